"""Extreme coordinates: huge, tiny, far away, of many bits, beyond doubles and between them."""

from __future__ import annotations

from random import Random

from gmpy2 import mpq

from bern_exact.corpus.draws import Number, Place, Ring, Rings, moved, until
from bern_exact.corpus.family import Family, by_name
from bern_exact.corpus.random_polygons import random_ring, with_holes


def huge(random: Random, n: int, digits: int) -> Rings:
    """A random ring whose coordinates have so many digits."""
    return random_ring(random, n, digits)


def tiny(random: Random, n: int, holes: int, digits: int) -> Rings:
    """A random polygon of size 10^-digits."""
    return scaled(with_holes(random, n, holes), mpq(1, 10**digits))


def scaled(rings: Rings, factor: Number) -> list[Ring]:
    """The rings, larger by a factor."""
    return moved(rings, lambda x, y: (x * factor, y * factor))


def far_away(random: Random, n: int, holes: int, digits: int) -> Rings:
    """A random polygon moved by 10^digits + 1 to the right and down."""
    far = 10**digits + 1
    return moved(with_holes(random, n, holes), lambda x, y: (x + far, y - far))


def high_bits(random: Random, n: int, holes: int, bits: int) -> Rings:
    """A random polygon, each coordinate with a denominator of so many bits."""

    def draw() -> Rings:
        return shaken(random, with_holes(random, n, holes), bits)

    return until(draw)


def shaken(random: Random, rings: Rings, bits: int) -> list[Ring]:
    """Every coordinate moved by up to 2^-9, to a denominator of so many bits."""

    def shake(x: Number, y: Number) -> Place:
        u, v = (
            mpq(random.getrandbits(bits - 10), random.getrandbits(bits) | 1 << (bits - 1))
            for _ in range(2)
        )
        return x + u, y - v

    return moved(rings, shake)


def odd_fractions(random: Random, n: int, most: int) -> Rings:
    """Coordinates with small denominators, all different: no common grid, as 1/3, 2/7, 5/11."""

    def draw() -> Rings:
        rings = random_ring(random, n, 1)
        return moved(
            rings,
            lambda x, y: (
                x + mpq(random.randrange(1, most), 2 * random.randrange(1, most) + 1),
                y + mpq(random.randrange(1, most), 2 * random.randrange(1, most) + 1),
            ),
        )

    return until(draw)


def beyond_doubles(random: Random, n: int, holes: int, digits: int, down: int) -> Rings:
    """A random polygon of size 10^digits, or 10^-digits: doubles overflow, or are all zero."""
    factor = mpq(1, 10**digits) if down else 10**digits
    return scaled(with_holes(random, n, holes), factor)


def between_doubles(random: Random, n: int, holes: int, bits: int) -> Rings:
    """A random polygon of size 2^-bits at (1, -1): its vertices round to the same few doubles."""
    unit = mpq(1, 2**bits)
    return moved(with_holes(random, n, holes), lambda x, y: (1 + x * unit, y * unit - 1))


FAMILIES = (
    Family(
        "huge",
        "integers that no double holds: coordinates of up to 60 digits",
        ("huge", "needs-rationals"),
        {"n": (5, 14), "digits": (20, 60)},
        by_name(huge),
    ),
    Family(
        "tiny",
        "absolute tolerances: the whole polygon is smaller than any epsilon",
        ("tiny", "needs-rationals"),
        {"n": (5, 11), "holes": (0, 2), "digits": (12, 40)},
        by_name(tiny),
    ),
    Family(
        "far-away",
        "cancellation: an ordinary polygon moved by 10^20 to 10^40, where doubles see one point",
        ("far-away", "huge", "needs-rationals", "rounds-to-invalid"),
        {"n": (5, 11), "holes": (0, 2), "digits": (20, 40)},
        by_name(far_away),
    ),
    Family(
        "high-bits",
        "short numbers: denominators of up to 200 bits, all different",
        ("many-digits", "needs-rationals"),
        {"n": (5, 10), "holes": (0, 1), "bits": (80, 200)},
        by_name(high_bits),
    ),
    Family(
        "odd-fractions",
        "a common denominator: small fractions such as 1/3, 2/7 and 5/11, each another",
        ("needs-rationals",),
        {"n": (5, 12), "most": (6, 30)},
        by_name(odd_fractions),
    ),
    Family(
        "beyond-doubles",
        "the range of doubles: sizes of 10^330 and more, which overflow, or 10^-330, which vanish",
        ("beyond-doubles", "needs-rationals"),
        {"n": (4, 9), "holes": (0, 1), "digits": (330, 360), "down": (0, 1)},
        by_name(beyond_doubles),
    ),
    Family(
        "between-doubles",
        "the resolution of doubles: rounded to them the vertices merge and the rings collapse",
        ("needs-rationals", "rounds-to-invalid", "tiny"),
        {"n": (5, 11), "holes": (0, 2), "bits": (58, 70)},
        by_name(between_doubles),
    ),
)
