"""Thinning: Steiner vertices go one by one while the mesh's guarantees can spare them."""

from __future__ import annotations

from collections.abc import Collection
from heapq import heapify, heappop, heappush

from gmpy2 import mpq

from bern_exact.exact.angle_bound import AngleBound
from bern_exact.exact.errors import InputError
from bern_exact.exact.predicates import squared_height
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.thinning.grade import Grades
from bern_exact.thinning.holes import fill
from bern_exact.thinning.records import Thinned
from bern_exact.thinning.stars import Stars

MOST_TRIANGLES = (12, 24, 48)
"""The largest star that is tried, by round: time is cubic in it, and most large stars shrink
while others go."""


def thin(
    mesh: Mesh,
    polygon: Polygon,
    *,
    max_angle: AngleBound | None,
    thin_angle: AngleBound | None = None,
) -> Thinned:
    """Remove every Steiner vertex whose star can be triangulated without it just as well.

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
        A smaller bound for new triangles.  The mesh's largest angle falls to it as far as the
        triangles above it go, and never grows beyond the larger of the two.

    Raises
    ------
    InputError
        Kind `schema` if the polygon's vertices are not the mesh's first, `zero-area` if the mesh
        has a flat triangle or none at all.

    Notes
    -----
    A vertex inside P leaves its ring as a hole, one inside an edge of P the ring closed by that
    edge.  The hole is filled by its own vertices so that its lowest triangle is highest.
    Vertices with few triangles go first, ties by their number; when one goes, its neighbours
    are tried again.  In the end no star of at most 48 triangles can spare its vertex.

    The stars that are tried have bounded size, and so each removal brings back a bounded number
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
    bounds = [bound for bound in (max_angle, thin_angle) if bound is not None]
    stars = Stars(mesh.vertices, mesh.triangles)
    grades = Grades(mesh.vertices, bounds, _least_squared_height(mesh))
    waiting: Collection[int] = range(polygon.n, len(mesh.vertices))
    rounds = 0
    for most in MOST_TRIANGLES:
        if waiting:
            waiting = _round(stars, grades, polygon.n, waiting, most)
            rounds += 1
    thinned = _compact(stars, polygon.n)
    return Thinned(mesh, thinned, len(mesh.vertices) - len(thinned.vertices), rounds)


def _round(
    stars: Stars, grades: Grades, first: int, vertices: Collection[int], most: int
) -> Collection[int]:
    """Try these vertices and the neighbours of all that go.

    Parameters
    ----------
    stars, grades
        The triangulation, changed in place, and what new triangles keep.
    first : int
        The least vertex that may go.
    vertices : collection of int
        Those to be tried.
    most : int
        The most triangles of a star that is tried.

    Returns
    -------
    collection of int
        Those that have not been tried since their star changed: it is too large.
    """
    waiting = set(vertices)
    # An entry whose degree is out of date is not the vertex's last: it is passed over.
    queue = [(stars.degree(v), v) for v in vertices]
    heapify(queue)
    while queue:
        degree, vertex = heappop(queue)
        if vertex not in waiting or degree != stars.degree(vertex) or degree > most:
            continue
        waiting.discard(vertex)
        ring = stars.ring(vertex)
        triangles = None if ring is None else fill(ring, grades)
        if ring is None or triangles is None:
            continue
        stars.replace(vertex, triangles)
        for neighbour in ring:
            if neighbour >= first:
                waiting.add(neighbour)
                heappush(queue, (stars.degree(neighbour), neighbour))
    return waiting


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
