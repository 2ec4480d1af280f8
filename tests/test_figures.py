"""Shortened values enclose what they stand for."""

from __future__ import annotations

from fractions import Fraction

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.figures import DIGITS, enclosed, shortened


def ends(text: str) -> tuple[Fraction, Fraction]:
    """The two ends of what people are shown."""
    parts = text.strip("[]").split(", ")
    return Fraction(parts[0]), Fraction(parts[-1])


@given(st.fractions())
def test_the_value_lies_between_the_ends(value: Fraction) -> None:
    low, high = ends(enclosed(mpq(value)))
    assert low <= value <= high


@given(st.fractions().filter(bool), st.integers(-60, 60))
def test_the_ends_are_a_unit_of_the_last_digit_apart(value: Fraction, exponent: int) -> None:
    scaled = value * Fraction(10) ** exponent
    low, high = ends(enclosed(mpq(scaled)))
    assert high - low <= abs(scaled) / 10 ** (DIGITS - 1)


def test_what_is_exact_at_that_length_is_shown_exactly() -> None:
    assert enclosed(mpq(1, 8)) == "0.125"


@given(st.fractions().filter(bool))
def test_a_long_value_is_shortened(value: Fraction) -> None:
    text = str(value / 10**40)
    assert len(shortened(text)) < 40 + 2 * DIGITS


@pytest.mark.parametrize("text", ["no", "a word or two", "12"])
def test_what_is_short_or_no_number_stays(text: str) -> None:
    assert shortened(text) == text
