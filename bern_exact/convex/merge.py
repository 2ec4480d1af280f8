"""Cells merged into large blocks (Section 5.1, by Lemma 6)."""

from __future__ import annotations

from collections.abc import Iterator

from bern_exact.convex.block_records import Block, Blocks
from bern_exact.convex.cells import Cells
from bern_exact.interior.records import GridNode, Rectilinear
from bern_exact.interior.subdivided.halving import halving


def merge(cells: Cells) -> Blocks:
    """Q as a set of large matching blocks.

    Section 5.1: "The boundary of the union of rectangles interior to P is a simple polygon Q
    satisfying the matching condition [...] Lemma 6 states that Q can be partitioned into a set of
    'large' matching subdivided rectangles".

    Parameters
    ----------
    cells : Cells
        Q; columns without a cell, and parts that touch in a point, are allowed.

    Returns
    -------
    Blocks
        Each cell in one block.

    Notes
    -----
    Lemma 6 in index space, where each cell is a unit square: O(V log V) for V vertices.

    >>> from gmpy2 import mpq
    >>> lines = tuple(mpq(i) for i in range(4))
    >>> merge(Cells(lines, lines, (0, 0, 0), (1, 2, 2))).blocks
    (Block(x0=0, x1=1, y0=0, y1=1), Block(x0=1, x1=3, y0=0, y1=2))
    """
    rectangles = halving(outline(cells)).rectangles
    return Blocks(cells, tuple(Block(*rectangle[:4]) for rectangle in rectangles))


def outline(cells: Cells) -> Rectilinear:
    """The boundary of Q in index space, with a vertex at each end of a line.

    Columns that share no more than a point belong to different loops.
    """
    loops = []
    first = 0
    for j in range(len(cells.low)):
        if not _joined(cells, j):
            if cells.low[j] < cells.high[j]:
                loops.append(tuple(_loop(cells, first, j)))
            first = j + 1
    return Rectilinear(tuple(loops))


def _joined(cells: Cells, j: int) -> bool:
    """Does column j share an edge with the next?"""
    if j + 1 == len(cells.low):
        return False
    return max(cells.low[j : j + 2]) < min(cells.high[j : j + 2])


def _loop(cells: Cells, first: int, last: int) -> Iterator[GridNode]:
    """Counter-clockwise round the columns `first` to `last`, at unit steps."""
    yield from _staircase(cells.low[first : last + 1], first, 1)
    yield from _side(last + 1, cells.low[last], cells.high[last])
    yield from _staircase(cells.high[first : last + 1][::-1], last + 1, -1)
    yield from _side(first, cells.high[first], cells.low[first])


def _staircase(heights: tuple[int, ...], x: int, step: int) -> Iterator[GridNode]:
    """Along the ends of columns, from x on to the right or to the left, without the last vertex."""
    for i, height in enumerate(heights):
        yield x, height
        x += step
        if i + 1 < len(heights) and heights[i + 1] != height:
            yield from _side(x, height, heights[i + 1])


def _side(x: int, start: int, stop: int) -> Iterator[GridNode]:
    """Along a vertical, without the last vertex."""
    step = 1 if stop > start else -1
    for y in range(start, stop, step):
        yield x, y
