"""The structure that `proofs.outside_blocks`, `lemma_4` and `merged_faces` prove, on polygons.

Samples prove nothing; but a rule of the construction that is none of the proofs' would show here.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import cache
from itertools import pairwise

import pytest
from gmpy2 import mpq

from bern_exact.boundary.corners import TAU, warp
from bern_exact.boundary.dice import dice
from bern_exact.boundary.faces import trace
from bern_exact.boundary.merge import merge_boundary
from bern_exact.boundary.optimal import Demand, best_triangulation, largest_kappa
from bern_exact.boundary.project import Cuttable, cuttable
from bern_exact.boundary.records import Framed, Lopped, MergedFace, MergedMesh, Node
from bern_exact.checkers.rings import boundary_edge
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.exact.similarity import Similarity
from bern_exact.plane.feature_size import feature_size
from bern_exact.plane.validation import polygon_from_rings
from proofs.merged_faces import left_out

Point = tuple[mpq, mpq]

ALMOST = mpq(1, 10**9)

UP = mpq(0), mpq(1)

FOUND = {
    "three corners move": (
        "-60.007,-105.071 46.503,1.441 100.031,750.073 100.012,758.097 47.391,760.007 "
        "-1.502,-22.241 -90.003,-22.003 -106.011,-60.013"
    ),
    "a q-vertex slides": (
        "-59.604,-110.543 -21.59,-93.573 -21.756,-1.073 760.526,51.191 758.561,95.802 "
        "750.1,99.917 1.497,47.016 -104.623,-59.507"
    ),
    "cuts are left out": (
        "16.618,14.205 4.918,12.88 -6.533,15.165 -18.943,12.101 -19.943,-5.003 "
        "-8.304,-17.94 0.102,-18.302 12.702,-22.9 20.803,-2.451"
    ),
    "rectangles with a side on an edge": (
        "-0.126,-0.874 -2.722,-15.781 6.098,-26.776 19.572,-22.865 29.212,-19.361 28.489,-0.989"
    ),
    "a face between two edges": (
        "8.32,6.86 4.72,17.24 -72.9,36.95 -83.3,25.35 -77.41,18.55 0.44,0.07"
    ),
}
"""Corners over the grid; found by a search for what is rare or nearest to the bounds."""

OFFSETS = (TAU - ALMOST, TAU + ALMOST, ALMOST - TAU, -TAU - ALMOST, 1 - TAU - ALMOST)


def corridor(offset: mpq, steep: bool = False) -> list[Point]:
    """A corridor whose lower wall passes the grid vertex (40, 2) at this distance below it.

    That is on the rim of the block of the wall's upper end.
    """
    start = mpq(1, 3), mpq(2, 5)
    along = 40 - start[0], 2 - offset - start[1]
    far = (mpq(83, 2) - start[0]) / along[0]  # to x = 41 1/2
    unit = mpq(1, 40)
    corners = (mpq(0), 0), (far, 0), (far + 7 * unit, 6), (far, 12), (mpq(0), 12), (-7 * unit, 6)
    points = [
        (
            start[0] + s * along[0] - r * unit * along[1],
            start[1] + s * along[1] + r * along[0] * unit,
        )
        for s, r in corners
    ]
    return [(y, x) for x, y in reversed(points)] if steep else points


@cache
def mesh_of(name: str) -> MergedMesh:
    """The construction of Theorem 2 on a polygon of `FOUND`."""
    corners = (corner.split(",") for corner in FOUND[name].split())
    return mesh_over_the_grid([(mpq(x), mpq(y)) for x, y in corners])


def mesh_over_the_grid(points: Sequence[Point]) -> MergedMesh:
    """The same on a polygon in grid coordinates, b = 1; its corners must be obtuse and s' >= 8."""
    polygon = polygon_from_rings([[hpoint(x, y) for x, y in points]])
    size = feature_size(polygon)
    assert size.squared >= 64
    lopped = Lopped(polygon, polygon, tuple(range(polygon.n)), ())
    still = Similarity.of((mpq(1), mpq(0)), (mpq(0), mpq(0)))
    traced, tracer = trace(dice(Framed(lopped, size, mpq(1), mpq(8), still, polygon)))
    warped, warping = warp(traced, tracer, TAU)
    return merge_boundary(warped, warping, tracer, TAU, "height")


