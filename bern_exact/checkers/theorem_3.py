"""Theorem 3: a polygon with holes in O(n^1.5) triangles without large angles."""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.boundary.records import Framed, MergedMesh
from bern_exact.checkers import bounds
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.no_large_angle import AngleJudgement, check_count, check_mesh
from bern_exact.exact.angle_bound import AngleBound
from bern_exact.plane.feature_size import FeatureSize
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon


def check_theorem_3(
    polygon: Polygon,
    mesh: Mesh,
    framed: Framed,
    feature: FeatureSize,
    verdict: AngleJudgement,
    merged: MergedMesh,
    *,
    tau: mpq,
    angle_bound: AngleBound,
) -> list[Finding]:
    """Check Theorem 3 on the finished mesh, in the input's coordinates.

    Parameters
    ----------
    polygon : Polygon
        P.
    mesh : Mesh
        The finished mesh, the vertices of P first.
    framed : Framed
        For the grid unit and the lopped corners.
    feature : FeatureSize
        s, certified by `definition_1`.
    verdict : AngleJudgement
        The judge's verdict on this mesh and P.
    merged : MergedMesh
        The part near the boundary.
    tau : mpq
        The snapping threshold in grid units.
    angle_bound : AngleBound
        The largest angle asked for.

    Notes
    -----
    Heights are measured here again, not taken from the verdict.  Linear time.
    """
    shape = framed.blocks
    edges = bounds.region_edges(bounds.lopped_vertices(1), shape)
    return [
        check_count(
            "theorem-3",
            mesh,
            polygon.n,
            f"the mesh has at most C n + 4 N^1.5 + 8 N triangles, N <= {edges} n (Lemma 8), "
            f"C = {bounds.boundary_and_fan_triangles(1, shape)} from the parts",
            bounds.theorem_3_triangles(polygon.n, shape),
        ),
        *check_mesh(
            "theorem-3",
            mesh,
            framed,
            feature,
            verdict,
            merged,
            tau=tau,
            angle_bound=angle_bound,
        ),
    ]
