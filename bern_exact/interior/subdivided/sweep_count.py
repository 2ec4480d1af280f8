"""How many rows a vertical segment crosses, for segments met from left to right."""

from __future__ import annotations

from bisect import bisect_left

from bern_exact.interior.subdivided.lattice import Strips


class Sweep:
    """The rows just right of a vertical line that moves to the right.

    Parameters
    ----------
    rows : Strips
        A row [low, high] x [near, far] is there while low <= x < high.

    Notes
    -----
    O(log N) a row and a question: a Fenwick tree over the lower lines of rows.
    """

    def __init__(self, rows: Strips) -> None:
        self._lines = sorted({row.near for row in rows.strips})
        self._sums = [0] * (len(self._lines) + 1)
        self._starting = sorted(rows.strips, key=lambda row: row.low, reverse=True)
        self._ending = sorted(rows.strips, key=lambda row: row.high, reverse=True)

    def advance(self, x: int) -> None:
        """Move the line to x, no smaller than before."""
        while self._starting and self._starting[-1].low <= x:
            self._add(self._starting.pop().near, 1)
        while self._ending and self._ending[-1].high <= x:
            self._add(self._ending.pop().near, -1)

    def count(self, y0: int, y1: int) -> int:
        """How many rows there are between two of their lines."""
        return self._below(y1) - self._below(y0)

    def _add(self, line: int, amount: int) -> None:
        i = bisect_left(self._lines, line) + 1
        while i < len(self._sums):
            self._sums[i] += amount
            i += i & -i

    def _below(self, y: int) -> int:
        """How many rows begin below y."""
        total, i = 0, bisect_left(self._lines, y)
        while i:
            total += self._sums[i]
            i &= i - 1
        return total
