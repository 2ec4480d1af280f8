"""The constants of the grid and its blocks, for the paper's choice and for the experimental ones.

As in `bounds`; rationals and integers, each with its place in the paper and its reason.
"""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.boundary.records import BlockShape

FACTOR = mpq(8)
"""s' in grid units: b = s'/8, rounded down (Section 2; the paper takes s where s' is needed)."""

UNIT_ROUNDING = 1 - mpq(1, 2**9)
"""The least ratio of b to s'/factor: b is s'/factor rounded down to a rational."""


def blocks_are_disjoint(shape: BlockShape, factor: mpq) -> bool:
    """Are blocks disjoint within P' (Section 2), if s' is at least this many grid units?

    A point of its block is at most 2 sqrt 2 from a vertex: it is less than 2 away along either
    axis.  For the four squares round the nearest corner it is at most 3/2 sqrt 2, since v is at
    most 1/2 from that corner along either axis.  Two vertices on one sheet are at least s'
    apart, so twice that suffices: factor > 4 sqrt 2 or 3 sqrt 2.

    >>> blocks_are_disjoint("square", mpq(17, 3)), blocks_are_disjoint("square", mpq(11, 2))
    (True, False)
    >>> blocks_are_disjoint("corner", mpq(17, 4)), blocks_are_disjoint("corner", mpq(4))
    (True, False)
    """
    return factor > 0 and factor**2 > (32 if shape == "square" else 18)


def intervals_a_vertex(shape: BlockShape = "square") -> int:
    """Kept intervals per vertex of P' (Section 2).

    A block has 4 + 4 lines, or 3 + 3 round the nearest corner, and the wedge of its vertex cuts
    the piece of a line within the block into at most two.

    >>> intervals_a_vertex("square"), intervals_a_vertex("corner")
    (16, 12)
    """
    return 16 if shape == "square" else 12
