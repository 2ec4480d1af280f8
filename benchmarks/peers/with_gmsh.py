"""Gmsh (C. Geuzaine and J.-F. Remacle), by the PyPI package `gmsh`.

Its 2-D meshers keep every edge of the boundary unless a size asks for shorter ones, and promise
sizes, not angles.
"""

from __future__ import annotations

import gmsh

from benchmarks.peers.doubles import rings_of_doubles
from benchmarks.peers.floats import mesh_of_floats
from benchmarks.peers.meshers import Clock
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon

DELAUNAY = 5
"""Of `Mesh.Algorithm`."""

TRIANGLE = 2
"""Of element types."""


def coarse(polygon: Polygon, clock: Clock) -> Mesh:
    """No size anywhere: as coarse as it can be."""
    return _mesh(polygon, clock, extend=0)


def graded(polygon: Polygon, clock: Clock) -> Mesh:
    """Sizes inside extended from the lengths of the boundary's edges."""
    return _mesh(polygon, clock, extend=1)


def _mesh(polygon: Polygon, clock: Clock, *, extend: int) -> Mesh:
    gmsh.initialize(interruptible=False)
    for option, value in (
        ("General.Terminal", 0),
        ("General.NumThreads", 1),
        ("Mesh.Algorithm", DELAUNAY),
        ("Mesh.MeshSizeFromPoints", 0),
        ("Mesh.MeshSizeExtendFromBoundary", extend),
    ):
        gmsh.option.setNumber(option, value)
    shape = gmsh.model.geo
    loops = []
    for ring in rings_of_doubles(polygon):
        points = [shape.addPoint(x, y, 0) for x, y in ring]
        lines = [shape.addLine(points[i - 1], points[i]) for i in range(len(points))]
        loops.append(shape.addCurveLoop(lines))
    shape.addPlaneSurface(loops)
    shape.synchronize()
    with clock:
        gmsh.model.mesh.generate(2)
    tags, flat, _ = gmsh.model.mesh.getNodes()
    kinds, _, corners = gmsh.model.mesh.getElements(2)
    gmsh.finalize()
    number = {int(tag): i for i, tag in enumerate(tags)}
    at = list(map(int, kinds)).index(TRIANGLE)
    triangles = [[number[int(v)] for v in three] for three in corners[at].reshape(-1, 3)]
    return mesh_of_floats(flat.reshape(-1, 3)[:, :2].tolist(), triangles)
