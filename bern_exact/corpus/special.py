"""Special directions and angles: axis-parallel, diagonal, right, flat, symmetric, and nearly so."""

from __future__ import annotations

from functools import cmp_to_key
from random import Random

from gmpy2 import mpq

from bern_exact.corpus import over_the_grid, shapes
from bern_exact.corpus.draws import (
    Place,
    Ring,
    Rings,
    beside,
    between,
    moved,
    nth,
    pick,
    places,
    sign,
    until,
)
from bern_exact.corpus.family import Family, by_name
from bern_exact.corpus.random_polygons import random_ring, with_holes


def walls(random: Random, n: int) -> list[list[shapes.Point]]:
    """A maze whose walls are exactly axis-parallel, its corridors 1 wide and 1 apart."""
    rings = shapes.maze(n, random.randrange(10**9))
    return [[((x + 8) // 16, (y + 8) // 16) for x, y in ring] for ring in rings]


def rectilinear(random: Random, n: int) -> list[list[shapes.Point]]:
    """A maze whose walls are exactly axis-parallel, their distances random."""
    rings = walls(random, n)
    xs, ys = (_spread(random, {p[axis] for ring in rings for p in ring}) for axis in (0, 1))
    return [[(xs[x], ys[y]) for x, y in ring] for ring in rings]


def _spread(random: Random, marks: set[int]) -> dict[int, int]:
    """New places for coordinates, in the same order, 1 to 9 apart."""
    place, found = 0, {}
    for mark in sorted(marks):
        place += between(random, 1, 9)
        found[mark] = place
    return found


def octilinear(random: Random, n: int) -> Rings:
    """A rectilinear maze with every corner cut off at 45 degrees: 2 n vertices."""
    (ring,) = rectilinear(random, n)
    return cut_off(ring)


def cut_off(ring: list[shapes.Point]) -> Rings:
    """An axis-parallel ring of integer points, every corner cut off at 45 degrees."""
    cut: Ring = []
    for before, corner, after in zip(ring[-1:] + ring, ring, ring[1:] + ring[:1], strict=False):
        for end in (before, after):
            (x, y), (u, v) = corner, end
            cut.append((x + mpq((u > x) - (u < x), 4), y + mpq((v > y) - (v < y), 4)))
    return [cut]


TURNS = ((1, 1), (4, 3), (12, 5), (10**6, 1), (1, -(10**9)))
"""Integer directions that the axes are turned to: 45 degrees, Pythagorean, hardly turned."""


def turned(random: Random, n: int, turn: int) -> Rings:
    """A rectilinear maze turned to one of `TURNS`: every angle is right, no edge axis-parallel."""
    c, s = nth(TURNS, turn)
    return moved(rectilinear(random, n), lambda x, y: (c * x - s * y, s * x + c * y))


def near_right(random: Random, digits: int) -> Rings:
    """Corners about 90 degrees on both sides of it, up to 10^-digits, and a hole with such ones."""

    def off() -> mpq:
        return mpq(random.randrange(-9, 10), 10 ** random.randrange(3, digits + 1))

    corners = [(0, 0), (9, 0), (9, 7), (0, 7)]
    hole = [(3, 3), (3, 5), (6, 5), (6, 3)]
    kept = hole[: pick(random, (3, 4, 4))]
    rings: list[Ring] = [[(x + off(), y + off()) for x, y in each] for each in (corners, kept)]
    return rings[: pick(random, (1, 2))]


def near_flat(random: Random, n: int, digits: int) -> Rings:
    """A random ring with a vertex within 10^-digits of the middle of each edge, on either side."""
    size = 10**6

    def bent() -> Rings:
        (ring,) = random_ring(random, max(3, n // 2), 6)
        found: Ring = []
        for p, q in zip(ring, [*ring[1:], ring[0]], strict=True):
            aside = sign(random) * mpq(between(random, 1, 9), size * 10**digits)
            found += [p, beside(p, q, mpq(1, 2), aside)]
        return [found]

    return until(bent)


def subdivided(random: Random, n: int, holes: int) -> Rings:
    """A random ring, a maze or a star, with 180-degree vertices on its edges."""
    kind = random.randrange(3)
    if kind == 0:
        return subdivide(random, with_holes(random, n, holes))
    family = shapes.maze if kind == 1 else shapes.star
    return subdivide(random, family(n, random.randrange(10**9)))


def subdivide(random: Random, rings: Rings) -> list[Ring]:
    """180-degree vertices on a third of the edges, some very near to an end."""
    found: list[Ring] = []
    for ring in rings:
        finer: Ring = []
        for p, q in zip(ring, [*ring[1:], ring[0]], strict=True):
            finer.append(p)
            if random.randrange(3) == 0:
                finer.append(beside(p, q, mpq(1, pick(random, (2, 3, 7, 50))), 0))
        found.append(finer)
    return found


def flat_crowd(random: Random, n: int, digits: int) -> Rings:
    """A rectangle, its sides crowded with 180-degree vertices near to corners and to each other."""
    width, height = between(random, 1, 9), between(random, 1, 9)
    corners: Ring = [(0, 0), (width, 0), (width, height), (0, height)]
    parts: list[dict[mpq, None]] = [{} for _ in corners]
    for _ in range(n - 4):
        near = mpq(between(random, 1, 9), 10 ** between(random, 1, digits))
        parts[random.randrange(4)][pick(random, (near, 1 - near))] = None
    ring: Ring = []
    for p, q, found in zip(corners, corners[1:] + corners[:1], parts, strict=True):
        ring += [beside(p, q, t, 0) for t in (mpq(0), *sorted(found))]
    return [ring]


KOCH_HEIGHT = mpq(13, 45)
"""About sqrt(3)/6: the height of a tip on an edge of length 1, its base a third."""


def koch(random: Random, bumps: int) -> Rings:
    """A triangle on whose edges tips are put as on Koch's curve, at random, outward or inward."""

    def bumpy() -> Rings:
        ring: Ring = [(0, 0), (90, 0), (45, 78)]
        for _ in range(bumps):
            i = random.randrange(len(ring))
            ring[i + 1 : i + 1] = _tip(ring[i], ring[(i + 1) % len(ring)], sign(random))
        return [ring]

    return until(bumpy)


def _tip(p: Place, q: Place, side: int) -> Ring:
    """The three points between p and q, the tip on the left for 1."""
    heights = ((mpq(1, 3), mpq(0)), (mpq(1, 2), side * KOCH_HEIGHT), (mpq(2, 3), mpq(0)))
    return [beside(p, q, along, aside) for along, aside in heights]


def symmetric(random: Random, quarter: int) -> Rings:
    """A star of so many random points and their three turns by 90 degrees: ties for everything."""
    size = 10 ** between(random, 1, 3)
    found = [(between(random, 1, size), between(random, 0, size)) for _ in range(quarter)]
    found.sort(key=cmp_to_key(_compare_directions))
    ring: Ring = []
    for _ in range(4):
        ring += found
        found = [(-y, x) for x, y in found]
    return [ring]


def _compare_directions(u: tuple[int, int], v: tuple[int, int]) -> int:
    """Counter-clockwise from the x-axis, within the first quadrant; then by length."""
    area = v[0] * u[1] - u[0] * v[1]
    return area or u[0] + u[1] - v[0] - v[1]


def special_frame(random: Random) -> Rings:
    """Edges and vertices exactly on grid lines in the first frames that are tried."""
    return places(over_the_grid.special_in_first_frames(random))


def threshold(random: Random) -> Rings:
    """One vertex whose edges pass at about tau from grid points of its block."""
    return until(lambda: places(over_the_grid.aimed_at_grid_points(random)))


FAMILIES = (
    Family(
        "rectilinear",
        "general position: every edge is axis-parallel, so that a grid must be turned",
        ("rectilinear", "right-angles", "reflex"),
        {"n": (8, 24)},
        by_name(rectilinear),
    ),
    Family(
        "octilinear",
        "choosers of rows and columns that tie: axis-parallel and exactly diagonal edges alternate",
        ("axis-parallel", "diagonal", "reflex"),
        {"n": (6, 14)},
        by_name(octilinear),
    ),
    Family(
        "turned",
        "right angles that are not axis-parallel: a right angle must be seen as one wherever it "
        "lies, exactly diagonal or turned by a millionth",
        ("right-angles", "reflex"),
        {"n": (8, 20), "turn": (0, len(TURNS) - 1)},
        by_name(turned),
    ),
    Family(
        "near-right",
        "the line between acute and obtuse: corners within 10^-16 of 90 degrees on both sides",
        ("near-right",),
        {"digits": (4, 16)},
        by_name(near_right),
        raw=True,
    ),
    Family(
        "near-flat",
        "the line between reflex, flat and convex: vertices within 10^-18 of the middle of edges",
        ("near-flat",),
        {"n": (8, 16), "digits": (3, 12)},
        by_name(near_flat),
    ),
    Family(
        "subdivided",
        "180-degree vertices: dropped, merged or taken for reflex ones; some very near to a corner",
        ("flat-vertices",),
        {"n": (4, 9), "holes": (0, 2)},
        by_name(subdivided),
    ),
    Family(
        "flat-crowd",
        "a feature size that is attained along an edge: 180-degree vertices crowd on sides",
        ("convex", "flat-vertices", "axis-parallel"),
        {"n": (6, 10), "digits": (1, 4)},
        by_name(flat_crowd),
    ),
    Family(
        "koch",
        "self-similar outlines: 60-degree tips on tips, inward and outward, collinear feet",
        ("collinear",),
        {"bumps": (2, 6)},
        by_name(koch),
    ),
    Family(
        "symmetric",
        "the choice among equals: every distance, angle and width is attained four times",
        ("ties",),
        {"quarter": (2, 4)},
        by_name(symmetric),
    ),
    Family(
        "special-frame",
        "a grid that must avoid degenerate positions: edges and vertices lie exactly on the lines "
        "of the first grids that are tried",
        ("needs-rationals",),
        {},
        by_name(special_frame),
        raw=True,
    ),
    Family(
        "threshold",
        "snapping: a vertex whose edges pass grid points at just the distance that decides",
        ("needs-rationals",),
        {},
        by_name(threshold),
    ),
)
