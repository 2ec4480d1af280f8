"""Theorem 1: a polygon with holes into O(n) triangles of nearly the greatest least height.

The proof of Theorem 1, stage by stage: lop off the acute corners (Lemma 1),
dice and warp (Lemma 2), sweep the interior (Lemma 3).
"""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.boundary.boundary_mesh import triangulate_boundary
from bern_exact.boundary.corners import TAU
from bern_exact.boundary.records import BlockShape
from bern_exact.checkers.as_printed import check_boundary_as_printed, check_swept_as_printed
from bern_exact.checkers.definition_2 import check_definition_2
from bern_exact.checkers.lemma_2 import check_lemma_2
from bern_exact.checkers.lemma_3 import check_lemma_3
from bern_exact.checkers.theorem_1 import check_theorem_1
from bern_exact.checkers.warping import check_faces
from bern_exact.interior.rectilinear import interior
from bern_exact.interior.sweep import sweep
from bern_exact.oracle.fast import verify_mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems.assemble import INTERIOR, assemble, boundary_triangles, nodes_on_cuts
from bern_exact.theorems.grid import grid_for
from bern_exact.theorems.prepare import prepare
from bern_exact.theorems.stages import Check, Construction, Log, Observer, Silent


def theorem_1(
    polygon: Polygon,
    *,
    blocks: BlockShape = "square",
    factor: mpq | None = None,
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
    blocks : {"square", "corner"}
        The paper's 3 x 3 squares round that of a vertex, or (experimental) the four squares round
        the grid vertex nearest to it.
    factor : mpq, optional
        s' in grid units; without it 8 for square and 9/2 for corner blocks.
    check : {"every-stage", "final", "none"}
        Check every claim after its stage, the theorem's own at the end, or nothing.
    as_printed : bool
        Also evaluate the sentences that are false as printed.
    observer : Observer, optional
        Told of each stage's record.

    Raises
    ------
    RefusedOption
        If the factor does not keep blocks apart.
    LemmaViolation
        If a guarantee fails.

    Notes
    -----
    O(n log^2 n) in the size of P', exact throughout.
    """
    log = Log(check, observer or Silent(), as_printed)
    prepared = prepare(polygon, log, TAU, grid_for(blocks, factor))

    boundary = triangulate_boundary(prepared.warped, prepared.warping, prepared.tracer)
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
        prepared.warped,
        boundary_triangles(boundary.faces),
        [(INTERIOR, triangle) for column in swept.columns for triangle in column.triangles],
        nodes_on_cuts(prepared.warped),
    )
    log.done("mesh", assembled)
    if check != "none":
        verdict = verify_mesh(assembled.mesh, polygon)
        log.demand(
            check_theorem_1(polygon, assembled.mesh, prepared.framed, prepared.feature, verdict)
        )
    if as_printed:
        log.demand(check_boundary_as_printed(boundary))
        log.demand(check_swept_as_printed(swept))
    return log.construction(polygon, prepared.feature, prepared.framed, assembled)