def place(mesh: MergedMesh, node: Node) -> Point:
    """Where a node ends."""
    x, y, w = mesh.point_of(node)
    return mpq(x, w), mpq(y, w)


def run(mesh: MergedMesh, edge: int) -> Point:
    """The direction of an edge of P'."""
    polygon = mesh.warped.traced.diced.framed.polygon
    (a, b), (c, d) = (place(mesh, v) for v in (edge, polygon.after[edge]))
    return c - a, d - b


def cross(u: Point, v: Point) -> mpq:
    return u[0] * v[1] - u[1] * v[0]


def minus(p: Point, q: Point) -> Point:
    return p[0] - q[0], p[1] - q[1]


def edge_of(mesh: MergedMesh, node: Node) -> int:
    """The edge that a q-vertex is on."""
    assert isinstance(node, int)
    diced = mesh.warped.traced.diced
    return diced.crossings[node - diced.framed.polygon.n].edge


def pieces(mesh: MergedMesh, ring: Sequence[Node]) -> list[int]:
    """The edges of P' that a face outside blocks has a piece of, before warping."""
    sides = zip([ring[-1], *ring[:-1]], ring, strict=True)
    return [edge_of(mesh, b) for a, b in sides if isinstance(a, int) and isinstance(b, int)]


def wrong_before(mesh: MergedMesh) -> Iterator[object]:
    """`faces_before_warping`: pieces of at most two edges, running in opposite quadrants."""
    polygon = mesh.warped.traced.diced.framed.polygon
    for face in mesh.touched:
        if face.block < 0:
            runs = [run(mesh, edge) for edge in pieces(mesh, face.ring)]
            if any(isinstance(node, int) and node < polygon.n for node in face.ring):
                yield "a vertex on a face outside blocks", face
            if len(runs) > 2:
                yield "more than two pieces", face
            if len(runs) == 2 and not all(a * b < 0 for a, b in zip(*runs, strict=True)):
                yield "no opposite quadrants", face
            if len(runs) == 2 and len(face.ring) != 6:
                yield "a side is missing", face


def wrong_moves(mesh: MergedMesh) -> Iterator[object]:
    """`what_moves` and `sides_by_moving`."""
    warped, n = mesh.warped, mesh.warped.traced.diced.framed.polygon.n
    for face in mesh.touched:
        if face.block >= 0:
            continue
        targets = [warped.moved[node] for node in face.ring if node in warped.moved]  # type: ignore[index]
        if any(isinstance(target, int) and target < n for target in targets):
            yield "substep 1 moved a corner", face
            continue
        had = pieces(mesh, face.ring)
        for edge, corners in Counter(edge_of(mesh, target) for target in targets).items():
            if corners > 1 and edge not in had:
                low, high = sorted(map(abs, run(mesh, edge)))
                if had or len(face.ring) != 4 or low >= TAU * high:
                    yield "two corners on an edge, no such rectangle", face


def wrong_shapes(mesh: MergedMesh) -> Iterator[object]:
    """`faces_after_warping`, `least_edge`: all turns are to the left, pieces keep their sense."""
    warped = mesh.warped
    for face in mesh.touched:
        if face.block >= 0:
            continue
        ring = list(dict.fromkeys(warped.image_of(node) for node in face.ring))
        if len(ring) < 3:
            continue
        points = [place(mesh, node) for node in ring]
        runs = [minus(p, points[i - 1]) for i, p in enumerate(points)]
        if any(cross(u, v) <= 0 for u, v in pairwise([runs[-1], *runs])):
            yield "not convex", face
        for i, along in enumerate(runs):
            edge = boundary_edge(warped, ring[i - 1], ring[i])
            if edge >= 0 and along[0] * run(mesh, edge)[0] <= 0:
                yield "a piece is reversed", face
            if along[0] ** 2 + along[1] ** 2 < TAU**2:
                yield "a short side", face


