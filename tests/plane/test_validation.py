"""Validation refuses exactly what is not a polygon, for a true reason, at the true place."""

from __future__ import annotations

from typing import Any

import pytest
from gmpy2 import mpq
from hypothesis import example, given, settings
from hypothesis import strategies as st

from bern_exact.exact.errors import INPUT_ERROR_KINDS, InputError
from bern_exact.exact.points import HPoint, grid_point, hpoint
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings

from .by_definition import (
    edge_defects,
    is_polygon,
    nesting_defects,
    on_segment,
    twice_area,
    vertex_defects,
)
from .shapes import comb, plate, polygons, spiral, star

Rings = list[list[HPoint]]


def ring(*corners: tuple[int, int]) -> list[HPoint]:
    return [grid_point(x, y) for x, y in corners]


def refusal(rings: Rings) -> InputError:
    with pytest.raises(InputError) as caught:
        polygon_from_rings(rings)
    assert caught.value.kind in INPUT_ERROR_KINDS
    return caught.value


def point_of(where: dict[str, Any]) -> HPoint:
    return hpoint(*(mpq(text) for text in where["point"]))


def ends(rings: Rings, edge: list[int]) -> tuple[HPoint, HPoint]:
    r, i = edge
    return rings[r][i], rings[r][(i + 1) % len(rings[r])]


def check(rings: Rings) -> None:
    """The verdict, the kind and the place are those of the definitions."""
    try:
        polygon = polygon_from_rings(rings)
    except InputError as error:
        check_refusal(rings, error)
        return
    assert is_polygon(rings)
    assert polygon.points == tuple(p for r in rings for p in r)
    for r, indices in enumerate(polygon.rings):
        assert (twice_area([polygon.points[v] for v in indices]) > 0) == (r == 0)
        assert indices[0] == sum(map(len, rings[:r]))


def check_refusal(rings: Rings, error: InputError) -> None:
    basic = vertex_defects(rings)
    if basic:
        assert error.kind == basic[0]
        return
    pairs = edge_defects(rings)
    if pairs:
        e, f = error.where["edges"]
        point = point_of(error.where)
        assert pairs[frozenset((tuple(e), tuple(f)))] == error.kind
        assert on_segment(point, *ends(rings, e)) and on_segment(point, *ends(rings, f))
        return
    found = nesting_defects(rings)
    assert (error.kind, error.where["ring"]) in found
    assert error.where["ring"] == min(r for _, r in found)


small = st.tuples(st.integers(0, 5), st.integers(0, 5)).map(lambda p: grid_point(*p))
tiny = st.tuples(st.integers(0, 3), st.integers(0, 3)).map(lambda p: grid_point(*p))


@settings(max_examples=350)
@given(st.lists(small, max_size=8))
def test_one_ring(corners: list[HPoint]) -> None:
    check([corners])


@settings(max_examples=350)
@given(st.lists(small, min_size=3, max_size=7, unique=True))
@example(ring((0, 0), (4, 0), (4, 4), (2, 0), (0, 4)))
@example(ring((0, 0), (4, 0), (4, 4), (3, 4), (3, 0), (1, 0), (1, 4), (0, 4)))
def test_one_ring_of_distinct_vertices(corners: list[HPoint]) -> None:
    check([corners])


@settings(max_examples=250)
@given(st.lists(st.lists(tiny, min_size=3, max_size=4, unique=True), min_size=2, max_size=3))
def test_several_rings(rings: Rings) -> None:
    check(rings)


@settings(max_examples=300)
@given(st.lists(st.tuples(small, st.integers(0, 5), st.booleans()), min_size=1, max_size=5))
def test_triangles_in_and_around_a_square(places: list[tuple[HPoint, int, bool]]) -> None:
    """Nested, disjoint, outside and crossing, with little else wrong."""
    rings = [ring((-1, -1), (23, 0), (24, 24), (0, 23))]
    for (x, y, _), size, around in places:
        x, y = 5 * int(x), 5 * int(y)
        reach = 60 if around else size
        rings.append(ring((x, y), (x + reach + 1, y), (x, y + reach + 2)))
    check(rings)


