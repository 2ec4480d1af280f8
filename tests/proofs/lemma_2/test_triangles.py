"""What is found of triangles and sides holds, by boxes or by sections."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from random import Random

import numpy as np
import pytest
from gmpy2 import mpq

from proofs.lemma_2 import triangles
from proofs.lemma_2.block import CORNERS, block
from proofs.lemma_2.exact import Configuration, Vector, place, type_of
from proofs.lemma_2.forms import ONE, Form, lowered, product
from proofs.lemma_2.points import Bounds, Boxes, Place
from proofs.lemma_2.rays import E, F
from proofs.lemma_2.replay import scaled
from proofs.lemma_2.sections import asides, is_long
from proofs.lemma_2.warping import Ring, outcomes
from tests.proofs.lemma_2.configurations import TAU, box_round, some_configuration

CLAIM = Bounds((1, 1), scaled(1, 8), (91, 10), edges=True)


def rings_of(c: Configuration) -> set[Ring]:
    """The faces that any corner leaves."""
    made = block(c.cls, type_of(c, E, TAU), type_of(c, F, TAU))
    assert made is not None
    found = [found for corner in CORNERS for found in outcomes(made, corner)]
    return {ring for outcome in found for ring in outcome.rings}


def squared(p: Vector, q: Vector) -> mpq:
    return (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2


def altitude_squared(apex: Vector, p: Vector, q: Vector) -> mpq:
    """The squared distance of a point from the line through two others."""
    cross = (p[0] - apex[0]) * (q[1] - apex[1]) - (p[1] - apex[1]) * (q[0] - apex[0])
    return cross * cross / squared(p, q)


@pytest.mark.parametrize("cls", range(4))
def test_sections_tell_the_truth(cls: int) -> None:
    random, told = Random(f"sections {cls}"), [0, 0, 0]
    for _ in range(12):
        c = some_configuration(random, cls)
        for ring in rings_of(c):
            at = {point: place(c, point) for point in ring}
            for p, q in combinations(ring, 2):
                if is_long(cls, p, q):
                    assert squared(at[p], at[q]) >= TAU**2
                    told[0] += 1
            for corners in combinations(ring, 3):
                for g, q, w, axis, steep in asides(cls, corners):
                    a, b, d = (at[corners[i]] for i in (g, q, w))
                    assert a[axis] == b[axis] and squared(a, b) >= TAU**2
                    told[1] += 1
                    if steep:
                        assert altitude_squared(a, b, d) >= TAU**2 / 2
                        told[2] += 1
    assert min(told) > 20


@pytest.mark.parametrize("cls", range(4))
def test_what_passes_in_a_box_is_so_at_its_middle(cls: int) -> None:
    random, seen = Random(f"known {cls}"), set()
    for _ in range(4):
        c = some_configuration(random, cls)
        boxes = Boxes(*box_round(c, 256), cls, CLAIM)
        for ring in rings_of(c):
            for corners in combinations(ring, 3):
                a, b, d = (place(c, point) for point in corners)
                angle, height = least_cotangent_and_height((a, b, d))
                kept = angle >= -1 and height >= TAU**2 / 2
                passed = bool(np.all(triangles.is_triangle(boxes, corners)))
                assert kept or not passed
                seen.add((kept, passed))
            for p, q in combinations(ring, 2):
                long = squared(place(c, p), place(c, q)) >= TAU**2
                assert long or not np.all(triangles.is_side(boxes, p, q))
    assert seen >= {(True, True), (False, False)}


def test_a_side_shorter_than_tau_fails() -> None:
    c = Configuration((mpq(1, 3), mpq(19, 20)), (mpq(1, 7), mpq(1, 5)), 2, 0)
    boxes = Boxes(*box_round(c), 2, CLAIM)
    assert not triangles.is_side(boxes, ("v",), ("row", 0, 1, 1)).any()
    assert triangles.is_side(boxes, ("v",), ("row", 0, 2, 1)).all()


def test_angles_and_heights_of_exact_triangles() -> None:
    random = Random("triangles")
    bounds = Bounds((9, 10), scaled(1, 8), (3, 6))
    seen = set()
    for _ in range(600):
        size = random.choice((ONE // 16, ONE // 4, 2 * ONE))
        corners = [(random.randrange(-size, size), random.randrange(-size, size)) for _ in "abc"]
        a, b, c = (Place(*(Form(np.array([z])) for z in corner)) for corner in corners)
        angle, height = least_cotangent_and_height(corners)
        sides = (b - a, c - b, a - c)
        cross = lowered(
            product(sides[0].x, sides[1].y) - product(sides[0].y, sides[1].x), triangles.SHIFT
        )
        high = all(bool(triangles.is_high(bounds, cross, side)) for side in sides)
        least = mpq(3, 64) ** 2 * ONE**2
        assert high <= (height > least) and high >= (height > least * 33 / 32)
        good = bool(triangles.is_good(bounds, sides))
        assert good == (high and angle > -mpq(9, 10))
        seen.add((good, high))
    assert seen == {(True, True), (False, True), (False, False)}


def least_cotangent_and_height(corners: Sequence[tuple[mpq | int, mpq | int]]) -> tuple[mpq, mpq]:
    """Of a triangle; its height, squared, is negative if it is clockwise."""
    sides = [
        (corners[i][0] - corners[i - 1][0], corners[i][1] - corners[i - 1][1]) for i in range(3)
    ]
    cross = mpq(sides[0][0] * sides[1][1] - sides[0][1] * sides[1][0])
    if cross <= 0:
        return mpq(-(10**9)), mpq(-1)
    dots = [
        -(u[0] * w[0] + u[1] * w[1]) for u, w in zip(sides, [*sides[1:], sides[0]], strict=True)
    ]
    longest = max(u[0] ** 2 + u[1] ** 2 for u in sides)
    return min(dots) / cross, cross * cross / longest


def test_roots_are_near() -> None:
    squares = np.arange(1 << 20, dtype=np.int64)
    found = triangles.roots(squares)
    assert (abs(found * found - squares) <= 2 * found + 2).all() and (found > 0).all()
