"""Theorem 4 and its baseline on convex polygons of all kinds, with the lone judge."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from importlib import resources
from pathlib import Path

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from jsonschema import Draft202012Validator

from bern_exact import triangulate
from bern_exact.corpus.convex import FAMILIES
from bern_exact.exact.angles import ANGLE_90
from bern_exact.exact.errors import InputError
from bern_exact.exact.points import HPoint, coordinates
from bern_exact.exact.similarity import Similarity
from bern_exact.interior.sweep import TooManyTriangles
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems import convex_mesh
from bern_exact.theorems.stages import Construction, RefusedOption
from bern_exact.theorems.theorem_4 import bouncing, theorem_4
from tests.convex.polygons import SHAPES, convex_polygons, family, polygon, shape
from tests.theorems.judged import verdict_on

STAGES = ["feature-size", "framed", "bounced", "gridded", "merged", "reduced", "mesh"]


def proved(made: Construction) -> Construction:
    """A construction of which every claim holds, and the lone judge too."""
    assert all(found.holds for found in made.findings if found.role == "guarantee")
    verdict = verdict_on(made, "90")
    assert verdict["valid"], verdict["defects"][:3]
    return made


@settings(max_examples=10)
@given(convex_polygons(7))
def test_no_angle_is_obtuse(shape: Polygon) -> None:
    proved(theorem_4(shape))


@settings(max_examples=4)
@given(convex_polygons(7))
def test_no_angle_is_obtuse_in_the_baseline(shape: Polygon) -> None:
    better, simpler = theorem_4(shape, check="none"), proved(bouncing(shape))
    assert len(better.assembled.mesh.triangles) <= len(simpler.assembled.mesh.triangles)


@pytest.mark.parametrize("name", SHAPES)
def test_single_shapes(name: str) -> None:
    proved(theorem_4(shape(name), as_printed=True))


@pytest.mark.parametrize("name", FAMILIES)
def test_families(name: str) -> None:
    proved(theorem_4(family(name, 16, 2), as_printed=True))


@pytest.mark.parametrize("name", ["random-hull", "regular"])
def test_180_degree_vertices_anywhere(name: str) -> None:
    proved(theorem_4(family(name, 7, 1, parts=3)))


def test_every_triangle_needs_no_more_than_its_altitude() -> None:
    assert len(theorem_4(shape("triangle")).assembled.mesh.triangles) == 2


def test_a_right_triangle_keeps_its_vertices() -> None:
    made = theorem_4(shape("right triangle"))
    assert made.assembled.mesh.vertices[:3] == made.polygon.points


def test_the_stages_in_order() -> None:
    assert list(theorem_4(shape("kite"), check="none").records) == STAGES
    assert list(bouncing(shape("kite"), check="none").records) == [*STAGES[:4], "mesh"]


def test_much_is_saved_with_many_vertices() -> None:
    certificate = triangulate(family("random-hull", 80), theorem=4, check="none").certificate
    assert 2 * certificate.triangles < certificate.counts["gridded"]["baseline_triangles"]


def moved(shape: Polygon, turn: Similarity) -> Polygon:
    return shape.with_points([turn.apply(p) for p in shape.points])


def as_set(made: Construction) -> set[frozenset[HPoint]]:
    at = made.assembled.mesh.vertices
    return {frozenset(at[v] for v in corners) for corners in made.assembled.mesh.triangles}


@pytest.mark.parametrize("seed", range(3))
def test_moved_and_scaled_the_mesh_moves_along(seed: int) -> None:
    turn = Similarity.of((mpq(7, 3), mpq(0)), (mpq(5), mpq(-1, 7)))
    plain = family("random-hull", 12, seed)
    mesh = {frozenset(map(turn.apply, t)) for t in as_set(theorem_4(plain, check="none"))}
    assert mesh == as_set(theorem_4(moved(plain, turn), check="none"))


@pytest.mark.parametrize("seed", range(3))
def test_turned_the_other_way_round_and_relabelled_it_stays(seed: int) -> None:
    plain = family("random-hull", 12, seed)
    pairs = [coordinates(p) for p in plain.points]
    other = polygon([(pairs[5:] + pairs[:5])[::-1]])
    assert as_set(theorem_4(plain, check="none")) == as_set(theorem_4(other, check="none"))


def test_reflex_vertices_are_refused_by_name() -> None:
    dent = [(0, 0), (4, 0), (4, 4), (2, 1), (0, 4)]
    with pytest.raises(InputError) as caught:
        triangulate(dent, theorem=4)
    assert (caught.value.kind, caught.value.where) == ("not-convex", {"vertex": [0, 3]})


def test_a_baseline_too_large_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(convex_mesh, "MOST_TRIANGLES", 10)
    with pytest.raises(TooManyTriangles):
        triangulate(family("random-hull", 12), theorem=4, check="none", baseline=True)


@pytest.mark.parametrize("option", ["max_angle", "interior", "objective", "squares"])
def test_options_of_other_theorems_are_refused(option: str) -> None:
    value = {"max_angle": 140, "interior": "best", "objective": "angle", "squares": True}[option]
    with pytest.raises(RefusedOption, match="not an option of Theorem 4"):
        triangulate(shape("kite"), theorem=4, **{option: value})


def test_thinning_keeps_90_degrees() -> None:
    made = triangulate(family("random-hull", 12), theorem=4, thin=True)
    assert made.certificate.holds and made.certificate.raw is not None
    assert made.certificate.max_angle.is_at_most(ANGLE_90)
    assert made.certificate.triangles < made.certificate.raw.triangles


def test_the_certificate_tells_the_diameter() -> None:
    result = triangulate([(0, 0), (1, 0), (1, 1), (0, 1)], theorem=4)
    record = result.certificate.to_json()
    schema = resources.files("bern_exact").joinpath("schemas", "certificate.schema.json")
    Draft202012Validator(json.loads(schema.read_text())).validate(record)
    assert record["grid_unit"] is None and record["rotation"] is None
    assert record["diameter"] == {
        "vertices": [[0, 0], [0, 2]],
        "squared": "2",
        "alpha": ["1/2", "-1/2"],
        "beta": ["0", "0"],
    }


def test_a_rational_rotation_is_told() -> None:
    certificate = triangulate(shape("right triangle"), theorem=4).certificate
    assert certificate.rotation == (mpq(4, 5), mpq(3, 5))


def test_claims_are_unique_and_put_to_the_test() -> None:
    made = theorem_4(family("random-hull", 40))
    assert len({found.claim for found in made.findings}) == len(made.findings)
    assert not [found.claim for found in made.findings if not found.cases]
    for found in made.findings:
        json.dumps([found.to_json(), found.witness])


PRINTED = """
import hashlib
from bern_exact import triangulate
from tests.convex.polygons import family
for name in ("random-hull", "clustered-spiral"):
    result = triangulate(family(name, 14), theorem=4, as_printed=True, thin=name == "random-hull")
    print(name, hashlib.sha256(result.document.encode()).hexdigest())
"""


def test_the_same_bytes_under_any_hash_seed() -> None:
    first, second = (
        subprocess.run(
            [sys.executable, "-c", PRINTED],
            env={**os.environ, "PYTHONHASHSEED": seed},
            cwd=Path(__file__).resolve().parents[2],
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("0", "4242")
    )
    assert first == second and first.count("\n") == 2
