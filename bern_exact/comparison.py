"""Somebody's mesh beside our theorems' meshes of the same polygon, in numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from gmpy2 import mpq

from bern_exact.api import triangulate
from bern_exact.certificate import Certificate
from bern_exact.exact.angles import Angle
from bern_exact.facts import facts_of
from bern_exact.oracle.verdict import Verdict, angle_json
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems.stages import Observer


@dataclass(frozen=True)
class Row:
    """The figures of one mesh.

    Parameters
    ----------
    mesh : str
        Whose it is: "given", "theorem 2", "theorem 2, thinned".
    triangles : int
        How many it has.
    triangles_per_vertex : mpq
        Of the polygon's vertices.
    max_angle : Angle or None
        The largest angle; None if no triangle has area.
    min_height_squared : mpq or None
        The least squared height; likewise.
    """

    mesh: str
    triangles: int
    triangles_per_vertex: mpq
    max_angle: Angle | None
    min_height_squared: mpq | None

    def to_json(self) -> dict[str, Any]:
        """The row as an object of `verify --compare --json`."""
        height = self.min_height_squared
        return {
            "mesh": self.mesh,
            "triangles": self.triangles,
            "triangles_per_vertex": str(self.triangles_per_vertex),
            "max_angle": None if self.max_angle is None else angle_json(self.max_angle),
            "min_height_squared": None if height is None else str(height),
        }


def compare(
    verdict: Verdict, polygon: Polygon, *, observer: Observer | None = None
) -> tuple[Row, ...]:
    """The mesh that was judged, then ours by each theorem that applies, raw and thinned.

    Theorem 1; Theorem 2 for a simple polygon, 3 for one with holes; Theorem 4 for a convex one.

    Parameters
    ----------
    verdict : Verdict
        On the mesh.
    polygon : Polygon
        What it should triangulate.
    observer : Observer, optional
        Is told of every stage.

    Notes
    -----
    Takes what the constructions and their thinning take; they run unchecked.
    """
    count = verdict.triangles
    least = verdict.min_height_squared
    rows = [Row("given", count, mpq(count, polygon.n), verdict.max_angle, least)]
    for theorem in _theorems(polygon):
        result = triangulate(polygon, theorem=theorem, thin=True, check="none", observer=observer)
        thinned = result.certificate
        if thinned.raw is not None:
            rows.append(_row(f"theorem {theorem}", thinned.raw))
        rows.append(_row(f"theorem {theorem}, thinned", thinned))
    return tuple(rows)


def _theorems(polygon: Polygon) -> list[int]:
    """Those that apply."""
    without_large_angles = 3 if polygon.holes else 2
    return [1, without_large_angles, *([4] if facts_of(polygon).convex else [])]


def _row(name: str, certificate: Certificate) -> Row:
    """The figures of a mesh of ours."""
    return Row(
        name,
        certificate.triangles,
        mpq(certificate.triangles, certificate.n),
        certificate.max_angle,
        certificate.min_height_squared,
    )
