"""Merging the faces along each edge (Section 3, Lemma 4) and what the edges' faces become.

"Merge all faces supported by edge e, except the faces resulting from occupied
and neighbor squares at the endpoints of e": where a single grid edge hits e
it is taken away, and with it the large angles there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Literal

from gmpy2 import mpq

from bern_exact.boundary.boundary_mesh import touched_rectangles, triangulated, wanted_in_blocks
from bern_exact.boundary.corners import TAU
from bern_exact.boundary.faces import Tracer
from bern_exact.boundary.optimal import Demand, largest_kappa
from bern_exact.boundary.project import Chooser, best_cuts, cuttable, fewest_cuts, project
from bern_exact.boundary.records import (
    MergedFace,
    MergedMesh,
    Node,
    Projected,
    Warped,
    WarpedFace,
)
from bern_exact.boundary.warp import Warping
from bern_exact.exact.points import HPoint

Ring = tuple[Node, ...]

Objective = Literal["fewest", "height", "angle"]
"""What Lemma 5's pieces are best at: few of them, the greatest least height, or the least largest
angle."""


def nodes_on_edge(warped: Warped, edge: int) -> list[Node]:
    """The distinct final nodes on an edge of P' from tail to head, after warping."""
    diced = warped.traced.diced
    nodes: list[Node] = [edge]
    ends = [*(warped.image[j] for j in diced.on_edge[edge]), diced.framed.polygon.after[edge]]
    for node in ends:
        if node != nodes[-1]:
            nodes.append(node)
    return nodes


@dataclass
class _Run:
    """Consecutive faces along an edge, merged so far.

    Parameters
    ----------
    faces : list of int
        Their indices.
    base : list of Node
        The nodes on the edge from tail to head.
    chain : list of Node
        The rest of the ring, from the last base node counter-clockwise to the first.
    """

    faces: list[int]
    base: list[Node]
    chain: list[Node]


@dataclass
class Merger:
    """Merges faces along edges, one edge after the other; each face is used once.

    Parameters
    ----------
    warped : Warped
        Where everything went.
    rings : sequence of Ring
        All warped faces.
    blocks : sequence of int
        For each ring the vertex whose block it belongs to, or -1.
    """

    warped: Warped
    rings: Sequence[Ring]
    blocks: Sequence[int]
    used: set[int] = field(default_factory=set)

    def __post_init__(self) -> None:
        self._ring_of = {
            (ring[i - 1], node): number
            for number, ring in enumerate(self.rings)
            for i, node in enumerate(ring)
        }
        # The images of interior grid vertices: they stay, whatever hits the edge there.
        self._grid_images = {self.warped.image_of(node) for node in self.warped.moved}

    def along(self, edge: int) -> Iterator[MergedFace]:
        """The merged faces along an edge, from tail to head."""
        nodes = nodes_on_edge(self.warped, edge)
        run: _Run | None = None
        for tail, head in zip(nodes, nodes[1:], strict=False):
            number = self._ring_of[tail, head]
            if self.blocks[number] >= 0 or (
                number in self.used and (run is None or number != run.faces[-1])
            ):
                if run:
                    yield self._finished(edge, run)
                run = None
                continue
            joined = run and self._joined(run, number, tail, head)
            if run and not joined:
                yield self._finished(edge, run)
            run = joined or _Run([number], [tail, head], self._chain(number, tail, head))
            self.used.add(number)
        if run:
            yield self._finished(edge, run)

    def _chain(self, number: int, tail: Node, head: Node) -> list[Node]:
        """A ring from `head` round to `tail`, leaving out the edge between them."""
        ring = self.rings[number]
        start = ring.index(head)
        return [*ring[start:], *ring[:start]]

    def _joined(self, run: _Run, number: int, tail: Node, head: Node) -> _Run | None:
        """The run with the next face, if exactly one grid edge hits the boundary edge between."""
        if number == run.faces[-1]:
            # The same face twice in a row: the node between has no edge inwards.
            return _Run(run.faces, [*run.base, head], run.chain[run.chain.index(head) :])
        chain = self._chain(number, tail, head)
        # ... x, tail of the next face meets tail, x, ... of the run: one edge between them.
        if tail in self._grid_images or chain[-2] != run.chain[1]:
            return None
        return _Run([*run.faces, number], [*run.base, head], [*chain[:-1], *run.chain[2:]])

    def _finished(self, edge: int, run: _Run) -> MergedFace:
        """The record of a run."""
        return MergedFace(edge, tuple(run.faces), tuple(run.base), tuple(reversed(run.chain)))


def merge_boundary(
    warped: Warped,
    warping: Warping,
    tracer: Tracer,
    tau: mpq = TAU,
    objective: Objective = "fewest",
) -> MergedMesh:
    """The faces near the boundary, triangulated without large angles.

    Section 3: the faces along each edge are merged (Lemma 4) and cut by diagonals
    (Lemma 5); those of blocks are triangulated as in Lemma 2; a rectangle that only
    a moved corner joins to the boundary keeps its own vertices.

    Parameters
    ----------
    warped : Warped
        Where everything goes.
    warping : Warping
        The same as a function.
    tracer : Tracer
        For the rectangles without a piece of boundary.
    tau : mpq
        The threshold of warping: no angle exceeds 135 degrees + arctan(2 tau).
    objective : {"fewest", "height", "angle"}
        Choose as few diagonals as the angle bound and heights of at least tau / sqrt 2 allow; or
        for the greatest least height within the angle bound; or for the least largest angle
        with heights of at least tau / sqrt 2.
    """
    touched = (*warped.traced.faces, *touched_rectangles(warped, tracer))
    rings: list[Ring] = []
    sources: list[int] = []
    for source, face in enumerate(touched):
        for ring in warping.rings(face.ring):
            rings.append(tuple(node for node, _ in ring))
            sources.append(source)
    merger = Merger(warped, rings, [touched[source].block for source in sources])
    polygon = warped.traced.diced.framed.polygon
    first = polygon.n + len(warped.points)
    wanted = _demands(tau, objective)
    choices: list[tuple[Chooser, Demand]] = [(best_cuts, demand) for demand in wanted]
    if objective == "fewest":
        choices.insert(0, (fewest_cuts, Demand(largest_kappa(tau), tau * tau / 2)))
    projected: list[Projected] = []
    projections: list[HPoint] = []
    for edge in range(polygon.n):
        for merged in merger.along(edge):
            points = [warping.image(node)[1] for node in merged.staircase]
            whole = cuttable(merged, polygon.lines[edge], points, tau * tau / 2)
            found, fresh = project(whole, choices, first + len(projections))
            projected.append(found)
            projections += fresh
    faces = []
    for number, (nodes, source) in enumerate(zip(rings, sources, strict=True)):
        if number not in merger.used:
            points = [warping.image(node)[1] for node in nodes]
            block = touched[source].block
            demands = (*wanted_in_blocks(warped, tau), *wanted) if block >= 0 else wanted
            faces.append(WarpedFace(nodes, block, source, triangulated(nodes, points, demands)))
    return MergedMesh(warped, touched, tuple(faces), tuple(projected), tuple(projections))


def _demands(tau: mpq, objective: Objective) -> tuple[Demand, ...]:
    """What a piece must keep, in order of preference; the last can always be kept."""
    kappa = largest_kappa(tau)
    by_height = (Demand(kappa), Demand())
    return (Demand(kappa, tau * tau / 2, True), *by_height) if objective == "angle" else by_height
