"""Reading and writing files.  The format follows the file's suffix, or is named."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Protocol, TypeVar

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import shown
from bern_exact.formats import cgshop, safe_json
from bern_exact.formats.mesh_json import load_mesh
from bern_exact.formats.polygon_json import load_polygon, read_polygon
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon

_T_co = TypeVar("_T_co", covariant=True)


class _Reader(Protocol[_T_co]):
    """Reads one format from a path."""

    def __call__(self, source: Path, /, *, binary64: bool) -> _T_co: ...


def _load_json(source: Path, /, *, binary64: bool) -> Polygon:
    """The polygon in a JSON file of any of the formats here: what it holds tells which."""
    document = safe_json.load(source)
    if cgshop.is_instance(document):
        return cgshop.read_instance(document).polygon
    return read_polygon(document, binary64=binary64)


def _load_cgshop(source: Path, /, *, binary64: bool) -> Polygon:
    """The polygon of a CG:SHOP instance, whose integers are what they are."""
    return cgshop.load_instance(source).polygon


POLYGON_READERS: Mapping[str, _Reader[Polygon]] = {".json": _load_json}
"""Suffix -> reader of a polygon."""

POLYGON_FORMATS: Mapping[str, _Reader[Polygon]] = {"json": load_polygon, "cgshop": _load_cgshop}
"""Name of a format -> reader of a polygon."""

MESH_READERS: Mapping[str, _Reader[tuple[Mesh, Polygon | None]]] = {".json": load_mesh}
"""Suffix -> reader of a mesh, and of its polygon if the format holds one."""

MESH_FORMATS = ("json", "cgshop")
"""Names of the formats in which meshes are written."""


def read_polygon_file(
    path: str | os.PathLike[str], *, binary64: bool = False, format: str | None = None
) -> Polygon:
    """The polygon in a file.

    Parameters
    ----------
    path : path
        Its suffix tells the format: `.json`, a `bern-exact/polygon` or a CG:SHOP instance.
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
    if format is None:
        read = _reader(path, POLYGON_READERS, "polygon")
    elif format in POLYGON_FORMATS:
        read = POLYGON_FORMATS[format]
    else:
        known = ", ".join(POLYGON_FORMATS)
        raise InputError("unsupported", f"no polygon format {shown(format)}; there are: {known}")
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


def format_of_mesh(path: Path) -> str:
    """In which of `MESH_FORMATS` a mesh is written to a path: CG:SHOP's for `.solution.json`.

    >>> format_of_mesh(Path("a.solution.json")), format_of_mesh(Path("a.mesh.json"))
    ('cgshop', 'json')
    """
    return "cgshop" if path.name.lower().endswith(".solution.json") else "json"


def read_mesh_file(
    path: str | os.PathLike[str], *, binary64: bool = False
) -> tuple[Mesh, Polygon | None]:
    """The mesh in a file, and the polygon that the file says it triangulates, if any.

    Parameters and refusals are those of `read_polygon_file`.  The mesh is not judged.
    """
    return _reader(path, MESH_READERS, "mesh")(Path(path), binary64=binary64)


_R = TypeVar("_R")


def _reader(path: str | os.PathLike[str], readers: Mapping[str, _R], what: str) -> _R:
    """The reader for a path's suffix, in any case of letters."""
    suffix = Path(path).suffix.lower()
    if suffix not in readers:
        known = ", ".join(sorted(readers))
        message = f"no {what} format has the suffix {suffix!r}; there are: {known}"
        raise InputError("unsupported", message, {"suffix": suffix})
    return readers[suffix]
