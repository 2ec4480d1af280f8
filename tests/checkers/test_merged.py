"""Section 3 near the boundary: claims hold on sound records and fail on damaged ones."""

from __future__ import annotations

import json
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, TypeVar

import pytest
from gmpy2 import mpq

from bern_exact import triangulate
from bern_exact.boundary.records import Projected
from bern_exact.checkers import bounds
from bern_exact.checkers.findings import demand
from bern_exact.checkers.lemma_4 import check_lemma_4
from bern_exact.checkers.lemma_5 import check_lemma_5
from bern_exact.checkers.printed_ends import check_merged_as_printed
from bern_exact.checkers.warping import check_faces
from bern_exact.corpus.errata import BY_NAME
from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.exact.angles import ANGLE_150, ANGLE_180
from bern_exact.exact.points import along, grid_point
from tests.checkers.merged_samples import (
    CHECKS,
    SIMPLE,
    Merged,
    boundary_of,
    finding,
    merged_of,
    region_of,
)
from tests.checkers.samples import THINGS, replace

T = TypeVar("T")
Damage = Callable[[Merged], Merged]
DAMAGES: list[tuple[str, str, Damage]] = []


def breaks(check: str, *claims: str) -> Callable[[Damage], Damage]:
    """The damage must break these claims of this check."""

    def register(damage: Damage) -> Damage:
        DAMAGES.extend((check, claim, damage) for claim in claims)
        return damage

    return register


def put(items: tuple[T, ...], index: int, item: T) -> tuple[T, ...]:
    return (*items[:index], item, *items[index + 1 :])


def with_mesh(s: Merged, **changes: Any) -> Merged:
    return s.but(merged=replace(s.merged, **changes))


def with_item(s: Merged, index: int, **changes: Any) -> Merged:
    """One cut-up face changed."""
    item = s.merged.projected[index]._replace(**changes)
    return with_mesh(s, projected=put(s.merged.projected, index, item))


def with_face(s: Merged, index: int, **changes: Any) -> Merged:
    """One merged face changed."""
    return with_item(s, index, merged=s.merged.projected[index].merged._replace(**changes))


def first(s: Merged, wanted: Callable[[Projected], bool]) -> int:
    return next(i for i, item in enumerate(s.merged.projected) if wanted(item))


def with_foot(s: Merged, index: int, move: Callable[[Projected], Any]) -> Merged:
    """The first projection of a face put elsewhere."""
    item = s.merged.projected[index]
    number = item.cuts[0][1] - s.framed.polygon.n - len(s.merged.warped.points)
    return with_mesh(s, projections=put(s.merged.projections, number, move(item)))


# Lemma 4


@breaks("lemma-4", "lemma-4.base")
def base_backwards(s: Merged) -> Merged:
    return with_face(s, 0, base=s.merged.projected[0].merged.base[::-1])


@breaks("lemma-4", "lemma-4.base")
def base_off_its_edge(s: Merged) -> Merged:
    base = s.merged.projected[0].merged.base
    return with_face(s, 0, base=(base[0], (0, 0), base[-1]))


@breaks("lemma-4", "lemma-4.monotone", "lemma-4.slope", "lemma-4.union")
def staircase_winds(s: Merged) -> Merged:
    index = first(s, lambda item: len(item.merged.staircase) > 4)
    a, b, c, *rest = s.merged.projected[index].merged.staircase
    return with_face(s, index, staircase=(a, c, b, *rest))


@breaks("lemma-4", "lemma-4.slope", "lemma-4.union")
def staircase_shortened(s: Merged) -> Merged:
    index = first(s, lambda item: len(item.merged.staircase) > 4)
    a, b, _, *rest = s.merged.projected[index].merged.staircase
    return with_face(s, index, staircase=(a, b, *rest[1:]))


@breaks("lemma-4", "lemma-4.clipped")
def clipped_by_the_other_sign(s: Merged) -> Merged:
    polygon = s.framed.polygon
    face = s.merged.projected[0].merged
    a, b, _ = polygon.lines[face.edge]
    other = next(e for e, (c, d, _) in enumerate(polygon.lines) if a * b * c * d < 0)
    chain = (face.base[0], other, polygon.after[other], face.base[-1])
    return with_face(s, 0, staircase=chain)


