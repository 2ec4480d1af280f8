"""Convex polygons as families, for Theorem 4."""

from __future__ import annotations

from random import Random

from bern_exact.corpus import convex
from bern_exact.corpus.draws import Rings, pick
from bern_exact.corpus.family import Family, by_name, by_seed


def subdivided(random: Random, n: int, parts: int) -> Rings:
    """A convex polygon with each edge in so many equal parts."""
    made = pick(random, (convex.random_hull, convex.regular, convex.parabola))
    return convex.subdivided(made(n, random.randrange(1001)), parts)


def small_hull(random: Random, size: int) -> Rings:
    """The hull of ten points of a small grid."""
    return [convex.hull([(random.randrange(size), random.randrange(size)) for _ in range(10)])]


_TWELVE = {"n": (5, 12)}

FAMILIES = (
    Family(
        "random-hull",
        "lengths taken for alike: the hull of random points, with very long and very short edges",
        ("convex",),
        _TWELVE,
        by_seed(convex.random_hull),
    ),
    Family(
        "random-convex",
        "what holds near circles only: random vectors in the order of their angles",
        ("convex",),
        _TWELVE,
        by_seed(convex.random_convex),
    ),
    Family(
        "small-hull",
        "the choice of a diameter among ties: the hull of a few points of a small grid",
        ("convex",),
        {"size": (3, 8)},
        by_name(small_hull),
    ),
    Family(
        "cocircular",
        "in-circle tests and the choice of a diameter: rational points exactly on a circle",
        ("convex", "cocircular", "needs-rationals"),
        _TWELVE,
        by_seed(convex.regular, 1001),
    ),
    Family(
        "parabola",
        "a longest diagonal that is an edge: everything on one side of it",
        ("convex",),
        _TWELVE,
        by_seed(convex.parabola, 100),
    ),
    Family(
        "arc",
        "a longest diagonal that is an edge, and in-circle tests: points of at most half a circle",
        ("convex", "cocircular"),
        _TWELVE,
        by_seed(convex.arc, 1000),
    ),
    Family(
        "ellipse",
        "round frames: a thousand times as long as wide, the vertices crowded at both ends",
        ("convex", "slender"),
        _TWELVE,
        by_seed(convex.ellipse, 1001),
    ),
    Family(
        "tiny-edges",
        "lengths taken for granted: edges of 1 and of 10^5 beside each other",
        ("convex", "cocircular", "uneven-edges"),
        {"n": (6, 12)},
        by_seed(convex.tiny_edges),
    ),
    Family(
        "clustered-spiral",
        "bounds on bouncing: vertices close together whose paths wind out by a hundredth a turn",
        ("convex", "near-flat"),
        {"n": (6, 12)},
        by_seed(convex.clustered_spiral),
    ),
    Family(
        "occupied-spiral",
        "orders of bouncing: paths wind through triangles that hold a subdivision each",
        ("convex", "near-flat"),
        {"n": (7, 12)},
        by_seed(convex.occupied_spiral),
    ),
    Family(
        "convex-needle",
        "frames without height: a convex polygon a million times as long as wide",
        ("convex", "slender", "needle"),
        {"n": (6, 12)},
        by_seed(convex.needle),
    ),
    Family(
        "convex-subdivided",
        "180-degree vertices that Theorem 4 must not take for corners: every edge in equal parts",
        ("convex", "flat-vertices"),
        {"n": (4, 6), "parts": (2, 3)},
        by_name(subdivided),
    ),
)
