"""What a judge says of a mesh: the verdict, and the defects behind it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from gmpy2 import mpq

from bern_exact.exact.angles import Angle
from bern_exact.exact.enclosures import decimal_enclosure, degrees_enclosure, sqrt_enclosure
from bern_exact.exact.numbers import parse_rational
from bern_exact.exact.points import HPoint, coordinates

DEFECTS = {
    "index-out-of-range": "a triangle names a vertex that is not there",
    "repeated-index": "a triangle names a vertex twice",
    "duplicate-vertex": "two vertices are at the same point",
    "unused-vertex": "no triangle uses the vertex",
    "degenerate-triangle": "the triangle's corners lie on one line",
    "clockwise-triangle": "the triangle runs clockwise",
    "edge-used-twice": "several triangles lie on the same side of the edge",
    "polygon-vertex-missing": "the mesh has no vertex at the polygon's",
    "boundary-vertex-off-edge": "the boundary vertex lies on no edge of the polygon",
    "hanging-vertex": "the vertex lies inside a triangle's edge",
    "crossing-edges": "the boundary edge crosses another",
    "boundary-not-simple": "the boundary edge crosses another",
    "overlap": "several triangles cover the same place beside the edge",
    "triangle-outside": "a triangle beside the edge lies outside the polygon",
    "hole-filled": "a triangle beside the edge lies in a hole of the polygon",
    "region-not-covered": "no triangle covers the polygon beside the edge",
    "angle-above-bound": "the triangle has an angle above the bound",
    "height-below-bound": "the triangle has a height below the bound",
    "too-many-triangles": "there are more triangles than the bound",
}
"""The closed list of what can be wrong with a mesh, and what each kind says in words."""

ANGLE_CLASSES = ("le60", "le90", "le120", "le135", "le150", "above")
"""Triangles by their largest angle; each triangle with area is in the first class that fits."""


@dataclass(frozen=True)
class Defect:
    """One thing that is wrong with a mesh.

    Parameters
    ----------
    kind : str
        A key of `DEFECTS`.
    where : dict
        `{"triangle": t}`, `{"vertex": v}` or `{"edge": [a, b]}` of the mesh,
        `{"polygon_vertex": [ring, index]}` or `{"polygon_edge": [ring, index]}` of the polygon,
        or nothing, if it is the mesh as a whole.
    message : str
        The kind and the place.
    witness : dict
        Exact values that show it, JSON-ready.
    """

    kind: str
    where: dict[str, Any]
    message: str
    witness: dict[str, Any]

    @staticmethod
    def of(kind: str, where: dict[str, Any], witness: dict[str, Any]) -> Defect:
        """A defect with its message; what has no place is told by its witness."""
        place = ", ".join(f"{name} {value}" for name, value in (where or witness).items())
        return Defect(kind, where, f"{kind}: {place}", witness)

    @property
    def sentence(self) -> str:
        """The message, and in words what its kind means.

        >>> Defect.of("clockwise-triangle", {"triangle": 3}, {}).sentence
        'clockwise-triangle: triangle 3 (the triangle runs clockwise)'
        """
        words = DEFECTS[self.kind]
        if "distance" in self.witness:
            words += f": {distance_words(self.witness)}"
        return f"{self.message} ({words})"

    def to_json(self) -> dict[str, Any]:
        """The defect as an object of `verify --json`."""
        return {
            "kind": self.kind,
            "where": self.where,
            "message": self.message,
            "witness": self.witness,
        }


def distance_words(witness: Mapping[str, Any]) -> str:
    """How far a vertex is from where it belongs, in a few words.

    >>> distance_words({"polygon_edge": [0, 7], "distance": ["0.25", "0.25"], "ulps": ["9", "9.1"]})
    '0.25 (at most 9.1 ulps) from edge [0, 7]'
    """
    low, high = witness["distance"]
    shown = low if low == high else f"{low[:8]}...{low[len(low.partition('e')[0]) :]}"
    edge, corner = witness.get("polygon_edge"), witness.get("polygon_vertex")
    place = f"edge {edge}" if corner is None else f"the polygon's vertex {corner}"
    return f"{shown} (at most {witness['ulps'][1]} ulps) from {place}"


class Findings:
    """The first `limit` defects, and whether there is any at all."""

    def __init__(self, limit: int) -> None:
        self.limit = limit
        self.valid = True
        self.defects: list[Defect] = []

    @property
    def full(self) -> bool:
        """Would another defect no longer be listed?"""
        return len(self.defects) >= self.limit

    def add(self, kind: str, where: dict[str, Any], witness: dict[str, Any]) -> None:
        """Note a defect."""
        self.valid = False
        if not self.full:
            self.defects.append(Defect.of(kind, where, witness))


def point_json(p: HPoint) -> list[str]:
    """A point as exact text."""
    x, y = coordinates(p)
    return [str(x), str(y)]


@dataclass(frozen=True, repr=False)
class Verdict:
    """Whether a mesh is a triangulation within the bounds asked for; true if it is.

    Parameters
    ----------
    valid : bool
        There is no defect at all.
    defects : tuple of Defect
        The defects found, up to the limit asked for.
    triangles, vertices : int
        How many the mesh has.
    max_angle : Angle or None
        The largest angle of any triangle that has area; None if there is none.
    max_angle_triangle : int or None
        The first triangle that has it.
    min_height_squared : mpq or None
        The least squared height of any triangle that has area.
    min_height_triangle : int or None
        The first triangle that has it.
    angle_classes : dict
        The number of triangles in each of `ANGLE_CLASSES`.
    within_tolerance : bool or None
        Whether the mesh is valid but for boundary vertices at most `tolerance` off their edges or
        vertices of the polygon; None if that was not asked.
    tolerance : mpq or None
        The distance that was asked.
    off_edge : dict or None
        How many boundary vertices are not where they belong, and the one that is furthest:
        `vertices`, `vertex`, `point`, `polygon_edge` or `polygon_vertex`, `distance_squared`,
        `distance`, `ulps`.  None if there is none, or it is not known where; see `departures`.
    feature_size_squared : mpq or None
        s^2 of the polygon (Definition 1); None without a polygon or from a judge alone.
    polygon_vertices : int or None
        How many vertices the polygon has; likewise.
    """

    valid: bool
    defects: tuple[Defect, ...]
    triangles: int
    vertices: int
    max_angle: Angle | None
    max_angle_triangle: int | None
    min_height_squared: mpq | None
    min_height_triangle: int | None
    angle_classes: dict[str, int]
    within_tolerance: bool | None = field(default=None)
    tolerance: mpq | None = field(default=None)
    off_edge: dict[str, Any] | None = field(default=None)
    feature_size_squared: mpq | None = field(default=None)
    polygon_vertices: int | None = field(default=None)

    def __bool__(self) -> bool:
        return self.valid or self.within_tolerance is True

    @property
    def state(self) -> str:
        """The answer in a few words.

        >>> from gmpy2 import mpq
        >>> Verdict(False, (), 1, 3, None, None, None, None, {}, True, mpq(1, 10**16)).state
        'valid within 1e-16'
        """
        if self.valid:
            return "valid"
        if self.tolerance is None:
            return "not valid"
        low, _ = decimal_enclosure(self.tolerance, self.tolerance)
        shown = low if parse_rational(low) == self.tolerance else str(self.tolerance)
        return f"{'valid' if self.within_tolerance else 'not valid, not even'} within {shown}"

    @property
    def height_ratio_squared(self) -> mpq | None:
        """The least squared height over the squared feature size; at most 1 in a valid mesh."""
        if self.min_height_squared is None or self.feature_size_squared is None:
            return None
        return self.min_height_squared / self.feature_size_squared

    @property
    def triangles_per_vertex(self) -> mpq | None:
        """Triangles a vertex of the polygon."""
        return mpq(self.triangles, self.polygon_vertices) if self.polygon_vertices else None

    def __repr__(self) -> str:
        state = self.state
        if self.defects:
            state += f", {len(self.defects)} defect{'s' * (len(self.defects) > 1)} listed"
        lines = [f"<Verdict: {state}; {self.triangles} triangles, {self.vertices} vertices"]
        if self.max_angle is not None and self.min_height_squared is not None:
            low, high = degrees_enclosure(self.max_angle)
            angle = low if low == high else f"{low}..{high}"
            low, high = sqrt_enclosure(self.min_height_squared, 6)
            height = low if low == high else f"{low}..{high}"
            lines[0] += f", largest angle {angle}, least height {height}"
        lines += [f"  {defect.sentence}" for defect in self.defects[:5]]
        if len(self.defects) > 5:
            lines.append("  ...")
        return "\n".join(lines) + ">"

    def to_json(self) -> dict[str, Any]:
        """The object of `verify --json`; what only some verdicts have comes last."""
        angle: dict[str, Any] | None = None
        if self.max_angle is not None:
            angle = {**angle_json(self.max_angle), "triangle": self.max_angle_triangle}
        record = {
            "valid": self.valid,
            "within_tolerance": self.within_tolerance,
            "defects": [defect.to_json() for defect in self.defects],
            "triangles": self.triangles,
            "vertices": self.vertices,
            "max_angle": angle,
            "min_height_squared": _text(self.min_height_squared),
            "feature_size_squared": _text(self.feature_size_squared),
            "angle_classes": self.angle_classes,
        }
        more = {
            "tolerance": _text(self.tolerance),
            "off_edge": self.off_edge,
            "height_ratio_squared": _text(self.height_ratio_squared),
            "triangles_per_vertex": _text(self.triangles_per_vertex),
        }
        return record | {name: value for name, value in more.items() if value is not None}


def angle_json(angle: Angle) -> dict[str, Any]:
    """An angle, exactly and in degrees."""
    return {
        "cos_sign": angle.cos_sign,
        "cos_squared": str(angle.cos_squared),
        "degrees": list(degrees_enclosure(angle)),
    }


def _text(value: mpq | None) -> str | None:
    return None if value is None else str(value)
