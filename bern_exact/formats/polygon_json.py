"""`bern-exact/polygon`, version 1: polygons with holes as JSON."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from bern_exact.exact.numbers import format_rational
from bern_exact.exact.points import HPoint, coordinates
from bern_exact.formats import fields, safe_json
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings

FORMAT = "bern-exact/polygon"


def load_polygon(source: safe_json.Source, *, binary64: bool = False) -> Polygon:
    """The polygon in a JSON file or stream.

    Raises
    ------
    InputError
        The text is not JSON, or the document is refused by `read_polygon`.
    OSError
        The file cannot be read.
    """
    return read_polygon(safe_json.load(source), binary64=binary64)


def read_polygon(document: Any, *, binary64: bool = False, path: str = "$") -> Polygon:
    """The polygon of a JSON document.

    Parameters
    ----------
    document : object
        A `bern-exact/polygon`, or a bare object with `outer` and perhaps `holes` and `name`.
        Other members are ignored.
    binary64 : bool
        Read each decimal as the double nearest to it.
    path : str
        Where the document stands in its file, for messages.

    Raises
    ------
    InputError
        Kind `schema`, `unsupported` or `number`, with the path; or the kinds of
        `polygon_from_rings`, with ring, vertex and edge.

    Notes
    -----
    Linear but for the validation, O(n log n).
    """
    document = fields.as_object(document, path)
    fields.check_format(document, FORMAT, path)
    outer = fields.member(document, "outer", path)
    rings = [fields.as_points(outer, f"{path}.outer", binary64=binary64)]
    holes = fields.as_list(document.get("holes", []), f"{path}.holes")
    for i, hole in enumerate(holes):
        rings.append(fields.as_points(hole, f"{path}.holes[{i}]", binary64=binary64))
    name = fields.as_name(document.get("name", ""), f"{path}.name")
    return polygon_from_rings(rings, name)


def dump_polygon(polygon: Polygon) -> dict[str, Any]:
    """The document of a polygon, its rings in input order."""
    rings = [point_texts(polygon.input_ring(r)) for r in range(len(polygon.rings))]
    return {
        "format": FORMAT,
        "version": 1,
        "name": polygon.name,
        "outer": rings[0],
        "holes": rings[1:],
    }


def point_texts(points: Iterable[HPoint]) -> list[list[str]]:
    """Points as pairs of exact texts."""
    return [[format_rational(c) for c in coordinates(p)] for p in points]
