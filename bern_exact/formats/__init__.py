"""Reading and writing files.  The format follows the file's suffix."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Protocol, TypeVar

from bern_exact.exact.errors import InputError
from bern_exact.formats.mesh_json import load_mesh
from bern_exact.formats.polygon_json import load_polygon
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon

_T_co = TypeVar("_T_co", covariant=True)


class _Reader(Protocol[_T_co]):
    """Reads one format from a path."""

    def __call__(self, source: Path, /, *, binary64: bool) -> _T_co: ...


POLYGON_READERS: Mapping[str, _Reader[Polygon]] = {".json": load_polygon}
"""Suffix -> reader of a polygon."""

MESH_READERS: Mapping[str, _Reader[tuple[Mesh, Polygon | None]]] = {".json": load_mesh}
"""Suffix -> reader of a mesh, and of its polygon if the format holds one."""


def read_polygon_file(path: str | os.PathLike[str], *, binary64: bool = False) -> Polygon:
    """The polygon in a file.

    Parameters
    ----------
    path : path
        Its suffix names the format: `.json`.
    binary64 : bool
        Read each decimal as the double nearest to it, then exactly.

    Raises
    ------
    InputError
        Kind `unsupported`: no format has that suffix; else as the format's reader.
    OSError
        The file cannot be read.
    """
    return _reader(path, POLYGON_READERS, "polygon")(Path(path), binary64=binary64)


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