@breaks("lemma-4", "lemma-4.once")
def merged_face_lost(s: Merged) -> Merged:
    return with_mesh(s, projected=s.merged.projected[1:])


@breaks("lemma-4", "lemma-4.once", "lemma-4.union")
def face_used_twice(s: Merged) -> Merged:
    return with_face(s, 0, faces=s.merged.projected[1].merged.faces)


@breaks("lemma-4", "lemma-4.once")
def face_out_of_range(s: Merged) -> Merged:
    return with_face(s, 0, faces=(*s.merged.projected[0].merged.faces, 10**9))


@breaks("lemma-4", "lemma-4.once")
def block_lost(s: Merged) -> Merged:
    return with_mesh(s, faces=s.merged.faces[1:])


@breaks("lemma-4", "lemma-4.where")
def merged_too_little(s: Merged) -> Merged:
    index = first(s, lambda item: len(item.merged.faces) > 1)
    item = s.merged.projected[index]
    one, *others = item.merged.faces
    rest = item._replace(merged=item.merged._replace(faces=tuple(others)))
    alone = item._replace(merged=item.merged._replace(faces=(one,)))
    return with_mesh(s, projected=(*put(s.merged.projected, index, alone), rest))


@breaks("lemma-4", "lemma-4.where")
def merged_at_the_image_of_a_grid_vertex(s: Merged) -> Merged:
    item = s.merged.projected[first(s, lambda item: len(item.merged.faces) > 1)]
    moved = {**s.merged.warped.moved, (10**6, 10**6): item.merged.base[1]}
    return with_mesh(s, warped=replace(s.merged.warped, moved=moved))


# Lemma 5


@breaks("lemma-5", "lemma-2.tiles")
def block_triangle_lost(s: Merged) -> Merged:
    face = s.merged.faces[0]
    return with_mesh(s, faces=put(s.merged.faces, 0, face._replace(triangles=face.triangles[1:])))


@breaks("lemma-5", "lemma-2.block-angle", "lemma-2.block-height")
def block_clockwise(s: Merged) -> Merged:
    i, face = next((i, f) for i, f in enumerate(s.merged.faces) if f.block >= 0)
    triangles = tuple((r, q, p) for p, q, r in face.triangles)
    return with_mesh(s, faces=put(s.merged.faces, i, face._replace(triangles=triangles)))


@breaks("lemma-5", "lemma-2.height", "lemma-5.angle")
def rectangle_clockwise(s: Merged) -> Merged:
    i, face = next((i, f) for i, f in enumerate(s.merged.faces) if f.block < 0)
    triangles = tuple((r, q, p) for p, q, r in face.triangles)
    return with_mesh(s, faces=put(s.merged.faces, i, face._replace(triangles=triangles)))


@breaks("lemma-5", "lemma-2.block-edges")
def block_triangle_small(s: Merged) -> Merged:
    i, face = next((i, f) for i, f in enumerate(s.merged.faces) if f.block >= 0)
    corner = next(node for node in face.ring if isinstance(node, tuple))
    close = len(s.merged.projections) + s.framed.polygon.n + len(s.merged.warped.points)
    x, y = corner
    point = along(grid_point(x, y), grid_point(x + 1, y), mpq(1, 9))
    triangle = (corner, close, (x, y + 1))
    faces = put(s.merged.faces, i, face._replace(ring=triangle, triangles=(triangle,)))
    return with_mesh(s, faces=faces, projections=(*s.merged.projections, point))


def is_cut(item: Projected) -> bool:
    return len(item.cuts) > 2


@breaks("lemma-5", "lemma-5.projections")
def foot_off_the_edge(s: Merged) -> Merged:
    return with_foot(s, first(s, is_cut), lambda item: grid_point(*item.cuts[0][0]))


@breaks("lemma-5", "lemma-5.projections")
def diagonal_askew(s: Merged) -> Merged:
    index = first(s, is_cut)
    feet = s.merged.point_of
    return with_foot(
        s, index, lambda item: along(feet(item.cuts[0][1]), feet(item.cuts[1][1]), mpq(1, 2))
    )


