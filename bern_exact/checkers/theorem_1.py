"""Theorem 1: O(n) triangles of height Omega(s), with explicit constants."""

from __future__ import annotations

from collections.abc import Mapping, Sized
from typing import Protocol

from gmpy2 import mpq

from bern_exact.boundary.records import BlockShape, Framed
from bern_exact.checkers import bounds, bounds_blocks
from bern_exact.checkers.bounds_grid import intervals_a_vertex
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.places import squared_height
from bern_exact.plane.feature_size import FeatureSize
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon

STAGE = "mesh"

LEAST: Mapping[BlockShape, str] = {"square": "sqrt(2)", "corner": "2"}
"""What tau b is divided by in the least height, for both shapes of blocks."""


class Judgement(Protocol):
    """What is read of the judge's verdict."""

    @property
    def valid(self) -> bool:
        """Is the mesh a triangulation of the polygon?"""

    @property
    def defects(self) -> Sized:
        """What is wrong with it."""


def check_theorem_1(
    polygon: Polygon,
    mesh: Mesh,
    framed: Framed,
    feature: FeatureSize,
    verdict: Judgement,
    *,
    tau: mpq = bounds.TAU,
) -> list[Finding]:
    """Check Theorem 1 on the finished mesh, in the input's coordinates.

    Parameters
    ----------
    polygon : Polygon
        P.
    mesh : Mesh
        The finished mesh.
    framed : Framed
        For the grid unit.
    feature : FeatureSize
        s, certified by `definition_1`.
    verdict : Judgement
        The judge's verdict on this mesh and P.
    tau : mpq
        The snapping threshold in grid units.

    Notes
    -----
    Heights are measured here again, not taken from the verdict.  Linear time.
    """
    most, valid = Extreme(greatest=True), Violations()
    most.offer(len(mesh.triangles), 1, {"n": polygon.n})
    valid.case(verdict.valid, {"defects": len(verdict.defects)})
    least = least_height(mesh)
    shape = framed.blocks
    constant = bounds.theorem_1_triangles(2, shape) // 2
    return [
        most.finding(
            "theorem-1.count",
            STAGE,
            f"the mesh has at most C n triangles, C = {constant} from the parts "
            f"({intervals_a_vertex(shape)} intervals a vertex "
            "of P', at most 2 n vertices of P', Lemma 3)",
            bounds.theorem_1_triangles(polygon.n, shape),
        ),
        least.finding(
            "theorem-1.grid-height",
            STAGE,
            f"every triangle has height at least tau b/{LEAST[shape]} (squared, in the input's "
            "units)",
            bounds_blocks.block_height_squared(shape, tau) * framed.unit**2,
        ),
        relative(least, feature.squared).finding(
            "theorem-1.height",
            STAGE,
            f"the least height is at least tau s/({3 * framed.factor} {LEAST[shape]}) up to the "
            "rounding "
            "of cuts and grid unit, s being an upper bound for every triangulation ((height/s)^2)",
            bounds.theorem_1_height_squared(tau, framed.factor, shape),
        ),
        valid.finding(
            "theorem-1.valid", STAGE, "the mesh is a triangulation of P, as the judge finds"
        ),
    ]


def least_height(mesh: Mesh) -> Extreme:
    """The least squared height, and its triangle."""
    least = Extreme()
    for i, (p, q, r) in enumerate(mesh.triangles):
        num, den = squared_height(mesh.vertices[p], mesh.vertices[q], mesh.vertices[r])
        least.offer(num, den, {"triangle": i, "vertices": [p, q, r]})
    return least


def relative(least: Extreme, squared: mpq) -> Extreme:
    """The same over s^2."""
    ratio = Extreme()
    if least.cases:
        ratio.offer(least.num * squared.denominator, least.den * squared.numerator, least.witness)
    ratio.cases = least.cases
    return ratio
