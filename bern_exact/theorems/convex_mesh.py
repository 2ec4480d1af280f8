"""Theorem 4's mesh in the input's coordinates: cells, right triangles, all undone exactly."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from gmpy2 import mpq

from bern_exact.convex.cells import Cells, GridPoint
from bern_exact.convex.records import Bounced, Corner, Gridded, RightTriangle
from bern_exact.exact.points import HPoint, hpoint, reduced
from bern_exact.exact.similarity import Similarity
from bern_exact.interior.sweep import TooManyTriangles
from bern_exact.plane.mesh import Mesh
from bern_exact.theorems.assemble import CELL, RIM, Assembled

MOST_TRIANGLES = 4_000_000
"""Triangles of cells that the baseline may have; more are refused."""

CellTriangle = tuple[GridPoint, GridPoint, GridPoint]


def split_cells(cells: Cells) -> Iterator[CellTriangle]:
    """Every cell split by a diagonal: the O(n^2) algorithm.

    Raises
    ------
    TooManyTriangles
        If there would be more than `MOST_TRIANGLES`.
    """
    if 2 * cells.number > MOST_TRIANGLES:
        raise TooManyTriangles(
            f"the whole grid has {2 * cells.number:,} triangles, more than {MOST_TRIANGLES:,}"
        )
    return (
        triangle
        for j, (low, high) in enumerate(zip(cells.low, cells.high, strict=True))
        for i in range(low, high)
        for triangle in (
            ((j, i), (j + 1, i), (j + 1, i + 1)),
            ((j, i), (j + 1, i + 1), (j, i + 1)),
        )
    )


def assemble_convex(gridded: Gridded, inside: Iterable[CellTriangle]) -> Assembled:
    """Put the triangles of the cells and those along the boundary together.

    Parameters
    ----------
    gridded : Gridded
        The grid and its right triangles along the boundary.
    inside : iterable of triangles
        What the cells are divided into; corners are crossings of lines.

    Notes
    -----
    Vertices: those of P in input order, the crossings in use by column, the feet of altitudes.
    O(m log m) for m triangles.
    """
    cells = gridded.cells
    rim = [triangle for leg in gridded.legs for triangle in leg.triangles]
    corners: list[RightTriangle] = [*inside, *rim]
    number: dict[Corner, int] = dict(_corners_of_polygon(gridded.bounced, cells))
    fresh = {corner for triangle in corners for corner in triangle} - number.keys()
    crossings = sorted(corner for corner in fresh if isinstance(corner, tuple))
    feet = range(len(gridded.feet))
    new: list[Corner] = [*crossings, *feet]
    frame = gridded.bounced.frame
    number.update((corner, v) for v, corner in enumerate(new, frame.polygon.n))
    back = frame.similarity.inverse()
    vertices = [
        *frame.polygon.points,
        *_places(crossings, cells, back),
        *(back.apply(hpoint(*foot)) for foot in gridded.feet),
    ]
    triangles = tuple((number[a], number[b], number[c]) for a, b, c in corners)
    classes = (CELL,) * (len(corners) - len(rim)) + (RIM,) * len(rim)
    return Assembled(Mesh(tuple(vertices), triangles), classes)


def _corners_of_polygon(bounced: Bounced, cells: Cells) -> Iterator[tuple[GridPoint, int]]:
    """The crossing at which each vertex of P lies."""
    column = {x: j for j, x in enumerate(cells.xs)}
    row = {y: i for i, y in enumerate(cells.ys)}
    for v, (x, y) in enumerate(bounced.frame.places):
        yield (column[x], row[y]), v


def _places(crossings: Iterable[GridPoint], cells: Cells, back: Similarity) -> Iterator[HPoint]:
    """Crossings in the input's coordinates.

    The point (x, y) comes from (alpha x + tau) + i alpha y: a part for its vertical, and one for
    its horizontal, each made once.
    """
    zero = mpq(0)
    turn = Similarity(back.a, back.b, back.u * 0, back.v * 0, back.d)
    columns: Sequence[HPoint] = [back.apply(hpoint(x, zero)) for x in cells.xs]
    rows: Sequence[HPoint] = [turn.apply(hpoint(zero, y)) for y in cells.ys]
    for j, i in crossings:
        px, py, pw = columns[j]
        qx, qy, qw = rows[i]
        yield reduced(px * qw + qx * pw, py * qw + qy * pw, pw * qw)
