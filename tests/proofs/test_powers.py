"""Bounds of logarithms and powers hold what they bound."""

from __future__ import annotations

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.exact.enclosures import power_bounds
from proofs.powers import log_bounds, power_between


@given(st.integers(1, 10**6), st.integers(1, 60), st.integers(1, 40))
def test_powers_agree_with_integer_roots(base: int, p: int, q: int) -> None:
    low, high = power_between(mpq(base), mpq(p, q) if p < 3 * q else mpq(1, q))
    exponent = mpq(p, q) if p < 3 * q else mpq(1, q)
    least, most = power_bounds(base, exponent, 40)
    assert low <= most and least <= high
    assert high - low < mpq(1, 2**20)


@given(st.integers(1, 1000), st.integers(1, 1000))
def test_logarithms_add(p: int, r: int) -> None:
    q = mpq(p, r)
    low, high = log_bounds(q)
    twice = log_bounds(q * q)
    assert twice[0] <= 2 * high and 2 * low <= twice[1]


@pytest.mark.parametrize("bad", [mpq(0), mpq(-1)])
def test_no_logarithm(bad: mpq) -> None:
    with pytest.raises(ValueError, match="positive"):
        log_bounds(bad)
