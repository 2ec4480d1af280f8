"""Theorem 4: a convex polygon into O(n^1.848) triangles without an obtuse angle.

Section 5, stage by stage: the frame of the diameter, verticals and bounced paths, cells and
right triangles along the boundary (Lemma 9), cells merged into large blocks (Lemma 6), and lines
removed from the blocks (Lemmas 10 to 12).
"""

from __future__ import annotations

from collections.abc import Iterable

from bern_exact.checkers.bounced_grid import check_grid
from bern_exact.checkers.bouncing import check_bouncing
from bern_exact.checkers.definition_1 import check_definition_1
from bern_exact.checkers.diameter import check_diameter
from bern_exact.checkers.lemma_9 import check_lemma_9
from bern_exact.checkers.lemma_10 import check_lemma_10, check_lemma_10_as_printed
from bern_exact.checkers.lemma_11 import check_lemma_11, check_lemma_11_as_printed
from bern_exact.checkers.lemma_12 import check_lemma_12
from bern_exact.checkers.merged_cells import check_merged_cells
from bern_exact.checkers.printed_bounces import check_bouncing_as_printed
from bern_exact.checkers.printed_recursion import check_lemma_12_as_printed
from bern_exact.checkers.theorem_4 import check_theorem_4
from bern_exact.convex.block_records import Reduced
from bern_exact.convex.bounce import bounce
from bern_exact.convex.cells import Cells
from bern_exact.convex.faces import faces
from bern_exact.convex.frame import convex_frame
from bern_exact.convex.merge import merge
from bern_exact.convex.records import Gridded
from bern_exact.convex.reduction import reduce_blocks
from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.oracle.fast import verify_mesh
from bern_exact.plane.feature_size import FeatureSize, feature_size
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import triangulate_polygon
from bern_exact.theorems.convex_mesh import CellTriangle, assemble_convex, split_cells
from bern_exact.theorems.stages import Check, Construction, Log, Observer, Silent

DEGREES_90 = parse_angle_bound("90")


def theorem_4(
    polygon: Polygon,
    *,
    check: Check = "every-stage",
    as_printed: bool = False,
    observer: Observer | None = None,
) -> Construction:
    """Triangulate a convex polygon into O(n^1.848) triangles without an obtuse angle.

    Theorem 4: "In time O(n^1.848), an n-vertex convex polygon can be triangulated with
    O(n^1.848) nonobtuse triangles."

    Parameters
    ----------
    polygon : Polygon
        Valid, convex and without holes; 180-degree vertices are allowed.
    check, as_printed, observer
        As in `theorem_1`.

    Raises
    ------
    InputError
        Kind `has-holes`, or `not-convex` naming a reflex vertex.
    LemmaViolation
        If a guarantee fails.

    Notes
    -----
    O(n log n) up to the blocks, then linear in the triangles, but for the checks: the diameter's
    is quadratic in n.
    """
    log = Log(check, observer or Silent(), as_printed)
    gridded, feature = _grid(polygon, log)
    reduced = _reduce(gridded.cells, log)
    return _finish(gridded, feature, reduced.triangles, reduced, log)


def bouncing(
    polygon: Polygon,
    *,
    check: Check = "every-stage",
    as_printed: bool = False,
    observer: Observer | None = None,
) -> Construction:
    """The earlier O(n^2) algorithm, on which Theorem 4 improves: every cell split.

    Section 5: "partition P as above, bounce paths until each triangle along the boundary has at
    most one subdivision point, and then triangulate with Lemma 9."

    Parameters
    ----------
    polygon, check, as_printed, observer
        As in `theorem_4`.

    Raises
    ------
    InputError, LemmaViolation
        As in `theorem_4`.
    TooManyTriangles
        If the cells would have more than 4,000,000 triangles.
    """
    log = Log(check, observer or Silent(), as_printed)
    gridded, feature = _grid(polygon, log)
    return _finish(gridded, feature, split_cells(gridded.cells), None, log)


def _grid(polygon: Polygon, log: Log) -> tuple[Gridded, FeatureSize]:
    """Frame, bounce, and draw the grid."""
    framed = convex_frame(polygon)
    feature = feature_size(polygon, triangulate_polygon(polygon))
    log.done("feature-size", feature)
    if log.every_stage:
        log.demand(check_definition_1(polygon, feature))
    log.done("framed", framed)
    if log.every_stage:
        log.demand(check_diameter(framed))

    bounced = bounce(framed)
    log.done("bounced", bounced)
    if log.every_stage:
        log.demand(check_bouncing(bounced))
    if log.as_printed:
        log.demand(check_bouncing_as_printed(bounced))

    gridded = faces(bounced)
    log.done("gridded", gridded)
    if log.every_stage:
        log.demand(check_grid(gridded))
        log.demand(check_lemma_9(gridded))
    return gridded, feature


def _reduce(cells: Cells, log: Log) -> Reduced:
    """Merge the cells into blocks, and remove lines from those."""
    merged = merge(cells)
    log.done("merged", merged)
    if log.every_stage:
        log.demand(check_merged_cells(merged, cells))

    reduced = reduce_blocks(merged)
    log.done("reduced", reduced)
    if log.every_stage:
        log.demand(check_lemma_10(reduced))
        log.demand(check_lemma_11(reduced))
        log.demand(check_lemma_12(reduced))
    if log.as_printed:
        log.demand(check_lemma_10_as_printed(reduced))
        log.demand(check_lemma_11_as_printed(reduced))
        log.demand(check_lemma_12_as_printed(reduced))
    return reduced


def _finish(
    gridded: Gridded,
    feature: FeatureSize,
    inside: Iterable[CellTriangle],
    reduced: Reduced | None,
    log: Log,
) -> Construction:
    """The mesh in the input's coordinates, and the theorem's own claims."""
    framed = gridded.bounced.frame
    assembled = assemble_convex(gridded, inside)
    log.done("mesh", assembled)
    if log.check != "none":
        verdict = verify_mesh(assembled.mesh, framed.polygon)
        log.demand(check_theorem_4(framed.polygon, assembled.mesh, gridded, reduced, verdict))
    return log.construction(framed.polygon, feature, framed, assembled)
