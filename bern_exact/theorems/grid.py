"""The grid and the blocks that are asked for: the paper's, or the experimental ones."""

from __future__ import annotations

from collections.abc import Mapping

from gmpy2 import mpq

from bern_exact.boundary.blocks import FACTOR, Grid
from bern_exact.boundary.records import BlockShape
from bern_exact.theorems.stages import RefusedOption

FACTORS: Mapping[BlockShape, mpq] = {"square": FACTOR, "corner": mpq(9, 2)}
"""s' in grid units if nothing else is asked for."""

LEAST_SQUARED: Mapping[BlockShape, int] = {"square": 32, "corner": 18}
"""Blocks are disjoint above 4 sqrt 2 and 3 sqrt 2 grid units: twice the greatest distance of a
vertex from a corner of its block."""

MOST = 64
"""The finest grid allowed: the heights fall as the factor grows."""


def grid_for(blocks: BlockShape = "square", factor: mpq | None = None) -> Grid:
    """The grid for a shape of blocks and a factor, or the shape's own.

    Raises
    ------
    RefusedOption
        If blocks could overlap, or the factor is above 64.

    >>> grid_for("corner")
    Grid(blocks='corner', factor=mpq(9,2))
    """
    if factor is None:
        return Grid(blocks, FACTORS[blocks])
    least = LEAST_SQUARED[blocks]
    if not (factor > 0 and factor * factor > least and factor <= MOST):
        raise RefusedOption(
            f"factor {factor}: {blocks} blocks need more than sqrt({least}), about "
            f"{'5.657' if blocks == 'square' else '4.243'}, to be disjoint, and at most {MOST} "
            "is allowed"
        )
    return Grid(blocks, factor)
