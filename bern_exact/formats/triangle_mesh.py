"""Meshes of Shewchuk's Triangle: vertices in a `.node`, triangles in the `.ele` beside it.

Vertices are numbered from 0 or from 1, whichever the first one has; what follows a `#` is a
comment; attributes and boundary markers are passed over.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import shown
from bern_exact.formats.doubles import Rounding
from bern_exact.formats.token_text import Chosen, TokenText, columns
from bern_exact.plane.array_mesh import ArrayMesh, Indices, Points
from bern_exact.plane.mesh import Mesh


@dataclass(frozen=True)
class Nodes:
    """Vertices, and the number of the first one.

    Parameters
    ----------
    points : Points
        In order.
    first : int
        0 or 1.
    """

    points: Points
    first: int


def load_mesh(source: Path, /, *, binary64: bool) -> ArrayMesh:
    """The mesh of a `.node` and a `.ele`; either is named, or a `.poly` of the same name.

    Raises
    ------
    InputError
        Kind `schema`: the other file is not there; `unsupported`: three dimensions, or triangles
        of six nodes; `syntax` or `number`, with file and line.
    OSError
        A file cannot be read.

    Notes
    -----
    Linear; a million triangles take about two seconds.
    """
    suffix = source.suffix.lower()
    node = source if suffix == ".node" else beside(source, ".node")
    ele = source if suffix == ".ele" else beside(source, ".ele")
    nodes = load_nodes(node, binary64=binary64)
    return ArrayMesh(nodes.points, _triangles(ele, nodes.first))


def beside(source: Path, suffix: str) -> Path:
    """The file of the same name with another suffix, in the same case of letters or in lower case.

    Raises
    ------
    InputError
        Kind `schema`: there is none.
    """
    candidates = [source.with_suffix(suffix)]
    if source.suffix.isupper():
        candidates.insert(0, source.with_suffix(suffix.upper()))
    found = next((path for path in candidates if path.is_file()), None)
    if found is None:
        name = candidates[0].name
        message = f"{source.name} needs {name} beside it, and there is no such file"
        raise InputError("schema", message, {"file": name})
    return found


def load_nodes(source: Path, *, binary64: bool) -> Nodes:
    """The vertices in a `.node`.

    Raises
    ------
    InputError
        As `load_mesh`.
    """
    text = TokenText.of_file(source, comments=True, name=source.name)
    nodes, row = read_nodes(text, binary64=binary64)
    check_end(text, row)
    return nodes


def read_nodes(text: TokenText, *, binary64: bool) -> tuple[Nodes, int]:
    """The vertices at the beginning of a text without comments, and the row after them.

    Raises
    ------
    InputError
        Kind `unsupported`: three dimensions; `syntax`: another number of lines or of words on a
        line than the first line says, or vertices that are not numbered in order; `number`.
    """
    count = text.whole(0, "the number of vertices")
    dimension = text.whole(1, "the dimension")
    if dimension != 2:
        raise text.refuse("unsupported", f"the dimension is 2 here, not {dimension}", 1)
    first = rows(text, 1, count, 3, "vertex")
    if len(first) == 0:
        return Nodes(text.points(np.empty((0, 2), dtype=np.int64), binary64=binary64), 0), 1
    numbers = text.integers(first)
    base = int(numbers[0])
    wrong = np.flatnonzero(numbers != base + np.arange(count)) if base in (0, 1) else [0]
    if len(wrong):
        word = int(first[wrong[0]])
        message = "vertices are numbered in order from 0 or 1, and this is no. "
        raise text.refuse("syntax", message + shown(text.text(word)), word)
    return Nodes(text.points(columns(first, 1, 2), binary64=binary64), base), 1 + count


def rows(text: TokenText, row: int, count: int, least: int, what: str) -> Chosen:
    """The first words of `count` lines from a row on, each of at least `least` words.

    Raises
    ------
    InputError
        Kind `syntax`: there are fewer lines or words.
    """
    if row + count > len(text.row_first):
        there = len(text.row_first) - row
        message = f"the file ends after {max(there, 0):,} of {count:,} lines ({what})"
        raise text.refuse("syntax", message, len(text))
    short = np.flatnonzero(text.row_size[row : row + count] < least)
    if len(short):
        at = row + int(short[0])
        message = f"{what}: {least} numbers are expected, not {int(text.row_size[at])}"
        raise text.refuse("syntax", message, int(text.row_first[at]))
    return text.row_first[row : row + count]


def check_end(text: TokenText, row: int) -> None:
    """Refuse lines after the last one that the counts allow.

    Raises
    ------
    InputError
        Kind `syntax`.
    """
    if row < len(text.row_first):
        message = "there are more lines than the counts say"
        raise text.refuse("syntax", message, int(text.row_first[row]))


def _triangles(source: Path, base: int) -> Indices:
    """The triangles in a `.ele`, 0-based."""
    text = TokenText.of_file(source, comments=True, name=source.name)
    count = text.whole(0, "the number of triangles")
    if text.row_size[0] > 1:
        corners = text.whole(1, "the number of nodes a triangle")
        if corners != 3:
            message = f"triangles of 3 nodes are read, not of {corners}"
            raise text.refuse("unsupported", message, 1)
    first = rows(text, 1, count, 4, "triangle")
    check_end(text, 1 + count)
    return text.integers(columns(first, 0, 1, 2, 3))[:, 1:] - base


def dumps_mesh(mesh: Mesh) -> tuple[str, str, int]:
    """A mesh as `.node` and `.ele`, 1-based, and the number of coordinates that were rounded.

    Raises
    ------
    InputError
        Kind `number`: a coordinate is beyond all doubles.
    """
    rounding = Rounding()
    pairs = rounding.pairs(mesh.vertices)
    node = [f"{len(pairs)} 2 0 0", *(f"{v} {x} {y}" for v, (x, y) in enumerate(pairs, 1))]
    ele = [f"{len(mesh.triangles)} 3 0"]
    ele += [f"{t} {a + 1} {b + 1} {c + 1}" for t, (a, b, c) in enumerate(mesh.triangles, 1)]
    return "\n".join(node) + "\n", "\n".join(ele) + "\n", rounding.rounded
