"""Lemma 7's triangulation of one subdivided rectangle."""

from __future__ import annotations

import pytest
from hypothesis import given

from bern_exact.checkers.findings import demand
from bern_exact.checkers.lemma_7 import check_lemma_7
from bern_exact.interior.records import Rectilinear
from bern_exact.interior.subdivided.records import Partition, SubdividedRectangle
from bern_exact.interior.subdivided.rectangle import (
    steiner_points,
    tile,
    triangles_of,
    triangulate,
)
from tests.interior.rectangles import subdivided_rectangles


def partition(*rectangles: SubdividedRectangle) -> Partition:
    return Partition(Rectilinear(()), rectangles, (0,) * len(rectangles))


@given(subdivided_rectangles())
def test_every_claim_of_lemma_7_holds(rectangle: SubdividedRectangle) -> None:
    demand(check_lemma_7(tile(partition(rectangle))))


@given(subdivided_rectangles())
def test_sizes_are_known_beforehand(rectangle: SubdividedRectangle) -> None:
    tiling = triangulate(rectangle)
    assert len(tiling.steiner) == steiner_points(rectangle)
    assert len(tiling.triangles) == triangles_of(rectangle)


# Where the printed placement of the outermost Steiner points gives 143, 180 and 146 degrees.
PRINTED = {
    "v = 3 beta": SubdividedRectangle(0, 20, 0, 3, (1, 2), (1, 2), (10,), (10,)),
    "v = 2 beta": SubdividedRectangle(0, 20, 0, 2, (1,), (1,), (), ()),
    "d = 2": SubdividedRectangle(0, 20, 0, 2, (1,), (1,), (10,), (10,)),
}


@pytest.mark.parametrize("name", PRINTED)
def test_where_the_printed_placement_fails(name: str) -> None:
    demand(check_lemma_7(tile(partition(PRINTED[name]))))


def test_the_height_bound_is_attained() -> None:
    tight = SubdividedRectangle(0, 8, 0, 4, (2,), (2,), (2, 4), (2, 4))
    (height,) = [f for f in check_lemma_7(tile(partition(tight))) if f.claim == "lemma-7.height"]
    assert height.measured == "1/5"


def test_no_steiner_point_where_a_pair_of_sides_is_unsubdivided() -> None:
    assert not triangulate(SubdividedRectangle(0, 9, 0, 1, (), (), (2, 5), (2, 5))).steiner
    assert not triangulate(SubdividedRectangle(0, 9, 0, 30, (7,), (7,), (), ())).steiner
