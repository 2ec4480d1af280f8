"""`verify` takes vertices and triangles as users have them."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from gmpy2 import mpq, mpz

from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.exact.errors import InputError
from bern_exact.oracle.api import verify

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
TWO = [(0, 1, 2), (0, 2, 3)]


@pytest.mark.parametrize(
    "one", [1, 1.0, "1", "2/2", "1e0", Fraction(1), mpq(1), mpz(1)], ids=lambda x: type(x).__name__
)
def test_numbers_of_every_kind(one: Any) -> None:
    square = [(0, 0), (one, 0), (one, one), (0, one)]
    assert verify(square, TWO, square)


def test_text_is_decimal_and_float_is_binary() -> None:
    third = [(0, 0), (1, 0), (0, 1)]
    assert verify([(0, 0), (1, 0), (0, "0.1")], [(0, 1, 2)]).min_height_squared == mpq(1, 101)
    binary = verify([(0, 0), (1, 0), (0, 0.1)], [(0, 1, 2)]).min_height_squared
    assert binary is not None and binary != mpq(1, 101)
    assert verify(third, [(0, 1, 2)], third)


def test_numpy_arrays() -> None:
    numpy = pytest.importorskip("numpy")
    square, two = numpy.array(SQUARE, dtype=float), numpy.array(TWO)
    assert verify(square, two, square)
    assert verify(square.astype("float32"), two.astype("uint8"), [square])
    assert verify([tuple(row) for row in square], list(two), [tuple(row) for row in square])


def test_polygons_in_every_form() -> None:
    ring = [(-1, -1), (2, -1), (2, 2), (-1, 2)]
    hole = SQUARE
    vertices = [*ring, *hole]
    triangles = [
        t for k in range(4) for j in [(k + 1) % 4] for t in ((k, j, 4 + k), (j, 4 + j, 4 + k))
    ]
    assert verify(vertices, triangles, [ring, hole])
    assert verify(vertices, triangles, {"outer": ring, "holes": [hole]})
    assert not verify(vertices, triangles, ring)
    assert verify(iter(vertices), iter(triangles))


def test_bounds() -> None:
    for bound in (90, "90", 90.0, "cos:0:0", parse_angle_bound("90")):
        assert verify(SQUARE, TWO, max_angle=bound)
    assert not verify(SQUARE, TWO, max_angle=89.9)
    assert not verify(SQUARE, TWO, min_height_squared=0.75)
    assert not verify(SQUARE, TWO, max_triangles=1)


def test_the_feature_size_of_a_given_polygon() -> None:
    thin = [(0, 0), (5, 0), (5, "1/3"), (0, "1/3")]
    assert verify(thin, TWO, thin).feature_size_squared == mpq(1, 9)
    assert verify(thin, TWO[:1], thin).feature_size_squared == mpq(1, 9)
    assert verify(thin, TWO).feature_size_squared is None


def test_a_verdict_shows_what_is_wrong() -> None:
    shown = repr(verify(SQUARE, [(0, 2, 1)], SQUARE))
    assert "clockwise-triangle: triangle 0 (the triangle runs clockwise)" in shown
    assert repr(verify(SQUARE, TWO)).startswith("<Verdict: valid; 2 triangles, 4 vertices")


@pytest.mark.parametrize(
    "vertices, triangles, kind",
    [
        ([(0, float("nan"))], [], "number"),
        ([(0, float("inf"))], [], "number"),
        ([(0, True)], [], "number"),
        ([(0, None)], [], "number"),
        ([(0, "x")], [], "number"),
        ([(0, 1j)], [], "number"),
        ([(0, 0, 0)], [], "schema"),
        ([0, 0], [], "schema"),
        ("points", [], "schema"),
        (None, [], "schema"),
        (SQUARE, [(0, 1)], "schema"),
        (SQUARE, [(0, 1, 2.0)], "schema"),
        (SQUARE, [(0, 1, True)], "schema"),
        (SQUARE, [0, 1, 2], "schema"),
    ],
)
def test_what_is_refused(vertices: Any, triangles: Any, kind: str) -> None:
    with pytest.raises(InputError) as caught:
        verify(vertices, triangles)
    assert caught.value.kind == kind


@pytest.mark.parametrize(
    "polygon", [[], [[]], [(0, 0)], 7, "ring", {}, {"outer": SQUARE, "holes": 1}]
)
def test_polygons_that_are_refused(polygon: Any) -> None:
    with pytest.raises(InputError):
        verify(SQUARE, TWO, polygon)


@pytest.mark.parametrize("bound", ["", "x", "-1", "181", "nan", "cos:0:1", "cos:1:2", True])
def test_angles_that_are_refused(bound: Any) -> None:
    with pytest.raises(InputError):
        verify(SQUARE, TWO, max_angle=bound)
