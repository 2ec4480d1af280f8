"""Faces of edges: triangles of a triangulation come back, whatever the edges' order and pieces."""

from __future__ import annotations

from itertools import combinations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bern_exact.corpus.shapes import star
from bern_exact.exact.points import HPoint, grid_point, line_through, meet
from bern_exact.exact.predicates import orientation, side
from bern_exact.oracle.api import polygon_of
from bern_exact.plane.edge_faces import Edge, faces_of_edges
from bern_exact.plane.triangulation import triangulate_polygon


def normal(triangle: tuple[int, int, int]) -> tuple[int, int, int]:
    """The triangle from its least vertex on."""
    k = triangle.index(min(triangle))
    return triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]


def edges_of(triangles: list[tuple[int, int, int]]) -> list[Edge]:
    return [e for t in triangles for e in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))]


@pytest.mark.parametrize("seed", range(4))
def test_a_triangulation_comes_back(seed: int) -> None:
    polygon = polygon_of(star(30, seed))
    triangles = [normal(t) for t in triangulate_polygon(polygon).triangles()]
    found = faces_of_edges(polygon.points, reversed(edges_of(triangles)))
    assert (found.triangles, found.stray, found.crossing) == (sorted(triangles), [], None)


GRID = [grid_point(x, y) for x in range(3) for y in range(3)]
grid_edges = st.lists(
    st.tuples(st.integers(0, 8), st.integers(0, 8)), min_size=1, max_size=12, unique=True
)


def crosses(points: list[HPoint], e: Edge, f: Edge) -> bool:
    """Do two edges cross in a point that is no vertex?  By the definition."""
    first, second = (line_through(points[a], points[b]) for a, b in (e, f))
    if side(first, points[f[0]]) * side(first, points[f[1]]) >= 0:
        return False
    if side(second, points[e[0]]) * side(second, points[e[1]]) >= 0:
        return False
    return meet(first, second) not in points


def inside(points: list[HPoint], v: int, e: Edge) -> bool:
    """Is v strictly inside an edge?"""
    p, a, b = (points[i] for i in (v, *e))
    if orientation(a, b, p) != 0 or p in (a, b):
        return False
    return min(a, b) < p < max(a, b)  # grid points have weight 1


def pieces_of(points: list[HPoint], edges: list[Edge]) -> set[Edge]:
    """The pieces of edges between neighbouring vertices on them, by the definition."""
    pieces = set()
    for a, b in edges:
        on = [v for v in range(len(points)) if inside(points, v, (a, b))]
        stops = sorted((*on, a, b), key=points.__getitem__)
        pieces |= {(min(e), max(e)) for e in zip(stops, stops[1:], strict=False)}
    return pieces


@settings(max_examples=300)
@given(grid_edges)
def test_a_crossing_is_found_if_there_is_one(edges: list[Edge]) -> None:
    edges = [e for e in edges if e[0] != e[1]]
    found = faces_of_edges(GRID, edges)
    real = any(crosses(GRID, e, f) for e, f in combinations(edges, 2))
    assert (found.crossing is not None) == real
    if found.crossing:
        assert crosses(GRID, *found.crossing)


@settings(max_examples=300)
@given(grid_edges)
def test_pieces_are_sides_of_triangles_or_stray(edges: list[Edge]) -> None:
    edges = [e for e in edges if e[0] != e[1]]
    found = faces_of_edges(GRID, edges)
    if found.crossing is None:
        sides = {(min(e), max(e)) for e in edges_of(found.triangles)}
        assert sides | set(found.stray) == pieces_of(GRID, edges)
        assert not sides & set(found.stray)
        assert all(orientation(*(GRID[v] for v in t)) > 0 for t in found.triangles)


def test_an_edge_through_a_vertex_is_two() -> None:
    points = [grid_point(*p) for p in ((0, 0), (2, 0), (4, 0), (2, 3), (2, -3))]
    spokes = [(0, 2), (3, 4), (0, 3), (3, 2), (2, 4), (4, 0)]
    found = faces_of_edges(points, spokes)
    assert found.triangles == [(0, 1, 3), (0, 4, 1), (1, 2, 3), (1, 4, 2)]


def test_edges_on_one_another_count_once() -> None:
    points = [grid_point(*p) for p in ((0, 0), (2, 0), (4, 0), (2, 3))]
    found = faces_of_edges(points, [(0, 2), (0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)])
    assert (found.triangles, found.stray) == ([(0, 1, 3), (1, 2, 3)], [])


def test_a_face_of_four_sides_is_none_and_implied_edges_are_not_stray() -> None:
    square = [grid_point(*p) for p in ((0, 0), (1, 0), (1, 1), (0, 1))]
    ring = [(0, 1), (1, 2), (2, 3), (3, 0)]
    assert faces_of_edges(square, ring).stray == [(0, 1), (0, 3), (1, 2), (2, 3)]
    found = faces_of_edges(square, ring[:1], ring)
    assert (found.triangles, found.stray) == ([], [])
