"""Q as loops and columns, against its cells one by one."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.interior.records import Rectilinear
from bern_exact.interior.rectilinear import (
    UnmatchedEdge,
    columns,
    interior,
    ordinates,
    strictly_between,
)
from tests.interior.regions import Cells, cell_sets, regions, unit_region

Ring = tuple[tuple[int, int], ...]


def cell_ring(cell: tuple[int, int]) -> Ring:
    """A unit cell, counter-clockwise."""
    i, j = cell
    return ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))


def around(cells: Cells) -> list[Ring]:
    """The cells of a box around some cells that are none of them: they are the touched faces."""
    size = 2 + max(max(cell) for cell in cells)
    box = [(i, j) for i in range(-1, size) for j in range(-1, size)]
    return [cell_ring(cell) for cell in box if cell not in cells]


def twice_area(loops: tuple[Ring, ...]) -> int:
    return sum(
        loop[k - 1][0] * y - loop[k - 1][1] * x for loop in loops for k, (x, y) in enumerate(loop)
    )


def inner_loops(cells: Cells) -> tuple[Ring, ...]:
    """Q if all other cells of a box are touched, up to the boundary outside the box."""
    rim = {-1, 2 + max(max(cell) for cell in cells)}
    # Grid vertices at the rim are replaced by a node on the boundary.
    return interior(tuple(0 if rim & {*v} else v for v in ring) for ring in around(cells)).loops


@given(cell_sets())
def test_the_loops_enclose_just_the_untouched_cells(cells: Cells) -> None:
    loops = inner_loops(cells)
    assert twice_area(loops) == 2 * len(cells)
    darts = {(loop[k - 1], v) for loop in loops for k, v in enumerate(loop)}
    expected = {
        (ring[k - 1], v) for ring in map(cell_ring, sorted(cells)) for k, v in enumerate(ring)
    }
    assert darts == {(a, b) for a, b in expected if (b, a) not in expected}


@given(cell_sets())
def test_loops_are_those_of_the_region(cells: Cells) -> None:
    def canonical(loops: tuple[Ring, ...]) -> list[Ring]:
        return sorted(
            min(tuple(loop[k:] + loop[:k]) for k in range(len(loop))) for loop in map(tuple, loops)
        )

    assert canonical(inner_loops(cells)) == canonical(unit_region(cells, every_line=True).loops)


@given(cell_sets())
def test_the_touched_faces_may_come_in_any_order(cells: Cells) -> None:
    faces = around(cells)
    assert interior(faces) == interior(faces[::-1])
    assert interior(faces) == interior([ring[1:] + ring[:1] for ring in faces])


def test_cells_that_touch_at_a_corner_stay_one_loop_each() -> None:
    # At the common corner the first way on is left: each loop keeps to its own cell.
    loops = inner_loops(frozenset({(0, 0), (1, 1)}))
    assert sorted(map(len, loops)) == [4, 4]


def test_holes_that_touch_at_a_corner() -> None:
    cells = frozenset((i, j) for i in range(4) for j in range(4)) - {(1, 1), (2, 2)}
    loops = inner_loops(cells)
    assert sorted(map(len, loops)) == [8, 16]  # interior on the left joins the two holes
    assert twice_area(loops) == 2 * len(cells)


def test_nothing_is_left() -> None:
    assert interior([]).loops == ()
    assert interior([((0, 0), 5, 6)]).loops == ()


@given(regions())
def test_columns_tile_the_region(region: Rectilinear) -> None:
    found = columns(region)
    assert sum(2 * (c.x1 - c.x0) * (c.y1 - c.y0) for c in found) == twice_area(region.loops)
    for i, c in enumerate(found):
        for d in found[:i]:
            assert c.x1 <= d.x0 or d.x1 <= c.x0 or c.y1 <= d.y0 or d.y1 <= c.y0


@given(cell_sets())
def test_columns_of_unit_cells_are_the_maximal_stacks(cells: Cells) -> None:
    expected = []
    for i, j in sorted(cells):
        if (i, j - 1) not in cells:
            top = next(k for k in range(j, j + 99) if (i, k) not in cells)
            expected.append((i, i + 1, j, top))
    assert sorted(columns(unit_region(cells, every_line=True))) == sorted(expected)


@given(regions())
def test_columns_are_sorted(region: Rectilinear) -> None:
    found = columns(region)
    keys = [(c.x0, c.x1, c.y0) for c in found]
    assert keys == sorted(keys)


UNMATCHED = {
    "a step whose chord ends inside an edge": ((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)),
    "clockwise": ((0, 0), (0, 1), (1, 1), (1, 0)),
    "a top alone": ((0, 0), (1, 0), (2, 0), (2, 1), (0, 1)),
}


@pytest.mark.parametrize("name", UNMATCHED)
def test_columns_without_matching_raise(name: str) -> None:
    with pytest.raises(UnmatchedEdge):
        columns(Rectilinear((UNMATCHED[name],)))


@given(regions())
def test_ordinates_are_those_of_the_vertices(region: Rectilinear) -> None:
    points = {v for loop in region.loops for v in loop}
    found = ordinates(region)
    assert {(x, y) for x, ys in found.items() for y in ys} == points
    assert all(ys == sorted(set(ys)) for ys in found.values())


@given(st.lists(st.integers(0, 20)).map(sorted), st.integers(-1, 21), st.integers(-1, 21))
def test_strictly_between(values: list[int], low: int, high: int) -> None:
    if low <= high:
        assert list(strictly_between(values, low, high)) == [v for v in values if low < v < high]
