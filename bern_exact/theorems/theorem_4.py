"""Theorem 4: a convex polygon into O(n^1.848) triangles without an obtuse angle.

Section 5, stage by stage: the frame of the diameter, verticals and bounced paths, cells and
right triangles along the boundary (Lemma 9).
"""

from __future__ import annotations

from bern_exact.convex.bounce import bounce
from bern_exact.convex.faces import faces
from bern_exact.convex.frame import convex_frame
from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.oracle.fast import verify_mesh
from bern_exact.plane.feature_size import feature_size
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import triangulate_polygon
from bern_exact.theorems.convex_mesh import assemble_convex, split_cells
from bern_exact.theorems.stages import Check, Construction, Log, Observer, Silent

DEGREES_90 = parse_angle_bound("90")


def theorem_4(
    polygon: Polygon,
    *,
    check: Check = "every-stage",
    as_printed: bool = False,
    observer: Observer | None = None,
) -> Construction:
    log = Log(check, observer or Silent(), as_printed)
    framed = convex_frame(polygon)
    feature = feature_size(polygon, triangulate_polygon(polygon))
    log.done("feature-size", feature)
    log.done("framed", framed)
    bounced = bounce(framed)
    log.done("bounced", bounced)
    gridded = faces(bounced)
    log.done("gridded", gridded)
    assembled = assemble_convex(gridded, split_cells(gridded.cells))
    log.done("mesh", assembled)
    if check != "none":
        verdict = verify_mesh(assembled.mesh, polygon, max_angle=DEGREES_90)
    return log.construction(polygon, feature, framed, assembled)
