"""Doubles that decide: arrays of balls, whose radii are proved to hold the exact value.

A ball is a double v and a radius r: the exact real number is at most r from v.  Every operation
rounds v once and makes r as large as it must be; `proofs/float_filter.py` has the proofs, for
operands of the sizes that `Points.wild` lets pass.  What is beyond them has an infinite radius,
and an infinite or undefined radius decides nothing.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from gmpy2 import isqrt, mpq, mpz
from numpy.typing import NDArray

from bern_exact.plane.array_mesh import Doubles, Flags, nearest_double

ROUNDING = 2.0**-53
"""A sum, product or quotient of doubles differs from the exact one by this times itself."""

GROWTH = 1 + 2.0**-49
"""A radius is multiplied by this, which makes up for the rounding errors of its own formula."""

INPUT = 2.0**-52
"""A double that stands for a coordinate x differs from it by at most this times |x|."""

SPLIT = 2.0**27 + 1
"""Veltkamp's factor: x is the sum of two doubles of 26 bits."""

UNDECIDED = 2
"""Where a sign is neither -1, 0 nor 1."""

Signs = NDArray[np.int8]


@dataclass(frozen=True, slots=True, eq=False)
class Ball:
    """Real numbers that are at most `radius` from `value`.

    Parameters
    ----------
    value : array of float64
        The middle.
    radius : array of float64
        At least 0; infinite or not a number where nothing is known.
    """

    value: Doubles
    radius: Doubles

    def __neg__(self) -> Ball:
        return Ball(-self.value, self.radius)

    def __add__(self, other: Ball) -> Ball:
        value = self.value + other.value
        return Ball(value, (self.radius + other.radius + ROUNDING * np.abs(value)) * GROWTH)

    def __sub__(self, other: Ball) -> Ball:
        return self + -other

    def __mul__(self, other: Ball) -> Ball:
        value = self.value * other.value
        left = np.abs(self.value) * other.radius
        right = self.radius * (np.abs(other.value) + other.radius)
        return Ball(value, (left + right + ROUNDING * np.abs(value)) * GROWTH)

    def over(self, other: Ball) -> Ball:
        """The quotient; nothing is known of it where the divisor's ball holds 0."""
        value = self.value / other.value
        size, gap = np.abs(value), np.abs(other.value) - other.radius
        radius = (self.radius + size * other.radius) / gap + ROUNDING * size
        return Ball(value, np.where(gap > 0, radius * GROWTH, np.inf))

    def size(self) -> Ball:
        """The absolute value."""
        return Ball(np.abs(self.value), self.radius)

    def least(self, other: Ball) -> Ball:
        """The smaller of two numbers: the smaller ball, with both radii where they overlap."""
        is_first = self.value <= other.value
        value = np.where(is_first, self.value, other.value)
        radius = np.where(is_first, self.radius, other.radius)
        both = self.radius + other.radius
        apart = np.abs(self.value - other.value) > both * GROWTH
        return Ball(value, np.where(apart, radius, both))

    def low(self) -> Doubles:
        """A lower bound, of a product, quotient or 0: their radii are at least their rounding."""
        low: Doubles = self.value - 2 * self.radius
        return low

    def high(self) -> Doubles:
        """An upper bound, likewise."""
        high: Doubles = self.value + 2 * self.radius
        return high

    def signs(self) -> Signs:
        """-1, 0 or 1 where the ball holds numbers of one sign alone, else `UNDECIDED`."""
        signs = np.full(self.value.shape, UNDECIDED, dtype=np.int8)
        signs[self.value > self.radius] = 1
        signs[self.value < -self.radius] = -1
        signs[(self.value == 0) & (self.radius == 0)] = 0
        return signs


