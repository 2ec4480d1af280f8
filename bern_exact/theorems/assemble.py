"""From stage records to one mesh in the input's coordinates."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

from gmpy2 import mpq

from bern_exact.boundary.merge import nodes_on_edge
from bern_exact.boundary.records import Cut, Node, Warped, WarpedFace
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.plane.mesh import Mesh, Triangle
from bern_exact.plane.polygon import Polygon

Place = tuple[int | mpq, int | mpq]
"""A point in grid coordinates: a grid vertex, or a Steiner point of the interior."""

Tagged = tuple[int, tuple[Node, Node, Node]]
"""(class, triangle): the class as an index into `CLASSES`."""

CLASSES = ("block", "boundary", "merged", "interior", "rectangle", "fan", "cell", "rim")
"""What a triangle comes from: a face of a block, another touched face, a merged face, Q swept or
cut into rectangles, a lopped corner; of a convex polygon the grid's cells, or a right triangle
along the boundary."""

BLOCK, BOUNDARY, MERGED, INTERIOR, RECTANGLE, FAN, CELL, RIM = range(len(CLASSES))


@dataclass(frozen=True)
class Assembled:
    """The finished mesh and where each triangle comes from.

    Parameters
    ----------
    mesh : Mesh
        In the input's coordinates; the input's vertices first.
    classes : tuple of int
        For each triangle an index into `CLASSES`.
    """

    mesh: Mesh
    classes: tuple[int, ...]


def boundary_triangles(faces: Iterable[WarpedFace]) -> list[Tagged]:
    """The triangles of faces near the boundary, each with its class."""
    return [
        (BLOCK if face.block >= 0 else BOUNDARY, triangle)
        for face in faces
        for triangle in face.triangles
    ]


def nodes_on_cuts(warped: Warped) -> dict[int, list[Node]]:
    """For each cut edge of P' its final nodes from tail to head."""
    cuts = warped.traced.diced.framed.lopped.cuts
    return {cut.before: nodes_on_edge(warped, cut.before) for cut in cuts}


def assemble(
    warped: Warped,
    boundary: Sequence[Tagged],
    interior: Iterable[tuple[int, Sequence[Place]]],
    on_cuts: Mapping[int, Sequence[Node]],
    projections: Sequence[HPoint] = (),
) -> Assembled:
    """Put boundary faces, interior triangles and the fans of lopped corners together.

    Section 2: "As a final step in the algorithm, each isosceles triangle with Steiner points
    on its base is cut into a fan of triangles".

    Parameters
    ----------
    warped : Warped
        Where the nodes are.
    boundary : sequence of (class, triangle)
        The triangles near the boundary.
    interior : iterable of (class, triangle)
        The triangles of Q, by points in grid coordinates.
    on_cuts : mapping edge -> nodes
        The nodes on each cut edge of P' from tail to head.
    projections : sequence of HPoint
        Steiner points on edges, in grid coordinates, if there are any: the nodes after the
        q-vertices.

    Returns
    -------
    Assembled
        Everything is undone exactly: grid vertices go through the inverse similarity, vertices of
        P' keep their own coordinates.

    Notes
    -----
    Vertices: those of P in input order, the ends of cuts, the q-vertices, the projections, the
    points of the interior by (x, y).  O(m log m) for m triangles.
    """
    framed = warped.traced.diced.framed
    lopped = framed.lopped
    tagged: list[tuple[int, Sequence[Node | Place]]] = [*boundary, *interior]
    numbers = _Numbering(lopped.polygon, lopped.origin)
    numbers.add(node for _, triangle in tagged for node in triangle)
    triangles = [numbers.triangle(triangle) for _, triangle in tagged]
    fans = [triangle for cut in lopped.cuts for triangle in _fan(cut, on_cuts[cut.before], numbers)]
    back = framed.similarity.inverse()
    on_edges = (*warped.points, *projections)
    vertices = list(lopped.polygon.points)
    for node in numbers.new:
        if isinstance(node, tuple):
            vertices.append(back.apply(hpoint(*node)))
        elif node < lopped.lopped.n:
            vertices.append(lopped.lopped.points[node])
        else:
            vertices.append(back.apply(on_edges[node - lopped.lopped.n]))
    classes = [tag for tag, _ in tagged] + [FAN] * len(fans)
    return Assembled(Mesh(tuple(vertices), tuple(triangles + fans)), tuple(classes))


class _Numbering:
    """Mesh vertex numbers of nodes."""

    def __init__(self, polygon: Polygon, origin: Sequence[int]) -> None:
        self._first = polygon.n
        self._number: dict[Node | Place, int] = {i: v for i, v in enumerate(origin) if v >= 0}
        self.new: list[int | Place] = []

    def add(self, nodes: Iterable[Node | Place]) -> None:
        """Number all these nodes, those that have no number yet in a fixed order."""
        fresh = set(nodes) - self._number.keys()
        numbered = sorted(node for node in fresh if isinstance(node, int))
        self.new = [*numbered, *sorted(node for node in fresh if isinstance(node, tuple))]
        for i, node in enumerate(self.new):
            self._number[node] = self._first + i

    def __getitem__(self, node: Node | Place) -> int:
        return self._number[node]

    def triangle(self, nodes: Sequence[Node | Place]) -> Triangle:
        """The mesh triangle of three nodes."""
        number = self._number
        return (number[nodes[0]], number[nodes[1]], number[nodes[2]])


def _fan(cut: Cut, base: Sequence[Node], numbers: _Numbering) -> Iterator[Triangle]:
    """The fan from a lopped corner over all mesh vertices on its base."""
    for tail, head in pairwise(base):
        # The base has P' on its left and the corner on its right.
        yield (cut.corner, numbers[head], numbers[tail])
