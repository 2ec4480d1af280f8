"""Legacy VTK files: unstructured grids and polygonal data, ASCII read and written; binary: meshio.

The third coordinate must be 0.  Vertices, lines and data are passed over.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import shown
from bern_exact.formats import meshio_files, vtk_cells
from bern_exact.formats.cursor import Cursor
from bern_exact.formats.doubles import Rounding
from bern_exact.formats.token_text import Chosen, TokenText, read_bytes
from bern_exact.plane.array_mesh import ArrayMesh, Indices, Points
from bern_exact.plane.mesh import Mesh

_HEADER = re.compile(rb"#\s*vtk DataFile Version[^\n]*\n[^\n]*\n\s*(ASCII|BINARY)\b", re.IGNORECASE)
_BLANK_LINE = re.compile(rb"\n[ \t\r]*\n")
_GRIDS = ("UNSTRUCTURED_GRID", "POLYDATA")

Cells = tuple[Chosen, Indices]
"""The words of all corners, and where each cell's end among them."""


def load_mesh(source: Path, /, *, binary64: bool) -> ArrayMesh:
    """The mesh in a legacy VTK file.

    Raises
    ------
    InputError
        Kind `unsupported`: another data set, cells that are no triangles, lines or points, a third
        coordinate other than 0, binary files without meshio; `syntax` or `number`, with the line.
    OSError
        The file cannot be read.

    Notes
    -----
    Linear; a million triangles take about three seconds.
    """
    data = read_bytes(source)
    header = _HEADER.match(data)
    if header is None:
        message = "line 1: `# vtk DataFile Version`, a title, and ASCII or BINARY are expected"
        raise InputError("syntax", message, {"line": 1})
    if header.group(1).upper() == b"BINARY":
        return meshio_files.load_mesh(source, "vtk")
    first_line = data.count(b"\n", 0, header.end()) + 1
    return _Reader(TokenText(data[header.end() :], first_line=first_line), binary64).mesh()


