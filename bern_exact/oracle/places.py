"""Where the places that defects name lie in the plane."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from bern_exact.exact.points import HPoint
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon


def points_of(where: Mapping[str, Any], mesh: Mesh, polygon: Polygon | None) -> list[HPoint]:
    """The points of a defect's place.

    Parameters
    ----------
    where : mapping
        As `Defect.where`.
    mesh, polygon
        What was judged.

    Returns
    -------
    list of HPoint
        The corners of a triangle as far as there are such vertices, the ends of an edge, one
        vertex, or nothing for the mesh as a whole.

    Examples
    --------
    >>> from bern_exact.exact.points import hpoint
    >>> mesh = Mesh((hpoint(0, 0), hpoint(1, 0), hpoint(0, 1)), ((0, 1, 2), (0, 1, 7)))
    >>> len(points_of({"triangle": 1}, mesh, None)), len(points_of({"edge": [1, 2]}, mesh, None))
    (2, 2)
    """
    for key in ("vertex", "edge", "triangle"):
        if key in where:
            indices = mesh.triangles[where[key]] if key == "triangle" else where[key]
            indices = [indices] if key == "vertex" else indices
            return [mesh.vertices[v] for v in indices if 0 <= v < len(mesh.vertices)]
    if polygon is not None and "polygon_vertex" in where:
        r, i = where["polygon_vertex"]
        return [polygon.input_ring(r)[i]]
    if polygon is not None and "polygon_edge" in where:
        r, i = where["polygon_edge"]
        ring = polygon.input_ring(r)
        return [ring[i], ring[(i + 1) % len(ring)]]
    return []
