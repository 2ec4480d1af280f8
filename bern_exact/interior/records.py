"""The records of the interior stages, in grid coordinates (integers)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

GridNode = tuple[int, int]


@dataclass(frozen=True)
class Rectilinear:
    """Q of Definition 2: what is left of P' when the touched faces are taken away.

    Parameters
    ----------
    loops : tuple of tuple of GridNode
        Each boundary loop as its successive vertices (180-degree ones included), interior
        on the left.  Several components and vertices that occur more than once (touching)
        are the rule.
    """

    loops: tuple[tuple[GridNode, ...], ...]

    @property
    def edges(self) -> int:
        """N, the number of boundary edges."""
        return sum(len(loop) for loop in self.loops)


class Column(NamedTuple):
    """A maximal stack of cells between two neighbouring vertical lines.

    Parameters
    ----------
    x0, x1 : int
        The neighbouring vertical lines that bound it.
    y0, y1 : int
        Its lower and upper side.
    """

    x0: int
    x1: int
    y0: int
    y1: int


class SweptColumn(NamedTuple):
    """A column with the final vertices on its two vertical sides.

    Parameters
    ----------
    column : Column
        The column.
    left, right : tuple of int
        All y-coordinates of mesh vertices on the sides, corners included, increasing.
    triangles : tuple of (GridNode, GridNode, GridNode)
        Counter-clockwise.
    """

    column: Column
    left: tuple[int, ...]
    right: tuple[int, ...]
    triangles: tuple[tuple[GridNode, GridNode, GridNode], ...]


@dataclass(frozen=True)
class Swept:
    """The interior after the two sweeps of Lemma 3.

    Parameters
    ----------
    region : Rectilinear
        Q.
    columns : tuple of SweptColumn
        By (x0, y0).
    added : frozenset of GridNode
        The Steiner points that the sweeps added, all interior to Q.
    """

    region: Rectilinear
    columns: tuple[SweptColumn, ...]
    added: frozenset[GridNode]
