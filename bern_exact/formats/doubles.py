"""Coordinates written as doubles, and how many of them were rounded to be written so."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from gmpy2 import mpq, mpz

from bern_exact.exact.errors import InputError
from bern_exact.exact.points import HPoint
from bern_exact.plane.array_mesh import nearest_double

_LARGEST_INTEGER = 2**53


@dataclass
class Rounding:
    """Writes coordinates, and counts.

    Parameters
    ----------
    rounded : int
        The number of coordinates so far that no double is.

    Examples
    --------
    >>> rounding = Rounding()
    >>> rounding.text(mpz(1), mpz(2)), rounding.text(mpz(3), mpz(1)), rounding.rounded
    ('0.5', '3', 0)
    >>> rounding.text(mpz(1), mpz(3)), rounding.rounded
    ('0.3333333333333333', 1)
    """

    rounded: int = 0

    def text(self, numerator: mpz, denominator: mpz) -> str:
        """The shortest decimal that is read as the double nearest to a quotient, denominator > 0.

        Raises
        ------
        InputError
            Kind `number`: it is beyond all doubles.
        """
        whole, part = divmod(numerator, denominator)
        if part == 0 and abs(whole) <= _LARGEST_INTEGER:
            return str(whole)
        double = nearest_double(numerator, denominator)
        try:
            ratio = double.as_integer_ratio()
        except OverflowError:
            message = "a coordinate is beyond the largest double: JSON alone holds it"
            raise InputError("number", message) from None
        if mpq(*ratio) != mpq(numerator, denominator):
            self.rounded += 1
        return repr(double)

    def pairs(self, points: Iterable[HPoint]) -> list[tuple[str, str]]:
        """The texts (x, y) of points."""
        text = self.text
        return [(text(x, w), text(y, w)) for x, y, w in points]
