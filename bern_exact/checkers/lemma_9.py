"""Lemma 9: a right triangle with one subdivision on a leg into three right triangles."""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.checkers import bounds_bounce as bounds
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.convex.cells import GridPoint
from bern_exact.convex.records import Corner, Gridded, Leg, Position, RightTriangle

STAGE = "gridded"


def check_lemma_9(gridded: Gridded) -> list[Finding]:
    """Check every triangle along the boundary.

    Lemma 9: "If a right triangle has one subdivision point on a leg, it can be triangulated with
    three right triangles, by adding a diagonal from the opposite vertex to the subdivision point,
    and then dropping an altitude to the hypotenuse."

    Parameters
    ----------
    gridded : Gridded
        The record; its lines, certified by `grid`, are believed to increase.

    Notes
    -----
    Linear time.  Corners on one line are told by their indices, others by their coordinates.
    """
    right, tiling, most = Violations(), Violations(), Extreme(greatest=True)
    for leg in gridded.legs:
        place = {"column": leg.column, "side": leg.side}
        for triangle in leg.triangles:
            right.case(_is_right(gridded, triangle), place)
        tiling.case(_is_tiling(gridded, leg), place)
        most.offer(len(leg.triangles), 1, place)
    return [
        right.finding(
            "lemma-9.right", STAGE, "each triangle is positive, with an angle of exactly 90 degrees"
        ),
        tiling.finding(
            "lemma-9.tiling",
            STAGE,
            "the triangles fill the right triangle, use its subdivision, and put one point "
            "on its hypotenuse only",
        ),
        most.finding(
            "lemma-9.triangles",
            STAGE,
            "a right triangle with a subdivision becomes three",
            bounds.RIGHT_TRIANGLES,
        ),
    ]


def _is_right(gridded: Gridded, triangle: RightTriangle) -> bool:
    """Is one of the angles exactly 90 degrees, and is the triangle counter-clockwise?"""
    a, b, c = triangle
    if isinstance(a, tuple) and isinstance(b, tuple) and isinstance(c, tuple):
        for p, q, r in ((a, b, c), (b, c, a), (c, a, b)):
            if (p[0] == q[0] and p[1] == r[1]) or (p[1] == q[1] and p[0] == r[0]):
                return _turn(p, q, r) > 0
    corners = tuple(map(gridded.position, triangle))
    return any(_dot(*corners[i:], *corners[:i]) == 0 for i in range(3)) and _cross(*corners) > 0


def _turn(p: GridPoint, q: GridPoint, r: GridPoint) -> int:
    """The orientation of a triangle with two sides along lines, by indices."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def _is_tiling(gridded: Gridded, leg: Leg) -> bool:
    """Is each directed edge used once, and is what no reverse cancels the subdivided outline?

    With positive triangles, which is `lemma-9.right`, they then fill the outline.
    """
    sides = [pair for p, q, r in leg.triangles for pair in ((p, q), (q, r), (r, p))]
    edges = set(sides)
    free = {edge for edge in edges if edge[::-1] not in edges}
    corners = (leg.low, leg.right, leg.high)
    feet = {p for edge in edges for p in edge} - {*corners, leg.subdivision}
    outline: list[Corner] = [*corners, *feet]
    if leg.subdivision is not None:
        outline.insert(2, leg.subdivision)
    ring = set(zip(outline, [*outline[1:], outline[0]], strict=True))
    if _turn(leg.right, leg.high, leg.low) < 0:
        ring = {(q, p) for p, q in ring}
    return (
        len(sides) == len(edges)
        and free == ring
        and len(feet) == (leg.subdivision is not None)
        and _is_on_leg(leg)
        and all(_is_on_hypotenuse(gridded, leg, foot) for foot in feet)
    )


def _is_on_leg(leg: Leg) -> bool:
    """Is the subdivision strictly between the right angle and the far corner?"""
    if leg.subdivision is None:
        return True
    column, row = leg.subdivision
    ends = sorted((leg.right[1], leg.high[1]))
    return column == leg.right[0] == leg.high[0] and ends[0] < row < ends[1]


def _is_on_hypotenuse(gridded: Gridded, leg: Leg, foot: Corner) -> bool:
    """Is this point strictly between the two corners on the boundary?"""
    p, q, s = map(gridded.position, (leg.low, leg.high, foot))
    return min(p[0], q[0]) < s[0] < max(p[0], q[0]) and _cross(p, q, s) == 0


def _dot(p: Position, q: Position, r: Position) -> mpq:
    """The dot product of the sides at p."""
    return (q[0] - p[0]) * (r[0] - p[0]) + (q[1] - p[1]) * (r[1] - p[1])


def _cross(p: Position, q: Position, r: Position) -> mpq:
    """Twice the signed area."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
