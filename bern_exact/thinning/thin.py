"""Thinning: Steiner vertices go while the mesh's guarantees can spare them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from heapq import heapify, heappop, heappush
from typing import NamedTuple

from gmpy2 import mpq

from bern_exact.exact.angle_bound import AngleBound
from bern_exact.exact.errors import InputError
from bern_exact.exact.predicates import squared_height
from bern_exact.plane.mesh import Mesh, Triangle
from bern_exact.plane.polygon import Polygon
from bern_exact.thinning.grade import ALIKE, AngleGrades, Grades
from bern_exact.thinning.holes import fill, least_first
from bern_exact.thinning.records import Thinned
from bern_exact.thinning.stars import Stars


class Try(NamedTuple):
    """One way to remove a vertex.

    Parameters
    ----------
    together : int
        How many vertices go at once: this one and neighbours of it.
    most : int
        The most sides of a hole that is filled: time is cubic in it.
    relaxed : bool
        May triangles with an angle above the one asked for be made where there were some?
    """

    together: int
    most: int
    relaxed: bool = False


ALONE = (Try(1, 12), Try(1, 24), Try(1, 48))
"""Most large stars shrink while others go."""

TOGETHER = (Try(2, 16), Try(3, 16))
"""Groups are tried of what is left."""


def _relaxed(tries: tuple[Try, ...]) -> tuple[Try, ...]:
    return tuple(way._replace(relaxed=True) for way in tries)


TRIES = ALONE + TOGETHER
"""Without an angle asked for, in this order."""

TRIES_FOR_ANGLE = ALONE + _relaxed(ALONE) + TOGETHER + _relaxed(TOGETHER)
"""With one."""


def thin(
    mesh: Mesh,
    polygon: Polygon,
    *,
    max_angle: AngleBound | None,
    thin_angle: AngleBound | None = None,
) -> Thinned:
    """Remove every Steiner vertex whose triangles can be replaced without it just as well.

    The guarantees of the mesh stay: it has fewer triangles, none of them is lower than its
    lowest was, and no angle is above `max_angle` if none was.

    Parameters
    ----------
    mesh : Mesh
        A triangulation of the polygon, the polygon's vertices first.
    polygon : Polygon
        Its vertices stay, 180-degree ones too.
    max_angle : AngleBound or None
        The mesh's own bound, which every new triangle keeps.
    thin_angle : AngleBound, optional
        A smaller bound for new triangles.  Only where there are triangles above it, and in the
        end, some are replaced by no more such triangles with angles no larger.

    Raises
    ------
    InputError
        Kind `schema` if the polygon's vertices are not the mesh's first, `zero-area` if the mesh
        has a flat triangle or none at all.

    Notes
    -----
    A vertex inside P leaves its ring as a hole, one inside an edge of P the ring closed by that
    edge; up to three neighbours leave one hole together.  The hole is filled by its own
    vertices so that its lowest triangle is highest.
    Vertices with few triangles go first, ties by their number; when one goes, its neighbours
    are tried again.  In the end no vertex can be spared by any way of `TRIES`.

    The holes have bounded size, and so each removal brings back a bounded number
    of vertices: a mesh of m triangles takes O(m log m) time.

    Examples
    --------
    >>> from bern_exact.exact.points import hpoint
    >>> from bern_exact.plane.validation import polygon_from_rings
    >>> square = polygon_from_rings([[hpoint(x, y) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))]])
    >>> split = Mesh((*square.points, hpoint(1, 1)), ((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)))
    >>> thin(split, square, max_angle=None).mesh.triangles
    ((0, 1, 3), (1, 2, 3))
    """
    if mesh.vertices[: polygon.n] != polygon.points:
        raise InputError("schema", "the polygon's vertices are not the first of the mesh")
    bounds = [] if max_angle is None else [max_angle]
    floor = _least_squared_height(mesh)
    by_angle = None
    if thin_angle is not None:
        by_angle = AngleGrades(mesh.vertices, bounds, floor, thin_angle)
        bounds = [*bounds, thin_angle]
    stars = Stars(mesh.vertices, mesh.triangles)
    grades = Grades(mesh.vertices, bounds, floor)
    _Thinning(stars, polygon.n, grades, by_angle).run(TRIES_FOR_ANGLE if by_angle else TRIES)
    thinned = _compact(stars, polygon.n)
    return Thinned(mesh, thinned, len(mesh.vertices) - len(thinned.vertices))


class _Thinning:
    """Tries to remove vertices until none can be spared.

    Parameters
    ----------
    stars : Stars
        The triangulation, changed in place.
    first : int
        The least vertex that may go.
    grades : Grades
        What new triangles keep.
    by_angle : AngleGrades or None
        What they keep in a relaxed try.
    """

    def __init__(
        self, stars: Stars, first: int, grades: Grades, by_angle: AngleGrades | None
    ) -> None:
        self.stars = stars
        self.first = first
        self.grades = grades
        self.by_angle = by_angle
        # The next try of each vertex that has one left.
        self.upcoming: dict[int, int] = {}

    def run(self, tries: tuple[Try, ...]) -> None:
        """Try each vertex in every way, again from the first when a neighbour has gone."""
        stars, upcoming = self.stars, self.upcoming
        upcoming.update({v: 0 for v in range(self.first, len(stars.points)) if stars.degree(v)})
        # An entry that is out of date is passed over.
        queue = [(0, stars.degree(v), v) for v in upcoming]
        heapify(queue)
        while queue:
            number, degree, vertex = heappop(queue)
            if upcoming.get(vertex) != number or degree != stars.degree(vertex):
                continue
            found = self._filled(vertex, number, tries[number])
            if found is None:
                if number + 1 == len(tries):
                    del upcoming[vertex]
                    continue
                upcoming[vertex] = number + 1
                heappush(queue, (number + 1, degree, vertex))
                continue
            group, triangles = found
            stars.replace(group, triangles)
            for v in group:
                upcoming.pop(v, None)
            for v in sorted({v for triangle in triangles for v in triangle if v >= self.first}):
                upcoming[v] = 0
                heappush(queue, (0, stars.degree(v), v))

    def _filled(
        self, vertex: int, number: int, way: Try
    ) -> tuple[tuple[int, ...], list[Triangle]] | None:
        """The first group with this vertex that can go in this way, and what takes its place."""
        for group, ring in self._holes(vertex, number, way):
            triangles = self._no_worse(group, ring) if way.relaxed else fill(ring, self.grades)
            if triangles is not None:
                return group, triangles
        return None

    def _holes(
        self, vertex: int, number: int, way: Try
    ) -> Iterator[tuple[tuple[int, ...], list[int]]]:
        """The groups that could go, and the holes that they would leave.

        A group is tried once since it last changed: by the last of its vertices to come so far.
        """
        if self.stars.degree(vertex) > way.most + way.together:
            return
        for group in self.stars.groups(vertex, way.together, self.first):
            if any(v != vertex and self.upcoming.get(v, number + 1) <= number for v in group):
                continue
            ring = self.stars.ring(*group)
            if ring is not None and len(ring) <= way.most:
                yield group, ring

    def _no_worse(self, group: tuple[int, ...], ring: list[int]) -> list[Triangle] | None:
        """Triangles with no larger angle than the largest that goes, nor more above the one asked.

        None if none that go are above the angle asked for: then there is nothing to relax.
        """
        grades = self.by_angle
        old = self.stars.around(group)
        most = 0 if grades is None else _above(grades, old)
        if grades is None or not most:
            return None
        new = fill(ring, grades)
        if new is None or _above(grades, new) > most:
            return None
        worst, before = (
            min(self.stars.cotangent(t) for t in triangles) for triangles in (new, old)
        )
        return new if worst >= before else None


def _above(grades: AngleGrades, triangles: Iterable[Triangle]) -> int:
    """How many triangles have an angle above the one asked for."""
    return sum(1 for triangle in triangles if grades.of(*least_first(triangle)) < ALIKE)


def _compact(stars: Stars, kept: int) -> Mesh:
    """The mesh of the vertices that are left, in their old order; the first `kept` all stay."""
    left = [v for v in range(len(stars.points)) if v < kept or stars.degree(v)]
    number = {v: i for i, v in enumerate(left)}
    triangles = [(number[a], number[b], number[c]) for a, b, c in stars.triangles()]
    return Mesh(tuple(stars.points[v] for v in left), tuple(triangles))


def _least_squared_height(mesh: Mesh) -> mpq:
    """The least squared height of a triangle."""
    points = mesh.vertices
    heights = [squared_height(points[a], points[b], points[c]) for a, b, c in mesh.triangles]
    least = min(heights, default=mpq(0))
    if least == 0:
        raise InputError("zero-area", "the mesh has a flat triangle, or no triangle at all")
    return least
