"""Warping: grid vertices move to the boundary (Section 2, both substeps).

`Warping` says where everything goes once it is known which corner each
vertex takes.  It works for one vertex alone (to try a corner) as well as
for all together, since blocks are disjoint.

Exterior grid vertices are kept as instances (edge, k, l), one for each
boundary edge: on one sheet two edges never share one, and so at most two
q-vertices choose the same instance.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cached_property

from gmpy2 import mpq

from bern_exact.boundary.records import HORIZONTAL, VERTICAL, Crossing, GridNode, Node, Traced
from bern_exact.exact.points import HPoint, grid_point, hpoint, line_through, meet

Instance = tuple[int, int, int]
"""(edge, k, l): the exterior grid vertex (k, l) as edge `edge` sees it."""


class QVertices:
    """The q-vertices as substep 2 sees them, whatever substep 1 does.

    Parameters
    ----------
    traced : Traced
        Their inner neighbours and anchors.
    tau : mpq
        The threshold below which a q-vertex chooses a grid vertex (1/8 of the grid unit).
    """

    def __init__(self, traced: Traced, tau: mpq) -> None:
        self.traced = traced
        self.crossings = traced.diced.crossings
        self.polygon = traced.diced.framed.polygon
        self.n = self.polygon.n
        self.anchors: list[Instance] = [
            (q.edge, *anchor) for q, anchor in zip(self.crossings, traced.anchors, strict=True)
        ]
        self.wishes = [self._wish(j, tau) for j in range(len(self.crossings))]
        self.choosers = self._choosers()

    def _wish(self, j: int, tau: mpq) -> GridNode | Instance | None:
        """What q-vertex j chooses if nothing hinders it: g if nearer than tau, else its anchor."""
        q, g = self.crossings[j], self.traced.inner[j]
        if g is not None and self._distance(q, g) < tau:
            return g
        anchor = self.anchors[j]
        return anchor if self._distance(q, anchor[1:]) < tau else None

    @staticmethod
    def _distance(q: Crossing, node: tuple[int, ...]) -> mpq:
        """The distance of a q-vertex from a grid vertex on its line."""
        return abs(q.at - node[1 if q.axis == VERTICAL else 0])

    def _choosers(self) -> dict[GridNode | Instance, list[int]]:
        """For each chosen place its choosers, nearest first, ties horizontal first."""
        found: dict[GridNode | Instance, list[int]] = {}
        for j, wish in enumerate(self.wishes):
            if wish is not None:
                found.setdefault(wish, []).append(j)
        for place, choosers in found.items():
            if len(choosers) > 1:
                node = place[-2:]
                choosers.sort(
                    key=lambda j, node=node: (  # type: ignore[misc]
                        self._distance(self.crossings[j], node),
                        self.crossings[j].axis != HORIZONTAL,
                        j,
                    )
                )
        return found

    @cached_property
    def points(self) -> list[HPoint]:
        """The q-vertices where the grid lines cross the boundary, before any sliding."""
        return [
            hpoint(q.line, q.at) if q.axis == VERTICAL else hpoint(q.at, q.line)
            for q in self.crossings
        ]


class Warping:
    """Both substeps of warping, given what moves in substep 1.

    Parameters
    ----------
    q_vertices : QVertices
        The q-vertices and their wishes.
    moved : mapping GridNode -> vertex
        The interior grid vertices that move in substep 1.
    instances : mapping (edge, k, l) -> vertex
        The exterior instances that move in substep 1.
    """

    def __init__(
        self,
        q_vertices: QVertices,
        moved: Mapping[GridNode, int],
        instances: Mapping[Instance, int],
    ) -> None:
        self.q = q_vertices
        self.moved = moved
        self.instances = instances
        self._image: dict[int, tuple[Node, HPoint]] = {}

    def is_free(self, j: int) -> bool:
        """Are the inner neighbour and the anchor of q-vertex j unmoved by substep 1?"""
        return self.q.traced.inner[j] not in self.moved and self.q.anchors[j] not in self.instances

    def chooser(self, place: GridNode | Instance) -> int:
        """The q-vertex to which a place moves in substep 2, or -1."""
        for j in self.q.choosers.get(place, ()):
            if self.is_free(j):
                return j
        return -1

    def grid_target(self, node: GridNode) -> Node:
        """Where an interior grid vertex moves: a vertex, a q-vertex, or itself."""
        v = self.moved.get(node)
        if v is not None:
            return v
        j = self.chooser(node)
        return node if j < 0 else self.q.n + j

    def instance_target(self, place: Instance) -> Node:
        """Where an exterior instance moves: a vertex, a q-vertex, or its grid vertex."""
        v = self.instances.get(place)
        if v is not None:
            return v
        j = self.chooser(place)
        return place[1:] if j < 0 else self.q.n + j

    def fate(self, j: int) -> tuple[Node, HPoint]:
        """The node that q-vertex j ends as, and where."""
        known = self._image.get(j)
        if known is None:
            known = self._image[j] = self._fate(j)
        return known

    def _fate(self, j: int) -> tuple[Node, HPoint]:
        q, g, anchor = self.q.crossings[j], self.q.traced.inner[j], self.q.anchors[j]
        ends = (q.edge, self.q.polygon.after[q.edge])
        if g is None:
            inner = self.instance_target(self._far_anchor(q))
            if inner in ends:
                return self._settled(inner)
        elif self.chooser(g) == j:
            return self.q.n + j, self.q.points[j]
        else:
            inner = self.grid_target(g)
            if inner in ends or self._is_on(inner, q.edge):
                return self._settled(inner)
        outer = self.instance_target(anchor)
        if not isinstance(outer, tuple) and outer != self.q.n + j:
            return self._settled(outer)
        if inner == g or not isinstance(outer, tuple):
            return self.q.n + j, self.q.points[j]
        # q slides to where the straight segment to its fixed anchor crosses its edge.
        segment = line_through(self._settled(inner)[1], grid_point(*outer))
        return self.q.n + j, meet(segment, self.q.polygon.lines[q.edge])

    def _far_anchor(self, q: Crossing) -> Instance:
        """The anchor of the q-vertex at the other end of an interval without grid vertices."""
        return self.q.anchors[self.q.traced.diced.crossing_at[q.axis, q.line, q.far]]

    def _is_on(self, node: Node, edge: int) -> bool:
        """Is the node a q-vertex of this edge?"""
        return (
            isinstance(node, int)
            and node >= self.q.n
            and self.q.crossings[node - self.q.n].edge == edge
        )

    def _settled(self, node: Node) -> tuple[Node, HPoint]:
        """Where a node ends that a grid vertex or a q-vertex has moved to.

        A q-vertex that was chosen by its anchor's instance may itself have merged with
        another one on its edge; one that chose its inner neighbour stays.
        """
        if isinstance(node, tuple):
            return node, grid_point(*node)
        if node < self.q.n:
            return node, self.q.polygon.points[node]
        return self.fate(node - self.q.n)

    def image(self, node: Node) -> tuple[Node, HPoint]:
        """The final node of any node of the arrangement, and where."""
        if isinstance(node, tuple):
            return self._settled(self.grid_target(node))
        if node < self.q.n:
            return self._settled(node)
        return self.fate(node - self.q.n)

    def rings(self, ring: Iterable[Node]) -> list[list[tuple[Node, HPoint]]]:
        """What a face becomes: its rings of final nodes, repeats dropped, split where they touch.

        Rings of fewer than three nodes vanish.
        """
        finished: list[list[tuple[Node, HPoint]]] = []
        path: list[tuple[Node, HPoint]] = []
        place: dict[Node, int] = {}
        for node in ring:
            final = self.image(node)
            start = place.get(final[0])
            if start is not None:
                # Back at a node of the path: what lies between is a ring of its own.
                loop = path[start:]
                for closed in path[start + 1 :]:
                    del place[closed[0]]
                del path[start + 1 :]
                if len(loop) > 2:
                    finished.append(loop)
                continue
            place[final[0]] = len(path)
            path.append(final)
        if len(path) > 2:
            finished.append(path)
        return finished
