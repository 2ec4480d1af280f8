"""Lemma 8's partition, against its claims and against cells counted one by one."""

from __future__ import annotations

from collections import Counter

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.checkers.findings import demand
from bern_exact.checkers.lemma_7 import check_lemma_7
from bern_exact.checkers.lemma_8 import check_lemma_8
from bern_exact.checkers.matching import check_matching
from bern_exact.interior.records import Rectilinear
from bern_exact.interior.subdivided.rectangle import tile
from bern_exact.interior.subdivided.strips import count_strips, default_spacing, strips
from tests.interior.regions import (
    Cells,
    cell_sets,
    cells_of,
    grown,
    region_of,
    regions,
    surface_vertices,
    unit_region,
)

SPACINGS = st.one_of(st.none(), st.integers(1, 12))


@given(regions())
def test_every_claim_of_lemma_8_holds(region: Rectilinear) -> None:
    demand(check_lemma_8(strips(region)))


@given(regions(), SPACINGS)
def test_any_spacing_gives_matching_rectangles(region: Rectilinear, spacing: int | None) -> None:
    partition = strips(region, spacing)
    demand(check_matching(partition, "lemma-8", "partition"))
    demand(check_lemma_7(tile(partition)))


@given(cell_sets(), SPACINGS)
def test_each_cell_lies_in_one_rectangle(cells: Cells, spacing: int | None) -> None:
    partition = strips(unit_region(cells), spacing)
    found = Counter(cell for r in partition.rectangles for cell in cells_of(r))
    assert found == Counter(cells)


@given(regions(), SPACINGS)
def test_counting_needs_no_building(region: Rectilinear, spacing: int | None) -> None:
    assert count_strips(region, spacing) == surface_vertices(strips(region, spacing))


def test_where_a_guide_line_would_meet_the_boundary_between_vertices() -> None:
    shape = frozenset({(0, 0), (1, 0), (2, 0), (0, 1), (0, 2), (1, 2)})
    region = region_of(shape, (0, 1, 2, 3), (0, 1, 2, 3))
    assert (2, 0) not in region.loops[0]
    for spacing in range(1, 5):
        demand(check_matching(strips(region, spacing), "lemma-8", "partition"))


def test_rectangles_are_not_cut() -> None:
    region = unit_region(frozenset((i, j) for i in range(9) for j in range(5)), every_line=True)
    assert [r[:4] for r in strips(region).rectangles] == [(0, 9, 0, 5)]


@pytest.mark.parametrize("size", [100, 3000])
def test_large_regions(size: int) -> None:
    partition = strips(unit_region(grown(size, size)))
    demand(check_lemma_8(partition))
    demand(check_lemma_7(tile(partition)))


def test_nothing_gives_nothing() -> None:
    assert strips(Rectilinear(())).rectangles == ()
    assert count_strips(Rectilinear(())) == 0
    assert default_spacing(Rectilinear(())) == 1
