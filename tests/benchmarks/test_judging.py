"""Meshes of doubles are measured exactly, invalid ones too."""

from __future__ import annotations

import json
from collections.abc import Sequence

import pytest
from gmpy2 import mpq

from benchmarks.peers.boundary import followed
from benchmarks.peers.figures import standing
from benchmarks.peers.floats import mesh_of_floats
from benchmarks.peers.judging import Judged, judged
from bern_exact.exact.angles import ANGLE_90, Angle
from bern_exact.oracle.arguments import polygon_of
from tests.benchmarks.fakes import SQUARE
from tests.benchmarks.made import verdict

HALVES = [(0, 1, 2), (0, 2, 3)]
TILTED = [(0.0, 0.0), (3.0, 1.0), (2.0, 4.0), (-1.0, 3.0)]
THIRD = 1 / 3
"""The double nearest to 1/3: (1, 1/3) is on the edge from (0, 0) to (3, 1), (1, THIRD) is not."""

Points = Sequence[tuple[float, float]]


def measured(points: Points, triangles: Sequence[Sequence[int]], polygon: Points) -> Judged:
    return judged(mesh_of_floats(points, triangles), polygon_of(polygon))


def test_a_square_is_exact() -> None:
    found = measured(SQUARE, HALVES, SQUARE)
    assert found.valid
    assert found.keeps_boundary
    assert found.max_angle == ANGLE_90
    assert found.min_height_squared == found.height_ratio_squared == mpq(1, 2)
    assert (found.off, standing(found)) == (0, "exact")


def test_a_vertex_off_its_edge_by_rounding_is_told_and_measured() -> None:
    points = [*TILTED, (1.0, THIRD)]
    found = measured(points, [(0, 4, 3), (4, 1, 2), (4, 2, 3)], TILTED)
    assert not found.valid
    assert found.keeps_boundary is False
    assert found.is_valid_but_for_rounding
    assert (found.off, standing(found)) == (1, "1 off")
    error = mpq(*THIRD.as_integer_ratio()) - mpq(1, 3)
    assert found.off_squared == 9 * error**2 / 10


def test_a_vertex_far_off_its_edge_is_no_rounding() -> None:
    points = [*TILTED, (1.0, 0.25)]
    found = measured(points, [(0, 4, 3), (4, 1, 2), (4, 2, 3)], TILTED)
    assert found.defects == {"boundary-vertex-off-edge": 1}
    assert not found.is_valid_but_for_rounding
    assert found.keeps_boundary is False


def test_what_else_is_wrong_is_told_besides_a_vertex_off_its_edge() -> None:
    points = [*TILTED, (1.0, THIRD), (9.0, 9.0)]
    found = measured(points, [(0, 4, 3), (4, 1, 2), (4, 2, 3)], TILTED)
    assert found.defects == {"boundary-vertex-off-edge": 1, "unused-vertex": 1}
    assert not found.is_valid_but_for_rounding
    assert standing(found) == "1 off, unused-vertex"


def test_a_boundary_that_crosses_itself_is_judged_against_the_polygon() -> None:
    points = [*TILTED, (0.75, 0.25), (0.5, 2.0), (1.0, 1 / 3)]
    rounds = [(0, 6, 5), (6, 4, 5), (4, 1, 5), (1, 2, 5), (2, 3, 5), (3, 0, 5)]
    found = measured(points, rounds, TILTED)
    assert found.off == 1
    assert not found.is_valid_but_for_rounding


def test_a_vertex_on_its_edge_is_not_off() -> None:
    found = measured([*SQUARE, (0.5, 0.0)], [(0, 4, 3), (4, 1, 2), (4, 2, 3)], SQUARE)
    assert found.valid
    assert found.off == 0


@pytest.mark.parametrize(
    ("triangles", "kind"),
    [
        ([(0, 2, 1), (0, 2, 3)], "clockwise-triangle"),
        ([(0, 1, 2)], "region-not-covered"),
        ([(0, 1, 2), (0, 2, 3), (0, 1, 3)], "overlap"),
        ([(0, 1, 2), (0, 2, 7)], "index-out-of-range"),
    ],
)
def test_what_is_wrong_is_told(triangles: Sequence[Sequence[int]], kind: str) -> None:
    found = measured(SQUARE, triangles, SQUARE)
    assert kind in found.defects
    assert not found.valid
    assert not found.is_valid_but_for_rounding
    assert kind in standing(found)


def test_an_invalid_mesh_is_measured_all_the_same() -> None:
    found = measured(SQUARE, [(0, 1, 2)], SQUARE)
    assert found.max_angle == ANGLE_90
    assert found.min_height_squared == mpq(1, 2)


def test_no_mesh_at_all_has_no_figures() -> None:
    found = measured(SQUARE, [], SQUARE)
    assert (found.triangles, found.max_angle, found.height_ratio_squared) == (0, None, None)
    assert not found.valid


def test_a_boundary_vertex_that_is_missing_cannot_be_followed() -> None:
    mesh = mesh_of_floats(SQUARE[:3], [(0, 1, 2)])
    assert followed(mesh, polygon_of(SQUARE)) is None


def test_two_boundaries_at_one_vertex_cannot_be_followed() -> None:
    points = [*SQUARE, (0.5, 0.5)]
    mesh = mesh_of_floats(points, [(0, 1, 4), (2, 3, 4)])
    assert followed(mesh, polygon_of(SQUARE)) is None


def test_a_filled_hole_is_no_rounding() -> None:
    hole = [(0.25, 0.25), (0.75, 0.25), (0.5, 0.75)]
    found = judged(mesh_of_floats(SQUARE, HALVES), polygon_of([SQUARE, hole]))
    assert found.off is None
    assert not found.is_valid_but_for_rounding


def test_other_defects_that_fill_the_list_leave_the_boundary_open() -> None:
    assert verdict(defects={"clockwise-triangle": 200}).keeps_boundary is None
    assert verdict(defects={"clockwise-triangle": 199}).keeps_boundary is True


@pytest.mark.parametrize(
    "found",
    [
        verdict(),
        verdict(max_angle=None, min_height_squared=None, off=None),
        verdict(max_angle=Angle(0, mpq(0)), defects={"overlap": 3}, off_squared=mpq(1, 3)),
    ],
)
def test_verdicts_survive_json(found: Judged) -> None:
    assert Judged.of_json(json.loads(json.dumps(found.to_json()))) == found
