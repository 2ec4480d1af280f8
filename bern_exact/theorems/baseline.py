"""The simpler construction that Theorems 1 to 3 improve on: all interior rectangles, split.

Section 3: "Simply splitting interior rectangles with diagonals, we obtain an O(n^2)-size
triangulation.  We now work on improving the size bound."
"""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.boundary.blocks import Grid
from bern_exact.boundary.boundary_mesh import triangulate_boundary
from bern_exact.boundary.corners import TAU
from bern_exact.boundary.merge import Objective
from bern_exact.boundary.records import BlockShape
from bern_exact.checkers.extremes import Violations
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.lemma_2 import check_lemma_2
from bern_exact.checkers.warping import check_faces
from bern_exact.exact.angle_bound import AngleBound
from bern_exact.interior.rectilinear import interior
from bern_exact.interior.sweep import whole_grid
from bern_exact.oracle.fast import verify_mesh
from bern_exact.oracle.verdict import Verdict
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems.assemble import (
    INTERIOR,
    Assembled,
    assemble,
    boundary_triangles,
    nodes_on_cuts,
)
from bern_exact.theorems.grid import grid_for
from bern_exact.theorems.no_large_angle import InteriorTriangle, put_together, treat_boundary
from bern_exact.theorems.prepare import Prepared, prepare
from bern_exact.theorems.stages import Check, Construction, Log, Observer, Silent
from bern_exact.theorems.threshold import threshold_for

MOST_TRIANGLES = 2_000_000
"""Interior triangles that a baseline may have; more are refused."""


def baseline(
    polygon: Polygon,
    *,
    max_angle: AngleBound | None = None,
    objective: Objective = "fewest",
    blocks: BlockShape = "square",
    factor: mpq | None = None,
    check: Check = "every-stage",
    as_printed: bool = False,
    observer: Observer | None = None,
) -> Construction:
    """Triangulate with the whole grid inside: the same guarantees, Theta(n^2) triangles.

    Parameters
    ----------
    polygon : Polygon
        Valid; holes are allowed.
    max_angle : AngleBound, optional
        Treat the boundary as Theorems 2 and 3 do, for this bound; without it as Theorem 1.
    objective, blocks, factor, check, as_printed, observer
        As in `theorem_2`.

    Raises
    ------
    TooManyTriangles
        If the grid would have more than `MOST_TRIANGLES` triangles.
    """
    grid = grid_for(blocks, factor)
    log = Log(check, observer or Silent(), as_printed)
    if max_angle is None:
        prepared, assembled = _highest(polygon, log, grid)
    else:
        tau = threshold_for(max_angle)
        prepared = prepare(polygon, log, tau, grid)
        merged, region = treat_boundary(prepared, log, tau, objective)
        whole = whole_grid(region, MOST_TRIANGLES)
        log.done("grid", whole)
        inside: list[InteriorTriangle] = [
            (INTERIOR, triangle) for column in whole.columns for triangle in column.triangles
        ]
        assembled = put_together(prepared, merged, inside, log)
    if check != "none":
        verdict = verify_mesh(assembled.mesh, polygon, max_angle=max_angle)
        log.demand([_judged(verdict)])
    return log.construction(polygon, prepared.feature, prepared.framed, assembled)


def _highest(polygon: Polygon, log: Log, grid: Grid) -> tuple[Prepared, Assembled]:
    """Theorem 1 without Lemma 3."""
    prepared = prepare(polygon, log, TAU, grid)
    boundary = triangulate_boundary(prepared.warped, prepared.warping, prepared.tracer)
    log.done("boundary", boundary)
    region = interior(face.ring for face in boundary.touched)
    log.done("interior", region)
    if log.every_stage:
        log.demand(check_lemma_2(boundary))
        log.demand(check_faces(boundary, region))
    whole = whole_grid(region, MOST_TRIANGLES)
    log.done("grid", whole)
    assembled = assemble(
        prepared.warped,
        boundary_triangles(boundary.faces),
        [(INTERIOR, triangle) for column in whole.columns for triangle in column.triangles],
        nodes_on_cuts(prepared.warped),
    )
    log.done("mesh", assembled)
    return prepared, assembled


def _judged(verdict: Verdict) -> Finding:
    """The mesh is valid, and within the angle bound if there is one."""
    valid = Violations()
    valid.case(bool(verdict), {"defects": [defect.message for defect in verdict.defects[:3]]})
    return valid.finding(
        "baseline.valid", "mesh", "the mesh is a triangulation of P within the bounds asked for"
    )
