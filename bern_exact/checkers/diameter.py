"""The frame of Section 5: the longest diagonal from (0, 0) to (1, 0), and the chains over it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from gmpy2 import lcm, mpq, mpz

from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.convex.records import LOWER, UPPER, Chain, ConvexFrame, Position

STAGE = "framed"
Place = tuple[mpz, mpz]
"""A point over the common denominator of all."""


def check_diameter(frame: ConvexFrame) -> list[Finding]:
    """Check the frame of a convex polygon.

    Parameters
    ----------
    frame : ConvexFrame
        The record.

    Notes
    -----
    All pairs of vertices are measured: quadratic, in integers.
    """
    places, chains, similarity = Violations(), Violations(), Violations()
    numbers = {"vertices": len(frame.polygon.points), "places": len(frame.places)}
    places.case(numbers["vertices"] == numbers["places"], numbers)
    points = frame.polygon.points
    for v, (p, place, quotient) in enumerate(
        zip(points, frame.places, _quotients(frame), strict=False)
    ):
        places.case(place == quotient, {"vertex": v})
        x, y, w = frame.similarity.apply(p)
        similarity.case(place == (mpq(x, w), mpq(y, w)), {"vertex": v})
        inside = 0 < place[0] < 1 or v in (frame.a, frame.b)
        places.case(inside, {"vertex": v, "x": place[0]})
    for side, ring in ((LOWER, _ring(frame, frame.a)), (UPPER, _ring(frame, frame.b)[::-1])):
        _look_at_chain(frame.chains[side], side, ring, chains)
    return [
        *_longest(frame),
        places.finding(
            "diameter.frame",
            STAGE,
            "each vertex p is at (p - A)/(B - A), A at 0, B at 1, all others strictly between",
        ),
        similarity.finding(
            "diameter.similarity",
            STAGE,
            "the similarity that will be undone takes each vertex to its place",
        ),
        chains.finding(
            "diameter.chains",
            STAGE,
            "the chains from A to B are the boundary, each monotone in x and concave",
        ),
    ]


def _longest(frame: ConvexFrame) -> Iterator[Finding]:
    """AB against all pairs, in the input's coordinates over one denominator."""
    points = frame.polygon.points
    scale = lcm(*(w for _, _, w in points)) if len(points) > 1 else points[0][2]
    whole = [(x * (scale // w), y * (scale // w)) for x, y, w in points]
    most, at, ties = mpz(0), (0, 0), list[tuple[Place, Place]]()
    for v, (x, y) in enumerate(whole):
        for w in range(v):
            u, z = whole[w]
            squared = (x - u) * (x - u) + (y - z) * (y - z)
            if squared > most:
                most, at, ties = squared, (w, v), []
            if squared == most:
                ties.append(_in_order((x, y), (u, z)))
    (ax, ay), (bx, by) = whole[frame.a], whole[frame.b]
    longest = Extreme(greatest=True)
    longest.offer(most, scale * scale, {"vertices": list(at)})
    longest.cases = len(whole) * (len(whole) - 1) // 2
    yield longest.finding(
        "diameter.longest",
        STAGE,
        "no two vertices are farther apart than A and B (squared)",
        mpq((bx - ax) ** 2 + (by - ay) ** 2, scale * scale),
    )
    first = Violations()
    first.case(((ax, ay), (bx, by)) == min(ties), {"A": frame.a, "B": frame.b})
    yield first.finding(
        "diameter.first",
        STAGE,
        "A comes before B, and they are the first of all pairs as far apart, by (x, y)",
    )


def _in_order(p: Place, q: Place) -> tuple[Place, Place]:
    """Two points by (x, y)."""
    return (p, q) if p < q else (q, p)


def _quotients(frame: ConvexFrame) -> Iterator[Position]:
    """(p - A)/(B - A) for every vertex p."""
    points = [(mpq(x, w), mpq(y, w)) for x, y, w in frame.polygon.points]
    (ax, ay), (bx, by) = points[frame.a], points[frame.b]
    dx, dy = bx - ax, by - ay
    squared = dx * dx + dy * dy
    for x, y in points:
        u, v = x - ax, y - ay
        yield (u * dx + v * dy) / squared, (v * dx - u * dy) / squared


def _ring(frame: ConvexFrame, start: int) -> Sequence[Position]:
    """The vertices from A or B counter-clockwise to the other."""
    end = frame.b if start == frame.a else frame.a
    (ring,) = frame.polygon.rings
    i, k = ring.index(start), ring.index(end)
    along = ring[i : k + 1] if i < k else ring[i:] + ring[: k + 1]
    return [frame.places[v] for v in along if v < len(frame.places)]


def _look_at_chain(chain: Chain, side: int, places: Sequence[Position], broken: Violations) -> None:
    """One chain against the boundary: increasing x, slopes that do not grow, no height below 0."""
    sign = 1 if side == UPPER else -1
    same = list(places) == [(x, sign * h) for x, h in zip(chain.xs, chain.hs, strict=False)]
    broken.case(same and len(chain.xs) == len(chain.hs), {"side": side})
    steps = [(q[0] - p[0], sign * (q[1] - p[1])) for p, q in pairwise(places)]
    for i, (dx, _) in enumerate(steps):
        broken.case(dx > 0 and sign * places[i][1] >= 0, {"side": side, "vertex": i})
    for i, ((dx, dy), (ex, ey)) in enumerate(pairwise(steps)):
        broken.case(dx * ey <= dy * ex, {"side": side, "vertex": i + 1})
