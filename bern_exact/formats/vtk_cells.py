"""Cells as VTK has them, in its legacy files and in its XML files: the triangles among them."""

from __future__ import annotations

import numpy as np

from bern_exact.formats.token_text import Chosen, TokenText
from bern_exact.plane.array_mesh import Indices

TRIANGLE, POLYGON = 5, 7
PASSED_OVER = frozenset((1, 2, 3, 4, 21, 35, 68))
"""Types of vertices and of lines."""

_NAMES = {
    6: "triangle strips",
    8: "pixels",
    9: "quads",
    10: "tetrahedra",
    12: "hexahedra",
    22: "triangles of 6 nodes",
    69: "Lagrange triangles",
}


def triangles(
    text: TokenText, corners: Chosen, ends: Indices, kinds: Indices, kind_words: Chosen | None
) -> Indices:
    """The corners of the triangles among cells.

    Parameters
    ----------
    text : TokenText
        The text that holds the corners.
    corners : array of int64
        The words that are the corners of all cells, one cell after the other.
    ends : array
        For each cell where its corners end among these.
    kinds : array
        For each cell its type.
    kind_words : array of int64, optional
        The words that say so, for messages; without them the cell's number is told.

    Raises
    ------
    InputError
        Kind `unsupported`: cells other than triangles, lines and points; `syntax`: ends that are
        none, a triangle without three corners.
    """
    place = int(corners[0]) if len(corners) else 0
    if len(kinds) != len(ends):
        message = f"{len(ends):,} cells have {len(kinds):,} types"
        raise text.refuse("syntax", message, place)
    if len(ends) == 0:
        return np.empty((0, 3), dtype=np.int64)
    begins = np.concatenate(([0], ends[:-1]))
    sizes = ends - begins
    if (sizes < 0).any() or ends[-1] != len(corners):
        raise text.refuse("syntax", "the cells' offsets are not those of their corners", place)
    ignored = np.isin(kinds, list(PASSED_OVER))
    bad = np.flatnonzero(~(ignored | (kinds == TRIANGLE) | ((kinds == POLYGON) & (sizes == 3))))
    if len(bad):
        cell, kind = int(bad[0]), int(kinds[bad[0]])
        what = _NAMES.get(kind, f"cells of type {kind}")
        if kind == POLYGON:
            what = f"polygons of {sizes[cell]} corners"
        message = f"only triangles are read, not {what} (cell {cell})"
        word = place if kind_words is None else int(kind_words[cell])
        raise text.refuse("unsupported", message, word)
    wrong = np.flatnonzero(~ignored & (sizes != 3))
    if len(wrong):
        message = f"cell {wrong[0]} is a triangle of {sizes[wrong[0]]} corners"
        raise text.refuse("syntax", message, place)
    first = begins[~ignored].astype(np.int64)
    return text.integers(corners[first[:, None] + np.arange(3)])
