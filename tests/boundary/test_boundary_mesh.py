"""The faces near the boundary: what they become and how they are triangulated."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from bern_exact.boundary.optimal import (
    HIGHEST,
    HIGHEST_WITHIN_135,
    best_triangulation,
)
from bern_exact.exact.predicates import squared_height
from tests.boundary.naive import area, square
from tests.boundary.samples import drawn, every_family
from tests.boundary.test_corners import REFUSED

draws = pytest.mark.parametrize(("kind", "seed"), REFUSED)


@every_family
def test_the_warped_faces_cover_what_the_touched_ones_did(kind: str, seed: int) -> None:
    stages = drawn(kind, seed)
    boundary, warped = stages.boundary, stages.warped
    near = sum(area([warped.point_of(node) for node in face.ring]) for face in boundary.faces)
    inner = sum(area([warped.point_of(node) for node in loop]) for loop in stages.interior.loops)
    assert near + inner == stages.framed.polygon.area


@every_family
def test_faces_have_no_repeated_nodes(kind: str, seed: int) -> None:
    for face in drawn(kind, seed).boundary.faces:
        assert len(set(face.ring)) == len(face.ring) >= 3
        assert len(face.triangles) == len(face.ring) - 2


@every_family
def test_triangulations_are_the_highest(kind: str, seed: int) -> None:
    stages = drawn(kind, seed)
    for face in stages.boundary.faces:
        demand = HIGHEST_WITHIN_135 if face.block >= 0 else HIGHEST
        points = {node: stages.warped.point_of(node) for node in face.ring}
        best = best_triangulation(list(points.values()), demand)
        assert best is not None
        heights = (squared_height(*(points[v] for v in triangle)) for triangle in face.triangles)
        assert min(heights) == best.value


@every_family
def test_block_faces_lie_in_their_blocks_before_warping(kind: str, seed: int) -> None:
    stages = drawn(kind, seed)
    for face in stages.boundary.touched:
        nodes = [node for node in face.ring if isinstance(node, tuple)]
        if face.block >= 0:
            x, y = square(stages.framed.polygon.points[face.block])
            assert all(abs(2 * u - 2 * x - 1) <= 3 >= abs(2 * t - 2 * y - 1) for u, t in nodes)


@draws
def test_nothing_is_lower_than_tau_over_root_two(kind: str, seed: int) -> None:
    stages = drawn(kind, seed)
    for face in stages.boundary.faces:
        for triangle in face.triangles:
            height = squared_height(*(stages.warped.point_of(node) for node in triangle))
            assert height >= mpq(1, 128)


@every_family
def test_all_edges_but_those_of_the_boundary_fit_together(kind: str, seed: int) -> None:
    stages = drawn(kind, seed)
    darts = {
        (ring[i - 1], node)
        for ring in (face.ring for face in stages.boundary.faces)
        for i, node in enumerate(ring)
    }
    inner = {(loop[i - 1], v) for loop in stages.interior.loops for i, v in enumerate(loop)}
    open_ones = {(a, b) for a, b in darts if (b, a) not in darts and (b, a) not in inner}
    assert all(isinstance(a, int) and isinstance(b, int) for a, b in open_ones)
    assert all((b, a) in darts for a, b in inner)
