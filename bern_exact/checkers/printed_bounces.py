"""What Section 5 prints of bouncing and is false: no path turns, any triangle may be next."""

from __future__ import annotations

from collections.abc import Iterator

from gmpy2 import mpq

from bern_exact.checkers import bounds_bounce as bounds
from bern_exact.checkers.bouncing import Replay
from bern_exact.checkers.chords import Turns
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.convex.records import Bounced, ConvexFrame, Pending

STAGE = "bounced"

PATIENCE = 2
"""The printed construction is given up after so many times the half-steps that it should take."""


def check_bouncing_as_printed(bounced: Bounced) -> list[Finding]:
    """Evaluate two printed sentences: one on the first subdivisions, one by bouncing anew.

    Parameters
    ----------
    bounced : Bounced
        The record.

    Notes
    -----
    The second takes time proportional to the product of half-steps and subdivisions.
    """
    turns, broken = Turns(bounced.frame), Violations()
    for x, side in () if bounced.frame.one_sided else bounced.first:
        if turns.zone(x):
            broken.case(turns.turn(x, side) is not None, {"x": x, "side": side})
    most, first = Extreme(greatest=True), len(bounced.first)
    turned = sum(step.stays is None for step in bounced.steps)
    bound = bounds.half_steps(first, turned)
    if not bounced.frame.one_sided:
        steps = FarthestFirst(bounced.frame).run(PATIENCE * bound)
        most.offer(steps, 1, {"subdivisions": first, "given up": steps >= PATIENCE * bound > 0})
    return [
        broken.finding(
            "bounce.printed-return",
            STAGE,
            "once those in the middle have been bounced, all subdivision points return to their "
            "own sides",
            role="as-printed",
        ),
        most.finding(
            "bounce.printed-order",
            STAGE,
            "each bounce leaves one more subdivision alone for good, whichever triangle is taken: "
            "half-steps with the farthest always first, at most as many as in the repaired order",
            bound,
            role="as-printed",
        ),
    ]


class FarthestFirst:
    """Section 5 to the letter, with the triangle that is farthest along always the next.

    All closed paths are added to begin with, so that strips are never mixed.

    Parameters
    ----------
    frame : ConvexFrame
        P, two-sided.
    """

    def __init__(self, frame: ConvexFrame) -> None:
        self._replay = Replay(frame)
        self._turns = self._replay.turns
        self._steps = 0
        self._known: dict[Pending, tuple[int, mpq]] = {}
        strips = self._replay.strips
        for x in (*strips.right, *strips.left):
            self._replay.add(x)

    def run(self, limit: int) -> int:
        """How many half-steps it takes, or the limit."""
        self._clear_middle(limit)
        while self._steps < limit and (farthest := max(self._conflicts(), default=None)):
            self._bounce(farthest[1])
            self._clear_middle(limit)
        return self._steps

    def _clear_middle(self, limit: int) -> None:
        """Bounce all that is pending in the middle."""
        while self._steps < limit:
            inside = [p for p in self._replay.pending if self._turns.zone(p.x) == 0]
            if not inside:
                return
            self._bounce(min(inside))

    def _bounce(self, pending: Pending) -> None:
        self._replay.add(pending.x)
        self._steps += 1

    def _conflicts(self) -> Iterator[tuple[mpq, Pending]]:
        """The second along of each triangle with several, after how far along it is."""
        triangles: dict[tuple[int, int], list[mpq]] = {}
        for x, side in self._replay.pending:
            triangles.setdefault((self._replay.column(x), side), []).append(x)
        for (_, side), places in triangles.items():
            if len(places) > 1:
                rightward = self._motion(Pending(places[0], side))[0]
                second = sorted(places, reverse=rightward < 0)[1]
                along = self._motion(Pending(second, side))[1]
                yield along, Pending(second, side)

    def _motion(self, pending: Pending) -> tuple[int, mpq]:
        """Whether a path goes right, left or nowhere; how far along it is, outward or inward.

        That is by where it is on the right, or would come to be next.
        """
        found = self._known.get(pending)
        if found is None:
            x, side = pending
            zone, outward = self._turns.zone(x), self._turns.outward(x, side)
            place = x if zone > 0 else self._turns.next(x, side)
            found = zone * outward, outward * (mpq(0) if place is None else place)
            self._known[pending] = found
        return found
