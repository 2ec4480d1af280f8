"""Tracing the faces along the boundary, before warping (Section 2).

A face is traced by walking with it on the left: along a piece of the
boundary, left into an interval at a q-vertex, left at every grid vertex
(each is a crossing of two whole intervals, so the way left exists), and
left again where an interval ends on the boundary.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence

from bern_exact.boundary.arrangement import EAST, NORTH, SOUTH, Arrangement
from bern_exact.boundary.blocks import Block, block_at
from bern_exact.boundary.records import VERTICAL, Diced, Face, GridNode, Node, Traced

Piece = tuple[int, int]
"""(edge, j): the piece of an edge between its nodes j and j + 1 from the tail."""

Corner = tuple[GridNode, int]
"""(grid vertex, direction of arrival): a corner of the face on the left."""


class Tracer:
    """Traces faces and remembers which corners at grid vertices they have taken.

    Parameters
    ----------
    arrangement : Arrangement
        What to walk in.
    """

    def __init__(self, arrangement: Arrangement) -> None:
        self.arrangement = arrangement
        diced = arrangement.diced
        self._n = diced.framed.polygon.n
        self._head = diced.framed.polygon.after
        self._diced = diced
        self._rank = [0] * len(diced.crossings)
        for found in diced.on_edge:
            for i, j in enumerate(found):
                self._rank[j] = i + 1
        self.taken: set[Corner] = set()
        """The corners at grid vertices of the faces along the boundary."""

    def pieces(self, edge: int) -> int:
        """How many pieces the crossings cut an edge into."""
        return len(self._diced.on_edge[edge]) + 1

    def along_boundary(self, piece: Piece) -> tuple[list[Node], list[Piece]]:
        """The face left of a boundary piece: its nodes, and the pieces on its boundary."""
        ring: list[Node] = []
        passed: list[Piece] = []
        current = piece
        while True:
            edge, j = current
            passed.append(current)
            on_edge = self._diced.on_edge[edge]
            ring.append(self._n + on_edge[j - 1] if j else edge)
            if j == len(on_edge):
                current = (self._head[edge], 0)
            else:
                current = self._through(on_edge[j], ring)
            if current == piece:
                return ring, passed

    def _through(self, crossing: int, ring: list[Node]) -> Piece:
        """Walk from a q-vertex through P' back to the boundary; the piece that begins there."""
        arrangement = self.arrangement
        ring.append(self._n + crossing)
        heading = arrangement.inwards(crossing)
        axis = self._diced.crossings[crossing].axis
        line = self._diced.crossings[crossing].line
        step = arrangement.step_from_crossing(crossing)
        while step.crossing < 0:
            node = (line, step.line) if axis == VERTICAL else (step.line, line)
            ring.append(node)
            self.taken.add((node, heading))
            heading = (heading + 1) % 4
            axis, line = 1 - axis, step.line
            step = arrangement.step_from_node(node, heading)
        return self._diced.crossings[step.crossing].edge, self._rank[step.crossing]

    def rectangle(self, node: GridNode, heading: int) -> tuple[Corner, ...]:
        """The face with a corner at a grid vertex, reached by `heading`; none of it is boundary.

        Its four corners, counter-clockwise.  Nothing is remembered.
        """
        corners = []
        for _ in range(4):
            corners.append((node, heading))
            heading = (heading + 1) % 4
            step = self.arrangement.step_from_node(node, heading)
            vertical = heading in (NORTH, SOUTH)
            node = (node[0], step.line) if vertical else (step.line, node[1])
        return tuple(corners)


def trace(diced: Diced) -> tuple[Traced, Tracer]:
    """Trace every face that has a piece of the boundary.

    Section 2: "There are O(n) faces around the boundary and O(n^2) interior rectangles";
    only the former are looked at.

    Parameters
    ----------
    diced : Diced
        The kept intervals.

    Returns
    -------
    Traced
        The faces, and the inner neighbour and the anchor of each q-vertex.
    Tracer
        For tracing the rectangles that warping touches.

    Notes
    -----
    O(n log^2 n): about 39 walking steps for each vertex of P'.
    """
    tracer = Tracer(Arrangement(diced))
    block_of = _pieces_in_blocks(diced)
    faces = []
    seen: set[Piece] = set()
    for edge in range(diced.framed.polygon.n):
        for j in range(tracer.pieces(edge)):
            if (edge, j) in seen:
                continue
            ring, passed = tracer.along_boundary((edge, j))
            seen.update(passed)
            block = max(block_of.get(piece, -1) for piece in passed)
            faces.append(Face(tuple(ring), block))
    inner = tuple(_inner(tracer.arrangement, j) for j in range(len(diced.crossings)))
    anchors = tuple(_anchor(tracer.arrangement, j) for j in range(len(diced.crossings)))
    return Traced(diced, tuple(faces), inner, anchors), tracer


def _pieces_in_blocks(diced: Diced) -> dict[Piece, int]:
    """Every boundary piece within the block of a vertex at an end of its edge -> that vertex."""
    polygon = diced.framed.polygon
    block_of: dict[Piece, int] = {}
    for v in range(polygon.n):
        block = block_at(diced.framed, v)
        outwards = diced.on_edge[v]
        inwards = diced.on_edge[polygon.before[v]]
        for j in range(_until_exit(diced, outwards, block)):
            block_of[v, j] = v
        for j in range(_until_exit(diced, inwards[::-1], block)):
            block_of[polygon.before[v], len(inwards) - j] = v
    return block_of


def _until_exit(diced: Diced, crossings: Sequence[int], block: Block) -> int:
    """How many pieces from a vertex on lie within its block.

    The block's outer lines are kept round the vertex, so its edges have crossings there.
    """
    for count, j in enumerate(crossings):
        q = diced.crossings[j]
        if q.line in (block.low[q.axis], block.high[q.axis]):
            return count + 1
    return len(crossings) + 1


def _inner(arrangement: Arrangement, crossing: int) -> GridNode | None:
    """The first grid vertex inwards from a q-vertex."""
    step = arrangement.step_from_crossing(crossing)
    if step.crossing >= 0:
        return None
    q = arrangement.diced.crossings[crossing]
    return (q.line, step.line) if q.axis == VERTICAL else (step.line, q.line)


def _anchor(arrangement: Arrangement, crossing: int) -> GridNode:
    """The first crossing outwards from a q-vertex with a line in use.

    There is one: the lines of the blocks at both ends of the edge are in use.
    """
    q = arrangement.diced.crossings[crossing]
    across = arrangement.lines[1 - q.axis]
    floor = q.at.numerator // q.at.denominator
    if arrangement.inwards(crossing) in (NORTH, EAST):
        line = across[bisect_right(across, floor) - 1]
    else:
        line = across[bisect_left(across, floor + 1)]
    return (q.line, line) if q.axis == VERTICAL else (line, q.line)
