"""CGAL's 2-D mesher (L. Rineau), by the PyPI package `cgal`.

`Delaunay_mesh_size_criteria_2(b, 0)` asks for a circumradius of at most sqrt(1/(4 b)) shortest
edges, which is no angle below arcsin(sqrt b), and for no size.  Steiner points may be put on the
boundary.
"""

from __future__ import annotations

from CGAL import CGAL_Mesh_2
from CGAL.CGAL_Kernel import Point_2
from CGAL.CGAL_Mesh_2 import Delaunay_mesh_size_criteria_2 as Criteria
from CGAL.CGAL_Mesh_2 import Mesh_2_Constrained_Delaunay_triangulation_2 as Triangulation

from benchmarks.peers.doubles import points_in_holes, rings_of_doubles
from benchmarks.peers.floats import mesh_of_floats
from benchmarks.peers.meshers import Clock
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon

SIN_SQUARED_15 = 0.0669872981077807


def least_15(polygon: Polygon, clock: Clock) -> Mesh:
    """No angle below 15 degrees."""
    return _mesh(polygon, clock, SIN_SQUARED_15)


def least_20(polygon: Polygon, clock: Clock) -> Mesh:
    """No angle below 20.7 degrees, the default, and the most with a guarantee to end."""
    return _mesh(polygon, clock, 0.125)


def _mesh(polygon: Polygon, clock: Clock, bound: float) -> Mesh:
    rings = [[Point_2(x, y) for x, y in ring] for ring in rings_of_doubles(polygon)]
    seeds = [Point_2(x, y) for x, y in points_in_holes(polygon)]
    with clock:
        made = Triangulation()
        for ring in rings:
            corners = [made.insert(point) for point in ring]
            for i, corner in enumerate(corners):
                made.insert_constraint(corners[i - 1], corner)
        if seeds:  # what holds a seed is not meshed
            CGAL_Mesh_2.refine_Delaunay_mesh_2(made, seeds, Criteria(bound, 0), False)
        else:
            CGAL_Mesh_2.refine_Delaunay_mesh_2(made, Criteria(bound, 0))
    number: dict[tuple[float, float], int] = {}
    triangles = []
    for face in made.finite_faces():
        if face.is_in_domain():
            points = (face.vertex(i).point() for i in range(3))
            triangles.append([number.setdefault((p.x(), p.y()), len(number)) for p in points])
    return mesh_of_floats(list(number), triangles)
