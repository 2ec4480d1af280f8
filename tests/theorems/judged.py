"""A theorem with every check, and the lone judge's verdict besides."""

from __future__ import annotations

from typing import Any

from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.formats.mesh_json import mesh_document
from bern_exact.formats.polygon_json import dump_polygon
from bern_exact.oracle.judge import judge
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems.stages import Construction
from bern_exact.theorems.theorem_1 import theorem_1
from bern_exact.theorems.theorem_2 import theorem_2
from bern_exact.theorems.theorem_3 import theorem_3


def verdict_on(made: Construction, max_angle: str | None = None) -> dict[str, Any]:
    """What the lone judge, which shares no code with the construction, says of a mesh."""
    return judge(
        mesh_document(made.assembled.mesh), dump_polygon(made.polygon), max_angle=max_angle
    )


def proved(polygon: Polygon, **options: Any) -> Construction:
    """Theorem 1's mesh of a polygon: every claim holds, and the lone judge agrees."""
    return _proved(theorem_1(polygon, **options), None)


def proved_without_large_angles(
    polygon: Polygon, max_angle: str = "150", theorem: int = 0, **options: Any
) -> Construction:
    """Theorem 2's mesh, or 3's if there are holes or it is asked for, proved likewise."""
    construct = theorem_3 if polygon.holes or theorem == 3 else theorem_2
    made = construct(polygon, max_angle=parse_angle_bound(max_angle), **options)
    return _proved(made, max_angle)


def _proved(made: Construction, max_angle: str | None) -> Construction:
    """The construction, if it stands."""
    assert all(found.holds for found in made.findings if found.role == "guarantee")
    verdict = verdict_on(made, max_angle)
    assert verdict["valid"], verdict["defects"][:3]
    return made