class Stairs:
    """A merged face turned until its edge rises to the right, P' on its upper left."""

    def __init__(self, mesh: MergedMesh, merged: MergedFace) -> None:
        self.nodes = merged.staircase
        self.points = [place(mesh, node) for node in self.nodes]
        self.run = run(mesh, merged.edge)
        while not (self.run[0] > 0 and self.run[1] > 0):
            self.run, *self.points = [(-y, x) for x, y in (self.run, *self.points)]
        images = {mesh.warped.image_of(node) for node in mesh.warped.moved}
        self.rectangle = len(self.nodes) == 4 and {self.nodes[0], self.nodes[-1]} <= images

    def from_above(self) -> Stairs:
        """The mirror image in a line of slope -1, which exchanges the ends."""
        other = object.__new__(Stairs)
        other.nodes, other.rectangle = self.nodes[::-1], self.rectangle
        other.points = [(-y, -x) for x, y in reversed(self.points)]
        other.run = self.run[1], self.run[0]
        return other

    @property
    def levels(self) -> list[mpq]:
        return [x + y for x, y in self.points]

    def begins_on_a_row(self) -> bool:
        dx, dy = minus(self.points[1], self.points[0])
        return bool(abs(dx) > abs(dy))

    def leaves_out(self) -> bool:
        """Is c_2 left out in the cutting of `merged_faces`?"""
        a, c_1, c_2 = self.points[:3]
        near = minus(c_2, c_1) == UP and a[0] - c_1[0] > 1 - left_out()
        return self.begins_on_a_row() and near and isinstance(self.nodes[2], tuple)


def wrong_ends(mesh: MergedMesh) -> Iterator[object]:
    """`lemma_4`: monotone; a row at the lower end is as in `row_at_a_block`."""
    for item in mesh.projected:
        stairs = Stairs(mesh, item.merged)
        if any(after - t < TAU for t, after in pairwise(stairs.levels[1:-1])):
            yield "t grows by less than tau", item.merged
        for seen in (stairs, stairs.from_above()):
            if seen.rectangle:
                continue
            (x, y), c_1, c_2 = seen.points[:3]
            t = seen.levels
            if not seen.begins_on_a_row():
                if t[1] - t[0] < TAU:
                    yield "t grows by less than tau", item.merged
            elif not (
                isinstance(seen.nodes[1], tuple)
                and TAU <= x - c_1[0] < 1
                and y == c_1[1]
                and 2 * seen.run[1] > seen.run[0]
                and t[2] > t[0]
                and (minus(c_2, c_1) == UP or t[2] - t[0] >= 1 - TAU)
            ):
                yield "a row at an end", item.merged


def wrong_cuts(mesh: MergedMesh) -> Iterator[object]:
    """`end_faces_have_four_sides`, `projected_vertices` and the cutting of `merged_faces`."""
    polygon = mesh.warped.traced.diced.framed.polygon
    within = Demand(largest_kappa(TAU), TAU**2 / 4)
    for item in mesh.projected:
        stairs = Stairs(mesh, item.merged)
        points = [mesh.point_of(node) for node in stairs.nodes]
        face = cuttable(item.merged, polygon.lines[item.merged.edge], points)
        above = stairs.from_above()
        if not stairs.rectangle:
            first, last = stairs.begins_on_a_row(), above.begins_on_a_row()
            if list(face.cuts) != list(range(1 + first, len(points) - 1 - last)):
                yield "other vertices can be projected", item.merged
            if any(_beside(face, k) < TAU / 2 for k in range(len(face.cuts))):
                yield "beside its projection", item.merged
        out = {k for k, seen in ((0, stairs), (-1, above)) if seen.leaves_out()}
        for ring in _pieces(face, out, stairs.rectangle):
            if len(ring) > 4 or best_triangulation(ring, within) is None:
                yield "a piece without such triangles", item.merged


def _beside(face: Cuttable, k: int) -> mpq:
    """How far a staircase vertex is from its projection along an axis."""
    (x, _, w), (u, _, z) = face.staircase[face.cuts[k]], face.projections[k]
    return abs(mpq(x, w) - mpq(u, z))


def _pieces(face: Cuttable, out: set[int], whole: bool) -> Iterator[list[HPoint]]:
    """The pieces if all vertices but the first (0) or last (-1) are projected, as `out` says.

    What is left out is cut off as a triangle.
    """
    count = len(face.cuts)
    kept = [] if whole else [k for k in range(count) if k not in {i % count for i in out if count}]
    for i, j in pairwise([-1, *kept, count]):
        ring = face.ring(i, j)
        if not whole and 0 in out and i == -1:  # a, c_1, c_2
            yield [ring[0], ring[-2], ring[-1]]
            ring = ring[:-1]
        if not whole and -1 in out and j == count:  # b, c_(m-1), c_(m-2)
            yield ring[1:4]
            ring = [*ring[:2], *ring[3:]]
        yield ring


