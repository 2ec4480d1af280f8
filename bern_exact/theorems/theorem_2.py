"""Theorem 2: a simple polygon into O(n log n) triangles without an angle above 150 degrees.

The proof of Theorem 2, stage by stage: lop, dice and warp (Section 2), "then repair boundary faces
as in Lemma 5.  We merge all interior rectangles, and apply Lemmas 6 and 7 to the merged region."
"""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.boundary.merge import Objective
from bern_exact.boundary.records import BlockShape
from bern_exact.checkers.lemma_6 import check_lemma_6, check_lemma_6_as_printed
from bern_exact.checkers.theorem_2 import check_theorem_2
from bern_exact.exact.angle_bound import AngleBound, parse_angle_bound
from bern_exact.exact.errors import InputError
from bern_exact.interior.subdivided.halving import halving
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems.grid import grid_for
from bern_exact.theorems.no_large_angle import (
    judged,
    put_together,
    rectangle_triangles,
    tile_rectangles,
    treat_boundary,
)
from bern_exact.theorems.prepare import prepare
from bern_exact.theorems.stages import Check, Construction, Log, Observer, Silent
from bern_exact.theorems.threshold import threshold_for

DEGREES_150 = parse_angle_bound("150")


def theorem_2(
    polygon: Polygon,
    *,
    max_angle: AngleBound = DEGREES_150,
    objective: Objective = "fewest",
    squares: bool = False,
    blocks: BlockShape = "square",
    factor: mpq | None = None,
    check: Check = "every-stage",
    as_printed: bool = False,
    observer: Observer | None = None,
) -> Construction:
    """Triangulate a simple polygon into O(n log n) triangles of bounded angle and good height.

    Theorem 2: "In time O(n log n), an n-vertex simple polygon can be triangulated into
    O(n log n) triangles of height Omega(s) and maximum angle 150 degrees."

    Parameters
    ----------
    polygon : Polygon
        Valid and without holes.
    max_angle : AngleBound
        Above 135, at most 150 degrees.
    objective : {"fewest", "height", "angle"}
        What the pieces along the boundary are best at, within both bounds.
    squares : bool
        Cut the paper's unit squares off in Lemma 6 instead of whole strips.
    blocks, factor, check, as_printed, observer
        As in `theorem_1`.

    Raises
    ------
    InputError
        Kind `has-holes`.
    BoundOutOfReach
        If no threshold gives the angle bound.
    LemmaViolation
        If a guarantee fails.
    """
    if polygon.holes:
        raise InputError(
            "has-holes",
            f"Theorem 2 is for simple polygons and this one has {polygon.holes} "
            f"hole{'' if polygon.holes == 1 else 's'}: "
            "Theorem 3 is meant",
            {"ring": 1},
        )
    tau = threshold_for(max_angle)
    log = Log(check, observer or Silent(), as_printed)
    prepared = prepare(polygon, log, tau, grid_for(blocks, factor))
    merged, region = treat_boundary(prepared, log, tau, objective)

    partition = halving(region, squares=squares)
    log.done("partition", partition)
    if log.every_stage:
        log.demand(check_lemma_6(partition))
    if as_printed:
        log.demand(check_lemma_6_as_printed(partition))

    tiled = tile_rectangles(partition, log)
    assembled = put_together(prepared, merged, rectangle_triangles(tiled), log)
    if check != "none":
        log.demand(judged(check_theorem_2, polygon, prepared, merged, assembled, tau, max_angle))
    return log.construction(polygon, prepared.feature, prepared.framed, assembled)
