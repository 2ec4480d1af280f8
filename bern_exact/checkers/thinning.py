"""Thinning loses no guarantee: fewer triangles, no lower, no angle above the bound, still of P."""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Exact, Finding
from bern_exact.checkers.places import cotangent
from bern_exact.checkers.theorem_1 import Judgement, least_height
from bern_exact.exact.angle_bound import AngleBound
from bern_exact.exact.angles import ANGLE_180, Angle
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.thinning.records import Thinned

STAGE = "thinned"


def check_thinning(
    thinned: Thinned,
    polygon: Polygon,
    verdict: Judgement,
    *,
    max_angle: AngleBound | None,
    thin_angle: AngleBound | None = None,
) -> list[Finding]:
    """Check a thinned mesh against the raw one.

    Parameters
    ----------
    thinned : Thinned
        Both meshes.
    polygon : Polygon
        P.
    verdict : Judgement
        The judge's verdict on the thinned mesh and P.
    max_angle : AngleBound or None
        The raw mesh's own bound.
    thin_angle : AngleBound, optional
        The smaller bound that was asked for.

    Notes
    -----
    Heights and angles are measured here again.  Linear time.
    """
    raw, mesh = thinned.raw, thinned.mesh
    valid, count = Violations(), Extreme(greatest=True)
    valid.case(verdict.valid, {"defects": len(verdict.defects)})
    count.offer(len(mesh.triangles), 1, {"removed": thinned.removed})
    findings = [
        valid.finding(
            "thinning.valid", STAGE, "the mesh is a triangulation of P, as the judge finds"
        ),
        count.finding(
            "thinning.count",
            STAGE,
            "there are no more triangles than in the raw mesh",
            len(raw.triangles),
        ),
        least_height(mesh).finding(
            "thinning.height",
            STAGE,
            "no triangle is lower than the lowest of the raw mesh (squared)",
            least_height(raw).value or mpq(0),
        ),
        _check_vertices(thinned, polygon),
    ]
    if max_angle is not None:
        findings.append(_check_angle(mesh, max_angle))
    if thin_angle is not None:
        findings += _check_asked(thinned, thin_angle)
    return findings


def _check_vertices(thinned: Thinned, polygon: Polygon) -> Finding:
    """P's vertices first, the others some of the raw mesh's in their order."""
    raw, mesh = thinned.raw.vertices, thinned.mesh.vertices
    broken = Violations()
    for v, p in enumerate(polygon.points):
        broken.case(v < len(mesh) and mesh[v] == p, {"vertex": v})
    place = {p: i for i, p in enumerate(raw)}
    before = -1
    for v, p in enumerate(mesh):
        at = place.get(p, -1)
        broken.case(at > before, {"vertex": v})
        before = max(before, at)
    broken.case(len(mesh) + thinned.removed == len(raw), {"removed": thinned.removed})
    return broken.finding(
        "thinning.vertices",
        STAGE,
        "the vertices are P's and then some of the raw mesh's, in its order",
    )


def _check_asked(thinned: Thinned, asked: AngleBound) -> list[Finding]:
    """No more triangles above the angle asked for, and no angle above it that is larger."""
    above, largest = Extreme(greatest=True), Violations()
    before, after = (_angles_above(mesh, asked) for mesh in (thinned.raw, thinned.mesh))
    above.offer(len(after), 1, {"triangles": sorted(after)})
    least = min(before.values(), default=None)
    for t, cosine in after.items():
        largest.case(least is not None and cosine >= least, {"triangle": t})
    return [
        above.finding(
            "thinning.above-asked",
            STAGE,
            "no more triangles than in the raw mesh have an angle above the one asked for",
            len(before),
        ),
        largest.finding(
            "thinning.asked-angle",
            STAGE,
            "no angle above the one asked for is larger than the raw mesh's largest",
        ),
    ]


def _angles_above(mesh: Mesh, bound: AngleBound) -> dict[int, mpq]:
    """cos |cos| of the largest angle of each triangle with an angle above the bound.

    It falls as the angle grows, to -1 for a triangle that is flat or clockwise.
    """
    found = {}
    for t in range(len(mesh.triangles)):
        angle, _ = _largest_angle(mesh, [t])
        if angle is not None and not bound.admits(angle):
            found[t] = angle.signed_square
    return found


def _check_angle(mesh: Mesh, bound: AngleBound) -> Finding:
    """The raw mesh's bound, on all triangles."""
    angle, witness = _largest_angle(mesh, range(len(mesh.triangles)))
    low, high = bound.enclosure()
    exactly: Exact = str(low) if low == high else {"lower": str(low), "upper": str(high)}
    return Finding(
        "thinning.angle",
        STAGE,
        "no angle is above the raw mesh's bound (cos |cos|)",
        "guarantee",
        exactly,
        None if angle is None else str(angle.signed_square),
        len(mesh.triangles),
        angle is None or bound.admits(angle),
        witness,
    )


def _largest_angle(mesh: Mesh, triangles: range | list[int]) -> tuple[Angle | None, object]:
    """The largest angle of these triangles, and where; 180 degrees if one is flat or clockwise."""
    least = Extreme()
    for t in triangles:
        p, q, r = (mesh.vertices[v] for v in mesh.triangles[t])
        for before, apex, after in ((r, p, q), (p, q, r), (q, r, p)):
            dot, cross = cotangent(before, apex, after)
            if cross <= 0:
                return ANGLE_180, {"triangle": t}
            least.offer(dot, cross, {"triangle": t})
    if least.value is None:
        return None, None
    squared = least.value * least.value
    sign = (least.value > 0) - (least.value < 0)
    return Angle(sign, squared / (1 + squared)), least.witness
