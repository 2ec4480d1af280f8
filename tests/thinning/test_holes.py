"""Grades and the filling of holes against the definition and another dynamic programme."""

from __future__ import annotations

from random import Random

import pytest
from gmpy2 import mpq

from bern_exact.boundary.optimal import KAPPA_135, Demand, best_triangulation
from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.exact.angles import largest_angle
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.exact.predicates import orientation, squared_height
from bern_exact.thinning.grade import BITS, PASS, Grades
from bern_exact.thinning.holes import fill
from tests.theorems.families import some_polygon

BOUNDS = ("150", "149.5", "120", "90", "60", "cos:-1:3/4", "180", "100")


def random_triangle(random: Random) -> list[HPoint]:
    return [
        hpoint(mpq(random.randrange(20), random.randrange(1, 5)), mpq(random.randrange(20), 3))
        for _ in range(3)
    ]


@pytest.mark.parametrize("text", BOUNDS)
def test_a_triangle_may_be_made_if_it_keeps_angle_and_height(text: str) -> None:
    random, bound = Random(text), parse_angle_bound(text)
    for _ in range(300):
        p, q, r = points = random_triangle(random)
        floor = mpq(random.randrange(1, 30), 7)
        allowed = (
            orientation(p, q, r) > 0
            and bound.admits(largest_angle(p, q, r)[0])
            and squared_height(p, q, r) >= floor
        )
        assert (Grades(points, [bound], floor).of(0, 1, 2) >= PASS) == allowed


def test_a_height_at_the_floor_passes_and_one_just_below_does_not() -> None:
    points = [hpoint(0, 0), hpoint(2, 0), hpoint(1, 1)]
    assert Grades(points, [], mpq(1)).of(0, 1, 2) == PASS
    assert Grades(points, [], 1 + mpq(1, 10**40)).of(0, 1, 2) == 0


def test_an_angle_at_the_bound_passes_and_a_right_angle_is_at_90() -> None:
    points = [hpoint(0, 0), hpoint(2, 0), hpoint(0, 1)]
    right, less = parse_angle_bound("90"), parse_angle_bound("89.9999999999999999999999999")
    assert Grades(points, [right], mpq(1, 100)).of(0, 1, 2) > 0
    assert Grades(points, [right, less], mpq(1, 100)).of(0, 1, 2) == 0


def least_grade(points: list[HPoint], triangles: list[tuple[int, int, int]], floor: mpq) -> int:
    least = min(squared_height(*(points[v] for v in t)) for t in triangles)
    return int(least / floor * 2**BITS)


@pytest.mark.parametrize("seed", range(40))
@pytest.mark.parametrize("bounded", [False, True])
def test_a_hole_is_filled_as_the_other_programme_fills_it(seed: int, bounded: bool) -> None:
    polygon = some_polygon("simple", seed)
    (ring,) = polygon.rings
    floor = mpq(1, 50)
    bounds = [parse_angle_bound("135")] if bounded else []
    filled = fill(ring, Grades(polygon.points, bounds, floor))
    demand = Demand(KAPPA_135 if bounded else None, floor)
    best = best_triangulation([polygon.points[v] for v in ring], demand)
    assert (filled is None) == (best is None)
    if filled is not None and best is not None:
        points = list(polygon.points)
        assert len(filled) == len(ring) - 2
        assert least_grade(points, filled, floor) == int(best.value / floor * 2**BITS)


def test_more_triangles_than_are_remembered(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("bern_exact.thinning.grade._MOST_REMEMBERED", 2)
    polygon = some_polygon("simple", 3)
    (ring,) = polygon.rings
    forgetful = fill(ring, Grades(polygon.points, [], mpq(1, 10**6)))
    monkeypatch.undo()
    assert forgetful == fill(ring, Grades(polygon.points, [], mpq(1, 10**6))) is not None
