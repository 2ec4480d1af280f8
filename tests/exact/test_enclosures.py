"""Enclosures hold what they enclose, are as narrow as they say, and exact where they can be."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import mpmath
import pytest
from gmpy2 import mpq
from hypothesis import assume, given
from hypothesis import strategies as st

from bern_exact.exact.angles import Angle
from bern_exact.exact.enclosures import (
    arctan_bounds,
    cos_degrees_bounds,
    decimal_enclosure,
    degrees_bounds,
    degrees_enclosure,
    pi_bounds,
    power_bounds,
    sqrt_bounds,
    sqrt_enclosure,
)
from bern_exact.exact.numbers import parse_rational
from tests.rationals import fractions_between


def exactly(value: Fraction) -> mpq:
    return mpq(value.numerator, value.denominator)


def scaled(pair: tuple[Fraction, int]) -> mpq:
    return exactly(pair[0]) * mpq(10) ** pair[1]


def number(q: mpq) -> mpmath.mpf:
    return mpmath.mpf(int(q.numerator)) / int(q.denominator)


rationals = st.tuples(fractions_between(-50, 50), st.integers(-40, 40)).map(scaled)
positive = rationals.map(abs).filter(bool)
precisions = st.integers(1, 300)
digit_counts = st.integers(1, 40)
signs = st.sampled_from([-1, 1])
squares = st.one_of(
    fractions_between(0, 1).map(exactly),
    st.tuples(st.integers(1, 10**6), st.integers(7, 60)).map(lambda t: mpq(t[0]) / mpq(10) ** t[1]),
    st.tuples(st.integers(1, 10**6), st.integers(7, 60)).map(
        lambda t: 1 - mpq(t[0]) / mpq(10) ** t[1]
    ),
)


def is_within(value: mpmath.mpf, low: mpq, high: mpq) -> bool:
    """Is a value of 200 digits between two bounds, up to its own last digits?"""
    slack = abs(value) * mpmath.mpf(10) ** -180
    return number(low) <= value + slack and value - slack <= number(high)


@pytest.fixture(autouse=True, scope="module")
def _many_digits() -> Iterator[None]:
    with mpmath.workdps(200):
        yield


@given(positive, precisions)
def test_square_roots_lie_within_narrow_bounds(q: mpq, bits: int) -> None:
    low, high = sqrt_bounds(q, bits)
    assert low * low <= q <= high * high
    assert (high - low) * 2**bits <= low


@given(rationals, precisions)
def test_the_root_of_a_square_is_exact(q: mpq, bits: int) -> None:
    assert sqrt_bounds(q * q, bits) == (abs(q), abs(q))


def test_a_negative_number_has_no_root() -> None:
    with pytest.raises(ValueError, match="negative"):
        sqrt_bounds(mpq(-1), 10)


@given(positive, digit_counts)
def test_root_decimals_are_neighbours(q: mpq, digits: int) -> None:
    low, high = map(parse_rational, sqrt_enclosure(q, digits))
    assert low * low <= q <= high * high
    if low == high:
        assert low * low == q
    else:
        assert low * low < q < high * high
        # Neighbours of so many digits: apart by one unit of the last place.
        assert (high - low) * mpq(10) ** (digits - 1) <= low


@pytest.mark.parametrize(
    ("q", "text"), [("0", "0"), ("4", "2"), ("1/4", "0.5"), ("1e40", "100000000000000000000")]
)
def test_exact_roots_print_exactly(q: str, text: str) -> None:
    assert sqrt_enclosure(parse_rational(q)) == (text, text)


@pytest.mark.parametrize("exponent", [-10_000, -30, 30, 10_000])
def test_tiny_and_huge_roots_keep_their_digits(exponent: int) -> None:
    ends = sqrt_enclosure(2 * mpq(10) ** (2 * exponent), 6)
    low, high = (parse_rational(end) / mpq(10) ** exponent for end in ends)
    assert (low, high) == (mpq("1.41421".replace(".", "")) / 100_000, mpq(141_422, 100_000))


@given(precisions)
def test_pi(bits: int) -> None:
    low, high = pi_bounds(bits)
    assert is_within(+mpmath.pi, low, high)
    assert (high - low) * 2**bits <= 1


@given(rationals, precisions)
def test_arctangents_lie_within_narrow_bounds(q: mpq, bits: int) -> None:
    low, high = arctan_bounds(q, bits)
    assert is_within(mpmath.atan(number(q)), low, high)
    assert (high - low) * 2**bits <= abs(low)


@given(rationals, precisions)
def test_arctangent_is_odd(q: mpq, bits: int) -> None:
    low, high = arctan_bounds(q, bits)
    assert arctan_bounds(-q, bits) == (-high, -low)


@given(fractions_between(-1000, 1000).map(exactly), precisions)
def test_cosines_lie_within_narrow_bounds(degrees: mpq, bits: int) -> None:
    low, high = cos_degrees_bounds(degrees, bits)
    value = mpmath.cos(number(degrees) * mpmath.pi / 180)
    assert number(low) - mpmath.mpf(10) ** -180 <= value <= number(high) + mpmath.mpf(10) ** -180
    assert (high - low) * 2**bits <= 1


@pytest.mark.parametrize(
    ("degrees", "cosine"),
    [(0, 1), (60, (1, 2)), (90, 0), (120, (-1, 2)), (180, -1), (-300, (1, 2))],
)
def test_rational_cosines_are_exact(degrees: int, cosine: int | tuple[int, int]) -> None:
    value = mpq(*cosine) if isinstance(cosine, tuple) else mpq(cosine)
    assert cos_degrees_bounds(mpq(degrees), 20) == (value, value)


@pytest.mark.parametrize(
    ("sign", "square", "text"),
    [
        (1, mpq(1), "0"),
        (1, mpq(3, 4), "30"),
        (1, mpq(1, 2), "45"),
        (1, mpq(1, 4), "60"),
        (0, mpq(0), "90"),
        (-1, mpq(1, 4), "120"),
        (-1, mpq(1, 2), "135"),
        (-1, mpq(3, 4), "150"),
        (-1, mpq(1), "180"),
    ],
)
def test_rational_angles_are_exact(sign: int, square: mpq, text: str) -> None:
    assert degrees_enclosure(Angle(sign, square)) == (text, text)


@given(signs, squares, st.integers(1, 200))
def test_angles_lie_within_their_bounds(sign: int, square: mpq, bits: int) -> None:
    assume(square)
    low, high = degrees_bounds(Angle(sign, square), bits)
    value = mpmath.degrees(mpmath.acos(sign * mpmath.sqrt(number(square))))
    slack = mpmath.mpf(10) ** -60  # acos near 1 loses digits
    assert number(low) <= value + slack and value - slack <= number(high)
    assert (high - low) * 2**bits <= 90


@given(signs, squares, st.integers(1, 40))
def test_angle_decimals_are_neighbours(sign: int, square: mpq, places: int) -> None:
    assume(square not in (0, mpq(1, 4), mpq(1, 2), mpq(3, 4), 1))
    angle = Angle(sign, square)
    low, high = map(parse_rational, degrees_enclosure(angle, places))
    inner_low, inner_high = degrees_bounds(angle, 400)
    assert low < inner_low < inner_high < high
    assert (high - low) * mpq(10) ** places == 1


@given(signs, squares)
def test_complementary_angles_add_to_180(sign: int, square: mpq) -> None:
    assume(square)
    low, high = degrees_bounds(Angle(sign, square), 60)
    assert degrees_bounds(Angle(-sign, square), 60) == (180 - high, 180 - low)


@given(st.lists(squares.filter(bool), min_size=2, max_size=6), signs)
def test_enclosures_keep_the_order_of_angles(values: list[mpq], sign: int) -> None:
    angles = sorted((Angle(sign, q) for q in values), key=lambda a: -a.signed_square)
    lows = [parse_rational(degrees_enclosure(a)[0]) for a in angles]
    assert lows == sorted(lows)


@given(rationals, digit_counts)
def test_decimals_round_outwards_to_the_digits_asked(q: mpq, digits: int) -> None:
    texts = decimal_enclosure(q, q, digits)
    low, high = map(parse_rational, texts)
    assert low <= q <= high
    assert low == high or (high - low) * mpq(10) ** (digits - 1) <= max(abs(low), abs(high))
    for text in texts:
        shown = text.partition("e")[0].lstrip("-0.").replace(".", "").rstrip("0")
        assert len(shown) <= digits


@given(rationals)
def test_short_decimals_are_kept(q: mpq) -> None:
    short = parse_rational(decimal_enclosure(q, q, 5)[0])
    low, high = decimal_enclosure(short, short, 5)
    assert low == high and parse_rational(low) == short


def test_no_digits_are_refused() -> None:
    with pytest.raises(ValueError, match="at least one digit"):
        sqrt_enclosure(mpq(2), 0)


@given(st.integers(0, 10**6), st.integers(1, 40), st.integers(1, 40), st.integers(0, 40))
def test_powers_lie_between_their_bounds(base: int, over: int, under: int, bits: int) -> None:
    low, high = power_bounds(base, mpq(over, under), bits)
    exponent = mpq(over, under)
    power = mpq(base) ** int(exponent.numerator)
    degree = int(exponent.denominator)
    assert low**degree <= power <= high**degree
    assert high - low <= mpq(1, 2**bits)
    assert (low == high) == (low**degree == power)


@pytest.mark.parametrize(("base", "exponent"), [(-1, mpq(1)), (2, mpq(0)), (2, mpq(-1))])
def test_other_powers_are_refused(base: int, exponent: mpq) -> None:
    with pytest.raises(ValueError, match="natural"):
        power_bounds(base, exponent, 8)
