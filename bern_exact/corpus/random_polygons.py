"""Random simple polygons: untangled, grown edge by edge, star-shaped, mazes, spirals."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random

from gmpy2 import mpq

from bern_exact.corpus import shapes
from bern_exact.corpus.draws import Place, Ring, Rings, between, is_polygon, until
from bern_exact.corpus.family import Family, by_name, by_seed
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.exact.predicates import orientation
from bern_exact.theorems.stages import RefusedOption

Point = tuple[int, int]


def triangle(random: Random, digits: int) -> Rings:
    """Three points, often far from equilateral."""
    size = 10**digits
    return [[(random.randrange(size), random.randrange(10)) for _ in range(3)]]


def untangled(random: Random, n: int, size: int) -> list[Point]:
    """A random ring of n different points of a size x size grid, crossings undone by reversals.

    Points may be on one line; the ring may then touch itself (the caller validates it).
    Each reversal makes the ring shorter, so that it ends.

    Raises
    ------
    RefusedOption
        If the grid has not so many points.
    """
    if n > size * size:
        raise RefusedOption(f"a grid of {size} x {size} has no {n:,} points")
    chosen: dict[Point, None] = {}
    while len(chosen) < n:
        chosen[(random.randrange(size), random.randrange(size))] = None
    ring = list(chosen)
    done = False
    while not done:
        done = True
        for i in range(n - 1):
            for j in range(i + 2, n):
                if _cross(ring[i], ring[i + 1], ring[j], ring[(j + 1) % n]):
                    ring[i + 1 : j + 1] = ring[i + 1 : j + 1][::-1]
                    done = False
    return ring


def _cross(a: Point, b: Point, c: Point, d: Point) -> bool:
    """Do two segments cross, neither touching the other with an end?"""
    return _turn(a, b, c) * _turn(a, b, d) < 0 and _turn(c, d, a) * _turn(c, d, b) < 0


def _turn(p: Point, q: Point, r: Point) -> int:
    """1 for a left turn, -1 for a right one, 0 on a line."""
    area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    return (area > 0) - (area < 0)


def random_ring(random: Random, n: int, digits: int) -> Rings:
    """A random simple ring of n points with so many digits: hardly two edges are special."""
    return [untangled(random, n, 10**digits)]


def random_grid(random: Random, n: int, size: int) -> Rings:
    """A random simple ring on a small grid: collinear runs, axis-parallel and 45-degree edges."""
    return [untangled(random, n, size)]


def with_holes(random: Random, n: int, holes: int) -> list[Ring]:
    """A random simple ring on a small grid with up to so many triangular holes, where they fit."""

    def outline() -> Rings:
        return [untangled(random, n, n + 2)]

    outer = [list(ring) for ring in until(outline)]
    return add_holes(random, outer, n + 2, 16 * holes, holes)


def add_holes(
    random: Random, rings: Sequence[Ring], size: int, tries: int, most: int
) -> list[Ring]:
    """The rings and triangular holes, on a grid of quarters, that are found to fit."""
    found = list(rings)
    for _ in range(tries):
        if len(found) > most:
            break
        x, y = random.randrange(4 * size), random.randrange(4 * size)
        hole: Ring = [
            (mpq(x + random.randrange(-4, 5), 4), mpq(y + random.randrange(-4, 5), 4))
            for _ in range(3)
        ]
        if is_polygon([*found, hole]):
            found.append(hole)
    return found


def grown(random: Random, n: int, digits: int) -> Rings:
    """A triangle that grows by a triangle on an edge, or is cut by one, at random lengths.

    Half of the steps go on where the last one was: long arms and winding pockets.
    """
    size = 10**digits
    ring: list[HPoint] = [hpoint(0, 0), hpoint(size, 0), hpoint(random.randrange(size), size)]
    newest = 2
    while len(ring) < n:
        edge = newest - random.randrange(2) if random.randrange(2) else random.randrange(len(ring))
        edge %= len(ring)
        p = _near(random, ring[edge], ring[(edge + 1) % len(ring)], digits)
        if _can_be_inserted(ring, edge, p):
            ring.insert(edge + 1, p)
            newest = edge + 1
    return [[(int(x), int(y)) for x, y, _ in ring]]


def _near(random: Random, a: HPoint, b: HPoint, digits: int) -> HPoint:
    """A point about an edge, at a distance of any order of magnitude."""
    reach = 10 ** between(random, 1, digits + 1)
    part = random.randrange(101)
    x = (a[0] * (100 - part) + b[0] * part) // 100 + between(random, -reach, reach)
    y = (a[1] * (100 - part) + b[1] * part) // 100 + between(random, -reach, reach)
    return hpoint(int(x), int(y))


def _can_be_inserted(ring: Sequence[HPoint], edge: int, p: HPoint) -> bool:
    """Is the ring still simple if the edge goes by way of p?"""
    size = len(ring)
    a, b = ring[edge], ring[(edge + 1) % size]
    if orientation(a, b, p) == 0:
        return False
    for i in range(size):
        if i == edge:
            continue
        c, d = ring[i], ring[(i + 1) % size]
        for end in (a, b):
            if _meet(end, p, c, d):
                return False
    return True


def _meet(a: HPoint, p: HPoint, c: HPoint, d: HPoint) -> bool:
    """Have the segments ap and cd a common point other than a common end a?"""
    sides = orientation(a, p, c), orientation(a, p, d), orientation(c, d, a), orientation(c, d, p)
    if a in (c, d):
        # On one line they overlap, unless they leave a on different sides; p on cd is refused too.
        return sides[3] == 0
    return sides[0] * sides[1] <= 0 and sides[2] * sides[3] <= 0


def exponential_star(random: Random, n: int, digits: int) -> Rings:
    """A star whose tips are at distances of 1 to 10^digits, in every order of magnitude."""
    ring: list[Place] = []
    for i in range(n):
        x, y = shapes.on_circle(i, n, 1000)
        length = 10 ** between(random, 0, digits) * between(random, 1, 9)
        ring.append((x * length, y * length))
    return [ring]


FAMILIES = (
    Family(
        "triangle",
        "code that needs more than three vertices: acute or very obtuse triangles",
        (),
        {"digits": (1, 6)},
        by_name(triangle),
        raw=True,
    ),
    Family(
        "random",
        "whatever holds for nice polygons only: a random ring in general position",
        (),
        {"n": (4, 14), "digits": (3, 9)},
        by_name(random_ring),
    ),
    Family(
        "random-grid",
        "predicates that cannot be zero: vertices on lines of others, equal coordinates, "
        "axis-parallel and diagonal edges all over a small grid",
        (),
        {"n": (4, 14), "size": (5, 12)},
        by_name(random_grid),
    ),
    Family(
        "grown",
        "sampling that favours tame shapes: long arms and winding pockets at every scale",
        (),
        {"n": (6, 16), "digits": (2, 6)},
        by_name(grown),
    ),
    Family(
        "star",
        "meshers whose size grows with the aspect ratio: long thin spikes side by side",
        (),
        {"n": (4, 16)},
        by_seed(shapes.star),
    ),
    Family(
        "exponential-star",
        "tolerances taken from the size of the input: features of every order of magnitude",
        (),
        {"n": (5, 12), "digits": (2, 12)},
        by_name(exponential_star),
    ),
    Family(
        "maze",
        "whatever expects a polygon to be round: the inside winds everywhere",
        ("reflex",),
        {"n": (8, 20)},
        by_seed(shapes.maze),
    ),
    Family(
        "spiral",
        "whatever takes nearness in the plane for nearness inside: a corridor wound up",
        ("reflex",),
        {"n": (10, 22)},
        by_seed(shapes.spiral),
    ),
)
