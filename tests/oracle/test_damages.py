"""Damages on purpose: every judge reports each under its own name and at its place."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import cache
from typing import Any

import pytest
from gmpy2 import mpq

from bern_exact.corpus import convex, paper, shapes, slits
from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.exact.points import hpoint
from bern_exact.formats.mesh_json import mesh_document, read_mesh
from bern_exact.formats.polygon_json import dump_polygon
from bern_exact.oracle import judge as lone
from bern_exact.oracle.defects import DAMAGES, Damage, Damaged, damage
from bern_exact.oracle.fast import verify_mesh
from bern_exact.oracle.filtered import verify_arrays
from bern_exact.oracle.verdict import DEFECTS
from bern_exact.plane.array_mesh import ArrayMesh
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import triangulate_polygon
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems.theorem_1 import theorem_1
from bern_exact.theorems.theorem_3 import theorem_3
from bern_exact.theorems.theorem_4 import theorem_4
from tests.theorems.families import FAMILIES, ring, some_polygon

LIMIT = 200
"""Enough to hear of every kind; to name and place all of thousands takes long."""

Sample = tuple[Mesh, Polygon]


def by_lone_judge(damaged: Damaged) -> dict[str, Any]:
    polygon = None if damaged.polygon is None else dump_polygon(damaged.polygon)
    return lone.judge(mesh_document(damaged.mesh), polygon, limit=LIMIT, **damaged.criterion)


def bounds_of(damaged: Damaged) -> dict[str, Any]:
    """The criterion as our own judges take it."""
    angle = damaged.max_angle
    return {
        "max_angle": None if angle is None else parse_angle_bound(angle),
        "min_height_squared": damaged.min_height_squared,
        "max_triangles": damaged.max_triangles,
        "limit": LIMIT,
    }


def by_fast_judge(damaged: Damaged) -> dict[str, Any]:
    return verify_mesh(damaged.mesh, damaged.polygon, **bounds_of(damaged)).to_json()


def by_filtered_judge(damaged: Damaged) -> dict[str, Any]:
    arrays = ArrayMesh.of_mesh(damaged.mesh)
    return verify_arrays(arrays, damaged.polygon, **bounds_of(damaged)).to_json()


Judge = Callable[[Damaged], dict[str, Any]]

JUDGES: dict[str, Judge] = {
    "lone": by_lone_judge,
    "fast": by_fast_judge,
    "filtered": by_filtered_judge,
}

# A judge in plain Python gets one in so many of the damages on a mesh of this many triangles.
PATIENCE: dict[Judge, int] = {by_lone_judge: 1}
WHOLE = ("corpus-plate/refined", "threshold/refined")  # small meshes of which it gets all
every_judge = pytest.mark.parametrize("judge", JUDGES.values(), ids=JUDGES)

CORPUS: dict[str, list[list[tuple[Any, Any]]]] = {
    "corpus-star": shapes.star(9, 1),
    "corpus-maze": shapes.maze(14, 1),
    "corpus-spiral": shapes.spiral(12, 1),
    "corpus-plate": shapes.plate(8, 1),
    "corpus-hull": convex.random_hull(7, 1),
    "corpus-regular": convex.regular(8),
    "corpus-needle": convex.needle(5, 1),
    "corpus-clustered": convex.clustered_spiral(8, 1),
    "corpus-slit": slits.slit(1000),
    "corpus-comb": slits.comb(3, 1000),
    "corpus-hole-grid": paper.hole_grid(2),
    "corpus-thin": paper.thin_rectangle(5),
}


@cache
def polygon_of(name: str) -> Polygon:
    if name in CORPUS:
        return polygon_from_rings([ring(each) for each in CORPUS[name]], name)
    return min((some_polygon(name, seed) for seed in range(4)), key=lambda polygon: polygon.n)


def plain(polygon: Polygon) -> Sample:
    """A triangulation by the polygon's vertices."""
    return Mesh(polygon.points, tuple(triangulate_polygon(polygon).triangles())), polygon


