"""Merged faces of small polygons of every family, and Lemma 4's rule by definition."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from itertools import pairwise
from typing import NamedTuple

from gmpy2 import mpq

from bern_exact.boundary.corners import TAU
from bern_exact.boundary.merge import Merger, Objective, merge_boundary, nodes_on_edge
from bern_exact.boundary.records import MergedMesh, Node, Warped
from bern_exact.exact.points import HPoint
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems.prepare import prepare
from bern_exact.theorems.stages import Log, Silent
from tests.theorems.families import some_polygon

Ring = tuple[Node, ...]

Run = tuple[tuple[int, ...], tuple[Node, ...]]
"""The faces of a merged face and its nodes on the edge, before anything is projected."""


class Boundary(NamedTuple):
    """What the tests look at."""

    warped: Warped
    mesh: MergedMesh
    rings: Sequence[Ring]
    blocks: Sequence[int]


@cache
def merged(kind: str, seed: int, objective: Objective = "height", tau: mpq = TAU) -> Boundary:
    """The part near the boundary of a polygon of a family."""
    return merged_polygon(some_polygon(kind, seed), objective, tau)


def merged_polygon(polygon: Polygon, objective: Objective = "height", tau: mpq = TAU) -> Boundary:
    """The part near the boundary of any polygon, and the faces in the order it counts them."""
    made = prepare(polygon, Log("none", Silent()), tau)
    mesh = merge_boundary(made.warped, made.warping, made.tracer, tau, objective)
    rings, blocks = [], []
    for face in mesh.touched:
        for ring in made.warping.rings(face.ring):
            rings.append(tuple(node for node, _ in ring))
            blocks.append(face.block)
    return Boundary(made.warped, mesh, rings, blocks)


def merger_of(boundary: Boundary) -> Merger:
    """A merger that has used nothing yet."""
    return Merger(boundary.warped, boundary.rings, boundary.blocks)


class Definition:
    """Lemma 4's merging by definition: every edge inwards of every node is looked up.

    Parameters
    ----------
    boundary : Boundary
        For its faces.

    Attributes
    ----------
    why : set of str
        The reasons for which neighbours along an edge were kept apart, or not.
    """

    def __init__(self, boundary: Boundary) -> None:
        self.warped, self.blocks = boundary.warped, boundary.blocks
        darts = {
            (ring[i - 1], node): number
            for number, ring in enumerate(boundary.rings)
            for i, node in enumerate(ring)
        }
        self.darts = darts
        self.neighbours: dict[Node, set[Node]] = {}
        for a, b in darts:
            self.neighbours.setdefault(a, set()).add(b)
            self.neighbours.setdefault(b, set()).add(a)
        self.images = {self.warped.image_of(node) for node in self.warped.moved}
        self.used: set[int] = set()
        self.why: set[str] = set()

    def runs(self, edge: int) -> Iterator[Run]:
        """The merged faces along an edge."""
        faces: list[int] = []
        base: list[Node] = []
        for before, (tail, head) in zip(
            [None, *pairwise(nodes_on_edge(self.warped, edge))],
            pairwise(nodes_on_edge(self.warped, edge)),
            strict=False,
        ):
            number = self.darts[tail, head]
            continues = bool(faces) and self._continues(faces[-1], number, before, tail, head)
            if faces and not continues:
                yield tuple(dict.fromkeys(faces)), tuple(base)
                faces, base = [], []
            if continues or self._is_free(number):
                faces.append(number)
                base = [*(base or [tail]), head]
                self.used.add(number)
        if faces:
            yield tuple(dict.fromkeys(faces)), tuple(base)

    def _is_free(self, number: int) -> bool:
        """May the face be merged with any other?"""
        if self.blocks[number] >= 0:
            self.why.add("block")
        elif number in self.used:
            self.why.add("used")
        return self.blocks[number] < 0 and number not in self.used

    def _continues(
        self, last: int, number: int, before: tuple[Node, Node] | None, node: Node, head: Node
    ) -> bool:
        """Does the run go on across a node?"""
        if last == number:
            self.why.add("same face")
            return True
        if not self._is_free(number) or before is None:
            return False
        inwards = self.neighbours[node] - {before[0], head}
        if node in self.images:
            self.why.add("grid vertex")
        elif len(inwards) > 1:
            self.why.add("several edges")
        else:
            self.why.add("single edge")
        return node not in self.images and len(inwards) == 1


def points_of(boundary: Boundary, ring: Sequence[Node]) -> list[HPoint]:
    """Where nodes are."""
    return [boundary.mesh.point_of(node) for node in ring]