@given(polygons(), st.booleans(), st.booleans())
def test_polygons_are_accepted_in_any_orientation(
    polygon: Polygon, outer: bool, holes: bool
) -> None:
    rings = []
    for r in range(polygon.holes + 1):
        points = list(polygon.input_ring(r))
        rings.append(points[::-1] if (outer if r == 0 else holes) else points)
    check(rings)
    assert polygon_from_rings(rings).area == polygon.area


square = ring((0, 0), (10, 0), (10, 10), (0, 10))


@pytest.mark.parametrize(
    ("rings", "kind", "where"),
    [
        ([], "too-few-vertices", {"ring": 0}),
        ([ring((0, 0), (1, 1))], "too-few-vertices", {"ring": 0}),
        ([square, ring((1, 1), (2, 2))], "too-few-vertices", {"ring": 1}),
        (
            [[*square, square[0]]],
            "repeated-vertex",
            {"vertices": [[0, 0], [0, 4]], "point": ["0", "0"]},
        ),
        (
            [square, ring((5, 5), (10, 10), (6, 5))],
            "edges-touch",
            {"edges": [[0, 2], [1, 1]], "vertices": [[0, 2], [1, 1]], "point": ["10", "10"]},
        ),
        ([square, ring((1, 1), (3, 3), (2, 2))], "zero-area", {"ring": 1}),
        (
            [ring((0, 0), (10, 0), (10, 10), (4, 10), (7, 10))],
            "spike",
            {"vertex": [0, 3], "edges": [[0, 2], [0, 3]], "point": ["4", "10"]},
        ),
        (
            [ring((0, 0), (3, 1), (3, 0), (0, 2))],
            "edges-cross",
            {"edges": [[0, 0], [0, 2]], "point": ["2", "2/3"]},
        ),
        (
            [square, ring((10, 5), (6, 6), (6, 4))],
            "edges-touch",
            {"edges": [[0, 1], [1, 0]], "vertex": [1, 0], "point": ["10", "5"]},
        ),
        (
            [square, ring((10, 3), (10, 6), (6, 4))],
            "edges-overlap",
            {"edges": [[0, 1], [1, 0]], "point": ["10", "3"]},
        ),
        (
            [square, ring((1, 1), (2, 1), (1, 2)), ring((20, 1), (21, 1), (20, 2))],
            "hole-outside",
            {"ring": 2, "vertex": [2, 0], "point": ["20", "1"]},
        ),
        (
            [square, ring((1, 1), (8, 1), (1, 8)), ring((3, 2), (2, 2), (2, 3))],
            "hole-in-hole",
            {"ring": 2, "vertex": [2, 1], "point": ["2", "2"], "inside": 1},
        ),
        (
            [square, ring((-1, -1), (30, -1), (-1, 30))],
            "hole-outside",
            {"ring": 1, "vertex": [1, 0], "point": ["-1", "-1"]},
        ),
    ],
)
def test_each_kind_and_its_place(rings: Rings, kind: str, where: dict[str, object]) -> None:
    error = refusal(rings)
    assert (error.kind, error.where) == (kind, where)
    check_refusal(rings, error)


def test_flat_vertices_and_vertical_edges_are_allowed() -> None:
    polygon_from_rings([ring((0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (0, 2), (0, 1))])


def test_exact_near_misses() -> None:
    """A vertex next to an edge by 10^-30: accepted on the one side, refused on and beyond it."""
    tiny_step = mpq(1, 10**30)
    outer = ring((0, 0), (6, 2), (3, 9))
    for offset, kind in ((tiny_step, None), (mpq(0), "edges-touch"), (-tiny_step, "edges-cross")):
        rings = [outer, [hpoint(mpq(3), 1 + offset), *ring((4, 3), (3, 3))]]
        if kind is None:
            polygon_from_rings(rings)
        else:
            assert refusal(rings).kind == kind


@pytest.mark.parametrize("rings", [[star(3000)], [spiral(3000)], [comb(3000)], plate(900)])
def test_large_polygons_and_one_defect_in_them(rings: Rings) -> None:
    polygon = polygon_from_rings(rings)
    assert polygon.n == sum(map(len, rings))
    damaged = [list(r) for r in rings]
    damaged[-1][len(damaged[-1]) // 2] = grid_point(-(10**10), -(10**11) - 7)
    assert refusal(damaged).kind in ("edges-cross", "edges-touch", "edges-overlap", "spike")
