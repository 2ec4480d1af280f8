"""Meshes to be thinned, with their bounds."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from gmpy2 import mpq

from bern_exact import Polygon
from bern_exact.exact.angle_bound import AngleBound, parse_angle_bound
from bern_exact.exact.points import HPoint, along, hpoint
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems.theorem_1 import theorem_1
from bern_exact.theorems.theorem_2 import theorem_2
from bern_exact.theorems.theorem_3 import theorem_3

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
DEGREES_150 = parse_angle_bound("150")

SQUARE = polygon_from_rings([[hpoint(x, y) for x, y in ((0, 0), (4, 0), (4, 4), (0, 4))]])


def raw_mesh(polygon: Polygon, theorem: int) -> tuple[Mesh, AngleBound | None]:
    """A theorem's mesh and its bound on angles."""
    if theorem == 1:
        return theorem_1(polygon, check="none").assembled.mesh, None
    construct = theorem_3 if theorem == 3 or polygon.holes else theorem_2
    return construct(polygon, check="none").assembled.mesh, DEGREES_150


@cache
def example(name: str, theorem: int) -> tuple[Polygon, Mesh, AngleBound | None]:
    """An example's polygon, mesh and bound."""
    polygon = Polygon.load(EXAMPLES / f"{name}.json")
    return polygon, *raw_mesh(polygon, theorem)


def wheel(spokes: int, centre: HPoint | None = None) -> tuple[Polygon, Mesh]:
    """A square with further vertices on its edges, and all its triangles at one vertex inside."""
    corners = SQUARE.points
    ring: list[HPoint] = []
    for i, p in enumerate(corners):
        here = spokes // 4 + (i < spokes % 4)
        ring += [along(p, corners[(i + 1) % 4], mpq(k, here)) for k in range(here)]
    polygon = polygon_from_rings([ring])
    n = polygon.n
    triangles = tuple((i, (i + 1) % n, n) for i in range(n))
    return polygon, Mesh((*polygon.points, centre or hpoint(2, 2)), triangles)
