"""The same polygon just good and just bad: two things 10^-40 apart, or 10^-40 into each other."""

from __future__ import annotations

from collections.abc import Callable
from random import Random

from gmpy2 import mpq

from bern_exact.corpus.draws import Ring, Rings, beside, between, moved, nth
from bern_exact.corpus.family import Family, without_random

OUTER: Ring = [(0, 0), (20, 3), (24, 21), (-3, 19)]
"""A square, hardly turned: no edge is axis-parallel."""


def _part(random: Random) -> mpq:
    """A part of an edge, far from its ends."""
    return mpq(between(random, 3, 7), 10) + mpq(between(random, -9, 9), 997)


def tip_at_edge(random: Random, gap: mpq) -> Rings:
    """A hole's tip next to the outer ring."""
    tip = beside(OUTER[0], OUTER[1], _part(random), gap)
    return [OUTER, [tip, (13, between(random, 9, 14)), (5, between(random, 9, 14))]]


def tip_at_hole(random: Random, gap: mpq) -> Rings:
    """The tip of one hole next to an edge of another."""
    hole: Ring = [(4, 6), (17, between(random, 7, 9)), (11, 10)]
    tip = beside(hole[0], hole[1], _part(random), -gap)
    return [OUTER, hole, [tip, (9, 4), (12, between(random, 4, 5))]]


def tip_at_wall(random: Random, gap: mpq) -> Rings:
    """A reflex vertex of the outer ring next to its opposite edge."""
    tip = beside(OUTER[3], OUTER[0], _part(random), gap)
    return [[*OUTER[:2], (22, between(random, 8, 10)), tip, (23, 14), *OUTER[2:]]]


def tip_to_tip(random: Random, gap: mpq) -> Rings:
    """Two reflex tips of the outer ring that would meet in a point."""
    x, y = 10 + mpq(between(random, 1, 29), 10), between(random, 9, 12)
    lower: Ring = [(6, 1), (x, y - gap), (9, 1)]
    upper: Ring = [(13, 20), (x, y + gap), (10, 20)]
    return [[(0, 0), *lower, (20, 1), (21, 21), *upper, (-1, 20)]]


def wall_to_wall(random: Random, gap: mpq) -> Rings:
    """A hole with an edge along the outer ring."""
    part, tilt = _part(random), mpq(between(random, 1, 9), 10)
    p = beside(OUTER[1], OUTER[2], part - mpq(1, 4), gap)
    q = beside(OUTER[1], OUTER[2], part + mpq(1, 4), gap)
    return [OUTER, [p, q, (10 + tilt, 10)]]


def slit_walls(random: Random, gap: mpq) -> Rings:
    """An exterior slit whose walls would lie on each other."""
    y, deep = between(random, 6, 12), between(random, 3, 9)
    ring: Ring = [(0, 0), (20, 0), (20, y - gap), (deep, y - gap), (deep - 1, y + 3)]
    return [[*ring, (deep + 1, y + gap), (18, y + gap), (21, 20), (0, 20)]]


SHAPES: tuple[Callable[[Random, mpq], Rings], ...] = (
    tip_at_edge,
    tip_at_hole,
    tip_at_wall,
    tip_to_tip,
    wall_to_wall,
    slit_walls,
)
"""What nearly meets."""


def near_miss(gap: mpq, shape: int, variant: int) -> Rings:
    """The polygon of this shape and variant with a gap: a polygon if it is above 0, else not.

    Turned and moved by an exact similarity, so that the gap lies along no axis.
    """
    random = Random(f"near miss {shape} {variant}")
    rings = nth(SHAPES, shape)(random, gap)
    c, s = between(random, 1, 9), between(random, 1, 9)
    return moved(rings, lambda x, y: (c * x - s * y, s * x + c * y))


def just_good(shape: int, variant: int, digits: int) -> Rings:
    """Apart by about 10^-digits."""
    return near_miss(mpq(1, 10**digits), shape, variant)


def just_bad(shape: int, variant: int, digits: int) -> Rings:
    """Into each other by about 10^-digits."""
    return near_miss(mpq(-1, 10**digits), shape, variant)


_PARAMETERS = {"shape": (0, len(SHAPES) - 1), "variant": (0, 999), "digits": (40, 40)}

GOOD = (
    Family(
        "just-good",
        "refusals by a tolerance: two things 10^-40 apart, which is a polygon; the same parameters "
        "of just-bad give its twin",
        ("near-miss", "needs-rationals"),
        _PARAMETERS,
        without_random(just_good),
    ),
)

BAD = (
    Family(
        "just-bad",
        "acceptance by a tolerance: two edges cross by 10^-40; the same parameters of just-good "
        "give its twin",
        ("bad", "near-miss", "needs-rationals"),
        _PARAMETERS,
        without_random(just_bad),
        errors=("edges-cross",),
    ),
)
