"""CG:SHOP 2025: instances become polygons, polygons instances, meshes solutions."""

from __future__ import annotations

import random
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import pytest
from gmpy2 import mpz
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.api import triangulate
from bern_exact.corpus.shapes import star
from bern_exact.exact.errors import InputError
from bern_exact.exact.points import coordinates, hpoint
from bern_exact.formats.cgshop import (
    Instance,
    instance_document,
    instance_of,
    is_instance,
    read_instance,
    solution_document,
)
from bern_exact.formats.polygon_json import dump_polygon
from bern_exact.oracle.api import verify
from bern_exact.oracle.arguments import polygon_of
from bern_exact.plane.mesh import Mesh
from tests.rationals import many_fractions

HOOK: dict[str, Any] = {
    "content_type": "CG_SHOP_2025_Instance",
    "instance_uid": "hook",
    "num_points": 6,
    "points_x": [0, 10, -7, 10, 0, 3],
    "points_y": [0, 10, 5, 0, 10, 4],
    "region_boundary": [0, 3, 1, 5, 4, 2],
    "num_constraints": 0,
    "additional_constraints": [],
}
"""An instance whose points are not in the order of its boundary."""


def changed(**changes: Any) -> dict[str, Any]:
    return {**HOOK, **changes}


# ---------------------------------------------------------------- instances in


def test_the_vertices_are_in_the_order_of_the_boundary() -> None:
    polygon = read_instance(HOOK).polygon
    assert polygon.name == "hook"
    points = [tuple(map(int, coordinates(p))) for p in polygon.points]
    assert points == [(0, 0), (10, 0), (10, 10), (3, 4), (0, 10), (-7, 5)]


def test_either_orientation_is_read() -> None:
    turned = read_instance(changed(region_boundary=HOOK["region_boundary"][::-1]))
    assert turned.polygon.area == read_instance(HOOK).polygon.area


@pytest.mark.parametrize(
    "missing", ["content_type", "num_constraints", "additional_constraints", None]
)
def test_what_the_contest_leaves_out_at_times_may_be_missing(missing: str | None) -> None:
    document = {key: value for key, value in HOOK.items() if key != missing}
    assert read_instance(document) == read_instance(HOOK)


def test_members_of_others_are_ignored() -> None:
    assert read_instance(changed(meta={"a": 1})) == read_instance(HOOK)


def test_long_integers_stay_what_they_are() -> None:
    xs = [x * 10**40 + 1 for x in HOOK["points_x"]]
    assert read_instance(changed(points_x=xs)).points[1] == hpoint(10**41 + 1, 10)


@pytest.mark.parametrize(
    ("changes", "kind", "path"),
    [
        (
            {"num_constraints": 1, "additional_constraints": [[0, 1]]},
            "unsupported",
            "$.additional_constraints",
        ),
        ({"num_constraints": 2}, "unsupported", "$.num_constraints"),
        ({"region_boundary": [0, 3, 1, 5, 4]}, "unsupported", "$.points_x[2]"),
        ({"content_type": "CG_SHOP_2024_Instance"}, "unsupported", "$.content_type"),
        ({"content_type": "CG_SHOP_2025_Solution"}, "unsupported", "$.content_type"),
        ({"num_points": 7}, "schema", "$.points_x"),
        ({"points_y": [0, 1]}, "schema", "$.points_y"),
        ({"num_points": "6"}, "schema", "$.num_points"),
        ({"num_points": True}, "schema", "$.num_points"),
        ({"region_boundary": [0, 3, 1, 5, 4, 6]}, "schema", "$.region_boundary[5]"),
        ({"region_boundary": [0, 3, 1, 5, 4, -1]}, "schema", "$.region_boundary[5]"),
        ({"region_boundary": [0, 3, 1, 5, 4, "2"]}, "schema", "$.region_boundary[5]"),
        ({"region_boundary": {}}, "schema", "$.region_boundary"),
        ({"additional_constraints": {}}, "schema", "$.additional_constraints"),
        ({"points_x": [0, 10, "1/2", 10, 0, 3]}, "number", "$.points_x[2]"),
        ({"points_x": [0, 10, None, 10, 0, 3]}, "number", "$.points_x[2]"),
        ({"instance_uid": 7}, "schema", "$.instance_uid"),
    ],
)
def test_what_is_no_polygon_is_refused_by_its_name(
    changes: Mapping[str, Any], kind: str, path: str
) -> None:
    with pytest.raises(InputError) as refusal:
        read_instance(changed(**changes))
    assert (refusal.value.kind, refusal.value.where["path"]) == (kind, path)
    assert path in refusal.value.message


