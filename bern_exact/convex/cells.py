"""The rectangles of the bounced grid, as two staircases in index space."""

from __future__ import annotations

from dataclasses import dataclass

from gmpy2 import mpq

GridPoint = tuple[int, int]
"""Indices into the verticals and the horizontals."""


@dataclass(frozen=True)
class Cells:
    """The rectangles of the bounced grid: an orthoconvex region Q of cells in index space.

    Every line is kept whole within Q, so that each side of a block of cells carries as vertices
    exactly the lines that end on it or cross it.

    Parameters
    ----------
    xs : tuple of mpq
        The verticals, increasing, in the frame where A = (0, 0), B = (1, 0).
    ys : tuple of mpq
        The horizontals, increasing; one of them is 0.
    low, high : tuple of int
        The cells of the column between xs[j] and xs[j + 1] are (j, i) for
        low[j] <= i < high[j]; ys[low[j]] <= 0 <= ys[high[j]].  Equal if it has none.
    """

    xs: tuple[mpq, ...]
    ys: tuple[mpq, ...]
    low: tuple[int, ...]
    high: tuple[int, ...]

    @property
    def number(self) -> int:
        """How many cells there are."""
        return sum(self.high) - sum(self.low)
