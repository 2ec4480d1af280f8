"""The threshold for an angle bound: exact, best possible, refused out of reach."""

from __future__ import annotations

from fractions import Fraction

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.exact.angle_bound import AngleBound, parse_angle_bound
from bern_exact.exact.angles import ANGLE_135, ANGLE_150
from bern_exact.theorems.stages import RefusedOption
from bern_exact.theorems.threshold import (
    DENOMINATORS,
    BoundOutOfReach,
    largest_angle_for,
    threshold_for,
)

KNOWN = {
    "150": mpq(1, 8),
    "cos:-1:3/4": mpq(1, 8),
    "149.1": mpq(1, 8),
    "cos:-1:25/34": mpq(1, 8),
    "149": mpq(46, 369),
    "140": mpq(43, 983),
    "136": mpq(5, 573),
    "135.2": mpq(1, 573),
    "135.115": mpq(1, 997),
}
"""Bounds, and the threshold for each."""


def thresholds() -> list[mpq]:
    """All p/q <= 1/8 with q <= 1000, the greatest first."""
    found = {mpq(p, q) for q in range(1, DENOMINATORS + 1) for p in range(1, q) if 8 * p <= q}
    return sorted(found, reverse=True)


def by_brute_force(bound: AngleBound) -> mpq:
    """The first of all thresholds that the bound admits."""
    return next(tau for tau in thresholds() if bound.admits(largest_angle_for(tau)))


@pytest.mark.parametrize("text", KNOWN)
def test_known_bounds(text: str) -> None:
    assert threshold_for(parse_angle_bound(text)) == KNOWN[text]


@pytest.mark.parametrize("text", ["149.03", "147.77", "140", "136", "135.2", "cos:-1:7/10"])
def test_no_better_fraction_exists(text: str) -> None:
    bound = parse_angle_bound(text)
    assert threshold_for(bound) == by_brute_force(bound)


@given(st.fractions("135.12", "150", max_denominator=10**6))
def test_the_bound_is_kept(degrees: Fraction) -> None:
    bound = parse_angle_bound(str(degrees))
    tau = threshold_for(bound)
    assert 0 < tau <= mpq(1, 8) and tau.denominator <= DENOMINATORS
    assert bound.admits(largest_angle_for(tau))


@given(st.lists(st.integers(135_120, 150_000), min_size=2, max_size=2))
def test_a_larger_angle_has_no_smaller_threshold(thousandths: list[int]) -> None:
    low, high = (parse_angle_bound(f"{t}/1000") for t in sorted(thousandths))
    assert threshold_for(low) <= threshold_for(high)


@given(st.integers(9, DENOMINATORS))
def test_an_angle_that_a_threshold_gives_exactly(denominator: int) -> None:
    tau = mpq(1, denominator)
    angle = largest_angle_for(tau)
    assert threshold_for(AngleBound("", None, angle)) == tau


@pytest.mark.parametrize(
    "text",
    ["0", "90", "134.9", "135", "cos:-1:1/2", "135.05", "135.11", "150.1", "180", "cos:-1:76/100"],
)
def test_out_of_reach(text: str) -> None:
    with pytest.raises(BoundOutOfReach) as caught:
        threshold_for(parse_angle_bound(text))
    assert text in str(caught.value) and isinstance(caught.value, RefusedOption)


@pytest.mark.parametrize("text", ["135", "135.05"])
def test_the_refusal_says_why(text: str) -> None:
    with pytest.raises(BoundOutOfReach, match="blocks alone need 135"):
        threshold_for(parse_angle_bound(text))


def test_the_angle_lies_between_135_and_150_degrees() -> None:
    angles = [largest_angle_for(tau).signed_square for tau in thresholds()]
    assert angles == sorted(angles)
    assert ANGLE_150.signed_square < angles[0] and angles[-1] < ANGLE_135.signed_square
