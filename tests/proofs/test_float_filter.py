"""The proof's computable parts hold, and the filters do what it says."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.oracle import filters
from bern_exact.oracle.filters import (
    Ball,
    cotangent_bounds,
    difference,
    doubles_around,
    rounding_of_product,
    signs_of_two_products,
)
from proofs import float_filter
from tests.rationals import few_fractions, fractions, fractions_between

tame = st.one_of(
    st.just(0.0),
    st.floats(2.0**-100, 2.0**100),
    st.floats(-(2.0**100), -(2.0**-100)),
    st.integers(-50, 50).map(float),
    st.integers(-(2**53), 2**53).map(float),
)
parts = few_fractions(-1, 1, 8)


@st.composite
def held(draw: st.DrawFn) -> tuple[Ball, Fraction]:
    """A ball, and a number that it holds, often at its very end."""
    value = draw(tame)
    radius = abs(value) * draw(st.sampled_from([0.0, 2.0**-53, 2.0**-52, 2.0**-20, 0.5, 2.0]))
    x = Fraction(value) + draw(parts) * Fraction(radius)
    return Ball(np.array([value]), np.array([radius])), x


def holds(ball: Ball, x: Fraction) -> bool:
    value, radius = float(ball.value[0]), float(ball.radius[0])
    if not np.isfinite(value) or not np.isfinite(radius):
        return True
    return abs(x - Fraction(value)) <= Fraction(radius)


@pytest.mark.parametrize("statement, is_true", list(float_filter.claims()))
def test_the_proofs_claims_hold(statement: str, is_true: bool) -> None:
    assert is_true, statement


@given(held(), held())
def test_balls_hold_the_results(first: Any, second: Any) -> None:
    (a, x), (b, y) = first, second
    assert holds(a + b, x + y) and holds(a - b, x - y) and holds(a * b, x * y)
    assert holds(-a, -x) and holds(a.size(), abs(x)) and holds(a.least(b), min(x, y))
    with np.errstate(all="ignore"):
        quotient = a.over(b)
    if np.isfinite(quotient.radius[0]):
        assert y != 0 and holds(quotient, x / y)
        assert Fraction(float(quotient.low()[0])) <= x / y <= Fraction(float(quotient.high()[0]))


@given(held(), held())
def test_signs_are_told_where_they_are_certain(first: Any, second: Any) -> None:
    (a, x), (b, y) = first, second
    for ball, number in ((a, x), (a - b, x - y), (a * b, x * y)):
        (sign,) = ball.signs().tolist()
        assert sign == filters.UNDECIDED or sign == (number > 0) - (number < 0)


@given(tame, tame)
def test_the_rounding_errors_are_exact(x: float, y: float) -> None:
    a, b = np.array([x]), np.array([y])
    ball = difference(a, b)
    assert abs(Fraction(x) - Fraction(y) - Fraction(float(ball.value[0]))) == Fraction(
        float(ball.radius[0])
    )
    error = float(rounding_of_product(a, b, a * b)[0])
    assert Fraction(x) * Fraction(y) == Fraction(x * y) + Fraction(error)


@given(tame, tame, tame, tame, st.booleans())
def test_signs_of_two_products(x: float, y: float, z: float, w: float, near: bool) -> None:
    if near and y:  # x y against itself, up to an ulp
        z, w = -x, float(np.nextafter(y, w))
    exact = Fraction(x) * Fraction(y) + Fraction(z) * Fraction(w)
    (sign,) = signs_of_two_products(*(np.array([v]) for v in (x, y, z, w))).tolist()
    assert sign == (exact > 0) - (exact < 0)


@given(fractions, st.integers(-1200, 1200))
def test_doubles_around_a_rational(x: Fraction, power: int) -> None:
    x *= Fraction(2) ** power
    low, high = doubles_around(mpq(x.numerator, x.denominator), mpq(x.numerator, x.denominator))
    assert low == -np.inf or Fraction(low) <= x
    assert high == np.inf or x <= Fraction(high)
    with np.errstate(over="ignore"):
        assert high <= np.nextafter(np.nextafter(low, np.inf), np.inf)


@given(fractions_between(-1, 1))
def test_cotangents_are_between_their_bounds(square: Fraction) -> None:
    s = mpq(square.numerator, square.denominator)
    low, high = cotangent_bounds(s, s)
    assert low <= high
    if abs(square) < 1:
        ratio = square / (1 - abs(square))  # cot |cot|
        assert Fraction(low) * abs(Fraction(low)) <= ratio <= Fraction(high) * abs(Fraction(high))
        assert high - low <= abs(high) * 2.0**-50
    else:
        assert low == high == float("inf") * int(square)


@pytest.mark.parametrize("name, value", [("ROUNDING", 2.0**-55), ("GROWTH", 1 - 2.0**-50)])
def test_a_smaller_constant_would_be_found(
    name: str, value: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Both in the proof and by trying."""
    monkeypatch.setattr(filters, name, value)
    monkeypatch.setattr(float_filter, name, value)
    assert not all(is_true for _, is_true in float_filter.claims())
    random = np.random.default_rng(5)
    x, y = random.uniform(1, 2, (2, 20_000))
    x[0], y[0] = 1 + 2.0**-52, 1 - 2.0**-53  # the product is just below the middle of two doubles
    zero = np.zeros_like(x)
    wrong = 0
    for a, b in ((Ball(x, zero), Ball(y, zero)), (Ball(x, x * 2.0**-30), Ball(y, y * 2.0**-30))):
        product, total = a * b, a + b
        for i in range(0, len(x), 10):
            p, q = (Fraction(v.value[i]) + Fraction(v.radius[i]) for v in (a, b))
            for ball, exact in ((product, p * q), (total, p + q)):
                gap = abs(exact - Fraction(float(ball.value[i])))
                wrong += gap > Fraction(float(ball.radius[i]))
    assert wrong
