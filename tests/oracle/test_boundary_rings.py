"""The boundary of a mesh as rings, whatever touches."""

from __future__ import annotations

import random

import numpy as np
import pytest

from bern_exact.oracle.boundary_rings import boundary_rings
from tests.oracle.meshes import Case, annulus, fan, good, grid


def rings(case: Case) -> list[list[int]] | None:
    return boundary_rings(np.array(case.triangles, dtype=np.int64), len(case.vertices))


def sides(case: Case) -> set[tuple[int, int]]:
    edges = {(t[i], t[(i + 1) % 3]) for t in case.triangles for i in range(3)}
    return {(a, b) for a, b in edges if (b, a) not in edges}


@pytest.mark.parametrize("seed", range(20))
def test_the_rings_are_the_sides(seed: int) -> None:
    case = good(random.Random(seed))
    found = rings(case)
    assert found is not None
    run = [(ring[i], ring[(i + 1) % len(ring)]) for ring in found for i in range(len(ring))]
    assert len(run) == len(set(run)) and set(run) == sides(case)


def test_a_ring_a_hole() -> None:
    assert len(rings(annulus(5, random.Random(1))) or []) == 2
    assert len(rings(grid(4, 4, hole=True)) or []) == 2


def test_the_order_of_triangles_does_not_matter() -> None:
    case = fan(9, random.Random(2))
    shuffled = case.copy()
    shuffled.triangles = [(b, c, a) for a, b, c in reversed(case.triangles)]
    assert rings(case) == rings(shuffled)


def test_rings_that_touch_are_told_apart_by_their_triangles() -> None:
    # Two fans of two triangles round vertex 0.
    triangles = np.array([(0, 1, 2), (0, 2, 3), (0, 4, 5), (0, 5, 6)])
    assert boundary_rings(triangles, 7) == [[0, 1, 2, 3], [0, 4, 5, 6]]


def test_a_hole_that_touches_the_outer_ring_makes_one_ring_with_it() -> None:
    # A square 0 1 2 3 with a triangular hole 0 4 5: no triangle joins the sides of vertex 0.
    triangles = np.array([(0, 1, 4), (1, 2, 4), (4, 2, 5), (2, 3, 5), (3, 0, 5)])
    assert boundary_rings(triangles, 6) == [[0, 1, 2, 3, 0, 5, 4]]


@pytest.mark.parametrize(
    "triangles",
    [[(0, 1, 3)], [(0, 1, -1)], [(0, 1, 1)], [(0, 1, 2), (0, 1, 2)], [(0, 1, 2**70)]],
    ids=["too-large", "negative", "repeated", "twice", "huge"],
)
def test_there_is_no_boundary(triangles: list[tuple[int, int, int]]) -> None:
    array = np.array(triangles, dtype=object if triangles[0][2] > 2**62 else np.int64)
    assert boundary_rings(array, 3) is None


def test_no_triangles_have_no_rings() -> None:
    assert boundary_rings(np.empty((0, 3), dtype=np.int64), 5) == []
