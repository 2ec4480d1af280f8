"""Certified enclosures of what is irrational: square roots, angles, pi, cosines.

`*_bounds` return rationals, `*_enclosure` decimal texts for people.  Every bound is proved:
integers are rounded outwards, and each series alternates with falling terms, so that what is left
out is at most the first term of it.

Fixed point: an integer m stands for m / 2^p.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

from gmpy2 import iroot, isqrt, mpq, mpz

from bern_exact.exact.angles import Angle
from bern_exact.exact.numbers import MAX_EXPONENT

Interval = tuple[mpz, mpz]
"""A lower and an upper end, in fixed point."""

_RATIONAL_DEGREES = {mpq(0): 90, mpq(1, 4): 60, mpq(1, 2): 45, mpq(3, 4): 30, mpq(1): 0}
"""Squared cosine -> degrees, for the angles up to 90 where both are rational.

If cos^2 a is rational, so is cos 2a; by Niven's theorem 2a, if a rational number of degrees, is
then a multiple of 60 or of 90.  No other angle of a mesh is any decimal number of degrees.
"""

_PLAIN_EXPONENTS = range(-6, 22)
"""Exponents of the first digit for which a decimal is written without `e`."""


def _down(q: mpq, p: int) -> mpz:
    """floor(q 2^p)."""
    if p < 0:
        return q.numerator // (q.denominator << -p)
    return (q.numerator << p) // q.denominator


def _up(q: mpq, p: int) -> mpz:
    """ceil(q 2^p)."""
    return -_down(-q, p)


def _unscaled(m: mpz, p: int) -> mpq:
    """m / 2^p."""
    return mpq(m, mpz(1) << p) if p >= 0 else mpq(m << -p)


def _magnitude(q: mpq) -> int:
    """An integer e with 2^(e-1) < q < 2^(e+1), for q > 0."""
    return q.numerator.bit_length() - q.denominator.bit_length()


def sqrt_bounds(q: mpq, bits: int) -> tuple[mpq, mpq]:
    """Rationals around the square root of q >= 0, equal if it is rational.

    Parameters
    ----------
    q : mpq
        The square.
    bits : int
        The bounds differ by at most 2^-bits times the root.

    Raises
    ------
    ValueError
        q is negative.

    >>> sqrt_bounds(mpq(4, 9), 10)
    (mpq(2,3), mpq(2,3))
    >>> sqrt_bounds(mpq(2), 10)
    (mpq(181,128), mpq(2897,2048))
    """
    if q < 0:
        raise ValueError("a negative number has no real square root")
    numerator, denominator = isqrt(q.numerator), isqrt(q.denominator)
    if numerator * numerator == q.numerator and denominator * denominator == q.denominator:
        root = mpq(numerator, denominator)
        return root, root
    p = bits + 1 - _magnitude(q) // 2
    m = isqrt(_down(q, 2 * p))
    return _unscaled(m, p), _unscaled(m + 1, p)


@lru_cache(maxsize=1 << 14)
def power_bounds(base: int, exponent: mpq, bits: int) -> tuple[mpq, mpq]:
    """Rationals at most 2^-bits apart around base^exponent, equal if it is such a fraction.

    Parameters
    ----------
    base : int
        At least 0.
    exponent : mpq
        Positive, of small terms: p/q takes the integer q-th root of base^p 2^(q bits).

    Raises
    ------
    ValueError
        The base is negative or the exponent is not positive.

    >>> power_bounds(8, mpq(2, 3), 4), power_bounds(2, mpq(1, 2), 4)
    ((mpq(4,1), mpq(4,1)), (mpq(11,8), mpq(23,16)))
    """
    if base < 0 or exponent <= 0:
        raise ValueError("a power of a natural number with a positive exponent is wanted")
    degree = int(exponent.denominator)
    root, exact = iroot((mpz(base) ** int(exponent.numerator)) << (degree * bits), degree)
    return _unscaled(root, bits), _unscaled(root if exact else root + 1, bits)


def _alternating(
    first: Interval,
    square: Interval,
    p: int,
    step: Callable[[int], int],
    weight: Callable[[int], int],
) -> Interval:
    """Bounds of sum (-1)^k a_k / weight(k), where a_0 = first, a_(k+1) = a_k square / step(k).

    The terms must fall.  It ends at a term below 2^-p, which bounds all that is left out.
    """
    low, high = mpz(0), mpz(0)
    a, b = first
    k = 0
    while b > 1:
        term_low, term_high = a // weight(k), -(-b // weight(k))
        if k % 2 == 0:
            low, high = low + term_low, high + term_high
        else:
            low, high = low - term_high, high - term_low
        a = a * square[0] // (step(k) << p)
        b = -(-b * square[1] // (step(k) << p))
        k += 1
    return low - 1, high + 1


def _squared(x: Interval, p: int) -> Interval:
    """The square of an interval that is not negative."""
    return x[0] * x[0] >> p, -(-x[1] * x[1] >> p)


def _guarded(bits: int) -> int:
    """Bits enough for the rounding of all terms of a series of `bits` bits."""
    return bits + bits.bit_length() + 12


def _arctan_fixed(q: mpq, p: int) -> Interval:
    """Bounds of arctan q, 0 <= q <= 1/2: q - q^3/3 + q^5/5 - ..."""
    x = (_down(q, p), _up(q, p))
    return _alternating(x, _squared(x, p), p, lambda k: 1, lambda k: 2 * k + 1)


@lru_cache(maxsize=32)
def pi_bounds(bits: int) -> tuple[mpq, mpq]:
    """Rationals at most 2^-bits apart around pi = 16 arctan(1/5) - 4 arctan(1/239) (Machin).

    >>> low, high = pi_bounds(20)
    >>> low < mpq("3.14159266") and high > mpq("3.14159265")
    True
    """
    p = _guarded(bits)
    fifth, small = _arctan_fixed(mpq(1, 5), p), _arctan_fixed(mpq(1, 239), p)
    low, high = 16 * fifth[0] - 4 * small[1], 16 * fifth[1] - 4 * small[0]
    return _unscaled(low, p), _unscaled(high, p)


def arctan_bounds(q: mpq, bits: int) -> tuple[mpq, mpq]:
    """Rationals around arctan q in radians, at most 2^-bits |arctan q| apart; equal for q = 0.

    Beyond 1/2 by arctan q = pi/4 - arctan((1 - q)/(1 + q)) and arctan q = pi/2 - arctan(1/q).
    """
    if q < 0:
        low, high = arctan_bounds(-q, bits)
        return -high, -low
    if q == 0:
        return mpq(0), mpq(0)
    if 2 * q > 1:
        part, rest = (mpq(1, 2), 1 / q) if q > 1 else (mpq(1, 4), (1 - q) / (1 + q))
        turn, other = pi_bounds(bits + 3), arctan_bounds(rest, bits + 3)
        return part * turn[0] - other[1], part * turn[1] - other[0]
    p = _guarded(bits) - _magnitude(q)  # a small q has small bounds
    small_low, small_high = _arctan_fixed(q, p)
    return _unscaled(small_low, p), _unscaled(small_high, p)


def cos_degrees_bounds(degrees: mpq, bits: int) -> tuple[mpq, mpq]:
    """Rationals at most 2^-bits apart around the cosine of an angle in degrees.

    Equal where the cosine is rational: at the multiples of 60 and of 90 degrees.

    >>> cos_degrees_bounds(mpq(-240), 10)
    (mpq(-1,2), mpq(-1,2))
    """
    degrees = abs(degrees) % 360
    if degrees > 180:
        degrees = 360 - degrees
    if degrees > 90:
        low, high = cos_degrees_bounds(180 - degrees, bits)
        return -high, -low
    exact = {0: mpq(1), 60: mpq(1, 2), 90: mpq(0)}
    if degrees in exact:
        return exact[int(degrees)], exact[int(degrees)]
    p = _guarded(bits)
    ends = (
        _trigonometric(degrees, p, cosine=True)
        if degrees <= 45
        else (_trigonometric(90 - degrees, p, cosine=False))
    )
    return _unscaled(ends[0], p), _unscaled(ends[1], p)


def _trigonometric(degrees: mpq, p: int, *, cosine: bool) -> Interval:
    """Bounds of the cosine or the sine of 0 to 45 degrees, by their series."""
    pi = pi_bounds(p)
    x = (_down(degrees * pi[0] / 180, p), _up(degrees * pi[1] / 180, p))
    one = mpz(1) << p
    first, shift = ((one, one), 1) if cosine else (x, 2)
    return _alternating(
        first, _squared(x, p), p, lambda k: (2 * k + shift) * (2 * k + shift + 1), lambda k: 1
    )


def degrees_bounds(angle: Angle, bits: int) -> tuple[mpq, mpq]:
    """Rationals around an angle in degrees, equal if that is rational.

    They are at most about 2^-bits apart times the angle, or times 90 if it is more than 45.
    """
    if angle.cos_sign < 0:
        low, high = degrees_bounds(Angle(1, angle.cos_squared), bits)
        return 180 - high, 180 - low
    square = angle.cos_squared
    if square in _RATIONAL_DEGREES:
        exact = mpq(_RATIONAL_DEGREES[square])
        return exact, exact
    if 2 * square < 1:
        low, high = degrees_bounds(Angle(1, 1 - square), bits)
        return 90 - high, 90 - low
    tangent = sqrt_bounds((1 - square) / square, bits + 2)
    pi = pi_bounds(bits + 2)
    low = arctan_bounds(tangent[0], bits + 2)[0]
    high = arctan_bounds(tangent[1], bits + 2)[1]
    return 180 * low / pi[1], 180 * high / pi[0]


def sqrt_enclosure(q: mpq, digits: int = 12) -> tuple[str, str]:
    """The neighbouring decimals of so many significant digits around a square root.

    Equal if the root is such a decimal.

    >>> sqrt_enclosure(mpq(2), 6), sqrt_enclosure(mpq(1, 4))
    (('1.41421', '1.41422'), ('0.5', '0.5'))
    """
    return _tight(lambda bits: sqrt_bounds(q, bits), digits)


def degrees_enclosure(angle: Angle, places: int = 9) -> tuple[str, str]:
    """The neighbouring decimals of so many places after the point around an angle in degrees.

    Equal for 0, 30, 45, 60, 90, 120, 135, 150 and 180 degrees, and for no other angle.

    >>> degrees_enclosure(Angle(-1, mpq(3, 4))), degrees_enclosure(Angle(-1, mpq(9, 25)))
    (('150', '150'), ('126.869897645', '126.869897646'))
    """
    unit = 10**places
    low, high, bits = 0, 2, 4 * places + 16
    while high - low > 1:  # ends, as an irrational angle lies strictly between neighbours
        ends = degrees_bounds(angle, bits)
        low, high = int(_floor(ends[0] * unit)), -int(_floor(-ends[1] * unit))
        bits *= 2
    return _in_places(low, places), _in_places(high, places)


def _floor(q: mpq) -> mpz:
    """The greatest integer that is at most q."""
    return q.numerator // q.denominator


def _in_places(scaled: int, places: int) -> str:
    """The decimal scaled / 10^places, scaled >= 0."""
    whole, part = divmod(scaled, 10**places)
    return f"{whole}.{part:0{places}}".rstrip("0").rstrip(".")


def decimal_enclosure(low: mpq, high: mpq, digits: int = 12) -> tuple[str, str]:
    """Decimals of so many significant digits, the greatest below `low`, the least above `high`.

    >>> decimal_enclosure(mpq(1, 3), mpq(1, 3), 4), decimal_enclosure(mpq(-5, 2), mpq(10**30))
    (('0.3333', '0.3334'), ('-2.5', '1e30'))
    """
    return _rounded(low, digits, up=False), _rounded(high, digits, up=True)


def _tight(bounds: Callable[[int], tuple[mpq, mpq]], digits: int) -> tuple[str, str]:
    """Neighbouring decimals around a number that is rational or no decimal at all.

    Refined until both bounds round down to the same decimal, which an irrational number's do.
    """
    if digits < 1:
        raise ValueError("an enclosure has at least one digit")
    bits = 4 * digits + 8
    while True:
        low, high = bounds(bits)
        if low == high or _rounded(low, digits, up=False) == _rounded(high, digits, up=False):
            return decimal_enclosure(low, high, digits)
        bits *= 2


def _rounded(q: mpq, digits: int, *, up: bool) -> str:
    """A rational rounded up or down to so many significant digits."""
    if q == 0:
        return "0"
    if q < 0:
        return "-" + _rounded(-q, digits, up=not up)
    exponent = _decimal_exponent(q) - digits + 1
    scaled = q / _power_of_ten(exponent)
    mantissa = (
        -(-scaled.numerator // scaled.denominator) if up else scaled.numerator // scaled.denominator
    )
    return _decimal_text(mantissa, exponent)


def _power_of_ten(exponent: int) -> mpq:
    """10^exponent."""
    return mpq(10) ** exponent


def _decimal_exponent(q: mpq) -> int:
    """The exponent e of the first digit: 10^e <= q < 10^(e+1), for q > 0."""
    exponent = q.numerator.num_digits() - q.denominator.num_digits()  # right to within 2
    while _power_of_ten(exponent) > q:
        exponent -= 1
    while _power_of_ten(exponent + 1) <= q:
        exponent += 1
    return exponent


def _decimal_text(mantissa: mpz, exponent: int) -> str:
    """The shortest text of mantissa 10^exponent; `parse_rational` reads all of them."""
    every = mantissa.digits()
    text = every.rstrip("0")
    exponent += len(every) - len(text)
    first = exponent + len(text) - 1
    if first not in _PLAIN_EXPONENTS and abs(first) <= MAX_EXPONENT:
        return f"{text[0]}{'.' if len(text) > 1 else ''}{text[1:]}e{first}"
    if exponent >= 0:
        return text + "0" * exponent
    if first >= 0:
        return f"{text[: first + 1]}.{text[first + 1 :]}"
    return "0." + "0" * (-first - 1) + text
