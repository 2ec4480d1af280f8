"""`edges_around` against the definition, edge by edge."""

from __future__ import annotations

from collections.abc import Sequence

import pytest
from gmpy2 import mpq
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from bern_exact.exact.points import HPoint, coordinates, grid_point, hpoint
from bern_exact.plane.ray_shooting import edges_around

from .by_definition import is_polygon
from .shapes import star, untangled


def by_definition(points: Sequence[HPoint], after: Sequence[int], q: HPoint) -> tuple[int, int]:
    x, y = coordinates(q)
    hits = []
    for tail, head in enumerate(after):
        (ax, ay), (bx, by) = coordinates(points[tail]), coordinates(points[head])
        if min(ax, bx) < x < max(ax, bx):
            hits.append((ay + (by - ay) * (x - ax) / (bx - ax), tail))
    below = max((hit for hit in hits if hit[0] < y), default=(0, -1))
    above = min((hit for hit in hits if hit[0] > y), default=(0, -1))
    return below[1], above[1]


def sheared(ring: Sequence[HPoint]) -> list[HPoint]:
    """No vertical edges, and no vertex with an x that is a multiple of 1/2 (other than 0)."""
    return [hpoint(mpq(p[0]) + mpq(p[1] + 1, 1009), mpq(p[1])) for p in ring]


def ring_after(n: int) -> list[int]:
    return [(i + 1) % n for i in range(n)]


@settings(max_examples=60, deadline=None)
@given(
    st.integers(0, 10**6),
    st.integers(3, 14),
    st.booleans(),
    st.lists(st.tuples(st.integers(-1, 25), st.fractions(-1, 13, max_denominator=4)), max_size=20),
)
def test_agrees_with_the_definition(
    seed: int, n: int, backwards: bool, places: list[tuple[int, mpq]]
) -> None:
    ring = untangled(seed, n, 12)
    assume(is_polygon([ring]))
    ring = sheared(ring)
    if backwards:
        ring.reverse()
    queries = [hpoint(mpq(x, 2), mpq(y.numerator, y.denominator)) for x, y in places]
    expected = [by_definition(ring, ring_after(n), q) for q in queries]
    assert edges_around(ring, ring_after(n), queries) == expected


def test_an_edge_through_the_query_is_skipped() -> None:
    ring = [grid_point(0, 0), grid_point(4, 0), grid_point(4, 4), grid_point(0, 4)]
    ring = [hpoint(mpq(p[0]) + mpq(p[1], 100), mpq(p[1])) for p in ring]
    queries = [grid_point(2, 0), grid_point(2, 4), grid_point(2, 1)]
    assert edges_around(ring, [1, 2, 3, 0], queries) == [(-1, 2), (0, -1), (0, 2)]


def test_equal_x_of_vertices_that_no_edge_joins() -> None:
    ring = [grid_point(x, y) for x, y in ((0, 0), (2, 1), (4, 0), (3, 3), (2, 2), (1, 3))]
    queries = [hpoint(mpq(x, 4), mpq(3, 2)) for x in (3, 5, 7, 9, 11)]
    expected = [by_definition(ring, ring_after(6), q) for q in queries]
    assert edges_around(ring, ring_after(6), queries) == expected


def test_swapping_the_axes_answers_left_and_right() -> None:
    ring = star(200)
    swapped = [(y, x, w) for x, y, w in ring]
    after = ring_after(200)
    queries = [hpoint(mpq(2 * i + 1, 2), mpq(7919 * i, 2)) for i in range(-50, 50)]
    turned = [(y, x, w) for x, y, w in queries]
    assert edges_around(swapped, after, turned) == [
        by_definition(swapped, after, q) for q in turned
    ]


def test_vertical_edges_are_refused() -> None:
    ring = [grid_point(0, 0), grid_point(1, 0), grid_point(1, 1)]
    with pytest.raises(ValueError, match="edge 1 is vertical"):
        edges_around(ring, [1, 2, 0], [])


def test_a_query_over_a_vertex_is_refused() -> None:
    ring = [grid_point(0, 0), grid_point(2, 0), grid_point(1, 1)]
    with pytest.raises(ValueError, match="has the x of vertex 2"):
        edges_around(ring, [1, 2, 0], [grid_point(1, 0)])