@breaks("lemma-5", "lemma-5.projections", "lemma-5.base")
def foot_at_the_end(s: Merged) -> Merged:
    index = first(s, is_cut)
    feet = s.merged.point_of
    return with_foot(
        s,
        index,
        lambda item: along(feet(item.merged.base[0]), feet(item.cuts[0][1]), mpq(1, 10**6)),
    )


@breaks("lemma-5", "lemma-5.projections", "lemma-5.pieces")
def cuts_out_of_order(s: Merged) -> Merged:
    index = first(s, is_cut)
    a, b, *rest = s.merged.projected[index].cuts
    return with_item(s, index, cuts=(b, a, *rest))


@breaks("lemma-5", "lemma-5.projections", "lemma-5.pieces")
def foot_of_another_face(s: Merged) -> Merged:
    index = first(s, is_cut)
    (apex, _), *rest = s.merged.projected[index].cuts
    other = next(item for item in s.merged.projected[index + 1 :] if item.cuts)
    return with_item(s, index, cuts=((apex, other.cuts[0][1]), *rest))


@breaks("lemma-5", "lemma-5.projections")
def point_that_nothing_uses(s: Merged) -> Merged:
    return with_mesh(s, projections=(*s.merged.projections, grid_point(0, 0)))


@breaks("lemma-5", "lemma-5.pieces")
def piece_lost(s: Merged) -> Merged:
    return with_item(s, 0, pieces=s.merged.projected[0].pieces[1:])


@breaks("lemma-5", "lemma-5.tiles")
def piece_with_a_triangle_less(s: Merged) -> Merged:
    (ring, triangles), *rest = s.merged.projected[0].pieces
    return with_item(s, 0, pieces=((ring, triangles[1:]), *rest))


@breaks("lemma-5", "lemma-5.trapezoids", "lemma-5.pieces")
def trapezoids_joined(s: Merged) -> Merged:
    index = first(s, is_cut)
    pieces = s.merged.projected[index].pieces
    (one, triangles), (two, others) = pieces[1:3]
    ring = (one[0], two[1], *two[2:-1], *one[2:])
    joined = (ring, (*triangles, *others))
    return with_item(s, index, pieces=(pieces[0], joined, *pieces[3:]))


@breaks("lemma-5", "lemma-5.angle", "lemma-5.height", "lemma-5.tiles")
def piece_clockwise(s: Merged) -> Merged:
    (ring, triangles), *rest = s.merged.projected[0].pieces
    flipped = tuple((r, q, p) for p, q, r in triangles)
    return with_item(s, 0, pieces=((ring, flipped), *rest))


# The faces behind a merged boundary


@breaks("faces", "warping.area")
def nothing_merged(s: Merged) -> Merged:
    return merged_face_lost(s)


@breaks("faces", "warping.area")
def staircase_off_the_grid(s: Merged) -> Merged:
    return staircase_shortened(s)


@breaks("faces", "warping.edge-length", "warping.slope")
def crossing_slid_along(s: Merged) -> Merged:
    """A crossing between two merged faces put next to the following one."""
    index = first(s, lambda item: len(item.merged.faces) > 1)
    _, middle, following, *_ = s.merged.projected[index].merged.base
    where = s.merged.point_of
    point = along(where(following), where(middle), mpq(1, 1000))
    j = middle - s.framed.polygon.n
    warped = replace(s.merged.warped, points=put(s.merged.warped.points, j, point))
    return with_mesh(s, warped=warped)


# Theorems 2 and 3


def breaks_both(*claims: str) -> Callable[[Damage], Damage]:
    """The damage must break the claim of either theorem."""

    def register(damage: Damage) -> Damage:
        for theorem in ("theorem-2", "theorem-3"):
            DAMAGES.extend((theorem, f"{theorem}.{claim}", damage) for claim in claims)
        return damage

    return register


@breaks_both("count")
def too_few_vertices_for_it(s: Merged) -> Merged:
    return s.but(polygon=SimpleNamespace(n=0))


