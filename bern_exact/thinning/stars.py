"""The triangles of a mesh by their corners, so that a vertex can be taken out of them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from bern_exact.exact.points import HPoint, direction
from bern_exact.exact.predicates import cross, dot
from bern_exact.plane.mesh import Triangle


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
    >>> stars.replace(3, [(0, 1, 2)])
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

    def ring(self, vertex: int) -> list[int] | None:
        """The hole that a vertex would leave: its ring, counter-clockwise.

        The ring of a vertex inside a straight piece of the boundary is closed by that piece.  It
        is simple: every vertex of it is seen from the one that goes, each in a direction of its
        own.  The least vertex is first.

        Returns
        -------
        list of int or None
            None if the vertex is a corner of the boundary or its star is not in one piece.
        """
        link = self.links[vertex]
        last = set(link.values())
        starts = [x for x in link if x not in last]
        if len(starts) > 1 or not link:
            return None
        chain = [starts[0] if starts else min(link)]
        while len(chain) <= len(link):
            following = link.get(chain[-1])
            if following is None or following == chain[0]:
                break
            chain.append(following)
        if len(chain) != len(link) + len(starts):
            return None
        if starts and not self._is_between(chain[-1], vertex, chain[0]):
            return None
        first = chain.index(min(chain))
        return chain[first:] + chain[:first]

    def replace(self, vertex: int, triangles: Iterable[Triangle]) -> None:
        """Take a vertex out and put these triangles where its star was."""
        for x, y in self.links[vertex].items():
            del self.links[x][y]
            del self.links[y][vertex]
        self.links[vertex] = {}
        for triangle in triangles:
            self._add(triangle)

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
