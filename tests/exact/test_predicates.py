"""Signs and squared lengths are those of fractions, and keep their symmetries."""

from __future__ import annotations

from fractions import Fraction

from gmpy2 import mpq
from hypothesis import assume, given

from bern_exact.exact.points import line_through
from bern_exact.exact.predicates import (
    compare_xy,
    is_in_wedge,
    orientation,
    squared_distance,
    squared_distance_to_line,
    squared_distance_to_segment,
    squared_height,
)
from tests.exact.plain import (
    Point,
    cross,
    dot,
    exactly,
    homogeneous,
    minus,
    plain,
    points,
    sign,
    square,
    turn,
)
from tests.rationals import fractions


@given(points, points, points)
def test_orientation_is_the_sign_of_the_area(p: Point, q: Point, r: Point) -> None:
    assert orientation(*map(homogeneous, (p, q, r))) == sign(turn(p, q, r))


@given(points, points, points)
def test_orientation_turns_with_its_points(p: Point, q: Point, r: Point) -> None:
    a, b, c = map(homogeneous, (p, q, r))
    assert orientation(a, b, c) == orientation(b, c, a) == -orientation(b, a, c)


@given(points, points, fractions)
def test_points_of_a_line_do_not_turn(p: Point, q: Point, t: Fraction) -> None:
    r = (p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]))
    assert orientation(*map(homogeneous, (p, q, r))) == 0


@given(points, points)
def test_comparison_is_that_of_pairs(p: Point, q: Point) -> None:
    assert compare_xy(homogeneous(p), homogeneous(q)) == (p > q) - (p < q)


@given(points, points)
def test_squared_distances(p: Point, q: Point) -> None:
    assert plain(squared_distance(homogeneous(p), homogeneous(q))) == square(p, q)


@given(points, points, points)
def test_squared_distances_to_a_line(p: Point, q: Point, r: Point) -> None:
    assume(q != r)
    line = line_through(homogeneous(q), homogeneous(r))
    found = squared_distance_to_line(line, homogeneous(p))
    assert plain(found) == turn(q, r, p) ** 2 / square(q, r)


def distance_to_segment(p: Point, a: Point, b: Point) -> Fraction:
    """The squared distance of p from its nearest point of ab, by the parameter of that point."""
    u = minus(b, a)
    t = dot(minus(p, a), u) / dot(u, u) if a != b else Fraction(0)
    t = min(max(t, Fraction(0)), Fraction(1))
    return square(p, (a[0] + t * u[0], a[1] + t * u[1]))


@given(points, points, points)
def test_squared_distances_to_a_segment(p: Point, a: Point, b: Point) -> None:
    found = squared_distance_to_segment(*map(homogeneous, (p, a, b)))
    assert plain(found) == distance_to_segment(p, a, b)


@given(points, points)
def test_a_segment_may_be_a_point(p: Point, a: Point) -> None:
    found = squared_distance_to_segment(*map(homogeneous, (p, a, a)))
    assert plain(found) == square(p, a)


@given(points, points, points)
def test_squared_heights(p: Point, q: Point, r: Point) -> None:
    longest = max(square(p, q), square(q, r), square(r, p))
    assume(longest)
    found = squared_height(*map(homogeneous, (p, q, r)))
    assert plain(found) == turn(p, q, r) ** 2 / longest


@given(points, points, points)
def test_the_height_is_the_least_distance_of_a_vertex_from_its_edge(
    p: Point, q: Point, r: Point
) -> None:
    assume(turn(p, q, r))
    a, b, c = map(homogeneous, (p, q, r))
    heights = [squared_distance_to_line(line_through(u, v), w) for u, v, w in
               ((a, b, c), (b, c, a), (c, a, b))]  # fmt: skip
    assert squared_height(a, b, c) == min(heights)


def turned_from(u: Point, v: Point) -> tuple[int, mpq]:
    """The counter-clockwise angle from u to v: its half (0: up to 180 degrees), and -cos |cos|."""
    c, d = cross(u, v), dot(u, v)
    half = 0 if c > 0 or (c == 0 and d > 0) else 1
    falling = -exactly(d * abs(d) / (dot(u, u) * dot(v, v)))
    return (half, falling if half == 0 else -falling)


@given(points, points, points, points)
def test_the_wedge_is_a_range_of_angles(p: Point, before: Point, apex: Point, after: Point) -> None:
    assume(apex not in (before, after) and p != apex)
    out, into, to_p = minus(after, apex), minus(before, apex), minus(p, apex)
    assume(cross(out, into) or dot(out, into) < 0)  # an angle of 0 or 360 degrees has no wedge
    expected = turned_from(out, to_p) <= turned_from(out, into)
    found = is_in_wedge(*map(homogeneous, (p, before, apex, after)))
    assert found == expected


@given(points, points, points)
def test_the_wedge_holds_its_apex_and_its_rays(before: Point, apex: Point, after: Point) -> None:
    assume(apex not in (before, after))
    b, a, f = map(homogeneous, (before, apex, after))
    assume(orientation(b, a, f) or dot(minus(before, apex), minus(after, apex)) < 0)
    assert all(is_in_wedge(p, b, a, f) for p in (b, a, f))


@given(points, points, points, points)
def test_a_point_is_in_the_wedge_or_in_its_complement(
    p: Point, before: Point, apex: Point, after: Point
) -> None:
    q, b, a, f = map(homogeneous, (p, before, apex, after))
    assume(orientation(b, a, f) != 0)
    assert is_in_wedge(q, b, a, f) or is_in_wedge(q, f, a, b)
