"""Slender polygons: needles, combs, corridors, and walls that nearly touch across the exterior."""

from __future__ import annotations

from random import Random

from gmpy2 import mpq

from bern_exact.corpus import shapes, slits
from bern_exact.corpus.draws import Place, Ring, Rings, about, between, distinct, moved, sign
from bern_exact.corpus.family import Family, by_name
from bern_exact.corpus.random_polygons import with_holes


def spike(random: Random, digits: int) -> Rings:
    """A square with a spike as high as a number of so many digits, 2 wide."""
    return slits.spike(about(random, digits))


def bar(random: Random, digits: int) -> Rings:
    """A bar of 1 by 10^digits, its corners moved by up to a tenth."""

    def off() -> mpq:
        return mpq(random.randrange(-10, 11), 100)

    return moved(slits.bar(10**digits), lambda x, y: (x + off(), y + off()))


def needles(random: Random, n: int, digits: int) -> Rings:
    """About n/2 needles side by side, as long as a number of so many digits."""
    return [slits.needles(n, about(random, digits))]


def comb(random: Random, teeth: int, digits: int) -> Rings:
    """Rectangular teeth 1 wide, 1 apart and as long as a number of so many digits."""
    return slits.comb(teeth, about(random, digits))


def corridor(random: Random, n: int, digits: int) -> Rings:
    """A zigzag of n points and the same 10^-digits above it: a corridor of 2 n vertices."""
    chain: Ring = [(10 * i + random.randrange(9), random.randrange(30)) for i in range(n)]
    width = mpq(1, 10**digits)
    return [chain + [(x, y + width) for x, y in reversed(chain)]]


def outer_slit(random: Random, digits: int) -> Rings:
    """Two tips that nearly touch across an exterior slit, at 2 10^-digits or so."""
    gap = mpq(1, 10**digits)
    aside = mpq(random.randrange(-20, 21), 10 ** random.randrange(1, 12))
    deep = random.randrange(2, 7)
    ring: Ring = [(0, 0), (12, 0), (8, 5 - gap), (deep, 3), (deep, 7)]
    return [ring + [(8 + aside, 5 + gap), (12, 10), (0, 10)]]


def folded_slit(random: Random, digits: int) -> Rings:
    """An exterior slit with long walls that nearly touch, their vertices shifted."""
    gap = mpq(1, 10**digits)
    marks = sorted(i + 1 for i in distinct(random, 39, 4))
    upper: Ring = [(mpq(x, 4), 5 + gap) for x in marks[::2]]
    lower: Ring = [(mpq(x, 4), 5 - gap) for x in marks[1::2]]
    ring: Ring = [(0, 0), (12, 0), (11, 5 - gap), *lower[::-1], *upper]
    return [ring + [(11, 5 + gap), (12, 10), (0, 10)]]


def pocket(random: Random, digits: int) -> Rings:
    """A room outside that opens by a mouth of width 10^-digits: all but a hole."""
    mouth, top = mpq(1, 10**digits), random.randrange(12, 19)
    left, right = random.randrange(2, 5), random.randrange(7, 10)
    ring: Ring = [(0, 0), (12, 0), (12, 5), (right, 5), (right, random.randrange(1, 5))]
    ring += [(left, random.randrange(1, 5)), (left, 9), (right, random.randrange(7, 11))]
    return [ring + [(right, 5 + mouth), (12, 5 + mouth), (12, top), (0, top - 1)]]


def spiral_pocket(random: Random, windings: int, digits: int) -> Rings:
    """A square with a spiral slit of width 10^-digits or less: pockets that look like holes."""
    path = list(shapes.spiral_path(4 * windings + 1))
    half = mpq(between(random, 1, 9), 2 * 10 ** (digits + 1))
    side = 2 * windings + 2
    path[-1] = (side + random.randrange(3), path[-1][1])
    walls: tuple[Ring, Ring] = ([], [])
    for wall, way in zip(walls, (-1, 1), strict=True):
        for i, (x, y) in enumerate(path):
            ax, ay = shapes.STEPS[max(i - 1, 0) % 4]
            bx, by = shapes.STEPS[min(i, len(path) - 2) % 4]
            # The normals of the two parts that meet here, added where they differ.
            nx, ny = (-ay, ax) if (ax, ay) == (bx, by) else (-ay - by, ax + bx)
            wall.append((x + way * half * nx, y + way * half * ny))
    right, left = walls
    far = path[-1][0]
    square: Ring = [(far, side), (-side, side), (-side, -side), (far, -side)]
    return [square + right[::-1] + left]


