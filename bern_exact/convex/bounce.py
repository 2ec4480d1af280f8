"""Bouncing paths until no triangle along the boundary has two subdivisions (Section 5).

The paper's order is repaired in three places.  Paths that turn in the middle are bounced there at
once, whenever they come; those of the sense that may turn go first.  Of the triangles with several
subdivisions the one that comes first in the direction of motion is treated first, so that no later
path can reach a subdivision that has been left alone.  Closed paths are added only where they
part two subdivisions of one triangle.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from heapq import heapify, heappop, heappush

from gmpy2 import mpq, sign

from bern_exact.convex.chains import Sigma
from bern_exact.convex.records import LOWER, UPPER, Bounced, ConvexFrame, Pending
from bern_exact.convex.state import State, Zone


def bounce(frame: ConvexFrame) -> Bounced:
    """Draw verticals through the vertices and bounce subdivisions until all are alone.

    Section 5: "Our goal is to bounce paths until each triangle has at most one subdivision point."

    Parameters
    ----------
    frame : ConvexFrame
        P in its frame.

    Notes
    -----
    At most as many half-steps outside the middle as there are subdivisions at first, and at most
    two in the middle a path, so that with the closed paths there are at most 9 n verticals.
    O(n log n) half-steps, comparisons and bisections.
    """
    state = State(frame)
    if frame.one_sided:
        _bounce_one_sided(state)
        return state.bounced()
    for side in (UPPER, LOWER):
        for x in tuple(state.pending(Zone.MIDDLE, side)):
            # A path through the middle may have closed at another's vertical.
            if state.is_pending(x, side):
                _through_middle(state, Pending(x, side))
    turning, steady = _senses(state)
    closed = _closed_paths(state)
    for side in (turning, steady):
        _Turn(state, side, closed).run()
    return state.bounced()


def _bounce_one_sided(state: State) -> None:
    """If AB is an edge every path ends at once: each second subdivision of a triangle is bounced.

    Section 5: "We assume that the longest diagonal is not part of the boundary; otherwise our
    construction can be somewhat simplified."
    """
    for side in (UPPER, LOWER):
        waiting = [x for zone in Zone for x in state.pending(zone, side)]
        alone: mpq | None = None
        for x in waiting:
            if alone is not None and state.share_a_triangle(alone, x):
                state.half_step(x, side, alone)
                alone = None
            else:
                alone = x


def _senses(state: State) -> tuple[int, int]:
    """The sides of the two senses of motion, named by the side on which a path is right.

    With the upper flat farther right than the lower, paths that come back to the upper right
    are clockwise and never turn; the others may meet the middle and turn.
    """
    upper, lower = state.sigma
    if upper.first + upper.last >= lower.first + lower.last:
        return LOWER, UPPER
    return UPPER, LOWER


def _through_middle(state: State, pending: Pending | None) -> Pending | None:
    """Bounce on while the path is in the middle; what is left pending outside, if anything."""
    while pending is not None and state.zone(pending.x) == Zone.MIDDLE:
        pending = state.half_step(*pending)
    return pending


def _closed_paths(state: State) -> list[mpq]:
    """The right verticals of closed paths: where both sides have the same partner.

    "We extend the partition by bouncing paths at the O(n) heights at which f(y) - y changes sign":
    a path from (x, upper) returns to it exactly if sigma_upper(x) = sigma_lower(x).  The
    difference is linear between the vertices on the right and the partners of those on the left.
    Of an interval of zeros only the ends are listed.
    """
    inner = state.inner[1]
    breaks = {inner, mpq(1)}
    for sigma in state.sigma:
        for x in sigma.chain.xs:
            breaks.add(max(inner, x, sigma.across(x)))
    ordered = sorted(breaks)
    values = [_difference(*state.sigma, x) for x in ordered]
    found = [x for x, value in zip(ordered, values, strict=True) if value == 0]
    for i in range(1, len(ordered)):
        u, v = values[i - 1], values[i]
        if u * v < 0:
            found.append(ordered[i - 1] + (ordered[i] - ordered[i - 1]) * u / (u - v))
    return sorted(found)


def _difference(first: Sigma, second: Sigma, x: mpq) -> mpq:
    """sigma_first(x) - sigma_second(x) for x in the right or left zone, or at its inner end."""
    return first.across(x) - second.across(x)


class _Turn:
    """All bounces of one sense of motion.

    A path of this sense is pending on the right on `ahead` and on the left on the other side.
    It moves outward, away from the middle, at x if sigma_ahead(x) is greater than sigma_behind(x),
    in both zones; inward if it is less.

    Parameters
    ----------
    state : State
        Nothing pending in the middle.
    ahead : int
        The side on which paths of this sense are pending on the right.
    closed : sequence of mpq
        The right verticals of all closed paths, increasing.
    """

    def __init__(self, state: State, ahead: int, closed: Sequence[mpq]) -> None:
        self._state = state
        behind = LOWER if ahead == UPPER else UPPER
        self._side = {Zone.RIGHT: ahead, Zone.LEFT: behind}
        self._ahead, self._behind = state.sigma[ahead], state.sigma[behind]
        # Partners run the other way.
        left = [self._ahead.across(x) for x in reversed(closed)]
        self._closed = {Zone.RIGHT: closed, Zone.LEFT: left}
        self._conflicts: list[tuple[int, mpq, Zone, mpq, mpq]] = []

    def run(self) -> None:
        """Bounce until no triangle has two pending subdivisions of this sense."""
        for zone, side in self._side.items():
            waiting = self._state.pending(zone, side)
            for p, q in zip(waiting, waiting[1:], strict=False):
                self._note(zone, p, q)
        heapify(self._conflicts)
        while self._conflicts:
            _, _, zone, p, q = heappop(self._conflicts)
            if self._is_conflict(zone, p, q):
                self._settle(zone, p, q)

    def _note(self, zone: Zone, p: mpq, q: mpq) -> None:
        """Remember two neighbouring pending subdivisions, if they share a triangle.

        First come those to be parted by a closed path, then the others in the direction of
        motion: by the place where the farther one is on the right, or would come to be next.
        """
        if not self._state.share_a_triangle(p, q):
            return
        if self._parting(zone, p, q) is not None:
            heappush(self._conflicts, (0, mpq(0), zone, p, q))
            return
        place = self._farther(zone, p, q)
        if zone == Zone.LEFT:
            place = self._ahead.across(place)
        heappush(self._conflicts, (1, self._direction(p) * place, zone, p, q))

    def _is_conflict(self, zone: Zone, p: mpq, q: mpq) -> bool:
        """Are these still neighbouring pending subdivisions of one triangle?"""
        waiting = self._state.pending(zone, self._side[zone])
        i = bisect_left(waiting, p)
        return waiting[i : i + 2] == [p, q] and self._state.share_a_triangle(p, q)

    def _settle(self, zone: Zone, p: mpq, q: mpq) -> None:
        """Make a conflict one less: by a closed path, or by bouncing the farther one."""
        closed = self._parting(zone, p, q)
        if closed is not None:
            left, right = sorted((closed, self._ahead.across(closed)))
            self._state.close(right, left)
            return
        farther = self._farther(zone, p, q)
        stays = p if farther == q else q
        new = self._state.half_step(farther, self._side[zone], stays)
        new = _through_middle(self._state, new)
        if new is not None and self._side[self._state.zone(new.x)] == new.side:
            self._arrive(new)

    def _arrive(self, new: Pending) -> None:
        """A new pending subdivision may share its triangle with its neighbours."""
        zone = self._state.zone(new.x)
        waiting = self._state.pending(zone, new.side)
        i = bisect_left(waiting, new.x)
        for j in (i - 1, i):
            if 0 <= j < len(waiting) - 1:
                self._note(zone, waiting[j], waiting[j + 1])

    def _parting(self, zone: Zone, p: mpq, q: mpq) -> mpq | None:
        """A vertical in [p, q] whose path closes, if there is one: at p, at q or between them."""
        for x in (p, q):
            if self._direction(x) == 0:
                return x
        closed = self._closed[zone]
        i = bisect_right(closed, p)
        return closed[i] if i < len(closed) and closed[i] < q else None

    def _direction(self, x: mpq) -> int:
        """1 if a path of this sense at x moves outward, -1 if inward, 0 if it closes."""
        return int(sign(_difference(self._ahead, self._behind, x)))

    def _farther(self, zone: Zone, p: mpq, q: mpq) -> mpq:
        """Of p < q the one that is farther along; outward is right on the right."""
        outward = self._direction(p) > 0
        return q if outward == (zone == Zone.RIGHT) else p
