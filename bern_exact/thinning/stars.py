"""The triangles of a mesh by their corners, so that a vertex can be taken out of them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from gmpy2 import mpq

from bern_exact.exact.points import HPoint, direction
from bern_exact.exact.predicates import cross, dot
from bern_exact.plane.mesh import Triangle
from bern_exact.thinning.holes import least_first


class Stars:
    """A triangulation that changes: for each vertex its star.

    Parameters
    ----------
    points : sequence of HPoint
        The vertices.
    triangles : iterable of (int, int, int)
        Counter-clockwise; a valid triangulation.

    Notes
    -----
    `links[v]` maps x to y for each triangle (v, x, y): the directed edges opposite v.  Every
    change takes constant time a triangle, and nothing depends on anything but the order of calls.

    Examples
    --------
    >>> from bern_exact.exact.points import hpoint
    >>> corners = [hpoint(0, 0), hpoint(3, 0), hpoint(0, 3), hpoint(1, 1)]
    >>> stars = Stars(corners, [(0, 1, 3), (1, 2, 3), (2, 0, 3)])
    >>> stars.ring(3), stars.ring(0)
    ([0, 1, 2], None)
    >>> stars.replace([3], [(0, 1, 2)])
    >>> stars.triangles()
    [(0, 1, 2)]
    """

    __slots__ = ("links", "points")

    def __init__(self, points: Sequence[HPoint], triangles: Iterable[Triangle]) -> None:
        self.points = points
        self.links: list[dict[int, int]] = [{} for _ in points]
        for triangle in triangles:
            self._add(triangle)

    def degree(self, vertex: int) -> int:
        """The number of triangles at a vertex."""
        return len(self.links[vertex])

    def triangles(self) -> list[Triangle]:
        """All triangles, each with its least vertex first, in lexicographic order."""
        return sorted(
            (v, x, y)
            for v, link in enumerate(self.links)
            for x, y in link.items()
            if v < x and v < y
        )

    def groups(self, vertex: int, size: int, first: int) -> list[tuple[int, ...]]:
        """The connected sets of `size` vertices with this one, all of them `first` or above.

        Each sorted; in lexicographic order.
        """
        found: set[tuple[int, ...]] = {(vertex,)}
        for _ in range(size - 1):
            found = {
                tuple(sorted((*group, other)))
                for group in found
                for v in group
                for other in self._neighbours(v)
                if other >= first and other not in group
            }
        return sorted(found)

    def _neighbours(self, vertex: int) -> set[int]:
        link = self.links[vertex]
        return {*link, *link.values()}

    def around(self, group: Sequence[int]) -> set[Triangle]:
        """The triangles at some vertices, each with its least vertex first."""
        found = set()
        for v in group:
            for x, y in self.links[v].items():
                found.add(least_first((v, x, y)))
        return found

    def ring(self, *group: int) -> list[int] | None:
        """The hole that these vertices would leave together: its ring, counter-clockwise.

        Where one of them lies inside a straight piece of the boundary, the ring is closed by that
        piece.  It is simple, as the boundary of a disc of triangles.  The least vertex is first.

        Returns
        -------
        list of int or None
            None if one is a corner of the boundary, or their triangles are no disc.
        """
        outline = self._outline(group)
        if not outline:
            return None
        ring = [min(outline)]
        while len(ring) <= len(outline):
            following = outline.get(ring[-1])
            if following is None or following == ring[0]:
                break
            ring.append(following)
        if len(ring) != len(outline):
            return None
        for vertex in group:
            if vertex in outline:
                i = ring.index(vertex)
                if not self._is_between(ring[i - 1], vertex, ring[i + 1 - len(ring)]):
                    return None
                del ring[i]
        first = ring.index(min(ring))
        return ring[first:] + ring[:first]

    def _outline(self, group: Sequence[int]) -> dict[int, int] | None:
        """The directed edges round the triangles at some vertices; None if two begin alike."""
        edges: list[tuple[int, int]] = []
        for v in group:
            link = self.links[v]
            ends = set(link.values())
            for x, y in link.items():
                # The edge opposite v is outside unless the triangle beyond it goes as well.
                if x not in group and y not in group and self.links[y].get(x) not in group:
                    edges.append((x, y))
                if x not in ends:
                    edges.append((v, x))
            edges += [(y, v) for y in link.values() if y not in link]
        outline = dict(edges)
        return outline if len(outline) == len(set(edges)) else None

    def replace(self, group: Sequence[int], triangles: Iterable[Triangle]) -> None:
        """Take vertices out and put these triangles where theirs were."""
        for a, b, c in self.around(group):
            del self.links[a][b]
            del self.links[b][c]
            del self.links[c][a]
        for triangle in triangles:
            self._add(triangle)

    def cotangent(self, triangle: Triangle) -> mpq:
        """Of the largest angle of a counter-clockwise triangle; it falls as the angle grows."""
        a, b, c = (self.points[v] for v in triangle)
        corners = (
            (direction(apex, after), direction(apex, before))
            for before, apex, after in ((c, a, b), (a, b, c), (b, c, a))
        )
        return min(mpq(dot(u, v), cross(u, v)) for u, v in corners)

    def _add(self, triangle: Triangle) -> None:
        a, b, c = triangle
        self.links[a][b] = c
        self.links[b][c] = a
        self.links[c][a] = b

    def _is_between(self, first: int, middle: int, last: int) -> bool:
        """Does the vertex in the middle lie strictly between the others?"""
        u = direction(self.points[middle], self.points[first])
        v = direction(self.points[middle], self.points[last])
        return cross(u, v) == 0 and dot(u, v) < 0
