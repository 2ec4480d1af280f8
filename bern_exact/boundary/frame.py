"""Scaling and turning P' so that the grid unit is 1 and nothing is special (Section 2).

The paper assumes that no edge is horizontal or vertical and takes b = s/8.
Two vertices in overlapping blocks are then possible; b must come from the
feature size s' of P' itself.
"""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.boundary.blocks import Grid
from bern_exact.boundary.records import Framed, Lopped
from bern_exact.boundary.rotation import rotation
from bern_exact.exact.points import direction
from bern_exact.exact.roots import sqrt_below
from bern_exact.exact.similarity import Similarity
from bern_exact.plane.feature_size import FeatureSize
from bern_exact.plane.polygon import Polygon

UNIT_BITS = 10
"""Significant bits of the grid unit: b > (1 - 2^-9) s'/factor."""

DEFAULT = Grid()
"""The paper's blocks and grid."""


class Degenerate(Exception):
    """A position over the grid that is not general: another frame must be tried."""


def frame(lopped: Lopped, feature: FeatureSize, attempt: int, grid: Grid = DEFAULT) -> Framed:
    """P' turned, scaled so that b = 1, and shifted; each attempt gives another position.

    Parameters
    ----------
    lopped : Lopped
        The stage before.
    feature : FeatureSize
        The feature size s' of P'.
    attempt : int
        0, 1, 2, ...: the frame depends on P', the grid asked for and this number alone.
    grid : Grid
        How fine the grid is, and the shape of blocks.

    Raises
    ------
    Degenerate
        If an edge is axis-parallel or exactly diagonal, or a vertex lies on a grid line.

    Notes
    -----
    O(n log n), for the rotation.
    """
    unit = sqrt_below(feature.squared / (grid.factor * grid.factor), UNIT_BITS)
    similarity = (
        rotation(lopped.lopped, attempt)
        .then(Similarity.of((1 / unit, mpq(0)), (mpq(0), mpq(0))))
        .then(Similarity.of((mpq(1), mpq(0)), _shift(attempt)))
    )
    polygon = lopped.lopped.with_points([similarity.apply(p) for p in lopped.lopped.points])
    _refuse_special(polygon)
    return Framed(lopped, feature, unit, grid.factor, similarity, polygon, grid.blocks)


def _shift(attempt: int) -> tuple[mpq, mpq]:
    """A shift by fractions with prime denominators, which few inputs share."""
    return mpq(271 + attempt, 1009), mpq(619 + 2 * attempt, 1013)


def _refuse_special(polygon: Polygon) -> None:
    """Raise Degenerate for axis-parallel and diagonal edges and vertices on grid lines."""
    for p in polygon.points:
        if p[0] % p[2] == 0 or p[1] % p[2] == 0:
            raise Degenerate("a vertex lies on a grid line")
    for v, w in polygon.edges():
        dx, dy = direction(polygon.points[v], polygon.points[w])
        if dx == 0 or dy == 0 or abs(dx) == abs(dy):
            raise Degenerate("an edge is axis-parallel or diagonal")
