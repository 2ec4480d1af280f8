"""The corner rule, where the closest corner will not do."""

from __future__ import annotations

from functools import cache

import pytest
from gmpy2 import mpq

from bern_exact.boundary.corners import TAU, CornerRule, warp
from bern_exact.boundary.faces import trace
from bern_exact.boundary.optimal import (
    HIGHEST_WITHIN_135,
    KAPPA_135,
    Demand,
    best_triangulation,
)
from bern_exact.boundary.warp import Warping
from bern_exact.corpus.over_the_grid import around, moved_back
from bern_exact.exact.points import HPoint, grid_point, hpoint
from bern_exact.exact.predicates import is_in_wedge, squared_distance
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems.theorem_1 import theorem_1
from tests.boundary.naive import square
from tests.boundary.samples import Stages, drawn, every_family, stages_of
from tests.theorems.families import some_polygon

HAIRS = [mpq(1, 10), mpq(1, 100), mpq(1, 10**6), mpq(1, 10**12)]
DELTAS = [mpq(1, 50), mpq(1, 10), TAU - mpq(1, 10**9)]

REFUSED = [("threshold", seed) for seed in (20, 24, 59, 227, 350, 555)]
"""Random polygons in which some vertex needs another corner than the closest."""


@cache
def counterexample(hair: mpq, delta: mpq) -> Polygon:
    """v left of and above (1/2, 1/2) by a hair, its incoming edge through (1 + delta, 2).

    The closest corner, (0, 1), is outside.
    """
    v = (mpq(1, 2) - hair, mpq(1, 2) + hair)
    into = (1 + delta - v[0], 2 - v[1])
    return polygon_from_rings([moved_back(around(v, (mpq(-1), mpq(-3)), into))])


def all_corners(v: HPoint) -> list[tuple[int, int]]:
    """The corners of the square of v by distance, ties lexicographic."""
    x, y = square(v)
    corners = [(x + i, y + j) for i in (0, 1) for j in (0, 1)]
    return sorted(corners, key=lambda corner: (squared_distance(v, grid_point(*corner)), corner))


@pytest.mark.parametrize("delta", DELTAS[1:])
@pytest.mark.parametrize("hair", HAIRS[1:])
def test_the_closest_corner_is_refused(hair: mpq, delta: mpq) -> None:
    made = theorem_1(counterexample(hair, delta))  # every check: all angles in blocks <= 135
    stages = stages_of(counterexample(hair, delta))
    assert made.framed.unit == 1
    v = stages.framed.polygon.points[0]
    assert v == hpoint(mpq(1, 2) - hair, mpq(1, 2) + hair)
    assert all_corners(v)[0] == (0, 1)
    assert stages.warped.rank[0] > 0 and stages.warped.corners[0] != (0, 1)


@pytest.mark.parametrize("delta", DELTAS)
def test_the_closest_corner_gives_135_degrees_and_arctan_delta(delta: mpq) -> None:
    # In the limit of no hair; a hair changes the cotangent by about as much.
    hair = HAIRS[-1]
    traced, tracer = trace(stages_of(counterexample(hair, delta)).diced)
    rule = CornerRule(traced, tracer, TAU)
    polygon = traced.diced.framed.polygon
    moves = {(polygon.before[0], 0, 1): 0, (0, 0, 1): 0}
    warping = Warping(rule.q, {}, moves)
    worst = max(
        wanted
        for face in traced.faces
        if face.block == 0
        for final in warping.rings(face.ring)
        for wanted in [kappa_of([p for _, p in final])]
    )
    # cot(135 + arctan d) = -(1 + d)/(1 - d), and kappa is its negative.
    expected = (1 + delta) / (1 - delta)
    assert abs(worst - expected) < 100 * hair


def kappa_of(points: list[HPoint]) -> mpq:
    """Minus the least cotangent in the triangulation whose largest angle is least."""
    found = best_triangulation(points, Demand(for_angle=True))
    assert found is not None
    return -found.value


@pytest.mark.parametrize(("kind", "seed"), REFUSED)
def test_random_polygons_that_need_another_corner(kind: str, seed: int) -> None:
    made = theorem_1(some_polygon(kind, seed))
    assert any(stages_of(made.polygon).warped.rank)


def test_two_corners_may_be_refused() -> None:
    assert max(drawn("threshold", 555).warped.rank) == 2


def refusals(stages: Stages, v: int, corner: tuple[int, int]) -> list[str]:
    """What is wrong with a corner: the block is warped anew, with this corner for v alone."""
    traced, tracer = trace(stages.diced)
    polygon = stages.framed.polygon
    before, after = polygon.before[v], polygon.after[v]
    ends = [polygon.points[i] for i in (before, v, after)]
    moved = {corner: v} if is_in_wedge(grid_point(*corner), *ends) else {}
    moves = {(before, *corner): v, (v, *corner): v}
    warping = Warping(CornerRule(traced, tracer, TAU).q, moved, moves)
    wrong = []
    for face in [*traced.faces, *stages.boundary.touched]:
        if face.block != v:
            continue
        for final in warping.rings(face.ring):
            ring = [p for _, p in final]
            found = best_triangulation(ring, HIGHEST_WITHIN_135)
            if any(squared_distance(ring[i - 1], p) < TAU**2 for i, p in enumerate(ring)):
                wrong.append("edge")
            elif found is None:
                wrong.append("angle")
            elif 2 * found.value < TAU**2:
                wrong.append("height")
    return wrong


@every_family
def test_rank_counts_the_closer_corners(kind: str, seed: int) -> None:
    warped = drawn(kind, seed).warped
    points = warped.traced.diced.framed.polygon.points
    for v, (corner, rank) in enumerate(zip(warped.corners, warped.rank, strict=True)):
        assert all_corners(points[v])[rank] == corner


@pytest.mark.parametrize(("kind", "seed"), REFUSED)
def test_closer_corners_are_refused_for_a_reason_and_the_chosen_for_none(
    kind: str, seed: int
) -> None:
    stages = drawn(kind, seed)
    for v, rank in enumerate(stages.warped.rank):
        *closer, chosen = all_corners(stages.framed.polygon.points[v])[: rank + 1]
        assert not refusals(stages, v, chosen)
        # A rectangle of the block that the chosen corner leaves alone is not looked at here.
        assert rank == 0 or any(refusals(stages, v, corner) for corner in closer)


def test_the_choice_is_a_function_of_the_record() -> None:
    stages = drawn("threshold", 20)
    again, _ = warp(*trace(stages.diced))
    assert again == stages.warped


def test_if_no_corner_keeps_heights_the_closest_within_135_degrees_is_taken() -> None:
    traced, tracer = trace(stages_of(counterexample(HAIRS[1], DELTAS[1])).diced)
    rule = CornerRule(traced, tracer, TAU)
    chosen, rank = rule.choose(0)
    assert 0 < rank < 4  # the closest has larger angles
    first, second = rule.demands
    assert first.squared_floor > 0 == second.squared_floor
    never = Demand(KAPPA_135, mpq(100))
    rule.demands = (never, second)
    assert rule.choose(0) == (chosen, 4 + rank)
    rule.demands = (never, never)
    assert rule.choose(0)[1] == 8 and rule.choose(0)[0].corner == (0, 1)