@pytest.mark.parametrize("field", ["instance_uid", "num_points", "points_x", "region_boundary"])
def test_fields_that_must_be_there_are_missed(field: str) -> None:
    with pytest.raises(InputError, match=f'"{field}" is missing'):
        read_instance({key: value for key, value in HOOK.items() if key != field})


@pytest.mark.parametrize(
    ("boundary", "kind"),
    [([0, 1, 3, 5, 4, 2], "edges-cross"), ([0, 3, 1, 5, 4, 2, 5], "repeated-vertex")],
)
def test_boundaries_that_are_not_simple_are_refused(boundary: list[int], kind: str) -> None:
    with pytest.raises(InputError) as refusal:
        _ = read_instance(changed(region_boundary=boundary)).polygon
    assert refusal.value.kind == kind


@pytest.mark.parametrize(
    "document", [HOOK, {"region_boundary": 3}, {"content_type": HOOK["content_type"]}]
)
def test_instances_are_known_by_their_fields(document: dict[str, Any]) -> None:
    assert is_instance(document)


@pytest.mark.parametrize(
    "document", [{}, {"outer": []}, [], None, {"outer": [], "region_boundary": 1}]
)
def test_other_documents_are_none(document: Any) -> None:
    assert not is_instance(document)


# ---------------------------------------------------------------- instances out


rationals = many_fractions(-50, 50, 60)


@given(st.lists(rationals, min_size=2, max_size=2), st.integers(1, 60))
def test_a_polygon_is_its_instance_scaled_exactly(shift: list[Fraction], part: int) -> None:
    corners = [(0, 0), (4, 0), (4, 3), (1, 1)]
    ring = [(Fraction(x, part) + shift[0], Fraction(y, part) + shift[1]) for x, y in corners]
    polygon = polygon_of(ring)
    instance = instance_of(polygon, "made")
    again = read_instance(instance_document(instance))
    assert again.uid == instance.uid == "made"
    k = int(instance.scale)
    assert again.polygon == polygon_of([(x * k, y * k) for x, y in ring])
    # No smaller factor makes all of them integers.
    for p in {q for q in range(2, k + 1) if k % q == 0}:
        assert any((c * k / p).denominator > 1 for point in ring for c in point)


def test_integers_are_not_scaled() -> None:
    assert instance_of(polygon_of([(0, 0), (4, 0), (0, 3)])).scale == 1


def test_a_clockwise_ring_has_a_counter_clockwise_boundary_and_its_own_numbers() -> None:
    instance = instance_of(polygon_of([(0, 0), (0, 3), (4, 0)]))
    assert [tuple(map(int, p[:2])) for p in instance.points] == [(0, 0), (0, 3), (4, 0)]
    assert instance.boundary == (0, 2, 1)


def test_the_polygon_names_its_instance() -> None:
    named = read_instance(HOOK).polygon
    assert instance_of(named, "else").uid == "hook"


def test_holes_are_refused() -> None:
    hole = [(1, 1), (2, 1), (1, 2)]
    with pytest.raises(InputError) as refusal:
        instance_of(polygon_of([[(0, 0), (9, 0), (0, 9)], hole]))
    assert refusal.value.kind == "has-holes"


def test_integers_that_no_reader_would_take_are_refused() -> None:
    with pytest.raises(InputError) as refusal:
        instance_of(polygon_of([(0, 0), (1, 0), (0, f"1/{10**1000}")]))
    assert refusal.value.kind == "number"


# ---------------------------------------------------------------- solutions


def points_of(solution: Mapping[str, Any], instance: Mapping[str, Any]) -> list[Any]:
    """The exact points that a solution's indices mean, by the contest's rules."""
    known = zip(instance["points_x"], instance["points_y"], strict=True)
    steiner = zip(solution["steiner_points_x"], solution["steiner_points_y"], strict=True)
    return [(Fraction(x), Fraction(y)) for x, y in (*known, *steiner)]


def edges_of(mesh: Mesh, scale: mpz) -> set[frozenset[tuple[Fraction, Fraction]]]:
    """The edges of a mesh by their ends."""
    at = [
        tuple(Fraction(int(c.numerator), int(c.denominator)) * int(scale) for c in p)
        for p in mesh.coordinates
    ]
    return {frozenset((at[t[i - 1]], at[t[i]])) for t in mesh.triangles for i in range(3)}  # type: ignore[misc]


