"""Points whose coordinates are still the text of a file: parsed where they are looked at.

A file of a million numbers is read by checking all of it at once and rounding each number to the
double next to it; the few coordinates that doubles do not decide are parsed exactly, on demand.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeGuard

import numpy as np
from gmpy2 import mpq

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import JsonNumber, parse_rational
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.plane.array_mesh import (
    LONG,
    WHOLE,
    DoublePoints,
    Doubles,
    Flags,
    Lattice,
    Points,
    are_wild,
    common_multiple,
    lattice_of,
)

Number = int | float | str
"""A coordinate: an integer, a double that is meant exactly, or the text of a rational."""

LONGEST = 300
"""Texts up to this length are read at once: integers of so many digits are below all infinities."""

MOST_PLACES = 36
"""10^36 is below `LONG`."""

_CHARACTERS = b"0123456789+-./eE\n"


@dataclass(frozen=True)
class TextPoints:
    """Points by their numbers as a file has them.

    Parameters
    ----------
    numbers : sequence of int, float or str
        x0, y0, x1, y1, ...; each text one that `parse_rational` reads.
    doubles : array of float64, (V, 2)
        The doubles nearest to them.
    """

    numbers: Sequence[Number]
    doubles: Doubles

    @property
    def exact(self) -> bool:
        """It is not known whether the doubles are the coordinates."""
        return False

    @cached_property
    def wild(self) -> Flags:
        """(V,): is a coordinate neither 0 nor between `SMALL` and `LARGE` in size?"""
        wild = are_wild(self.doubles)
        for v, k in np.argwhere(self.doubles == 0).tolist():
            wild[v] |= _rational(self.numbers[2 * v + k]) != 0
        return wild

    @property
    def tame(self) -> bool:
        """Is no vertex wild?"""
        return not self.wild.any()

    @cached_property
    def lattice(self) -> Lattice | None:
        """The coordinates times their common denominator, if these are below `LONG` in size."""
        scale = common_multiple(map(_denominator, self.numbers))
        if scale is None:
            return None
        with np.errstate(over="ignore"):  # what is infinite is not below it either
            if not np.all(np.abs(self.doubles) * scale <= LONG):
                return None
        return lattice_of([_times(number, scale) for number in self.numbers])

    def __len__(self) -> int:
        return len(self.doubles)

    def point(self, v: int) -> HPoint:
        """The point of a vertex, exactly.

        >>> TextPoints(["0.1", 3], np.array([[0.1, 3.0]])).point(0)
        (mpz(1), mpz(30), mpz(10))
        """
        return hpoint(_rational(self.numbers[2 * v]), _rational(self.numbers[2 * v + 1]))

    def are_equal(self, v: int, w: int, axis: int) -> bool:
        """Do two vertices have the same x (axis 0), or the same y (axis 1)?"""
        x, y = self.numbers[2 * v + axis], self.numbers[2 * w + axis]
        return (type(x) is type(y) and x == y) or _rational(x) == _rational(y)


def points_of_numbers(numbers: Sequence[object], *, binary64: bool) -> Points | None:
    """Points from the numbers of a file, all at once, if nothing about them is unusual.

    Parameters
    ----------
    numbers : sequence of int and str
        x0, y0, x1, y1, ...
    binary64 : bool
        Read each decimal as the double nearest to it, then exactly.

    Returns
    -------
    Points or None
        The same points as `parse_rational` reads.  None if it refuses a number, and if a number
        is so long, or so large, that it is better read by itself: the caller then goes through
        them one by one, and has the place of the refusal.

    Notes
    -----
    Linear: half a second for a million decimals.

    >>> points_of_numbers(["1/3", "0.5"], binary64=False).point(0)
    (mpz(2), mpz(3), mpz(6))
    >>> points_of_numbers(["1/3", "nan"], binary64=False) is None
    True
    """
    if not _are_numbers(numbers):
        return None
    texts = [number for number in numbers if isinstance(number, str)]
    joined = "\n".join(texts)
    if not _look_like_numbers(texts, joined):
        return None
    fractions = "/" in joined
    try:
        flat = list(map(_nearest if fractions else float, numbers))
    except (ValueError, ZeroDivisionError, OverflowError):
        return None
    doubles = np.array(flat, dtype=np.float64).reshape(-1, 2) + 0  # no -0
    if ("e" in joined or "E" in joined) and not _are_exponents_small(numbers, doubles):
        return None
    if binary64:
        return _read_as_doubles(numbers, doubles, fractions)
    whole = not fractions and not ("." in joined or "e" in joined or "E" in joined)
    if whole and np.all(np.abs(doubles) < WHOLE):
        return DoublePoints(doubles)
    return TextPoints(numbers, doubles)


def _are_numbers(numbers: Sequence[object]) -> TypeGuard[Sequence[int | str]]:
    """Are these integers and texts alone?  (A boolean is no number.)"""
    return len(numbers) % 2 == 0 and set(map(type, numbers)) <= {int, str, JsonNumber}


def _look_like_numbers(texts: Sequence[str], joined: str) -> bool:
    """What `float` and `int` would read, but `parse_rational` does not, is told apart here."""
    if not texts:
        return True
    if max(map(len, texts)) > LONGEST or joined.count("\n") != len(texts) - 1:
        return False
    if joined.encode("utf-8", "surrogatepass").translate(None, _CHARACTERS):
        return False
    return "/-" not in joined and "/+" not in joined


def _nearest(number: int | str) -> float:
    """The double nearest to a number; a quotient of integers is rounded once."""
    if isinstance(number, str) and "/" in number:
        numerator, _, denominator = number.partition("/")
        return int(numerator) / int(denominator)
    return float(number)


def _are_exponents_small(numbers: Sequence[int | str], doubles: Doubles) -> bool:
    """Does `parse_rational` read the decimals of large exponents, which round to 0 or infinity?"""
    odd = np.flatnonzero((doubles == 0) | ~np.isfinite(doubles)).tolist()
    try:
        for i in odd:
            _rational(numbers[i])
    except InputError:
        return False
    return True


def _read_as_doubles(
    numbers: Sequence[int | str], doubles: Doubles, fractions: bool
) -> Points | None:
    """Decimals are the doubles nearest to them; integers and fractions are what they are."""
    if not np.isfinite(doubles).all():
        return None
    large = np.flatnonzero(np.abs(doubles) >= WHOLE).tolist()
    if not fractions and all(_is_decimal(numbers[i]) for i in large):
        return DoublePoints(doubles)
    flat = doubles.ravel().tolist()
    mixed = [x if _is_decimal(n) else n for n, x in zip(numbers, flat, strict=True)]
    return TextPoints(mixed, doubles)


def _is_decimal(number: Number) -> bool:
    """Is this a decimal, rather than an integer or a fraction?"""
    return isinstance(number, str) and not number.lstrip("+-").replace("/", "").isdigit()


def _rational(number: Number) -> mpq:
    """The rational that a number is."""
    if isinstance(number, str):
        return parse_rational(number)
    return mpq(*number.as_integer_ratio())


def _denominator(number: Number) -> int:
    """A denominator of a number; `LONG` if it is as large as that."""
    if not isinstance(number, str):
        return number.as_integer_ratio()[1]
    _, stroke, below = number.partition("/")
    if stroke:
        return int(below)
    _, places = _digits_and_places(number)
    return LONG if places > MOST_PLACES else _power_of_ten(places)


def _times(number: Number, scale: int) -> int:
    """A number times a multiple of its `_denominator`."""
    if not isinstance(number, str):
        numerator, denominator = number.as_integer_ratio()
        return numerator * (scale // denominator)
    numerator_text, stroke, below = number.partition("/")
    if stroke:
        return int(numerator_text) * (scale // int(below))
    digits, places = _digits_and_places(number)
    return int(digits) * (scale // _power_of_ten(places) * _power_of_ten(-places))


def _digits_and_places(decimal: str) -> tuple[str, int]:
    """A decimal as digits with a sign, and how many of them are behind the point."""
    mantissa, _, exponent = decimal.lower().partition("e")
    whole, _, part = mantissa.partition(".")
    return whole + part, len(part) - int(exponent or 0)


def _power_of_ten(exponent: int) -> int:
    """10^exponent; 1 if it is negative."""
    power: int = 10 ** max(exponent, 0)
    return power
