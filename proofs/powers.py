"""Certified rational bounds of logarithms and of real powers."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

from gmpy2 import mpq

from bern_exact.exact.enclosures import decimal_enclosure

Bounds = tuple[mpq, mpq]
"""A rational at most, and one at least, the number meant."""

BITS = 96
"""Ends are rounded outwards to multiples of 2^-96."""


def rounded(low: mpq, high: mpq) -> Bounds:
    """The same bounds with short ends, further out."""
    unit = mpq(1, 2**BITS)
    scaled_low, scaled_high = low / unit, high / unit
    return (
        scaled_low.numerator // scaled_low.denominator * unit,
        -(-scaled_high.numerator // scaled_high.denominator) * unit,
    )


@lru_cache(maxsize=256)
def log_bounds(q: mpq) -> Bounds:
    """The natural logarithm of q > 0.

    ln q = k ln 2 + 2 artanh z, z = (r - 1)/(r + 1), q = 2^k r with 1/2 <= r <= 2; the series
    z + z^3/3 + ... leaves out less than its first term left out times 1/(1 - z^2), z^2 <= 1/9.
    """
    if q <= 0:
        raise ValueError("only a positive number has a logarithm")
    k, r = 0, q
    while r > 1:
        k, r = k + 1, r / 2
    while r < mpq(1, 2):
        k, r = k - 1, r * 2
    low, high = _twice_artanh((r - 1) / (r + 1))
    if k:
        two = _twice_artanh(mpq(1, 3))
        low, high = low + min(k * two[0], k * two[1]), high + max(k * two[0], k * two[1])
    return rounded(low, high)


def _twice_artanh(z: mpq) -> Bounds:
    """2 artanh z for |z| <= 1/3."""
    total, power, i = mpq(0), z, 1
    while abs(power) > mpq(1, 2 ** (BITS + 8)):
        total, power, i = total + power / i, power * z * z, i + 2
    rest = 2 * abs(power) / i
    return rounded(2 * (total - rest), 2 * (total + rest))


def exp_bounds(low: mpq, high: mpq) -> Bounds:
    """e to the power of a number between low and high."""
    return _exp(low)[0], _exp(high)[1]


def _exp(y: mpq) -> Bounds:
    """Taylor's series at y / 2^j with |y / 2^j| <= 1/2, squared j times.

    The rest is at most twice the first term left out.
    """
    j = 0
    while abs(y) > mpq(1, 2):
        y, j = y / 2, j + 1
    total, term, i = mpq(0), mpq(1), 0
    while abs(term) > mpq(1, 2 ** (2 * BITS)):
        total, i = total + term, i + 1
        term = term * y / i
    low, high = total - 2 * abs(term), total + 2 * abs(term)
    for _ in range(j):
        low, high = low * low, high * high
    return low, high


def power_between(base: mpq, exponent: mpq) -> Bounds:
    """base^exponent for base > 0 and any rational exponent.

    >>> low, high = power_between(mpq(4), mpq(1, 2))
    >>> low <= 2 <= high and high - low < mpq(1, 2**80)
    True
    """
    low, high = log_bounds(mpq(base))
    ends = exponent * low, exponent * high
    return rounded(*exp_bounds(min(ends), max(ends)))


def shown(bounds: Bounds, digits: int = 9) -> str:
    """The bounds as decimals."""
    low, high = decimal_enclosure(*bounds, digits)
    return f"{low}..{high}"


def evaluated(f: Callable[[mpq], Bounds], at: mpq) -> str:
    """f(at) as decimals."""
    return shown(f(at))
