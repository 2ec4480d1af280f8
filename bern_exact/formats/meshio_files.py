"""Binary files, read by meshio (an optional extra): doubles or singles, each exactly."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any

import numpy as np

from bern_exact.exact.errors import InputError
from bern_exact.plane.array_mesh import ArrayMesh

PASSED_OVER = frozenset(("vertex", "line", "line3", "line4", "line5", "line6"))


def load_mesh(source: Path, format: str) -> ArrayMesh:
    """The mesh that meshio finds in a file.

    Parameters
    ----------
    source : Path
        The file.
    format : {"gmsh", "vtk", "vtu"}
        meshio's name of its format.

    Raises
    ------
    InputError
        Kind `unsupported`: meshio is not installed, a third coordinate is not 0, or there are cells
        other than triangles, lines and points; `syntax`: meshio cannot read it; `number`: a
        coordinate is not finite.
    OSError
        The file cannot be read.
    """
    try:
        reader = importlib.import_module(f"meshio.{format}")
    except ImportError:
        message = (
            "binary files and compressed ones are read by meshio, which is not installed: "
            "pip install 'bern_exact[meshio]', or write the file in ASCII"
        )
        raise InputError("unsupported", message) from None
    try:
        found = reader.read(source)
    except OSError:
        raise
    except Exception as error:  # whatever meshio meets in a broken file
        reason = " ".join(str(error).split())[:200] or type(error).__name__
        raise InputError("syntax", f"meshio cannot read the file: {reason}") from None
    return mesh_of(found)


def mesh_of(found: Any) -> ArrayMesh:
    """The triangles of a `meshio.Mesh`.

    Raises
    ------
    InputError
        As `load_mesh`.
    """
    points = np.asarray(found.points, dtype=np.float64)
    if points.ndim != 2 or points.shape[1] not in (2, 3):
        raise InputError("syntax", "points of two or three coordinates are expected")
    bad = np.flatnonzero((points[:, 2:] != 0).any(axis=1))
    if len(bad):
        message = f"the mesh is not planar: a third coordinate is not 0 (point {int(bad[0])})"
        raise InputError("unsupported", message, {"vertex": int(bad[0])})
    corners = [np.empty((0, 3), dtype=np.int64)]
    for block in found.cells:
        if block.type == "triangle":
            corners.append(np.asarray(block.data).reshape(-1, 3).astype(np.int64))
        elif block.type not in PASSED_OVER:
            message = f"only triangles are read, not cells of type {str(block.type)!r:.40}"
            raise InputError("unsupported", message)
    return ArrayMesh.of_doubles(points[:, :2] + 0, np.concatenate(corners))
