"""The paper's planar straight-line graphs (Section 4), and its counting arguments about them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from gmpy2 import mpq

from bern_exact.exact.angles import Angle, largest_angle
from bern_exact.exact.points import HPoint, coordinates, hpoint, line_through
from bern_exact.exact.predicates import side, squared_height
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.plane_graph import PlaneGraph

Place = tuple[mpq, mpq]


@dataclass(frozen=True)
class Accordion:
    """Paterson's accordion (Figure 7): skinny triangles stacked in a convex polygon.

    Parameters
    ----------
    graph : PlaneGraph
        Its points: the zig-zag from the top left downwards, then the top's vertices.
    zigzag : tuple of int
        The zig-zag's vertices; its first edge is the top side.
    top : tuple of int
        The vertices evenly spaced along the top side, from left to right.
    """

    graph: PlaneGraph
    zigzag: tuple[int, ...]
    top: tuple[int, ...]

    @property
    def layers(self) -> int:
        """How many skinny triangles are stacked."""
        return len(self.zigzag) - 2


SPACING = 100
"""The distance of the accordion's top vertices, in heights of the whole stack."""


def accordion(n: int) -> Accordion:
    """n skinny triangles one below the other, and n vertices along the top side.

    Section 4, after Paterson (Figure 7): "this PSLG requires Omega(n^2) triangles with angles
    bounded below 180".  The stack has height 1 and the vertices are 100 apart, so that
    no path of steepest edges downwards can reach the next one's unless some angle is within
    about two degrees of 180: the drift is at most tan(A/2) for angles of at most A.

    Parameters
    ----------
    n : int
        At least 1.
    """
    width = SPACING * (n + 1)
    zigzag = [_zigzag_vertex(i, n, width) for i in range(n + 2)]
    top = [(mpq(SPACING * j), mpq(0)) for j in range(1, n + 1)]
    chain = [0, *range(n + 2, 2 * n + 2), 1]
    edges = [*pairwise(chain), *pairwise(range(1, n + 2)), *((i, i + 2) for i in range(n))]
    points = tuple(hpoint(*p) for p in (*zigzag, *top))
    graph = PlaneGraph("accordion", points, tuple(edges))
    return Accordion(graph, tuple(range(n + 2)), tuple(chain[1:-1]))


def _zigzag_vertex(i: int, n: int, width: int) -> Place:
    """Vertex i, left if even; the sides bulge by up to 1/8, so that the polygon is convex."""
    depth = mpq(max(0, i - 1), n)
    bulge = depth * (2 - depth) / 8
    return (-bulge if i % 2 == 0 else width + bulge), -depth


def accordion_mesh(stack: Accordion) -> Mesh:
    """A triangulation of the accordion by vertical lines: Theta(n^2) triangles, angles about 90.

    Every top vertex sends a vertical line through the whole stack.
    """
    points = list(stack.graph.points)
    number = {p: i for i, p in enumerate(points)}
    below = [stack.top]
    for a, b in pairwise(stack.zigzag[1:]):
        below.append(tuple(_add(points, number, _on(points, a, b, t)) for t in stack.top))
    triangles: list[tuple[int, int, int]] = []
    for i, (upper, lower) in enumerate(pairwise(below)):
        first, shared, last = stack.zigzag[i : i + 3]
        if i % 2 == 0:
            triangles += _strip((first, *upper, shared), (last, *lower, shared))
        else:
            triangles += _strip((shared, *upper, first), (shared, *lower, last))
    return Mesh(tuple(points), tuple(triangles))


def _on(points: Sequence[HPoint], a: int, b: int, t: int) -> HPoint:
    """The point of the line ab straight below point t."""
    (ax, ay), (bx, by), (x, _) = (coordinates(points[i]) for i in (a, b, t))
    return hpoint(x, ay + (by - ay) * (x - ax) / (bx - ax))


def _add(points: list[HPoint], number: dict[HPoint, int], p: HPoint) -> int:
    """The number of a point, which is added if it is new."""
    if p not in number:
        number[p] = len(points)
        points.append(p)
    return number[p]


def _strip(high: Sequence[int], low: Sequence[int]) -> list[tuple[int, int, int]]:
    """The triangles between two chains of as many points; where they meet a side is no triangle."""
    found = []
    for (a, b), (c, d) in zip(pairwise(high), pairwise(low), strict=True):
        found += [t for t in ((c, d, b), (c, b, a)) if len({*t}) == 3]
    return found


