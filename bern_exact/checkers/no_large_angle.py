"""What Theorems 2 and 3 claim alike of the finished mesh: angle, height, validity."""

from __future__ import annotations

from typing import Protocol

from gmpy2 import mpq

from bern_exact.boundary.records import BlockShape, Framed, MergedMesh
from bern_exact.checkers import bounds
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Exact, Finding
from bern_exact.checkers.places import cotangents
from bern_exact.checkers.theorem_1 import Judgement, least_height, relative
from bern_exact.exact.angle_bound import AngleBound
from bern_exact.exact.angles import Angle
from bern_exact.plane.feature_size import FeatureSize
from bern_exact.plane.mesh import Mesh

STAGE = "mesh"


class AngleJudgement(Judgement, Protocol):
    """What is read of the judge's verdict."""

    @property
    def max_angle(self) -> Angle | None:
        """The largest angle of the mesh; None if no triangle has area."""

    @property
    def max_angle_triangle(self) -> int | None:
        """A triangle that has it."""


def check_mesh(
    theorem: str,
    mesh: Mesh,
    framed: Framed,
    feature: FeatureSize,
    verdict: AngleJudgement,
    merged: MergedMesh,
    *,
    tau: mpq,
    angle_bound: AngleBound,
) -> list[Finding]:
    """The claims but for the number of triangles.

    Parameters
    ----------
    theorem : str
        The claims' place, `theorem-2` or `theorem-3`.
    mesh, framed, feature, verdict, merged, tau, angle_bound
        As in `check_theorem_2`.
    """
    valid = Violations()
    valid.case(verdict.valid, {"defects": len(verdict.defects)})
    return [
        *_check_angle(theorem, verdict, tau, angle_bound),
        *_check_triangles(theorem, mesh, framed, feature, tau),
        _check_boundary_count(theorem, merged, framed.blocks),
        valid.finding(
            f"{theorem}.valid", STAGE, "the mesh is a triangulation of P, as the judge finds"
        ),
    ]


def check_count(theorem: str, mesh: Mesh, n: int, statement: str, bound: int) -> Finding:
    """The number of triangles, for n vertices of P, against the theorem's bound."""
    most = Extreme(greatest=True)
    most.offer(len(mesh.triangles), 1, {"n": n})
    return most.finding(f"{theorem}.count", STAGE, statement, bound)


def by_threshold(tau: mpq) -> Angle:
    """135 degrees + arctan(2 tau).

    >>> by_threshold(mpq(1, 8))
    Angle(cos_sign=-1, cos_squared=mpq(25,34))
    """
    squared = bounds.boundary_cotangent(tau) ** 2
    return Angle(-1, squared / (1 + squared))


def _check_angle(
    theorem: str, verdict: AngleJudgement, tau: mpq, asked: AngleBound
) -> list[Finding]:
    """The largest angle against the bound asked for, and against what tau promises."""
    angle = verdict.max_angle
    promised = by_threshold(tau)
    low, high = asked.enclosure()
    exactly: Exact = str(low) if low == high else {"lower": str(low), "upper": str(high)}

    def finding(claim: str, statement: str, bound: Exact, holds: bool) -> Finding:
        return Finding(
            f"{theorem}.{claim}",
            STAGE,
            statement,
            "guarantee",
            bound,
            None if angle is None else str(angle.signed_square),
            0 if angle is None else 1,
            holds,
            None if angle is None else {"triangle": verdict.max_angle_triangle},
        )

    return [
        finding(
            "angle",
            "no angle is above the bound asked for, 150 degrees if nothing was (cos |cos|)",
            exactly,
            angle is None or asked.admits(angle),
        ),
        finding(
            "threshold-angle",
            "no angle is above 135 degrees + arctan(2 tau) (cos |cos|)",
            str(promised.signed_square),
            angle is None or angle.is_at_most(promised),
        ),
    ]


def _check_triangles(
    theorem: str, mesh: Mesh, framed: Framed, feature: FeatureSize, tau: mpq
) -> list[Finding]:
    """Heights, and the angles of the fans: the triangles at lopped corners, which P' has not."""
    corners = {cut.corner for cut in framed.lopped.cuts}
    height, fan_angle = least_height(mesh), Extreme()
    for i, triangle in enumerate(mesh.triangles):
        if not corners.isdisjoint(triangle):
            p, q, r = (mesh.vertices[v] for v in triangle)
            for num, den in cotangents(p, q, r):
                fan_angle.offer(num, den, {"triangle": i, "vertices": triangle})
    return [
        fan_angle.finding(
            f"{theorem}.fan-angle",
            STAGE,
            "the fans of lopped corners have no angle above 135 degrees (least cotangent)",
            bounds.BLOCK_COTANGENT,
        ),
        height.finding(
            f"{theorem}.grid-height",
            STAGE,
            "every triangle has height at least tau b/2 (squared, in the input's units)",
            bounds.merged_height_squared(tau) * framed.unit**2,
        ),
        relative(height, feature.squared).finding(
            f"{theorem}.height",
            STAGE,
            f"the least height is at least tau s/{6 * framed.factor} up to the rounding of cuts "
            "and grid unit, s being an upper bound for every triangulation ((height/s)^2)",
            bounds.theorem_2_height_squared(tau, framed.factor),
        ),
    ]


def _check_boundary_count(theorem: str, merged: MergedMesh, shape: BlockShape) -> Finding:
    """The triangles near the boundary, before the interior's are counted."""
    lopped = merged.warped.traced.diced.framed.polygon.n
    most = Extreme(greatest=True)
    triangles = sum(len(face.triangles) for face in merged.faces) + sum(
        len(found) for item in merged.projected for _, found in item.pieces
    )
    most.offer(triangles, 1, {"vertices of P'": lopped})
    return most.finding(
        f"{theorem}.boundary-count",
        STAGE,
        "there are O(n) triangles near the boundary: merging and projecting at most doubles the "
        f"{bounds.touched_triangles(bounds.lopped_vertices(1), shape)} n of Section 2",
        bounds.merged_triangles(lopped, shape),
    )
