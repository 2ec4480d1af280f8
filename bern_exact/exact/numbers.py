"""Rationals as text: read, refused, written.

A number is an integer `-12`, a fraction `p/q` with q > 0, or a decimal `-1.5e-3`, and is read as
exactly that.  The size of a text is looked at before any number is built from it, so that
`1e999999999` is refused at once.  Texts are converted by gmpy2, which is subquadratic and knows
no limit on digits, and not by `int`, which refuses more than 4,300.
"""

from __future__ import annotations

import re
from typing import Any

from gmpy2 import mpq, mpz

from bern_exact.exact.errors import InputError

MAX_DIGITS = 100_000
"""The most digits that an integer (a numerator, a denominator, a decimal's digits) may have."""

MAX_EXPONENT = 10_000
"""The largest absolute value of a decimal's exponent."""

JSON_INT_DIGITS = 1_000
"""The most characters of a JSON integer that is read as an `int`; see `JsonNumber`."""

_MAX_LENGTH = 2 * MAX_DIGITS + 2
"""No number within the limits is longer: sign, numerator, stroke, denominator."""

_INTEGER_OR_FRACTION = re.compile(r"([+-]?)([0-9]+)(?:/([0-9]+))?")
_DECIMAL = re.compile(
    r"""(?P<sign>[+-]?)
        (?:(?P<whole>[0-9]+)(?:\.(?P<part>[0-9]*))?|\.(?P<only_part>[0-9]+))
        (?:[eE](?P<exponent>[+-]?[0-9]+))?""",
    re.VERBOSE,
)
_NOT_FINITE = re.compile(r"[+-]?(?:nan|inf|infinity)", re.IGNORECASE)

# A double is m 2^e with m < 2^53 and e from -1074 to 971.
_MANTISSA_BITS = 53
_LEAST_EXPONENT = -1074
_GREATEST_EXPONENT = 971


class JsonNumber(str):
    """A bare number of a JSON file that is no short integer: its text, to be read exactly.

    A class of its own, so that the number `1.5` and the string `"1.5"` can be told apart where
    only one of them may stand.
    """

    __slots__ = ()


def parse_rational(text: str, *, binary64: bool = False) -> mpq:
    """The rational that a text stands for.

    Parameters
    ----------
    text : str
        An integer, a fraction `p/q` (q > 0, not necessarily in lowest terms) or a decimal with
        or without an exponent.  ASCII digits, no spaces, no underscores.
    binary64 : bool
        Read a decimal as the double nearest to it (ties to even), then exactly.  Integers and
        fractions stay what they are.

    Raises
    ------
    InputError
        Kind `number`: anything else; a zero denominator; more than `MAX_DIGITS` digits; an
        exponent beyond `MAX_EXPONENT`; with `binary64`, a decimal beyond all doubles.

    Notes
    -----
    Quasi-linear in the digits; a refusal takes one look at the text.

    Examples
    --------
    >>> parse_rational("-6/4"), parse_rational("0.1"), parse_rational("-1.5e-3")
    (mpq(-3,2), mpq(1,10), mpq(-3,2000))
    >>> parse_rational("0.1", binary64=True)
    mpq(3602879701896397,36028797018963968)
    """
    if len(text) > _MAX_LENGTH:
        raise _too_long(text)
    exact = _INTEGER_OR_FRACTION.fullmatch(text)
    if exact is not None:
        return _fraction(text, *exact.groups())
    decimal = _DECIMAL.fullmatch(text)
    if decimal is None:
        raise InputError("number", _why_not_a_number(text))
    value = _decimal(text, decimal)
    return nearest_binary64(value) if binary64 else value


def _fraction(text: str, sign: str, numerator: str, denominator: str | None) -> mpq:
    """An integer or fraction from its parts."""
    if len(numerator) > MAX_DIGITS or len(denominator or "") > MAX_DIGITS:
        raise _too_long(text)
    divisor = mpz(denominator or "1", 10)
    if divisor == 0:
        raise InputError("number", f"{shown(text)} divides by zero")
    value = mpq(mpz(numerator, 10), divisor)
    return -value if sign == "-" else value


