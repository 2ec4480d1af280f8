"""Lemma 9: a right triangle with one subdivision on a leg into three right triangles."""

from __future__ import annotations

from collections.abc import Iterator

from gmpy2 import mpq

from bern_exact.checkers import bounds_bounce as bounds
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.convex.records import Gridded, Leg, Position

STAGE = "gridded"

Edge = tuple[Position, Position]


def check_lemma_9(gridded: Gridded) -> list[Finding]:
    """Check every triangle along the boundary.

    Lemma 9: "If a right triangle has one subdivision point on a leg, it can be triangulated with
    three right triangles, by adding a diagonal from the opposite vertex to the subdivision point,
    and then dropping an altitude to the hypotenuse."

    Parameters
    ----------
    gridded : Gridded
        The record; nothing but its coordinates is believed.

    Notes
    -----
    Linear time.
    """
    right, tiling, most = Violations(), Violations(), Extreme(greatest=True)
    for leg in gridded.legs:
        place = {"column": leg.column, "side": leg.side}
        triangles = [tuple(map(gridded.position, corners)) for corners in leg.triangles]
        for corners in triangles:
            right.case(_is_right(*corners), place)
        tiling.case(_is_tiling(gridded, leg, triangles), place)
        most.offer(len(triangles), 1, place)
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


def _is_right(p: Position, q: Position, r: Position) -> bool:
    """Is one of the angles exactly 90 degrees, and is the triangle counter-clockwise?"""
    dots = (_dot(p, q, r), _dot(q, r, p), _dot(r, p, q))
    return 0 in dots and _cross(p, q, r) > 0


def _is_tiling(gridded: Gridded, leg: Leg, triangles: list[tuple[Position, ...]]) -> bool:
    """Is each directed edge used once, and is what no reverse cancels the subdivided outline?"""
    edges: set[Edge] = set()
    for p, q, r in triangles:
        sides = ((p, q), (q, r), (r, p))
        if _cross(p, q, r) <= 0 or any(side in edges for side in sides):
            return False
        edges.update(sides)
    free = {edge for edge in edges if edge[::-1] not in edges}
    low, right, high = map(gridded.position, (leg.low, leg.right, leg.high))
    wanted = {low, right, high}
    if leg.subdivision is not None:
        wanted.add(gridded.position(leg.subdivision))
    feet = {p for triangle in triangles for p in triangle} - wanted
    outline = [*_on(low, right, wanted), *_on(right, high, wanted), *_on(high, low, wanted | feet)]
    if _cross(low, right, high) < 0:
        outline = [(q, p) for p, q in outline]
    on_boundary = {p for edge in outline for p in edge}
    return free == set(outline) and len(feet) <= 1 and on_boundary == wanted | feet


def _on(start: Position, end: Position, points: set[Position]) -> Iterator[Edge]:
    """The pieces of a segment between these points, those that are not on it left out."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = dx * dx + dy * dy
    placed = []
    for p in points:
        along = (p[0] - start[0]) * dx + (p[1] - start[1]) * dy
        if _cross(start, end, p) == 0 and 0 <= along <= length:
            placed.append((along, p))
    placed.sort()
    for (_, p), (_, q) in zip(placed, placed[1:], strict=False):
        yield p, q


def _dot(p: Position, q: Position, r: Position) -> mpq:
    """The dot product of the sides at p."""
    return (q[0] - p[0]) * (r[0] - p[0]) + (q[1] - p[1]) * (r[1] - p[1])


def _cross(p: Position, q: Position, r: Position) -> mpq:
    """Twice the signed area."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
