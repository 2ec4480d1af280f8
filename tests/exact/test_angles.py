"""Angle tests agree with the exact cosine, and the cosine with the triangle."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from gmpy2 import mpq, mpz
from hypothesis import assume, given
from hypothesis import strategies as st

from bern_exact.exact import angles
from bern_exact.exact.angles import Angle, angle_at, largest_angle, tangent_pair
from bern_exact.exact.points import grid_point
from tests.exact.plain import Point, cross, dot, exactly, homogeneous, minus, points, sign, turn

TESTS: list[tuple[Angle, Callable[[mpz, mpz], bool]]] = [
    (angles.ANGLE_60, angles.is_at_most_60),
    (angles.ANGLE_90, lambda dot_product, _: angles.is_at_most_90(dot_product)),
    (angles.ANGLE_120, angles.is_at_most_120),
    (angles.ANGLE_135, angles.is_at_most_135),
    (angles.ANGLE_150, angles.is_at_most_150),
]
by_bound = pytest.mark.parametrize(
    ("bound", "is_at_most"), TESTS, ids=["60", "90", "120", "135", "150"]
)

# Beside the bounds: integers near the multiples of sqrt(3) that 60, 120 and 150 degrees are.
legs = st.integers(-30, 30) | st.integers(-(10**30), 10**30) | st.sampled_from([97, 168, 56, 1351])


@by_bound
@given(st.data())
def test_a_bound_is_that_of_the_cosine(
    bound: Angle, is_at_most: Callable[[mpz, mpz], bool], data: st.DataObject
) -> None:
    product, area = mpz(data.draw(legs)), mpz(data.draw(legs.filter(lambda x: x > 0)))
    squared = mpq(product * product, product * product + area * area)
    angle = Angle(sign(product), squared)
    assert is_at_most(product, area) == angle.is_at_most(bound)


@pytest.mark.parametrize(
    ("bound", "product", "area"),
    [("90", 0, 1), ("135", -1, 1), ("135", -(10**40), 10**40)],
)
def test_an_angle_is_at_most_itself(bound: str, product: int, area: int) -> None:
    is_at_most = {"90": TESTS[1][1], "135": TESTS[3][1]}[bound]
    assert is_at_most(mpz(product), mpz(area))
    assert not is_at_most(mpz(product - 1), mpz(area))


@given(points, points, points)
def test_the_cosine_is_that_of_fractions(p: Point, q: Point, r: Point) -> None:
    assume(q not in (p, r))
    u, v = minus(p, q), minus(r, q)
    found = angle_at(*map(homogeneous, (p, q, r)))
    assert found == (sign(dot(u, v)), exactly(dot(u, v) ** 2 / (dot(u, u) * dot(v, v))))


@given(points, points, points)
def test_an_angle_has_no_orientation(p: Point, q: Point, r: Point) -> None:
    assume(q not in (p, r))
    a, b, c = map(homogeneous, (p, q, r))
    assert angle_at(a, b, c) == angle_at(c, b, a)


@given(points, points, points)
def test_the_largest_angle_is_no_smaller_than_any(p: Point, q: Point, r: Point) -> None:
    assume(turn(p, q, r))
    corners = tuple(map(homogeneous, (p, q, r)))
    found, where = largest_angle(*corners)
    each = [angle_at(corners[i - 1], corners[i], corners[(i + 1) % 3]) for i in range(3)]
    assert found == each[where]
    assert all(angle.is_at_most(found) for angle in each)
    assert each.index(found) == where  # of equal ones the first
    assert angles.ANGLE_60.is_at_most(found)


def test_right_and_flat_triangles() -> None:
    corner, east, north, west = (grid_point(*p) for p in ((0, 0), (3, 0), (0, 4), (-1, 0)))
    assert largest_angle(east, north, corner) == (angles.RIGHT, 2)
    assert largest_angle(east, corner, west) == (angles.ANGLE_180, 1)


@given(points, points, points)
def test_the_tangent_pair_turns_from_after_to_before(p: Point, q: Point, r: Point) -> None:
    product, area = tangent_pair(*map(homogeneous, (p, q, r)))
    u, v = minus(r, q), minus(p, q)
    assert (sign(product), sign(area)) == (sign(dot(u, v)), sign(cross(u, v)))
    assert product * exactly(cross(u, v)) == area * exactly(dot(u, v))


def test_the_named_angles_grow() -> None:
    named = [angles.ANGLE_60, angles.ANGLE_90, angles.ANGLE_120, angles.ANGLE_135,
             angles.ANGLE_150, angles.ANGLE_180]  # fmt: skip
    for i, smaller in enumerate(named):
        assert all(smaller.is_at_most(larger) for larger in named[i:])
        assert not any(larger.is_at_most(smaller) for larger in named[i + 1 :])
