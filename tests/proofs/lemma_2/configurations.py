"""Vertices with two rays: at random, and with rays that pass grid vertices at about tau."""

from __future__ import annotations

from random import Random
from typing import Any

import numpy as np
from gmpy2 import mpq

from proofs.lemma_2.block import LEFT, UP
from proofs.lemma_2.exact import Configuration, Vector, turned_point
from proofs.lemma_2.forms import ONE

TAU = mpq(1, 8)

# At tau exactly, too; through a grid vertex never.
OFFSETS = [mpq(k, 8) for k in (-8, -7, -1, 0, 1, 7, 8)]


def some_configuration(random: Random, cls: int) -> Configuration:
    """A configuration of this class, e going up; generic up to hairs."""
    while True:
        v = (_coordinate(random), _coordinate(random))
        slopes = (_slope(random, v), _slope(random, _own(v, cls)))
        if cls == UP and slopes[1] <= slopes[0]:
            continue
        if cls == LEFT and slopes[1] > slopes[0]:
            continue
        if all(0 < abs(m) < 1 for m in slopes):
            return Configuration(v, slopes, cls, 0)


def _own(v: Vector, quarters: int) -> Vector:
    return turned_point(-quarters % 4, v)


def _hair(random: Random) -> mpq:
    """A little more or less than nothing, and never special."""
    size = random.choice((97, 10**3, 10**6, 10**12))
    return mpq(random.choice((-1, 1)), size + random.randrange(1, 50))


def _coordinate(random: Random) -> mpq:
    """In (0, 1): at random, or near a multiple of 1/8."""
    while True:
        c = mpq(random.randrange(1, 997), 997)
        if random.randrange(2):
            c = mpq(random.randrange(9), 8) + _hair(random)
        if 0 < c < 1:
            return c


def _slope(random: Random, v: Vector) -> mpq:
    """m of a ray that goes up from v: at random, or past a grid vertex at about tau or 0."""
    if random.randrange(3) == 0:
        return mpq(random.randrange(-996, 997), 997)
    k, level = random.randrange(-1, 3), random.choice((1, 2))
    offset = random.choice(OFFSETS)
    if offset.denominator == 1 or random.randrange(4):
        offset += _hair(random)
    if random.randrange(2):
        return (k + offset - v[0]) / (level - v[1])
    rise = level - 1 + abs(offset) - v[1]
    return (k - v[0]) / rise if rise > 0 else mpq(0)


def directions(c: Configuration) -> tuple[Vector, Vector]:
    """The directions of e and f."""
    m_e, m_f = c.slopes
    x, y = m_f, mpq(1)
    for _ in range(c.cls):
        x, y = -y, x
    return (m_e, mpq(1)), (x, y)


def box_round(c: Configuration, radius: int = 4) -> tuple[Any, Any]:
    """A small box of parameters, as two arrays of one column."""
    centre = [int(p * ONE) for p in (*c.v, *c.slopes)]
    return tuple(np.array([[p + s * radius] for p in centre], dtype=np.int64) for s in (-1, 1))
