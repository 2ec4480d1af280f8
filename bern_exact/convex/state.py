"""The verticals and the pending subdivisions while paths are bounced."""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Sequence
from enum import IntEnum

from gmpy2 import mpq

from bern_exact.convex.chains import Sigma
from bern_exact.convex.records import (
    LOWER,
    UPPER,
    Bounced,
    ClosedPath,
    ConvexFrame,
    HalfStep,
    Pending,
)


class Zone(IntEnum):
    """Where a vertical is: left of both flats, right of both, or between."""

    LEFT = 0
    MIDDLE = 1
    RIGHT = 2


class State:
    """Verticals, pending subdivisions and what has been done, of one polygon.

    Parameters
    ----------
    frame : ConvexFrame
        P, its diameter no edge of it or one.

    Notes
    -----
    Everything is kept in sorted lists: O(log n) comparisons an operation.  Neighbouring pending
    subdivisions of a side share a triangle if no vertical lies between them.
    """

    def __init__(self, frame: ConvexFrame) -> None:
        self.frame = frame
        self.sigma = Sigma(frame.chains[UPPER]), Sigma(frame.chains[LOWER])
        upper, lower = self.sigma
        self.inner = min(upper.first, lower.first), max(upper.last, lower.last)
        self.verticals = sorted({x for x, _ in frame.places})
        self._is_vertical = set(self.verticals)
        self._pending: dict[tuple[Zone, int], list[mpq]] = {
            (zone, side): [] for zone in Zone for side in (UPPER, LOWER)
        }
        self._events: list[HalfStep | ClosedPath] = []
        self.first = self._subdivisions()
        for pending in self.first:
            insort(self.pending(self.zone(pending.x), pending.side), pending.x)

    def _subdivisions(self) -> tuple[Pending, ...]:
        """The ends of all horizontals that are not on a vertical at the boundary."""
        found = []
        for side, sigma in enumerate(self.sigma):
            partners = map(sigma.partner, self.verticals)
            found += sorted(
                Pending(x, side) for x in partners if x is not None and x not in self._is_vertical
            )
        return tuple(found)

    def zone(self, x: mpq) -> Zone:
        """Where x is."""
        if x < self.inner[0]:
            return Zone.LEFT
        return Zone.RIGHT if x > self.inner[1] else Zone.MIDDLE

    def pending(self, zone: Zone, side: int) -> list[mpq]:
        """The pending subdivisions of a side in a zone, increasing; not to be changed."""
        return self._pending[zone, side]

    def is_pending(self, x: mpq, side: int) -> bool:
        """Is there still this pending subdivision?"""
        return _position(self.pending(self.zone(x), side), x) is not None

    def share_a_triangle(self, p: mpq, q: mpq) -> bool:
        """Are these neighbouring pending subdivisions of one side with no vertical between them?"""
        return bisect_left(self.verticals, p) == bisect_left(self.verticals, q)

    def half_step(self, x: mpq, side: int, stays: mpq | None = None) -> Pending | None:
        """Bounce a pending subdivision; what the next horizontal leaves, if anything.

        The path closes if the vertical's other end is pending as well or has its partner among the
        verticals, and ends inside a flat top or bottom.
        """
        self._add_vertical(x)
        other = LOWER if side == UPPER else UPPER
        partner = self.sigma[other].partner(x)
        left = None
        if partner is not None and partner not in self._is_vertical:
            left = Pending(partner, other)
            insort(self.pending(self.zone(partner), other), partner)
        self._events.append(HalfStep(x, side, left, stays))
        return left

    def close(self, x: mpq, partner: mpq) -> None:
        """Add the closed path with these two verticals, x on B's side."""
        for vertical in (x, partner):
            if vertical not in self._is_vertical:
                self._add_vertical(vertical)
        self._events.append(ClosedPath(x, partner))

    def _add_vertical(self, x: mpq) -> None:
        """A new vertical; whatever was pending at its ends is no longer."""
        insort(self.verticals, x)
        self._is_vertical.add(x)
        for side in (UPPER, LOWER):
            waiting = self.pending(self.zone(x), side)
            i = _position(waiting, x)
            if i is not None:
                del waiting[i]

    def bounced(self) -> Bounced:
        """The record of what has been done."""
        return Bounced(self.frame, tuple(self.verticals), self.first, tuple(self._events))


def _position(increasing: Sequence[mpq], x: mpq) -> int | None:
    """Where x is, None if it is not there."""
    i = bisect_left(increasing, x)
    return i if i < len(increasing) and increasing[i] == x else None
