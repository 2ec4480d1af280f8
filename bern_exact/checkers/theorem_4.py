"""Theorem 4: a convex polygon in O(n^1.848) triangles, none of them obtuse."""

from __future__ import annotations

from collections.abc import Iterator

from gmpy2 import mpq

from bern_exact.checkers import bounds_bounce as bounds
from bern_exact.checkers.bounds_convex import power_sum
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.merged_cells import boundary_edges
from bern_exact.checkers.no_large_angle import AngleJudgement
from bern_exact.convex.block_records import Reduced
from bern_exact.convex.records import Gridded
from bern_exact.exact.angles import ANGLE_90
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon

STAGE = "mesh"


def check_theorem_4(
    polygon: Polygon,
    mesh: Mesh,
    gridded: Gridded,
    reduced: Reduced | None,
    verdict: AngleJudgement,
) -> list[Finding]:
    """Check the finished mesh, in the input's coordinates.

    Parameters
    ----------
    polygon : Polygon
        P.
    mesh : Mesh
        The mesh, by Theorem 4 or its baseline.
    gridded : Gridded
        The grid before lines were removed.
    reduced : Reduced or None
        The blocks; None for the baseline.
    verdict : AngleJudgement
        The judge's verdict on this mesh and P.

    Notes
    -----
    Linear time.
    """
    count, valid, vertices = Extreme(greatest=True), Violations(), Violations()
    count.offer(len(mesh.triangles), 1, {"n": polygon.n})
    valid.case(verdict.valid, {"defects": len(verdict.defects)})
    for v, p in enumerate(polygon.points):
        vertices.case(v < len(mesh.vertices) and mesh.vertices[v] == p, {"vertex": v})
    rim = sum(len(leg.triangles) for leg in gridded.legs)
    return [
        _check_record(mesh, gridded, reduced, rim),
        _check_angle(verdict),
        count.finding(
            "theorem-4.quadratic-count",
            STAGE,
            "there are O(n^2) triangles: 9 n verticals, 18 n + 1 horizontals, all cells split",
            bounds.baseline_triangles(polygon.n),
        ),
        count.finding(
            "theorem-4.baseline-count",
            STAGE,
            "there are no more triangles than the O(n^2) algorithm makes on the same verticals",
            2 * gridded.cells.number + rim,
        ),
        *([] if reduced is None else _check_power_count(polygon.n, count, gridded, reduced)),
        vertices.finding(
            "theorem-4.vertices", STAGE, "the vertices of P come first, in the input's order"
        ),
        valid.finding(
            "theorem-4.valid", STAGE, "the mesh is a triangulation of P, as the judge finds"
        ),
    ]


def _check_record(mesh: Mesh, gridded: Gridded, reduced: Reduced | None, rim: int) -> Finding:
    """Are the records of the stages those of this mesh, and of each other?"""
    record = Violations()
    inside = 2 * gridded.cells.number
    if reduced is not None:
        inside = sum(len(block.triangles) for block in reduced.blocks)
        record.case(reduced.merged.cells == gridded.cells, "the cells")
    made = {"triangles": len(mesh.triangles), "inside": inside, "along the boundary": rim}
    record.case(len(mesh.triangles) == inside + rim, made)
    return record.finding(
        "theorem-4.record",
        STAGE,
        "the blocks are of the grid's own cells, and the mesh has the triangles of all blocks (of "
        "the baseline two a cell) and those along the boundary",
    )


def _check_power_count(
    n: int, count: Extreme, gridded: Gridded, reduced: Reduced
) -> Iterator[Finding]:
    """The count by way of the blocks, and O(n^1.8475) with its constant."""
    cells = gridded.cells
    powers, classes = mpq(0), [0]
    for block in reduced.blocks:
        x0, x1, y0, y1 = block.block
        powers += power_sum(x1 - x0, y1 - y0)
        short, long = sorted((x1 - x0, y1 - y0))
        classes += [0] * (short.bit_length() + 1 - len(classes))
        classes[short.bit_length()] += long
    edges, longest = boundary_edges(cells), Extreme(greatest=True)
    for i, total in enumerate(classes):
        if edges:
            longest.offer(total, edges, {"short sides below": 2**i})
    yield longest.finding(
        "theorem-4.long-sides",
        STAGE,
        "blocks with short sides from 2^i to 2^(i+1) - 1 have long sides of at most N together, "
        "N edges of cells being on the boundary of Q (ratio)",
        bounds.LONG_SIDES,
    )
    yield count.finding(
        "theorem-4.power-count",
        STAGE,
        "there are at most 5/2 (m^x k + m k^x) triangles summed over the blocks, and six a column, "
        "x = 0.8475 (for a square block, less than two a cell from 407 rows on)",
        bounds.blocks_triangles(powers, len(cells.low)),
    )
    yield count.finding(
        "theorem-4.count",
        STAGE,
        "there are O(n^1.8475) triangles: at most 6.3 N^1.8475 + 54 n, N = 54 n (less than "
        "324 n^2 + 54 n, of the quadratic count, for n from 5.9 10^9 on)",
        bounds.theorem_4_triangles(n),
    )


def _check_angle(verdict: AngleJudgement) -> Finding:
    """No angle above 90 degrees: the least cosine is not negative."""
    angle = verdict.max_angle
    return Finding(
        "theorem-4.angle",
        STAGE,
        "no angle is obtuse (cos |cos|)",
        "guarantee",
        "0",
        None if angle is None else str(angle.signed_square),
        0 if angle is None else 1,
        angle is None or angle.is_at_most(ANGLE_90),
        None if angle is None else {"triangle": verdict.max_angle_triangle},
    )
