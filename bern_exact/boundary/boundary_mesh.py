"""The faces near the boundary after warping, triangulated (Lemma 2)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gmpy2 import mpq

from bern_exact.boundary.arrangement import EAST, NORTH, SOUTH, WEST
from bern_exact.boundary.blocks import block_at
from bern_exact.boundary.corners import TAU, block_demands
from bern_exact.boundary.faces import Tracer
from bern_exact.boundary.optimal import (
    HIGHEST,
    HIGHEST_WITHIN_135,
    Demand,
    best_triangulation,
)
from bern_exact.boundary.records import BoundaryMesh, Face, GridNode, Node, Warped, WarpedFace
from bern_exact.boundary.warp import Warping
from bern_exact.exact.points import HPoint


class UntriangulatedFace(Exception):
    """A warped face that has no triangulation by its own vertices: not a simple ring."""


def triangulate_boundary(warped: Warped, warping: Warping, tracer: Tracer) -> BoundaryMesh:
    """Map every touched face through the warping and triangulate it for greatest height.

    Lemma 2: "After warping, each face can be triangulated with triangles of height
    Omega(s).  Neighbor and occupied squares can be triangulated with maximum angle at
    most 135 degrees as well."

    Parameters
    ----------
    warped : Warped
        Where everything goes.
    warping : Warping
        The same as a function.
    tracer : Tracer
        For the rectangles that have no piece of boundary but a moved corner.

    Notes
    -----
    Block faces: greatest height among the triangulations without an angle above 135 degrees.
    Linear time: each face has at most 7 nodes.
    """
    touched = [*warped.traced.faces, *touched_rectangles(warped, tracer)]
    faces: list[WarpedFace] = []
    for source, face in enumerate(touched):
        for ring in warping.rings(face.ring):
            nodes = tuple(node for node, _ in ring)
            points = [point for _, point in ring]
            demands = (*wanted_in_blocks(warped, TAU), HIGHEST) if face.block >= 0 else (HIGHEST,)
            triangles = triangulated(nodes, points, demands)
            faces.append(WarpedFace(nodes, face.block, source, triangles))
    return BoundaryMesh(warped, tuple(touched), tuple(faces))


def wanted_in_blocks(warped: Warped, tau: mpq) -> tuple[Demand, ...]:
    """What the triangles of a block face must keep, in order of preference.

    In square blocks the corner is chosen so that the highest triangles are high enough.
    """
    shape = warped.traced.diced.framed.blocks
    return (HIGHEST_WITHIN_135,) if shape == "square" else block_demands(shape, tau)


def triangulated(
    nodes: Sequence[Node], points: Sequence[HPoint], demands: Sequence[Demand]
) -> tuple[tuple[Node, Node, Node], ...]:
    """The best triangulation of a warped face by the first demand that can be kept.

    A checker reports a face that does not keep the first.
    """
    for demand in demands:
        found = best_triangulation(points, demand)
        if found:
            return tuple((nodes[i], nodes[j], nodes[k]) for i, j, k in found.triangles)
    raise UntriangulatedFace(f"face with nodes {tuple(nodes)}")


def touched_rectangles(warped: Warped, tracer: Tracer) -> Iterator[Face]:
    """The rectangles without a piece of boundary, one of whose corners has moved."""
    taken = set(tracer.taken)
    for node in sorted(warped.moved):
        for heading in (EAST, NORTH, WEST, SOUTH):
            if (node, heading) not in taken:
                corners = tracer.rectangle(node, heading)
                taken.update(corners)
                ring = tuple(corner for corner, _ in corners)
                yield Face(ring, _block(warped, ring, warped.moved[node]))


def _block(warped: Warped, ring: tuple[GridNode, ...], target: Node) -> int:
    """The vertex whose block holds a rectangle that has a corner moved to `target`, or -1."""
    polygon = warped.traced.diced.framed.polygon
    if not isinstance(target, int):
        return -1
    ends = [target]
    if target >= polygon.n:
        edge = warped.traced.diced.crossings[target - polygon.n].edge
        ends = [edge, polygon.after[edge]]
    for v in ends:
        if all(map(block_at(warped.traced.diced.framed, v).has, ring)):
            return v
    return -1
