"""Grades of triangles: which may be made, and how high they are, in one integer."""

from __future__ import annotations

from collections.abc import Sequence

from gmpy2 import mpq, mpz

from bern_exact.exact.angle_bound import AngleBound
from bern_exact.exact.points import HPoint

BITS = 32
"""Heights are told apart to 2^-32 of the floor; only the choice among allowed triangles sees it."""

PASS = mpz(1) << BITS
"""The least grade by height of a triangle that may be made."""

ALIKE = 4 * PASS
"""The grade by angle of all triangles without an angle above the one asked for."""

_MOST_REMEMBERED = 200_000


class Grades:
    """The grades of triangles on some vertices, remembered while there is room.

    Parameters
    ----------
    points : sequence of HPoint
        The vertices.
    bounds : sequence of AngleBound
        No angle above any of them.
    squared_floor : mpq
        No squared height below it; positive.

    Notes
    -----
    The grade is floor(2^32 height^2 / floor), or 0 for a triangle that may not be made: one that
    is clockwise or flat, has an angle above a bound, or whose exact ratio is below 1 (which
    is the case exactly if its rounded-down grade is below 2^32).
    """

    __slots__ = ("_bounds", "_den", "_known", "_num", "_points")

    def __init__(
        self, points: Sequence[HPoint], bounds: Sequence[AngleBound], squared_floor: mpq
    ) -> None:
        self._points = points
        self._num = squared_floor.denominator << BITS
        self._den = squared_floor.numerator
        self._known: dict[tuple[int, int, int], mpz] = {}
        self._bounds = [_Bound(bound) for bound in bounds]

    def of(self, a: int, b: int, c: int) -> mpz:
        """The grade of the triangle (a, b, c), given with its least vertex first."""
        key = (a, b, c)
        grade = self._known.get(key)
        if grade is None:
            if len(self._known) >= _MOST_REMEMBERED:
                self._known.clear()
            grade = self._known[key] = self._measured(*(self._points[v] for v in key))
        return grade

    def _measured(self, p: HPoint, q: HPoint, r: HPoint) -> mpz:
        px, py, pw = p
        qx, qy, qw = q
        rx, ry, rw = r
        ax, ay = qx * pw - px * qw, qy * pw - py * qw  # pw qw (q - p)
        bx, by = rx * pw - px * rw, ry * pw - py * rw  # pw rw (r - p)
        area = ax * by - ay * bx  # pw^2 qw rw times twice the area
        if area <= 0:
            return mpz(0)
        cx, cy = rx * qw - qx * rw, ry * qw - qy * rw  # qw rw (r - q)
        # Squared lengths times (pw qw rw)^2.
        u = (ax * ax + ay * ay) * (rw * rw)
        v = (bx * bx + by * by) * (qw * qw)
        w = (cx * cx + cy * cy) * (pw * pw)
        longest = max(u, v, w)
        grade = (area * area * self._num) // (longest * (pw * pw) * self._den)
        if grade < PASS:
            return mpz(0)
        # Twice the dot and the cross product at the corner opposite the longest side.
        dot, cross = u + v + w - 2 * longest, 2 * area * qw * rw
        if not all(bound.admits(dot, cross) for bound in self._bounds):
            return mpz(0)
        return self._graded(grade, dot, cross)

    def _graded(self, height: mpz, dot: mpz, cross: mpz) -> mpz:
        """The grade of a triangle that may be made, from its height's and its largest angle."""
        return height


class AngleGrades(Grades):
    """Grades by the largest angle instead of the height.

    Parameters
    ----------
    points, bounds, squared_floor
        As for `Grades`: what may be made at all.
    asked : AngleBound
        Triangles without an angle above this are all alike, and better than the others.

    Notes
    -----
    The grade of another is 1 + floor(2^32 (1 + c/(1 + |c|))) for the cotangent c of its largest
    angle: it falls as the angle grows.
    """

    __slots__ = ("_asked",)

    def __init__(
        self,
        points: Sequence[HPoint],
        bounds: Sequence[AngleBound],
        squared_floor: mpq,
        asked: AngleBound,
    ) -> None:
        super().__init__(points, bounds, squared_floor)
        self._asked = _Bound(asked)

    def _graded(self, height: mpz, dot: mpz, cross: mpz) -> mpz:
        if self._asked.admits(dot, cross):
            return ALIKE
        return 1 + PASS + (dot << BITS) // (cross + abs(dot))


class _Bound:
    """An angle bound with its cotangent at hand."""

    __slots__ = ("_above", "_asked", "_rest")

    def __init__(self, asked: AngleBound) -> None:
        self._asked = asked
        # c/(1 - |c|) is cot |cot| of the angle whose cos |cos| is c; for 150 degrees -3.
        high = asked.enclosure()[1]
        self._above = high.numerator
        self._rest = high.denominator - abs(high.numerator)

    def admits(self, dot: mpz, cross: mpz) -> bool:
        """May there be the angle with this dot product and this cross product > 0?"""
        if dot * abs(dot) * self._rest >= self._above * cross * cross:
            return True
        return self._asked.admits_corner(dot, cross)