def check(mesh: Mesh, instance: Instance) -> dict[str, Any]:
    """A mesh's solution, after looking at it by the contest's rules."""
    solution = solution_document(mesh, instance)
    assert set(solution) == {
        "content_type",
        "instance_uid",
        "steiner_points_x",
        "steiner_points_y",
        "edges",
    }
    assert solution["content_type"] == "CG_SHOP_2025_Solution"
    assert solution["instance_uid"] == instance.uid
    points = points_of(solution, instance_document(instance))
    assert len(set(points)) == len(points) == len(mesh.vertices)
    edges = solution["edges"]
    assert len({frozenset(edge) for edge in edges}) == len(edges)
    assert {frozenset((points[a], points[b])) for a, b in edges} == edges_of(mesh, instance.scale)
    return solution


@pytest.mark.parametrize("thin", [False, True])
def test_an_instance_is_solved_in_its_own_numbers(thin: bool) -> None:
    instance = read_instance(HOOK)
    result = triangulate(instance.polygon, thin=thin, check="none")
    solution = check(result.mesh, instance)
    assert verify(result.mesh.coordinates, result.mesh.triangles, instance.polygon)
    boundary = [
        *zip(instance.boundary, (*instance.boundary[1:], instance.boundary[0]), strict=True)
    ]
    if thin:
        assert all(sorted(edge) in solution["edges"] for edge in boundary)


@pytest.mark.parametrize("seed", range(3))
def test_any_order_of_the_points_gives_the_same_edges(seed: int) -> None:
    polygon = polygon_of(star(12, seed))
    mesh = triangulate(polygon, thin=True, check="none").mesh
    order = list(range(polygon.n))
    random.Random(seed).shuffle(order)
    boundary = tuple(order.index(v) for v in polygon.rings[0])
    check(mesh, Instance("shuffled", tuple(polygon.points[v] for v in order), boundary))


def test_a_scaled_polygon_is_solved_in_the_instance_s_coordinates() -> None:
    polygon = polygon_of([(0, 0), ("7/3", 0), ("7/3", "1/7"), ("1/2", "1/9")])
    instance = instance_of(polygon, "thirds")
    check(triangulate(polygon, check="none").mesh, instance)


def test_coordinates_are_strings_in_lowest_terms() -> None:
    square = polygon_of([(0, 0), (2, 0), (2, 2), (0, 2)])
    at = (*square.points, hpoint(1, 1))
    fan = Mesh(at, ((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)))
    solution = check(fan, instance_of(square))
    assert (solution["steiner_points_x"], solution["steiner_points_y"]) == (["1"], ["1"])
    assert solution["edges"][:3] == [[0, 1], [0, 3], [0, 4]]


def test_a_mesh_that_lacks_a_point_is_refused() -> None:
    polygon = polygon_of([(0, 0), (2, 0), (2, 2), (0, 2)])
    with pytest.raises(InputError, match="no vertex at point 3"):
        solution_document(Mesh(polygon.points[:3], ((0, 1, 2),)), instance_of(polygon))


# ---------------------------------------------------------------- the contest's verifier


@pytest.mark.parametrize("thin", [False, True])
@pytest.mark.parametrize("seed", range(3))
def test_the_contest_s_verifier_agrees(seed: int, thin: bool) -> None:
    reason = "cgshop2025-pyutils is not installed: it builds CGAL from a package server"
    pyutils = pytest.importorskip("cgshop2025_pyutils.verifier", reason=reason)
    schemas = pytest.importorskip("cgshop2025_pyutils.data_schemas", reason=reason)
    instance = instance_of(polygon_of(star(9, seed)), f"star{seed}")
    mesh = triangulate(instance.polygon, thin=thin, check="none").mesh
    solution = solution_document(mesh, instance)
    found = pyutils.verify(
        schemas.Cgshop2025Instance(**instance_document(instance)),
        schemas.Cgshop2025Solution(**solution),
        strict=True,
    )
    assert found.errors == []
    assert found.num_steiner_points == len(solution["steiner_points_x"])
    classes = verify(mesh.coordinates, mesh.triangles, instance.polygon).angle_classes
    acute_or_right = classes["le60"] + classes["le90"]
    assert found.num_obtuse_triangles == len(mesh.triangles) - acute_or_right


def test_a_polygon_s_document_is_no_instance() -> None:
    assert not is_instance(dump_polygon(read_instance(HOOK).polygon))
