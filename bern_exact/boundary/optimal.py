"""The best triangulation of a small face, by exact dynamic programming."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from gmpy2 import mpq

from bern_exact.exact.points import HPoint

Triple = tuple[int, int, int]

Rating = Callable[[int, int, int], mpq | None]
"""How good the triangle of three of a ring's vertices is, or None if it is refused."""

KAPPA_135 = mpq(1)
"""No angle above 135 degrees."""


def largest_kappa(tau: mpq) -> mpq:
    """kappa of the angle 135 degrees + arctan(2 tau): its cotangent is -(1 + 2 tau)/(1 - 2 tau).

    >>> largest_kappa(mpq(1, 8))
    mpq(5,3)
    """
    return (1 + 2 * tau) / (1 - 2 * tau)


@dataclass(frozen=True, slots=True)
class Demand:
    """What a triangulation must keep, and what it is best at.

    Parameters
    ----------
    kappa : mpq, optional
        No angle with dot + kappa cross < 0: its cotangent is at least -kappa.
    squared_floor : mpq
        No squared height below this.
    for_angle : bool
        Best is the least largest angle; otherwise the greatest least height.
    """

    kappa: mpq | None = None
    squared_floor: mpq = mpq(0)
    for_angle: bool = False


HIGHEST = Demand()
"""The greatest least height, whatever the angles."""

HIGHEST_WITHIN_135 = Demand(KAPPA_135)
"""The greatest least height without an angle above 135 degrees."""


@dataclass(frozen=True, slots=True)
class Triangulated:
    """A triangulation of a face.

    Parameters
    ----------
    triangles : tuple of (int, int, int)
        Indices into the ring, counter-clockwise.
    value : mpq
        What it is best at: the least squared height, or the least cotangent of an angle.
    """

    triangles: tuple[Triple, ...]
    value: mpq


def rate(p: HPoint, q: HPoint, r: HPoint, demand: Demand) -> mpq | None:
    """How good a triangle is by a demand; None if it is clockwise, flat or does not keep it."""
    px, py, pw = p
    qx, qy, qw = q
    rx, ry, rw = r
    ax, ay = qx * pw - px * qw, qy * pw - py * qw  # pw qw (q - p)
    bx, by = rx * pw - px * rw, ry * pw - py * rw  # pw rw (r - p)
    area = ax * by - ay * bx  # pw^2 qw rw times twice the area
    if area <= 0:
        return None
    cx, cy = rx * qw - qx * rw, ry * qw - qy * rw  # qw rw (r - q)
    # At each corner (dot, cross) up to a common positive factor; the cross products are all
    # the same area, scaled as their corners' dot products are.
    corners = (
        (ax * bx + ay * by, area),
        (-(ax * cx + ay * cy) * pw, area * qw),
        ((bx * cx + by * cy) * pw, area * rw),
    )
    kappa = demand.kappa
    if kappa is not None:
        num, den = kappa.numerator, kappa.denominator
        for dot, cross in corners:
            if den * dot + num * cross < 0:
                return None
    longest = max(
        (ax * ax + ay * ay) * rw * rw, (bx * bx + by * by) * qw * qw, (cx * cx + cy * cy) * pw * pw
    )
    height = mpq(area * area, longest * pw * pw)
    if height < demand.squared_floor:
        return None
    return min(mpq(dot, cross) for dot, cross in corners) if demand.for_angle else height


def best_triangulation(points: Sequence[HPoint], demand: Demand) -> Triangulated | None:
    """The best triangulation of a simple ring by its own vertices.

    Parameters
    ----------
    points : sequence of HPoint
        A simple polygon, counter-clockwise; not necessarily convex.
    demand : Demand
        What it must keep and be best at.

    Returns
    -------
    Triangulated or None
        As `best_by_rating`.
    """
    return best_by_rating(
        len(points), lambda i, j, k: rate(points[i], points[j], points[k], demand)
    )


def best_by_rating(size: int, rating: Rating) -> Triangulated | None:
    """The best triangulation of a simple ring whose triangles are rated by the caller.

    Parameters
    ----------
    size : int
        The number of sides.
    rating : callable
        Of three increasing positions in the ring.

    Returns
    -------
    Triangulated or None
        None if there is no triangulation that keeps the demand.  Of equally good ones, that
        with the least third corners.

    Notes
    -----
    The triangles of any choice of third corners form a combinatorial disc; if all are
    positively oriented over a simple ring they tile its interior (the disc covers each
    point as often as the ring winds around it).  So orientation is the only test needed.
    Cubic in the number of sides, which is at most 7 in a face.
    """
    if size == 3:
        value = rating(0, 1, 2)
        return None if value is None else Triangulated(((0, 1, 2),), value)
    table = _Table(rating)
    for width in range(2, size):
        for i in range(size - width):
            table.fill(i, i + width)
    value = table.value.get((0, size - 1))
    if value is None:
        return None
    return Triangulated(tuple(table.triangles(0, size - 1)), value)


@dataclass(slots=True)
class _Table:
    """Best values of the sub-polygons i, i + 1, ..., j."""

    rating: Rating
    value: dict[tuple[int, int], mpq] = field(default_factory=dict)
    third: dict[tuple[int, int], int] = field(default_factory=dict)

    def fill(self, i: int, j: int) -> None:
        """Choose the third corner of the triangle at the side ij."""
        best: mpq | None = None
        for k in range(i + 1, j):
            parts = self._parts(i, k, j)
            if parts is None or (best is not None and parts and min(parts) <= best):
                continue
            own = self.rating(i, k, j)
            if own is None:
                continue
            least = min([own, *parts])
            if best is None or least > best:
                best = least
                self.third[i, j] = k
        if best is not None:
            self.value[i, j] = best

    def _parts(self, i: int, k: int, j: int) -> list[mpq] | None:
        """The values of the sub-polygons beside a triangle; None if one has no triangulation."""
        parts = []
        for low, high in ((i, k), (k, j)):
            if high > low + 1:
                value = self.value.get((low, high))
                if value is None:
                    return None
                parts.append(value)
        return parts

    def triangles(self, i: int, j: int) -> list[Triple]:
        """The triangles chosen for the sub-polygon i ... j."""
        if j < i + 2:
            return []
        k = self.third[i, j]
        return [*self.triangles(i, k), (i, k, j), *self.triangles(k, j)]
