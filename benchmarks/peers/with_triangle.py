"""Triangle (J. R. Shewchuk), by the PyPI package `triangle`.

`-p` meshes a planar straight line graph, `-qA` refines until no angle is below A degrees but where
the input has one.  Steiner points may be put on the boundary.
"""

from __future__ import annotations

import triangle

from benchmarks.peers.doubles import points_in_holes, rings_of_doubles
from benchmarks.peers.floats import mesh_of_floats
from benchmarks.peers.meshers import Clock
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon


def pq15(polygon: Polygon, clock: Clock) -> Mesh:
    """No angle below 15 degrees."""
    return _mesh(polygon, clock, "pq15")


def pq20(polygon: Polygon, clock: Clock) -> Mesh:
    """No angle below 20 degrees, the default of `-q`."""
    return _mesh(polygon, clock, "pq20")


def _mesh(polygon: Polygon, clock: Clock, options: str) -> Mesh:
    points: list[tuple[float, float]] = []
    segments: list[tuple[int, int]] = []
    for ring in rings_of_doubles(polygon):
        first, n = len(points), len(ring)
        points += ring
        segments += [(first + i, first + (i + 1) % n) for i in range(n)]
    graph = {"vertices": points, "segments": segments}
    holes = points_in_holes(polygon)
    if holes:
        graph["holes"] = holes
    with clock:
        made = triangle.triangulate(graph, options)
    return mesh_of_floats(made["vertices"].tolist(), made["triangles"].tolist())
