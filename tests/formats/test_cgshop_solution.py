"""CG:SHOP solutions as meshes: accepted if and only if the edges are those of a triangulation."""

from __future__ import annotations

import json
from itertools import combinations
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bern_exact.__main__ import main
from bern_exact.api import triangulate
from bern_exact.corpus.shapes import star
from bern_exact.exact.errors import InputError
from bern_exact.exact.predicates import orientation
from bern_exact.formats import cgshop, read_array_mesh_file
from bern_exact.formats.cgshop_solution import is_solution, read_mesh
from bern_exact.oracle.api import polygon_of
from bern_exact.oracle.fast import verify_mesh
from bern_exact.oracle.verdict import Verdict

SQUARE: dict[str, Any] = {
    "content_type": "CG_SHOP_2025_Instance",
    "instance_uid": "square",
    "num_points": 4,
    "points_x": [0, 4, 4, 0],
    "points_y": [0, 0, 4, 4],
    "region_boundary": [0, 1, 2, 3],
    "num_constraints": 0,
    "additional_constraints": [],
}


def solution(edges: list[Any], steiner: list[tuple[Any, Any]] | None = None) -> dict[str, Any]:
    return {
        "content_type": "CG_SHOP_2025_Solution",
        "instance_uid": "square",
        "steiner_points_x": [x for x, _ in steiner or []],
        "steiner_points_y": [y for _, y in steiner or []],
        "edges": edges,
    }


def judged(document: dict[str, Any], instance: dict[str, Any] = SQUARE) -> Verdict:
    read = cgshop.read_instance(instance)
    return verify_mesh(read_mesh(document, read, binary64=False), read.polygon)


def kinds(document: dict[str, Any]) -> set[str]:
    return {defect.kind for defect in judged(document).defects}


CENTRE = [("2", "2")]
SPOKES = [[0, 4], [1, 4], [2, 4], [3, 4]]


@pytest.mark.parametrize(
    ("edges", "steiner"),
    [
        ([[0, 2]], []),
        ([[2, 0], [0, 2], [0, 1]], []),
        (SPOKES, CENTRE),
        ([[0, 2], [1, 3]], CENTRE),  # through the centre: two edges each
        ([[0, 4], [0, 2], [1, 4], [3, 4]], CENTRE),
        ([[0, 4], [4, 3]], [(4, "4/2")]),  # a Steiner point on the boundary
        ([[0, 4], [4, 3], [1, 4], [4, 2]], [("4.0", 2)]),
    ],
)
def test_triangulations_are_valid(edges: list[Any], steiner: list[tuple[Any, Any]]) -> None:
    steiner = [(4, 2) if p == (4, "4/2") else p for p in steiner]
    assert judged(solution(edges, steiner)).valid


@pytest.mark.parametrize(
    ("edges", "steiner", "kind"),
    [
        ([], [], "region-not-covered"),
        ([[0, 2], [1, 3]], [], "crossing-edges"),
        ([*SPOKES, [0, 2], [1, 3]], [(1, 2)], "crossing-edges"),
        (SPOKES[:3], CENTRE, "region-not-covered"),  # a face of four sides
        (SPOKES[:1], CENTRE, "unused-vertex"),  # an edge that ends inside
        ([[0, 2]], CENTRE, "region-not-covered"),  # through a point: four sides
        ([[0, 2]], [(1, 3)], "unused-vertex"),  # an isolated point
        ([[0, 2], [0, 4]], [(-1, 3)], "repeated-index"),  # an edge that ends outside
        ([[0, 2], [0, 4], [4, 3]], [(-1, 3)], "triangle-outside"),
        ([[0, 2], [0, 4], [4, 5], [5, 3]], [(-1, 1), (-1, 3)], "repeated-index"),  # a quad outside
        ([[0, 2], [0, 9]], [], "index-out-of-range"),
        ([[0, 2], [-1, 2]], [], "index-out-of-range"),
        ([[0, 2], [2, 2]], [], "repeated-index"),
        ([[0, 2]], [(0, "0")], "duplicate-vertex"),
        ([[0, 2], [4, 5], [5, 6], [6, 4]], [(2, 1), (3, 1), (3, 2)], "overlap"),
    ],
)
def test_others_are_not_and_the_defect_has_a_name(
    edges: list[Any], steiner: list[tuple[Any, Any]], kind: str
) -> None:
    assert kind in kinds(solution(edges, steiner))


L_SHAPE = {
    **SQUARE,
    "num_points": 5,
    "points_x": [0, 4, 4, 1, 0],
    "points_y": [0, 0, 1, 1, 4],
    "region_boundary": [0, 1, 2, 3, 4],
}


def test_an_edge_across_a_pocket_is_a_triangle_outside() -> None:
    edges = [[0, 3], [1, 3]]
    assert judged(solution(edges), L_SHAPE).valid
    found = judged(solution([*edges, [2, 4]]), L_SHAPE)
    assert "triangle-outside" in {d.kind for d in found.defects}