def refined(polygon: Polygon) -> Sample:
    """The same with a few vertices more, by harmless damages."""
    mesh, _ = plain(polygon)
    ways = ("triangle-split", "inner-edge-split", "boundary-edge-split", "edge-flipped")
    for seed, name in enumerate(ways):
        made = damage(mesh, polygon, name, seed)
        mesh = mesh if made is None else made.mesh
    return mesh, polygon


@cache
def sample(name: str) -> Sample:
    """Meshes: of every family a plain or a refined one, and a few by the theorems."""
    family, _, way = name.partition("/")
    polygon = polygon_of(family)
    makers: dict[str, Callable[[Polygon], Sample]] = {"plain": plain, "refined": refined}
    if way in makers:
        return makers[way](polygon)
    construct = {"1": theorem_1, "3": theorem_3, "4": theorem_4}[way]
    return construct(polygon, check="none").assembled.mesh, polygon


SAMPLES = [
    *(f"{name}/refined" for name in (*FAMILIES, *CORPUS)),
    "triangle/plain",
    "simple/plain",
    "plate/plain",
    "triangle/1",
    "corpus-thin/3",
    "corpus-hull/4",
]
BARE = ["simple_with_holes/refined", "corpus-slit/refined", "special_frame/refined"]
every_sample = pytest.mark.parametrize("name", SAMPLES)

UNDAMAGED = Damage("undamaged", "", None, frozenset(), False, lambda sound: None)


@cache
def damages_of(name: str, *, bare: bool, seed: int = 0) -> list[Damaged]:
    """Every damage that a mesh has a place for, judged against its polygon or (bare) without."""
    mesh, polygon = sample(name)
    made = [damage(mesh, None if bare else polygon, way, seed) for way in DAMAGES]
    return [damaged for damaged in made if damaged is not None]


def share_of(judge: Judge, name: str, made: list[Damaged]) -> list[Damaged]:
    """All, or for a slow judge some, other ones for each mesh."""
    if judge not in PATIENCE or name in WHOLE:
        return made
    step = 1 + len(sample(name)[0].triangles) // PATIENCE[judge]
    return made[SAMPLES.index(name) % step :: step]


def insist(damaged: Damaged, verdict: dict[str, Any]) -> None:
    """The verdict has the defect's own name and place, and names nothing that is not there."""
    way = damaged.damage
    found = {defect["kind"] for defect in verdict["defects"]}
    if way.kind is None:
        assert verdict["valid"] and not found, way
        return
    assert not verdict["valid"], way
    assert found <= way.besides | {way.kind}, (way, found)
    places = [d["where"] for d in verdict["defects"] if d["kind"] == way.kind]
    assert damaged.where in places, (way, damaged.where, places)


@every_judge
@every_sample
def test_each_is_reported_under_its_own_name_at_its_place(name: str, judge: Judge) -> None:
    for damaged in share_of(judge, name, damages_of(name, bare=False)):
        insist(damaged, judge(damaged))


@every_judge
@pytest.mark.parametrize("name", BARE)
def test_each_that_needs_no_polygon_is_reported_without_one(name: str, judge: Judge) -> None:
    for damaged in share_of(judge, name, damages_of(name, bare=True)):
        insist(damaged, judge(damaged))


@every_judge
@every_sample
def test_nothing_is_wrong_with_an_undamaged_mesh(name: str, judge: Judge) -> None:
    mesh, polygon = sample(name)
    for given in (polygon, None):
        insist(Damaged(UNDAMAGED, mesh, given, {}), judge(Damaged(UNDAMAGED, mesh, given, {})))


def test_every_kind_of_defect_is_made() -> None:
    assert {way.kind for way in DAMAGES.values()} == {None, *DEFECTS}
    made = {d.kind for name in SAMPLES for d in damages_of(name, bare=False)}
    assert made == {None, *DEFECTS}


