"""Theorem 4: a convex polygon in O(n^1.848) triangles, none of them obtuse."""

from __future__ import annotations

from bern_exact.checkers import bounds_bounce as bounds
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.no_large_angle import AngleJudgement
from bern_exact.convex.records import Gridded
from bern_exact.exact.angles import ANGLE_90
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon

STAGE = "mesh"


def check_theorem_4(
    polygon: Polygon, mesh: Mesh, gridded: Gridded, verdict: AngleJudgement
) -> list[Finding]:
    """Check the finished mesh, in the input's coordinates.

    Parameters
    ----------
    polygon : Polygon
        P.
    mesh : Mesh
        The mesh, by Theorem 4 or its baseline.
    gridded : Gridded
        The grid that it refines or coarsens.
    verdict : AngleJudgement
        The judge's verdict on this mesh and P.
    """
    count, valid, corners = Extreme(greatest=True), Violations(), Violations()
    count.offer(len(mesh.triangles), 1, {"n": polygon.n})
    valid.case(verdict.valid, {"defects": len(verdict.defects)})
    corners.case(mesh.vertices[: polygon.n] == polygon.points, {"n": polygon.n})
    most = 2 * gridded.cells.number + sum(len(leg.triangles) for leg in gridded.legs)
    return [
        _check_angle(verdict),
        count.finding(
            "theorem-4.quadratic-count",
            STAGE,
            "the mesh has O(n^2) triangles: 9 n verticals, 18 n + 1 horizontals, all cells split",
            bounds.baseline_triangles(polygon.n),
        ),
        count.finding(
            "theorem-4.baseline-count",
            STAGE,
            "there are no more triangles than the O(n^2) algorithm makes on the same verticals",
            most,
        ),
        corners.finding(
            "theorem-4.vertices", STAGE, "the vertices of P come first, in the input's order"
        ),
        valid.finding(
            "theorem-4.valid", STAGE, "the mesh is a triangulation of P, as the judge finds"
        ),
    ]


def _check_angle(verdict: AngleJudgement) -> Finding:
    """No angle above 90 degrees: the least cosine is not negative."""
    angle = verdict.max_angle
    return Finding(
        "theorem-4.angle",
        STAGE,
        "no angle is obtuse (cos |cos|)",
        "guarantee",
        "0",
        None if angle is None else str(angle.signed_square),
        0 if angle is None else 1,
        angle is None or angle.is_at_most(ANGLE_90),
        None if angle is None else {"triangle": verdict.max_angle_triangle},
    )
