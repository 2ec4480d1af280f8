"""The records that the boundary stages hand on: lopped, framed, diced, traced, warped, meshed.

Each stage is a function from one of these to the next.  Checkers read them
and nothing else.  Coordinates after `Framed` are *grid coordinates*: the
grid unit b is 1 and the grid lines are the integers.

Nodes
-----
A `Node` of the arrangement is an int or a pair of ints:

- `0 <= i < n'`: vertex i of P' (`framed.polygon`);
- `n' + j`: the q-vertex `diced.crossings[j]`;
- `(k, l)`: the grid vertex where the lines x = k and y = l cross.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple

from gmpy2 import mpq

from bern_exact.exact.points import HPoint, grid_point
from bern_exact.exact.similarity import Similarity
from bern_exact.plane.feature_size import FeatureSize
from bern_exact.plane.polygon import Polygon

BlockShape = Literal["square", "corner"]
"""3 x 3 squares round that of a vertex, or the 2 x 2 round the grid vertex nearest to it."""

GridNode = tuple[int, int]
Node = int | GridNode

VERTICAL = 0
"""The axis of the lines x = k."""
HORIZONTAL = 1
"""The axis of the lines y = l."""


class Cut(NamedTuple):
    """A lopped corner: the triangle (corner, after, before) of P is cut off.

    Parameters
    ----------
    corner : int
        The acute vertex v of P.
    nearest : int
        Its nearest visible vertex w of P.
    before, after : int
        Vertices of P' on P's edges into and out of the corner, both at about |vw|/3
        from it.  P' has the edge before -> after.
    """

    corner: int
    nearest: int
    before: int
    after: int


@dataclass(frozen=True)
class Lopped:
    """P and P', in the input's coordinates.

    Parameters
    ----------
    polygon : Polygon
        P.
    lopped : Polygon
        P'.
    origin : tuple of int
        For each vertex of P' the vertex of P that it is, or -1 for an end of a cut.
    cuts : tuple of Cut
        By increasing corner.
    """

    polygon: Polygon
    lopped: Polygon
    origin: tuple[int, ...]
    cuts: tuple[Cut, ...]


@dataclass(frozen=True)
class Framed:
    """P' in general position over the unit grid.

    Parameters
    ----------
    lopped : Lopped
        The stage before.
    feature : FeatureSize
        Definition 1 for P', in the input's units: s' squared and where.
    unit : mpq
        The grid unit b in the input's units: `factor * b <= s'`.
    factor : mpq
        What s' must be at least, in grid units (8 if nothing else was asked for).
    similarity : Similarity
        From the input's coordinates to grid coordinates; its scale is 1/b.
    polygon : Polygon
        P' in grid coordinates, same vertices and rings as `lopped.lopped`.
    blocks : {"square", "corner"}
        The shape of blocks.
    """

    lopped: Lopped
    feature: FeatureSize
    unit: mpq
    factor: mpq
    similarity: Similarity
    polygon: Polygon
    blocks: BlockShape = "square"


class Interval(NamedTuple):
    """A kept interval: the part of a grid line between two boundary edges, inside P'.

    Parameters
    ----------
    line : int
        k for the line x = k, l for y = l.
    low, high : int
        The edges of P' at its lower (left) and upper (right) end.
    """

    line: int
    low: int
    high: int


class Crossing(NamedTuple):
    """A q-vertex before warping: where a kept interval ends on the boundary.

    Parameters
    ----------
    axis : int
        VERTICAL or HORIZONTAL: the direction of its grid line.
    line : int
        The grid line's number.
    edge : int
        The edge of P'.
    at : mpq
        The other coordinate (y on a vertical line, x on a horizontal one); never an integer.
    far : int
        The edge at the other end of the interval.
    """

    axis: int
    line: int
    edge: int
    at: mpq
    far: int


@dataclass(frozen=True)
class Diced:
    """The kept intervals and their ends.

    Parameters
    ----------
    framed : Framed
        The stage before.
    vertical, horizontal : tuple of Interval
        Sorted by (line, low end's coordinate).
    crossings : tuple of Crossing
        All ends; crossing j is the node n' + j.
    on_edge : tuple of tuple of int
        For each edge of P' the indices of its crossings from tail to head.
    xs, ys : tuple of int
        The vertical and horizontal lines in use, sorted: the lines of all blocks ("the ones
        that support occupied and neighbor squares"), whether or not a piece of them is kept.
    """

    framed: Framed
    vertical: tuple[Interval, ...]
    horizontal: tuple[Interval, ...]
    crossings: tuple[Crossing, ...]
    on_edge: tuple[tuple[int, ...], ...]
    xs: tuple[int, ...]
    ys: tuple[int, ...]

    @cached_property
    def crossing_at(self) -> Mapping[tuple[int, int, int], int]:
        """(axis, line, edge) -> index of that crossing."""
        return {(q.axis, q.line, q.edge): j for j, q in enumerate(self.crossings)}


class Face(NamedTuple):
    """A face of the arrangement before warping.

    Parameters
    ----------
    ring : tuple of Node
        Counter-clockwise.
    block : int
        The vertex of P' whose block this face belongs to, or -1.
    """

    ring: tuple[Node, ...]
    block: int


@dataclass(frozen=True)
class Traced:
    """The faces with a piece of the boundary, in the arrangement before warping.

    Parameters
    ----------
    diced : Diced
        The stage before.
    faces : tuple of Face
        Every face that has an edge on the boundary of P'.
    inner : tuple of Node or None
        For each crossing its inner grid neighbour g: the first crossing inwards on its
        interval, or None if the interval has none.
    anchors : tuple of GridNode
        For each crossing its exterior anchor: the next crossing, beyond it on its line,
        with a perpendicular line in use.
    """

    diced: Diced
    faces: tuple[Face, ...]
    inner: tuple[GridNode | None, ...]
    anchors: tuple[GridNode, ...]


@dataclass(frozen=True)
class Warped:
    """Where every node goes.

    Parameters
    ----------
    traced : Traced
        The stage before.
    corners : tuple of GridNode
        For each vertex of P' the corner of its square that moves to it (substep 1).
    rank : tuple of int
        For each vertex, how often a corner was refused (0: the closest was taken). Of square
        blocks, 4 to 7: all four were, and one is taken for 135 degrees alone, for which `rank`
        - 4 closer ones were refused again; 8: the closest was taken all the same. Of corner
        blocks, 1: the closest was taken without 135 degrees; 2: it was taken all the same.
    moved : mapping GridNode -> Node
        Interior grid vertices that move, each with the P' vertex (substep 1) or the
        crossing (substep 2, before fates) that it moves to.
    instances : mapping (edge, k, l) -> Node
        Exterior instances that move, likewise.
    choices : mapping crossing index -> GridNode or (edge, k, l)
        What each crossing that chose in substep 2 chose.
    image : tuple of Node
        For each crossing the node that it ends as: itself, another crossing, or a vertex of P'.
    points : tuple of HPoint
        For each crossing its final position, in grid coordinates (that of its image).
    refused : mapping vertex -> tuple of rings
        For each vertex of P' whose closest corner was refused: what the faces of its block
        would have been with that corner, as the paper has it (for showing the erratum).
    """

    traced: Traced
    corners: tuple[GridNode, ...]
    rank: tuple[int, ...]
    moved: Mapping[GridNode, Node]
    instances: Mapping[tuple[int, int, int], Node]
    choices: Mapping[int, GridNode | tuple[int, int, int]]
    image: tuple[Node, ...]
    points: tuple[HPoint, ...]
    refused: Mapping[int, tuple[tuple[HPoint, ...], ...]]

    def image_of(self, node: Node) -> Node:
        """The final node of any node of the arrangement."""
        n = self.traced.diced.framed.polygon.n
        if isinstance(node, tuple):
            target = self.moved.get(node)
            return node if target is None else self.image_of(target)
        return node if node < n else self.image[node - n]

    def point_of(self, node: Node) -> HPoint:
        """The final position of any node of the arrangement, in grid coordinates."""
        polygon = self.traced.diced.framed.polygon
        final = self.image_of(node)
        if isinstance(final, tuple):
            return grid_point(*final)
        return polygon.points[final] if final < polygon.n else self.points[final - polygon.n]


class WarpedFace(NamedTuple):
    """A face after warping, and its triangles.

    Parameters
    ----------
    ring : tuple of Node
        Final nodes, counter-clockwise, all distinct.
    block : int
        The vertex of P' whose block it belongs to, or -1.
    source : int
        The index in `BoundaryMesh.touched` of the face before warping.
    triangles : tuple of (Node, Node, Node)
        Counter-clockwise.
    """

    ring: tuple[Node, ...]
    block: int
    source: int
    triangles: tuple[tuple[Node, Node, Node], ...]


@dataclass(frozen=True)
class BoundaryMesh:
    """The part of P' near the boundary, triangulated.

    Parameters
    ----------
    warped : Warped
        The stage before.
    touched : tuple of Face
        Unwarped: `traced.faces`, then the rectangles that only a moved corner joins to the
        boundary.
    faces : tuple of WarpedFace
        What they become; a face may vanish or split.
    """

    warped: Warped
    touched: tuple[Face, ...]
    faces: tuple[WarpedFace, ...]


class MergedFace(NamedTuple):
    """A merged face M of Lemma 4, before anything is projected onto its edge.

    Parameters
    ----------
    edge : int
        The edge e of P'.
    faces : tuple of int
        The warped faces merged, from tail to head along e.
    base : tuple of Node
        Their nodes on e, from tail to head; those strictly between the ends disappear.
    staircase : tuple of Node
        The rest of the boundary, from the first base node to the last, both included.
    """

    edge: int
    faces: tuple[int, ...]
    base: tuple[Node, ...]
    staircase: tuple[Node, ...]


class Projected(NamedTuple):
    """A merged face cut up by diagonals onto its edge, and triangulated (Lemma 5).

    Parameters
    ----------
    merged : MergedFace
        M.
    cuts : tuple of (Node, Node)
        (staircase vertex, its projection on the edge) of every diagonal, along the edge.
    pieces : tuple of (ring, triangles)
        From the first base node to the last: the first and the last are the end faces, those
        between diagonals from neighbouring staircase vertices trapezoids.
    """

    merged: MergedFace
    cuts: tuple[tuple[Node, Node], ...]
    pieces: tuple[tuple[tuple[Node, ...], tuple[tuple[Node, Node, Node], ...]], ...]


@dataclass(frozen=True)
class MergedMesh:
    """The part of P' near the boundary, triangulated without large angles.

    Parameters
    ----------
    warped : Warped
        The stage before.
    touched : tuple of Face
        Unwarped, as in `BoundaryMesh`.
    faces : tuple of WarpedFace
        The faces that are not merged: those of blocks, and rectangles without boundary edge.
    projected : tuple of Projected
        The merged faces.
    projections : tuple of HPoint
        The Steiner points on edges, in grid coordinates: point i is the node
        n' + len(crossings) + i.
    """

    warped: Warped
    touched: tuple[Face, ...]
    faces: tuple[WarpedFace, ...]
    projected: tuple[Projected, ...]
    projections: tuple[HPoint, ...]

    def point_of(self, node: Node) -> HPoint:
        """The final position of any node, in grid coordinates."""
        first = self.warped.traced.diced.framed.polygon.n + len(self.warped.points)
        if isinstance(node, int) and node >= first:
            return self.projections[node - first]
        return self.warped.point_of(node)
