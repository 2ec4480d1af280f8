"""Angle tests by the signs of dot and cross products, and the largest angle of a triangle.

An angle of a triangle is given by the exact pair (`cos_sign`,
`cos_squared`): it orders angles in [0, 180] degrees strictly.
"""

from __future__ import annotations

from typing import NamedTuple

from gmpy2 import mpq, mpz, sign

from bern_exact.exact.points import HPoint, direction
from bern_exact.exact.predicates import cross, dot


class Angle(NamedTuple):
    """An angle between 0 and 180 degrees, by its cosine: sign and square."""

    cos_sign: int
    cos_squared: mpq

    @property
    def signed_square(self) -> mpq:
        """cos |cos|: strictly decreasing in the angle."""
        return self.cos_sign * self.cos_squared

    def is_at_most(self, bound: Angle) -> bool:
        """Is this angle no larger than the bound?

        >>> Angle(-1, mpq(1, 2)).is_at_most(Angle(-1, mpq(3, 4)))
        True
        """
        return bool(self.signed_square >= bound.signed_square)


RIGHT = Angle(0, mpq(0))
ANGLE_60 = Angle(1, mpq(1, 4))
ANGLE_90 = RIGHT
ANGLE_120 = Angle(-1, mpq(1, 4))
ANGLE_135 = Angle(-1, mpq(1, 2))
ANGLE_150 = Angle(-1, mpq(3, 4))
ANGLE_180 = Angle(-1, mpq(1))


def is_at_most_60(dot_product: mpz, cross_product: mpz) -> bool:
    """Is the angle with this dot product and this cross product > 0 at most 60 degrees?"""
    return bool(dot_product > 0 and cross_product * cross_product <= 3 * dot_product * dot_product)


def is_at_most_90(dot_product: mpz) -> bool:
    """Is the angle with this dot product at most 90 degrees?"""
    return bool(dot_product >= 0)


def is_at_most_120(dot_product: mpz, cross_product: mpz) -> bool:
    """Is the angle with this dot product and this cross product > 0 at most 120 degrees?"""
    return bool(dot_product >= 0 or 3 * dot_product * dot_product <= cross_product * cross_product)


def is_at_most_135(dot_product: mpz, cross_product: mpz) -> bool:
    """Is the angle with this dot product and this cross product > 0 at most 135 degrees?"""
    return bool(dot_product + cross_product >= 0)


def is_at_most_150(dot_product: mpz, cross_product: mpz) -> bool:
    """Is the angle with this dot product and this cross product > 0 at most 150 degrees?"""
    return bool(dot_product >= 0 or dot_product * dot_product <= 3 * cross_product * cross_product)


def angle_at(before: HPoint, apex: HPoint, after: HPoint) -> Angle:
    """The angle (at most 180 degrees) between apex-before and apex-after."""
    u, v = direction(apex, before), direction(apex, after)
    product = dot(u, v)
    return Angle(int(sign(product)), mpq(product * product, dot(u, u) * dot(v, v)))


def largest_angle(p: HPoint, q: HPoint, r: HPoint) -> tuple[Angle, int]:
    """The largest angle of a triangle and the corner (0, 1 or 2) where it is.

    The corner is opposite the longest edge; of equal ones the first.
    """
    pq, qr, rp = direction(p, q), direction(q, r), direction(r, p)
    # Squared lengths times (pw qw rw)^2, so that they compare as integers.
    lengths = (dot(qr, qr) * p[2] ** 2, dot(rp, rp) * q[2] ** 2, dot(pq, pq) * r[2] ** 2)
    corner = max(range(3), key=lambda i: (lengths[i], -i))
    points = (p, q, r)
    return angle_at(points[corner - 1], points[corner], points[(corner + 1) % 3]), corner


def tangent_pair(before: HPoint, apex: HPoint, after: HPoint) -> tuple[mpz, mpz]:
    """(dot, cross) of apex-after and apex-before: the angle turned counter-clockwise."""
    u, v = direction(apex, after), direction(apex, before)
    return dot(u, v), cross(u, v)
