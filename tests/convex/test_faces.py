"""The grid, and the triangles along the boundary."""

from __future__ import annotations

import pytest
from hypothesis import given

from bern_exact.checkers.bounced_grid import check_grid
from bern_exact.checkers.lemma_9 import check_lemma_9
from bern_exact.convex.bounce import bounce
from bern_exact.convex.faces import faces
from bern_exact.convex.frame import convex_frame
from bern_exact.convex.records import Gridded
from bern_exact.plane.polygon import Polygon
from tests.convex.polygons import SHAPES, convex_polygons, family, shape


def gridded(polygon: Polygon) -> Gridded:
    return faces(bounce(convex_frame(polygon)))


def assert_right(record: Gridded) -> None:
    broken = [f for f in (*check_grid(record), *check_lemma_9(record)) if not f.holds]
    assert not broken, broken[0]


@given(convex_polygons())
def test_every_claim_holds(shape: Polygon) -> None:
    assert_right(gridded(shape))


@pytest.mark.parametrize("name", SHAPES)
def test_every_claim_holds_for_single_shapes(name: str) -> None:
    assert_right(gridded(shape(name)))


def test_a_triangle_is_two_right_triangles() -> None:
    record = gridded(shape("triangle"))
    assert record.cells.number == 0
    assert [len(leg.triangles) for leg in record.legs] == [1, 1]


def test_a_rhombus_is_four() -> None:
    record = gridded(shape("rhombus"))
    assert record.cells.number == 0 and len(record.legs) == 4


def test_there_is_a_foot_for_each_subdivision() -> None:
    record = gridded(family("random-hull", 30))
    subdivided = [leg for leg in record.legs if leg.subdivision is not None]
    assert subdivided and len(record.feet) == len(subdivided)
    assert all(len(leg.triangles) == 3 for leg in subdivided)


def test_all_lines_meet_the_cells_at_ab() -> None:
    record = gridded(family("random-hull", 30))
    zero = record.cells.ys.index(0)
    for low, high in zip(record.cells.low, record.cells.high, strict=True):
        assert low <= zero <= high
