"""Ask all three judges, and insist that they say the same."""

from __future__ import annotations

import json
from collections.abc import Iterator
from fractions import Fraction
from importlib import resources
from typing import Any

import numpy as np
from gmpy2 import mpq
from jsonschema import Draft202012Validator

from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.formats.mesh_json import read_array_mesh
from bern_exact.oracle import judge as lone
from bern_exact.oracle.fast import verify_mesh
from bern_exact.oracle.filtered import Effort, verify_arrays
from bern_exact.plane.array_mesh import ArrayMesh, DoublePoints, index_array
from tests.oracle.meshes import Case

SCHEMA = json.loads((resources.files("bern_exact") / "schemas/verdict.schema.json").read_text())
VALIDATOR = Draft202012Validator(SCHEMA)


def both(case: Case, **bounds: Any) -> dict[str, Any]:
    """The one verdict of all judges, word for word and key for key."""
    slow = lone.judge(case.document(), **bounds)
    mesh, polygon, options = case.mesh(), case.polygon(), options_of(bounds)
    fast = verify_mesh(mesh, polygon, **options).to_json()
    filtered = verify_arrays(ArrayMesh.of_mesh(mesh), polygon, **options).to_json()
    assert json.dumps(fast) == json.dumps(slow) == json.dumps(filtered)
    return slow


def options_of(bounds: dict[str, Any]) -> dict[str, Any]:
    """The bounds as the judges of the package take them."""
    angle, height = bounds.get("max_angle"), bounds.get("min_height_squared")
    return {
        "max_angle": None if angle is None else parse_angle_bound(str(angle)),
        "min_height_squared": None if height is None else mpq(height),
        "max_triangles": bounds.get("max_triangles"),
        "limit": bounds.get("limit", 100),
    }


def forms(case: Case) -> Iterator[tuple[str, ArrayMesh]]:
    """The mesh in arrays, in every way that there is to hold its points."""
    yield "exact", ArrayMesh.of_mesh(case.mesh())
    yield "text", read_array_mesh({**case.document(), "polygon": None})[0]
    flat = [c for p in case.vertices for c in p]
    if all(abs(c) < 2**1023 and Fraction(float(c)) == c for c in flat):
        doubles = np.array([float(c) for c in flat]).reshape(-1, 2)
        yield "doubles", ArrayMesh(DoublePoints(doubles), index_array(case.triangles))


def all_forms(case: Case, effort: Effort | None = None, **bounds: Any) -> dict[str, Any] | None:
    """The one verdict of all judges on the mesh in every form; None if its polygon is none."""
    try:
        slow = lone.judge(case.document(), **bounds)
    except lone.Unreadable:
        return None
    polygon, options = case.polygon(), options_of(bounds)
    told = json.dumps(slow)
    assert told == json.dumps(verify_mesh(case.mesh(), polygon, **options).to_json()), "fast"
    for name, mesh in forms(case):
        verdict = verify_arrays(mesh, polygon, **options, effort=effort)
        assert told == json.dumps(verdict.to_json()), name
    return slow


def kinds(case: Case, **bounds: Any) -> list[str]:
    """The kinds of defects that both judges find, each once, in order."""
    return list(dict.fromkeys(defect["kind"] for defect in both(case, **bounds)["defects"]))


def found(case: Case, kind: str, **bounds: Any) -> list[dict[str, Any]]:
    """The defects of one kind."""
    return [defect for defect in both(case, **bounds)["defects"] if defect["kind"] == kind]
