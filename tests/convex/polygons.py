"""Convex polygons that are hard in some way, each from a seed."""

from __future__ import annotations

from collections.abc import Callable
from random import Random

from gmpy2 import mpq
from hypothesis import strategies as st

from bern_exact.corpus.convex import FAMILIES, Place, Rings, hull, subdivided
from bern_exact.exact.points import coordinates, hpoint
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings

SHAPES: dict[str, list[Place]] = {
    "triangle": [(0, 0), (5, 0), (2, 3)],
    "right triangle": [(0, 0), (4, 0), (0, 3)],
    "equilateral by area": [(0, 0), (2, 0), (1, mpq(7, 4))],
    "needle triangle": [(0, 0), (10**6, 0), (3, 1)],
    "needle": [(0, 0), (10**6, 1), (2 * 10**6, 0), (10**6 + 7, -1)],
    "square": [(0, 0), (1, 0), (1, 1), (0, 1)],
    "rectangle": [(0, 0), (5, 0), (5, 1), (0, 1)],
    "rhombus": [(0, 0), (3, -1), (6, 0), (3, 1)],
    "kite": [(0, 0), (1, -2), (9, 0), (1, 2)],
    "flat top and bottom": [(0, 0), (2, -1), (5, -1), (9, 0), (7, 2), (4, 2)],
    "bottom within top": [(0, 0), (4, -1), (5, -1), (9, 0), (8, 2), (1, 2)],
    "top within bottom": [(0, 0), (1, -1), (8, -1), (9, 0), (6, 2), (5, 2)],
    "flats that meet": [(0, 0), (1, -1), (4, -1), (9, 0), (7, 1), (4, 1)],
    "diameter subdivided": [(0, 0), (2, 0), (3, 0), (6, 0), (5, 1), (1, 2)],
}
"""Single shapes by name."""


def polygon(rings: Rings) -> Polygon:
    """The validated polygon."""
    return polygon_from_rings([[hpoint(mpq(x), mpq(y)) for x, y in ring] for ring in rings])


def family(name: str, n: int, seed: int = 0, parts: int = 1) -> Polygon:
    """A member of a family, its edges in so many parts."""
    rings = FAMILIES[name](n, seed)
    return polygon(subdivided(rings, parts) if parts > 1 else rings)


def shape(name: str) -> Polygon:
    """A single shape."""
    return polygon([SHAPES[name]])


def small_grid(random: Random) -> Rings:
    """The hull of a few points of a small grid: parallel edges, ties for the diameter."""
    size = random.choice((3, 4, 5, 8))
    return [hull([(random.randrange(size), random.randrange(size)) for _ in range(10)])]


def flats(random: Random) -> Rings:
    """Flat tops and bottoms in any order, with vertices below and above."""
    width = random.randrange(5, 12)

    def two() -> list[int]:
        return sorted(random.sample(range(1, width), 2))

    points: list[Place] = [(0, 0), (width, 0)]
    points += [(x, 1) for x in two()] + [(x, -1) for x in two()]
    points += [(random.randrange(width), mpq(random.randrange(-9, 10), 10)) for _ in range(4)]
    return [hull(points)]


def mirrored(random: Random) -> Rings:
    """The same chain above and below, or turned by 180 degrees: all paths close, or none."""
    width = random.randrange(5, 12)
    half = [(random.randrange(1, width), mpq(random.randrange(1, 9), 4)) for _ in range(4)]
    other = [(x, -y) for x, y in half]
    if random.randrange(2):
        other = [(width - x, y) for x, y in other]
    return [hull([(0, 0), (width, 0), *half, *other])]


RANDOM: dict[str, Callable[[Random], Rings]] = {
    "small-grid": small_grid,
    "flats": flats,
    "mirrored": mirrored,
}


def some_convex(random: Random, most: int = 13) -> Polygon:
    """Any of these, perhaps subdivided, turned by an exact similarity, reversed or relabelled."""
    name = random.choice((*RANDOM, *FAMILIES))
    ring: list[Place] = []
    while len(ring) < 3:
        n = random.randrange(6, most + 1)
        (ring,) = RANDOM[name](random) if name in RANDOM else FAMILIES[name](n, random.randrange(9))
    (ring,) = subdivided([ring], random.choice((1, 1, 1, 2, 3)))
    u, v = random.choice(((1, 0), (3, 4), (1, -7), (-2, 1)))
    ring = [(u * x - v * y, v * x + u * y) for x, y in ring]
    start = random.randrange(len(ring))
    ring = ring[start:] + ring[:start]
    return polygon([ring[:: random.choice((1, -1))]])


def convex_hull_of(shape: Polygon) -> Polygon:
    """The convex hull of a polygon."""
    return polygon([hull([coordinates(p) for p in shape.points])])


def convex_polygons(most: int = 13) -> st.SearchStrategy[Polygon]:
    """Any convex polygon that `some_convex` draws, from members of at most so many vertices."""
    return st.integers(0, 10**6).map(lambda seed: some_convex(Random(seed), most))