def _decimal(text: str, match: re.Match[str]) -> mpq:
    """A decimal from the match of `_DECIMAL`, its sizes checked first."""
    part = match["part"] or match["only_part"] or ""
    digits = (match["whole"] or "") + part
    if len(digits) > MAX_DIGITS:
        raise _too_long(text)
    written = match["exponent"] or "0"
    size = written.lstrip("+-0") or "0"
    if len(size) > len(str(MAX_EXPONENT)) or int(size) > MAX_EXPONENT:
        raise InputError("number", f"the exponent of {shown(text)} is beyond {MAX_EXPONENT:,}")
    power = (-int(size) if written.startswith("-") else int(size)) - len(part)
    mantissa = mpz(digits, 10)
    if match["sign"] == "-":
        mantissa = -mantissa
    ten = mpz(10)
    return mpq(mantissa * ten**power) if power >= 0 else mpq(mantissa, ten**-power)


def nearest_binary64(value: mpq) -> mpq:
    """The binary64 double nearest to a rational, ties to even, as a rational.

    Raises
    ------
    InputError
        Kind `number`: the value rounds to an infinity.

    >>> nearest_binary64(mpq(2**53 + 1))
    mpq(9007199254740992,1)
    """
    numerator, denominator = abs(value.numerator), value.denominator
    # floor(log2 |value|) is this or one less; the loop below settles which.
    exponent = numerator.bit_length() - denominator.bit_length() - _MANTISSA_BITS
    exponent = max(exponent, _LEAST_EXPONENT)
    mantissa = _rounded_quotient(numerator << max(-exponent, 0), denominator << max(exponent, 0))
    if mantissa.bit_length() > _MANTISSA_BITS:
        exponent += 1
        mantissa = _rounded_quotient(
            numerator << max(-exponent, 0), denominator << max(exponent, 0)
        )
    if mantissa.bit_length() + exponent > _MANTISSA_BITS + _GREATEST_EXPONENT:
        raise InputError("number", "the number is beyond the largest binary64 double")
    size = mpq(mantissa) * mpq(2) ** exponent
    return -size if value < 0 else size


def _rounded_quotient(numerator: mpz, denominator: mpz) -> mpz:
    """The integer nearest to a quotient, ties to even; both positive."""
    quotient, remainder = divmod(numerator, denominator)
    if 2 * remainder > denominator or (2 * remainder == denominator and quotient % 2 == 1):
        quotient += 1
    return quotient


def format_rational(value: mpq | mpz | int) -> str:
    """The one text of a rational: an integer, or a fraction in lowest terms.

    >>> format_rational(mpq(6, -4)), format_rational(mpq(8, 2)), format_rational(10)
    ('-3/2', '4', '10')
    """
    return str(mpq(value))


def rational_from_json(value: Any, path: str, *, binary64: bool = False) -> mpq:
    """The rational at some place of a JSON document: a string or a bare number.

    Parameters
    ----------
    value : object
        What the document holds there, as `bern_exact.formats.safe_json` reads it.
    path : str
        Where, as JSONPath (`$.outer[3][0]`), for the refusal.
    binary64 : bool
        As in `parse_rational`.

    Raises
    ------
    InputError
        Kind `number`, with `where={"path": path}`: no number (booleans, null, lists, ...), one
        that `parse_rational` refuses, or a `float`, whose text is lost.

    >>> rational_from_json("1/3", "$.outer[0][0]"), rational_from_json(2, "$.outer[0][1]")
    (mpq(1,3), mpq(2,1))
    """
    if type(value) is int:
        return mpq(value)
    if isinstance(value, str):
        try:
            return parse_rational(value, binary64=binary64)
        except InputError as error:
            raise InputError("number", f"{error.message} (at {path})", {"path": path}) from None
    if isinstance(value, float):
        reason = "a float has lost the text of its decimal: give the number as a string"
    else:
        reason = f"{json_kind(value)} is not a number"
    raise InputError("number", f"{reason} (at {path})", {"path": path})


def json_kind(value: Any) -> str:
    """What a JSON value is, in words."""
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int | JsonNumber):
        return "a number"
    kinds = ((str, "a string"), (list, "an array"), (dict, "an object"))
    return next((words for kind, words in kinds if isinstance(value, kind)), "this value")


def shown(text: str) -> str:
    """A text in quotes for a message, cut to a readable length.

    >>> shown("1" * 50)
    "'111111111111111111111111...'"
    """
    return repr(text if len(text) <= 24 else text[:24] + "...")


def _too_long(text: str) -> InputError:
    """The refusal of a number that is too long."""
    message = f"{shown(text)} is too long: an integer has at most {MAX_DIGITS:,} digits"
    return InputError("number", message)


def _why_not_a_number(text: str) -> str:
    """The message for a text that is no number at all."""
    if _NOT_FINITE.fullmatch(text):
        return f"{shown(text)} is not finite"
    return f"{shown(text)} is not a number: an integer, a fraction p/q or a decimal is expected"
