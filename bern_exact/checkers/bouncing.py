"""Section 5's bouncing, replayed: every path goes where it must, and all ends soon enough."""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Iterator

from gmpy2 import mpq

from bern_exact.checkers import bounds_bounce as bounds
from bern_exact.checkers.chords import Turns
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.strips import Strips, check_f
from bern_exact.convex.records import Bounced, ClosedPath, ConvexFrame, HalfStep, Pending

STAGE = "bounced"


class Replay:
    """Verticals and subdivisions of P, one vertical after the other.

    Parameters
    ----------
    frame : ConvexFrame
        P.
    """

    def __init__(self, frame: ConvexFrame) -> None:
        self.turns = Turns(frame)
        self.strips = Strips(frame, self.turns)
        self.one_sided = any(side.most == 0 for side in self.turns.sides)
        self.verticals: list[mpq] = []
        self.pending: set[Pending] = set()
        self._known: set[mpq] = set()
        for x in sorted({x for x, _ in frame.places}):
            self.add(x)

    def add(self, x: mpq) -> None:
        """Draw a vertical, with horizontals from both its ends."""
        if x in self._known:
            return
        insort(self.verticals, x)
        self._known.add(x)
        for side, chain in enumerate(self.turns.sides):
            if (here := Pending(x, side)) in self.pending:
                self.pending.discard(here)
            elif (other := chain.across(x)) is not None and other not in self._known:
                self.pending.add(Pending(other, side))

    def column(self, x: mpq) -> int:
        """How many verticals lie left of x: equal for what shares a triangle."""
        return bisect_left(self.verticals, x)

    def most_in_a_triangle(self) -> Extreme:
        """The most subdivisions that one triangle along the boundary has."""
        number: dict[tuple[int, int], int] = {}
        for x, side in sorted(self.pending):
            place = self.column(x), side
            number[place] = number.get(place, 0) + 1
        most = Extreme(greatest=True)
        for (column, side), count in number.items():
            most.offer(count, 1, {"column": column, "side": side})
        if not number:
            most.offer(0, 1, None)
        most.cases = 2 * (len(self.verticals) - 1)
        return most


def check_bouncing(bounced: Bounced) -> list[Finding]:
    """Replay the bouncing and check what Section 5 claims of it.

    Parameters
    ----------
    bounced : Bounced
        The record; the frame, certified by `diameter`, is believed.

    Notes
    -----
    O(n log n) operations.
    """
    replay = Replay(bounced.frame)
    first, paths, strips, closed = Violations(), Violations(), Violations(), Violations()
    first.cases = len(bounced.first)
    if set(bounced.first) != replay.pending or len(set(bounced.first)) != len(bounced.first):
        first.broken({"subdivisions": len(bounced.first), "expected": len(replay.pending)})
    for event in bounced.events:
        if isinstance(event, HalfStep):
            strips.case(_goes_ahead(replay, event), _described(event))
            paths.case(_bounces(replay, event), _described(event))
        else:
            closed.case(_closes(replay, event), [event.x, event.partner])
    return [
        first.finding(
            "bounce.first",
            STAGE,
            "the subdivisions at first are the ends of all horizontals through vertices and "
            "verticals' ends that are on no vertical",
        ),
        paths.finding(
            "bounce.paths",
            STAGE,
            "each half-step bounces a subdivision that is pending, and leaves one where the next "
            "horizontal of its path ends, or none if that is on a vertical",
        ),
        strips.finding(
            "bounce.strips",
            STAGE,
            "each half-step outside the middle bounces the farther along of two subdivisions of "
            "one triangle that are in the same strip; strips are never mixed",
        ),
        closed.finding(
            "bounce.closed",
            STAGE,
            "each closed path closes exactly, and leaves nothing pending",
        ),
        *_check_counts(bounced, replay),
        *check_f(bounced.frame),
    ]


def _described(step: HalfStep) -> dict[str, object]:
    return {"x": step.x, "side": step.side, "stays": step.stays}


def _goes_ahead(replay: Replay, step: HalfStep) -> bool:
    """Is what stays pending in the same triangle and strip, and behind?  Else is it the middle?"""
    zone = replay.turns.zone(step.x)
    if step.stays is None:
        return zone == 0
    together = (
        Pending(step.stays, step.side) in replay.pending
        and replay.column(step.stays) == replay.column(step.x)
        and step.stays != step.x
    )
    if replay.one_sided:
        return together
    outward = zone * replay.turns.outward(step.x, step.side)
    ahead = outward * (step.x - step.stays) > 0
    return together and ahead and replay.strips.same(step.x, step.stays)


def _bounces(replay: Replay, step: HalfStep) -> bool:
    """Draw the vertical; was its start pending, and is what it leaves as recorded?"""
    if Pending(step.x, step.side) not in replay.pending:
        return False
    other = 1 - step.side
    before = Pending(step.x, other) in replay.pending
    target = replay.turns.sides[other].across(step.x)
    replay.add(step.x)
    left = None if target is None else Pending(target, other)
    if left is not None and (before or left not in replay.pending):
        left = None
    return left == step.left


def _closes(replay: Replay, path: ClosedPath) -> bool:
    """Draw both verticals; are they the sides of a rectangle inscribed in P?"""
    inscribed = path.partner < path.x and all(
        side.across(path.x) == path.partner and side.across(path.partner) == path.x
        for side in replay.turns.sides
    )
    replay.add(path.x)
    replay.add(path.partner)
    ends = {Pending(x, side) for x in path for side in (0, 1)}
    return inscribed and ends.isdisjoint(replay.pending)


def _check_counts(bounced: Bounced, replay: Replay) -> Iterator[Finding]:
    """How many subdivisions are left, and how many half-steps, closed paths, verticals."""
    n, first = bounced.frame.polygon.n, len(bounced.first)
    turned = sum(step.stays is None for step in bounced.steps)
    same = Violations()
    same.case(list(bounced.verticals) == replay.verticals, {"verticals": len(bounced.verticals)})
    yield same.finding(
        "bounce.record", STAGE, "the verticals are those of vertices, half-steps and closed paths"
    )
    yield replay.most_in_a_triangle().finding(
        "bounce.alone",
        STAGE,
        "each triangle along the boundary has at most one subdivision in the end",
        bounds.SUBDIVISIONS_A_TRIANGLE,
    )
    for claim, statement, count, bound in (
        (
            "subdivisions",
            "there are at most 2 (n - 2) subdivisions at first",
            first,
            bounds.first_subdivisions(n),
        ),
        (
            "half-steps",
            "there are at most as many half-steps as subdivisions at first and half-steps in the "
            "middle",
            len(bounced.steps),
            bounds.half_steps(first, turned),
        ),
        (
            "turned",
            "at most one half-step in the middle for each subdivision at first",
            turned,
            bounds.middle_steps(first),
        ),
        (
            "closed-paths",
            "at most one closed path for each subdivision at first",
            len(bounced.closed),
            bounds.closed_paths(first),
        ),
        (
            "verticals",
            "there are at most 9 n verticals in the end",
            len(bounced.verticals),
            bounds.verticals(n),
        ),
    ):
        most = Extreme(greatest=True)
        most.offer(count, 1, {"n": n})
        yield most.finding(f"bounce.{claim}", STAGE, statement, bound)
