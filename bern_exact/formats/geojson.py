"""GeoJSON (RFC 7946): a `Polygon`, by itself, in a Feature, or alone in a FeatureCollection.

Rings are closed by repeating their first point, which is left out of the polygon.  Coordinates are
numbers of the plane here, whatever reference system they have.
"""

from __future__ import annotations

import json
from typing import Any

from bern_exact.exact.numbers import rational_from_json, shown
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.formats import fields, safe_json
from bern_exact.formats.doubles import Rounding
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings

_GEOMETRIES = frozenset(
    (
        "Point",
        "MultiPoint",
        "LineString",
        "MultiLineString",
        "Polygon",
        "MultiPolygon",
        "GeometryCollection",
    )
)


def is_geojson(document: Any) -> bool:
    """Is this JSON document meant to be GeoJSON, sound or not?

    >>> is_geojson({"type": "Polygon"}), is_geojson({"outer": []}), is_geojson({"type": "mesh"})
    (True, False, False)
    """
    kind = document.get("type") if isinstance(document, dict) else None
    if not isinstance(kind, str) or "outer" in document:
        return False
    return kind in _GEOMETRIES or kind in ("Feature", "FeatureCollection")


def load_polygon(source: safe_json.Source, /, *, binary64: bool) -> Polygon:
    """The polygon in a file of GeoJSON.

    Raises
    ------
    InputError
        The text is not JSON, or the document is refused by `read_polygon`.
    OSError
        The file cannot be read.
    """
    return read_polygon(safe_json.load(source), binary64=binary64)


def read_polygon(document: Any, *, binary64: bool = False) -> Polygon:
    """The polygon of a document, named by the `name` of its feature's properties, if any.

    Raises
    ------
    InputError
        With the path.  Kind `unsupported`: another geometry, not exactly one polygon, a third
        coordinate other than 0; `schema`: a ring is not closed, or something is missing; `number`;
        or the kinds of `polygon_from_rings`.

    Examples
    --------
    >>> ring = [[0, 0], [4, 0], [0, 1], [0, 0]]
    >>> read_polygon({"type": "Polygon", "coordinates": [ring]}).area
    mpq(2,1)
    """
    document, path, name = _geometry(fields.as_object(document, "$"))
    kind = fields.member(document, "type", path)
    if kind != "Polygon":
        told = shown(kind) if isinstance(kind, str) else "that"
        raise fields.refuse("unsupported", f"a Polygon is read, not {told}", f"{path}.type")
    rings = fields.member(document, "coordinates", path)
    path = f"{path}.coordinates"
    if not fields.as_list(rings, path):
        raise fields.refuse("unsupported", "an empty polygon has no triangulation", path)
    return polygon_from_rings(
        [_ring(ring, f"{path}[{r}]", binary64) for r, ring in enumerate(rings)], name
    )


def _geometry(document: dict[str, Any]) -> tuple[dict[str, Any], str, str]:
    """The geometry of a document, its path, and its feature's name."""
    path, name = "$", ""
    if document.get("type") == "FeatureCollection":
        features = fields.as_list(fields.member(document, "features", path), "$.features")
        if len(features) != 1:
            message = f"exactly one feature is read, not {len(features)}"
            raise fields.refuse("unsupported", message, "$.features")
        path = "$.features[0]"
        document = fields.as_object(features[0], path)
        if document.get("type") != "Feature":
            raise fields.refuse("schema", "a Feature is expected", f"{path}.type")
    if document.get("type") == "Feature":
        properties = document.get("properties")
        named = properties.get("name") if isinstance(properties, dict) else None
        if isinstance(named, str):
            name = fields.as_name(named, f"{path}.properties.name")
        geometry = fields.member(document, "geometry", path)
        path = f"{path}.geometry"
        document = fields.as_object(geometry, path)
    return document, path, name


def _ring(value: Any, path: str, binary64: bool) -> list[HPoint]:
    """A ring without its repeated end."""
    items = fields.as_list(value, path)
    ring = [_position(item, f"{path}[{i}]", binary64) for i, item in enumerate(items)]
    if len(ring) < 2 or ring[0] != ring[-1]:
        message = "the ring is not closed: its last point is not its first"
        raise fields.refuse("schema", message, path)
    return ring[:-1]


def _position(value: Any, path: str, binary64: bool) -> HPoint:
    """A point, its third coordinate 0 if it has one."""
    items = fields.as_list(value, path)
    if not 2 <= len(items) <= 3:
        raise fields.refuse("schema", f"a position is [x, y], not {len(items)} values", path)
    x, y, *rest = (
        rational_from_json(item, f"{path}[{k}]", binary64=binary64) for k, item in enumerate(items)
    )
    if rest and rest[0] != 0:
        raise fields.refuse("unsupported", "a third coordinate is not 0", f"{path}[2]")
    return hpoint(x, y)


def dumps_polygon(polygon: Polygon) -> tuple[str, int]:
    """A polygon as a Feature, and the number of coordinates that were rounded to doubles.

    Outer rings run counter-clockwise and holes clockwise, as the standard asks: a ring that was
    read the other way is turned round.

    Raises
    ------
    InputError
        Kind `number`: a coordinate is beyond all doubles.
    """
    rounding = Rounding()
    rings = []
    for ring in polygon.rings:
        pairs = rounding.pairs(polygon.points[v] for v in ring)
        rings.append(", ".join(f"[{x}, {y}]" for x, y in (*pairs, pairs[0])))
    named = {"name": polygon.name} if polygon.name else {}
    text = (
        f'{{"type": "Feature", "properties": {json.dumps(named)},\n'
        ' "geometry": {"type": "Polygon", "coordinates": [\n'
        + ",\n".join(f"  [{ring}]" for ring in rings)
        + "]}}\n"
    )
    return text, rounding.rounded
