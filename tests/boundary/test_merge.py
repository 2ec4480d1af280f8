"""Merging faces along edges, against the definition; what is merged fits together."""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.boundary.merge import nodes_on_edge
from bern_exact.boundary.optimal import Demand, largest_kappa
from bern_exact.boundary.project import best_cuts, cuttable, project
from bern_exact.exact.points import coordinates
from bern_exact.exact.predicates import orientation
from tests.boundary.merging import Boundary, Definition, merged, merger_of, points_of
from tests.boundary.naive import area
from tests.boundary.samples import DRAWS, every_family
from tests.plane.by_definition import on_segment


@every_family
def test_faces_are_merged_by_the_definition(kind: str, seed: int) -> None:
    boundary = merged(kind, seed)
    definition = Definition(boundary)
    expected = [
        (edge, *run)
        for edge in range(boundary.warped.traced.diced.framed.polygon.n)
        for run in definition.runs(edge)
    ]
    found = [item.merged for item in boundary.mesh.projected]
    assert [(face.edge, face.faces, face.base) for face in found] == expected


def test_the_samples_need_every_rule() -> None:
    needed: set[str] = set()
    for draw in DRAWS:
        boundary = merged(*draw)
        definition = Definition(boundary)
        for edge in range(boundary.warped.traced.diced.framed.polygon.n):
            list(definition.runs(edge))
        needed |= definition.why
    assert needed >= {"block", "used", "grid vertex", "single edge"}


@every_family
def test_each_face_at_the_boundary_is_in_one_merged_face(kind: str, seed: int) -> None:
    boundary = merged(kind, seed)
    in_runs = [number for item in boundary.mesh.projected for number in item.merged.faces]
    polygon = boundary.warped.traced.diced.framed.polygon
    pieces = {
        piece
        for edge in range(polygon.n)
        for nodes in [nodes_on_edge(boundary.warped, edge)]
        for piece in zip(nodes, nodes[1:], strict=False)
    }
    supported = [
        number
        for number, ring in enumerate(boundary.rings)
        if boundary.blocks[number] < 0
        and any((ring[i - 1], node) in pieces for i, node in enumerate(ring))
    ]
    assert sorted(in_runs) == supported
    assert len(boundary.mesh.faces) == len(boundary.rings) - len(supported)


@every_family
def test_a_merged_face_is_the_union_of_its_faces(kind: str, seed: int) -> None:
    boundary = merged(kind, seed)
    for item in boundary.mesh.projected:
        face = item.merged
        outline = (*face.base[:1], *face.base[-1:], *face.staircase[-2:0:-1])
        parts = (area(points_of(boundary, boundary.rings[number])) for number in face.faces)
        assert area(points_of(boundary, outline)) == sum(parts)


@every_family
def test_the_base_lies_on_the_edge_in_order(kind: str, seed: int) -> None:
    boundary = merged(kind, seed)
    polygon = boundary.warped.traced.diced.framed.polygon
    for item in boundary.mesh.projected:
        edge, base = item.merged.edge, points_of(boundary, item.merged.base)
        tail, head = polygon.points[edge], polygon.points[polygon.after[edge]]
        assert all(on_segment(p, tail, head) for p in base)
        (x, y), (u, v) = coordinates(tail), coordinates(head)
        along = [(s - x) * (u - x) + (t - y) * (v - y) for s, t in map(coordinates, base)]
        assert along == sorted(set(along))


@every_family
def test_any_order_of_edges_will_do(kind: str, seed: int) -> None:
    boundary = merged(kind, seed)
    merger, polygon = merger_of(boundary), boundary.warped.traced.diced.framed.polygon
    demands = [(best_cuts, Demand(largest_kappa(mpq(1, 8))))]
    for edge in reversed(range(polygon.n)):
        for face in merger.along(edge):
            points = points_of(boundary, face.staircase)
            possible = cuttable(face, polygon.lines[edge], points, mpq(1, 128))
            assert project(possible, demands, 10**9)[0].pieces
    assert merger.used == {n for item in boundary.mesh.projected for n in item.merged.faces}


def everything(boundary: Boundary) -> list[tuple[tuple[object, ...], ...]]:
    """The triangles of faces of all kinds."""
    kept = [triangle for face in boundary.mesh.faces for triangle in face.triangles]
    cut = [t for item in boundary.mesh.projected for _, each in item.pieces for t in each]
    return [*kept, *cut]


@every_family
def test_the_triangles_cover_what_the_touched_faces_did(kind: str, seed: int) -> None:
    boundary = merged(kind, seed)
    triangles = everything(boundary)
    assert sum(area(points_of(boundary, t)) for t in triangles) == sum(
        area(points_of(boundary, ring)) for ring in boundary.rings
    )
    assert all(orientation(*points_of(boundary, t)) > 0 for t in triangles)


@every_family
def test_merging_leaves_fewer_vertices_on_the_boundary(kind: str, seed: int) -> None:
    for item in merged(kind, seed).mesh.projected:
        assert len(item.cuts) <= len(item.merged.staircase) - 2
