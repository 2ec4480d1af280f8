"""From stage records to one mesh in the input's coordinates."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from bern_exact.boundary.records import BoundaryMesh, Cut, Node, Warped
from bern_exact.exact.points import HPoint, grid_point
from bern_exact.plane.mesh import Mesh, Triangle
from bern_exact.plane.polygon import Polygon

NodeTriangle = tuple[Node, Node, Node]

CLASSES = ("block", "boundary", "interior", "fan")
"""What a triangle comes from: a face of a block, another touched face, Q, a lopped corner."""


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


def assemble(boundary: BoundaryMesh, interior: Sequence[NodeTriangle]) -> Assembled:
    """Put boundary faces, interior triangles and the fans of lopped corners together.

    Section 2: "As a final step in the algorithm, each isosceles triangle with Steiner points
    on its base is cut into a fan of triangles".

    Parameters
    ----------
    boundary : BoundaryMesh
        The faces near the boundary.
    interior : sequence of triples of grid vertices
        The triangles of Q; their corners may be Steiner points.

    Returns
    -------
    Assembled
        Everything is undone exactly: grid vertices go through the inverse similarity, vertices of
        P' keep their own coordinates.

    Notes
    -----
    Vertices: those of P in input order, the ends of cuts, the q-vertices, the grid
    vertices by (x, y).  O(m log m) for m triangles.
    """
    tagged: list[tuple[int, NodeTriangle]] = [
        (0 if face.block >= 0 else 1, triangle)
        for face in boundary.faces
        for triangle in face.triangles
    ]
    tagged += [(2, triangle) for triangle in interior]
    warped = boundary.warped
    framed = warped.traced.diced.framed
    lopped = framed.lopped
    numbers = _Numbering(lopped.polygon, lopped.origin)
    numbers.add(node for _, triangle in tagged for node in triangle)
    triangles = [numbers.triangle(triangle) for _, triangle in tagged]
    fans = [triangle for cut in lopped.cuts for triangle in _fan(warped, cut, numbers)]
    back = framed.similarity.inverse()
    vertices = list(lopped.polygon.points)
    vertices += [_original(node, warped, lopped.lopped, back.apply) for node in numbers.new]
    classes = [tag for tag, _ in tagged] + [3] * len(fans)
    return Assembled(Mesh(tuple(vertices), tuple(triangles + fans)), tuple(classes))


class _Numbering:
    """Mesh vertex numbers of nodes."""

    def __init__(self, polygon: Polygon, origin: Sequence[int]) -> None:
        self._first = polygon.n
        self._number: dict[Node, int] = {i: v for i, v in enumerate(origin) if v >= 0}
        self.new: list[Node] = []

    def add(self, nodes: Iterator[Node]) -> None:
        """Number all these nodes, those that have no number yet in a fixed order."""
        fresh = set(nodes) - self._number.keys()
        numbered = sorted(node for node in fresh if isinstance(node, int))
        self.new = [*numbered, *sorted(node for node in fresh if isinstance(node, tuple))]
        for i, node in enumerate(self.new):
            self._number[node] = self._first + i

    def __getitem__(self, node: Node) -> int:
        return self._number[node]

    def triangle(self, nodes: NodeTriangle) -> Triangle:
        """The mesh triangle of three nodes."""
        number = self._number
        return (number[nodes[0]], number[nodes[1]], number[nodes[2]])


def _fan(warped: Warped, cut: Cut, numbers: _Numbering) -> Iterator[Triangle]:
    """The fan from a lopped corner over all mesh vertices on its base."""
    base = nodes_on_edge(warped, cut.before)
    for tail, head in zip(base, base[1:], strict=False):
        # The base has P' on its left and the corner on its right.
        yield (cut.corner, numbers[head], numbers[tail])


def nodes_on_edge(warped: Warped, edge: int) -> list[Node]:
    """The distinct final nodes on an edge of P' from tail to head."""
    diced = warped.traced.diced
    nodes: list[Node] = [edge]
    ends = [*(warped.image[j] for j in diced.on_edge[edge]), diced.framed.polygon.after[edge]]
    for node in ends:
        if node != nodes[-1]:
            nodes.append(node)
    return nodes


def _original(
    node: Node, warped: Warped, lopped: Polygon, back: Callable[[HPoint], HPoint]
) -> HPoint:
    """The position of a node in the input's coordinates."""
    if isinstance(node, tuple):
        return back(grid_point(*node))
    if node < lopped.n:
        return lopped.points[node]
    return back(warped.points[node - lopped.n])
