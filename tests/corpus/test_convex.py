"""The convex families."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from bern_exact.convex.frame import convex_frame
from bern_exact.corpus.convex import FAMILIES, circle_point, subdivided
from bern_exact.facts import facts_of
from tests.convex.polygons import family


@pytest.mark.parametrize("name", FAMILIES)
@pytest.mark.parametrize("n", [5, 12, 60])
def test_members_are_convex_and_of_about_n_vertices(name: str, n: int) -> None:
    for seed in range(3):
        polygon = family(name, n, seed)
        assert facts_of(polygon).convex
        assert polygon.n <= n
        assert name == "needle" or polygon.n >= n - 1


@pytest.mark.parametrize("name", FAMILIES)
def test_members_are_determined_by_their_arguments(name: str) -> None:
    assert FAMILIES[name](12, 3) == FAMILIES[name](12, 3)


@pytest.mark.parametrize("name", ["parabola", "arc"])
def test_one_sided_families(name: str) -> None:
    assert convex_frame(family(name, 20)).one_sided


def test_points_of_a_circle_are_on_it() -> None:
    for i in range(12):
        x, y = circle_point(i, 12)
        assert x * x + y * y == 1


def test_a_subdivided_polygon_has_the_same_area() -> None:
    plain, fine = family("random-hull", 9), family("random-hull", 9, parts=3)
    assert fine.n == 3 * plain.n and fine.area == plain.area


def test_a_needle_is_a_million_times_as_long_as_wide() -> None:
    (ring,) = FAMILIES["needle"](12, 0)
    width = max(y for _, y in ring) - min(y for _, y in ring)
    assert max(x for x, _ in ring) - min(x for x, _ in ring) >= mpq(10**6) * width


def test_subdividing_once_changes_nothing() -> None:
    rings = FAMILIES["random-hull"](9, 0)
    assert subdivided(rings, 1) == rings