class _Reader:
    """The parts of a file after its header."""

    def __init__(self, text: TokenText, binary64: bool) -> None:
        self.text, self.binary64 = text, binary64
        self.cursor = Cursor(text)
        self.points: Points | None = None
        self.cells: Cells | None = None
        self.polygons: Cells | None = None
        self.kinds: Chosen | None = None

    def mesh(self) -> ArrayMesh:
        """Read to the end, or to the data of points and cells."""
        self.cursor.expect("DATASET")
        if (grid := self.cursor.word("the kind of data set").upper()) not in _GRIDS:
            message = f"data sets of kind {shown(grid)} are not read: {', '.join(_GRIDS)} are"
            raise self.text.refuse("unsupported", message, self.cursor.at - 1)
        while not self.cursor.at_end:
            word = self.cursor.word("a keyword").upper()
            if word in ("POINT_DATA", "CELL_DATA"):
                break
            self._part(word)
        if self.points is None:
            raise self.text.refuse("syntax", "the file has no POINTS", len(self.text))
        return ArrayMesh(self.points, np.concatenate([self._of_cells(), self._of_polygons()]))

    def _part(self, word: str) -> None:
        """What a keyword begins."""
        match word:
            case "POINTS":
                count = self.cursor.whole("the number of points")
                self.cursor.word("the type of the coordinates")
                words = self.cursor.take(count, 3, "points")
                self.text.check_flat(words[:, 2])
                self.points = self.text.points(words[:, :2], binary64=self.binary64)
            case "CELLS":
                self.cells = self._cells()
            case "CELL_TYPES":
                count = self.cursor.whole("the number of cells")
                self.kinds = self.cursor.take(count, 1, "types").reshape(-1)
            case "POLYGONS":
                self.polygons = self._cells()
            case "VERTICES" | "LINES":
                self._cells()
            case "FIELD":
                self._pass_field()
            case "METADATA":
                self._pass_metadata()
            case _:
                kind = "unsupported" if word == "TRIANGLE_STRIPS" else "syntax"
                message = (
                    f"{shown(word)} is not read"
                    if word.isidentifier()
                    else (f"a keyword is expected, not {shown(word)}")
                )
                raise self.text.refuse(kind, message, self.cursor.at - 1)

    def _cells(self) -> Cells:
        """Cells as sizes and corners, or (from version 5.1 on) as offsets and all corners."""
        count = self.cursor.whole("the number of cells")
        size = self.cursor.whole("the size of the list of cells")
        following = self.cursor.at
        if following < len(self.text) and self.text.text(following).upper() == "OFFSETS":
            return self._cells_by_offsets(count, size)
        words = self.cursor.take(size, 1, "corners").reshape(-1)
        if size == 4 * count and not np.any(self.text.integers(words[::4]) != 3):
            return words.reshape(-1, 4)[:, 1:].reshape(-1), 3 * np.arange(1, count + 1)
        return self._cells_by_sizes(count, words)

    def _cells_by_offsets(self, count: int, size: int) -> Cells:
        """`OFFSETS type`, where cells begin, and `CONNECTIVITY type`, all corners."""
        self.cursor.expect("OFFSETS")
        self.cursor.word("the type of the offsets")
        words = self.cursor.take(count, 1, "offsets").reshape(-1)
        offsets = self.text.integers(words)
        self.cursor.expect("CONNECTIVITY")
        self.cursor.word("the type of the corners")
        corners = self.cursor.take(size, 1, "corners").reshape(-1)
        if count and offsets[0] != 0:
            raise self.text.refuse("syntax", "the first offset is not 0", int(words[0]))
        return corners, offsets[1:]

    def _cells_by_sizes(self, count: int, words: Chosen) -> Cells:
        """The number of corners and the corners, cell after cell."""
        numbers = self.text.integers(words).tolist()
        kept, at = np.ones(len(words), dtype=bool), 0
        ends: list[int] = []
        for _ in range(count):
            if at >= len(numbers) or numbers[at] < 0 or at + numbers[at] >= len(numbers):
                message = "the list of cells ends before the last of them"
                raise self.text.refuse("syntax", message, int(words[-1]) if len(words) else 0)
            kept[at] = False
            at += numbers[at] + 1
            ends.append(at - len(ends) - 1)
        if at != len(numbers):
            message = "the list of cells goes on after the last of them"
            raise self.text.refuse("syntax", message, int(words[at]))
        return words[kept], np.array(ends, dtype=np.int64)

    def _pass_field(self) -> None:
        """`FIELD name n`, and n arrays of numbers."""
        self.cursor.word("the field's name")
        for _ in range(self.cursor.whole("the number of arrays")):
            self.cursor.word("an array's name")
            width = self.cursor.whole("the number of components")
            count = self.cursor.whole("the number of tuples")
            if self.cursor.word("the type of an array").lower() == "string":
                message = "fields of strings are not read"
                raise self.text.refuse("unsupported", message, self.cursor.at - 1)
            self.cursor.take(min(width, len(self.text) + 1) * count, 1, "numbers of a field")

    def _pass_metadata(self) -> None:
        """Up to a blank line."""
        begin = int(self.text.starts[self.cursor.at - 1])
        blank = _BLANK_LINE.search(self.text.data, begin)
        end = len(self.text.data) if blank is None else blank.start()
        self.cursor.at = int(np.searchsorted(self.text.starts, end))

    def _of_cells(self) -> Indices:
        """The triangles of `CELLS`."""
        if self.cells is None:
            return np.empty((0, 3), dtype=np.int64)
        if self.kinds is None:
            raise self.text.refuse("syntax", "the file has no CELL_TYPES", len(self.text))
        corners, ends = self.cells
        kinds = self.text.integers(self.kinds)
        return vtk_cells.triangles(self.text, corners, ends, kinds, self.kinds)

    def _of_polygons(self) -> Indices:
        """The triangles of `POLYGONS`."""
        if self.polygons is None:
            return np.empty((0, 3), dtype=np.int64)
        corners, ends = self.polygons
        kinds = np.full(len(ends), vtk_cells.POLYGON)
        return vtk_cells.triangles(self.text, corners, ends, kinds, None)


def dumps_mesh(mesh: Mesh) -> tuple[str, int]:
    """A mesh as a legacy VTK file in ASCII, and the number of coordinates that were rounded.

    Raises
    ------
    InputError
        Kind `number`: a coordinate is beyond all doubles.
    """
    rounding = Rounding()
    count = len(mesh.triangles)
    lines = ["# vtk DataFile Version 3.0", "bern_exact", "ASCII", "DATASET UNSTRUCTURED_GRID"]
    lines.append(f"POINTS {len(mesh.vertices)} double")
    lines += [f"{x} {y} 0" for x, y in rounding.pairs(mesh.vertices)]
    lines.append(f"CELLS {count} {4 * count}")
    lines += [f"3 {a} {b} {c}" for a, b, c in mesh.triangles]
    lines.append(f"CELL_TYPES {count}")
    lines += [str(vtk_cells.TRIANGLE)] * count
    return "\n".join(lines) + "\n", rounding.rounded
