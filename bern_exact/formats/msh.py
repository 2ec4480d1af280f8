"""MSH, of Gmsh: versions 2.2 and 4.1 in ASCII read and written, binary files read by meshio.

The third coordinate must be 0.  Points and lines, groups, entities and data are passed over.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import shown
from bern_exact.formats import meshio_files
from bern_exact.formats.cursor import Cursor
from bern_exact.formats.doubles import Rounding
from bern_exact.formats.token_text import Chosen, TokenText, columns, read_bytes
from bern_exact.plane.array_mesh import ArrayMesh, Indices, Points
from bern_exact.plane.mesh import Mesh

_HEADER = re.compile(
    rb"\s*(?:\$Comments.*?\$EndComments\s*)?\$MeshFormat\s+(\S+)\s+(\S+)", re.DOTALL
)

TRIANGLE = 2
PASSED_OVER = {15: 1, 1: 2, 8: 3, 26: 4, 27: 5, 28: 6}
"""Type -> nodes: a point, and lines of several orders."""

_NAMES = {3: "quadrangles", 4: "tetrahedra", 5: "hexahedra", 9: "triangles of 6 nodes"}


@dataclass(frozen=True)
class _Nodes:
    """Vertices and the numbers by which elements name them."""

    points: Points
    numbers: Indices

    def indices(self, named: Indices) -> Indices:
        """The vertices with these numbers, from 0; what names none is out of range."""
        count = len(self.numbers)
        if np.array_equal(self.numbers, np.arange(1, count + 1)):
            return named - 1
        order = np.argsort(self.numbers, kind="stable")
        ascending = self.numbers[order]
        at = np.minimum(np.searchsorted(ascending, named), max(count - 1, 0))
        if count == 0:
            return np.full(named.shape, -1)
        return np.where(ascending[at] == named, order[at], -1)


def load_mesh(source: Path, /, *, binary64: bool) -> ArrayMesh:
    """The mesh in a MSH file.

    Raises
    ------
    InputError
        Kind `unsupported`: another version, elements that are no triangles, points or lines, a
        third coordinate other than 0, binary files without meshio; `schema`: two nodes of one
        number; `syntax` or `number`, with the line.
    OSError
        The file cannot be read.

    Notes
    -----
    O(n log n) at most; a million triangles take about three seconds.
    """
    data = read_bytes(source)
    header = _HEADER.match(data)
    if header is None:
        raise InputError("syntax", "line 1: $MeshFormat is expected", {"line": 1})
    version, binary = (part.decode("ascii", "backslashreplace") for part in header.groups())
    if binary == "1":
        return meshio_files.load_mesh(source, "gmsh")
    text = TokenText(data)
    line = data.count(b"\n", 0, header.start(1)) + 1
    if version in ("2", "2.0", "2.1", "2.2"):
        read_nodes, read_triangles = _nodes_2, _triangles_2
    elif version == "4.1":
        read_nodes, read_triangles = _nodes_4, _triangles_4
    else:
        message = f"line {line}: MSH 2.2 and 4.1 are read, not {shown(version)}"
        raise InputError("unsupported", message, {"line": line})
    sections = _sections(text)
    nodes = read_nodes(_section(text, sections, "Nodes"), binary64)
    return ArrayMesh(
        nodes.points, nodes.indices(read_triangles(_section(text, sections, "Elements")))
    )


def _sections(text: TokenText) -> dict[str, int]:
    """The word after the heading of each section."""
    letters = np.frombuffer(text.data, dtype=np.uint8)
    marks = np.flatnonzero(letters[text.starts] == ord("$")).tolist()
    found: dict[str, int] = {}
    end = ""
    for word in marks:
        name = text.text(word)
        if end:
            end = "" if name == end else end
            continue
        if name in found and name != "$Comments":
            raise text.refuse("syntax", f"a second {shown(name)}", word)
        found[name] = word + 1
        end = f"$End{name[1:]}"
    if end in ("$EndNodes", "$EndElements"):
        raise text.refuse("syntax", f"the file ends before {end}", len(text))
    return found


def _section(text: TokenText, sections: dict[str, int], name: str) -> Cursor:
    """The beginning of a section."""
    if f"${name}" not in sections:
        raise text.refuse("syntax", f"the file has no section ${name}", len(text))
    return Cursor(text, sections[f"${name}"])


def _numbered(text: TokenText, names: Chosen, xyz: Chosen, binary64: bool) -> _Nodes:
    """Nodes by the words of their numbers and of their coordinates."""
    numbers = text.integers(names)
    if len(np.unique(numbers)) < len(numbers):
        ascending = np.sort(numbers)
        twice = ascending[1:][ascending[1:] == ascending[:-1]][0]
        word = int(names[np.flatnonzero(numbers == twice)[1]])
        raise text.refuse("schema", f"node {twice} is there twice", word)
    text.check_flat(xyz[:, 2])
    return _Nodes(text.points(xyz[:, :2], binary64=binary64), numbers)


def _nodes_2(cursor: Cursor, binary64: bool) -> _Nodes:
    """Version 2: a number and three coordinates a node."""
    count = cursor.whole("the number of nodes")
    words = cursor.take(count, 4, "nodes")
    cursor.expect("$EndNodes")
    return _numbered(cursor.text, words[:, 0], words[:, 1:], binary64)


def _triangles_2(cursor: Cursor) -> Indices:
    """Version 2: number, type, tags and nodes, an element a line."""
    text = cursor.text
    count = cursor.whole("the number of elements")
    row = int(np.searchsorted(text.row_first, cursor.at))
    first, size = text.row_first[row : row + count], text.row_size[row : row + count]
    if len(first) < count or (count and first[0] != cursor.at):
        message = f"$Elements: {count:,} lines are expected"
        raise text.refuse("syntax", message, len(text))
    Cursor(text, int(first[-1] + size[-1]) if count else cursor.at).expect("$EndElements")
    short = np.flatnonzero(size < 3)
    if len(short):
        message = "an element is its number, type, number of tags, tags and nodes"
        raise text.refuse("syntax", message, int(first[short[0]]))
    kinds = text.integers(first + 1)
    _check_kinds(text, kinds, first + 1)
    tags = text.integers(first + 2)
    of = kinds == TRIANGLE
    wrong = np.flatnonzero(of & ((tags < 0) | (size != 6 + tags)))
    if len(wrong):
        message = "a triangle has as many tags as it says, and three nodes"
        raise text.refuse("syntax", message, int(first[wrong[0]]))
    return text.integers(columns(first[of] + 3 + tags[of].astype(np.int64), 0, 1, 2))


def _check_kinds(text: TokenText, kinds: Indices, words: Chosen) -> None:
    """Refuse elements other than triangles, lines and points."""
    bad = np.flatnonzero(~np.isin(kinds, [TRIANGLE, *PASSED_OVER]))
    if len(bad):
        kind = int(kinds[bad[0]])
        message = f"only triangles are read, not {_NAMES.get(kind, f'elements of type {kind}')}"
        raise text.refuse("unsupported", message, int(words[bad[0]]))


def _nodes_4(cursor: Cursor, binary64: bool) -> _Nodes:
    """Version 4.1: blocks, each of all its nodes' numbers, then all their coordinates."""
    blocks = cursor.whole("the number of blocks of nodes")
    count = cursor.whole("the number of nodes")
    cursor.take(1, 2, "least and greatest numbers")
    names, places = [np.empty(0, dtype=np.int64)], [np.empty((0, 3), dtype=np.int64)]
    for _ in range(blocks):
        dimension = cursor.whole("the dimension of an entity")
        cursor.take(1, 1, "entities")
        parametric = cursor.whole("whether the nodes are parametric")
        size = cursor.whole("the number of nodes in a block")
        if dimension > 3:
            message = f"an entity has dimension 0 to 3, not {dimension}"
            raise cursor.text.refuse("syntax", message, cursor.at - 4)
        names.append(cursor.take(size, 1, "nodes").reshape(-1))
        width = 3 + (dimension if parametric else 0)
        places.append(cursor.take(size, width, "nodes")[:, :3])
    cursor.expect("$EndNodes")
    words = np.concatenate(names)
    if len(words) != count:
        message = f"the blocks hold {len(words):,} nodes, and $Nodes says {count:,}"
        raise cursor.text.refuse("syntax", message, cursor.at - 1)
    return _numbered(cursor.text, words, np.concatenate(places), binary64)