def anisotropic(random: Random, n: int, holes: int, digits: int) -> Rings:
    """A random polygon squeezed to 10^-digits in one direction, or along a diagonal."""
    rings = with_holes(random, n, holes)
    return squeezed(rings, mpq(1, 10**digits), random.randrange(2) == 0)


def squeezed(rings: Rings, thin: mpq, along_diagonal: bool) -> list[Ring]:
    """The rings, thinner by this factor in y, or along a diagonal."""

    def squeeze(x: int | mpq, y: int | mpq) -> Place:
        return (x + y * thin, x - y * thin) if along_diagonal else (x, y * thin)

    return moved(rings, squeeze)


def broken_needle(random: Random, n: int, digits: int) -> Rings:
    """A needle 10^digits long whose long sides are bent in n - 2 places, both ways alternately."""
    length, gaps = 10**digits, n // 2
    ring: Ring = [(0, 0)]
    marks = [
        [(i + 1) * length // gaps + random.randrange(9) for i in range(gaps - 1)] for _ in "ab"
    ]
    ring += [(x, -9 + sign(random) * (i % 2)) for i, x in enumerate(marks[0])]
    ring += [(length, random.randrange(3))]
    return [ring + [(x, 9 + sign(random) * (i % 2)) for i, x in enumerate(marks[1])][::-1]]


FAMILIES = (
    Family(
        "bar",
        "meshers whose size grows with the aspect ratio: nearly a rectangle, up to 10^9 long",
        ("slender",),
        {"digits": (4, 9)},
        by_name(bar),
        raw=True,
    ),
    Family(
        "spike",
        "meshers that promise a least angle: the input has one below a thousandth itself",
        ("needle", "acute", "reflex"),
        {"digits": (4, 9)},
        by_name(spike),
    ),
    Family(
        "needles",
        "what happens at many tips: needles side by side, each with its own tiny angle",
        ("needle", "reflex"),
        {"n": (6, 14), "digits": (3, 8)},
        by_name(needles),
    ),
    Family(
        "comb",
        "sizes that grow with aspect ratio times vertices: long rectangular teeth, 1 wide, 1 apart",
        ("rectilinear", "right-angles", "reflex"),
        {"teeth": (2, 4), "digits": (1, 8)},
        by_name(comb),
    ),
    Family(
        "broken-needle",
        "angles next to 180 degrees on a shape without room: a needle with bent long sides",
        ("needle", "acute", "slender", "near-flat"),
        {"n": (8, 14), "digits": (5, 9)},
        by_name(broken_needle),
    ),
    Family(
        "corridor",
        "the distance between parallel walls: a zigzag corridor of width 10^-digits",
        ("thin", "uneven-edges"),
        {"n": (3, 7), "digits": (3, 12)},
        by_name(corridor),
    ),
    Family(
        "tips",
        "distances measured across the exterior: two tips nearly touch outside the polygon",
        ("reflex",),
        {"digits": (1, 12)},
        by_name(outer_slit),
    ),
    Family(
        "folded-slit",
        "distances measured across the exterior: the walls of a slit folded nearly shut must not "
        "see each other",
        ("reflex",),
        {"digits": (1, 9)},
        by_name(folded_slit),
    ),
    Family(
        "pocket",
        "taking a pocket for a hole: a room outside with a mouth of 10^-digits",
        ("reflex",),
        {"digits": (3, 12)},
        by_name(pocket),
    ),
    Family(
        "spiral-pocket",
        "taking pockets for holes: a slit in a spiral makes the outer ring look like nested ones",
        ("reflex",),
        {"windings": (1, 2), "digits": (1, 9)},
        by_name(spiral_pocket),
    ),
    Family(
        "anisotropic",
        "isotropic tolerances: everything squeezed by up to 10^9, along an axis or a diagonal",
        ("slender",),
        {"n": (5, 11), "holes": (0, 2), "digits": (4, 9)},
        by_name(anisotropic),
    ),
)
