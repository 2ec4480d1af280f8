"""The diameter and the frame."""

from __future__ import annotations

from itertools import combinations

import pytest
from hypothesis import given

from bern_exact.checkers.diameter import check_diameter
from bern_exact.convex.frame import convex_frame, diameter
from bern_exact.exact.errors import InputError
from bern_exact.exact.points import coordinates
from bern_exact.exact.predicates import squared_distance
from bern_exact.plane.polygon import Polygon
from tests.convex.polygons import SHAPES, convex_polygons, polygon, shape


@given(convex_polygons())
def test_the_diameter_is_the_first_of_the_longest(shape: Polygon) -> None:
    pairs = [
        (-squared_distance(p, q), *sorted((coordinates(p), coordinates(q))))
        for p, q in combinations(shape.points, 2)
    ]
    a, b = diameter(shape)
    assert min(pairs)[1:] == (coordinates(shape.points[a]), coordinates(shape.points[b]))


@given(convex_polygons())
def test_the_frame_is_what_its_checker_says(shape: Polygon) -> None:
    assert all(found.holds for found in check_diameter(convex_frame(shape)))


@pytest.mark.parametrize("name", SHAPES)
def test_the_frame_is_undone_exactly(name: str) -> None:
    frame = convex_frame(shape(name))
    back = frame.similarity.inverse()
    for p in frame.polygon.points:
        assert back.apply(frame.similarity.apply(p)) == p


def test_one_side_is_told() -> None:
    assert convex_frame(shape("diameter subdivided")).one_sided
    assert convex_frame(shape("triangle")).one_sided
    assert not convex_frame(shape("kite")).one_sided


def test_a_reflex_vertex_is_named() -> None:
    dented = polygon([[(0, 0), (4, 0), (4, 4), (3, 1), (0, 4)]])
    with pytest.raises(InputError) as caught:
        convex_frame(dented)
    assert caught.value.kind == "not-convex"
    assert caught.value.where == {"vertex": [0, 3]}


def test_holes_are_named() -> None:
    square = [(0, 0), (9, 0), (9, 9), (0, 9)]
    with pytest.raises(InputError) as caught:
        convex_frame(polygon([square, [(3, 3), (6, 3), (3, 6)]]))
    assert (caught.value.kind, caught.value.where) == ("has-holes", {"ring": 1})


def test_180_degree_vertices_are_no_reflex_ones() -> None:
    assert convex_frame(polygon([[(0, 0), (1, 0), (2, 0), (2, 2), (1, 2), (0, 2)]])).a == 0
