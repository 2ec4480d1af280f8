"""The best triangulation of a small ring, against all of its triangulations."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from gmpy2 import mpq
from hypothesis import assume, given
from hypothesis import strategies as st

from bern_exact.boundary.optimal import (
    HIGHEST,
    HIGHEST_WITHIN_135,
    Demand,
    Triple,
    best_triangulation,
    rate,
)
from bern_exact.exact.points import HPoint, coordinates, grid_point
from bern_exact.exact.predicates import cross, dot, orientation, squared_height
from tests.plane.by_definition import is_polygon, twice_area
from tests.plane.shapes import untangled

DEMANDS = [
    HIGHEST,
    HIGHEST_WITHIN_135,
    Demand(mpq(2)),
    Demand(for_angle=True),
    Demand(squared_floor=mpq(1), for_angle=True),
]


@st.composite
def rings(draw: st.DrawFn) -> list[HPoint]:
    """Simple rings of 3 to 7 points, convex or not, collinear points included."""
    n = draw(st.integers(3, 7))
    ring = untangled(draw(st.integers(0, 10**6)), n, draw(st.sampled_from((3, 5, 20))))
    assume(is_polygon([ring]))
    return ring if twice_area(ring) > 0 else ring[::-1]


def triangulations(i: int, j: int) -> Iterator[list[Triple]]:
    """All choices of third corners for the sides i ... j of a ring."""
    if j < i + 2:
        yield []
    for k in range(i + 1, j):
        for left in triangulations(i, k):
            for right in triangulations(k, j):
                yield [*left, (i, k, j), *right]


def value_of(points: list[HPoint], triangles: list[Triple], demand: Demand) -> mpq | None:
    """The least height or cotangent of a triangulation, None if it does not keep the demand."""
    least = None
    for i, j, k in triangles:
        corners = [points[i], points[j], points[k]]
        if orientation(*corners) <= 0 or squared_height(*corners) < demand.squared_floor:
            return None
        cotangent = min(
            mpq(dot(u, v), cross(u, v))
            for a, apex, b in zip(
                corners[-1:] + corners, corners, corners[1:] + corners, strict=False
            )
            for u, v in [vectors(apex, b, a)]
        )
        if demand.kappa is not None and cotangent < -demand.kappa:
            return None
        value = cotangent if demand.for_angle else squared_height(*corners)
        least = value if least is None else min(least, value)
    return least


def vectors(apex: HPoint, b: HPoint, a: HPoint) -> tuple[tuple[mpq, mpq], tuple[mpq, mpq]]:
    """The true vectors from the apex."""
    (x, y), (u, v), (s, t) = coordinates(apex), coordinates(b), coordinates(a)
    return (u - x, v - y), (s - x, t - y)


@pytest.mark.parametrize("demand", DEMANDS)
@given(ring=rings())
def test_the_best_of_all_triangulations(ring: list[HPoint], demand: Demand) -> None:
    values = [value_of(ring, each, demand) for each in triangulations(0, len(ring) - 1)]
    best = max((value for value in values if value is not None), default=None)
    found = best_triangulation(ring, demand)
    assert (found and found.value) == best
    if found is not None:
        assert value_of(ring, list(found.triangles), demand) == best


@pytest.mark.parametrize("demand", DEMANDS)
@given(ring=rings())
def test_its_triangles_tile_the_ring(ring: list[HPoint], demand: Demand) -> None:
    found = best_triangulation(ring, demand)
    if found is not None:
        assert len(found.triangles) == len(ring) - 2
        areas = (twice_area([ring[i] for i in triangle]) for triangle in found.triangles)
        assert sum(areas) == twice_area(ring)


@given(ring=rings())
def test_where_the_ring_begins_does_not_matter(ring: list[HPoint]) -> None:
    found = {
        getattr(best_triangulation([*ring[i:], *ring[:i]], HIGHEST), "value", None)
        for i in range(len(ring))
    }
    assert len(found) == 1


def test_every_simple_ring_without_straight_corners_has_one() -> None:
    bent = [grid_point(x, y) for x, y in ((0, 0), (9, 0), (9, 9), (5, 1), (4, 8), (3, 1))]
    assert best_triangulation(bent, HIGHEST) is not None
    assert best_triangulation(bent[::-1], HIGHEST) is None


def test_a_bound_that_no_triangulation_keeps() -> None:
    flat = [grid_point(x, y) for x, y in ((0, 0), (10, 0), (5, 1))]
    assert best_triangulation(flat, HIGHEST_WITHIN_135) is None
    assert best_triangulation(flat, HIGHEST) is not None


@pytest.mark.parametrize(
    ("apex", "kept"), [((1, 2), True), ((2, 2), True), ((-2, 2), True), ((-3, 2), False)]
)
def test_135_degrees_is_allowed_and_no_more(apex: tuple[int, int], kept: bool) -> None:
    corners = (grid_point(0, 0), grid_point(5, 0), grid_point(*apex))
    assert (rate(*corners, HIGHEST_WITHIN_135) is not None) == kept


@pytest.mark.parametrize("points", [((0, 0), (1, 1), (2, 2)), ((0, 0), (0, 1), (1, 0))])
def test_flat_and_clockwise_triangles_are_none(points: tuple[tuple[int, int], ...]) -> None:
    p, q, r = (grid_point(x, y) for x, y in points)
    assert rate(p, q, r, HIGHEST) is None


def test_of_equal_ones_the_least_third_corner() -> None:
    square = [grid_point(x, y) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    found = best_triangulation(square, HIGHEST)
    assert found is not None and set(found.triangles) == {(0, 1, 3), (1, 2, 3)}