CHECKS: tuple[Callable[[MergedMesh], Iterator[object]], ...] = (
    wrong_before,
    wrong_moves,
    wrong_shapes,
    wrong_ends,
    wrong_cuts,
)


@pytest.mark.parametrize("check", CHECKS)
@pytest.mark.parametrize("name", FOUND)
def test_polygons_found_are_as_proved(
    check: Callable[[MergedMesh], Iterator[object]], name: str
) -> None:
    assert not list(check(mesh_of(name)))


@pytest.mark.parametrize("steep", [False, True])
@pytest.mark.parametrize("offset", OFFSETS)
def test_walls_next_to_the_threshold_are_as_proved(offset: mpq, steep: bool) -> None:
    mesh = mesh_over_the_grid(corridor(offset, steep))
    assert not [wrong for check in CHECKS for wrong in check(mesh)]
    vertex = (2, 40) if steep else (40, 2)
    assert (vertex in mesh.warped.moved) == (0 < offset < TAU)
    moved = {place[1:] for place in mesh.warped.instances}
    assert (vertex in moved) == (-TAU < offset < 0)


def test_the_polygons_show_what_they_were_found_for() -> None:
    def merged(name: str) -> list[Stairs]:
        mesh = mesh_of(name)
        return [Stairs(mesh, item.merged) for item in mesh.projected]

    assert any(stairs.rectangle for stairs in merged("rectangles with a side on an edge"))
    assert any(stairs.leaves_out() for stairs in merged("cuts are left out"))
    two = mesh_of("a face between two edges")
    assert any(len(pieces(two, face.ring)) == 2 for face in two.touched if face.block < 0)
    three = mesh_of("three corners move")
    moved = three.warped.moved
    assert any(sum(node in moved for node in face.ring) == 3 for face in three.touched)
    assert slid(mesh_of("a q-vertex slides"))


def slid(mesh: MergedMesh) -> list[int]:
    """The q-vertices of faces outside blocks that are off their lines."""
    warped, n = mesh.warped, mesh.warped.traced.diced.framed.polygon.n
    outside = {node for face in mesh.touched if face.block < 0 for node in face.ring}
    return [
        j
        for j, q in enumerate(warped.traced.diced.crossings)
        if n + j in outside
        and warped.image[j] == n + j
        and warped.points[j][q.axis] != q.line * warped.points[j][2]
    ]


def test_a_face_with_four_pieces_is_found() -> None:
    mesh = mesh_of("a face between two edges")
    face = next(face for face in mesh.touched if face.block < 0 and len(face.ring) == 6)
    twice = replace(mesh, touched=(*mesh.touched, face._replace(ring=face.ring * 2)))
    assert list(wrong_before(twice))


def test_a_corner_that_a_vertex_has_taken_is_found() -> None:
    mesh = mesh_of("three corners move")
    corner = next(
        node for f in mesh.touched if f.block < 0 for node in f.ring if isinstance(node, tuple)
    )
    moved = {**mesh.warped.moved, corner: 0}
    assert list(wrong_moves(replace(mesh, warped=replace(mesh.warped, moved=moved))))


def test_a_q_vertex_in_the_wrong_place_is_found() -> None:
    mesh = mesh_of("a q-vertex slides")
    points = list(mesh.warped.points)
    (j, *_) = slid(mesh)
    on_edge = mesh.warped.traced.diced.on_edge[mesh.warped.traced.diced.crossings[j].edge]
    points[j] = points[on_edge[-1]]  # beyond the next one
    warped = replace(mesh.warped, points=tuple(points))
    assert list(wrong_shapes(replace(mesh, warped=warped)))


@pytest.mark.parametrize("check", [wrong_ends, wrong_cuts])
def test_a_staircase_upside_down_is_found(
    check: Callable[[MergedMesh], Iterator[object]],
) -> None:
    mesh = mesh_of("cuts are left out")
    longest = max(mesh.projected, key=lambda item: len(item.merged.staircase))
    first, *middle, last = longest.merged.staircase
    merged = longest.merged._replace(staircase=(first, *reversed(middle), last))
    assert not list(check(replace(mesh, projected=(longest,))))
    assert list(check(replace(mesh, projected=(longest._replace(merged=merged),))))
