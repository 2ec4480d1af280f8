"""Meshes in arrays hold the same points as meshes of exact points."""

from __future__ import annotations

import numpy as np
import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.exact.errors import InputError
from bern_exact.exact.points import coordinates, hpoint
from bern_exact.plane.array_mesh import (
    PART,
    UNIT,
    ArrayMesh,
    DoublePoints,
    ExactPoints,
    Lattice,
    index_array,
)
from bern_exact.plane.mesh import Mesh
from tests.rationals import fractions

rationals = fractions.map(lambda q: mpq(q.numerator, q.denominator))
doubles = st.floats(allow_nan=False, allow_infinity=False)


@given(st.lists(st.tuples(rationals, rationals), min_size=1))
def test_the_doubles_are_within_the_unit_of_the_coordinates(pairs: list[tuple[mpq, mpq]]) -> None:
    points = ExactPoints([hpoint(x, y) for x, y in pairs])
    for row, pair in zip(points.doubles.tolist(), pairs, strict=True):
        for value, coordinate in zip(row, pair, strict=True):
            assert abs(mpq(value) - coordinate) <= UNIT * abs(coordinate)


@given(st.lists(st.tuples(doubles, doubles), min_size=1))
def test_doubles_are_read_exactly(pairs: list[tuple[float, float]]) -> None:
    points = DoublePoints(np.array(pairs))
    for v, (x, y) in enumerate(pairs):
        assert coordinates(points.point(v)) == (mpq(x), mpq(y))


@pytest.mark.parametrize(
    "x, tame",
    [
        (mpq(0), True),
        (mpq(1, 3), True),
        (mpq(2) ** 100, True),
        (mpq(2) ** 101, False),
        (mpq(2) ** 2000, False),
        (mpq(1, mpq(2) ** 101), False),
        (mpq(1, mpq(2) ** 2000), False),
    ],
)
def test_numbers_that_doubles_hold_badly_are_not_tame(x: mpq, tame: bool) -> None:
    assert ExactPoints([hpoint(x, mpq(1))]).tame is tame
    assert ExactPoints([hpoint(mpq(1), -x)]).tame is tame


def test_a_mesh_in_arrays_is_the_mesh() -> None:
    mesh = Mesh((hpoint(mpq(1, 3), 0), hpoint(1, 0), hpoint(0, 1)), ((0, 1, 2), (-1, 5, 5)))
    assert ArrayMesh.of_mesh(mesh).mesh == mesh


@pytest.mark.parametrize(
    "triangles", [[(0, 1)], [(0, 1, 2), (0, 1)], [(0, 1, 0.5)], [(0, 1, "2")], [True, 1, 2]]
)
def test_other_shapes_are_refused(triangles: object) -> None:
    with pytest.raises(InputError):
        index_array(triangles)


def test_infinities_are_refused_with_their_place() -> None:
    with pytest.raises(InputError, match=r"vertices\[1\]"):
        ArrayMesh.of_doubles([(0, 0), (0, float("inf"))], [])


@pytest.mark.parametrize("index", [2**63, 2**64, -(2**63) - 1, 10**500])
def test_indices_beyond_64_bits_are_kept(index: int) -> None:
    assert index_array([(0, index, -1)]).tolist() == [[0, index, -1]]


@pytest.mark.parametrize(
    "big, scale", [(1, 2), (2**119 - 1, 2), (2**119, None), (mpq(1, 7), 14), (mpq(1, 3**76), None)]
)
def test_a_lattice_is_the_coordinates_times_a_number(big: mpq, scale: int | None) -> None:
    pairs = [(mpq(1, 2), mpq(-3)), (mpq(big), mpq(0))]
    lattice = ExactPoints([hpoint(x, y) for x, y in pairs]).lattice
    assert (lattice is None) == (scale is None)
    if lattice is not None and scale is not None:
        assert unsplit(lattice) == [c * scale for pair in pairs for c in pair]


def unsplit(lattice: Lattice) -> list[int]:
    """The integers x0, y0, x1, y1, ... from their parts."""
    high, low = lattice[:, :2].ravel().tolist(), lattice[:, 2:].ravel().tolist()
    return [(h << PART) + part for h, part in zip(high, low, strict=True)]