@dataclass(frozen=True)
class Descents:
    """The paths downwards from the top vertices of an accordion, in some triangulation.

    Parameters
    ----------
    paths : tuple of tuple of int
        For each top vertex the vertices of its path, down to the lowest edge.
    """

    paths: tuple[tuple[int, ...], ...]

    @property
    def separate(self) -> bool:
        """Does no path merge with another?"""
        return self.vertices == sum(len(path) for path in self.paths)

    @property
    def vertices(self) -> int:
        """How many vertices are on the paths: the mesh has at least as many."""
        return len({v for path in self.paths for v in path})


def descents(stack: Accordion, mesh: Mesh) -> Descents:
    """The paper's counting argument, evaluated on a triangulation of the accordion.

    "Because each vertex at the top must have a 'downwards' edge, and each of the endpoints of
    these edges must in turn have downwards edge, there must be a path running down from each top
    vertex through the stack of skinny triangles.  If triangles are sufficiently skinny,
    separate paths cannot merge because of the angle bound.  Thus each path must have
    complexity Omega(n) and the entire triangulation complexity Omega(n^2)."

    Each path takes the steepest edge downwards.  An edge cannot cross those of the
    accordion, so a path down to the bottom has a vertex on each.

    Parameters
    ----------
    stack : Accordion
        The accordion.
    mesh : Mesh
        Any triangulation of it, its points first.
    """
    neighbours = _neighbours(mesh)
    bottom = line_through(*(stack.graph.points[v] for v in stack.zigzag[-2:]))
    at = mesh.coordinates
    paths = []
    for v in stack.top:
        path = [v]
        while side(bottom, mesh.vertices[path[-1]]) != 0 and (
            lower := [w for w in neighbours[path[-1]] if at[w][1] < at[path[-1]][1]]
        ):
            path.append(_steepest(path[-1], lower, at))
        paths.append(tuple(path))
    return Descents(tuple(paths))


def _steepest(v: int, lower: Sequence[int], at: Sequence[Place]) -> int:
    """The neighbour downwards along the steepest edge, the left one of two as steep."""
    x, y = at[v]
    return min(lower, key=lambda w: (abs(at[w][0] - x) / (y - at[w][1]), at[w][0]))


def _neighbours(mesh: Mesh) -> dict[int, set[int]]:
    found: dict[int, set[int]] = defaultdict(set)
    for a, b, c in mesh.triangles:
        found[a] |= {b, c}
        found[b] |= {a, c}
        found[c] |= {a, b}
    return found


def triangle_on_rectangle(k: int) -> PlaneGraph:
    """A very skinny triangle on a rectangle with two close subdivision points (Figure 8).

    Section 4: "Height Omega(s) can be achieved only with a Steiner point x near the subdivision
    points; x cannot lie on the top side of the rectangle, as this decreases the feature size of
    the triangle to about 1/k.  So x must be interior to the rectangle, and then there must be
    a large angle (arbitrarily close to 180 as k grows)."

    Points: the rectangle (0, 0), (k, 0), (k + 1, 0), (k^2, 0), (k^2, 1), (0, 1), and the
    triangle's apex (k^2, 2).

    Parameters
    ----------
    k : int
        At least 2.
    """
    wide = k * k
    corners = [(0, 0), (k, 0), (k + 1, 0), (wide, 0), (wide, 1), (0, 1), (wide, 2)]
    edges = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0), (4, 6), (6, 5)]
    return PlaneGraph(
        "triangle on rectangle", tuple(hpoint(mpq(x), mpq(y)) for x, y in corners), tuple(edges)
    )


@dataclass(frozen=True)
class Dilemma:
    """What a triangulation of the skinny triangle on a rectangle pays with.

    Parameters
    ----------
    on_top : int
        Steiner points on the rectangle's top side, which is the triangle's base.
    least_height_squared : mpq
        Over all triangles.
    largest : Angle
        Over all triangles.
    """

    on_top: int
    least_height_squared: mpq
    largest: Angle


def dilemma(graph: PlaneGraph, mesh: Mesh) -> Dilemma:
    """Evaluate the paper's argument on a triangulation of `triangle_on_rectangle`.

    Parameters
    ----------
    graph : PlaneGraph
        The graph.
    mesh : Mesh
        Any triangulation of it, its points first.
    """
    new = mesh.coordinates[len(graph.points) :]
    corners = [tuple(mesh.vertices[v] for v in triangle) for triangle in mesh.triangles]
    return Dilemma(
        sum(y == 1 for _, y in new),
        min(squared_height(p, q, r) for p, q, r in corners),
        max(
            (largest_angle(p, q, r)[0] for p, q, r in corners),
            key=lambda angle: -angle.signed_square,
        ),
    )
