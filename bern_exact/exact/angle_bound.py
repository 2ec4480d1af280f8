"""Bounds on angles as users write them, compared exactly with the angles of a mesh.

An angle is ordered by its signed square cos |cos|, which is rational for every angle of a mesh
and falls as the angle grows.  That of a bound in degrees is rational for the multiples of 30 and
45 alone (Niven's theorem on the doubled angle), which are taken exactly; every other bound is
enclosed by rationals as tightly as it takes to decide, which ends because equality cannot occur.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from gmpy2 import mpq, mpz

from bern_exact.exact.angles import Angle
from bern_exact.exact.enclosures import cos_degrees_bounds
from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import parse_rational

_EXACT = {0: mpq(1), 30: mpq(3, 4), 45: mpq(1, 2), 60: mpq(1, 4), 90: mpq(0)}
_MOST_CHARACTERS = 1_000
_FIRST_BITS = 64


@dataclass(frozen=True, slots=True)
class AngleBound:
    """An upper bound on angles, in degrees or by its cosine.

    Parameters
    ----------
    text : str
        As it was written.
    degrees : mpq or None
        The bound in degrees, 0 to 180, if it was given so.
    angle : Angle or None
        The bound by its cosine, if that has a rational square.
    """

    text: str
    degrees: mpq | None
    angle: Angle | None

    def enclosure(self, bits: int = _FIRST_BITS) -> tuple[mpq, mpq]:
        """Rationals around the bound's signed square, equal if that is rational itself."""
        if self.angle is not None:
            return self.angle.signed_square, self.angle.signed_square
        if self.degrees is None:
            raise ValueError("a bound has degrees or an angle")
        return signed_square_bounds(self.degrees, bits)

    def admits(self, angle: Angle) -> bool:
        """Is the angle at most the bound?

        >>> parse_angle_bound("149.5").admits(Angle(-1, mpq(3, 4)))
        False
        >>> parse_angle_bound("cos:-1:3/4").admits(Angle(-1, mpq(3, 4)))
        True
        """
        return self._admits(angle.signed_square)

    def admits_corner(self, dot: mpz, cross: mpz) -> bool:
        """Is the angle with this dot product and this cross product > 0 at most the bound?

        Only products of the two are formed, so this is the test for inner loops.
        """
        squared_dot, squared_cross = dot * abs(dot), cross * cross
        low, high = self.enclosure()
        # c/(1 - |c|) is cot |cot| of the angle whose cos |cos| is c.
        if squared_dot * (high.denominator - abs(high.numerator)) >= high.numerator * squared_cross:
            return True
        if squared_dot * (low.denominator - abs(low.numerator)) < low.numerator * squared_cross:
            return False
        return self._admits(mpq(squared_dot, dot * dot + squared_cross))

    def _admits(self, signed_square: mpq) -> bool:
        bits = _FIRST_BITS
        while True:
            low, high = self.enclosure(bits)
            if signed_square >= high:
                return True
            if signed_square < low:
                return False
            bits *= 2


def parse_angle_bound(text: str) -> AngleBound:
    """A bound from decimal degrees (`140`, `149.5`) or `cos:S:p/q` (150 = `cos:-1:3/4`).

    Raises
    ------
    InputError
        Kind `number`: neither of these, or not from 0 to 180 degrees.

    Examples
    --------
    >>> parse_angle_bound("135").angle == parse_angle_bound("cos:-1:1/2").angle
    True
    """
    if text.startswith("cos:"):
        return _from_cosine(text)
    if len(text) > _MOST_CHARACTERS:
        raise InputError("number", f"an angle has at most {_MOST_CHARACTERS:,} characters")
    degrees = parse_rational(text)
    if not 0 <= degrees <= 180:
        raise InputError("number", f"the angle {text} is not from 0 to 180 degrees")
    low, high = signed_square_bounds(degrees, _FIRST_BITS)
    return AngleBound(text, degrees, _angle(low) if low == high else None)


def _from_cosine(text: str) -> AngleBound:
    sign, _, square_text = text[4:].partition(":")
    square = parse_rational(square_text)
    if sign not in ("-1", "0", "1") or (sign == "0") != (square == 0) or not 0 <= square <= 1:
        raise InputError("number", "an angle cos:S:p/q has S in -1, 0, 1 and 0 <= p/q <= 1")
    return AngleBound(text, None, Angle(int(sign), square))


def _angle(signed_square: mpq) -> Angle:
    return Angle((signed_square > 0) - (signed_square < 0), abs(signed_square))


@lru_cache(maxsize=1024)
def signed_square_bounds(degrees: mpq, bits: int) -> tuple[mpq, mpq]:
    """Rationals at most 2^(1 - bits) apart around cos |cos| of an angle of 0 to 180 degrees.

    Equal for the multiples of 30 and of 45 degrees.
    """
    if degrees > 90:
        low, high = signed_square_bounds(180 - degrees, bits)
        return -high, -low
    if degrees in _EXACT:
        return _EXACT[int(degrees)], _EXACT[int(degrees)]
    low, high = cos_degrees_bounds(degrees, bits)
    low, high = max(low, mpq(0)), min(high, mpq(1))  # at most 1, so that it has a cotangent
    return low * low, high * high
