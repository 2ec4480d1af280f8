"""The block of a vertex, and the grid that makes blocks disjoint (Section 2).

The paper's block is the square of the vertex with its neighbours, 3 x 3 squares.  Four squares
round the grid corner nearest to the vertex will do as well: fewer lines, and a coarser grid.
That is experimental, since the paper does not treat it.
"""

from __future__ import annotations

from typing import NamedTuple

from gmpy2 import f_div, mpq

from bern_exact.boundary.records import BlockShape, Framed, GridNode
from bern_exact.exact.points import HPoint

FACTOR = mpq(8)
"""s' is at least this many grid units: the paper's choice, for its own blocks."""


class Grid(NamedTuple):
    """What is free to be chosen about blocks.

    Parameters
    ----------
    blocks : {"square", "corner"}
        Their shape.
    factor : mpq
        s' in grid units, at least.
    """

    blocks: BlockShape = "square"
    factor: mpq = FACTOR


class Block(NamedTuple):
    """The grid squares between two corners.

    Parameters
    ----------
    low, high : (int, int)
        The lower left and the upper right corner.
    """

    low: GridNode
    high: GridNode

    def has(self, node: GridNode) -> bool:
        """Is this grid vertex in the block or on its rim?

        >>> Block((0, 0), (2, 2)).has((2, 1)), Block((0, 0), (2, 2)).has((3, 1))
        (True, False)
        """
        return all(a <= x <= b for a, x, b in zip(self.low, node, self.high, strict=True))


def square_of(p: HPoint) -> GridNode:
    """The lower left corner of the grid square of a point."""
    return int(f_div(p[0], p[2])), int(f_div(p[1], p[2]))


def corner_near(p: HPoint) -> GridNode:
    """The grid vertex nearest to a point, of equally near ones the lexicographically first.

    >>> corner_near((3, 7, 5)), corner_near((1, 3, 2))
    ((1, 1), (0, 1))
    """
    x, y = (-int(f_div(p[2] - 2 * part, 2 * p[2])) for part in p[:2])
    return x, y


def block_of(p: HPoint, shape: BlockShape) -> Block:
    """The block of a vertex at a point.

    Parameters
    ----------
    p : HPoint
        In grid coordinates, on no grid line.
    shape : {"square", "corner"}
        Of blocks.

    >>> block_of((3, 7, 5), "square"), block_of((3, 7, 5), "corner")
    (Block(low=(-1, 0), high=(2, 3)), Block(low=(0, 0), high=(2, 2)))
    """
    if shape == "square":
        x, y = square_of(p)
        return Block((x - 1, y - 1), (x + 2, y + 2))
    x, y = corner_near(p)
    return Block((x - 1, y - 1), (x + 1, y + 1))


def block_at(framed: Framed, v: int) -> Block:
    """The block of vertex v of P'."""
    return block_of(framed.polygon.points[v], framed.blocks)
