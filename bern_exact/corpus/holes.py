"""Holes: a few, many, tiny, nearly touching one another or the outer ring, filling it."""

from __future__ import annotations

from random import Random

from gmpy2 import mpq

from bern_exact.corpus import shapes, slits
from bern_exact.corpus.draws import Place, Ring, Rings, about, between, until
from bern_exact.corpus.family import Family, by_name
from bern_exact.corpus.random_polygons import with_holes


def some_holes(random: Random, n: int, holes: int) -> Rings:
    """A random ring with just so many triangular holes."""
    return until(lambda: with_holes(random, n, holes), lambda rings: len(rings) == holes + 1)


def plate(random: Random, side: int) -> Rings:
    """A square with side x side turned square holes."""
    return shapes.plate(4 * side * side, random.randrange(10**9))


def tiny_holes(random: Random, digits: int, holes: int) -> Rings:
    """Triangular holes of size 10^-digits or so, four in a row."""
    size, rows = mpq(1, 10**digits), max(4, (holes + 3) // 4)
    top = 10 * rows
    rings: list[Ring] = [[(0, 0), (40, 1), (41, top - 1), (-1, top)]]
    for i in range(holes):
        x, y = 5 + 10 * (i % 4) + random.randrange(4), 5 + 10 * (i // 4) + random.randrange(4)
        corners = [(0, 0), (random.randrange(1, 5), -1), (random.randrange(-2, 3), 2)]
        rings.append([(x + u * size, y + v * size) for u, v in corners])
    return rings


def inner_slit(random: Random, digits: int) -> Rings:
    """Two holes whose tips are 10^-digits from one another and from the outer ring."""
    gap = mpq(1, 10**digits)
    tip = random.randrange(2, 9)
    first: Ring = [(gap, tip), (4, 2), (4, 8)]
    second: Ring = [(4 + gap, random.randrange(2, 9)), (8, 3), (9, 10 - gap)]
    return [[(0, 0), (10, 0), (10, 10), (0, 10)], first, second]


def chain(random: Random, holes: int, digits: int) -> Rings:
    """Holes in a row, tip to tip and from wall to wall, with gaps of 10^-digits: nearly a cut."""
    gap = mpq(1, 10**digits)
    rings: list[Ring] = [[(0, -9), (10 * holes, -9), (10 * holes, 9), (0, 9)]]
    tips: list[Place] = [(10 * i, between(random, -4, 4)) for i in range(holes + 1)]
    for (x, y), (u, v) in zip(tips, tips[1:], strict=False):
        middle = x + between(random, 3, 7)
        hole: Ring = [(x + gap, y), (middle, between(random, -8, -5))]
        rings.append([*hole, (u - gap, v), (middle, between(random, 5, 8))])
    return rings


def shell(random: Random, n: int, digits: int) -> Rings:
    """A star with a hole of the same shape, smaller by 10^-digits: a thin wall all round."""
    part = 1 - mpq(1, 10**digits)
    ring: Ring = []
    for i in range(n):
        x, y = shapes.on_circle(i, n, 1000)
        radius = between(random, 2, 9)
        ring.append((x * radius, y * radius))
    return [ring, [(x * part, y * part) for x, y in reversed(ring)]]


def slit(random: Random, digits: int) -> Rings:
    """A plate with two square holes, 1 apart and as long as a number of so many digits."""
    return slits.slit(about(random, digits))


FAMILIES = (
    Family(
        "holes",
        "holes that are forgotten or filled: a few triangles in a random outline, in both "
        "orientations",
        ("holes",),
        {"n": (5, 10), "holes": (1, 3)},
        by_name(some_holes),
    ),
    Family(
        "plate",
        "what is quadratic in the number of holes: turned squares in rows",
        ("holes", "right-angles"),
        {"side": (1, 2)},
        by_name(plate),
    ),
    Family(
        "tiny-holes",
        "holes lost among larger things: many that are up to 10^5 times smaller than the outline",
        ("holes",),
        {"digits": (1, 5), "holes": (2, 7)},
        by_name(tiny_holes),
    ),
    Family(
        "inner-slit",
        "rings merged by a tolerance: holes that nearly touch one another and the outer ring",
        ("holes",),
        {"digits": (1, 12)},
        by_name(inner_slit),
    ),
    Family(
        "chain-of-holes",
        "taking the inside for two parts: holes tip to tip from wall to wall, 10^-digits apart",
        ("holes",),
        {"holes": (1, 4), "digits": (2, 12)},
        by_name(chain),
    ),
    Family(
        "shell",
        "walls thinner than everything else: a hole of the outer ring's own shape, just smaller",
        ("holes", "thin"),
        {"n": (3, 7), "digits": (3, 9)},
        by_name(shell),
    ),
    Family(
        "slit",
        "sizes that grow with the length of a slit: two holes up to 10^9 long, 1 apart",
        ("holes", "rectilinear", "right-angles", "thin"),
        {"digits": (5, 9)},
        by_name(slit),
    ),
)
