"""The shape of a triangle in homogeneous integers: its largest angle and its least height."""

from __future__ import annotations

from typing import Any

from gmpy2 import mpq, mpz, sign

from bern_exact.exact.angle_bound import AngleBound
from bern_exact.exact.angles import Angle
from bern_exact.exact.points import HPoint
from bern_exact.oracle.verdict import Findings, angle_json

Shape = tuple[mpz, mpz, mpz, mpz]
"""(2 dot, cross, longest, product): the largest angle's cot, and what heights are made of."""


def shape_of(p: HPoint, q: HPoint, r: HPoint) -> Shape:
    """Twice the dot product at the largest angle, cross product, longest edge squared, and scale.

    The first three are multiplied by the scale, (pw qw rw)^2, so that they are integers.
    """
    px, py, pw = p
    qx, qy, qw = q
    rx, ry, rw = r
    ax, ay = qx * pw - px * qw, qy * pw - py * qw
    bx, by = rx * pw - px * rw, ry * pw - py * rw
    cx, cy = rx * qw - qx * rw, ry * qw - qy * rw
    cross = (ax * by - ay * bx) * qw * rw
    first = (ax * ax + ay * ay) * rw * rw
    second = (bx * bx + by * by) * qw * qw
    third = (cx * cx + cy * cy) * pw * pw
    longest = max(first, second, third)
    return first + second + third - 2 * longest, cross, longest, (pw * qw * rw) ** 2


def angle_class(dot: mpz, cross: mpz) -> int:
    """The number of the class of the angle with this 2 dot and this cross > 0."""
    if dot > 0:
        return 0 if 4 * cross * cross <= 3 * dot * dot else 1
    if dot == 0:
        return 1
    squared_dot, squared_cross = dot * dot, cross * cross
    if 3 * squared_dot <= 4 * squared_cross:
        return 2
    if squared_dot <= 4 * squared_cross:
        return 3
    return 4 if squared_dot <= 12 * squared_cross else 5


def angle_of(dot: mpz, cross: mpz) -> Angle:
    """The angle with this 2 dot and this cross."""
    return Angle(int(sign(dot)), mpq(dot * dot, dot * dot + 4 * cross * cross))


class Extremes:
    """The first triangle with the largest angle, and the first with the least height."""

    def __init__(self) -> None:
        self.max_angle_triangle: int | None = None
        self.min_height_triangle: int | None = None
        self._low = mpz(0), mpz(1)  # the least cot so far
        self._least = mpz(0), mpz(1)  # the least squared height so far

    def see_angle(self, t: int, shape: Shape) -> None:
        """Take the angle of a triangle with area into account."""
        dot, cross, low = shape[0], abs(shape[1]), self._low
        if self.max_angle_triangle is None or dot * low[1] < low[0] * cross:
            self.max_angle_triangle, self._low = t, (dot, cross)

    def see_height(self, t: int, shape: Shape) -> None:
        """Take the height of a triangle with area into account."""
        square, product, least = shape[1] * shape[1], shape[2] * shape[3], self._least
        if self.min_height_triangle is None or square * least[1] < least[0] * product:
            self.min_height_triangle, self._least = t, (square, product)

    @property
    def max_angle(self) -> Angle | None:
        """The largest angle, if there is one."""
        return None if self.max_angle_triangle is None else angle_of(*self._low)

    @property
    def min_height_squared(self) -> mpq | None:
        """The least squared height, if there is one."""
        return None if self.min_height_triangle is None else mpq(*self._least)


class Bounds:
    """What is asked of every triangle with area.

    Parameters
    ----------
    max_angle : AngleBound or None
        No angle may be larger.
    min_height_squared : mpq or None
        No squared height may be smaller.
    """

    def __init__(self, max_angle: AngleBound | None, min_height_squared: mpq | None) -> None:
        self.max_angle, self.min_height_squared = max_angle, min_height_squared

    def admit_angle(self, shape: Shape) -> bool:
        """Is the largest angle at most the bound?"""
        return self.max_angle is None or self.max_angle.admits_corner(shape[0], 2 * abs(shape[1]))

    def admit_height(self, shape: Shape) -> bool:
        """Is the least height at least the bound?"""
        return self.min_height_squared is None or _height(shape) >= self.min_height_squared

    def look_at(self, t: int, shape: Shape, found: Findings) -> None:
        """Note what a triangle does not keep."""
        if self.max_angle is not None and not self.admit_angle(shape):
            witness: dict[str, Any] = {"bound": self.max_angle.text}
            if not found.full:
                witness |= angle_json(angle_of(shape[0], abs(shape[1])))
            found.add("angle-above-bound", {"triangle": t}, witness)
        if self.min_height_squared is not None and not self.admit_height(shape):
            bound, height = str(self.min_height_squared), str(_height(shape))
            witness = {"bound": bound, "height_squared": height}
            found.add("height-below-bound", {"triangle": t}, witness)


def _height(shape: Shape) -> mpq:
    """The least squared height of a triangle with area."""
    return mpq(shape[1] * shape[1], shape[2] * shape[3])
