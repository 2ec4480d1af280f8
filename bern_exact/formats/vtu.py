"""VTK's XML files of unstructured grids: `.vtu`, ASCII read and written; other encodings: meshio.

One piece is read; the third coordinate must be 0.  Vertices, lines and data are passed over.
Documents with a type declaration are refused, and with it every entity of their own.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import NoReturn
from xml.parsers import expat

import numpy as np

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import shown
from bern_exact.formats import meshio_files, vtk_cells
from bern_exact.formats.doubles import Rounding
from bern_exact.formats.token_text import TokenText, read_bytes
from bern_exact.plane.array_mesh import ArrayMesh, Indices, Points
from bern_exact.plane.mesh import Mesh

_WANTED = ("points", "connectivity", "offsets", "types")


class _Binary(Exception):
    """An array is not in ASCII."""


@dataclass
class _Array:
    """The text of an array, the line on which it begins, and its components."""

    line: int
    components: str
    pieces: list[str] = field(default_factory=list)

    @property
    def text(self) -> TokenText:
        """The words of the array."""
        data = "".join(self.pieces).encode("ascii", "backslashreplace")
        return TokenText(data, first_line=self.line)


class _Scanner:
    """What an XML file holds of a mesh."""

    def __init__(self) -> None:
        self.arrays: dict[str, _Array] = {}
        self.counts: dict[str, str] = {}
        self.inside: list[str] = []
        self.current: _Array | None = None
        self.parser = expat.ParserCreate()
        self.parser.buffer_text = True
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._end
        self.parser.CharacterDataHandler = self._characters
        self.parser.StartDoctypeDeclHandler = self._refuse_doctype

    def scan(self, data: bytes) -> None:
        """Go through the file."""
        try:
            self.parser.Parse(data, True)
        except InputError:
            raise
        except expat.ExpatError as error:
            reason = expat.ErrorString(error.code)
            raise _refused("syntax", f"no XML: {reason}", error.lineno) from None
        except (ValueError, LookupError):  # an encoding that nobody knows
            raise _refused("syntax", "no XML of a known encoding", 1) from None
        if not self.counts:
            raise _refused("syntax", "the grid has no Piece", self.parser.CurrentLineNumber)

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        line = self.parser.CurrentLineNumber
        self._check_place(name, attributes, line)
        if name == "AppendedData":
            raise _Binary
        if name == "Piece":
            if self.counts:
                raise _refused("unsupported", "only one Piece is read", line)
            self.counts = attributes
        if name == "DataArray" and self.inside:
            wanted = "points" if self.inside[-1] == "Points" else attributes.get("Name", "")
            if self.inside[-1] in ("Points", "Cells") and wanted in _WANTED:
                if attributes.get("format", "ascii") != "ascii":
                    raise _Binary
                self.current = _Array(line, attributes.get("NumberOfComponents", ""))
                self.arrays[wanted] = self.current
        self.inside.append(name)

    def _check_place(self, name: str, attributes: dict[str, str], line: int) -> None:
        """Refuse other files than of unstructured grids."""
        if not self.inside and name != "VTKFile":
            raise _refused("syntax", f"VTKFile is expected, not {shown(name)}", line)
        if name == "VTKFile" and attributes.get("type") != "UnstructuredGrid":
            kind = shown(attributes.get("type", ""))
            raise _refused("unsupported", f"files of {kind} are not read", line)

    def _end(self, name: str) -> None:
        self.inside.pop()
        self.current = None

    def _characters(self, text: str) -> None:
        if self.current is not None:
            self.current.pieces.append(text)

    def _refuse_doctype(self, *_: object) -> NoReturn:
        line = self.parser.CurrentLineNumber
        raise _refused("unsupported", "a document type declaration is not read", line)


def _refused(kind: str, message: str, line: int) -> InputError:
    return InputError(kind, f"line {line}: {message}", {"line": line})


def load_mesh(source: Path, /, *, binary64: bool) -> ArrayMesh:
    """The mesh in a `.vtu`.

    Raises
    ------
    InputError
        Kind `unsupported`: another data set, several pieces, a document type declaration, cells
        that are no triangles, lines or points, a third coordinate other than 0, other encodings
        than ASCII without meshio; `syntax` or `number`, with the line.
    OSError
        The file cannot be read.

    Notes
    -----
    Linear; a million triangles take about three seconds.
    """
    scanner = _Scanner()
    try:
        scanner.scan(read_bytes(source))
    except _Binary:
        return meshio_files.load_mesh(source, "vtu")
    texts = {}
    for name in _WANTED:
        if name not in scanner.arrays:
            line = scanner.parser.CurrentLineNumber
            raise _refused("syntax", f"the Piece has no array {name!r} in ASCII", line)
        texts[name] = scanner.arrays[name].text
    points = _points(texts["points"], scanner, binary64)
    kinds, ends = (text.integers(_all(text)) for text in (texts["types"], texts["offsets"]))
    for name, found in (("NumberOfCells", len(ends)), ("NumberOfPoints", len(points))):
        said = scanner.counts.get(name, str(found))
        if said.strip() != str(found):
            line = scanner.arrays["types" if name == "NumberOfCells" else "points"].line
            raise _refused("syntax", f"{name} is {shown(said)}, and there are {found:,}", line)
    corners = texts["connectivity"]
    return ArrayMesh(points, vtk_cells.triangles(corners, _all(corners), ends, kinds, None))


def _all(text: TokenText) -> Indices:
    """All words of an array."""
    return np.arange(len(text), dtype=np.int64)


def _points(text: TokenText, scanner: _Scanner, binary64: bool) -> Points:
    """The points, three coordinates each."""
    if scanner.arrays["points"].components.strip() not in ("3", ""):
        line = scanner.arrays["points"].line
        raise _refused("syntax", "points have three components", line)
    if len(text) % 3:
        raise text.refuse("syntax", "points have three coordinates each", len(text))
    words = _all(text).reshape(-1, 3)
    text.check_flat(words[:, 2])
    return text.points(words[:, :2], binary64=binary64)


def dumps_mesh(mesh: Mesh) -> tuple[str, int]:
    """A mesh as `.vtu` in ASCII, and the number of coordinates that were rounded to doubles.

    Raises
    ------
    InputError
        Kind `number`: a coordinate is beyond all doubles.
    """
    rounding = Rounding()
    count = len(mesh.triangles)
    lines = [
        '<?xml version="1.0"?>',
        '<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">',
        "<UnstructuredGrid>",
        f'<Piece NumberOfPoints="{len(mesh.vertices)}" NumberOfCells="{count}">',
        "<Points>",
        '<DataArray type="Float64" Name="Points" NumberOfComponents="3" format="ascii">',
        *(f"{x} {y} 0" for x, y in rounding.pairs(mesh.vertices)),
        "</DataArray>",
        "</Points>",
        "<Cells>",
        '<DataArray type="Int64" Name="connectivity" format="ascii">',
        *(f"{a} {b} {c}" for a, b, c in mesh.triangles),
        "</DataArray>",
        '<DataArray type="Int64" Name="offsets" format="ascii">',
        *(str(3 * t) for t in range(1, count + 1)),
        "</DataArray>",
        '<DataArray type="UInt8" Name="types" format="ascii">',
        *(str(vtk_cells.TRIANGLE) for _ in range(count)),
        "</DataArray>",
        "</Cells>",
        "</Piece>",
        "</UnstructuredGrid>",
        "</VTKFile>",
    ]
    return "\n".join(lines) + "\n", rounding.rounded
