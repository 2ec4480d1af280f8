"""Which corner of its square moves to each vertex: the corner rule, repaired (Lemma 2).

The paper takes the closest corner; block faces can then have angles up to
142.125 degrees.  Here the corners are tried in order of distance, and the first is
taken for which every face of the block can be triangulated with all angles
at most 135 degrees, edges of at least tau and heights of at least tau / sqrt 2.
For tau = 1/8 there always is one: `proofs/lemma_2` has the certificate.  Should
there be none for a smaller tau, the first that gives 135 degrees is taken, whatever
its edges and heights: down to the least tau of `proofs.lemma_2.thresholds` there is one.

A block round the nearest corner has its other corners on its rim, where faces of
no block would be warped with them: there the nearest corner moves, heights of
tau / 2 suffice, and 135 degrees + arctan(2 tau) if 135 cannot be had.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from gmpy2 import mpq

from bern_exact.boundary.arrangement import EAST, NORTH, SOUTH, WEST
from bern_exact.boundary.blocks import block_at, corner_near, square_of
from bern_exact.boundary.faces import Tracer
from bern_exact.boundary.optimal import KAPPA_135, Demand, best_triangulation, largest_kappa
from bern_exact.boundary.records import BlockShape, GridNode, Node, Traced, Warped
from bern_exact.boundary.warp import Instance, QVertices, Warping
from bern_exact.exact.points import HPoint, grid_point
from bern_exact.exact.predicates import is_in_wedge, squared_distance

TAU = mpq(1, 8)
"""The snapping threshold in grid units."""

# The cell at a grid vertex that lies left of it when it is reached by a heading, as the
# offset of its lower left corner.
CELL_OFFSET = {EAST: (-1, 0), NORTH: (-1, -1), WEST: (0, -1), SOUTH: (0, 0)}


def block_demands(shape: BlockShape, tau: mpq) -> tuple[Demand, ...]:
    """What the triangles of a block face must keep, in order of preference.

    Square blocks: 135 degrees and a height of tau/sqrt 2, by the choice of corner; or, if no
    corner has both, 135 degrees.  Corner blocks have no such choice: a height of tau/2, with
    135 degrees or 135 degrees + arctan(2 tau).  Edges of at least tau go with every height.
    """
    if shape == "square":
        return Demand(KAPPA_135, tau * tau / 2), Demand(KAPPA_135)
    return Demand(KAPPA_135, tau * tau / 4), Demand(largest_kappa(tau), tau * tau / 4)


@dataclass(frozen=True)
class Substep1:
    """The moves of substep 1 for one vertex and one corner."""

    corner: GridNode
    moved: dict[GridNode, int]
    instances: dict[Instance, int]


class CornerRule:
    """Chooses the corner that moves to each vertex.

    Parameters
    ----------
    traced : Traced
        The faces along the boundary, before warping.
    tracer : Tracer
        Which corners at grid vertices those faces have taken.
    tau : mpq
        The snapping threshold.
    """

    def __init__(self, traced: Traced, tracer: Tracer, tau: mpq) -> None:
        self.traced = traced
        self.framed = traced.diced.framed
        self.polygon = self.framed.polygon
        self.q = QVertices(traced, tau)
        self.tau_squared = tau * tau
        self.demands = block_demands(self.framed.blocks, tau)
        self._taken = tracer.taken
        self._block_faces: list[list[int]] = [[] for _ in range(self.polygon.n)]
        for i, face in enumerate(traced.faces):
            if face.block >= 0:
                self._block_faces[face.block].append(i)

    def choose(self, v: int) -> tuple[Substep1, int]:
        """The corner for vertex v and how often one was refused, as in `Warped.rank`.

        Every corner is tried with a demand before any is with the next.  If no corner keeps the
        first (impossible for square blocks and tau = 1/8, and never seen otherwise), the
        checkers of Lemma 2 report the block; if none keeps any, the closest is taken.
        """
        candidates = self._candidates(v)
        tries = [(demand, candidate) for demand in self.demands for candidate in candidates]
        for rank, (demand, candidate) in enumerate(tries):
            if self._is_good(v, candidate, demand):
                return candidate, rank
        return candidates[0], len(tries)

    def _candidates(self, v: int) -> list[Substep1]:
        """The four corners by distance, ties lexicographic; of a corner block its centre alone."""
        p = self.polygon.points[v]
        if self.framed.blocks == "corner":
            return [self._moves(v, corner_near(p))]
        fx, fy = square_of(p)
        corners = [(fx + i, fy + j) for i in (0, 1) for j in (0, 1)]
        corners.sort(key=lambda c: (squared_distance(p, grid_point(*c)), c))
        return [self._moves(v, c) for c in corners]

    def _moves(self, v: int, corner: GridNode) -> Substep1:
        """What moves to v if it takes this corner."""
        points = self.polygon.points
        before, after = self.polygon.before[v], self.polygon.after[v]
        inside = is_in_wedge(grid_point(*corner), points[before], points[v], points[after])
        return Substep1(
            corner,
            {corner: v} if inside else {},
            {(before, *corner): v, (v, *corner): v},
        )

    def _is_good(self, v: int, candidate: Substep1, demand: Demand) -> bool:
        """Does every face of the block keep a demand with this corner?

        A demand without a height asks for no length of edges either.
        """
        for points in self._block_faces_with(v, candidate):
            if demand.squared_floor and self._has_short_edge(points):
                return False
            if best_triangulation(points, demand) is None:
                return False
        return True

    def closest(self, v: int) -> tuple[tuple[HPoint, ...], ...]:
        """The faces of the block of v if its closest corner moves to it, as printed."""
        return tuple(self._block_faces_with(v, self._candidates(v)[0]))

    def _block_faces_with(self, v: int, candidate: Substep1) -> Iterator[tuple[HPoint, ...]]:
        """The faces of the block that may change, after warping with this corner."""
        warping = Warping(self.q, candidate.moved, candidate.instances)
        for ring in self._block_rings(v, candidate, warping):
            for final in warping.rings(ring):
                yield tuple(point for _, point in final)

    def _has_short_edge(self, points: Sequence[HPoint]) -> bool:
        return any(
            squared_distance(points[i - 1], p) < self.tau_squared for i, p in enumerate(points)
        )

    def _block_rings(
        self, v: int, candidate: Substep1, warping: Warping
    ) -> Iterator[Sequence[Node]]:
        """The unwarped faces of the block of v that may change."""
        touched: set[GridNode] = set(candidate.moved)
        for i in self._block_faces[v]:
            ring = self.traced.faces[i].ring
            yield ring
            touched.update(
                node
                for node in ring
                if isinstance(node, tuple) and warping.grid_target(node) != node
            )
        yield from self._touched_cells(v, sorted(touched))

    def _touched_cells(self, v: int, nodes: Sequence[GridNode]) -> Iterator[Sequence[Node]]:
        """The cells of the block that have one of these corners and no piece of boundary."""
        block = block_at(self.framed, v)
        seen: set[GridNode] = set()
        for node in nodes:
            for heading, (i, j) in CELL_OFFSET.items():
                x, y = node[0] + i, node[1] + j
                if (node, heading) in self._taken or (x, y) in seen:
                    continue
                if block.has((x, y)) and block.has((x + 1, y + 1)):
                    seen.add((x, y))
                    yield ((x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1))


def warp(traced: Traced, tracer: Tracer, tau: mpq = TAU) -> tuple[Warped, Warping]:
    """Warp: each vertex takes a corner of its square, then each near q-vertex a grid vertex.

    Section 2, the third step.

    Parameters
    ----------
    traced : Traced
        The faces along the boundary, before warping.
    tracer : Tracer
        The corners that these faces have taken.
    tau : mpq
        The snapping threshold of substep 2, in grid units.

    Returns
    -------
    Warped
        Where everything goes.
    Warping
        The same as a function, for mapping faces.

    Notes
    -----
    Linear time in the number of q-vertices.
    """
    rule = CornerRule(traced, tracer, tau)
    corners: list[GridNode] = []
    rank: list[int] = []
    moved_1: dict[GridNode, int] = {}
    instances_1: dict[Instance, int] = {}
    for v in range(rule.polygon.n):
        chosen, refused = rule.choose(v)
        corners.append(chosen.corner)
        rank.append(refused)
        moved_1.update(chosen.moved)
        instances_1.update(chosen.instances)
    warping = Warping(rule.q, moved_1, instances_1)
    moved: dict[GridNode, Node] = dict(moved_1)
    instances: dict[Instance, Node] = dict(instances_1)
    choices = {
        j: wish for j, wish in enumerate(rule.q.wishes) if wish is not None and warping.is_free(j)
    }
    for place in sorted(set(choices.values()), key=lambda place: (len(place), place)):
        target = rule.q.n + warping.chooser(place)
        if len(place) == 2:
            moved[place] = target
        else:
            instances[place] = target
    fates = [warping.fate(j) for j in range(len(rule.q.crossings))]
    record = Warped(
        traced,
        tuple(corners),
        tuple(rank),
        moved,
        instances,
        choices,
        tuple(node for node, _ in fates),
        tuple(point for _, point in fates),
        {v: rule.closest(v) for v, refused in enumerate(rank) if refused},
    )
    return record, warping
