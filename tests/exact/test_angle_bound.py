"""Bounds on angles are decided as the lone judge decides them, and as they must be."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from gmpy2 import mpq, mpz
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.exact.angle_bound import parse_angle_bound, signed_square_bounds
from bern_exact.exact.angles import Angle
from bern_exact.exact.enclosures import degrees_bounds, degrees_enclosure
from bern_exact.exact.errors import InputError
from bern_exact.oracle import judge as lone
from tests.rationals import many_fractions

squares = many_fractions(-1, 1, 10**6)
degrees = many_fractions(0, 180, 10**4)


def angle(square: Fraction) -> Angle:
    return Angle((square > 0) - (square < 0), mpq(abs(square).numerator, abs(square).denominator))


@given(squares, degrees)
def test_the_judges_agree(square: Fraction, bound: Fraction) -> None:
    text = str(bound)
    assert parse_angle_bound(text).admits(angle(square)) != lone.angle_bound(text)(square)


@given(squares)
def test_the_judges_show_the_same_degrees(square: Fraction) -> None:
    assert list(degrees_enclosure(angle(square))) == lone.angle(square)["degrees"]


@given(squares)
def test_the_degrees_shown_enclose_the_angle(square: Fraction) -> None:
    low, high = degrees_enclosure(angle(square))
    assert parse_angle_bound(high).admits(angle(square))
    assert low == high or not parse_angle_bound(low).admits(angle(square))
    assert Fraction(high) - Fraction(low) in (0, Fraction(1, 10**9))


@given(squares, st.integers(1, 300))
def test_the_enclosures_of_both_judges_overlap(square: Fraction, bits: int) -> None:
    low, high = degrees_bounds(angle(square), bits)
    other_low, other_high = lone.in_degrees(square, bits)
    assert 0 <= other_low <= other_high <= 180
    assert Fraction(str(low)) <= other_high and other_low <= Fraction(str(high))


@given(degrees)
def test_bounds_in_degrees_are_enclosed_tightly(bound: Fraction) -> None:
    low, high = signed_square_bounds(mpq(bound.numerator, bound.denominator), 64)
    assert low <= high and high - low <= mpq(1, 2**63)
    assert (low == high) == (bound % 30 == 0 or bound % 45 == 0)
    assert low == high or not lone.is_above(Fraction(str(high)), bound)
    assert low == high or lone.is_above(Fraction(str(low)), bound)


@pytest.mark.parametrize("whole", [0, 30, 45, 60, 90, 120, 135, 150, 180])
def test_multiples_of_30_and_45_are_exact(whole: int) -> None:
    bound = parse_angle_bound(str(whole))
    assert bound.angle is not None
    assert bound.admits(bound.angle)
    assert degrees_enclosure(bound.angle) == (str(whole), str(whole))
    square = bound.angle.signed_square
    if square < 1:
        tiny = mpq(1, 10**400)
        assert bound.admits(angle(Fraction(str(square + tiny))))
    if square > -1:
        assert not bound.admits(angle(Fraction(str(square - mpq(1, 10**400)))))


@given(st.integers(-(10**6), 10**6), st.integers(1, 10**6), degrees)
def test_corners_are_judged_by_their_angles(dot: int, cross: int, bound: Fraction) -> None:
    square = Fraction(dot * abs(dot), dot * dot + cross * cross)
    limit = parse_angle_bound(str(bound))
    assert limit.admits_corner(mpz(dot), mpz(cross)) == limit.admits(angle(square))


@pytest.mark.parametrize("dot", [-(10**40), -1, 0, 1, 10**40])
def test_bounds_next_to_0_and_180_degrees(dot: int) -> None:
    tiny, wide = parse_angle_bound("1e-30"), parse_angle_bound("179." + "9" * 30)
    assert tiny.admits_corner(mpz(dot), mpz(1)) == (dot == 10**40)
    assert wide.admits_corner(mpz(dot), mpz(1)) == (dot > -(10**40))


def test_a_bound_is_refined_until_it_decides() -> None:
    """Bounds a hair below and above an angle that is no multiple of anything."""
    square = Fraction(-9, 25)
    low, high = Fraction(126), Fraction(127)
    for _ in range(900):  # bisect the angle far beyond 64 bits
        middle = (low + high) / 2
        low, high = (middle, high) if lone.is_above(square, middle) else (low, middle)
        if high - low < Fraction(1, 2**300):
            break
    tell = [parse_angle_bound(str(end)).admits(angle(square)) for end in (low, high)]
    assert tell == [False, True]


def test_many_triangles_against_many_bounds() -> None:
    rng = random.Random(7)
    for _ in range(300):
        square = Fraction(rng.randint(-1000, 1000), 1000)
        text = f"{rng.randint(0, 179)}.{rng.randint(0, 999)}"
        assert parse_angle_bound(text).admits(angle(square)) != lone.angle_bound(text)(square)


@pytest.mark.parametrize(
    "text",
    ["", "x", "-1", "180.0001", "nan", "1e5", "cos:", "cos:1", "cos:2:1/4", "cos:0:1/4", "cos:1:0"]
    + ["cos:1:5/4", "cos:+1:1/4", "cos:-1:-1/4", "9" * 2_000, "0." + "1" * 2_000],
)
def test_what_is_no_bound_is_refused(text: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_angle_bound(text)
    assert caught.value.kind == "number"
    with pytest.raises(lone.Unreadable):
        lone.angle_bound(text)
