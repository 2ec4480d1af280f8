"""Rational numbers just below square roots, with integers only."""

from __future__ import annotations

from gmpy2 import isqrt, mpq, mpz


def sqrt_below(square: mpq, bits: int) -> mpq:
    """The largest number of `bits` significant bits that is at most the square root.

    Parameters
    ----------
    square : mpq
        A positive rational.
    bits : int
        At least 1.

    Returns
    -------
    mpq
        r = m 2^k with 2^(bits-1) <= m < 2^bits and r <= sqrt(square) < r (1 + 2^(1-bits)).

    >>> sqrt_below(mpq(2), 10)
    mpq(181,128)
    >>> sqrt_below(mpq(1, 9), 10)
    mpq(341,1024)
    """
    # floor(log2 square) is this or one less; either way one scaling of the two fits.
    exponent = square.numerator.bit_length() - square.denominator.bit_length()
    half = exponent // 2
    for shift in (bits - half, bits - half - 1, bits - half - 2):
        m = _floor_sqrt_scaled(square, shift)
        if m.bit_length() == bits:
            return mpq(m) / mpq(mpz(1) << shift) if shift >= 0 else mpq(m << -shift)
    raise ArithmeticError("unreachable: no scaling of the root has the wanted bits")


def _floor_sqrt_scaled(square: mpq, shift: int) -> mpz:
    """floor(2^shift sqrt(square)); shift may be negative."""
    if shift >= 0:
        return isqrt((square.numerator << (2 * shift)) // square.denominator)
    return isqrt(square.numerator // (square.denominator << (-2 * shift)))
