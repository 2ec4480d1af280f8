"""What is evaluated over a box contains what holds at a place in it."""

from __future__ import annotations

from random import Random
from typing import Any

import numpy as np
import pytest
from gmpy2 import mpq

from proofs.lemma_2.block import CORNERS, block
from proofs.lemma_2.exact import Configuration, place, type_of
from proofs.lemma_2.forms import ONE, Form
from proofs.lemma_2.points import Bounds, Boxes, Place, roots
from proofs.lemma_2.rays import E, F
from proofs.lemma_2.replay import Rays, scaled
from proofs.lemma_2.warping import outcomes
from tests.proofs.lemma_2.configurations import TAU, some_configuration

BOUNDS = Bounds((1, 1), scaled(1, 8))


def random_box(random: Random, c: Configuration) -> Boxes:
    """A box with a configuration in it, not in its middle."""
    size = ONE >> random.choice((3, 5, 8, 12))
    low, high = [], []
    for p in (*c.v, *c.slopes):
        start = int(p * ONE) - random.randrange(size)
        low.append([start])
        high.append([start + 2 * size])
    return Boxes(np.array(low, dtype=np.int64), np.array(high, dtype=np.int64), c.cls, BOUNDS)


def is_within(form: Form, value: mpq) -> bool:
    """Is a value in the range of a form?"""
    centre: Any = np.broadcast_to(form.c, 1)[0]
    radius: Any = np.broadcast_to(form.radius(), 1)[0]
    return bool(abs(value * ONE - int(centre)) <= int(radius))


@pytest.mark.parametrize("cls", range(4))
def test_types_and_places(cls: int) -> None:
    random = Random(f"points {cls}")
    for _ in range(40):
        c = some_configuration(random, cls)
        boxes = random_box(random, c)
        kinds = [type_of(c, ray, TAU) for ray in (E, F)]
        rays = Rays(boxes)
        assert all(rays.possible(ray, kinds[ray]).all() for ray in (E, F))
        made = block(cls, *kinds)
        assert made is not None
        for corner in CORNERS:
            for found in outcomes(made, corner):
                for point in {point for ring in found.rings for point in ring}:
                    forms, exact = boxes.place(point), place(c, point)
                    assert is_within(forms.x, exact[0]) and is_within(forms.y, exact[1])


def test_angles_and_heights_of_exact_triangles() -> None:
    random = Random("triangles")
    zero = np.zeros((4, 1), dtype=np.int64)
    boxes = Boxes(zero, zero, 0, Bounds((9, 10), scaled(1, 8), (3, 6)))
    seen = set()
    for _ in range(600):
        size = random.choice((ONE // 16, ONE // 4, 2 * ONE))
        corners = [(random.randrange(-size, size), random.randrange(-size, size)) for _ in "abc"]
        a, b, c = (Place(*(Form(np.array([z])) for z in corner)) for corner in corners)
        angle, squared = least_cotangent_and_height(corners)
        high = bool(boxes.is_high((b - a, c - b, a - c)))
        assert high <= (squared > mpq(3, 64) ** 2) and high >= (squared > mpq(3, 64) ** 2 * 33 / 32)
        good = bool(boxes.is_good(a, b, c))
        assert good == (high and angle > -mpq(9, 10))
        seen.add((good, high))
    assert seen == {(True, True), (False, True), (False, False)}


def least_cotangent_and_height(corners: list[tuple[int, int]]) -> tuple[mpq, mpq]:
    """Of a triangle, in grid units and squared; its height is negative if it is clockwise."""
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
    return min(dots) / cross, cross * cross / longest / ONE**2


def test_roots_are_near() -> None:
    squares = np.arange(1 << 20, dtype=np.int64)
    found = roots(squares)
    assert (abs(found * found - squares) <= 2 * found + 2).all() and (found > 0).all()
