"""Heights and partners along a chain."""

from __future__ import annotations

from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.checkers.chords import Side
from bern_exact.convex.chains import Sigma
from bern_exact.convex.frame import convex_frame
from bern_exact.convex.records import Chain
from bern_exact.plane.polygon import Polygon
from tests.convex.polygons import convex_polygons

PARTS = st.fractions(0, 1, max_denominator=60).map(mpq)


@given(convex_polygons(), PARTS, st.integers(0, 1))
def test_partners_have_the_same_height_and_are_each_others(
    shape: Polygon, x: mpq, side: int
) -> None:
    sigma = Sigma(convex_frame(shape).chains[side])
    other = sigma.partner(x)
    if other is not None:
        assert sigma.height(other) == sigma.height(x)
        assert sigma.partner(other) == x


@given(convex_polygons(), PARTS, st.integers(0, 1))
def test_the_checkers_chain_says_the_same(shape: Polygon, x: mpq, side: int) -> None:
    chain = convex_frame(shape).chains[side]
    sigma, seen = Sigma(chain), Side(chain)
    assert sigma.height(x) == seen.height(x)
    assert sigma.partner(x) == seen.across(x)


def test_inside_a_flat_top_there_is_no_partner() -> None:
    thirds = Sigma(Chain((mpq(0), mpq(1, 3), mpq(2, 3), mpq(1)), (mpq(0), mpq(1), mpq(1), mpq(0))))
    assert thirds.partner(mpq(1, 2)) is None
    assert thirds.partner(mpq(1, 3)) == mpq(2, 3)
    assert thirds.partner(mpq(2, 3)) == mpq(1, 3)


def test_a_chain_that_is_the_diameter_has_no_partners() -> None:
    flat = Sigma(Chain((mpq(0), mpq(1)), (mpq(0), mpq(0))))
    assert flat.partner(mpq(1, 2)) is None
    assert flat.height(mpq(1, 2)) == 0
