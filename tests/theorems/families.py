"""Random polygons of the kinds that break triangulations, each from a `Random` alone.

A family may return rings that are no polygon; `some_polygon` draws until they are.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from random import Random

from gmpy2 import mpq

from bern_exact.corpus import shapes as corpus
from bern_exact.exact.errors import InputError
from bern_exact.exact.points import HPoint, along, coordinates, hpoint
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings
from tests.plane import shapes
from tests.theorems.over_the_grid import aimed_at_grid_points, special_in_first_frames

Ring = list[HPoint]
Rings = list[Ring]
Family = Callable[[Random], Rings]
Pairs = Sequence[tuple[int | mpq, int | mpq]]


def ring(pairs: Pairs) -> Ring:
    """Points from rational pairs."""
    return [hpoint(mpq(x), mpq(y)) for x, y in pairs]


def mapped(rings: Rings, move: Callable[[mpq, mpq], tuple[mpq, mpq]]) -> Rings:
    """Every point moved."""
    return [[hpoint(*move(*coordinates(p))) for p in each] for each in rings]


# Plain ------------------------------------------------------------------------


def triangle(random: Random) -> Rings:
    """Three points, often far from equilateral."""
    size = 10 ** random.randrange(1, 7)
    return [ring([(random.randrange(size), random.randrange(10)) for _ in range(3)])]


def simple(random: Random) -> Rings:
    """Random points on a small grid: collinear runs, axis-parallel and 45-degree edges."""
    return [shapes.untangled(random.randrange(10**9), random.randrange(4, 15), 12)]


def simple_with_holes(random: Random) -> Rings:
    """A random simple ring with triangular holes on a finer grid, wherever they fit."""
    rings = [shapes.untangled(random.randrange(10**9), random.randrange(4, 12), 9)]
    for _ in range(8):
        x, y = random.randrange(36), random.randrange(36)
        hole = [
            (mpq(x + random.randrange(-4, 5), 4), mpq(y + random.randrange(-4, 5), 4))
            for _ in range(3)
        ]
        if is_valid([*rings, ring(hole)]):
            rings.append(ring(hole))
    return rings


def star(random: Random) -> Rings:
    """Long thin spikes round a centre."""
    return [ring(r) for r in corpus.star(random.randrange(4, 25), random.randrange(10**9))]


def maze(random: Random) -> Rings:
    """Corridors of a random tree, shaken."""
    return [ring(r) for r in corpus.maze(random.randrange(10, 50), random.randrange(10**9))]


def plate(random: Random) -> Rings:
    """A square with turned square holes."""
    return [ring(r) for r in corpus.plate(random.randrange(8, 50), random.randrange(10**9))]


def spiral(random: Random) -> Rings:
    """A corridor wound up."""
    return [ring(r) for r in corpus.spiral(random.randrange(8, 30), random.randrange(10**9))]


# Special directions and vertices ---------------------------------------------------


def rectilinear(random: Random) -> Rings:
    """A maze whose walls are exactly axis-parallel."""
    return [
        ring([((x + 8) // 16, (y + 8) // 16) for x, y in each])
        for each in corpus.maze(random.randrange(10, 40), random.randrange(10**9))
    ]


def octilinear(random: Random) -> Rings:
    """A rectilinear maze with every corner cut off at 45 degrees."""
    (walls,) = rectilinear(random)
    cut = []
    for before, corner, after in zip(
        walls[-1:] + walls, walls, walls[1:] + walls[:1], strict=False
    ):
        for end in (before, after):
            (x, y), (u, v) = coordinates(corner), coordinates(end)
            cut.append((x + mpq((u > x) - (u < x), 4), y + mpq((v > y) - (v < y), 4)))
    return [ring(cut)]


def subdivided(random: Random) -> Rings:
    """Any other polygon with 180-degree vertices on its edges, some very near to an end."""
    rings = list(some_rings(random, random.choice((simple_with_holes, maze, star))))
    for number, each in enumerate(rings):
        finer = []
        for p, q in zip(each, each[1:] + each[:1], strict=True):
            finer.append(p)
            if random.randrange(3) == 0:
                finer.append(along(p, q, mpq(1, random.choice((2, 3, 7, 50)))))
        rings[number] = finer
    return rings


def special_frame(random: Random) -> Rings:
    """Edges and vertices exactly on grid lines in the first frames that are tried."""
    return special_in_first_frames(random)


def threshold(random: Random) -> Rings:
    """One vertex whose edges pass at about tau from grid points of its block."""
    return aimed_at_grid_points(random)


# Extreme coordinates -------------------------------------------------------------------


def high_bits(random: Random) -> Rings:
    """Coordinates with denominators of a hundred bits."""

    def shaken(x: mpq, y: mpq) -> tuple[mpq, mpq]:
        u, v = (mpq(random.getrandbits(90), random.getrandbits(100) | 2**99) for _ in range(2))
        return x + u, y - v

    return mapped(some_rings(random, simple_with_holes), shaken)


def far_away(random: Random) -> Rings:
    """Any other polygon moved by 10^30 + 1."""
    far = 10**30 + 1
    return mapped(some_rings(random, simple_with_holes), lambda x, y: (x + far, y - far))


def anisotropic(random: Random) -> Rings:
    """Any other polygon squeezed by up to 10^9 in one direction, or along a diagonal."""
    thin = mpq(1, 10 ** random.randrange(3, 10))
    rings = some_rings(random, random.choice((simple, simple_with_holes)))
    if random.randrange(2):
        return mapped(rings, lambda x, y: (x, y * thin))
    return mapped(rings, lambda x, y: (x + y * thin, x - y * thin))


# Nearly touching, nearly right, very small ----------------------------------------------


def outer_slit(random: Random) -> Rings:
    """Two tips that nearly touch across an exterior slit."""
    gap = mpq(1, 10 ** random.randrange(1, 12))
    aside = mpq(random.randrange(-20, 21), 10 ** random.randrange(1, 12))
    deep = random.randrange(2, 7)
    return [
        ring(
            [(0, 0), (12, 0), (8, 5 - gap), (deep, 3), (deep, 7)]
            + [(8 + aside, 5 + gap), (12, 10), (0, 10)]
        )
    ]


def folded_slit(random: Random) -> Rings:
    """An exterior slit with long walls that nearly touch, their vertices shifted."""
    gap = mpq(1, 10 ** random.randrange(1, 9))
    marks = sorted(random.sample(range(1, 40), 4))
    upper = [(mpq(x, 4), 5 + gap) for x in marks[::2]]
    lower = [(mpq(x, 4), 5 - gap) for x in marks[1::2]]
    return [
        ring(
            [(0, 0), (12, 0), (11, 5 - gap), *lower[::-1], *upper, (11, 5 + gap), (12, 10), (0, 10)]
        )
    ]


def inner_slit(random: Random) -> Rings:
    """Holes that nearly touch one another and the outer ring."""
    gap = mpq(1, 10 ** random.randrange(1, 6))
    tip = random.randrange(2, 9)
    first = [(gap, tip), (4, 2), (4, 8)]
    second = [(4 + gap, random.randrange(2, 9)), (8, 3), (9, 10 - gap)]
    return [ring([(0, 0), (10, 0), (10, 10), (0, 10)]), ring(first), ring(second)]


def comb(random: Random) -> Rings:
    """Needles side by side."""
    return [shapes.comb(random.randrange(4, 14), 10 ** random.randrange(1, 8))]


def nearly_right(random: Random) -> Rings:
    """Corners within 10^-12 of 90 degrees, on both sides of it, and a hole with such ones."""

    def off(size: int) -> mpq:
        return mpq(random.randrange(-9, 10), 10 ** random.randrange(3, 14)) * size

    corners = [(0, 0), (9, 0), (9, 7), (0, 7)]
    hole = [(3, 3), (3, 5), (6, 5), (6, 3)]
    kept = hole[: random.choice((3, 4, 4))]
    rings = [[(x + off(1), y + off(1)) for x, y in each] for each in (corners, kept)]
    return [ring(each) for each in rings[: random.choice((1, 2))]]


def tiny_holes(random: Random) -> Rings:
    """Many triangular holes far smaller than the outline."""
    size = mpq(1, 10 ** random.randrange(1, 5))
    rings = [ring([(0, 0), (40, 1), (41, 39), (-1, 40)])]
    for i in range(random.randrange(1, 12)):
        x, y = 5 + 10 * (i % 4) + random.randrange(4), 5 + 10 * (i // 4) + random.randrange(4)
        corners = [(0, 0), (random.randrange(1, 5), -1), (random.randrange(-2, 3), 2)]
        rings.append(ring([(x + u * size, y + v * size) for u, v in corners]))
    return rings


FAMILIES: dict[str, Family] = {
    family.__name__: family
    for family in (
        triangle,
        simple,
        simple_with_holes,
        star,
        maze,
        plate,
        spiral,
        rectilinear,
        octilinear,
        subdivided,
        special_frame,
        threshold,
        high_bits,
        far_away,
        anisotropic,
        outer_slit,
        folded_slit,
        inner_slit,
        comb,
        nearly_right,
        tiny_holes,
    )
}


def is_valid(rings: Rings) -> bool:
    """Are these the rings of a polygon?"""
    try:
        polygon_from_rings(rings)
    except InputError:
        return False
    return True


def attempts(random: Random, family: Family) -> Iterator[Rings]:
    """Rings of the family, for ever."""
    while True:
        yield family(random)


def some_rings(random: Random, family: Family) -> Rings:
    """Rings of the family that are a polygon."""
    return next(rings for rings in attempts(random, family) if is_valid(rings))


def some_polygon(kind: str, seed: int) -> Polygon:
    """The polygon of this family and seed."""
    random = Random(f"{kind} {seed}")
    return polygon_from_rings(some_rings(random, FAMILIES[kind]), f"{kind}-{seed}")
