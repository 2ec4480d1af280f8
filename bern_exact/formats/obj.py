"""OBJ, of Wavefront: vertices `v` and faces `f`, read and written.

The third coordinate must be 0.  Faces may name textures and normals (`f 1/2/3 ...`) and count back
from the last vertex (`f -3 -2 -1`).  Lines and points, groups, materials and the like are passed
over; free-form curves and surfaces are refused.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from bern_exact.exact.numbers import shown
from bern_exact.formats.doubles import Rounding
from bern_exact.formats.token_text import Chosen, TokenText, columns, read_bytes, without_comments
from bern_exact.plane.array_mesh import ArrayMesh, Indices
from bern_exact.plane.mesh import Mesh

_PASSED_OVER = frozenset(
    b"vt vn vp g o s mg usemtl mtllib usemap maplib l p bevel c_interp d_interp lod".split()
)
_FREE_FORM = frozenset(
    b"cstype deg bmat step curv curv2 surf parm trim hole scrv sp end con".split()
)
_CORNER = re.compile(rb"[^/]+(?:/[0-9+-]*)*")
_CONTINUED = re.compile(rb"\\[ \t]*\r?\n")


def load_mesh(source: Path, /, *, binary64: bool) -> ArrayMesh:
    """The mesh in an OBJ file.

    Raises
    ------
    InputError
        With the line.  Kind `unsupported`: faces of more than three corners, a third coordinate
        other than 0, free forms; `syntax`, `number`.
    OSError
        The file cannot be read.

    Notes
    -----
    Linear; a million triangles take about two seconds.
    """
    data = without_comments(read_bytes(source))
    if b"\\" in data:
        data = _CONTINUED.sub(b" ", data)
    text = TokenText(data)
    vertex, face = _kinds(text)
    first, size = text.row_first[vertex], text.row_size[vertex]
    _check_sizes(text, first, size, 3, 8, "a vertex has coordinates x y z")
    text.check_flat(first[size > 3] + 3)
    points = text.points(columns(first, 1, 2), binary64=binary64)
    first, size = text.row_first[face], text.row_size[face]
    large = np.flatnonzero(size > 4)
    if len(large):
        message = f"only triangles are read, not faces of {size[large[0]] - 1} corners"
        raise text.refuse("unsupported", message, int(first[large[0]]))
    _check_sizes(text, first, size, 4, 4, "a face has three corners")
    before = np.cumsum(vertex)[face]  # how many vertices stand before each face
    return ArrayMesh(points, _zero_based(_corners(text, columns(first, 1, 2, 3)), before))


def _kinds(text: TokenText) -> tuple[Chosen, Chosen]:
    """Which rows are vertices, and which faces."""
    first = text.row_first
    letters = np.frombuffer(text.data, dtype=np.uint8)
    start, size = text.starts[first], text.ends[first] - text.starts[first]
    letter, last = letters[start], letters[text.ends[first] - 1]
    vertex, face = (size == 1) & (letter == ord("v")), (size == 1) & (letter == ord("f"))
    often = (size == 2) & (letter == ord("v")) & ((last == ord("t")) | (last == ord("n")))
    for word in first[~(vertex | face | often)].tolist():
        keyword = text.raw(word)
        if keyword in _FREE_FORM:
            message = f"free-form curves and surfaces are not read: {shown(text.text(word))}"
            raise text.refuse("unsupported", message, word)
        if keyword not in _PASSED_OVER:
            raise text.refuse("syntax", f"{shown(text.text(word))} begins no line of OBJ", word)
    return vertex, face


def _check_sizes(
    text: TokenText, first: Chosen, size: Chosen, least: int, most: int, rule: str
) -> None:
    """Refuse rows of fewer or more words."""
    wrong = np.flatnonzero((size < least) | (size > most))
    if len(wrong):
        message = f"{rule}, and here are {size[wrong[0]] - 1} words"
        raise text.refuse("syntax", message, int(first[wrong[0]]))


def _corners(text: TokenText, words: Chosen) -> Indices:
    """The vertices that corners name: what stands before a stroke."""
    if b"/" not in text.data:
        return text.integers(words)
    flat = words.reshape(-1)
    letters = np.frombuffer(text.data, dtype=np.uint8)
    strokes = np.append(np.flatnonzero(letters == ord("/")), len(letters))
    stroke = strokes[np.searchsorted(strokes, text.starts[flat])]
    end = text.ends[flat]
    change = np.zeros(len(letters) + 1, dtype=np.int8)
    change[stroke[stroke < end]] = 1
    change[end[stroke < end]] = -1
    cut = np.cumsum(change[:-1], dtype=np.int8).view(bool)
    odd = bool((stroke == text.starts[flat]).any())
    if odd or letters[cut].tobytes().translate(None, b"0123456789+-/"):
        word = next(w for w in flat.tolist() if not _CORNER.fullmatch(text.raw(w)))
        raise text.refuse("syntax", f"{shown(text.text(word))} is no corner of a face", word)
    return TokenText(np.where(cut, np.uint8(32), letters).tobytes()).integers(words)


def _zero_based(corners: Indices, before: Chosen) -> Indices:
    """Indices from 0; what counts back counts from the vertices before its face."""
    back: Indices = corners + before[:, None]
    return np.where(corners < 0, back, corners - 1)


def dumps_mesh(mesh: Mesh) -> tuple[str, int]:
    """A mesh as OBJ, and the number of coordinates that were rounded to doubles.

    Raises
    ------
    InputError
        Kind `number`: a coordinate is beyond all doubles.
    """
    rounding = Rounding()
    lines = [f"v {x} {y} 0" for x, y in rounding.pairs(mesh.vertices)]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in mesh.triangles]
    return "".join(f"{line}\n" for line in lines), rounding.rounded
