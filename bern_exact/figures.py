"""Exact values in a few characters, for people; made with integers, certified, deciding nothing."""

from __future__ import annotations

from collections.abc import Sequence

from gmpy2 import mpq, mpz

from bern_exact.checkers.findings import Exact
from bern_exact.exact.angles import Angle
from bern_exact.exact.enclosures import degrees_enclosure, sqrt_enclosure
from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import parse_rational

DIGITS = 6
"""Significant digits of a shortened value."""

LONGEST = 12
"""An exact value of no more characters is shown as it is."""


def shortened(value: Exact) -> str:
    """An exact value for people: itself if short, else decimals that enclose it.

    >>> shortened(20640), shortened("1/128"), shortened("1234567/89101112131415")
    ('20,640', '1/128', '[1.38557e-8, 1.38558e-8]')
    """
    if value is None:
        return "-"
    if isinstance(value, int):
        return f"{value:,}"
    if isinstance(value, dict):
        return f"[{value['lower'][:LONGEST]}, {value['upper'][:LONGEST]}]"
    if len(value) <= LONGEST:
        return value
    try:
        return enclosed(parse_rational(value))
    except InputError:
        return value


def enclosed(value: mpq, digits: int = DIGITS) -> str:
    """Decimals of so many significant digits that enclose a rational; one if it is exact.

    >>> enclosed(mpq(1, 3)), enclosed(mpq(-5, 4)), enclosed(mpq(10) ** 30 + 1)
    ('[0.333333, 0.333334]', '-1.25', '[1e30, 1.00001e30]')
    """
    if value == 0:
        return "0"
    # The exponent of the first digit is this or one less.
    exponent = value.numerator.num_digits() - value.denominator.num_digits()
    if abs(value) < mpq(10) ** exponent:
        exponent -= 1
    scaled = value * mpq(10) ** (digits - 1 - exponent)
    low = scaled.numerator // scaled.denominator
    if low == scaled:
        return _decimal(low, exponent, digits)
    return f"[{_decimal(low, exponent, digits)}, {_decimal(low + 1, exponent, digits)}]"


def _decimal(mantissa: mpz, exponent: int, digits: int) -> str:
    """mantissa 10^(exponent + 1 - digits) as a decimal, with an exponent if it is far from 1."""
    sign, text = "-" if mantissa < 0 else "", str(abs(mantissa))
    exponent += len(text) - digits  # a mantissa rounded up to 10^digits has one digit more
    if -4 <= exponent < digits:
        whole = text[: exponent + 1] if exponent >= 0 else "0"
        part = text[exponent + 1 :] if exponent >= 0 else "0" * (-exponent - 1) + text
        suffix = ""
    else:
        whole, part, suffix = text[0], text[1:], f"e{exponent}"
    part = part.rstrip("0")
    return f"{sign}{whole}{'.' + part if part else ''}{suffix}"


def degrees(angle: Angle, digits: int = DIGITS) -> str:
    """An angle in degrees, for people."""
    return _bounds(degrees_enclosure(angle, digits))


def root(squared: mpq, digits: int = DIGITS) -> str:
    """A length given by its square, for people."""
    return _bounds(sqrt_enclosure(squared, digits))


def _bounds(pair: Sequence[str]) -> str:
    lower, upper = pair
    return lower if lower == upper else f"[{lower}, {upper}]"
