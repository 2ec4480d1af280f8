"""What Section 5 prints of bouncing and is false: paths that turn, and any order of triangles."""

from __future__ import annotations

from bern_exact.checkers.chords import Turns
from bern_exact.checkers.extremes import Violations
from bern_exact.checkers.findings import Finding
from bern_exact.convex.records import Bounced

STAGE = "bounced"


def check_bouncing_as_printed(bounced: Bounced) -> list[Finding]:
    """Evaluate the printed sentence on the subdivisions that there are at first.

    Parameters
    ----------
    bounced : Bounced
        The record.
    """
    turns, broken = Turns(bounced.frame), Violations()
    for x, side in () if bounced.frame.one_sided else bounced.first:
        if turns.zone(x):
            broken.case(turns.turn(x, side) is not None, {"x": x, "side": side})
    return [
        broken.finding(
            "bounce.printed-return",
            STAGE,
            "once those in the middle have been bounced, all subdivision points return to their "
            "own sides",
            role="as-printed",
        )
    ]
