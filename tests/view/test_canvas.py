"""Rounding for pictures, and path data."""

from __future__ import annotations

from gmpy2 import mpq, mpz
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.exact.points import HPoint, hpoint
from bern_exact.view.canvas import Plane, Window, path_data, text_of

rationals = st.fractions(min_value=-(10**6), max_value=10**6, max_denominator=10**6)
points = st.builds(lambda x, y: hpoint(mpq(x), mpq(y)), rationals, rationals)


@given(st.lists(points, min_size=1, max_size=8))
def test_every_point_lies_in_the_rounded_box(some: list[HPoint]) -> None:
    plane = Plane.around(some)
    for x, y in plane.all(some):
        assert 0 <= x <= plane.width
        assert 0 <= y <= plane.height


@given(st.lists(points, min_size=2, max_size=8), st.integers(1, 10**12))
def test_the_picture_does_not_depend_on_scale_and_place(some: list[HPoint], k: int) -> None:
    moved = [hpoint(k * mpq(x, w) + 5, k * mpq(y, w) - 7) for x, y, w in some]
    assert Plane.around(some).all(some) == Plane.around(moved).all(moved)


def test_huge_coordinates_keep_their_shape() -> None:
    far = mpz(10) ** 30
    square = [(far + dx, far + dy, mpz(1)) for dx, dy in ((0, 0), (1, 0), (1, 1), (0, 1))]
    plane = Plane.around(square, bits=4)
    assert plane.all(square) == [(0, 0), (16, 0), (16, 16), (0, 16)]


def test_y_points_up_on_the_page() -> None:
    window = Window(0, 0, 100, 100, 10)
    assert window.at((0, 100)) == (0, 0)
    assert window.at((0, 0)) == (0, 10_000)


def test_both_axes_have_one_scale() -> None:
    window = Window.fitting(Plane(mpq(0), mpq(0), mpq(1), 200, 100), across=50, down=50)
    right, up = window.at((100, 0)), window.at((0, 100))
    origin = window.at((0, 0))
    assert right[0] - origin[0] == origin[1] - up[1]


def test_what_rounds_to_a_dot_leaves_no_path() -> None:
    assert path_data(Window(0, 0, 10**9, 10**9, 1), [[(0, 0), (1, 0), (0, 1)]]) == ""


@given(st.text())
def test_text_in_a_picture_is_always_xml(text: str) -> None:
    from xml.etree import ElementTree

    ElementTree.fromstring(f"<t>{text_of(text)}</t>".encode())
