"""The best triangulation of a small face, by exact dynamic programming."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from gmpy2 import mpq

from bern_exact.exact.points import HPoint

Triple = tuple[int, int, int]


@dataclass(frozen=True, slots=True)
class Triangulated:
    """A triangulation of a face.

    Parameters
    ----------
    triangles : tuple of (int, int, int)
        Indices into the ring, counter-clockwise.
    squared_height : mpq
        The least squared height of a triangle.
    """

    triangles: tuple[Triple, ...]
    squared_height: mpq


def squared_height_if(p: HPoint, q: HPoint, r: HPoint, limited: bool) -> mpq | None:
    """The squared height of a counter-clockwise triangle, or None if it is not admitted.

    Parameters
    ----------
    p, q, r : HPoint
        The triangle.
    limited : bool
        Refuse angles above 135 degrees?  (dot + cross >= 0 at each corner.)
    """
    px, py, pw = p
    qx, qy, qw = q
    rx, ry, rw = r
    ax, ay = qx * pw - px * qw, qy * pw - py * qw  # pw qw (q - p)
    bx, by = rx * pw - px * rw, ry * pw - py * rw  # pw rw (r - p)
    area = ax * by - ay * bx  # pw^2 qw rw times twice the area
    if area <= 0:
        return None
    cx, cy = rx * qw - qx * rw, ry * qw - qy * rw  # qw rw (r - q)
    if limited:
        # Each cross product is the same area, scaled as its own corner's dot product is:
        # at p by pw^2 qw rw, at q by qw^2 pw rw, at r by rw^2 pw qw.
        if ax * bx + ay * by + area < 0:
            return None
        if (-ax * cx - ay * cy) * pw + area * qw < 0:
            return None
        if (bx * cx + by * cy) * pw + area * rw < 0:
            return None
    longest = max(
        (ax * ax + ay * ay) * rw * rw, (bx * bx + by * by) * qw * qw, (cx * cx + cy * cy) * pw * pw
    )
    return mpq(area * area, longest * pw * pw)


def best_triangulation(points: Sequence[HPoint], limited: bool) -> Triangulated | None:
    """The triangulation of a simple ring with the greatest least height.

    Parameters
    ----------
    points : sequence of HPoint
        A simple polygon, counter-clockwise; not necessarily convex.
    limited : bool
        Allow no angle above 135 degrees?

    Returns
    -------
    Triangulated or None
        None if there is no triangulation within the limit.  Of equally good ones, that
        with the least third corners.

    Notes
    -----
    The triangles of any choice of third corners form a combinatorial disc; if all are
    positively oriented over a simple ring they tile its interior (the disc covers each
    point as often as the ring winds around it).  So orientation is the only test needed.
    Cubic in the number of sides, which is at most 7 here.
    """
    size = len(points)
    if size == 3:
        height = squared_height_if(points[0], points[1], points[2], limited)
        return None if height is None else Triangulated(((0, 1, 2),), height)
    table = _Table(points, limited)
    for width in range(2, size):
        for i in range(size - width):
            table.fill(i, i + width)
    height = table.value.get((0, size - 1))
    if height is None:
        return None
    return Triangulated(tuple(table.triangles(0, size - 1)), height)


@dataclass(slots=True)
class _Table:
    """Best least heights of the sub-polygons i, i + 1, ..., j."""

    points: Sequence[HPoint]
    limited: bool
    value: dict[tuple[int, int], mpq] = field(default_factory=dict)
    third: dict[tuple[int, int], int] = field(default_factory=dict)

    def fill(self, i: int, j: int) -> None:
        """Choose the third corner of the triangle at the side ij."""
        best: mpq | None = None
        for k in range(i + 1, j):
            least = self._rest(i, k, j)
            if least is None or (best is not None and 0 <= least <= best):
                continue
            height = squared_height_if(self.points[i], self.points[k], self.points[j], self.limited)
            if height is None:
                continue
            least = height if least < 0 else min(least, height)
            if best is None or least > best:
                best = least
                self.third[i, j] = k
        if best is not None:
            self.value[i, j] = best

    def _rest(self, i: int, k: int, j: int) -> mpq | None:
        """The least height of both sub-polygons beside a triangle; -1 if both are single sides."""
        parts = []
        for low, high in ((i, k), (k, j)):
            if high > low + 1:
                value = self.value.get((low, high))
                if value is None:
                    return None
                parts.append(value)
        return min(parts) if parts else mpq(-1)

    def triangles(self, i: int, j: int) -> list[Triple]:
        """The triangles chosen for the sub-polygon i ... j."""
        if j < i + 2:
            return []
        k = self.third[i, j]
        return [*self.triangles(i, k), (i, k, j), *self.triangles(k, j)]
