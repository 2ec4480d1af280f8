"""The records of Lemmas 6, 7 and 8: partitions of Q into subdivided rectangles.

Definition 2's *lattice* is what all of them are cut along: the lines from the
vertices of Q through its interior, each of which, by the matching condition,
runs from a vertex to a vertex.  A *cell* lies between neighbouring lines; there
can be Theta(N^2) of them and nothing here enumerates them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from bern_exact.interior.records import GridNode, Rectilinear

Edge = tuple[GridNode, GridNode]
"""An edge of the lattice, between neighbouring points."""

HalfNode = tuple[int, int]
"""A point in half grid units: (2 x, 2 y)."""


class SubdividedRectangle(NamedTuple):
    """A rectangle with additional vertices on its sides (Section 3.1), in grid units.

    Parameters
    ----------
    x0, x1, y0, y1 : int
        [x0, x1] x [y0, y1].
    left, right : tuple of int
        The ordinates of the vertices strictly inside its vertical sides, increasing.
    bottom, top : tuple of int
        The abscissas of the vertices strictly inside its horizontal sides, increasing.
    """

    x0: int
    x1: int
    y0: int
    y1: int
    left: tuple[int, ...]
    right: tuple[int, ...]
    bottom: tuple[int, ...]
    top: tuple[int, ...]

    def ring(self) -> list[GridNode]:
        """All its vertices, counter-clockwise from the lower left corner.

        >>> SubdividedRectangle(0, 4, 0, 1, (), (), (1,), (1,)).ring()
        [(0, 0), (1, 0), (4, 0), (4, 1), (1, 1), (0, 1)]
        """
        x0, x1, y0, y1 = self[:4]
        ring = [(x, y0) for x in (x0, *self.bottom)]
        ring += [(x1, y) for y in (y0, *self.right)]
        ring += [(x, y1) for x in (x1, *reversed(self.top))]
        ring += [(x0, y) for y in (y1, *reversed(self.left))]
        return ring


@dataclass(frozen=True)
class Partition:
    """Q as a set of matching subdivided rectangles.

    Parameters
    ----------
    region : Rectilinear
        Q.
    rectangles : tuple of SubdividedRectangle
        By (x0, y0).
    steps : tuple of int
        For each rectangle the half-step of Lemma 6 in which it was cut off, from 1: what is
        left after k half-steps is the union of those with a step above k.  0 with Lemma 8.
    bridges : tuple of Edge
        Where Q was slit to join its holes to the boundary before Lemma 6.
    """

    region: Rectilinear
    rectangles: tuple[SubdividedRectangle, ...]
    steps: tuple[int, ...]
    bridges: tuple[Edge, ...] = ()


class Tiling(NamedTuple):
    """A subdivided rectangle, triangulated (Lemma 7).

    Parameters
    ----------
    rectangle : SubdividedRectangle
        The rectangle.
    steiner : tuple of HalfNode
        The points added strictly inside it, in half units.
    triangles : tuple of (HalfNode, HalfNode, HalfNode)
        Counter-clockwise, in half units.
    """

    rectangle: SubdividedRectangle
    steiner: tuple[HalfNode, ...]
    triangles: tuple[tuple[HalfNode, HalfNode, HalfNode], ...]


@dataclass(frozen=True)
class Tiled:
    """The interior, every rectangle of a partition triangulated.

    Parameters
    ----------
    partition : Partition
        The stage before.
    tilings : tuple of Tiling
        One a rectangle, in the order of `partition.rectangles`.
    """

    partition: Partition
    tilings: tuple[Tiling, ...]
