"""Theorem 1: O(n) triangles of height Omega(s), with explicit constants."""

from __future__ import annotations

from collections.abc import Sized
from typing import Protocol

from gmpy2 import mpq

from bern_exact.boundary.records import Framed
from bern_exact.checkers import bounds
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.places import squared_height
from bern_exact.plane.feature_size import FeatureSize
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon

STAGE = "mesh"


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
    return [
        most.finding(
            "theorem-1.count",
            STAGE,
            "the mesh has at most C n triangles, C = 4850 from the parts (16 intervals a vertex "
            "of P', at most 2 n vertices of P', Lemma 3)",
            bounds.theorem_1_triangles(polygon.n),
        ),
        least.finding(
            "theorem-1.grid-height",
            STAGE,
            "every triangle has height at least tau b/sqrt(2) (squared, in the input's units)",
            bounds.boundary_height_squared(tau) * framed.unit**2,
        ),
        relative(least, feature.squared).finding(
            "theorem-1.height",
            STAGE,
            "the least height is at least tau s/(24 sqrt(2)) up to the rounding of cuts and grid "
            "unit, s being an upper bound for every triangulation ((height/s)^2)",
            bounds.theorem_1_height_squared(tau),
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
