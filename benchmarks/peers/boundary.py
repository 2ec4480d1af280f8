"""How far a mesh's boundary vertices lie off the polygon's edges, exactly."""

from __future__ import annotations

from typing import NamedTuple

from gmpy2 import mpq

from bern_exact.exact.points import HPoint, coordinates
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon


class Off(NamedTuple):
    """How many boundary vertices lie on the edge that they are meant for, and how far off."""

    vertices: int
    worst_squared: mpq


def off_the_edges(mesh: Mesh, polygon: Polygon) -> Off | None:
    """The boundary vertices off their edges: those between two of the polygon's vertices.

    Parameters
    ----------
    mesh : Mesh
        Any; its boundary is followed from vertex to vertex of the polygon.
    polygon : Polygon
        What it should triangulate.

    Returns
    -------
    Off or None
        None if the boundary does not run once along every edge of the polygon.

    Notes
    -----
    Linear.  Distances are from the edges' lines.
    """
    ahead = _boundary(mesh)
    if ahead is None:
        return None
    corners = set(polygon.points)
    count, worst = 0, mpq(0)
    for tail, head in polygon.edges():
        p, q = polygon.points[tail], polygon.points[head]
        vertex = ahead.pop(p, None)
        while vertex is not None and vertex not in corners:
            squared = _squared_distance(vertex, p, q)
            if squared:
                count, worst = count + 1, max(worst, squared)
            vertex = ahead.pop(vertex, None)
        if vertex != q:
            return None
    return None if ahead else Off(count, worst)


def _boundary(mesh: Mesh) -> dict[HPoint, HPoint] | None:
    """For each boundary vertex the next one; None if one has several."""
    directed = {
        (a, b) for t in mesh.triangles for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))
    }
    size = len(mesh.vertices)
    ahead: dict[HPoint, HPoint] = {}
    for a, b in sorted(directed):
        if (b, a) not in directed and 0 <= a < size and 0 <= b < size:
            if mesh.vertices[a] in ahead:
                return None
            ahead[mesh.vertices[a]] = mesh.vertices[b]
    return ahead


def _squared_distance(point: HPoint, p: HPoint, q: HPoint) -> mpq:
    """The squared distance of a point from the line pq."""
    (x, y), (px, py), (qx, qy) = map(coordinates, (point, p, q))
    ux, uy = qx - px, qy - py
    cross = ux * (y - py) - uy * (x - px)
    return cross * cross / (ux * ux + uy * uy)
