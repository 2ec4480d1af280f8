"""Damages on purpose: every judge reports each under its own name and at its place."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import pytest

from bern_exact.corpus import convex, paper, shapes, slits
from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.formats.mesh_json import mesh_document
from bern_exact.formats.polygon_json import dump_polygon
from bern_exact.oracle import judge as lone
from bern_exact.oracle.defects import DAMAGES, Damaged, damage
from bern_exact.oracle.fast import verify_mesh
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import triangulate_polygon
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems.theorem_1 import theorem_1
from bern_exact.theorems.theorem_3 import theorem_3
from bern_exact.theorems.theorem_4 import theorem_4
from tests.theorems.families import FAMILIES, ring, some_polygon

ALL = 10**6
"""More defects than there are."""

Sample = tuple[Mesh, Polygon]


def by_lone_judge(damaged: Damaged) -> dict[str, Any]:
    polygon = None if damaged.polygon is None else dump_polygon(damaged.polygon)
    return lone.judge(mesh_document(damaged.mesh), polygon, limit=ALL, **damaged.criterion)


def by_fast_judge(damaged: Damaged) -> dict[str, Any]:
    angle = damaged.max_angle
    return verify_mesh(
        damaged.mesh,
        damaged.polygon,
        max_angle=None if angle is None else parse_angle_bound(angle),
        min_height_squared=damaged.min_height_squared,
        max_triangles=damaged.max_triangles,
        limit=ALL,
    ).to_json()


JUDGES: dict[str, Callable[[Damaged], dict[str, Any]]] = {
    "lone": by_lone_judge,
    "fast": by_fast_judge,
}
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
    return some_polygon(name, 1)


def plain(polygon: Polygon) -> Sample:
    """A triangulation by the polygon's vertices."""
    return Mesh(polygon.points, tuple(triangulate_polygon(polygon).triangles())), polygon


def refined(polygon: Polygon) -> Sample:
    """The same with a few vertices more, by harmless damages."""
    mesh, _ = plain(polygon)
    ways = ("triangle-split", "inner-edge-split", "boundary-edge-split", "edge-flipped") * 2
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
every_sample = pytest.mark.parametrize("name", SAMPLES)


def damages_of(name: str, seed: int = 0) -> list[Damaged]:
    mesh, polygon = sample(name)
    made = [damage(mesh, given, way, seed) for way in DAMAGES for given in (polygon, None)]
    return [damaged for damaged in made if damaged is not None]


@every_judge
@every_sample
def test_each_is_reported_under_its_own_name_at_its_place(
    name: str, judge: Callable[[Damaged], dict[str, Any]]
) -> None:
    for damaged in damages_of(name):
        way, verdict = damaged.damage, judge(damaged)
        found = {defect["kind"] for defect in verdict["defects"]}
        if way.kind is None:
            assert verdict["valid"] and not found, way
            continue
        assert not verdict["valid"] and found - way.besides - {way.kind} == set(), way
        places = [d["where"] for d in verdict["defects"] if d["kind"] == way.kind]
        assert damaged.where in places, (way, damaged.where, places)