HEXAGON = {
    **SQUARE,
    "num_points": 6,
    "points_x": [0, 2, 4, 4, 2, 0],
    "points_y": [0, 1, 0, 4, 3, 4],
    "region_boundary": [0, 1, 2, 3, 4, 5],
}
PAIRS = [*combinations(range(6), 2)]


@settings(max_examples=200)
@given(st.sets(st.sampled_from(PAIRS), max_size=6))
def test_exactly_triangulations_are_accepted(chosen: set[tuple[int, int]]) -> None:
    """Of six points in general position: three diagonals inside that do not cross."""
    instance = cgshop.read_instance(HEXAGON)
    at, boundary = instance.points, {(i, i + 1) for i in range(5)} | {(0, 5)}
    diagonals = sorted(chosen - boundary)
    fine = len(diagonals) == 3 and not any(
        len({*e, *f}) == 4
        and orientation(at[e[0]], at[e[1]], at[f[0]]) != orientation(at[e[0]], at[e[1]], at[f[1]])
        and orientation(at[f[0]], at[f[1]], at[e[0]]) != orientation(at[f[0]], at[f[1]], at[e[1]])
        for e, f in combinations([*diagonals, *boundary], 2)
    )
    fine = fine and not {(0, 2), (3, 5)} & chosen  # these are outside
    assert judged(solution(sorted(map(list, chosen))), HEXAGON).valid == fine


@pytest.mark.parametrize("thin", [False, True])
def test_what_is_written_is_read(thin: bool) -> None:
    polygon = polygon_of(star(12, 1))
    instance = cgshop.instance_of(polygon, "square")
    mesh = triangulate(polygon, thin=thin, check="none").mesh
    found = read_mesh(cgshop.solution_document(mesh, instance), instance, binary64=False)
    assert len(found.triangles) == len(mesh.triangles)
    assert verify_mesh(found, polygon).valid


# ---------------------------------------------------------------- files


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "s.solution.json").write_text(json.dumps(solution([[0, 2]])))
    return tmp_path


@pytest.mark.parametrize("name", ["s.instance.json", "square.instance.json", "square.json"])
def test_the_instance_is_found_beside_the_solution(folder: Path, name: str) -> None:
    (folder / name).write_text(json.dumps(SQUARE))
    found, polygon = read_array_mesh_file(folder / "s.solution.json")
    assert polygon is not None
    assert verify_mesh(found.mesh, polygon).valid


def test_the_instance_may_be_named(folder: Path) -> None:
    (folder / "else").mkdir()
    named = folder / "else" / "x.json"
    named.write_text(json.dumps(SQUARE))
    found, _ = read_array_mesh_file(folder / "s.solution.json", polygon_path=named)
    assert len(found.triangles) == 2


def test_without_its_instance_a_solution_is_refused_with_advice(folder: Path) -> None:
    with pytest.raises(InputError, match="--polygon, or put it beside .* s.instance.json"):
        read_array_mesh_file(folder / "s.solution.json")


def test_another_instance_is_refused(folder: Path) -> None:
    (folder / "s.instance.json").write_text(json.dumps({**SQUARE, "instance_uid": "other"}))
    with pytest.raises(InputError, match="is of instance 'square', not of 'other'"):
        read_array_mesh_file(folder / "s.solution.json", format="cgshop")


@pytest.mark.parametrize(("edges", "code"), [([[0, 2]], 0), ([[0, 2], [1, 3]], 1), ([[0, 9]], 1)])
def test_verify_says_yes_or_no(folder: Path, edges: list[Any], code: int) -> None:
    (folder / "s.instance.json").write_text(json.dumps(SQUARE))
    (folder / "s.solution.json").write_text(json.dumps(solution(edges)))
    assert main(["verify", str(folder / "s.solution.json")]) == code


@pytest.mark.parametrize(
    ("changes", "kind", "path"),
    [
        ({"edges": [[0]]}, "schema", "$.edges[0]"),
        ({"edges": [[0, 1.5]]}, "schema", "$.edges[0][1]"),
        ({"edges": [[0, True]]}, "schema", "$.edges[0][1]"),
        ({"edges": None}, "schema", "$.edges"),
        ({"steiner_points_x": [1]}, "schema", "$.steiner_points_y"),
        ({"steiner_points_x": ["x"]}, "number", "$.steiner_points_x[0]"),
    ],
)
def test_malformed_solutions_are_refused(changes: dict[str, Any], kind: str, path: str) -> None:
    with pytest.raises(InputError) as refusal:
        judged({**solution([[0, 2]]), **changes})
    assert (refusal.value.kind, refusal.value.where) == (kind, {"path": path})


def test_solutions_are_known_by_their_fields() -> None:
    assert is_solution(solution([]))
    assert not is_solution(SQUARE)
    assert not is_solution([])
