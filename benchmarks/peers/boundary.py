"""A mesh's own boundary, and how far its vertices lie off the polygon's edges, exactly."""

from __future__ import annotations

from typing import NamedTuple

from gmpy2 import mpq

from bern_exact.exact.points import HPoint, coordinates
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon


class Followed(NamedTuple):
    """A mesh's boundary, followed along the polygon's edges.

    Parameters
    ----------
    rings : list of list of HPoint
        For each ring of the polygon the mesh's own, with the vertices that it has in addition.
    off : int
        How many of those lie off the edge that they are meant for.
    off_squared : mpq
        The largest distance of one of them from its edge's line, squared.
    """

    rings: list[list[HPoint]]
    off: int
    off_squared: mpq


def followed(mesh: Mesh, polygon: Polygon) -> Followed | None:
    """Follow a mesh's boundary from vertex to vertex of the polygon.

    Parameters
    ----------
    mesh : Mesh
        Any.
    polygon : Polygon
        What it should triangulate.

    Returns
    -------
    Followed or None
        None if the boundary does not run once along every edge of the polygon, from its tail to
        its head.

    Notes
    -----
    Linear.
    """
    ahead = _boundary(mesh)
    if ahead is None:
        return None
    corners = set(polygon.points)
    rings, off, worst = [], 0, mpq(0)
    for indices in polygon.rings:
        ring: list[HPoint] = []
        for tail in indices:
            p, q = polygon.points[tail], polygon.points[polygon.after[tail]]
            ring.append(p)
            vertex = ahead.pop(p, None)
            while vertex is not None and vertex not in corners:
                ring.append(vertex)
                squared = _squared_distance(vertex, p, q)
                if squared:
                    off, worst = off + 1, max(worst, squared)
                vertex = ahead.pop(vertex, None)
            if vertex != q:
                return None
        rings.append(ring)
    return None if ahead else Followed(rings, off, worst)


def _boundary(mesh: Mesh) -> dict[HPoint, HPoint] | None:
    """For each boundary vertex the next one; None if one has several."""
    directed = {
        (a, b) for t in mesh.triangles for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))
    }
    size = len(mesh.vertices)
    ahead: dict[HPoint, HPoint] = {}
    for a, b in sorted((a, b) for a, b in directed if (b, a) not in directed):
        if 0 <= a < size and 0 <= b < size:
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
