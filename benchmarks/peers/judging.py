"""What is measured of a mesh, anybody's: all of it exactly, by this package's judge."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from gmpy2 import mpq

from benchmarks.peers.boundary import Followed, followed
from bern_exact.exact.angles import Angle
from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import parse_rational
from bern_exact.oracle.fast import verify_mesh
from bern_exact.plane.feature_size import feature_size
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings

LISTED = 200
"""How many defects the judge lists."""

OFF = "boundary-vertex-off-edge"

ROUNDING = mpq(1, 10**6)
"""No farther off its edge, to the feature size, is a vertex that is off by rounding."""

BOUNDARY = frozenset(
    (
        OFF,
        "polygon-vertex-missing",
        "hanging-vertex",
        "crossing-edges",
        "overlap",
        "triangle-outside",
        "hole-filled",
        "region-not-covered",
    )
)
"""Kinds of defects that say that the mesh's boundary is not the polygon's."""


@dataclass(frozen=True)
class Judged:
    """The exact figures of one mesh.

    Parameters
    ----------
    triangles, vertices : int
        How many there are.
    defects : mapping
        Kind -> how many; none if the mesh is valid.  `boundary-vertex-off-edge` are all that there
        are; if a boundary can be followed, the others are those of the mesh as a triangulation
        of what its own boundary encloses; at most `LISTED` are listed.
    max_angle : Angle or None
        The largest angle; None if no triangle has an area.
    min_height_squared : mpq or None
        The least height, squared.
    feature_squared : mpq
        The feature size of the polygon judged against, squared.
    off : int or None
        How many boundary vertices lie off their edge; None if the boundary cannot be followed.
    off_squared : mpq
        The largest distance of one of them from its edge, squared.
    """

    triangles: int
    vertices: int
    defects: Mapping[str, int]
    max_angle: Angle | None
    min_height_squared: mpq | None
    feature_squared: mpq
    off: int | None
    off_squared: mpq

    @property
    def valid(self) -> bool:
        """Is it exactly a triangulation of the polygon?"""
        return not self.defects

    @property
    def keeps_boundary(self) -> bool | None:
        """Is its boundary exactly the polygon's?  None if other defects filled the list."""
        if BOUNDARY & self.defects.keys():
            return False
        return True if sum(self.defects.values()) < LISTED else None

    @property
    def is_valid_but_for_rounding(self) -> bool:
        """Is nothing wrong but that vertices on the boundary lie off their edges by rounding?"""
        near = self.off_squared <= ROUNDING**2 * self.feature_squared
        return self.off is not None and self.defects.keys() <= {OFF} and near

    @property
    def height_ratio_squared(self) -> mpq | None:
        """(least height / feature size)^2."""
        if self.min_height_squared is None:
            return None
        return self.min_height_squared / self.feature_squared

    def to_json(self) -> dict[str, Any]:
        """As JSON, every number exact."""
        return {
            "triangles": self.triangles,
            "vertices": self.vertices,
            "defects": dict(self.defects),
            "cos_sign": self.max_angle and self.max_angle.cos_sign,
            "cos_squared": self.max_angle and str(self.max_angle.cos_squared),
            "min_height_squared": self.min_height_squared and str(self.min_height_squared),
            "feature_squared": str(self.feature_squared),
            "off": self.off,
            "off_squared": str(self.off_squared),
        }

    @staticmethod
    def of_json(record: Mapping[str, Any]) -> Judged:
        """The inverse of `to_json`."""
        angle, height = record["cos_squared"], record["min_height_squared"]
        return Judged(
            triangles=record["triangles"],
            vertices=record["vertices"],
            defects=record["defects"],
            max_angle=Angle(record["cos_sign"], parse_rational(angle)) if angle else None,
            min_height_squared=parse_rational(height) if height else None,
            feature_squared=parse_rational(record["feature_squared"]),
            off=record["off"],
            off_squared=parse_rational(record["off_squared"]),
        )


def judged(mesh: Mesh, polygon: Polygon) -> Judged:
    """Measure a mesh against the polygon that its maker was given; an invalid one too.

    A mesh with boundary vertices off their edges is judged as a triangulation of what its own
    boundary encloses; the distances say how far that is from the polygon.
    """
    found = followed(mesh, polygon)
    target, defects = polygon, Counter[str]()
    if found is not None and found.off:
        target = _enclosed(found) or polygon
        if target is not polygon:
            defects[OFF] = found.off
    verdict = verify_mesh(mesh, target, limit=LISTED)
    defects.update(defect.kind for defect in verdict.defects)
    return Judged(
        triangles=verdict.triangles,
        vertices=verdict.vertices,
        defects=dict(sorted(defects.items())),
        max_angle=verdict.max_angle,
        min_height_squared=verdict.min_height_squared,
        feature_squared=feature_size(polygon).squared,
        off=None if found is None else found.off,
        off_squared=mpq(0) if found is None else found.off_squared,
    )


def _enclosed(found: Followed) -> Polygon | None:
    """What a mesh's own boundary encloses, if that is a polygon."""
    try:
        return polygon_from_rings(found.rings)
    except InputError:
        return None
