"""Shortened values say nothing that is not so."""

from __future__ import annotations

from fractions import Fraction

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.figures import DIGITS, digits_of, root, shortened
from tests.rationals import fractions


def ends(text: str) -> tuple[Fraction, Fraction]:
    """What the value may be, by the digits shown."""
    if text.startswith("["):
        first, last = text.strip("[]").split(", ")
        return ends(first)[0], ends(last)[1]
    if "..." not in text:
        return Fraction(text), Fraction(text)
    digits, _, exponent = text.partition("...")
    power = Fraction(10) ** int(exponent.lstrip("e") or "0")
    unit = Fraction(1, 10 ** len(digits.partition(".")[2]))
    outward = -unit if digits.startswith("-") else unit
    low, high = sorted((Fraction(digits), Fraction(digits) + outward))
    return low * power, high * power


@given(fractions, st.integers(-60, 60))
def test_the_digits_are_those_of_the_value(value: Fraction, exponent: int) -> None:
    scaled = value * Fraction(10) ** exponent
    low, high = ends(digits_of(mpq(scaled)))
    assert low <= scaled <= high


@given(fractions.filter(bool), st.integers(-60, 60))
def test_there_are_as_many_digits_as_promised(value: Fraction, exponent: int) -> None:
    scaled = value * Fraction(10) ** exponent
    low, high = ends(digits_of(mpq(scaled)))
    assert high - low <= abs(scaled) / 10 ** (DIGITS - 1)


@given(st.integers(1, 10**300), st.integers(1, 10**300))
def test_long_fractions_are_shown_by_their_first_digits(p: int, q: int) -> None:
    low, high = ends(digits_of(mpq(p, q)))
    assert low <= Fraction(p, q) <= high
    assert high - low <= Fraction(p, q) / 10 ** (DIGITS - 1)


@given(fractions.filter(bool).map(abs))
def test_a_root_squares_to_what_it_is_of(square: Fraction) -> None:
    low, high = ends(root(mpq(square)))
    assert low**2 <= square <= high**2


def test_what_is_exact_at_that_length_is_shown_exactly() -> None:
    assert digits_of(mpq(1, 8)) == "0.125"


@given(fractions.filter(bool))
def test_a_long_value_is_shortened(value: Fraction) -> None:
    text = str(value / 10**40)
    assert len(shortened(text)) < 40 + 2 * DIGITS


@pytest.mark.parametrize("text", ["no", "a word or two", "12"])
def test_what_is_short_or_no_number_stays(text: str) -> None:
    assert shortened(text) == text
