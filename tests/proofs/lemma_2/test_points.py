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
from proofs.lemma_2.points import Bounds, Boxes
from proofs.lemma_2.rays import E, F
from proofs.lemma_2.replay import Rays, scaled
from proofs.lemma_2.warping import outcomes
from tests.proofs.lemma_2.configurations import TAU, some_configuration

EIGHTH = Bounds((1, 1), scaled(1, 8))
SLAB = Bounds((1, 1), scaled(1, 16), slab=scaled(1, 16))
"""All thresholds from 1/16 to 1/8."""


def random_box(random: Random, c: Configuration, bounds: Bounds) -> Boxes:
    """A box with a configuration in it, not in its middle."""
    size = ONE >> random.choice((3, 5, 8, 12))
    low, high = [], []
    for p in (*c.v, *c.slopes):
        start = int(p * ONE) - random.randrange(size)
        low.append([start])
        high.append([start + 2 * size])
    return Boxes(np.array(low, dtype=np.int64), np.array(high, dtype=np.int64), c.cls, bounds)


def is_within(form: Form, value: mpq) -> bool:
    """Is a value in the range of a form?"""
    centre: Any = np.broadcast_to(form.c, 1)[0]
    radius: Any = np.broadcast_to(form.radius(), 1)[0]
    return bool(abs(value * ONE - int(centre)) <= int(radius))


@pytest.mark.parametrize("bounds", [EIGHTH, SLAB], ids=["1/8", "slab"])
@pytest.mark.parametrize("cls", range(4))
def test_types_and_places(cls: int, bounds: Bounds) -> None:
    random = Random(f"points {cls}")
    for _ in range(40 if bounds == EIGHTH else 20):
        c = some_configuration(random, cls)
        boxes = random_box(random, c, bounds)
        tau = TAU - mpq(random.randrange(5) * bounds.slab, 4 * ONE)
        kinds = [type_of(c, ray, tau) for ray in (E, F)]
        rays = Rays(boxes)
        assert all(rays.possible(ray, kinds[ray]).all() for ray in (E, F))
        made = block(cls, *kinds)
        assert made is not None
        for corner in CORNERS:
            for found in outcomes(made, corner):
                for point in {point for ring in found.rings for point in ring}:
                    forms, exact = boxes.place(point), place(c, point)
                    assert is_within(forms.x, exact[0]) and is_within(forms.y, exact[1])
