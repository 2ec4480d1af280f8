"""Similarities are exact maps of complex numbers, and are undone exactly."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from bern_exact.exact.angles import angle_at
from bern_exact.exact.points import coordinates
from bern_exact.exact.predicates import orientation, squared_distance
from bern_exact.exact.similarity import Similarity
from tests.exact.plain import Point, exactly, homogeneous, plain, points
from tests.rationals import fractions

Pair = tuple[Fraction, Fraction]

pairs = st.tuples(fractions, fractions)
alphas = pairs.filter(lambda pair: pair != (0, 0))


def similarity(alpha: Pair, tau: Pair) -> Similarity:
    return Similarity.of((exactly(alpha[0]), exactly(alpha[1])), (exactly(tau[0]), exactly(tau[1])))


similarities = st.builds(similarity, alphas, pairs)


@given(alphas, pairs, points)
def test_the_image_is_alpha_p_plus_tau(alpha: Pair, tau: Pair, p: Point) -> None:
    x, y = coordinates(similarity(alpha, tau).apply(homogeneous(p)))
    assert plain(x) == alpha[0] * p[0] - alpha[1] * p[1] + tau[0]
    assert plain(y) == alpha[1] * p[0] + alpha[0] * p[1] + tau[1]


@given(similarities, points)
def test_the_inverse_undoes_it(there: Similarity, p: Point) -> None:
    q = homogeneous(p)
    assert there.inverse().apply(there.apply(q)) == q
    assert there.apply(there.inverse().apply(q)) == q


@given(similarities, similarities, points)
def test_one_after_the_other(first: Similarity, second: Similarity, p: Point) -> None:
    q = homogeneous(p)
    assert first.then(second).apply(q) == second.apply(first.apply(q))


@given(similarities)
def test_there_and_back_is_nothing(there: Similarity) -> None:
    both = there.then(there.inverse())
    assert (both.a, both.b, both.u, both.v, both.d) == (1, 0, 0, 0, 1)


@given(similarities, points, points)
def test_squared_lengths_grow_by_the_squared_scale(m: Similarity, p: Point, q: Point) -> None:
    a, b = homogeneous(p), homogeneous(q)
    grown = squared_distance(m.apply(a), m.apply(b))
    assert grown == m.squared_scale * squared_distance(a, b)


@given(similarities, points, points, points)
def test_orientations_and_angles_stay(m: Similarity, p: Point, q: Point, r: Point) -> None:
    before = [homogeneous(x) for x in (p, q, r)]
    after = [m.apply(x) for x in before]
    assert orientation(*before) == orientation(*after)
    if q not in (p, r):
        assert angle_at(*before) == angle_at(*after)


@given(fractions)
def test_rotations_keep_lengths_and_have_the_tangent_of_the_half_angle(t: Fraction) -> None:
    turn = Similarity.rotation(exactly(t))
    assert turn.squared_scale == 1
    x, y = coordinates(turn.apply(homogeneous((Fraction(1), Fraction(0)))))
    assert y == exactly(t) * (1 + x)
