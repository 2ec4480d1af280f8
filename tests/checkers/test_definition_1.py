"""The certificate of Definition 1 against the definition by brute force."""

from __future__ import annotations

from collections.abc import Sequence

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.checkers.definition_1 import (
    admissible_distance,
    check_definition_1,
    close_pairs,
)
from bern_exact.checkers.sweep import first_edges
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.exact.predicates import squared_distance
from bern_exact.plane.feature_size import FeatureSize
from bern_exact.plane.polygon import Polygon
from tests.checkers.samples import THINGS
from tests.plane.by_definition import meeting
from tests.plane.shapes import comb, oriented, polygons, spiral, star


def candidates(polygon: Polygon) -> list[FeatureSize]:
    """All edges, and all pairs whose shortest segment leaves into the wedge, the least first."""
    found = [
        FeatureSize(squared_distance(polygon.points[v], polygon.points[w]), None, v)
        for v, w in polygon.edges()
    ]
    for v in range(polygon.n):
        for e in range(polygon.n):
            if v not in (e, polygon.after[e]):
                distance = admissible_distance(polygon, v, e)
                if distance is not None:
                    found.append(FeatureSize(distance, v, e))
    return sorted(found, key=lambda f: f.squared)


def holds(polygon: Polygon, feature: FeatureSize) -> bool:
    (found,) = check_definition_1(polygon, feature)
    return found.holds


@given(polygons())
def test_the_least_candidate_is_certified_and_no_other(polygon: Polygon) -> None:
    found = candidates(polygon)
    for feature in found[:6]:
        assert holds(polygon, feature) == (feature.squared == found[0].squared)


@given(polygons(), st.integers(1, 10**6))
def test_scaling_scales_the_certificate(polygon: Polygon, scale: int) -> None:
    feature = candidates(polygon)[0]
    larger = polygon.with_points(
        [hpoint(mpq(x * scale, w), mpq(y * scale, w)) for x, y, w in polygon.points]
    )
    assert holds(larger, FeatureSize(feature.squared * scale**2, feature.vertex, feature.edge))
    if scale > 1:
        assert not holds(larger, feature)


@pytest.mark.parametrize("name", THINGS)
def test_handmade_polygons(name: str) -> None:
    found = candidates(THINGS[name])
    assert holds(THINGS[name], found[0])
    larger = [f for f in found if f.squared > found[0].squared]
    assert not any(holds(THINGS[name], feature) for feature in larger)


@pytest.mark.parametrize("ring", [star(60), spiral(60), comb(60)])
def test_shapes(ring: list[HPoint]) -> None:
    polygon = oriented([ring])
    found = candidates(polygon)
    assert holds(polygon, found[0])
    assert not holds(polygon, next(f for f in found if f.squared > found[0].squared))


def test_no_pair_is_certified_that_is_not_there() -> None:
    square = THINGS["square"]
    for feature in (
        FeatureSize(mpq(1), 0, 0),
        FeatureSize(mpq(1), 0, 3),
        FeatureSize(mpq(1), 9, 1),
        FeatureSize(mpq(1), None, 4),
        FeatureSize(mpq(1), None, -1),
    ):
        assert not holds(square, feature)
    assert holds(square, FeatureSize(mpq(1), 0, 1))
    assert holds(square, FeatureSize(mpq(1), None, 2))


@given(polygons())
def test_sweep_finds_the_first_edges(polygon: Polygon) -> None:
    """Against shooting each ray at all edges, from points a very little to the right and left."""
    points = polygon.points
    low = min(y // w for _, y, w in points) - 1
    high = max(y // w for _, y, w in points) + 1
    tilt = mpq(1, 10**9)
    for v, (below, above) in enumerate(first_edges(points, polygon.after)):
        for expected, end in ((below, low), (above, high)):
            x, y = mpq(points[v][0], points[v][2]), mpq(points[v][1], points[v][2])
            target = hpoint(x - (end - y) * tilt, end)
            hits = [
                e
                for e, w in polygon.edges()
                if v not in (e, w) and meeting(points[v], target, points[e], points[w])
            ]
            assert _first(points, polygon.after, v, target, hits) == expected


def _first(
    points: Sequence[HPoint], after: Sequence[int], v: int, target: HPoint, hits: list[int]
) -> int:
    """The hit nearest to v."""

    def fraction(e: int) -> mpq:
        a, b = points[e], points[after[e]]
        dx = mpq(target[0], target[2]) - mpq(points[v][0], points[v][2])
        dy = mpq(target[1], target[2]) - mpq(points[v][1], points[v][2])
        ux, uy = mpq(b[0], b[2]) - mpq(a[0], a[2]), mpq(b[1], b[2]) - mpq(a[1], a[2])
        wx = mpq(a[0], a[2]) - mpq(points[v][0], points[v][2])
        wy = mpq(a[1], a[2]) - mpq(points[v][1], points[v][2])
        return (wx * uy - wy * ux) / (dx * uy - dy * ux)

    return min(hits, key=fraction, default=-1)


@given(
    st.sets(st.tuples(st.integers(-30, 30), st.integers(-30, 30)), max_size=30),
    st.integers(1, 10**6),
    st.integers(1, 10**6),
)
def test_close_pairs_are_all_pairs_within_reach(
    places: set[tuple[int, int]], numerator: int, denominator: int
) -> None:
    points = [hpoint(mpq(x, 7), mpq(y, 9)) for x, y in sorted(places)]
    reach = mpq(numerator, denominator)
    expected = {
        (i, j)
        for j in range(len(points))
        for i in range(j)
        if squared_distance(points[i], points[j]) <= reach
    }
    found = list(close_pairs(points, reach))
    assert len(found) == len(set(found))
    assert set(found) == expected
