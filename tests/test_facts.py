"""Facts of polygons."""

from __future__ import annotations

from itertools import combinations

import pytest
from gmpy2 import mpq
from hypothesis import assume, given
from hypothesis import strategies as st

from bern_exact.exact.points import HPoint, hpoint
from bern_exact.exact.predicates import orientation, squared_distance
from bern_exact.facts import convex_hull, facts_of, is_acute, squared_diameter
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings

small = st.integers(-6, 6)
points = st.builds(hpoint, small, small)


def are_on_one_line(some: list[HPoint]) -> bool:
    return all(orientation(*three) == 0 for three in combinations(some, 3))


@given(st.lists(points, min_size=3, max_size=12, unique=True))
def test_the_diameter_is_the_largest_distance(some: list[HPoint]) -> None:
    assume(not are_on_one_line(some))
    assert squared_diameter(some) == max(squared_distance(*two) for two in combinations(some, 2))


@given(st.lists(points, min_size=3, max_size=12, unique=True))
def test_the_hull_is_convex_and_holds_every_point(some: list[HPoint]) -> None:
    assume(not are_on_one_line(some))
    hull = convex_hull(some)
    for i, corner in enumerate(hull):
        following = hull[(i + 1) % len(hull)]
        assert orientation(hull[i - 1], corner, following) > 0
        assert all(orientation(corner, following, p) >= 0 for p in some)


def test_a_right_angle_is_not_acute() -> None:
    corners = ((0, 0), (1, 0), (0, 1))
    triangle = Polygon(tuple(hpoint(x, y) for x, y in corners), ((0, 1, 2),))
    assert [is_acute(triangle, v) for v in range(3)] == [False, True, True]


def test_a_reflex_corner_is_not_acute() -> None:
    corners = ((0, 0), (4, 0), (4, 4), (mpq(7, 2), 1))
    dart = Polygon(tuple(hpoint(x, y) for x, y in corners), ((0, 1, 2, 3),))
    assert not is_acute(dart, 3)


@pytest.mark.parametrize("turned", [False, True], ids=["as given", "turned round"])
@pytest.mark.parametrize("first", range(4))
def test_the_short_edge_is_named_as_in_the_input(first: int, turned: bool) -> None:
    outer = [(-20, -20), (20, -20), (20, 20), (-20, 20)]
    ring = [(0, 0), (10, 0), (10, 1), (0, 10)]
    hole = ring[first:] + ring[:first]
    hole = hole[::-1] if turned else hole
    polygon = polygon_from_rings([[hpoint(x, y) for x, y in corners] for corners in (outer, hole)])
    at = facts_of(polygon).to_json()["feature_size_at"]
    number, index = at["edge"]
    assert number == 1 and list(at) == ["edge"]
    assert {hole[index], hole[(index + 1) % 4]} == {(10, 0), (10, 1)}
