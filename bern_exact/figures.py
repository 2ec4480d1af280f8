"""Exact values in a few characters, for people; made with integers, certified, deciding nothing."""

from __future__ import annotations

from collections.abc import Sequence

from gmpy2 import mpq

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
    """An exact value for people: itself if short, else its first digits.

    >>> shortened(20640), shortened("1/128"), shortened("1234567/89101112131415")
    ('20,640', '1/128', '1.38557...e-8')
    """
    if value is None:
        return "-"
    if isinstance(value, dict):
        return _shared((value["lower"], value["upper"]))
    if isinstance(value, int) or (value.isdecimal() and len(value) <= LONGEST):
        return f"{int(value):,}"
    if len(value) <= LONGEST:
        return value
    try:
        return digits_of(parse_rational(value))
    except InputError:
        return value


def digits_of(value: mpq, digits: int = DIGITS) -> str:
    """The first significant digits of a rational, none of them rounded; dots if more follow.

    >>> digits_of(mpq(1, 3)), digits_of(mpq(-5, 4)), digits_of(mpq(10) ** 30 + 1)
    ('0.333333...', '-1.25', '1.00000...e30')
    """
    if value == 0:
        return "0"
    size = abs(value)
    # num_digits may be one too many: begin high enough and go down to the first digit's place.
    exponent = size.numerator.num_digits() - size.denominator.num_digits() + 1
    while size < mpq(10) ** exponent:
        exponent -= 1
    scaled = size * mpq(10) ** (digits - 1 - exponent)
    mantissa = str(scaled.numerator // scaled.denominator)
    shown = _placed(mantissa, exponent, is_exact=scaled.denominator == 1)
    return f"-{shown}" if value < 0 else shown


def _placed(mantissa: str, exponent: int, *, is_exact: bool) -> str:
    """Digits with their point, the first of them worth 10^exponent."""
    suffix = ""
    if -5 < exponent < 0:
        whole, part = "0", "0" * (-exponent - 1) + mantissa
    elif 0 <= exponent < len(mantissa):
        whole, part = mantissa[: exponent + 1], mantissa[exponent + 1 :]
    else:
        whole, part, suffix = mantissa[0], mantissa[1:], f"e{exponent}"
    part = part.rstrip("0") if is_exact else part
    number = f"{whole}.{part}" if part else whole
    return f"{number}{'' if is_exact else '...'}{suffix}"


def degrees(angle: Angle) -> str:
    """An angle in degrees, for people."""
    return _shared(degrees_enclosure(angle))


def root(squared: mpq) -> str:
    """A length given by its square, for people."""
    return _shared(sqrt_enclosure(squared))


def _shared(bounds: Sequence[str]) -> str:
    """What certified bounds of a number say of its first digits."""
    lower, upper = map(parse_rational, bounds)
    return digits_of(lower) if lower == upper else _common(lower, upper)


def _common(lower: mpq, upper: mpq) -> str:
    """The longest first digits, dots after them, that both ends of an interval share."""
    for digits in range(DIGITS, 1, -1):
        low, high = (digits_of(end, digits).replace("...", "") for end in (lower, upper))
        if low == high:
            return digits_of((lower + upper) / 2, digits)
    return f"[{digits_of(lower)}, {digits_of(upper)}]"
