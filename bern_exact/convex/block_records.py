"""The records of Section 5.1: cells merged into blocks, and blocks with lines removed.

A *block* is a rectangle of cells.  Its *columns* and *rows* lie between neighbouring lines;
everything here is lists of lines, never the cells themselves.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain
from typing import NamedTuple

from bern_exact.convex.cells import Cells, GridPoint

Triangle = tuple[GridPoint, GridPoint, GridPoint]
"""Counter-clockwise."""


class Block(NamedTuple):
    """A rectangle of cells, [x0, x1] x [y0, y1] in indices of lines.

    Parameters
    ----------
    x0, x1 : int
        The verticals on its sides.
    y0, y1 : int
        The horizontals on its sides.
    """

    x0: int
    x1: int
    y0: int
    y1: int


@dataclass(frozen=True)
class Blocks:
    """Q as a set of matching blocks (Lemma 6).

    Parameters
    ----------
    cells : Cells
        Q.
    blocks : tuple of Block
        By (x0, y0).
    """

    cells: Cells
    blocks: tuple[Block, ...]


LEAF, SPLIT, OUTER = 0, 1, 2
"""The levels of a node: not divided; Figure 11(a); an outer part divided again, Figure 11(b)."""


class Node(NamedTuple):
    """A rectangle of the recursion behind Lemma 12, with all lines but those removed before.

    Parameters
    ----------
    level : int
        `LEAF`, `SPLIT` or `OUTER`.
    turned : bool
        Whether the strips are rows (then the lines are verticals) rather than columns.
    strips : tuple of int
        The lines between which the strips lie, sides of the rectangle included.
    lines : tuple of int
        The lines across the strips, sides of the rectangle included.
    first, last : int
        The strips l and r, between which lines are removed, as positions; -1 in a leaf.
    removed : tuple of int
        The lines removed between them.
    parts : (int, int, int)
        The nodes before strip l, between l and r, and after r; -1 where there is none.
    triangles : int
        How many triangles it is divided into in all.
    """

    level: int
    turned: bool
    strips: tuple[int, ...]
    lines: tuple[int, ...]
    first: int
    last: int
    removed: tuple[int, ...]
    parts: tuple[int, int, int]
    triangles: int

    @property
    def size(self) -> tuple[int, int]:
        """How many strips it has, and how many rectangles each strip."""
        return len(self.strips) - 1, len(self.lines) - 1

    @property
    def columns(self) -> tuple[int, ...]:
        """Its verticals."""
        return self.lines if self.turned else self.strips

    @property
    def rows(self) -> tuple[int, ...]:
        """Its horizontals."""
        return self.strips if self.turned else self.lines

    def halved(self) -> Iterator[tuple[int, int, int, int, bool]]:
        """Every use of Lemma 10: (strip, line below, line removed, line above, on the far side).

        The strip is a position; the subdivision lies on its near or its far side.
        """
        removed = set(self.removed)
        for i in range(1, len(self.lines) - 1):
            if self.lines[i] in removed:
                three = self.lines[i - 1], self.lines[i], self.lines[i + 1]
                yield (self.first, *three, False)
                yield (self.last, *three, True)


class ReducedBlock(NamedTuple):
    """A block, triangulated with few lines inside (Lemma 12).

    Parameters
    ----------
    block : Block
        The block.
    nodes : tuple of Node
        The recursion, each node after its parts: the last is the block itself.
    triangles : tuple of Triangle
        What it is divided into; no point but the crossings of its lines, and on its sides all.
    """

    block: Block
    nodes: tuple[Node, ...]
    triangles: tuple[Triangle, ...]


@dataclass(frozen=True)
class Reduced:
    """All of Q, triangulated (Section 5.1).

    Parameters
    ----------
    merged : Blocks
        The stage before.
    blocks : tuple of ReducedBlock
        In the order of `merged.blocks`.
    """

    merged: Blocks
    blocks: tuple[ReducedBlock, ...]

    @property
    def triangles(self) -> tuple[Triangle, ...]:
        """All triangles, block by block."""
        return tuple(chain.from_iterable(block.triangles for block in self.blocks))

    @property
    def number(self) -> int:
        """How many triangles there are."""
        return sum(len(block.triangles) for block in self.blocks)
