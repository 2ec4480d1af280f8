"""Convex polygons by the family, for Theorem 4; each determined by its arguments.

All coordinates are exact: integers, or rationals where points lie on a circle exactly.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cmp_to_key
from random import Random

from gmpy2 import mpq, mpz, sign

from bern_exact.corpus.draws import beside, distinct, pick, shuffle
from bern_exact.corpus.shapes import SIZE

Rational = int | mpq
Place = tuple[Rational, Rational]
Rings = list[list[Place]]

TURNS = 10**6
"""Places round a circle that random points are drawn from."""


def circle_point(i: int, n: int) -> tuple[mpq, mpq]:
    """The i-th of n points about evenly spread round the unit circle, exactly on it.

    >>> circle_point(1, 8)
    (mpq(3,5), mpq(4,5))
    """
    quarter, along = divmod(4 * i, n)
    norm = n * n + along * along
    x, y = mpq(n * n - along * along, norm), mpq(2 * n * along, norm)
    for _ in range(quarter):
        x, y = -y, x
    return x, y


def hull(points: Sequence[Place]) -> list[Place]:
    """The corners of the convex hull, counter-clockwise from the leftmost."""
    ordered = sorted(set(points))
    return _half_hull(ordered)[:-1] + _half_hull(ordered[::-1])[:-1]


def _half_hull(ordered: Sequence[Place]) -> list[Place]:
    chain: list[Place] = []
    for p in ordered:
        while len(chain) > 1 and _turn(chain[-2], chain[-1], p) <= 0:
            chain.pop()
        chain.append(p)
    return chain


def _turn(p: Place, q: Place, r: Place) -> Rational:
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def random_hull(n: int, seed: int = 0) -> Rings:
    """The hull of n random points round a circle of radius 2^20, rounded: at most n vertices.

    Edges of very different lengths, in no order.
    """
    random = Random(seed)
    places = [circle_point(i, TURNS) for i in distinct(random, TURNS, n)]
    return [hull([(int(x * 2**20), int(y * 2**20)) for x, y in places])]


def regular(n: int, seed: int = 0) -> Rings:
    """n rational points exactly on the unit circle, nearly a regular n-gon; seed turns it.

    Meant to break the choice of the diameter: there are ties for it if n is even, and near-ties.
    """
    turn = circle_point(seed, 1001)
    points = [circle_point(i, n) for i in range(n)]
    return [[(x * turn[0] - y * turn[1], x * turn[1] + y * turn[0]) for x, y in points]]


def parabola(n: int, seed: int = 0) -> Rings:
    """n points (i, i^2), sheared by the seed: one-sided, the diameter being an edge."""
    return [[(i, i * i + seed * i) for i in range(n)]]


def arc(n: int, seed: int = 0) -> Rings:
    """n points of an arc of a circle, at most half of it: one-sided."""
    ring = [circle_point(i, 2 * (n - 1) + seed) for i in range(n)]
    return [list(ring)]


def ellipse(n: int, seed: int = 0, aspect: int = 1000) -> Rings:
    """n rational points on an ellipse `aspect` times as long as wide, turned by the seed."""
    (ring,) = regular(n)
    c, s = circle_point(seed, 1001)
    return [[(aspect * x * c - y * s, aspect * x * s + y * c) for x, y in ring]]


def tiny_edges(n: int, seed: int = 0) -> Rings:
    """Pairs of points round a circle, a millionth of its radius apart; n vertices, or n - 1 if odd.

    Meant to break whatever takes lengths for granted: edges of 1 and of 10^6 beside each other.
    """
    start = Random(seed).randrange(TURNS)
    pairs = max(2, n // 2)
    ring: list[Place] = []
    for i in range(pairs):
        at = start + i * TURNS // pairs
        ring += [circle_point(k % TURNS, TURNS) for k in (at, at + 1)]
    return [hull(ring)]


def clustered_spiral(n: int, seed: int = 0) -> Rings:
    """A parallelogram with n - 4 further vertices close together, whose paths wind slowly.

    The highest and lowest vertices are nearly above each other, so that each turn of a path goes
    outward by a hundredth only.  Meant for the bounds on bouncing: nearly as many half-steps
    as may be, 3.9 n verticals.
    """
    shift = 500 + seed % 400
    right, top = (10**5, 0), (shift, 10**4)
    found: list[Place] = [right, top, (-(10**5), 0), (-shift, -(10**4))]
    k = n - 4
    for i in range(1, k + 1):
        bend = mpq(i * (2 * k + 2 - i), 10**6 * (k + 1) ** 2)
        found.append(beside(top, right, mpq(i, 100 * (k + 1)), bend))
    return [hull(found)]


def occupied_spiral(n: int, seed: int = 0) -> Rings:
    """A parallelogram, a cluster of vertices where paths begin, and the others along their way.

    The paths of the cluster wind outward through triangles that hold a subdivision each.
    Meant to break orders of bouncing: if the farthest triangle is always treated first, each path
    of the cluster pushes all the others on, with several times the half-steps.
    """
    slope = mpq(1, 50 + seed % 20)
    ratio = (1 - slope) / (1 + slope)
    cluster = max(1, (n - 4) * 2 // 5)
    ends = {1: (mpq(1), mpq(0)), -1: (mpq(-1), mpq(0))}
    tops = {1: (slope, mpq(1, 5)), -1: (-slope, mpq(-1, 5))}
    along = [1 - (1 - ratio) * mpq(i + 1, 4 * (cluster + 1)) for i in range(cluster)]
    placed = [(1, t) for t in along]
    for j in range(n - 4 - cluster):
        placed.append((-1 if j % 2 == 0 else 1, ratio ** (j + 1) * (1 + ratio) / 2))
    found: list[Place] = [*ends.values(), *tops.values()]
    for side, part in placed:
        t = part * mpq(19, 20)
        found.append(beside(ends[side], tops[side], t, -t * (1 - t) / 10**7))
    return [hull([(int(10**18 * x), int(10**18 * y)) for x, y in found])]


def needle(n: int, seed: int = 0, aspect: int = 10**6) -> Rings:
    """An integer polygon about `aspect` times as long as wide: the hull of random points.

    Few of the n points are corners.
    """
    random = Random(seed)
    width = 1000
    length = width * aspect
    points = [(random.randrange(length), random.randrange(width)) for _ in range(n - 2)]
    return [hull([(0, random.randrange(width)), (length, random.randrange(width)), *points])]


def random_convex(n: int, seed: int = 0) -> Rings:
    """A random convex polygon after Valtr: random vectors of sum 0 in the order of their angles.

    n vertices; equal directions make 180-degree ones.
    """
    random = Random(seed)
    xs, ys = (_random_steps(n, random) for _ in range(2))
    shuffle(random, ys)
    ring: list[Place] = []
    x = y = 0
    for dx, dy in sorted(zip(xs, ys, strict=True), key=cmp_to_key(_compare_directions)):
        ring.append((x, y))
        x, y = x + dx, y + dy
    return [ring]


def _random_steps(n: int, random: Random) -> list[int]:
    """n integers other than 0 with the sum 0: the steps of two walks to the right, one turned."""
    marks = sorted(distinct(random, SIZE, n))
    steps, last = [], {1: marks[0], -1: marks[0]}
    for mark in marks[1:-1]:
        way = pick(random, (1, -1))
        steps.append(way * (mark - last[way]))
        last[way] = mark
    return [*steps, marks[-1] - last[1], last[-1] - marks[-1]]


def _compare_directions(u: tuple[int, int], v: tuple[int, int]) -> int:
    """-1, 0 or 1 in the order of directions counter-clockwise, upward ones first."""
    halves = (u[1] < 0) - (v[1] < 0)
    return halves or int(sign(mpz(v[0] * u[1] - u[0] * v[1])))


def subdivided(rings: Rings, parts: int = 2) -> Rings:
    """The same polygon with each edge in so many equal parts: 180-degree vertices."""
    (ring,) = rings
    fine: list[Place] = []
    for (px, py), (qx, qy) in zip(ring, ring[1:] + ring[:1], strict=True):
        for k in range(parts):
            t = mpq(k, parts)
            fine.append((px + t * (qx - px), py + t * (qy - py)))
    return [fine]


FAMILIES: Mapping[str, Callable[[int, int], Rings]] = {
    "random-hull": random_hull,
    "random-convex": random_convex,
    "regular": regular,
    "parabola": parabola,
    "arc": arc,
    "ellipse": ellipse,
    "tiny-edges": tiny_edges,
    "clustered-spiral": clustered_spiral,
    "occupied-spiral": occupied_spiral,
    "needle": needle,
}
"""Each family, of about n vertices from a seed."""
