"""A convex polygon's chains as the checkers see them: heights, chords and turns of a path."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from typing import NamedTuple

from gmpy2 import mpq, sign

from bern_exact.convex.records import Chain, ConvexFrame, Position


class Chord(NamedTuple):
    """The points of a chain at one height."""

    left: mpq
    right: mpq


class Side:
    """One chain: interpolated between its vertices, from A up to the flat and down to B.

    Parameters
    ----------
    chain : Chain
        Its coordinates alone are believed.
    """

    def __init__(self, chain: Chain) -> None:
        self._places: Sequence[Position] = tuple(zip(chain.xs, chain.hs, strict=True))
        self.xs = list(chain.xs)
        self.most = max(chain.hs)
        top = [i for i, h in enumerate(chain.hs) if h == self.most]
        self.first, self.last = chain.xs[top[0]], chain.xs[top[-1]]
        self._up = self._places[: top[0] + 1]
        self._down = self._places[: top[-1] - 1 : -1]

    def height(self, x: mpq) -> mpq:
        """The distance from AB at x."""
        i = min(max(bisect_right(self.xs, x), 1), len(self.xs) - 1)
        (x0, h0), (x1, h1) = self._places[i - 1], self._places[i]
        return h0 + (h1 - h0) * (x - x0) / (x1 - x0)

    def chord(self, height: mpq) -> Chord:
        """The leftmost and the rightmost point of this height, at most the chain's own."""
        return Chord(_reach(self._up, height), _reach(self._down, height))

    def across(self, x: mpq) -> mpq | None:
        """The other end of the chord at x; None inside a flat, where the chord is longer."""
        if self.first < x < self.last or self.most == 0:
            return None
        left, right = self.chord(self.height(x))
        return right if x == left else left


def _reach(monotone: Sequence[Position], height: mpq) -> mpq:
    """Where a part that only rises has this height first."""
    i = bisect_left(monotone, height, key=lambda place: place[1])
    x1, h1 = monotone[i]
    if h1 == height:
        return x1
    x0, h0 = monotone[i - 1]
    return x0 + (x1 - x0) * (height - h0) / (h1 - h0)


class Turns:
    """Zones and senses of motion between the two chains.

    Parameters
    ----------
    frame : ConvexFrame
        P.
    """

    def __init__(self, frame: ConvexFrame) -> None:
        self.sides = Side(frame.chains[0]), Side(frame.chains[1])
        upper, lower = self.sides
        self.inner = min(upper.first, lower.first), max(upper.last, lower.last)

    def zone(self, x: mpq) -> int:
        """-1 left of both flats, 1 right of both, else 0: the middle."""
        return -1 if x < self.inner[0] else int(x > self.inner[1])

    def outward(self, x: mpq, side: int) -> int:
        """The sign of f(y) - y for a path pending at x: 1 if it winds outward, 0 if it closes."""
        ahead = self.sides[side if self.zone(x) > 0 else 1 - side]
        behind = self.sides[1 - side if self.zone(x) > 0 else side]
        a, b = ahead.across(x), behind.across(x)
        return 0 if a is None or b is None else int(sign(a - b))

    def next(self, x: mpq, side: int) -> mpq | None:
        """Where a path pending at (x, side) is pending next, on the other side."""
        return self.sides[1 - side].across(x)

    def turn(self, x: mpq, side: int) -> mpq | None:
        """f: where a path pending at (x, side) is back on this side, None if it is not so soon."""
        half = self.next(x, side)
        if half is None or self.zone(half) != -self.zone(x):
            return None
        whole = self.next(half, 1 - side)
        return whole if whole is not None and self.zone(whole) == self.zone(x) else None
