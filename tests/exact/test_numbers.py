"""Rationals as text: what is read, what is refused, what is written."""

from __future__ import annotations

import sys
from fractions import Fraction

import pytest
from gmpy2 import mpq, mpz
from hypothesis import assume, given
from hypothesis import strategies as st

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import (
    MAX_DIGITS,
    MAX_EXPONENT,
    JsonNumber,
    format_rational,
    nearest_binary64,
    parse_rational,
    rational_from_json,
)
from tests.rationals import fractions

rationals = fractions
decimals = st.from_regex(r"[+-]?[0-9]{1,25}\.[0-9]{0,25}(?:[eE][+-]?[0-9]{1,2})?", fullmatch=True)


def exactly(value: Fraction) -> mpq:
    return mpq(value.numerator, value.denominator)


@given(rationals)
def test_what_is_written_is_read_back(value: Fraction) -> None:
    assert parse_rational(format_rational(exactly(value))) == exactly(value)


@given(rationals)
def test_the_text_is_that_of_fractions(value: Fraction) -> None:
    assert format_rational(exactly(value)) == str(value)


@given(rationals, st.integers(1, 10**9))
def test_fractions_are_read_in_any_terms(value: Fraction, factor: int) -> None:
    text = f"{value.numerator * factor}/{value.denominator * factor}"
    assert parse_rational(text) == exactly(value)


@given(decimals)
def test_a_decimal_is_exactly_that_decimal(text: str) -> None:
    assert parse_rational(text) == exactly(Fraction(text))


@pytest.mark.parametrize(
    "text", ["5.", ".5", "+.5e1", "1E3", "-0.0", "00012", "+3", "0/5", "007/02"]
)
def test_every_allowed_form_is_read(text: str) -> None:
    assert parse_rational(text) == exactly(Fraction(text if text != "5." else "5"))


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_binary64_reads_back_every_printed_double(value: float) -> None:
    text = f"{value:.17e}"
    assert parse_rational(text, binary64=True) == exactly(Fraction(value))


@given(st.text("0123456789", min_size=1, max_size=40), st.integers(-400, 330))
def test_binary64_rounds_decimals_as_the_machine_does(digits: str, exponent: int) -> None:
    text = f"{digits}e{exponent}"
    assume(float(text) != float("inf"))
    assert parse_rational(text, binary64=True) == exactly(Fraction(float(text)))


@given(st.integers(0, 2**53 - 1), st.integers(-1080, 971), st.sampled_from([-1, 1]))
def test_ties_go_to_the_even_double(mantissa: int, exponent: int, sign: int) -> None:
    tie = Fraction(sign * (2 * mantissa + 1)) * Fraction(2) ** (exponent - 1)
    try:
        expected = exactly(Fraction(float(tie)))
    except OverflowError:
        with pytest.raises(InputError):
            nearest_binary64(exactly(tie))
    else:
        assert nearest_binary64(exactly(tie)) == expected


@pytest.mark.parametrize("text", ["9007199254740993", "1/3"])
def test_binary64_leaves_integers_and_fractions(text: str) -> None:
    assert parse_rational(text, binary64=True) == mpq(text)


def test_binary64_refuses_what_would_be_infinite() -> None:
    largest = int(sys.float_info.max)
    assert parse_rational(f"{largest}.0", binary64=True) == largest
    with pytest.raises(InputError, match="beyond the largest"):
        parse_rational("1.8e308", binary64=True)


REFUSED = [
    *(
        "",
        " ",
        " 1",
        "1 ",
        "1\n",
        "abc",
        "1_000",
        "1,5",
        "--1",
        "+-1",
        "0x10",
        "1e",
        "e5",
        ".",
        "-",
    ),
    *("1/", "/2", "1/-2", "1/+2", "1/2/3", "1.5/2", "1/2.5", "1e5/2", "1 /2", "1/0", "-7/000"),
    *("nan", "NaN", "-nan", "inf", "-Infinity", "١٢", "²", "½", "−1", "1e5.5", "1\0", "\ud800"),  # noqa: RUF001
    *("1e10001", "1e-10001", "1e999999999", "0e99999", "1e" + "9" * 50_000),
    *("9" * 100_001, "1/" + "9" * 100_001, "0." + "1" * 100_000, "9" * 10_000_000),
]


@pytest.mark.parametrize("text", REFUSED, ids=lambda t: ascii(t)[:24])
def test_all_else_is_refused(text: str) -> None:
    with pytest.raises(InputError) as refusal:
        parse_rational(text)
    assert refusal.value.kind == "number"
    assert len(refusal.value.message) < 200


def test_the_limits_themselves_are_read() -> None:
    assert parse_rational("9" * MAX_DIGITS) == mpz(10) ** MAX_DIGITS - 1
    assert parse_rational(f"1e{MAX_EXPONENT}") == mpz(10) ** MAX_EXPONENT
    assert parse_rational(f"1e-000{MAX_EXPONENT}") * mpz(10) ** MAX_EXPONENT == 1
    assert format_rational(parse_rational("-" + "7" * MAX_DIGITS)) == "-" + "7" * MAX_DIGITS


@given(st.text())
def test_any_text_is_read_or_refused(text: str) -> None:
    try:
        value = parse_rational(text)
    except InputError as error:
        assert error.kind == "number"
    else:
        assert parse_rational(format_rational(value)) == value


@pytest.mark.parametrize("value", [True, False, None, [], {}, [1], 0.5, float("nan"), object()])
def test_what_is_no_number_in_json_is_refused_with_its_path(value: object) -> None:
    with pytest.raises(InputError) as refusal:
        rational_from_json(value, "$.outer[3][0]")
    assert refusal.value.kind == "number"
    assert refusal.value.where == {"path": "$.outer[3][0]"}


@pytest.mark.parametrize("value", [3, "3", "6/2", JsonNumber("3.0"), "0.3e1"])
def test_strings_and_bare_numbers_are_read_alike(value: object) -> None:
    assert rational_from_json(value, "$") == 3


def test_a_bad_text_in_json_is_refused_with_its_path() -> None:
    with pytest.raises(InputError) as refusal:
        rational_from_json("1/0", "$.holes[0][2][1]")
    assert refusal.value.where == {"path": "$.holes[0][2][1]"}
    assert "$.holes[0][2][1]" in refusal.value.message
