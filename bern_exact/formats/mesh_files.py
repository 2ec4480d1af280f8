"""Meshes from files and as texts.  The format follows the file's suffix, or is named."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from bern_exact.formats import (
    cgshop_solution,
    msh,
    obj,
    off,
    safe_json,
    triangle_mesh,
    triangle_poly,
    vtk,
    vtu,
)
from bern_exact.formats.dispatch import reader_for
from bern_exact.formats.mesh_json import dumps_mesh, load_array_mesh, read_array_mesh
from bern_exact.plane.array_mesh import ArrayMesh
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon

Found = tuple[ArrayMesh, Polygon | None]
"""A mesh, and the polygon that its file says it triangulates, if any."""


class _Reader(Protocol):
    """Reads one format from a path; `polygon` is the file that the user says has the polygon."""

    def __call__(self, source: Path, /, *, binary64: bool, polygon: Path | None) -> Found: ...


def _alone(read: Callable[..., ArrayMesh]) -> _Reader:
    """The reader of a format that holds no polygon."""

    def load(source: Path, /, *, binary64: bool, polygon: Path | None) -> Found:
        return read(source, binary64=binary64), None

    return load


def _load_json(source: Path, /, *, binary64: bool, polygon: Path | None) -> Found:
    """The mesh in a `bern-exact/mesh` or a CG:SHOP solution: what it holds tells which."""
    document = safe_json.load(source)
    if cgshop_solution.is_solution(document):
        mesh, own = cgshop_solution.read_solution(
            document, source, binary64=binary64, polygon=polygon
        )
        return ArrayMesh.of_mesh(mesh), own
    return read_array_mesh(document, binary64=binary64)


def _load_document(source: Path, /, *, binary64: bool, polygon: Path | None) -> Found:
    """The mesh in a `bern-exact/mesh`."""
    return load_array_mesh(source, binary64=binary64)


def _load_cgshop(source: Path, /, *, binary64: bool, polygon: Path | None) -> Found:
    """The mesh of a CG:SHOP solution."""
    mesh, own = cgshop_solution.load_mesh(source, binary64=binary64, polygon=polygon)
    return ArrayMesh.of_mesh(mesh), own


def _load_poly(source: Path, /, *, binary64: bool, polygon: Path | None) -> Found:
    """The mesh beside a `.poly`, and the polygon in it unless another one is named."""
    own = triangle_poly.load_polygon(source, binary64=binary64) if polygon is None else None
    return triangle_mesh.load_mesh(source, binary64=binary64), own


MESH_FORMATS: Mapping[str, _Reader] = {
    "json": _load_document,
    "cgshop": _load_cgshop,
    "poly": _load_poly,
    "node": _alone(triangle_mesh.load_mesh),
    "off": _alone(off.load_mesh),
    "obj": _alone(obj.load_mesh),
    "msh": _alone(msh.load_mesh),
    "vtk": _alone(vtk.load_mesh),
    "vtu": _alone(vtu.load_mesh),
}
"""Name of a format -> reader of a mesh."""

MESH_READERS: Mapping[str, _Reader] = {
    ".json": _load_json,
    ".ele": MESH_FORMATS["node"],
    **{f".{name}": read for name, read in MESH_FORMATS.items() if name not in ("json", "cgshop")},
}
"""Suffix -> reader of a mesh."""


def read_array_mesh_file(
    path: str | os.PathLike[str],
    *,
    binary64: bool = False,
    format: str | None = None,
    polygon_path: str | os.PathLike[str] | None = None,
) -> tuple[ArrayMesh, Polygon | None]:
    """The mesh in a file, and the polygon that the file says it triangulates, if any.

    The mesh is not judged: indices may be out of range, triangles overlap.

    Parameters
    ----------
    path : path
        Its suffix tells the format.  Of `.node` and `.ele` either is named, or a `.poly` that they
        stand beside.
    binary64 : bool
        Read each decimal as the double nearest to it, then exactly.
    format : str, optional
        A key of `MESH_FORMATS`, whatever the suffix.
    polygon_path : path, optional
        Where the user says that the polygon is: a CG:SHOP solution needs the instance there.

    Raises
    ------
    InputError
        Kind `unsupported`: no such format or none of that suffix; else as the format's reader.
    OSError
        A file cannot be read.
    """
    read = reader_for(path, format, MESH_READERS, MESH_FORMATS, "mesh")
    polygon = None if polygon_path is None else Path(polygon_path)
    return read(Path(path), binary64=binary64, polygon=polygon)


def read_mesh_file(
    path: str | os.PathLike[str], *, binary64: bool = False, format: str | None = None
) -> tuple[Mesh, Polygon | None]:
    """The mesh in a file, every point exact, and the polygon that it triangulates, if any.

    Parameters and refusals are those of `read_array_mesh_file`.
    """
    found, polygon = read_array_mesh_file(path, binary64=binary64, format=format)
    return found.mesh, polygon


@dataclass(frozen=True)
class Written:
    """A mesh as text.

    Parameters
    ----------
    texts : mapping
        Suffix -> text, of each file that the format has; without a suffix where there is one file.
    rounded : int
        How many coordinates were rounded to doubles.
    """

    texts: Mapping[str, str]
    rounded: int


def _one_file(dumps: Callable[[Mesh], tuple[str, int]]) -> Callable[[Mesh], Written]:
    """The writer of a format that has one file."""

    def write(mesh: Mesh) -> Written:
        text, rounded = dumps(mesh)
        return Written({"": text}, rounded)

    return write


def _write_json(mesh: Mesh) -> Written:
    """The document of a mesh, exactly."""
    return Written({"": dumps_mesh(mesh)}, 0)


def _write_node(mesh: Mesh) -> Written:
    """Triangle's two files."""
    node, ele, rounded = triangle_mesh.dumps_mesh(mesh)
    return Written({".node": node, ".ele": ele}, rounded)


MESH_WRITERS: Mapping[str, Callable[[Mesh], Written]] = {
    "json": _write_json,
    "node": _write_node,
    "off": _one_file(off.dumps_mesh),
    "obj": _one_file(obj.dumps_mesh),
    "msh": _one_file(msh.dumps_mesh),
    "vtk": _one_file(vtk.dumps_mesh),
    "vtu": _one_file(vtu.dumps_mesh),
}
"""Name of a format -> writer of a mesh by itself; a CG:SHOP solution needs its instance."""


def format_of_mesh(path: Path) -> str:
    """The format in which a mesh is written to a path: JSON if no other has its suffix.

    >>> [format_of_mesh(Path(name)) for name in ("a.solution.json", "a.mesh.json", "a.1.ele")]
    ['cgshop', 'json', 'node']
    """
    if path.name.lower().endswith(".solution.json"):
        return "cgshop"
    suffix = path.suffix.lower()
    if suffix == ".ele":
        return "node"
    return suffix[1:] if suffix[1:] in (*MESH_WRITERS, "svg") else "json"
