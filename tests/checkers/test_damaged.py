"""Each claim fails on a record damaged on purpose, and gives a witness."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import TypeVar

import pytest
from gmpy2 import mpq, mpz

from bern_exact.boundary.records import Interval
from bern_exact.checkers.findings import LemmaViolation, demand
from bern_exact.exact.points import HPoint, along, grid_point, reduced
from bern_exact.exact.similarity import Similarity
from bern_exact.interior.records import Column, Rectilinear
from bern_exact.plane.polygon import Polygon
from tests.checkers.samples import CHECKS, Stages, finding, replace, stages_of

T = TypeVar("T")
Damage = Callable[[Stages], Stages]
DAMAGES: list[tuple[str, str, Damage]] = []


def breaks(check: str, *claims: str) -> Callable[[Damage], Damage]:
    """The damage must break these claims of this check."""

    def register(damage: Damage) -> Damage:
        DAMAGES.extend((check, claim, damage) for claim in claims)
        return damage

    return register


def put(items: tuple[T, ...], index: int, item: T) -> tuple[T, ...]:
    """The same tuple with one item replaced."""
    return (*items[:index], item, *items[index + 1 :])


def shifted(p: HPoint, x: mpq | int, y: mpq | int) -> HPoint:
    """The point moved by (x, y)."""
    dx, dy = mpq(x), mpq(y)
    w = p[2] * dx.denominator * dy.denominator
    return reduced(
        p[0] * dx.denominator * dy.denominator + dx.numerator * dy.denominator * p[2],
        p[1] * dx.denominator * dy.denominator + dy.numerator * dx.denominator * p[2],
        w,
    )


def moved_vertex(polygon: Polygon, v: int, p: HPoint) -> Polygon:
    return polygon.with_points(put(polygon.points, v, p))


# Definition 1 and Lemma 1


@breaks("definition-1", "definition-1.feature-size")
def feature_too_large(s: Stages) -> Stages:
    return s.but(feature=replace(s.feature, squared=s.feature.squared + 1))


@breaks("definition-1", "definition-1.feature-size")
def feature_too_small(s: Stages) -> Stages:
    return s.but(feature=replace(s.feature, squared=s.feature.squared * mpq(99, 100)))


@breaks("lemma-1", "lemma-1.feature-size")
def lopped_feature_too_small(s: Stages) -> Stages:
    shorter = replace(s.framed.feature, squared=s.feature.squared / 10)
    return s.but(framed=replace(s.framed, feature=shorter))


@breaks("lemma-1", "lemma-1.structure", "lemma-1.acute")
def acute_corner_left(s: Stages) -> Stages:
    polygon = s.polygon
    return s.but(
        lopped=replace(
            s.lopped, lopped=polygon, origin=tuple(range(polygon.n)), cuts=s.lopped.cuts[:0]
        )
    )


@breaks("lemma-1", "lemma-1.structure")
def vertex_moved(s: Stages) -> Stages:
    kept = next(i for i, v in enumerate(s.lopped.origin) if v >= 0)
    shorter = s.lopped.lopped
    moved = moved_vertex(shorter, kept, shifted(shorter.points[kept], mpq(1, 10**6), 0))
    return s.but(lopped=replace(s.lopped, lopped=moved))


def recut(s: Stages, t: mpq) -> Stages:
    """Both ends of the first cut moved to fractions t of their distance from the corner."""
    cut, shorter = s.lopped.cuts[0], s.lopped.lopped
    corner = s.polygon.points[cut.corner]
    for end in (cut.before, cut.after):
        shorter = moved_vertex(shorter, end, along(corner, shorter.points[end], t))
    return s.but(lopped=replace(s.lopped, lopped=shorter))


@breaks("lemma-1", "lemma-1.cut-points")
def cut_too_far(s: Stages) -> Stages:
    return recut(s, mpq(11, 10))


@breaks("lemma-1", "lemma-1.cut-distance")
def cut_too_near(s: Stages) -> Stages:
    return recut(s, mpq(9, 10))


@breaks("lemma-1", "lemma-1.cut-points", "lemma-1.base-angles")
def cut_askew(s: Stages) -> Stages:
    cut, shorter = s.lopped.cuts[0], s.lopped.lopped
    corner = s.polygon.points[cut.corner]
    longer = along(corner, shorter.points[cut.after], mpq(3))
    return s.but(lopped=replace(s.lopped, lopped=moved_vertex(shorter, cut.after, longer)))


@breaks("lemma-1", "lemma-1.triangle-height")
def feature_of_thin_cuts(s: Stages) -> Stages:
    return s.but(feature=replace(s.feature, squared=s.feature.squared * 1000))


# The frame and dicing


@breaks("framed", "dicing.unit", "dicing.frame")
def unit_too_large(s: Stages) -> Stages:
    return s.but(framed=replace(s.framed, unit=s.framed.unit * 2))


@breaks("framed", "dicing.unit-rounding", "dicing.frame")
def unit_too_small(s: Stages) -> Stages:
    return s.but(framed=replace(s.framed, unit=s.framed.unit / 2))


@breaks("framed", "dicing.frame", "dicing.no-axis-parallel", "dicing.off-grid")
def frame_unturned(s: Stages) -> Stages:
    scale = Similarity.of((1 / s.framed.unit, mpq(0)), (mpq(0), mpq(0)))
    polygon = s.lopped.lopped.with_points([scale.apply(p) for p in s.lopped.lopped.points])
    return s.but(framed=replace(s.framed, polygon=polygon))


@breaks("framed", "dicing.no-diagonal")
def edge_diagonal(s: Stages) -> Stages:
    polygon = s.framed.polygon
    head = shifted(polygon.points[0], 50, 50)
    return s.but(framed=replace(s.framed, polygon=moved_vertex(polygon, polygon.after[0], head)))


@breaks("framed", "dicing.one-vertex-a-sheet")
def two_vertices_in_a_block(s: Stages) -> Stages:
    polygon = s.framed.polygon
    near = shifted(polygon.points[0], mpq(1, 7), mpq(1, 8))
    return s.but(framed=replace(s.framed, polygon=moved_vertex(polygon, polygon.after[0], near)))


@breaks("diced", "dicing.intervals")
def too_many_intervals(s: Stages) -> Stages:
    spare = tuple(Interval(k, 0, 1) for k in range(20 * s.framed.polygon.n))
    return s.but(diced=replace(s.diced, vertical=spare))


@breaks("diced", "dicing.crossings", "dicing.blocks-covered")
def interval_lost(s: Stages) -> Stages:
    return s.but(diced=replace(s.diced, vertical=()))


@breaks("diced", "dicing.crossings")
def crossing_off_its_edge(s: Stages) -> Stages:
    q = s.diced.crossings[3]
    crossings = put(s.diced.crossings, 3, q._replace(at=q.at + mpq(1, 10**9)))
    return s.but(diced=replace(s.diced, crossings=crossings))


# Warping


@breaks("warped", "warping.corner")
def other_corner(s: Stages) -> Stages:
    x, y = s.warped.corners[0]
    return s.but(warped=replace(s.warped, corners=put(s.warped.corners, 0, (x + 2, y))))


@breaks("warped", "warping.corner")
def corner_unmoved(s: Stages) -> Stages:
    n = s.framed.polygon.n
    moved = {g: t for g, t in s.warped.moved.items() if isinstance(t, tuple) or t >= n}
    return s.but(warped=replace(s.warped, moved=moved))


@breaks("warped", "warping.choosers")
def third_chooser(s: Stages) -> Stages:
    choices = dict(s.warped.choices)
    target = next(iter(choices.values()))
    choices.update(dict.fromkeys((0, 1, 2), target))
    return s.but(warped=replace(s.warped, choices=choices))


@breaks("warped", "warping.nearest-chooser")
def choice_forgotten(s: Stages) -> Stages:
    return s.but(warped=replace(s.warped, choices={}))


@breaks("warped", "warping.displacement", "warping.nearest-chooser")
def moved_too_far(s: Stages) -> Stages:
    far = next(j for j, q in enumerate(s.diced.crossings) if abs(q.at - round(q.at)) > mpq(1, 7))
    moved = {**s.warped.moved, (10**6, 10**6): s.framed.polygon.n + far}
    return s.but(warped=replace(s.warped, moved=moved))


@breaks("warped", "warping.on-boundary")
def crossing_slid_off(s: Stages) -> Stages:
    n = s.framed.polygon.n
    own = next(j for j, image in enumerate(s.warped.image) if image == n + j)
    point = shifted(s.warped.points[own], mpq(1, 10**9), 0)
    return s.but(warped=replace(s.warped, points=put(s.warped.points, own, point)))


@breaks("warped", "warping.on-boundary")
def crossing_merged_elsewhere(s: Stages) -> Stages:
    q = s.diced.crossings[0]
    stranger = next(v for v in range(s.framed.polygon.n) if v not in (q.edge, q.edge + 1))
    return s.but(warped=replace(s.warped, image=put(s.warped.image, 0, stranger)))


def with_place(s: Stages, node: int, point: HPoint) -> Stages:
    """A final crossing put elsewhere."""
    j = node - s.framed.polygon.n
    warped = replace(s.warped, points=put(s.warped.points, j, point))
    return s.but(warped=warped, boundary=replace(s.boundary, warped=warped))


def outside_edge(s: Stages) -> tuple[int, tuple[int, int]]:
    """A q-vertex and the grid vertex next to it on a face outside the blocks."""
    n = s.framed.polygon.n
    for face in s.boundary.faces:
        for a, b in zip(face.ring, face.ring[1:], strict=False):
            if face.block < 0 and isinstance(b, tuple) and not isinstance(a, tuple) and a >= n:
                return a, b
    raise LookupError


@breaks("faces", "warping.edge-length")
def edge_too_short(s: Stages) -> Stages:
    a, b = outside_edge(s)
    return with_place(s, a, shifted(grid_point(*b), mpq(1, 10), 0))


@breaks("faces", "warping.slope", "warping.convex", "warping.area")
def interval_too_steep(s: Stages) -> Stages:
    a, b = outside_edge(s)
    return with_place(s, a, shifted(grid_point(*b), 20, 21))


@breaks("faces", "warping.sides")
def too_many_sides(s: Stages) -> Stages:
    i, face = next((i, f) for i, f in enumerate(s.boundary.faces) if f.block < 0)
    ring = tuple((k, 0) for k in range(7))
    faces = put(s.boundary.faces, i, face._replace(ring=ring))
    return s.but(boundary=replace(s.boundary, faces=faces))


@breaks("faces", "warping.area")
def face_lost(s: Stages) -> Stages:
    return s.but(boundary=replace(s.boundary, faces=s.boundary.faces[1:]))


@breaks("faces", "warping.area")
def face_twice(s: Stages) -> Stages:
    return s.but(boundary=replace(s.boundary, faces=s.boundary.faces + s.boundary.faces[:1]))


@breaks("faces", "warping.area")
def loop_of_q_lost(s: Stages) -> Stages:
    return s.but(interior=Rectilinear(s.interior.loops[1:]))


@breaks("faces", "warping.boundary-sides")
def face_at_a_vertex(s: Stages) -> Stages:
    i, face = next((i, f) for i, f in enumerate(s.boundary.faces) if f.block < 0)
    faces = put(s.boundary.faces, i, face._replace(ring=(0, 1, 2, 3)))
    return s.but(boundary=replace(s.boundary, faces=faces))


@breaks("faces", "warping.moved-a-face")
def everything_moves(s: Stages) -> Stages:
    moved = {g: 0 for f in s.boundary.touched for g in f.ring if isinstance(g, tuple)}
    warped = replace(s.warped, moved=moved)
    return s.but(boundary=replace(s.boundary, warped=warped))


# Lemma 2


@breaks("lemma-2", "lemma-2.tiles")
def triangle_lost(s: Stages) -> Stages:
    face = s.boundary.faces[0]
    faces = put(s.boundary.faces, 0, face._replace(triangles=face.triangles[1:]))
    return s.but(boundary=replace(s.boundary, faces=faces))


def reversed_triangles(s: Stages, *, block: bool) -> Stages:
    i, face = next((i, f) for i, f in enumerate(s.boundary.faces) if (f.block >= 0) == block)
    triangles = tuple((r, q, p) for p, q, r in face.triangles)
    faces = put(s.boundary.faces, i, face._replace(triangles=triangles))
    return s.but(boundary=replace(s.boundary, faces=faces))


@breaks("lemma-2", "lemma-2.tiles", "lemma-2.block-angle", "lemma-2.block-height")
def block_clockwise(s: Stages) -> Stages:
    return reversed_triangles(s, block=True)


@breaks("lemma-2", "lemma-2.tiles", "lemma-2.height")
def face_clockwise(s: Stages) -> Stages:
    return reversed_triangles(s, block=False)


@breaks("lemma-2", "lemma-2.block-angle", "lemma-2.block-edges", "lemma-2.block-height")
def block_triangle_thin(s: Stages) -> Stages:
    i, face = next((i, f) for i, f in enumerate(s.boundary.faces) if f.block >= 0)
    corner = s.framed.polygon.points[0]
    spot = (int(corner[0] // corner[2]), int(corner[1] // corner[2]))
    n = s.framed.polygon.n
    warped = replace(
        s.warped,
        image=put(s.warped.image, 0, n),
        points=put(s.warped.points, 0, shifted(grid_point(*spot), mpq(1, 20), mpq(1, 1000))),
    )
    triangle = (spot, (spot[0] + 1, spot[1]), n)
    faces = put(s.boundary.faces, i, face._replace(ring=triangle, triangles=(triangle,)))
    return s.but(boundary=replace(s.boundary, warped=warped, faces=faces))


# Definition 2 and Lemma 3


@breaks("definition-2", "definition-2.matching")
def matching_vertex_missing(s: Stages) -> Stages:
    loop = ((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2))
    return s.but(interior=Rectilinear((loop,)))


@breaks("definition-2", "definition-2.matching")
def sheets_overlap(s: Stages) -> Stages:
    square = ((0, 0), (2, 0), (2, 2), (0, 2))
    taller = ((0, 1), (2, 1), (2, 3), (0, 3))
    return s.but(interior=Rectilinear((square, taller)))


@breaks("definition-2", "definition-2.matching")
def wide_over_narrow(s: Stages) -> Stages:
    wide = ((0, 0), (3, 0), (3, 3), (0, 3))
    narrow = ((1, 1), (2, 1), (2, 2), (1, 2))
    return s.but(interior=Rectilinear((wide, narrow)))


@breaks("definition-2", "definition-2.matching")
def inside_out(s: Stages) -> Stages:
    return s.but(interior=Rectilinear((((0, 0), (0, 1), (1, 1), (1, 0)),)))


@breaks("definition-2", "definition-2.rectilinear")
def slanted(s: Stages) -> Stages:
    return s.but(interior=Rectilinear((((0, 0), (1, 0), (1, 1)),)))


@breaks("definition-2", "definition-2.rectilinear", "definition-2.feature-size")
def vertex_repeated(s: Stages) -> Stages:
    return s.but(interior=Rectilinear((((0, 0), (0, 0), (1, 0), (1, 1), (0, 1)),)))


def with_column(s: Stages, **changes: object) -> Stages:
    item = s.swept.columns[0]._replace(**changes)
    return s.but(swept=replace(s.swept, columns=(item, *s.swept.columns[1:])))


@breaks("lemma-3", "lemma-3.columns", "lemma-3.euler")
def interior_triangle_lost(s: Stages) -> Stages:
    return with_column(s, triangles=s.swept.columns[0].triangles[1:])


@breaks("lemma-3", "lemma-3.columns")
def column_elsewhere(s: Stages) -> Stages:
    return with_column(s, column=Column(-9, -8, 0, 1))


@breaks("lemma-3", "lemma-3.columns")
def side_point_forgotten(s: Stages) -> Stages:
    index, item = next((i, c) for i, c in enumerate(s.swept.columns) if len(c.left) > 2)
    item = item._replace(left=(item.left[0], item.left[-1]))
    return s.but(swept=replace(s.swept, columns=put(s.swept.columns, index, item)))


@breaks("lemma-3", "lemma-3.added", "lemma-3.interior", "lemma-3.euler")
def points_added_outside(s: Stages) -> Stages:
    strangers = frozenset((-(10**6), y) for y in range(10**4))
    return s.but(swept=replace(s.swept, added=s.swept.added | strangers))


@breaks("lemma-3", "lemma-3.interior", "lemma-3.euler")
def point_added_on_the_boundary(s: Stages) -> Stages:
    vertex = s.interior.loops[0][0]
    return s.but(swept=replace(s.swept, added=s.swept.added | {vertex}))


@breaks("lemma-3", "lemma-3.one-subdivision", "lemma-3.columns")
def two_subdivisions(s: Stages) -> Stages:
    return with_column(s, left=(0, 1, 2, 3), right=(0, 3))


@breaks("lemma-3", "lemma-3.height")
def interior_triangle_thin(s: Stages) -> Stages:
    return with_column(s, triangles=(((0, 0), (1, 0), (0, 5)), ((0, 5), (1, 9), (0, 6))))


@breaks("lemma-3", "lemma-3.count", "lemma-3.euler")
def too_many_interior_triangles(s: Stages) -> Stages:
    return with_column(s, triangles=(((0, 0), (1, 0), (0, 1)),) * 10**5)


# Theorem 1


@breaks("theorem-1", "theorem-1.count")
def too_many_triangles(s: Stages) -> Stages:
    mesh = replace(s.mesh, triangles=s.mesh.triangles[:1] * (4851 * s.polygon.n))
    return s.but(mesh=mesh)


@breaks("theorem-1", "theorem-1.grid-height", "theorem-1.height")
def mesh_triangle_clockwise(s: Stages) -> Stages:
    p, q, r = s.mesh.triangles[-1]
    return s.but(mesh=replace(s.mesh, triangles=(*s.mesh.triangles[:-1], (r, q, p))))


@breaks("theorem-1", "theorem-1.grid-height", "theorem-1.height")
def mesh_triangle_thin(s: Stages) -> Stages:
    p, q, r = s.mesh.triangles[0]
    a, b = s.mesh.vertices[p], s.mesh.vertices[q]
    x, y, w = along(a, b, mpq(1, 2))
    # Just left of the midpoint of the first edge.
    dx, dy = b[0] * a[2] - a[0] * b[2], b[1] * a[2] - a[1] * b[2]
    scale = mpz(10**9) * a[2] * b[2]
    off = reduced(x * scale - dy * w, y * scale + dx * w, w * scale)
    return s.but(mesh=replace(s.mesh, vertices=put(s.mesh.vertices, r, off)))


@breaks("theorem-1", "theorem-1.valid")
def judged_invalid(s: Stages) -> Stages:
    return s.but(verdict=SimpleNamespace(valid=False, defects=("overlap",)))


@pytest.mark.parametrize(
    ("check", "claim", "damage"),
    DAMAGES,
    ids=[f"{damage.__name__}-{claim}" for _, claim, damage in DAMAGES],
)
def test_damage_is_found(check: str, claim: str, damage: Damage) -> None:
    found = finding(damage(stages_of("plate")), check, claim)
    assert not found.holds
    assert found.witness is not None


def test_a_violation_is_raised_with_its_witness() -> None:
    damaged = face_lost(stages_of("plate"))
    with pytest.raises(LemmaViolation, match=r"warping\.area"):
        demand(CHECKS["faces"](damaged))


def test_every_claim_has_a_damage_that_breaks_it() -> None:
    claims = {f.claim for check in CHECKS.values() for f in check(stages_of("plate"))}
    assert claims == {claim for _, claim, _ in DAMAGES}
