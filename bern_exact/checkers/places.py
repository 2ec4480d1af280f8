"""Where nodes are after warping, and squared lengths and heights as unreduced fractions."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from gmpy2 import mpq, mpz

from bern_exact.boundary.records import Node, Warped
from bern_exact.checkers.extremes import plain
from bern_exact.exact.points import HPoint, grid_point


class Places(dict[Node, HPoint]):
    """The position of each final node in grid coordinates, found once.

    Parameters
    ----------
    warped : Warped
        Its `image` and `points` say where vertices and crossings are; a grid vertex
        that did not move is where it was.
    projections : sequence of HPoint
        The Steiner points on edges of a `MergedMesh`, the nodes after all crossings.
    """

    def __init__(self, warped: Warped, projections: Sequence[HPoint] = ()) -> None:
        super().__init__(enumerate(warped.traced.diced.framed.polygon.points))
        n = len(self)
        for j, image in enumerate(warped.image):
            if image == n + j:
                self[image] = warped.points[j]
        self.update(enumerate(projections, n + len(warped.image)))

    def __missing__(self, node: Node) -> HPoint:
        """Called for what is no vertex, final crossing or projection: a grid vertex.

        Raises
        ------
        KeyError
            For a crossing that ends as another node, or an index out of range.
        """
        if not isinstance(node, tuple):
            raise KeyError(node)
        place = self[node] = grid_point(*node)
        return place

    def describe(self, witness: Any) -> Any:
        """The nodes of a witness `(what, nodes)` with their exact positions, JSON-ready."""
        what, nodes = witness
        return {
            "at": plain(what),
            "nodes": [{"node": plain(node), "point": point_text(self[node])} for node in nodes],
        }


def point_text(p: HPoint) -> list[str]:
    """The exact coordinates of a point as text."""
    return [str(mpq(p[0], p[2])), str(mpq(p[1], p[2]))]


def squared_length(p: HPoint, q: HPoint) -> tuple[mpz, mpz]:
    """|pq|^2 as a fraction that is not reduced."""
    px, py, pw = p
    qx, qy, qw = q
    dx = qx * pw - px * qw
    dy = qy * pw - py * qw
    w = pw * qw
    return dx * dx + dy * dy, w * w


def squared_height(p: HPoint, q: HPoint, r: HPoint) -> tuple[mpz, mpz]:
    """The squared height over the longest edge as a fraction that is not reduced.

    A triangle that is clockwise or flat counts with a height of -1 or 0: its
    height is below any bound.
    """
    px, py, pw = p
    qx, qy, qw = q
    rx, ry, rw = r
    ax, ay = qx * pw - px * qw, qy * pw - py * qw  # pw qw (q - p)
    bx, by = rx * pw - px * rw, ry * pw - py * rw  # pw rw (r - p)
    area = ax * by - ay * bx  # pw^2 qw rw twice the area
    if area <= 0:
        return (mpz(-1) if area < 0 else mpz(0)), mpz(1)
    cx, cy = rx * qw - qx * rw, ry * qw - qy * rw  # qw rw (r - q)
    longest = max(
        (ax * ax + ay * ay) * rw * rw, (bx * bx + by * by) * qw * qw, (cx * cx + cy * cy) * pw * pw
    )
    return area * area, longest * pw * pw


def cotangent(before: HPoint, apex: HPoint, after: HPoint) -> tuple[mpz, mpz]:
    """(dot, cross) at a corner of a counter-clockwise triangle: the angle's cotangent.

    `after` is the next corner counter-clockwise.  The fraction falls as the
    angle grows from 0 to 180 degrees.
    """
    ox, oy, ow = apex
    ax, ay, aw = after
    bx, by, bw = before
    ux, uy = ax * ow - ox * aw, ay * ow - oy * aw
    vx, vy = bx * ow - ox * bw, by * ow - oy * bw
    return ux * vx + uy * vy, ux * vy - uy * vx


def cotangents(p: HPoint, q: HPoint, r: HPoint) -> Iterator[tuple[mpz, mpz]]:
    """The cotangents of a triangle's three angles as unreduced fractions, at p, q and r.

    A clockwise or flat triangle counts as angles of 180 degrees and more: what it
    yields is -2 or less, below any bound.
    """
    corners = (p, q, r)
    for i, apex in enumerate(corners):
        inner, area = cotangent(corners[i - 1], apex, corners[i - 2])
        yield (inner, area) if area > 0 else (-abs(inner) - 2, mpz(1))
