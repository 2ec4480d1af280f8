"""The rings of the warped faces, found again from the record of where every node goes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from bern_exact.boundary.records import BoundaryMesh, MergedFace, MergedMesh, Node, Warped
from bern_exact.checkers.extremes import Violations
from bern_exact.checkers.places import Places

NearBoundary = BoundaryMesh | MergedMesh
"""Both records of the part of P' near the boundary: with every face, or with merged ones."""

Ring = tuple[Node, ...]


def places_of(mesh: NearBoundary) -> Places:
    """Where the nodes of a mesh near the boundary are."""
    return Places(mesh.warped, mesh.projections if isinstance(mesh, MergedMesh) else ())


def warped_rings(mesh: NearBoundary) -> list[tuple[Ring, int]]:
    """What the touched faces become: every ring with the index of the face it comes from.

    They stand in the order in which `MergedFace.faces` counts them.
    """
    return [
        (ring, source)
        for source, face in enumerate(mesh.touched)
        for ring in simple_rings(mesh.warped.image_of(node) for node in face.ring)
    ]


def simple_rings(nodes: Iterable[Node]) -> Iterator[Ring]:
    """A closed walk cut into rings of distinct nodes; those of one or two nodes vanish.

    >>> list(simple_rings([1, 1, 2, 3, 4, 5, 3, 6]))
    [(3, 4, 5), (1, 2, 3, 6)]
    """
    path: list[Node] = []
    for node in nodes:
        if node not in path:
            path.append(node)
            continue
        start = path.index(node)
        if len(path) - start > 2:
            yield tuple(path[start:])
        del path[start + 1 :]
    if len(path) > 2:
        yield tuple(path)


def merged_ring(face: MergedFace) -> Ring:
    """The boundary of a merged face, counter-clockwise."""
    return (*face.base, *reversed(face.staircase[1:-1]))


def measured_rings(mesh: NearBoundary) -> list[tuple[Ring, int]]:
    """Every warped face with its block (-1 outside): those recorded, then those merged."""
    rings = [(face.ring, face.block) for face in mesh.faces]
    if isinstance(mesh, MergedMesh):
        found = warped_rings(mesh)
        merged = [i for item in mesh.projected for i in item.merged.faces if 0 <= i < len(found)]
        rings += [(found[i][0], mesh.touched[found[i][1]].block) for i in merged]
    return rings


def outline_rings(mesh: NearBoundary) -> Iterator[Ring]:
    """The faces near the boundary that stay: those recorded, and the merged ones."""
    yield from (face.ring for face in mesh.faces)
    if isinstance(mesh, MergedMesh):
        yield from (merged_ring(item.merged) for item in mesh.projected)


def cancelled(rings: Iterable[Sequence[Node]], broken: Violations) -> dict[tuple[Node, Node], None]:
    """The directed edges of the rings that no reverse cancels, in a fixed order.

    An edge that two rings use in the same direction breaks the claim.
    """
    left: dict[tuple[Node, Node], None] = {}
    for ring in rings:
        for i, b in enumerate(ring):
            a = ring[i - 1]
            if (b, a) in left:
                del left[b, a]
            elif (a, b) in left:
                broken.broken((None, (a, b)))
            else:
                left[a, b] = None
    return left


def boundary_edge(warped: Warped, a: Node, b: Node) -> int:
    """The edge of P' on which both final nodes lie, -1 if there is none."""
    if isinstance(a, tuple) or isinstance(b, tuple):
        return -1
    shared = [e for e in _edges(warped, a) if e in _edges(warped, b)]
    return shared[0] if shared else -1


def _edges(warped: Warped, node: int) -> tuple[int, ...]:
    diced = warped.traced.diced
    polygon = diced.framed.polygon
    if node < polygon.n:
        return node, polygon.before[node]
    return (diced.crossings[node - polygon.n].edge,)