def difference(head: Doubles, tail: Doubles, given: Doubles | None = None) -> Ball:
    """head - tail of coordinates next to these doubles.

    The rounding error is known exactly (Knuth's sum): the radius is 0 if there is none.

    Parameters
    ----------
    head, tail : array of float64
        Doubles.
    given : array of float64, optional
        How far the coordinates may differ from them, both together.
    """
    value = head - tail
    error = np.abs(rounding_of_difference(head, tail, value))
    return Ball(value, error if given is None else (error + given) * GROWTH)


def rounding_of_difference(head: Doubles, tail: Doubles, value: Doubles) -> Doubles:
    """head - tail - value exactly, value being the rounded difference (Knuth)."""
    virtual = head - value
    error: Doubles = (head - (value + virtual)) + (virtual - tail)
    return error


def rounding_of_product(x: Doubles, y: Doubles, value: Doubles) -> Doubles:
    """x y - value exactly, value being the rounded product (Dekker)."""
    x_high, y_high = SPLIT * x, SPLIT * y
    x_high, y_high = x_high - (x_high - x), y_high - (y_high - y)
    x_low, y_low = x - x_high, y - y_high
    error: Doubles = ((x_high * y_high - value) + x_high * y_low + x_low * y_high) + x_low * y_low
    return error


def signs_of_two_products(x: Doubles, y: Doubles, z: Doubles, w: Doubles) -> Signs:
    """The sign of x y + z w, exactly.

    Rounding is monotone: if the products round to p and q, and p differs from -q, then x y
    differs from -z w the same way; if p = -q, the sign is that of the sum of their errors.

    >>> signs_of_two_products(*(np.array([v]) for v in (1 + 2.0**-30, 1 - 2.0**-30, -1.0, 1.0)))
    array([-1], dtype=int8)
    """
    first, second = x * y, z * w
    rounded = first + second
    errors = rounding_of_product(x, y, first) + rounding_of_product(z, w, second)
    return np.sign(np.where(rounded == 0, errors, rounded)).astype(np.int8)


def are_exact(*balls: Ball) -> Flags:
    """Where do all the balls hold their values alone?"""
    exact: Flags = np.logical_and.reduce([ball.radius == 0 for ball in balls])
    return exact


def doubles_around(low: mpq, high: mpq) -> tuple[float, float]:
    """Doubles at most `low` and at least `high`: these themselves, if they are doubles.

    >>> doubles_around(mpq(0), mpq(1, 2))
    (0.0, 0.5)
    """
    below = nearest_double(low.numerator, low.denominator)
    above = nearest_double(high.numerator, high.denominator)
    if not np.isfinite(below) or mpq(*below.as_integer_ratio()) > low:
        below = float(np.nextafter(below, -np.inf))
    if not np.isfinite(above) or mpq(*above.as_integer_ratio()) < high:
        above = float(np.nextafter(above, np.inf))
    return below, above


def cotangent_bounds(low: mpq, high: mpq) -> tuple[float, float]:
    """Doubles around the cotangents of the angles whose cos |cos| is from low to high.

    With s = cos |cos| it is the square root of |s| / (1 - |s|), with the sign of s.

    >>> cotangent_bounds(mpq(0), mpq(0)), cotangent_bounds(mpq(-1), mpq(-1))
    ((0.0, 0.0), (-inf, -inf))
    """
    if low >= 1 or high <= -1:
        end = float("inf" if low >= 1 else "-inf")
        return end, end
    bottom = float("-inf") if low <= -1 else doubles_around(*_cotangent(low))[0]
    top = float("inf") if high >= 1 else doubles_around(*_cotangent(high))[1]
    return bottom, top


def _cotangent(square: mpq) -> tuple[mpq, mpq]:
    """Rationals around one cotangent, closer to each other than doubles are."""
    if square < 0:
        low, high = _cotangent(-square)
        return -high, -low
    ratio = square / (1 - square)
    scale = mpz(2) ** (128 + ratio.denominator.bit_length())
    root = isqrt(ratio.numerator * scale * scale // ratio.denominator)
    return mpq(root, scale), mpq(root + (1 if square else 0), scale)
