"""Polygons from files and as texts.  The format follows the file's suffix, or is named."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Protocol

from bern_exact.formats import cgshop, geojson, safe_json, triangle_poly, wkt
from bern_exact.formats.dispatch import reader_for
from bern_exact.formats.polygon_json import dump_polygon, load_polygon, read_polygon
from bern_exact.plane.polygon import Polygon


class _Reader(Protocol):
    """Reads one format from a path."""

    def __call__(self, source: Path, /, *, binary64: bool) -> Polygon: ...


def _load_json(source: Path, /, *, binary64: bool) -> Polygon:
    """The polygon in a JSON file of any of the formats here: what it holds tells which."""
    document = safe_json.load(source)
    if cgshop.is_instance(document):
        return cgshop.read_instance(document).polygon
    if geojson.is_geojson(document):
        return geojson.read_polygon(document, binary64=binary64)
    return read_polygon(document, binary64=binary64)


def _load_cgshop(source: Path, /, *, binary64: bool) -> Polygon:
    """The polygon of a CG:SHOP instance, whose integers are what they are."""
    return cgshop.load_instance(source).polygon


POLYGON_READERS: Mapping[str, _Reader] = {
    ".json": _load_json,
    ".poly": triangle_poly.load_polygon,
    ".wkt": wkt.load_polygon,
    ".geojson": geojson.load_polygon,
}
"""Suffix -> reader of a polygon."""

POLYGON_FORMATS: Mapping[str, _Reader] = {
    "json": load_polygon,
    "cgshop": _load_cgshop,
    "poly": triangle_poly.load_polygon,
    "wkt": wkt.load_polygon,
    "geojson": geojson.load_polygon,
}
"""Name of a format -> reader of a polygon."""


def read_polygon_file(
    path: str | os.PathLike[str], *, binary64: bool = False, format: str | None = None
) -> Polygon:
    """The polygon in a file.

    Parameters
    ----------
    path : path
        Its suffix tells the format: `.poly`, `.wkt`, `.geojson`, or `.json`, which may be a
        `bern-exact/polygon`, GeoJSON or a CG:SHOP instance.
    binary64 : bool
        Read each decimal as the double nearest to it, then exactly.
    format : str, optional
        A key of `POLYGON_FORMATS`, whatever the suffix.

    Raises
    ------
    InputError
        Kind `unsupported`: no such format or none of that suffix; else as the format's reader.
    OSError
        The file cannot be read.
    """
    read = reader_for(path, format, POLYGON_READERS, POLYGON_FORMATS, "polygon")
    return read(Path(path), binary64=binary64)


def read_instance_file(
    path: str | os.PathLike[str], *, format: str | None = None
) -> cgshop.Instance | None:
    """The CG:SHOP instance in a file, or None if the file is of another format.

    Parameters and refusals are those of `read_polygon_file`.
    """
    if format == "cgshop":
        return cgshop.load_instance(path)
    if format is not None or Path(path).suffix.lower() != ".json":
        return None
    document = safe_json.load(path)
    return cgshop.read_instance(document) if cgshop.is_instance(document) else None


def _dumps_json(polygon: Polygon) -> tuple[str, int]:
    """The document of a polygon, exactly."""
    return safe_json.dumps(dump_polygon(polygon)), 0


POLYGON_WRITERS: Mapping[str, Callable[[Polygon], tuple[str, int]]] = {
    "json": _dumps_json,
    "poly": triangle_poly.dumps_polygon,
    "wkt": wkt.dumps_polygon,
    "geojson": geojson.dumps_polygon,
}
"""Name of a format -> writer: a polygon's text, and how many coordinates were rounded."""