def _triangles_4(cursor: Cursor) -> Indices:
    """Version 4.1: blocks of elements of one type."""
    text = cursor.text
    blocks = cursor.whole("the number of blocks of elements")
    count = cursor.whole("the number of elements")
    cursor.take(1, 2, "least and greatest numbers")
    corners, seen = [np.empty((0, 3), dtype=np.int64)], 0
    for _ in range(blocks):
        cursor.take(1, 2, "dimensions and entities")
        kind = cursor.whole("the type of elements")
        _check_kinds(text, np.array([kind]), np.array([cursor.at - 1]))
        size = cursor.whole("the number of elements in a block")
        words = cursor.take(size, 1 + PASSED_OVER.get(kind, 3), "elements")
        seen += size
        if kind == TRIANGLE:
            corners.append(words[:, 1:])
    cursor.expect("$EndElements")
    if seen != count:
        message = f"the blocks hold {seen:,} elements, and $Elements says {count:,}"
        raise text.refuse("syntax", message, cursor.at - 1)
    return text.integers(np.concatenate(corners))


def dumps_mesh(mesh: Mesh) -> tuple[str, int]:
    """A mesh as MSH 4.1 in ASCII, and the number of coordinates that were rounded to doubles.

    Raises
    ------
    InputError
        Kind `number`: a coordinate is beyond all doubles.
    """
    rounding = Rounding()
    pairs = rounding.pairs(mesh.vertices)
    nodes, triangles = len(pairs), len(mesh.triangles)
    lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$Nodes"]
    lines += [f"1 {nodes} 1 {nodes}", f"2 1 0 {nodes}"]
    lines += [str(v) for v in range(1, nodes + 1)]
    lines += [f"{x} {y} 0" for x, y in pairs]
    lines += ["$EndNodes", "$Elements", f"1 {triangles} 1 {triangles}", f"2 1 2 {triangles}"]
    corners = enumerate(mesh.triangles, 1)
    lines += [f"{t} {a + 1} {b + 1} {c + 1}" for t, (a, b, c) in corners]
    lines.append("$EndElements")
    return "\n".join(lines) + "\n", rounding.rounded
