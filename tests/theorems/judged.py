"""Theorem 1 with every check, and the lone judge's verdict besides."""

from __future__ import annotations

from typing import Any

from bern_exact.formats.mesh_json import mesh_document
from bern_exact.formats.polygon_json import dump_polygon
from bern_exact.oracle.judge import judge
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems.stages import Construction
from bern_exact.theorems.theorem_1 import theorem_1


def verdict_on(made: Construction) -> dict[str, Any]:
    """What the lone judge, which shares no code with the construction, says of a mesh."""
    return judge(mesh_document(made.assembled.mesh), dump_polygon(made.polygon))


def proved(polygon: Polygon) -> Construction:
    """Theorem 1's mesh of a polygon: every claim holds, and the lone judge agrees."""
    made = theorem_1(polygon)
    assert all(found.holds for found in made.findings if found.role == "guarantee")
    verdict = verdict_on(made)
    assert verdict["valid"], verdict["defects"][:3]
    return made
