"""Lemma 7: every triangulated rectangle keeps its angle, height and size."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from bern_exact.checkers.bounds import (
    TILING_COTANGENT,
    TILING_HEIGHT_SQUARED,
    tiling_steiner_points,
    tiling_triangles,
)
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.interior.subdivided.records import (
    HalfNode,
    SubdividedRectangle,
    Tiled,
    Tiling,
)

STAGE = "tiled"
Edge = tuple[HalfNode, HalfNode]


def check_lemma_7(tiled: Tiled) -> tuple[Finding, ...]:
    """The claims of Lemma 7 over all rectangles.

    Parameters
    ----------
    tiled : Tiled
        The record; nothing but its coordinates is believed.

    Returns
    -------
    tuple of Finding
        `lemma-7.tiling`, `.angle`, `.height`, `.interior`, `.steiner`, `.triangles`.
    """
    tilings, inside = Violations(), Violations()
    angle, height = Extreme(), Extreme()
    steiner, triangles = Extreme(greatest=True), Extreme(greatest=True)
    for tiling in tiled.tilings:
        rectangle = tiling.rectangle
        place = rectangle[:4]
        tilings.case(_is_tiling(tiling), place)
        inside.case(all(_is_inside(p, rectangle) for p in tiling.steiner), place)
        beta = 2 * least_spacing(rectangle)
        for triangle in tiling.triangles:
            for cotangent in _cotangents(triangle):
                angle.offer(*cotangent, triangle)
            height.offer(*_squared_height(triangle, beta), triangle)
        on_boundary = len(rectangle.ring())
        long_side = _subdivisions_of_long_side(rectangle)
        steiner.offer(len(tiling.steiner) - long_side, 1, place)
        triangles.offer(len(tiling.triangles), on_boundary, place)
    return (
        tilings.finding(
            "lemma-7.tiling",
            STAGE,
            "The triangles of a rectangle fill it and use all its vertices and no other "
            "point of its sides.",
        ),
        angle.finding(
            "lemma-7.angle",
            STAGE,
            "Each angle is at most 135 degrees (least cotangent).",
            TILING_COTANGENT,
        ),
        height.finding(
            "lemma-7.height",
            STAGE,
            "Each squared height is at least 1/5 of the squared least spacing beta of "
            "vertices of its rectangle (ratio of squares).",
            TILING_HEIGHT_SQUARED,
        ),
        inside.finding(
            "lemma-7.interior", STAGE, "Steiner points lie strictly inside their rectangle."
        ),
        steiner.finding(
            "lemma-7.steiner",
            STAGE,
            "Steiner points beyond the number of subdivisions of a longer side.",
            tiling_steiner_points(0),
        ),
        triangles.finding(
            "lemma-7.triangles",
            STAGE,
            "Triangles for each vertex on the rectangle's boundary.",
            tiling_triangles(1),
        ),
    )


def least_spacing(rectangle: SubdividedRectangle) -> int:
    """beta: the least distance of neighbouring vertices along the sides, in grid units."""
    ring = rectangle.ring()
    return min(abs(p[0] - q[0]) + abs(p[1] - q[1]) for p, q in pairwise([*ring, ring[0]]))


def _subdivisions_of_long_side(rectangle: SubdividedRectangle) -> int:
    x0, x1, y0, y1 = rectangle[:4]
    return len(rectangle.bottom if x1 - x0 >= y1 - y0 else rectangle.left)


def _is_inside(p: HalfNode, rectangle: SubdividedRectangle) -> bool:
    x0, x1, y0, y1 = rectangle[:4]
    return 2 * x0 < p[0] < 2 * x1 and 2 * y0 < p[1] < 2 * y1


def _is_tiling(tiling: Tiling) -> bool:
    """Positive triangles, directed edges once, the rest exactly the ring, no other vertex."""
    ring = [(2 * x, 2 * y) for x, y in tiling.rectangle.ring()]
    edges: set[Edge] = set()
    for p, q, r in tiling.triangles:
        sides = ((p, q), (q, r), (r, p))
        if _cross(p, q, r) <= 0 or any(side in edges for side in sides):
            return False
        edges.update(sides)
    free = {edge for edge in edges if edge[::-1] not in edges}
    used = {p for triangle in tiling.triangles for p in triangle}
    listed = [*ring, *tiling.steiner]
    return (
        free == set(pairwise([*ring, ring[0]])) and used == set(listed) and len(used) == len(listed)
    )


def _cross(p: HalfNode, q: HalfNode, r: HalfNode) -> int:
    """Twice the signed area."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def _cotangents(triangle: Sequence[HalfNode]) -> Iterator[tuple[int, int]]:
    """(dot, cross) at each corner; -2, below any bound, for a triangle that is not positive."""
    area = _cross(*triangle)
    for i in range(3):
        p, q, r = triangle[i], triangle[i - 2], triangle[i - 1]
        dot = (q[0] - p[0]) * (r[0] - p[0]) + (q[1] - p[1]) * (r[1] - p[1])
        yield (dot, area) if area > 0 else (-2, 1)


def _squared_height(triangle: Sequence[HalfNode], beta: int) -> tuple[int, int]:
    """(height/beta)^2 as an unreduced fraction; -1 for a triangle that is not positive."""
    area = _cross(*triangle)
    if area <= 0:
        return -1, 1
    longest = max(
        (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2 for p, q in pairwise([*triangle, triangle[0]])
    )
    return area * area, longest * beta * beta
