"""What users give to `verify` is read exactly, or refused with its place."""

from __future__ import annotations

from decimal import Decimal
from typing import Any

import numpy as np
import pytest

from bern_exact import verify
from bern_exact.exact.errors import InputError
from bern_exact.testing import assert_triangulation

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
HALVES = [(0, 1, 2), (0, 2, 3)]


@pytest.mark.parametrize("kind", [float, int, object])
def test_masked_coordinates_are_refused(kind: type) -> None:
    masked = np.ma.masked_array(np.array(SQUARE, dtype=kind), mask=[[0, 0]] * 3 + [[1, 0]])
    with pytest.raises(InputError, match="vertices: an entry is masked"):
        verify(masked, np.array(HALVES))


def test_masked_indices_are_refused() -> None:
    masked = np.ma.masked_array(np.array(HALVES), mask=[[0, 0, 0], [0, 1, 0]])
    with pytest.raises(InputError, match="triangles: an entry is masked"):
        verify(np.array(SQUARE, dtype=float), masked)


def test_a_masked_array_without_masked_entries_is_an_array() -> None:
    assert verify(np.ma.masked_array(np.array(SQUARE, dtype=float)), np.array(HALVES), SQUARE)


def test_an_enormous_decimal_is_refused_at_once() -> None:
    with pytest.raises(InputError, match="exponent"):
        verify([(Decimal("1e99999999"), 0), (1, 0), (0, 1)], [(0, 1, 2)])


def test_a_decimal_is_that_decimal() -> None:
    ring = [(Decimal("0.1"), 0), (1, 0), (0, 1)]
    assert verify([("1/10", 0), (1, 0), (0, 1)], [(0, 1, 2)], ring)


def test_a_set_of_vertices_has_no_order() -> None:
    with pytest.raises(InputError, match="vertices: a sequence"):
        verify(set(SQUARE), HALVES)


@pytest.mark.parametrize("number", ["2", 2.5, -1, True, [2]])
@pytest.mark.parametrize("name", ["limit", "max_triangles"])
def test_numbers_of_things_are_integers(name: str, number: Any) -> None:
    options: dict[str, Any] = {name: number}
    for judge in (verify, assert_triangulation):
        with pytest.raises(InputError, match=name):
            judge(SQUARE, HALVES, **options)


@pytest.mark.parametrize("tolerance", [1e-12, np.float64(1e-12), np.float32(1e-12), "1e-12"])
def test_a_tolerance_is_the_decimal_that_it_prints_as(tolerance: Any) -> None:
    moved = [*SQUARE[:3], (0, "1.000000000001")]
    for judge in (verify, assert_triangulation):
        assert judge(moved, HALVES, SQUARE, tolerance=tolerance).state == "valid within 1e-12"
