"""Numbers read all at once are those that are read one by one."""

from __future__ import annotations

import pytest
from gmpy2 import mpq
from hypothesis import example, given
from hypothesis import strategies as st

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import JsonNumber, parse_rational
from bern_exact.exact.points import coordinates
from bern_exact.plane.array_mesh import DoublePoints, nearest_double
from bern_exact.plane.text_points import points_of_numbers
from tests.plane.test_array_mesh import unsplit

usual = st.one_of(
    st.integers(-(2**60), 2**60),
    st.integers(-(2**60), 2**60).map(str),
    st.fractions(max_denominator=2**40).map(str),
    st.decimals(allow_nan=False, allow_infinity=False, places=5).map(str),
    st.floats(allow_nan=False, allow_infinity=False).map(repr),
    st.floats(allow_nan=False, allow_infinity=False).map(repr).map(JsonNumber),
)
odd = st.text("0123456789+-./eE_ \nx", max_size=6)
pairs = st.lists(st.tuples(usual, usual), min_size=1, max_size=5)
odd_pairs = st.lists(st.tuples(usual | odd, usual | odd), min_size=1, max_size=3)


def one_by_one(numbers: list[int | str], binary64: bool) -> list[mpq] | None:
    try:
        return [
            mpq(n) if isinstance(n, int) else parse_rational(n, binary64=binary64) for n in numbers
        ]
    except InputError:
        return None


def check(numbers: list[int | str], binary64: bool, *, must_be_read: bool = False) -> None:
    points = points_of_numbers(numbers, binary64=binary64)
    expected = one_by_one(numbers, binary64)
    if points is None:
        assert not (must_be_read and expected is not None)
        return
    assert expected is not None
    flat = [c for v in range(len(points)) for c in coordinates(points.point(v))]
    assert flat == expected
    assert points.doubles.ravel().tolist() == [
        nearest_double(x.numerator, x.denominator) for x in expected
    ]
    if points.exact:
        assert [mpq(x) for x in points.doubles.ravel().tolist()] == expected
    if points.lattice is not None:
        integers = unsplit(points.lattice)
        scale = next((n / x for n, x in zip(integers, expected, strict=True) if x), mpq(1))
        assert scale > 0 and integers == [x * scale for x in expected]


@given(pairs, st.booleans())
def test_usual_numbers_are_read_at_once(pairs: list[tuple[int | str]], binary64: bool) -> None:
    check([n for pair in pairs for n in pair], binary64, must_be_read=True)


@given(odd_pairs, st.booleans())
@example([("1e-10001", "1")], False)
@example([("0e10001", "1")], True)
@example([("1e400", "1e-400")], False)
@example([("1e400", "1")], True)
@example([("1.5e-3", "-.5")], False)
def test_odd_texts_are_refused_or_read_alike(pairs: list[tuple[int | str]], binary64: bool) -> None:
    check([n for pair in pairs for n in pair], binary64)


@pytest.mark.parametrize(
    "text",
    ["1/-3", "1/+3", "1/0", "1/2/3", "/3", "1.5/2", "1e5/3", "nan", "inf", "1_0", " 1", "1\n", ""]
    + ["\n1", "١", "\ud800", "1" * 400, True, None, [1]],
)
def test_what_is_no_number_or_too_long_is_left_to_others(text: object) -> None:
    assert points_of_numbers([text, 1], binary64=False) is None
    assert points_of_numbers([1, text], binary64=True) is None


def test_decimals_with_binary64_and_small_integers_are_doubles() -> None:
    assert isinstance(points_of_numbers(["0.1", 3, "1e300", "4"], binary64=True), DoublePoints)
    assert isinstance(points_of_numbers([1, -(2**52)], binary64=False), DoublePoints)


@pytest.mark.parametrize("text", ["1e-2000", "-1e-2000", "1e2000", "1e-46", "1e46"])
def test_numbers_that_doubles_hold_badly_are_wild(text: str) -> None:
    points = points_of_numbers(["0", "1", text, "1", "0.0", "0"], binary64=False)
    assert points is not None
    assert points.wild.tolist() == [False, True, False]


@pytest.mark.parametrize("x, y", [("1/3", "2/6"), ("0.50", "0.5"), ("1/2", ".5"), (3, "3")])
def test_equal_coordinates_are_told_whatever_their_text(x: int | str, y: int | str) -> None:
    points = points_of_numbers(["1/7", x, 0, y, "1/7", "9"], binary64=False)
    assert points is not None
    assert points.are_equal(0, 1, 1) and points.are_equal(0, 2, 0)
    assert not points.are_equal(0, 2, 1) and not points.are_equal(0, 1, 0)
