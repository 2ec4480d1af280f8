"""Theorem 3: a polygon with holes into O(n^{3/2}) triangles without an angle above 150 degrees.

As Theorem 2, with Lemma 8 in place of Lemma 6, which "fails for rectilinear polygons with holes";
or with the alternative that the paper mentions: "connects holes to the boundary to form a simple
polygon and then applies Lemma 6".
"""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.boundary.merge import Objective
from bern_exact.boundary.records import BlockShape
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.lemma_6 import check_lemma_6
from bern_exact.checkers.lemma_8 import check_lemma_8
from bern_exact.checkers.theorem_3 import check_theorem_3
from bern_exact.exact.angle_bound import AngleBound
from bern_exact.interior.subdivided.choice import Method, partition
from bern_exact.interior.subdivided.records import Partition
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
from bern_exact.theorems.theorem_2 import DEGREES_150
from bern_exact.theorems.threshold import threshold_for


def theorem_3(
    polygon: Polygon,
    *,
    max_angle: AngleBound = DEGREES_150,
    interior: Method = "best",
    objective: Objective = "fewest",
    blocks: BlockShape = "square",
    factor: mpq | None = None,
    check: Check = "every-stage",
    as_printed: bool = False,
    observer: Observer | None = None,
) -> Construction:
    """Triangulate a polygon with holes into triangles of bounded angle and good height.

    Theorem 3: "In time O(n log n + k), an n-vertex polygon with holes can be triangulated into
    k = O(n^{3/2}) triangles of height Omega(s) and maximum angle 150 degrees."

    Parameters
    ----------
    polygon : Polygon
        Valid; holes are allowed.
    max_angle : AngleBound
        Above 135, at most 150 degrees.
    interior : {"strips", "bridges", "best"}
        Lemma 8; the holes joined to the boundary and Lemma 6; or for each component of Q the
        one that is counted to have fewer vertices.
    objective : {"fewest", "height", "angle"}
        What the pieces along the boundary are best at, within both bounds.
    blocks, factor, check, as_printed, observer
        As in `theorem_1`.

    Raises
    ------
    BoundOutOfReach
        If no threshold gives the angle bound.
    LemmaViolation
        If a guarantee fails.
    """
    tau = threshold_for(max_angle)
    log = Log(check, observer or Silent(), as_printed)
    prepared = prepare(polygon, log, tau, grid_for(blocks, factor))
    merged, region = treat_boundary(prepared, log, tau, objective)

    rectangles = partition(region, interior)
    log.done("partition", rectangles)
    if log.every_stage:
        log.demand(_check_partition(rectangles, interior))

    tiled = tile_rectangles(rectangles, log)
    assembled = put_together(prepared, merged, rectangle_triangles(tiled), log)
    if check != "none":
        log.demand(judged(check_theorem_3, polygon, prepared, merged, assembled, tau, max_angle))
    return log.construction(polygon, prepared.feature, prepared.framed, assembled)


def _check_partition(rectangles: Partition, interior: Method) -> tuple[Finding, ...]:
    """Lemma 6 for the bridged region, else Lemma 8, whose bound the best of both keeps too."""
    return check_lemma_6(rectangles) if interior == "bridges" else check_lemma_8(rectangles)
