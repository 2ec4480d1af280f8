"""Theorem 1: a polygon with holes into O(n) triangles of nearly the greatest least height.

The proof of Theorem 1, stage by stage: lop off the acute corners (Lemma 1),
dice and warp (Lemma 2), sweep the interior (Lemma 3).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from bern_exact.boundary.boundary_mesh import triangulate_boundary
from bern_exact.boundary.corners import warp
from bern_exact.boundary.dice import dice
from bern_exact.boundary.faces import trace
from bern_exact.boundary.frame import Degenerate, frame
from bern_exact.boundary.lop import lop
from bern_exact.boundary.records import Diced, Framed, Lopped
from bern_exact.checkers.as_printed import (
    check_boundary_as_printed,
    check_framed_as_printed,
    check_lopped_as_printed,
    check_swept_as_printed,
    check_warped_as_printed,
)
from bern_exact.checkers.definition_1 import check_definition_1
from bern_exact.checkers.definition_2 import check_definition_2
from bern_exact.checkers.dicing import check_dicing, check_frame
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.lemma_1 import check_lemma_1
from bern_exact.checkers.lemma_2 import check_lemma_2
from bern_exact.checkers.lemma_3 import check_lemma_3
from bern_exact.checkers.theorem_1 import check_theorem_1
from bern_exact.checkers.warping import check_faces, check_warping
from bern_exact.interior.rectilinear import interior
from bern_exact.interior.sweep import sweep
from bern_exact.oracle.fast import verify_mesh
from bern_exact.plane.feature_size import FeatureSize, feature_size
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import triangulate_polygon
from bern_exact.theorems.assemble import Assembled, assemble
from bern_exact.theorems.stages import Check, Log, Observer, Silent

ATTEMPTS = 100
"""Frames tried before giving up; each fails only on a coincidence of its own."""


@dataclass(frozen=True)
class Construction:
    """What a theorem's construction made.

    Parameters
    ----------
    polygon : Polygon
        P.
    feature : FeatureSize
        Definition 1 for P.
    framed : Framed
        The grid: its unit and rotation.
    assembled : Assembled
        The mesh, and where each triangle comes from.
    records : mapping
        Every stage's record by its name, in order.
    findings : sequence of Finding
        Every claim evaluated.
    """

    polygon: Polygon
    feature: FeatureSize
    framed: Framed
    assembled: Assembled
    records: Mapping[str, object]
    findings: Sequence[Finding]


def theorem_1(
    polygon: Polygon,
    *,
    check: Check = "every-stage",
    as_printed: bool = False,
    observer: Observer | None = None,
) -> Construction:
    """Triangulate a polygon with holes into O(n) triangles of height Omega(s).

    Theorem 1: "In time O(n log n), an n-vertex polygon with holes can be triangulated into
    O(n) triangles of height Omega(s), where s is an upper bound on the largest possible
    minimum height."

    Parameters
    ----------
    polygon : Polygon
        Valid, as `polygon_from_rings` makes it.
    check : {"every-stage", "final", "none"}
        Check every claim after its stage, the theorem's own at the end, or nothing.
    as_printed : bool
        Also evaluate the sentences that are false as printed.
    observer : Observer, optional
        Told of each stage's record.

    Raises
    ------
    LemmaViolation
        If a guarantee fails.

    Notes
    -----
    O(n log^2 n) in the size of P', exact throughout.
    """
    log = Log(check, observer or Silent())
    triangulation = triangulate_polygon(polygon)
    feature = feature_size(polygon, triangulation)
    log.done("feature-size", feature)
    if log.every_stage:
        log.demand(check_definition_1(polygon, feature))

    lopped = lop(polygon, triangulation)
    log.done("lopped", lopped)

    diced = _dice_somewhere(lopped)
    log.done("framed", diced.framed)
    if log.every_stage:
        log.demand(check_lopped(diced.framed, feature))
        log.demand(check_frame(diced.framed))
    log.done("diced", diced)
    if log.every_stage:
        log.demand(check_dicing(diced))

    traced, tracer = trace(diced)
    log.done("traced", traced)

    warped, warping = warp(traced, tracer)
    log.done("warped", warped)
    if log.every_stage:
        log.demand(check_warping(warped))

    boundary = triangulate_boundary(warped, warping, tracer)
    log.done("boundary", boundary)
    if log.every_stage:
        log.demand(check_lemma_2(boundary))

    region = interior(face.ring for face in boundary.touched)
    log.done("interior", region)
    if log.every_stage:
        log.demand(check_faces(boundary, region))
        log.demand(check_definition_2(region))

    swept = sweep(region)
    log.done("swept", swept)
    if log.every_stage:
        log.demand(check_lemma_3(swept))

    assembled = assemble(
        boundary, [triangle for column in swept.columns for triangle in column.triangles]
    )
    log.done("mesh", assembled)
    if check != "none":
        verdict = verify_mesh(assembled.mesh, polygon)
        log.demand(check_theorem_1(polygon, assembled.mesh, diced.framed, feature, verdict))
    if as_printed:
        log.demand(check_lopped_as_printed(lopped, feature))
        log.demand(check_framed_as_printed(diced.framed, feature))
        log.demand(check_warped_as_printed(warped))
        log.demand(check_boundary_as_printed(boundary))
        log.demand(check_swept_as_printed(swept))
    return Construction(polygon, feature, diced.framed, assembled, log.records, log.findings)


def check_lopped(framed: Framed, feature: FeatureSize) -> list[Finding]:
    """Lemma 1, and Definition 1 for P', on which the grid unit rests."""
    lopped = framed.lopped
    certified = check_definition_1(
        lopped.lopped, framed.feature, claim="definition-1.lopped", stage="framed"
    )
    return [*certified, *check_lemma_1(lopped, feature, framed.feature)]


def _dice_somewhere(lopped: Lopped) -> Diced:
    """Dice P' in the first frame in which nothing is special."""
    feature = feature_size(lopped.lopped)
    for attempt in range(ATTEMPTS):
        try:
            return dice(frame(lopped, feature, attempt))
        except Degenerate as coincidence:
            reason = coincidence
    raise reason
