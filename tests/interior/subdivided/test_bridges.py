"""Holes joined to the boundary by slits."""

from __future__ import annotations

from collections import Counter

from hypothesis import given
from hypothesis import strategies as st

from bern_exact.checkers.findings import demand
from bern_exact.checkers.lemma_6 import check_lemma_6
from bern_exact.checkers.lemma_7 import check_lemma_7
from bern_exact.interior.records import Rectilinear
from bern_exact.interior.subdivided.bridges import bridged, bridges, count_bridged, slit
from bern_exact.interior.subdivided.halving import halving
from bern_exact.interior.subdivided.lattice import components
from bern_exact.interior.subdivided.rectangle import tile
from tests.interior.regions import (
    Cells,
    cell_sets,
    cells_of,
    regions,
    surface_vertices,
    unit_region,
)


@given(regions(), st.booleans())
def test_every_claim_of_lemma_6_holds_with_slits(region: Rectilinear, squares: bool) -> None:
    demand(check_lemma_6(bridged(region, squares=squares)))


@given(regions())
def test_every_rectangle_can_be_triangulated(region: Rectilinear) -> None:
    demand(check_lemma_7(tile(bridged(region))))


@given(cell_sets())
def test_each_cell_lies_in_one_rectangle(cells: Cells) -> None:
    found = Counter(cell for r in bridged(unit_region(cells)).rectangles for cell in cells_of(r))
    assert found == Counter(cells)


@given(regions(), st.booleans())
def test_counting_needs_no_building(region: Rectilinear, squares: bool) -> None:
    assert count_bridged(region, squares=squares) == surface_vertices(
        bridged(region, squares=squares)
    )


@given(regions())
def test_slits_leave_no_hole(region: Rectilinear) -> None:
    open_region = slit(region, bridges(region))
    assert all(len(part.loops) == 1 for part in components(open_region))


@given(regions(holes=False))
def test_without_holes_it_is_the_halving(region: Rectilinear) -> None:
    assert bridged(region) == halving(region)


def test_a_short_way_round_a_corner() -> None:
    """Far to the right, but near to the top one column on."""
    cells = frozenset((i, j) for i in range(30) for j in range(30)) - {(4, 26)}
    edges = bridges(unit_region(cells, every_line=True))
    assert len(edges) <= 4
