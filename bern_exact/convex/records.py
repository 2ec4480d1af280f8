"""The records of Section 5: the frame, the bounced verticals, the triangles along the boundary.

Everything is in the frame where the polygon's diameter AB is from (0, 0) to (1, 0).  The boundary
is then two *chains* from A to B, the upper and the lower, each told by its distance from AB.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from gmpy2 import mpq

from bern_exact.convex.cells import Cells, GridPoint
from bern_exact.exact.similarity import Similarity
from bern_exact.plane.polygon import Polygon

UPPER, LOWER = 0, 1
"""The sides of AB."""

Position = tuple[mpq, mpq]
"""A point in the frame."""

Corner = GridPoint | int
"""A crossing of lines, or the number of a foot of an altitude."""

RightTriangle = tuple[Corner, Corner, Corner]
"""Counter-clockwise."""


@dataclass(frozen=True)
class Chain:
    """One side of the boundary, from A to B.

    Parameters
    ----------
    xs : tuple of mpq
        Its vertices' x, strictly increasing from 0 to 1.
    hs : tuple of mpq
        Their distances from AB, not negative; 0 at both ends, all 0 if AB is an edge; concave.
    """

    xs: tuple[mpq, ...]
    hs: tuple[mpq, ...]

    @cached_property
    def flat(self) -> tuple[mpq, mpq]:
        """The interval on which it is farthest from AB; often a point."""
        most = max(self.hs)
        far = [x for x, h in zip(self.xs, self.hs, strict=True) if h == most]
        return far[0], far[-1]

    @property
    def is_edge(self) -> bool:
        """Is it AB itself?"""
        return not any(self.hs)


@dataclass(frozen=True)
class ConvexFrame:
    """P with its diameter from (0, 0) to (1, 0) (Section 5).

    Parameters
    ----------
    polygon : Polygon
        P, in the input's coordinates.
    a, b : int
        The ends of the diameter AB, vertices of P; A comes first lexicographically.
    similarity : Similarity
        From the input's coordinates into the frame.
    places : tuple of (mpq, mpq)
        Each vertex of P in the frame.
    chains : (Chain, Chain)
        The upper and the lower side.
    """

    polygon: Polygon
    a: int
    b: int
    similarity: Similarity
    places: tuple[Position, ...]
    chains: tuple[Chain, Chain]

    @property
    def one_sided(self) -> bool:
        """Is the diameter an edge, or several in a line?"""
        return any(chain.is_edge for chain in self.chains)


class Pending(NamedTuple):
    """A subdivision point of a triangle along the boundary: a path that has not gone on.

    A horizontal comes from the other end of its chord and ends on the last vertical before the
    boundary, at the height that the boundary has at x.

    Parameters
    ----------
    x : mpq
        Where the horizontal would reach the boundary.
    side : int
        `UPPER` or `LOWER`.
    """

    x: mpq
    side: int


class HalfStep(NamedTuple):
    """A pending subdivision bounced: its horizontal reaches the boundary, and a vertical starts.

    Parameters
    ----------
    x, side : mpq, int
        The pending subdivision.  The new vertical is at x.
    left : Pending or None
        The subdivision that the horizontal from the other end of the vertical makes, if any.
    stays : mpq or None
        The x of the pending subdivision that the vertical leaves behind alone in its triangle;
        None in the middle.
    """

    x: mpq
    side: int
    left: Pending | None
    stays: mpq | None


class ClosedPath(NamedTuple):
    """A path that ends where it starts: a rectangle inscribed in P.

    Parameters
    ----------
    x : mpq
        Its vertical between the highest and lowest vertices, and B.
    partner : mpq
        Its vertical on A's side.
    """

    x: mpq
    partner: mpq


@dataclass(frozen=True)
class Bounced:
    """The verticals after bouncing: no triangle along the boundary has two subdivisions.

    Parameters
    ----------
    frame : ConvexFrame
        P.
    verticals : tuple of mpq
        All of them, increasing.
    first : tuple of Pending
        The subdivisions before bouncing, by side and x.
    events : tuple of HalfStep or ClosedPath
        What was done, in order.
    """

    frame: ConvexFrame
    verticals: tuple[mpq, ...]
    first: tuple[Pending, ...]
    events: tuple[HalfStep | ClosedPath, ...]

    @property
    def steps(self) -> tuple[HalfStep, ...]:
        """The half-steps, in order."""
        return tuple(event for event in self.events if isinstance(event, HalfStep))

    @property
    def closed(self) -> tuple[ClosedPath, ...]:
        """The closed paths that were added, in order."""
        return tuple(event for event in self.events if isinstance(event, ClosedPath))

    @property
    def bits(self) -> int:
        """The most bits of a numerator or denominator of a vertical."""
        return max(
            max(x.numerator.bit_length(), x.denominator.bit_length()) for x in self.verticals
        )


class Leg(NamedTuple):
    """A right triangle along the boundary, and the right triangles that it is cut into (Lemma 9).

    Parameters
    ----------
    column : int
        Between verticals `column` and `column` + 1.
    side : int
        `UPPER` or `LOWER`.
    low : GridPoint
        Its corner on the boundary that is nearer to AB.
    right : GridPoint
        Its right angle.
    high : GridPoint
        Its corner on the boundary farther from AB.
    subdivision : GridPoint or None
        The point on its vertical leg, if there is one.
    triangles : tuple of RightTriangle
        One, or three.
    """

    column: int
    side: int
    low: GridPoint
    right: GridPoint
    high: GridPoint
    subdivision: GridPoint | None
    triangles: tuple[RightTriangle, ...]


@dataclass(frozen=True)
class Gridded:
    """P as cells and right triangles along the boundary.

    Parameters
    ----------
    bounced : Bounced
        The stage before.
    cells : Cells
        The rectangles.
    legs : tuple of Leg
        The triangles along the boundary, by column, the upper one first.
    feet : tuple of Position
        The feet of Lemma 9's altitudes, on the boundary.
    """

    bounced: Bounced
    cells: Cells
    legs: tuple[Leg, ...]
    feet: tuple[Position, ...]

    def position(self, corner: Corner) -> Position:
        """Where a corner is."""
        if isinstance(corner, tuple):
            return self.cells.xs[corner[0]], self.cells.ys[corner[1]]
        return self.feet[corner]