@every_judge
def test_every_damage_reaches_every_judge(judge: Judge) -> None:
    shares = (share_of(judge, name, damages_of(name, bare=False)) for name in SAMPLES)
    assert {damaged.damage.name for share in shares for damaged in share} == set(DAMAGES)


def test_a_good_share_of_them_leaves_the_mesh_valid() -> None:
    assert len(DAMAGES) >= 50
    assert sum(way.kind is None for way in DAMAGES.values()) >= 10


def test_kinds_are_those_of_the_judges() -> None:
    for way in DAMAGES.values():
        assert way.besides <= set(DEFECTS) and (way.kind is None or way.kind in DEFECTS)


@pytest.mark.parametrize("name", ["corpus-plate/refined", "high_bits/refined"])
def test_the_seed_decides(name: str) -> None:
    first, again, other = (
        [d.mesh for d in damages_of(name, bare=False, seed=seed)] for seed in (3, 3, 4)
    )
    assert first == again and first != other


@pytest.mark.parametrize("way", DAMAGES)
def test_a_damage_damages_and_leaves_the_mesh_given_as_it_was(way: str) -> None:
    mesh, polygon = sample("corpus-hole-grid/refined")
    before = (mesh.vertices, mesh.triangles, polygon.points)
    made = damage(mesh, polygon, way, 0)
    assert (mesh.vertices, mesh.triangles, polygon.points) == before
    if made is None:
        assert way in ("corner-cut-off", "pocket-covered")
    else:
        assert (made.mesh, made.polygon) != (mesh, polygon) or made.criterion


def test_what_is_written_says_all() -> None:
    """From the files alone the lone judge finds what they say."""
    for damaged in damages_of("triangle/refined", bare=False):
        told = json.loads(json.dumps(damaged.to_json()))
        assert told["result"] == ("valid" if told["kind"] is None else "invalid")
        document = json.loads(json.dumps(mesh_document(damaged.mesh, damaged.polygon)))
        assert read_mesh(document)[0] == damaged.mesh
        assert lone.judge(document, **told["criterion"])["valid"] == (told["result"] == "valid")
        if told["where"]:
            assert told["points"]


def test_moves_are_tiny() -> None:
    """A vertex on an edge 4 long is moved by 4 / 10^40, exactly."""
    corners = [(0, 0), (4, 0), (4, 4), (0, 4)]
    polygon = polygon_from_rings([[hpoint(x, y) for x, y in corners]])
    mesh = Mesh((*polygon.points, hpoint(2, 0)), ((0, 4, 3), (4, 1, 2), (4, 2, 3)))
    made = damage(mesh, polygon, "boundary-vertex-outwards", 0)
    assert made is not None and made.where == {"vertex": 4}
    assert made.mesh.vertices[4] == hpoint(2, mpq(-2, 10**40))


def test_what_needs_a_hole_or_a_polygon_is_not_made_without() -> None:
    mesh, polygon = sample("triangle/plain")
    assert damage(mesh, polygon, "hole-filled", 0) is None
    assert damage(mesh, None, "polygon-vertex-moved", 0) is None


def test_an_unknown_damage_is_refused() -> None:
    mesh, polygon = sample("triangle/plain")
    with pytest.raises(KeyError):
        damage(mesh, polygon, "mesh-improved", 0)


def test_a_judge_that_says_less_fails() -> None:
    """The test of the tests: a verdict without the defect, without its place, or with more."""
    (made,) = [d for d in damages_of("triangle/refined", bare=False) if d.kind == "unused-vertex"]
    verdict = by_fast_judge(made)
    insist(made, verdict)
    (defect,) = verdict["defects"]
    moved = {**defect, "where": {"vertex": 0}}
    another = {**defect, "kind": "overlap"}
    for wrong in ([], [moved], [another], [defect, another]):
        with pytest.raises(AssertionError):
            insist(made, {**verdict, "defects": wrong})
    with pytest.raises(AssertionError):
        insist(made, {**verdict, "valid": True})
