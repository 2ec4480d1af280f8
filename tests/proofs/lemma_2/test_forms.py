"""Affine forms contain what they stand for."""

from __future__ import annotations

from random import Random

import numpy as np
import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from proofs.lemma_2.forms import (
    ONE,
    Form,
    bounded,
    integer,
    is_positive,
    lowered,
    product,
    quotient,
)

SYMBOLS = range(3)

units = st.fractions(-1, 1, max_denominator=64)
coefficients = st.integers(-ONE, ONE)


@st.composite
def forms_with_values(draw: st.DrawFn) -> tuple[list[tuple[Form, mpq]], list[mpq]]:
    """Two forms over shared symbols, each with a value that it can have."""
    shared = [mpq(draw(units)) for _ in SYMBOLS]
    found = []
    for _ in range(2):
        c = draw(coefficients)
        size = draw(st.sampled_from((1, 2**4, 2**12, 2**20)))
        a = {i: draw(coefficients) // size for i in SYMBOLS if draw(st.booleans())}
        r = abs(draw(coefficients)) // size
        value = c + sum((v * shared[i] for i, v in a.items()), mpq(0)) + r * mpq(draw(units))
        arrays = {i: np.array([v], dtype=np.int64) for i, v in a.items()}
        found.append((Form(np.array([c], dtype=np.int64), arrays, np.array([r])), value / ONE))
    return found, shared


def contains(form: Form, value: mpq, shared: list[mpq], scale: int = ONE) -> bool:
    """Is this value one of the form's, for these values of the shared symbols?"""
    centre = int(form.c[0]) + sum((int(v[0]) * shared[i] for i, v in form.a.items()), mpq(0))
    return abs(value * scale - centre) <= int(np.broadcast_to(form.r, 1)[0])


@settings(max_examples=40)
@given(forms_with_values())
def test_sums_and_products(drawn: tuple[list[tuple[Form, mpq]], list[mpq]]) -> None:
    ((p, x), (q, y)), shared = drawn
    assert contains(p + q, x + y, shared)
    assert contains(p - q.times(3), x - 3 * y, shared)
    assert contains(product(p, q), x * y, shared, ONE * ONE)
    assert contains(product(p, p), x * x, shared, ONE * ONE)
    assert contains(lowered(product(p, q)), x * y, shared)


@settings(max_examples=40)
@given(forms_with_values(), st.integers(2, 4), st.booleans(), st.sampled_from((None, 2)))
def test_quotients(
    drawn: tuple[list[tuple[Form, mpq]], list[mpq]], size: int, flip: bool, symbol: int | None
) -> None:
    ((p, x), (q, y)), shared = drawn
    q, y = q.plus(size * ONE), y + size
    if flip:
        q, y = q.times(-1), -y
    if y == 0 or abs(x / y) > 4:
        return
    if symbol is not None:  # a symbol that nothing else has
        symbol, shared = 3, [*shared, x / y / 4]
    assert contains(quotient(p, q, -4 * ONE, 4 * ONE, symbol), x / y, shared)


def test_a_quotient_by_what_may_be_0_is_between_its_bounds() -> None:
    zero = Form(np.array([0]), {0: np.array([ONE])}, np.array([0]))
    found = quotient(integer(1), zero, ONE, 3 * ONE, None)
    assert (int(found.c[0]), int(found.r[0])) == (2 * ONE, ONE)


@pytest.mark.parametrize(("c", "r", "positive"), [(5, 4, True), (4, 4, False), (-9, 1, False)])
def test_positive_is_meant_strictly(c: int, r: int, positive: bool) -> None:
    assert bool(is_positive(Form(c, {}, r))) == positive


def test_what_is_too_large_is_found() -> None:
    assert bool(bounded(Form(7 * ONE, {0: ONE}, 0))) and not bool(
        bounded(Form(7 * ONE, {0: ONE}, 1))
    )


def test_no_product_of_bounded_forms_overflows() -> None:
    random = Random("overflow")
    for _ in range(50):
        split = random.randrange(8 * ONE)
        sides = [Form(np.array([8 * ONE - split]), {0: np.array([split])}, 0)] * 2
        along = product(sides[0], (sides[1].times(16) + sides[1].times(16)))
        exact = 32 * ((8 * ONE - split) ** 2 + split * split // 2)
        assert abs(int((along + along).c[0]) - 2 * exact) <= 64
