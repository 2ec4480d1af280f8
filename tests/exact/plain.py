"""The exact ground done plainly in fractions, which tests compare with, and strategies."""

from __future__ import annotations

from fractions import Fraction

from gmpy2 import mpq
from hypothesis import strategies as st

from bern_exact.exact.points import HPoint, hpoint
from tests.rationals import few_fractions, fractions

Point = tuple[Fraction, Fraction]

# Small coordinates meet often on lines and in angles; the others are there for their size.
small = few_fractions(-3, 3, 3)
coordinates = st.one_of(small, small, fractions, st.integers(-(10**40), 10**40).map(Fraction))
points = st.tuples(coordinates, coordinates)


def exactly(value: Fraction) -> mpq:
    return mpq(value.numerator, value.denominator)


def plain(value: mpq) -> Fraction:
    return Fraction(int(value.numerator), int(value.denominator))


def homogeneous(p: Point) -> HPoint:
    return hpoint(exactly(p[0]), exactly(p[1]))


def minus(p: Point, q: Point) -> Point:
    return p[0] - q[0], p[1] - q[1]


def dot(u: Point, v: Point) -> Fraction:
    return u[0] * v[0] + u[1] * v[1]


def cross(u: Point, v: Point) -> Fraction:
    return u[0] * v[1] - u[1] * v[0]


def turn(p: Point, q: Point, r: Point) -> Fraction:
    """Twice the signed area of a triangle."""
    return cross(minus(q, p), minus(r, p))


def square(p: Point, q: Point) -> Fraction:
    """The squared distance of two points."""
    return dot(minus(p, q), minus(p, q))


def sign(value: Fraction) -> int:
    return (value > 0) - (value < 0)
