"""Rings that are no polygon, in every way that the validation refuses."""

from __future__ import annotations

from random import Random

from gmpy2 import mpq

from bern_exact.corpus.draws import Number, Place, Ring, Rings, beside, between, moved, pick
from bern_exact.corpus.extreme import between_doubles
from bern_exact.corpus.family import Draw, Family, by_name
from bern_exact.corpus.random_polygons import with_holes
from bern_exact.exact.numbers import nearest_binary64


def plain(random: Random, n: int) -> list[Ring]:
    """A random polygon with at most one hole."""
    return with_holes(random, n, random.randrange(2))


def part(random: Random) -> mpq:
    """A part strictly between 0 and 1."""
    most = between(random, 2, 9)
    return mpq(between(random, 1, most - 1), most)


def beyond(rings: Rings) -> Number:
    """An abscissa to the right of everything."""
    return max(x for ring in rings for x, _ in ring) + 1


def too_few_vertices(random: Random, n: int) -> Rings:
    """An outer ring, or a hole, of two vertices or one; or no vertex at all."""
    (outer, *_) = plain(random, n)
    kept = outer[: random.randrange(3)]
    return [outer, kept or outer[:2]] if random.randrange(2) else [kept]


def repeated_vertex(random: Random, n: int) -> Rings:
    """A ring that is closed by its first vertex, or visits a vertex again somewhere."""
    rings = plain(random, n)
    ring = rings[random.randrange(len(rings))]
    if random.randrange(2):
        ring.append(ring[0])
    else:
        ring.insert(random.randrange(len(ring) + 1), pick(random, ring))
    return rings


def zero_area(random: Random, n: int) -> Rings:
    """An outer ring, or a hole, within a line that no axis is parallel to."""
    rings = plain(random, n)
    (px, py), (dx, dy) = rings[0][0], (between(random, 1, 9), between(random, 1, 9))
    ring: Ring = []
    for i in range(between(random, 3, 5)):
        t = i + part(random) / 2
        ring.append((px + t * dx, py + t * dy))
    return [ring] if random.randrange(2) else [rings[0], ring]


def edges_cross(random: Random, n: int) -> Rings:
    """A random polygon, two vertices of a ring exchanged, or a hole that sticks out."""
    rings = plain(random, n)
    ring = rings[0]
    if random.randrange(2):
        i, j = random.randrange(len(ring)), random.randrange(len(ring))
        ring[i], ring[j] = ring[j], ring[i]
        return rings
    corners = ((mpq(5, 8), mpq(-1, 16)), (mpq(5, 8), mpq(1, 16)), (mpq(1, 3), mpq(1, 99)))
    return [ring, [beside(ring[0], ring[1], along, aside) for along, aside in corners]]


def edges_touch(random: Random, n: int) -> Rings:
    """A hole with a vertex on an edge or a vertex of the outer ring, or a pinched outer ring."""
    rings = plain(random, n)
    ring = rings[0]
    i = random.randrange(len(ring))
    p, q = ring[i], ring[(i + 1) % len(ring)]
    way = random.randrange(3)
    if way == 0:
        ring.insert(random.randrange(len(ring)), beside(p, q, part(random), mpq(0)))
        return rings
    tip = p if way == 1 else beside(p, q, part(random), mpq(0))
    side = pick(random, (-1, 1)) * mpq(1, between(random, 9, 99))
    return [ring, [tip, *(beside(tip, q, mpq(t, 20), side) for t in (1, 2))]]


def edges_overlap(random: Random, n: int) -> Rings:
    """A hole with an edge along an edge of the outer ring."""
    (ring, *_) = plain(random, n)
    i = random.randrange(len(ring))
    p, q = ring[i], ring[(i + 1) % len(ring)]
    side = pick(random, (-1, 1)) * mpq(1, between(random, 9, 99))
    first, second = sorted((part(random) / 2, 1 - part(random) / 3))
    along = [beside(p, q, t, mpq(0)) for t in (first, second)]
    return [ring, [*along, beside(p, q, (first + second) / 2, side)]]


