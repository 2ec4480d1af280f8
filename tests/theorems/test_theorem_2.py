"""Theorem 2: simple polygons of all kinds, with every check, the angles by the lone judge."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from gmpy2 import mpq
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from bern_exact import Polygon, triangulate
from bern_exact.boundary.merge import Objective
from bern_exact.checkers.findings import LemmaViolation
from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.exact.errors import InputError
from bern_exact.interior.subdivided.records import Partition
from bern_exact.plane.feature_size import feature_size
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems import no_large_angle as module
from bern_exact.theorems.assemble import CLASSES
from bern_exact.theorems.stages import Check
from bern_exact.theorems.theorem_2 import theorem_2
from bern_exact.theorems.theorem_3 import theorem_3
from tests.campaign import without_holes
from tests.plane.shapes import polygons
from tests.theorems.families import FAMILIES, mapped, some_polygon
from tests.theorems.judged import proved_without_large_angles as proved
from tests.theorems.outlines import EXAMPLES, cases
from tests.theorems.test_metamorphic import MOVES, relabelled, rings_of

ROOT = Path(__file__).resolve().parents[2]

WHOLE = [path for path in EXAMPLES if not Polygon.load(path).holes]
SMALL = [path for path in WHOLE if path.stat().st_size <= 20_000]
LARGE = [path for path in WHOLE if path not in SMALL]

STAGES = [
    "feature-size",
    "lopped",
    "framed",
    "diced",
    "traced",
    "warped",
    "merged",
    "interior",
    "partition",
    "tiled",
    "mesh",
]

DRAWS = [("simple", 3), ("nearly_right", 1), ("threshold", 20), ("star", 4), ("octilinear", 3)]

draws = pytest.mark.parametrize(("kind", "seed"), DRAWS)
few = settings(max_examples=8, suppress_health_check=[HealthCheck.too_slow])


def simple(kind: str, seed: int) -> Polygon:
    """The outer ring of a polygon of a family."""
    return without_holes(some_polygon(kind, seed))


# Polygons of all kinds --------------------------------------------------------------


@pytest.mark.parametrize("kind", FAMILIES)
@pytest.mark.parametrize("seed", [3])
def test_every_family(kind: str, seed: int) -> None:
    proved(simple(kind, seed))


@few
@given(polygons())
def test_small_polygons_that_shrink(polygon: Polygon) -> None:
    proved(without_holes(polygon))


@few
@given(
    kind=st.sampled_from(sorted(FAMILIES)),
    seed=st.integers(100, 10**9),
    max_angle=st.sampled_from(["149.5", "140", "136", "135.2", "cos:-1:25/34"]),
    objective=st.sampled_from(["height", "angle"]),
    squares=st.booleans(),
)
def test_any_seed_of_any_family_with_any_options(
    kind: str, seed: int, max_angle: str, objective: Objective, squares: bool
) -> None:
    proved(simple(kind, seed), max_angle, objective=objective, squares=squares)


@pytest.mark.parametrize("path", SMALL, ids=lambda path: path.stem)
def test_real_polygons_without_holes(path: Path) -> None:
    polygon = Polygon.load(path)
    made = proved(polygon)
    assert made.assembled.mesh.vertices[: polygon.n] == polygon.points


@pytest.mark.parametrize("path", cases(LARGE))
def test_large_real_polygons_without_holes(path: Path) -> None:
    made = theorem_2(Polygon.load(path), check="final")
    assert all(found.holds for found in made.findings) and made.findings


# The angle bound ----------------------------------------------------------------------


@draws
def test_better_angles_by_the_lone_judge(kind: str, seed: int) -> None:
    proved(simple(kind, seed), "136")


@draws
def test_the_unit_does_not_depend_on_the_angle(kind: str, seed: int) -> None:
    polygon = simple(kind, seed)
    wide, narrow = (
        theorem_2(polygon, max_angle=parse_angle_bound(bound), check="none")
        for bound in ("150", "136")
    )
    assert wide.framed == narrow.framed


@draws
def test_150_degrees_are_the_default(kind: str, seed: int) -> None:
    polygon = simple(kind, seed)
    asked = theorem_2(polygon, max_angle=parse_angle_bound("150"), check="none")
    assert theorem_2(polygon, check="none").assembled == asked.assembled


# Holes ----------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["plate", "tiny_holes", "inner_slit"])
def test_holes_are_refused(kind: str) -> None:
    with pytest.raises(InputError, match="Theorem 3 is meant") as caught:
        theorem_2(some_polygon(kind, 0))
    assert (caught.value.kind, caught.value.where) == ("has-holes", {"ring": 1})


# Stages, checks, options ----------------------------------------------------------------


def test_the_stages_are_those_of_the_proof() -> None:
    assert list(theorem_2(some_polygon("simple", 0), check="none").records) == STAGES


@pytest.mark.parametrize("check", ["every-stage", "final", "none"])
def test_what_is_checked_does_not_change_the_mesh(check: Check) -> None:
    polygon = some_polygon("maze", 0)
    made = theorem_2(polygon, check=check)
    assert made.assembled == theorem_2(polygon, check="none").assembled
    places = {found.claim.split(".")[0] for found in made.findings}
    lemmas = {f"lemma-{i}" for i in (1, 2, 4, 5, 6, 7)}
    if check == "every-stage":
        assert {*lemmas, "theorem-2", "definition-1", "definition-2"} <= places
    else:
        assert places == ({"theorem-2"} if check == "final" else set())


def test_a_stage_that_breaks_a_lemma_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    original = module.tile

    def forgetful(partition: Partition) -> Any:
        shorter = Partition(partition.region, partition.rectangles[1:], partition.steps[1:])
        return original(shorter)

    monkeypatch.setattr(module, "tile", forgetful)
    with pytest.raises(LemmaViolation) as caught:
        theorem_2(some_polygon("simple", 0), check="final")
    assert caught.value.finding.claim == "theorem-2.valid"


@draws
def test_squares_make_no_fewer_triangles(kind: str, seed: int) -> None:
    polygon = simple(kind, seed)
    strips, squares = (theorem_2(polygon, squares=s, check="none") for s in (False, True))
    counts = [len(made.assembled.mesh.triangles) for made in (strips, squares)]
    assert counts[0] <= counts[1]


@draws
def test_bridges_without_holes_are_theorem_2(kind: str, seed: int) -> None:
    polygon = simple(kind, seed)
    bridged = theorem_3(polygon, interior="bridges", check="none")
    assert bridged.assembled == theorem_2(polygon, check="none").assembled


def test_the_classes_are_those_of_the_parts() -> None:
    made = theorem_2(simple("star", 4), check="none")
    names = {CLASSES[tag] for tag in made.assembled.classes}
    assert {"block", "merged", "rectangle", "fan"} <= names
    assert names <= {"block", "boundary", "merged", "rectangle", "fan"}


# What must not matter -------------------------------------------------------------------


@draws
@pytest.mark.parametrize("name", MOVES)
def test_moved_polygons(kind: str, seed: int, name: str) -> None:
    move, factor = MOVES[name]
    polygon = simple(kind, seed)
    made = proved(polygon_from_rings(mapped(rings_of(polygon), move)), check="final")
    assert made.feature.squared == factor * feature_size(polygon).squared


@draws
def test_a_power_of_two_scales_the_mesh(kind: str, seed: int) -> None:
    polygon = simple(kind, seed)
    image = polygon_from_rings(mapped(rings_of(polygon), lambda x, y: (x * 2**40, y * 2**40)))
    before, after = (theorem_2(each, check="none").assembled for each in (polygon, image))
    assert before.mesh.triangles == after.mesh.triangles and before.classes == after.classes
    scaled = mapped([list(before.mesh.vertices)], lambda x, y: (x * 2**40, y * 2**40))
    assert [*after.mesh.vertices] == scaled[0]


@draws
@pytest.mark.parametrize("way", ["other first vertices", "other orientations"])
def test_relabelled_polygons(kind: str, seed: int, way: str) -> None:
    # Faces are merged edge after edge: another first edge may merge otherwise.
    proved(polygon_from_rings(relabelled(rings_of(simple(kind, seed)), way)), check="final")


PRINTED = """
import hashlib
from bern_exact.api import triangulate
from tests.theorems.families import some_polygon
for kind in ("simple", "simple_with_holes", "plate", "star", "threshold", "inner_slit"):
    polygon = some_polygon(kind, 1)
    for options in ({}, {"max_angle": "140", "objective": "angle"}):
        document = triangulate(polygon, **options).document
        print(kind, hashlib.sha256(document.encode()).hexdigest())
"""


def test_the_same_bytes_under_any_hash_seed() -> None:
    first, second = (
        subprocess.run(
            [sys.executable, "-c", PRINTED],
            env={**os.environ, "PYTHONHASHSEED": hash_seed},
            cwd=ROOT,
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for hash_seed in ("0", "4242")
    )
    assert first.count("\n") == 12 and first == second


# As users call it -------------------------------------------------------------------------


def test_it_is_the_default_for_simple_polygons() -> None:
    result = triangulate(simple("simple", 0))
    certificate = json.loads(result.document)["certificate"]
    assert certificate["theorem"] == 2
    assert mpq(certificate["max_angle"]["cos_squared"]) <= mpq(3, 4)


@pytest.mark.parametrize("max_angle", [140, "140", "140.0"])
def test_a_bound_as_users_write_it(max_angle: str | int) -> None:
    polygon = simple("simple", 0)
    bound = parse_angle_bound("140")
    expected = theorem_2(polygon, max_angle=bound, check="none").assembled.mesh
    assert triangulate(polygon, max_angle=max_angle, check="none").mesh == expected
