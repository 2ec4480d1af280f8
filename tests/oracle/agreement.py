"""Ask all three judges, and insist that they say the same."""

from __future__ import annotations

import json
from importlib import resources
from typing import Any

from gmpy2 import mpq
from jsonschema import Draft202012Validator

from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.oracle import judge as lone
from bern_exact.oracle.fast import verify_mesh
from bern_exact.oracle.filtered import verify_arrays
from bern_exact.plane.array_mesh import ArrayMesh
from tests.oracle.meshes import Case

SCHEMA = json.loads((resources.files("bern_exact") / "schemas/verdict.schema.json").read_text())
VALIDATOR = Draft202012Validator(SCHEMA)


def both(case: Case, **bounds: Any) -> dict[str, Any]:
    """The one verdict of all judges, word for word and key for key."""
    angle, height = bounds.get("max_angle"), bounds.get("min_height_squared")
    options: dict[str, Any] = {
        "max_angle": None if angle is None else parse_angle_bound(str(angle)),
        "min_height_squared": None if height is None else mpq(height),
        "max_triangles": bounds.get("max_triangles"),
        "limit": bounds.get("limit", 100),
    }
    mesh, polygon = case.mesh(), case.polygon()
    fast = verify_mesh(mesh, polygon, **options).to_json()
    filtered = verify_arrays(ArrayMesh.of_mesh(mesh), polygon, **options).to_json()
    slow = lone.judge(case.document(), **bounds)
    assert json.dumps(fast) == json.dumps(slow) == json.dumps(filtered)
    return slow


def kinds(case: Case, **bounds: Any) -> list[str]:
    """The kinds of defects that both judges find, each once, in order."""
    return list(dict.fromkeys(defect["kind"] for defect in both(case, **bounds)["defects"]))


def found(case: Case, kind: str, **bounds: Any) -> list[dict[str, Any]]:
    """The defects of one kind."""
    return [defect for defect in both(case, **bounds)["defects"] if defect["kind"] == kind]
