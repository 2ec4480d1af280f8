"""A valid mesh before it is damaged: what lies where, and choices from a seed."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property
from random import Random
from typing import TypeVar

from gmpy2 import mpq

from bern_exact.exact.points import HPoint, along, coordinates, hpoint
from bern_exact.exact.predicates import compare_xy, orientation
from bern_exact.plane.mesh import Mesh, Triangle
from bern_exact.plane.polygon import Polygon

Edge = tuple[int, int]
T = TypeVar("T")

TINY = mpq(1, 10**40)
"""How far vertices are moved, in lengths of an edge beside them."""


class Sound:
    """A valid mesh, its edges and its boundary.

    Parameters
    ----------
    mesh : Mesh
        A triangulation of the polygon, or without one of what its boundary encloses.
    polygon : Polygon or None
        The polygon.
    random : Random, optional
        Decides between equals.  Integers alone are drawn from it.
    """

    def __init__(self, mesh: Mesh, polygon: Polygon | None, random: Random | None = None) -> None:
        self.vertices, self.triangles = mesh.vertices, mesh.triangles
        self.polygon = polygon
        self.random = random or Random(0)
        self.owner: dict[Edge, int] = {}
        self.at: list[list[int]] = [[] for _ in mesh.vertices]
        for t, (a, b, c) in enumerate(mesh.triangles):
            for edge in ((a, b), (b, c), (c, a)):
                self.owner[edge] = t
                self.at[edge[0]].append(t)
        self.sides = [(a, b) for a, b in self.owner if (b, a) not in self.owner]

    # What lies where -------------------------------------------------------------

    @cached_property
    def boundary(self) -> frozenset[int]:
        """The vertices on the boundary."""
        return frozenset(a for a, _ in self.sides)

    @cached_property
    def ahead(self) -> dict[int, int]:
        """For each boundary vertex the next one, interior on the left."""
        return dict(self.sides)

    @cached_property
    def corners(self) -> dict[int, int]:
        """For each vertex that is one of the polygon's, in its order, the number there."""
        if self.polygon is None:
            return {}
        number = {p: v for v, p in enumerate(self.vertices)}
        return {number[p]: i for i, p in enumerate(self.polygon.points)}

    @cached_property
    def polygon_edge(self) -> dict[Edge, int]:
        """For each side the polygon's edge on which it lies."""
        found = {}
        for v, i in self.corners.items():
            tail, head = v, self.ahead[v]
            found[tail, head] = i
            while head not in self.corners:
                tail, head = head, self.ahead[head]
                found[tail, head] = i
        return found

    def sides_of(self, *, outer: bool) -> list[Edge]:
        """The sides along the outer ring, or along the holes; without a polygon none."""
        if self.polygon is None:
            return []
        ring_of = self.polygon.ring_of
        return [side for side, i in self.polygon_edge.items() if (ring_of[i] == 0) == outer]

    @property
    def inner_edges(self) -> list[Edge]:
        """The edges between two triangles, in both directions."""
        return [(a, b) for a, b in self.owner if (b, a) in self.owner]

    def apex(self, a: int, b: int) -> int:
        """The third corner of the triangle on the left of ab."""
        return next(v for v in self.triangles[self.owner[a, b]] if v not in (a, b))

    def turn(self, a: int, b: int, c: int) -> int:
        """1 if three vertices turn left, -1 right, 0 neither."""
        return orientation(self.vertices[a], self.vertices[b], self.vertices[c])

    # Choices ---------------------------------------------------------------------

    def shuffled(self, items: Iterable[T]) -> list[T]:
        """The items in some order."""
        order = list(items)
        self.random.shuffle(order)
        return order

    def some(self, items: Sequence[T]) -> T | None:
        """One of the items, or None if there are none."""
        return items[self.random.randrange(len(items))] if items else None

    # Other meshes ----------------------------------------------------------------

    def mesh(
        self,
        *,
        moved: dict[int, HPoint] | None = None,
        added: Iterable[HPoint] = (),
        replaced: dict[int, Triangle] | None = None,
        more: Iterable[Triangle] = (),
    ) -> Mesh:
        """This mesh with vertices moved or added and triangles replaced or added."""
        vertices, triangles = list(self.vertices), list(self.triangles)
        for v, p in (moved or {}).items():
            vertices[v] = p
        for t, corners in (replaced or {}).items():
            triangles[t] = corners
        return Mesh((*vertices, *added), (*triangles, *more))

    def other(self, mesh: Mesh) -> Sound:
        """Another valid mesh of the same polygon."""
        return Sound(mesh, self.polygon, self.random)

    def with_edge_split(self, a: int, b: int, t: mpq) -> Sound:
        """A new vertex on an edge, its triangles split; it is the last vertex."""
        new = len(self.vertices)
        replaced, more = {}, []
        for tail, head in ((a, b), (b, a)):
            if (tail, head) in self.owner:
                apex = self.apex(tail, head)
                replaced[self.owner[tail, head]] = (tail, new, apex)
                more.append((new, head, apex))
        point = along(self.vertices[a], self.vertices[b], t)
        return self.other(self.mesh(added=[point], replaced=replaced, more=more))

    def with_triangle_split(self, t: int, weights: tuple[int, int, int] = (3, 4, 5)) -> Sound:
        """A new vertex inside a triangle, joined to its corners; it is the last vertex."""
        a, b, c = self.triangles[t]
        new = len(self.vertices)
        mesh = self.mesh(
            added=[self.inside(t, weights)],
            replaced={t: (a, b, new)},
            more=[(b, c, new), (c, a, new)],
        )
        return self.other(mesh)

    def with_edge_flipped(self, a: int, b: int) -> Mesh | None:
        """Edge ab exchanged for the other diagonal, if its quadrilateral is strictly convex."""
        if (a, b) not in self.owner or (b, a) not in self.owner:
            return None
        c, d = self.apex(a, b), self.apex(b, a)
        if self.turn(a, d, c) <= 0 or self.turn(b, c, d) <= 0:
            return None
        return self.mesh(replaced={self.owner[a, b]: (a, d, c), self.owner[b, a]: (d, b, c)})

    def with_inner_vertex(self) -> Sound:
        """This mesh if it has a vertex inside, or else one with a triangle split."""
        if len(self.boundary) < len(self.vertices):
            return self
        return self.with_triangle_split(self.random.randrange(len(self.triangles)))

    def with_vertex_on_edge(self) -> tuple[Sound, int]:
        """This mesh and a vertex inside an edge of the polygon, made if there is none."""
        found = self.some([v for v, _ in self.polygon_edge if v not in self.corners])
        if found is not None:
            return self, found
        a, b = self.sides[self.random.randrange(len(self.sides))]
        return self.with_edge_split(a, b, mpq(1, 2)), len(self.vertices)

    # Points ----------------------------------------------------------------------

    def inside(self, t: int, weights: tuple[int, int, int] = (3, 4, 5)) -> HPoint:
        """A point inside a triangle, by its barycentric weights."""
        corners = [coordinates(self.vertices[v]) for v in self.triangles[t]]
        total = sum(weights)
        x = sum(w * p[0] for w, p in zip(weights, corners, strict=True)) / mpq(total)
        y = sum(w * p[1] for w, p in zip(weights, corners, strict=True)) / mpq(total)
        return hpoint(x, y)

    def normal(self, a: int, b: int) -> tuple[mpq, mpq]:
        """The vector ab turned left: into the triangle on its left."""
        (px, py), (qx, qy) = coordinates(self.vertices[a]), coordinates(self.vertices[b])
        return py - qy, qx - px

    def stays(self, v: int, p: HPoint) -> bool:
        """Do all triangles at v stay counter-clockwise if it is moved to p?"""
        place = {v: p}
        return all(
            orientation(*(place.get(u, self.vertices[u]) for u in self.triangles[t])) > 0
            for t in self.at[v]
        )

    def nudged(self, v: int, step: tuple[mpq, mpq]) -> HPoint:
        """Vertex v moved by a tiny part of a vector, its triangles still counter-clockwise."""
        size = TINY
        while not self.stays(v, shifted(self.vertices[v], step, size)):
            size *= TINY
        return shifted(self.vertices[v], step, size)

    def is_free(self, corners: Sequence[HPoint]) -> bool:
        """Does the boundary not meet this triangle but in its corners and edges?  Linear."""
        edges = [(corners[i - 1], corners[i]) for i in range(3)]
        for a, b in self.sides:
            p, q = self.vertices[a], self.vertices[b]
            if p in corners and q in corners:
                continue
            if p not in corners and all(orientation(u, w, p) >= 0 for u, w in edges):
                return False
            if any(
                p not in (u, w) and q not in (u, w) and segments_meet(p, q, u, w) for u, w in edges
            ):
                return False
        return True


def shifted(p: HPoint, step: tuple[mpq, mpq], size: mpq) -> HPoint:
    """The point p + size step."""
    x, y = coordinates(p)
    return hpoint(x + size * step[0], y + size * step[1])


def segments_meet(p: HPoint, q: HPoint, u: HPoint, w: HPoint) -> bool:
    """Have two closed segments a point in common?"""
    turns = orientation(p, q, u), orientation(p, q, w), orientation(u, w, p), orientation(u, w, q)
    if turns[0] * turns[1] < 0 and turns[2] * turns[3] < 0:
        return True
    ends = ((u, p, q), (w, p, q), (p, u, w), (q, u, w))
    return any(
        turn == 0 and compare_xy(end, a) * compare_xy(end, b) <= 0
        for turn, (end, a, b) in zip(turns, ends, strict=True)
    )
