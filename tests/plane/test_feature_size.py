"""Definition 1 and nearest visible vertices against the definitions, all pairs."""

from __future__ import annotations

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from bern_exact.exact.points import grid_point, hpoint
from bern_exact.exact.predicates import squared_distance
from bern_exact.exact.similarity import Similarity
from bern_exact.plane.feature_size import FeatureSize, feature_size
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.ray_shooting import edges_around_vertices
from bern_exact.plane.triangulation import triangulate_polygon
from bern_exact.plane.visibility import nearest_visible_vertex

from .by_definition import feature_size_by_definition, sees
from .shapes import comb, oriented, plate, polygons, spiral, star


def check_feature_size(polygon: Polygon) -> None:
    found = feature_size(polygon)
    vertex = -1 if found.vertex is None else found.vertex
    assert (found.squared, vertex, found.edge) == feature_size_by_definition(polygon)


def check_nearest(polygon: Polygon) -> None:
    triangulation, points = triangulate_polygon(polygon), polygon.points
    for v in range(polygon.n):
        expected = min(
            (squared_distance(points[v], points[w]), w)
            for w in range(polygon.n)
            if w != v and sees(polygon, points[v], points[w])
        )
        assert nearest_visible_vertex(polygon, triangulation, v) == expected[::-1]


@settings(max_examples=300)
@given(polygons())
def test_feature_size_is_that_of_the_definition(polygon: Polygon) -> None:
    check_feature_size(polygon)


@settings(max_examples=200)
@given(polygons(), st.fractions(-3, 3, max_denominator=9))
def test_feature_size_of_turned_polygons_is_that_of_the_definition(
    polygon: Polygon, t: mpq
) -> None:
    turn = Similarity.rotation(mpq(t.numerator, t.denominator))
    check_feature_size(polygon.with_points([turn.apply(p) for p in polygon.points]))


@given(polygons())
def test_nearest_visible_vertex_is_that_of_the_definition(polygon: Polygon) -> None:
    check_nearest(polygon)


@pytest.mark.parametrize("rings", [[star(40)], [spiral(30)], [comb(30, 50)], plate(6)])
def test_larger_shapes(rings: list[list[tuple[int, int, int]]]) -> None:
    check_feature_size(oriented(rings))
    check_nearest(oriented(rings))


@settings(max_examples=60)
@given(polygons(), st.integers(1, 30), st.integers(1, 30), st.booleans())
def test_feature_size_scales_with_squeezed_polygons(
    polygon: Polygon, width: int, height: int, upright: bool
) -> None:
    """Needles: squeezed by up to 1000 in one direction."""
    a, b = (1, 1000 * height) if upright else (1000 * width, 1)
    squeezed = polygon.with_points(
        [hpoint(mpq(x, w) * a, mpq(y, w) * b) for x, y, w in polygon.points]
    )
    check_feature_size(squeezed)


def test_across_an_exterior_slit_nothing_counts() -> None:
    corners = [(0, 0), (1000, 0), (1000, 1000), (501, 1000), (500, 100), (499, 1000), (0, 1000)]
    polygon = oriented([[grid_point(x, y) for x, y in corners]])
    assert feature_size(polygon) == FeatureSize(mpq(100 * 100), 4, 0)


def test_a_needle_is_measured_exactly() -> None:
    polygon = oriented([[grid_point(0, 0), hpoint(10**30, mpq(1, 10**6)), grid_point(0, 1)]])
    found = feature_size(polygon)
    assert (found.squared, found.vertex, found.edge) == feature_size_by_definition(polygon)


def test_flat_vertices_count() -> None:
    corners = [(0, 0), (5, 0), (6, 0), (20, 0), (20, 20), (0, 20)]
    polygon = oriented([[grid_point(x, y) for x, y in corners]])
    assert feature_size(polygon) == FeatureSize(mpq(1), None, 1)


def test_edges_around_vertices_skip_the_vertex_own_edges() -> None:
    corners = [(0, 0), (8, 1), (9, 9), (4, 5), (1, 9)]
    ring = [grid_point(x, y) for x, y in corners]
    after = [1, 2, 3, 4, 0]
    assert edges_around_vertices(ring, after) == [(-1, -1), (-1, 2), (-1, -1), (0, -1), (0, -1)]
