"""The function f of Section 5, its strips, and what the paper says of it."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from itertools import pairwise

from gmpy2 import mpq

from bern_exact.checkers.chords import Side, Turns
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.convex.records import ConvexFrame

STAGE = "bounced"


class Strips:
    """Where f(y) - y changes sign: at the chords that are as long above as below.

    Parameters
    ----------
    frame : ConvexFrame
        P.
    turns : Turns
        Its zones.
    """

    def __init__(self, frame: ConvexFrame, turns: Turns) -> None:
        self._turns = turns
        upper, lower = turns.sides
        inner = turns.inner[1]
        breaks = {inner}
        for side, chain in zip(turns.sides, frame.chains, strict=True):
            for x, h in zip(chain.xs, chain.hs, strict=True):
                breaks.add(max(inner, x, side.chord(h).right))
        ordered = sorted(breaks)
        lefts = [_left(upper, x) - _left(lower, x) for x in ordered]
        zeros = {x for x, value in zip(ordered, lefts, strict=True) if value == 0}
        for (x0, v0), (x1, v1) in pairwise(zip(ordered, lefts, strict=True)):
            if v0 * v1 < 0:
                zeros.add((x0 * v1 - x1 * v0) / (v1 - v0))
        self.right = sorted(zeros)
        self.left = sorted(_left(upper, x) for x in zeros)

    def same(self, x: mpq, other: mpq) -> bool:
        """Are two places of one zone in the same strip, neither on a path that closes?"""
        zeros = self.right if self._turns.zone(x) > 0 else self.left
        return bisect_left(zeros, x) == bisect_right(zeros, other) == bisect_right(zeros, x)


def _left(side: Side, x: mpq) -> mpq:
    """The left end of the chord that ends at x on the right."""
    return side.chord(side.height(x)).left


def check_f(frame: ConvexFrame) -> list[Finding]:
    """Check what Section 5 says of f, for both senses of motion.

    Parameters
    ----------
    frame : ConvexFrame
        P; if AB is an edge there is no f.

    Notes
    -----
    On each piece f is taken at both ends and at two points between, which must lie on a line.
    """
    continuous, monotone, pieces = Violations(), Violations(), Extreme(greatest=True)
    turns = Turns(frame)
    for ahead in (0, 1) if not frame.one_sided else ():
        a, b = turns.sides[ahead], turns.sides[1 - ahead]
        breaks = _breaks(turns, a, b)
        pieces.offer(len(breaks) - 1, 1, {"side": ahead})
        for x0, x1 in pairwise(breaks):
            f0, f1 = _f(a, b, x0), _f(a, b, x1)
            for k in (1, 2):
                expected = f0 + (f1 - f0) * k / 3
                value = _f(a, b, x0 + (x1 - x0) * k / 3)
                continuous.case(value == expected, {"side": ahead, "from": x0, "to": x1})
            monotone.case(f0 < f1, {"side": ahead, "from": x0, "to": x1})
    n = frame.polygon.n
    return [
        continuous.finding(
            "bounce.f-continuous", STAGE, "f is continuous, and linear between its breakpoints"
        ),
        monotone.finding("bounce.f-monotone", STAGE, "f is strictly monotone"),
        pieces.finding(
            "bounce.f-pieces",
            STAGE,
            "f has O(n) linear pieces, at most n + 2",
            n + 2,
        ),
    ]


def _f(ahead: Side, behind: Side, x: mpq) -> mpq:
    """One turn of a path pending at x on the right: to the left on one chain, back on the other."""
    return ahead.chord(ahead.height(_left(behind, x))).right


def _breaks(turns: Turns, ahead: Side, behind: Side) -> Sequence[mpq]:
    """The places on the right where f may bend, from where it begins to B.

    f has no value where the way leads into a flat: left of it only it begins.
    """
    start = turns.inner[1]
    if ahead.first < behind.first:
        start = max(start, behind.chord(behind.height(ahead.first)).right)
    found = {start, mpq(1)}
    for x in behind.xs:
        found.add(behind.chord(behind.height(x)).right)
    for x in ahead.xs:
        left = _left(ahead, x)
        if left < behind.first:
            found.add(behind.chord(behind.height(left)).right)
    return sorted(x for x in found if x >= start)
