"""OFF, the object file format of Geomview, in ASCII: read and written.

The third coordinate must be 0.  Colours and normals are passed over, faces of fewer than three
corners too.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from bern_exact.formats.doubles import Rounding
from bern_exact.formats.token_text import Chosen, TokenText, columns
from bern_exact.formats.triangle_mesh import check_end, rows
from bern_exact.plane.array_mesh import ArrayMesh
from bern_exact.plane.mesh import Mesh

_HEADER = re.compile(r"(?:ST)?C?N?OFF")


def load_mesh(source: Path, /, *, binary64: bool) -> ArrayMesh:
    """The mesh in an OFF file; a vertex and a face a line.

    Raises
    ------
    InputError
        With the line.  Kind `unsupported`: four coordinates, binary files, faces of more than
        three corners, a third coordinate other than 0; `syntax`, `number`.
    OSError
        The file cannot be read.

    Notes
    -----
    Linear; a million triangles take about two seconds.
    """
    text = TokenText.of_file(source, comments=True)
    row, word = _header(text)
    vertices = text.whole(word, "the number of vertices")
    faces = text.whole(word + 1, "the number of faces")
    first = rows(text, row, vertices, 3, "vertex")
    text.check_flat(first + 2)
    points = text.points(columns(first, 0, 1), binary64=binary64)
    first = rows(text, row + vertices, faces, 1, "face")
    check_end(text, row + vertices + faces)
    return ArrayMesh(points, text.integers(_corners(text, first, row + vertices)))


def _header(text: TokenText) -> tuple[int, int]:
    """The row of the first vertex, and the word that counts the vertices."""
    if len(text) == 0:
        raise text.refuse("syntax", "the file is empty", 0)
    if text.text(0).isdigit():
        return 1, 0
    if not _HEADER.fullmatch(text.text(0)):
        kind = "unsupported" if text.text(0).endswith("OFF") else "syntax"
        raise text.refuse(kind, "the first word of the files that are read is OFF", 0)
    if len(text) > 1 and text.text(1) == "BINARY":
        raise text.refuse("unsupported", "binary OFF files are not read", 1)
    return (1 if text.row_size[0] > 1 else 2), 1


def _corners(text: TokenText, first: Chosen, row: int) -> Chosen:
    """The words that name the corners of triangles."""
    sizes = text.integers(first)
    large = np.flatnonzero(sizes > 3)
    if len(large):
        message = f"only triangles are read, not faces of {sizes[large[0]]} corners"
        raise text.refuse("unsupported", message, int(first[large[0]]))
    short = np.flatnonzero((sizes < 0) | (text.row_size[row : row + len(first)] <= sizes))
    if len(short):
        message = "a face has fewer corners than it says"
        raise text.refuse("syntax", message, int(first[short[0]]))
    return columns(first[sizes == 3], 1, 2, 3)


def dumps_mesh(mesh: Mesh) -> tuple[str, int]:
    """A mesh as OFF, and the number of coordinates that were rounded to doubles.

    Raises
    ------
    InputError
        Kind `number`: a coordinate is beyond all doubles.
    """
    rounding = Rounding()
    lines = ["OFF", f"{len(mesh.vertices)} {len(mesh.triangles)} 0"]
    lines += [f"{x} {y} 0" for x, y in rounding.pairs(mesh.vertices)]
    lines += [f"3 {a} {b} {c}" for a, b, c in mesh.triangles]
    return "\n".join(lines) + "\n", rounding.rounded
