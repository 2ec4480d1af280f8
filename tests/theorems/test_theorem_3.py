"""Theorem 3: polygons with holes, every interior, with every check and the lone judge."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from bern_exact import Polygon, triangulate
from bern_exact.boundary.merge import Objective
from bern_exact.interior.subdivided.choice import Method
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems.assemble import CLASSES
from bern_exact.theorems.stages import Check
from bern_exact.theorems.theorem_3 import theorem_3
from tests.plane.shapes import polygons
from tests.theorems.families import FAMILIES, mapped, some_polygon
from tests.theorems.judged import proved_without_large_angles
from tests.theorems.outlines import EXAMPLES, cases
from tests.theorems.test_metamorphic import MOVES, relabelled, rings_of

ROOT = Path(__file__).resolve().parents[2]

HOLED = [path for path in EXAMPLES if Polygon.load(path).holes]
SMALL = [path for path in HOLED if path.stat().st_size <= 2_000]
SMALLEST = [path for path in SMALL if path.stat().st_size <= 1_000]
LARGE = [path for path in HOLED if path not in SMALL]

METHODS: tuple[Method, ...] = ("strips", "bridges", "best")

DRAWS = [("plate", 3), ("tiny_holes", 5), ("inner_slit", 5), ("simple_with_holes", 3)]

draws = pytest.mark.parametrize(("kind", "seed"), DRAWS)
every_method = pytest.mark.parametrize("interior", METHODS)
few = settings(max_examples=8, suppress_health_check=[HealthCheck.too_slow])


def proved(polygon: Polygon, max_angle: str = "150", **options: object) -> None:
    """Theorem 3's mesh, with or without holes, proved."""
    proved_without_large_angles(polygon, max_angle, theorem=3, **options)


# Polygons of all kinds --------------------------------------------------------------


@pytest.mark.parametrize("kind", FAMILIES)
def test_every_family(kind: str) -> None:
    proved(some_polygon(kind, 2))


@every_method
@few
@given(polygon=polygons())
def test_small_polygons_that_shrink(polygon: Polygon, interior: Method) -> None:
    proved(polygon, interior=interior)


@few
@given(
    kind=st.sampled_from(sorted(FAMILIES)),
    seed=st.integers(100, 10**9),
    max_angle=st.sampled_from(["149.5", "140", "136", "135.2", "cos:-1:25/34"]),
    objective=st.sampled_from(["fewest", "height", "angle"]),
    interior=st.sampled_from(METHODS),
)
def test_any_seed_of_any_family_with_any_options(
    kind: str, seed: int, max_angle: str, objective: Objective, interior: Method
) -> None:
    proved(some_polygon(kind, seed), max_angle, objective=objective, interior=interior)


@pytest.mark.parametrize("path", SMALL, ids=lambda path: path.stem)
def test_small_real_polygons(path: Path) -> None:
    proved(Polygon.load(path))


@pytest.mark.parametrize("interior", ["strips", "bridges"])
@pytest.mark.parametrize("path", SMALLEST, ids=lambda path: path.stem)
def test_other_interiors_of_real_polygons(path: Path, interior: Method) -> None:
    proved(Polygon.load(path), interior=interior, check="final")


@pytest.mark.parametrize("path", cases(LARGE))
def test_other_real_polygons(path: Path) -> None:
    made = theorem_3(Polygon.load(path), check="final")
    assert all(found.holds for found in made.findings) and made.findings


# Angles and interiors -------------------------------------------------------------------


@draws
@every_method
def test_better_angles_by_the_lone_judge(kind: str, seed: int, interior: Method) -> None:
    proved(some_polygon(kind, seed), "136", interior=interior, check="final")


@draws
def test_the_interiors_differ_inside_alone(kind: str, seed: int) -> None:
    polygon = some_polygon(kind, seed)
    near = []
    for interior in METHODS:
        assembled = theorem_3(polygon, interior=interior, check="none").assembled
        near.append(
            {
                tuple(assembled.mesh.vertices[v] for v in triangle)
                for triangle, tag in zip(assembled.mesh.triangles, assembled.classes, strict=True)
                if CLASSES[tag] != "rectangle"
            }
        )
    assert near[0] == near[1] == near[2]


@draws
def test_the_best_interior_has_the_fewest_triangles(kind: str, seed: int) -> None:
    polygon = some_polygon(kind, seed)
    triangles = {
        interior: len(theorem_3(polygon, interior=interior, check="none").assembled.mesh.triangles)
        for interior in METHODS
    }
    assert triangles["best"] == min(triangles.values())


def test_the_best_interior_is_the_default() -> None:
    polygon = some_polygon("plate", 3)
    made = theorem_3(polygon, check="none")
    assert made.assembled == theorem_3(polygon, interior="best", check="none").assembled
    assert triangulate(polygon, check="none").mesh == made.assembled.mesh


@every_method
@pytest.mark.parametrize("check", ["every-stage", "final", "none"])
def test_what_is_checked_does_not_change_the_mesh(check: Check, interior: Method) -> None:
    polygon = some_polygon("plate", 2)
    made = theorem_3(polygon, check=check, interior=interior)
    bare = theorem_3(polygon, check="none", interior=interior)
    assert made.assembled == bare.assembled
    places = {found.claim.split(".")[0] for found in made.findings}
    inside = "lemma-6" if interior == "bridges" else "lemma-8"
    if check == "every-stage":
        assert {"lemma-4", "lemma-5", "lemma-7", inside, "theorem-3"} <= places
    else:
        assert places == ({"theorem-3"} if check == "final" else set())


# What must not matter -------------------------------------------------------------------


@pytest.mark.parametrize(("kind", "seed"), DRAWS[:2])
@pytest.mark.parametrize("name", MOVES)
def test_moved_polygons(kind: str, seed: int, name: str) -> None:
    move, _ = MOVES[name]
    proved(polygon_from_rings(mapped(rings_of(some_polygon(kind, seed)), move)), check="final")


@draws
@pytest.mark.parametrize(
    "way",
    ["other first vertices", "other order of holes", "other orientations", "mixed orientations"],
)
def test_relabelled_polygons(kind: str, seed: int, way: str) -> None:
    proved(polygon_from_rings(relabelled(rings_of(some_polygon(kind, seed)), way)), check="final")


@draws
def test_the_same_mesh_twice(kind: str, seed: int) -> None:
    polygon = some_polygon(kind, seed)
    first, second = (triangulate(polygon, check="none").document for _ in range(2))
    assert first == second
