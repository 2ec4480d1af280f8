"""Moving, scaling, mirroring and renumbering a mesh changes the verdict just as it must."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import pytest

from tests.oracle.agreement import both
from tests.oracle.meshes import Case, Point, damage, good

seeds = pytest.mark.parametrize("seed", range(40))


def spoiled(seed: int) -> Case:
    """A good mesh, in two of three cases damaged."""
    rng = random.Random(seed)
    case = good(rng)
    for _ in range(seed % 3):
        damage(case, rng)
    return case


def places(verdict: dict[str, Any]) -> list[tuple[str, str]]:
    return [(defect["kind"], str(defect["where"])) for defect in verdict["defects"]]


def kinds(verdict: dict[str, Any]) -> set[str]:
    return {defect["kind"] for defect in verdict["defects"]}


@seeds
def test_translation(seed: int) -> None:
    case = spoiled(seed)

    def move(p: Point) -> Point:
        return p[0] + Fraction(10**30, 7), p[1] - Fraction(1, 3)

    before, after = both(case), both(case.mapped(move))
    assert kinds(before) == kinds(after)
    for key in ("valid", "max_angle", "min_height_squared", "angle_classes"):
        assert before[key] == after[key]


@seeds
def test_scaling(seed: int) -> None:
    case, k = spoiled(seed), Fraction(3, 10**9)
    before, after = both(case), both(case.mapped(lambda p: (k * p[0], k * p[1])))
    assert places(before) == places(after)
    assert before["max_angle"] == after["max_angle"]
    if before["min_height_squared"] is not None:
        height = Fraction(before["min_height_squared"]) * k * k
        assert height == Fraction(after["min_height_squared"])


@seeds
def test_mirroring_and_turning_the_triangles_over(seed: int) -> None:
    case = spoiled(seed)
    before = both(case)
    after = both(case.mapped(lambda p: (-p[0], p[1]), mirror=True))
    assert before["valid"] == after["valid"]
    assert kinds(before) == kinds(after)
    assert before["min_height_squared"] == after["min_height_squared"]
    assert before["angle_classes"] == after["angle_classes"]


@seeds
def test_mirroring_alone_turns_every_good_triangle_clockwise(seed: int) -> None:
    case = good(random.Random(seed))
    verdict = both(case.mapped(lambda p: (p[0], -p[1])))
    assert kinds(verdict) == {"clockwise-triangle"}
    assert len(verdict["defects"]) == min(100, len(case.triangles))


@seeds
def test_renumbering(seed: int) -> None:
    case, rng = spoiled(seed), random.Random(seed)
    n = len(case.vertices)
    order = list(range(n))
    rng.shuffle(order)
    new = {old: i for i, old in enumerate(order)}
    triangles = [(new.get(a, a), new.get(b, b), new.get(c, c)) for a, b, c in case.triangles]
    rng.shuffle(triangles)
    turned = [t[i:] + t[:i] for t in triangles for i in [rng.randrange(3)]]
    other = Case([case.vertices[v] for v in order], turned, case.rings)
    before, after = both(case), both(other)
    assert before["valid"] == after["valid"]
    assert kinds(before) == kinds(after)
    assert before["angle_classes"] == after["angle_classes"]


@seeds
def test_the_rings_may_be_read_from_anywhere_in_either_direction(seed: int) -> None:
    case, rng = spoiled(seed), random.Random(seed)
    before = both(case)
    shifts = [rng.randrange(len(ring)) for ring in case.rings]
    case.rings = [r[i:] + r[:i] for r, i in zip(case.rings, shifts, strict=True)]
    case.rings = [r[::-1] if rng.random() < 0.5 else r for r in case.rings]
    assert before["valid"] == both(case)["valid"]
