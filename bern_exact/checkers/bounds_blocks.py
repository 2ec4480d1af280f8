"""Lemma 2's bounds for both shapes of blocks."""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.boundary.records import BlockShape
from bern_exact.checkers import bounds


def block_cotangent(shape: BlockShape, tau: mpq = bounds.TAU) -> mpq:
    """The cotangent of each angle in a block: 135 degrees, by the choice of corner (Lemma 2).

    A block round the nearest corner has no other to choose: only the bound of Theorems 2 and 3,
    135 degrees + arctan(2 tau), is promised.
    """
    return bounds.BLOCK_COTANGENT if shape == "square" else bounds.boundary_cotangent(tau)


def block_height_squared(shape: BlockShape, tau: mpq = bounds.TAU) -> mpq:
    """The least squared height in a block: (tau/sqrt 2)^2, or (tau/2)^2 round the nearest corner.

    There v may be 1/2 below a block line and 1/2 beside a grid vertex of it, from which an edge
    at v is tau away on the other side: these three have height tau/sqrt(1 + (1 + 2 tau)^2), for
    tau = 1/8 about 0.625 tau, and there is no other corner to choose.
    """
    return (
        bounds.boundary_height_squared(tau)
        if shape == "square"
        else bounds.merged_height_squared(tau)
    )
