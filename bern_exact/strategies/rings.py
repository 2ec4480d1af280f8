"""Rings of integer points, simple by construction: what strategies draw is turned into them."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cmp_to_key

from gmpy2 import gcd

Place = tuple[int, int]
Ring = list[Place]


def turn(p: Place, q: Place, r: Place) -> int:
    """Twice the signed area of three points."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def is_inside(p: Place, a: Place, b: Place) -> bool:
    """Does p lie inside the segment ab, not at an end?"""
    if turn(a, b, p) != 0:
        return False
    return (a[0] - p[0]) * (b[0] - p[0]) + (a[1] - p[1]) * (b[1] - p[1]) < 0


def cross(a: Place, b: Place, c: Place, d: Place) -> bool:
    """Do the segments ab and cd cross properly?"""
    at_c, at_d = turn(a, b, c), turn(a, b, d)
    if at_c == 0 or at_d == 0 or (at_c > 0) == (at_d > 0):
        return False
    at_a, at_b = turn(c, d, a), turn(c, d, b)
    return at_a != 0 and at_b != 0 and (at_a > 0) != (at_b > 0)


def are_on_a_line(points: Sequence[Place]) -> bool:
    """Are all these points on one line?  At least two, distinct."""
    return all(turn(points[0], points[1], p) == 0 for p in points)


def off_the_line(points: Sequence[Place], bound: int) -> Ring:
    """The points, the last one moved if all are on one line, within the bound on coordinates."""
    if not are_on_a_line(points):
        return list(points)
    (x, y), (u, _) = points[0], points[1]
    moved = (x, y + 1 if y < bound else y - 1) if x != u else (x + 1 if x < bound else x - 1, y)
    return [*points[:-1], moved]


def untangled(points: Sequence[Place]) -> Ring:
    """A simple ring through (nearly) all of these points, in this order if that is simple.

    Every step shortens the ring or drops a point, so that it ends; an order without crossings
    stays as it is, so that every simple ring can be the result.

    Parameters
    ----------
    points : sequence of (int, int)
        Distinct, not all on one line.

    Notes
    -----
    A point is dropped only where the ring runs straight through it while another edge does so
    too; what is left has the same convex hull.  Quadratic a pass, a few passes as a rule.

    Examples
    --------
    >>> untangled([(0, 0), (2, 2), (2, 0), (0, 2)])
    [(0, 0), (2, 0), (2, 2), (0, 2)]
    """
    ring = list(points)
    while _take_vertices_off_edges(ring) or _undo_crossings(ring):
        pass
    return ring


def _take_vertices_off_edges(ring: Ring) -> bool:
    """Put the first vertex inside another edge into that edge; was there any?"""
    n = len(ring)
    for k in range(n):
        v, before, after = ring[k], ring[k - 1], ring[(k + 1) % n]
        for m in range(n):
            if k in (m, (m + 1) % n) or not is_inside(v, ring[m], ring[(m + 1) % n]):
                continue
            del ring[k]
            if not is_inside(v, before, after):
                ring.insert(m + 1 if m < k else m, v)
            return True
    return False


def _undo_crossings(ring: Ring) -> bool:
    """Reverse the part between two edges that cross, wherever they do; was there any?"""
    n, found = len(ring), False
    for i in range(n - 2):
        for j in range(i + 2, n - (i == 0)):
            if cross(ring[i], ring[i + 1], ring[j], ring[(j + 1) % n]):
                ring[i + 1 : j + 1] = ring[i + 1 : j + 1][::-1]
                found = True
    return found


def without_flat(ring: Sequence[Place]) -> Ring:
    """A simple ring without its 180-degree vertices."""
    n = len(ring)
    return [p for i, p in enumerate(ring) if turn(ring[i - 1], p, ring[(i + 1) % n]) != 0]


def with_flat(ring: Sequence[Place], edge: int) -> Ring:
    """A ring with the first integer point of an edge as a vertex, if there is one."""
    (x, y), (u, v) = ring[edge], ring[(edge + 1) % len(ring)]
    steps = int(gcd(u - x, v - y))
    new = [(x + (u - x) // steps, y + (v - y) // steps)] if steps > 1 else []
    return [*ring[: edge + 1], *new, *ring[edge + 1 :]]


def convex_ring(steps: Sequence[Place]) -> Ring:
    """The convex ring whose edges have these directions, and one more that closes it.

    Parameters
    ----------
    steps : sequence of (int, int)
        No two in the same direction, not all on one line.

    Examples
    --------
    >>> convex_ring([(1, 0), (0, 1)])
    [(0, 0), (1, 0), (1, 1)]
    """
    closing = (-sum(x for x, _ in steps), -sum(y for _, y in steps))
    joined: Ring = []
    for step in sorted([*steps, closing], key=cmp_to_key(_compare_directions)):
        if step == (0, 0):
            continue
        if joined and _compare_directions(joined[-1], step) == 0:
            joined[-1] = joined[-1][0] + step[0], joined[-1][1] + step[1]
        else:
            joined.append(step)
    x, y = 0, 0
    ring = []
    for u, v in joined:
        ring.append((x, y))
        x, y = x + u, y + v
    left, low = min(x for x, _ in ring), min(y for _, y in ring)
    return [(x - left, y - low) for x, y in ring]


def _compare_directions(u: Place, v: Place) -> int:
    """-1, 0 or 1 as u comes before v counter-clockwise from east on, or has its direction."""
    lower = (u[1] < 0 or (u[1] == 0 and u[0] < 0)) - (v[1] < 0 or (v[1] == 0 and v[0] < 0))
    side = u[1] * v[0] - u[0] * v[1]
    return lower or (side > 0) - (side < 0)


def primitive(step: Place) -> Place:
    """The shortest integer vector in a direction."""
    length = int(gcd(step[0], step[1])) or 1
    return step[0] // length, step[1] // length
