"""Homogeneous points are what their fractions are."""

from __future__ import annotations

from fractions import Fraction

import pytest
from gmpy2 import gcd, mpz
from hypothesis import assume, given
from hypothesis import strategies as st

from bern_exact.exact.points import (
    along,
    coordinates,
    direction,
    grid_point,
    hpoint,
    line_through,
    meet,
    reduced,
)
from bern_exact.exact.predicates import side
from tests.exact.plain import Point, cross, exactly, homogeneous, minus, plain, points, sign, turn
from tests.rationals import fractions, fractions_between


@given(points)
def test_coordinates_undo_hpoint(p: Point) -> None:
    assert coordinates(homogeneous(p)) == (exactly(p[0]), exactly(p[1]))


@given(points)
def test_points_are_reduced_integers(p: Point) -> None:
    x, y, w = homogeneous(p)
    assert w > 0 and gcd(gcd(x, y), w) == 1
    assert all(type(part) is type(mpz()) for part in (x, y, w))


@given(points, st.integers(-(10**30), 10**30).filter(bool))
def test_equal_points_are_equal_tuples(p: Point, factor: int) -> None:
    x, y, w = homogeneous(p)
    assert reduced(x * factor, y * factor, w * factor) == (x, y, w)


@given(st.integers(), st.integers())
def test_grid_points_are_points(x: int, y: int) -> None:
    assert grid_point(x, y) == hpoint(x, y)


@given(points, points)
def test_directions_are_positive_multiples(p: Point, q: Point) -> None:
    u, v = homogeneous(p), homogeneous(q)
    scale = Fraction(int(u[2] * v[2]))
    difference = minus(q, p)
    assert direction(u, v) == (difference[0] * scale, difference[1] * scale)


@given(points, points, points)
def test_lines_are_positive_on_the_left(p: Point, q: Point, r: Point) -> None:
    line = line_through(homogeneous(p), homogeneous(q))
    assert side(line, homogeneous(r)) == sign(turn(p, q, r))


@given(points)
def test_there_is_no_line_through_one_point(p: Point) -> None:
    assert line_through(homogeneous(p), homogeneous(p)) == (0, 0, 0)


@given(points, points, points, points)
def test_lines_meet_where_both_pass(p: Point, q: Point, r: Point, s: Point) -> None:
    first, second = (line_through(homogeneous(a), homogeneous(b)) for a, b in ((p, q), (r, s)))
    if cross(minus(q, p), minus(s, r)) == 0:
        with pytest.raises(ZeroDivisionError):
            meet(first, second)
    else:
        common = meet(first, second)
        assert common == meet(second, first)
        assert side(first, common) == side(second, common) == 0


@given(points, points, fractions)
def test_along_interpolates(p: Point, q: Point, t: Fraction) -> None:
    x, y = coordinates(along(homogeneous(p), homogeneous(q), exactly(t)))
    assert (plain(x), plain(y)) == (p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]))


@given(points, points, fractions_between(0, 1))
def test_along_is_the_same_from_either_end(p: Point, q: Point, t: Fraction) -> None:
    assume(p != q)
    u, v = homogeneous(p), homogeneous(q)
    assert along(u, v, exactly(t)) == along(v, u, exactly(1 - t))
