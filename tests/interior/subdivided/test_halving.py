"""Lemma 6's halving, against its claims and against cells counted one by one."""

from __future__ import annotations

from collections import Counter

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.checkers.findings import demand
from bern_exact.checkers.lemma_6 import check_lemma_6, check_lemma_6_as_printed
from bern_exact.checkers.lemma_7 import check_lemma_7
from bern_exact.checkers.matching import check_matching
from bern_exact.interior.records import Rectilinear
from bern_exact.interior.subdivided.halving import HasHoles, count_halving, halving
from bern_exact.interior.subdivided.lattice import components
from bern_exact.interior.subdivided.rectangle import tile
from tests.interior.regions import (
    Cells,
    cell_sets,
    cells_of,
    grown,
    regions,
    surface_vertices,
    unit_region,
)


@given(regions(holes=False), st.booleans())
def test_every_claim_of_lemma_6_holds(region: Rectilinear, squares: bool) -> None:
    demand(check_lemma_6(halving(region, squares=squares)))


@given(regions(holes=False))
def test_every_rectangle_can_be_triangulated(region: Rectilinear) -> None:
    demand(check_lemma_7(tile(halving(region))))


@given(cell_sets(holes=False), st.booleans())
def test_each_cell_lies_in_one_rectangle(cells: Cells, squares: bool) -> None:
    partition = halving(unit_region(cells), squares=squares)
    found = Counter(cell for r in partition.rectangles for cell in cells_of(r))
    assert found == Counter(cells)


@given(regions(holes=False), st.booleans())
def test_counting_needs_no_building(region: Rectilinear, squares: bool) -> None:
    partition = halving(region, squares=squares)
    assert count_halving(region, squares=squares) == surface_vertices(partition)


@given(regions(holes=False))
def test_only_coincidence_and_order_of_coordinates_count(region: Rectilinear) -> None:
    stretched = Rectilinear(
        tuple(tuple((3 * x + 7, 10 * y - 1) for x, y in loop) for loop in region.loops)
    )
    wanted = [
        (3 * r.x0 + 7, 3 * r.x1 + 7, 10 * r.y0 - 1, 10 * r.y1 - 1)
        for r in halving(region).rectangles
    ]
    assert [r[:4] for r in halving(stretched).rectangles] == wanted


@pytest.mark.parametrize("size", [100, 3000])
@pytest.mark.parametrize("squares", [False, True])
def test_large_regions(size: int, squares: bool) -> None:
    partition = halving(unit_region(grown(size, size)), squares=squares)
    demand(check_lemma_6(partition))
    demand(check_lemma_7(tile(partition)))


NOTCHED = unit_region(
    frozenset((i, j) for i in range(6) for j in range(4)) - {(2, 3)}, every_line=True
)


def test_as_printed_the_boundary_grows() -> None:
    partition = halving(NOTCHED, as_printed=True)
    (printed,) = check_lemma_6_as_printed(partition)
    assert (printed.bound, printed.measured, printed.holds) == (22, 24, False)
    demand(check_matching(partition, "lemma-6", "partition"))


@given(regions(holes=False))
def test_as_printed_it_is_a_partition(region: Rectilinear) -> None:
    demand(check_matching(halving(region, as_printed=True), "lemma-6", "partition"))


@given(cell_sets(holes=False))
def test_as_printed_it_is_quadtree_erosion(cells: Cells) -> None:
    """After 2 k half-steps the complete aligned squares of 2^k x 2^k cells are left."""
    for part in components(unit_region(cells, every_line=True)):
        partition = halving(part, as_printed=True)
        every = {cell for r in partition.rectangles for cell in cells_of(r)}
        x, y = part.loops[0][0]
        left = {(i - x, j - y) for i, j in every}
        for k in range(4):
            kept = zip(partition.rectangles, partition.steps, strict=True)
            found = {cell for r, step in kept if step > 2 * k for cell in cells_of(r)}
            assert found == {(i + x, j + y) for i, j in left}
            left = eroded(left, 2 ** (k + 1))


def eroded(cells: set[tuple[int, int]], side: int) -> set[tuple[int, int]]:
    """The cells of aligned squares that are complete."""
    count = Counter((i // side, j // side) for i, j in cells)
    return {(i, j) for i, j in cells if count[i // side, j // side] == side * side}


def test_the_boundary_does_not_grow_where_even_parity_makes_it() -> None:
    partition = halving(NOTCHED)
    boundary = next(f for f in check_lemma_6(partition) if f.claim == "lemma-6.boundary")
    assert partition.region.edges == boundary.measured == 22


def test_a_rectangle_stays_whole() -> None:
    whole = ((0, 0), (9, 0), (9, 2), (9, 7), (0, 7), (0, 2))
    partition = halving(Rectilinear((whole,)))
    assert [r[:5] for r in partition.rectangles] == [(0, 9, 0, 7, (2,))]


def test_a_hole_is_refused() -> None:
    frame = frozenset((i, j) for i in range(3) for j in range(3)) - {(1, 1)}
    with pytest.raises(HasHoles):
        halving(unit_region(frame))


def test_nothing_gives_nothing() -> None:
    assert halving(Rectilinear(())).rectangles == ()