def spike(random: Random, n: int) -> Rings:
    """A ring that goes out to a point and comes back the same way, all of it or a part."""
    rings = plain(random, n)
    ring = rings[random.randrange(len(rings))]
    i = random.randrange(len(ring))
    p, q = ring[i], ring[(i + 1) % len(ring)]
    ring.insert(i + 2, beside(p, q, part(random), mpq(0)))
    return rings


def hole_outside(random: Random, n: int) -> Rings:
    """A hole beside the outer ring, around it, or close to one of its edges."""
    (ring, *_) = plain(random, n)
    far = beyond([ring])
    way = random.randrange(3)
    if way == 0:
        side = pick(random, (-1, 1)) * mpq(1, between(random, 9, 99))
        corners = ((mpq(2, 5), side), (mpq(3, 5), side), (mpq(1, 2), 2 * side))
        return [ring, [beside(ring[0], ring[1], along, aside) for along, aside in corners]]
    if way == 1:
        x, y = far, between(random, -9, 9)
        return [ring, [(x, y), (x + between(random, 1, 9), y), (x, y + 1)]]
    return [ring, [(-far, -far), (9 * far, -far), (-far, 9 * far)]]


def hole_in_hole(random: Random, n: int) -> Rings:
    """A hole within a hole, which comes before or after it."""
    rings = with_holes(random, n, 1)
    if len(rings) < 2:
        return rings
    outer, hole = rings
    (ax, ay), (bx, by), (cx, cy) = hole
    centre = ((ax + bx + cx) * mpq(1, 3), (ay + by + cy) * mpq(1, 3))
    size = part(random)
    inner = [beside(centre, p, size, mpq(0)) for p in hole]
    return [outer, inner, hole] if random.randrange(2) else [outer, hole, inner[::-1]]


def rounded(random: Random, n: int, bits: int) -> Rings:
    """A polygon that would be one, had its coordinates not been rounded to doubles."""

    def to_double(x: Number, y: Number) -> Place:
        return nearest_binary64(mpq(x)), nearest_binary64(mpq(y))

    return moved(between_doubles(random, n, 1, bits), to_double)


ROUNDED_ERRORS = (
    "repeated-vertex",
    "zero-area",
    "spike",
    "edges-cross",
    "edges-touch",
    "edges-overlap",
    "hole-outside",
    "hole-in-hole",
)


def _bad(kind: str, breaks: str, draw: Draw) -> Family:
    """A family of one kind of error."""
    return Family(f"bad-{kind}", breaks, ("bad",), {"n": (4, 9)}, draw, errors=(kind,))


FAMILIES = (
    _bad(
        "too-few-vertices",
        "readers that count on three vertices: rings of two, of one, of none",
        by_name(too_few_vertices),
    ),
    _bad(
        "repeated-vertex",
        "vertices merged in silence: a ring closed by its first vertex, or through a vertex twice",
        by_name(repeated_vertex),
    ),
    _bad(
        "zero-area",
        "divisions by an area: all vertices of a ring on a slanting line",
        by_name(zero_area),
    ),
    _bad(
        "edges-cross",
        "a missing or inexact simplicity test: two edges of one ring or of two rings cross",
        by_name(edges_cross),
    ),
    _bad(
        "edges-touch",
        "simplicity tests that look for crossings only: a vertex on an edge or on another ring's",
        by_name(edges_touch),
    ),
    _bad(
        "edges-overlap",
        "collinear edges taken for disjoint ones: a hole's edge along the outer ring",
        by_name(edges_overlap),
    ),
    _bad(
        "spike",
        "angles of 0 taken for 180 degrees: the boundary folds back on itself",
        by_name(spike),
    ),
    _bad(
        "hole-outside",
        "holes that are taken at their word: one beside the outer ring, close to it, or around it",
        by_name(hole_outside),
    ),
    _bad(
        "hole-in-hole",
        "even-odd rules: a hole within a hole is no island",
        by_name(hole_in_hole),
    ),
    Family(
        "bad-rounded",
        "rounding on the way in: a polygon no longer, for its coordinates were rounded to doubles",
        ("bad",),
        {"n": (5, 9), "bits": (52, 55)},
        by_name(rounded),
        errors=ROUNDED_ERRORS,
    ),
)