@breaks_both("angle")
def asked_for_less(s: Merged) -> Merged:
    return s.but(angle_bound=parse_angle_bound("100.5"))


@breaks_both("angle", "threshold-angle")
def large_angle(s: Merged) -> Merged:
    return s.but(
        verdict=SimpleNamespace(valid=True, defects=(), max_angle=ANGLE_180, max_angle_triangle=0)
    )


@breaks_both("threshold-angle")
def angle_just_150(s: Merged) -> Merged:
    return s.but(
        verdict=SimpleNamespace(valid=True, defects=(), max_angle=ANGLE_150, max_angle_triangle=0)
    )


@breaks_both("fan-angle", "grid-height", "height")
def fan_clockwise(s: Merged) -> Merged:
    p, q, r = s.mesh.triangles[-1]
    return s.but(mesh=replace(s.mesh, triangles=(*s.mesh.triangles[:-1], (r, q, p))))


@breaks_both("grid-height", "height")
def unit_and_feature_large(s: Merged) -> Merged:
    feature = replace(s.feature, squared=s.feature.squared * 10**6)
    return s.but(feature=feature, framed=replace(s.framed, unit=s.framed.unit * 1000))


@breaks_both("boundary-count")
def boundary_many_times(s: Merged) -> Merged:
    return with_mesh(s, faces=s.merged.faces * 2000)


@breaks_both("valid")
def judged_invalid(s: Merged) -> Merged:
    return s.but(verdict=replace(s.verdict, valid=False))


@pytest.mark.parametrize(
    ("check", "claim", "damage"),
    DAMAGES,
    ids=[f"{damage.__name__}-{claim}" for _, claim, damage in DAMAGES],
)
def test_damage_is_found(check: str, claim: str, damage: Damage) -> None:
    found = finding(damage(merged_of("slender")), check, claim)
    assert not found.holds
    assert found.witness is not None
    json.dumps([found.to_json(), found.witness])


def test_every_claim_has_a_damage_that_breaks_it() -> None:
    sound = merged_of("slender")
    claims = {f.claim for name, check in CHECKS.items() if name != "faces" for f in check(sound)}
    assert claims == {claim for check, claim, _ in DAMAGES if check != "faces"}


def test_the_sample_puts_every_claim_to_the_test() -> None:
    sound = merged_of("slender")
    findings = [f for check in CHECKS.values() for f in check(sound)]
    assert [f.claim for f in findings if f.cases == 0] == []
    assert len({f.claim for f in findings}) == len(findings)


@pytest.mark.parametrize("degrees", ["150", "140", "135.2"])
@pytest.mark.parametrize("name", SIMPLE)
def test_every_guarantee_holds(name: str, degrees: str) -> None:
    records = merged_of(name, degrees)
    for check in CHECKS.values():
        demand(check(records))


@pytest.mark.parametrize("name", [name for name, thing in THINGS.items() if thing.holes])
def test_every_boundary_guarantee_holds_with_holes(name: str) -> None:
    mesh = boundary_of(name)
    demand(check_lemma_4(mesh))
    demand(check_lemma_5(mesh))
    demand(check_faces(mesh, region_of(mesh)))


def test_height_does_not_come_for_free_at_the_end_faces() -> None:
    shape, _, height = check_merged_as_printed(merged_of("end-face").merged)
    assert shape.holds and not height.holds
    assert mpq(height.measured) < mpq(1, 10**7)


def test_an_end_face_may_have_more_than_150_degrees() -> None:
    made = triangulate(BY_NAME["obtuse-end-face"].rings, theorem=2)
    shape, angle, _ = check_merged_as_printed(made.stages["merged"])
    assert shape.holds and not angle.holds
    assert -2 < mpq(angle.measured) < mpq(-179, 100)


def test_merged_faces_lower_than_other_boundary_faces_can_be() -> None:
    """The bound of Lemma 2, tau/sqrt 2, is not Lemma 5's, even for the paper's tau."""
    found = finding(merged_of("low-corner"), "lemma-5", "lemma-5.height")
    assert bounds.merged_height_squared() <= mpq(found.measured) < bounds.boundary_height_squared()
