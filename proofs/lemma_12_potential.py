"""The potential A(M) K + M A(K) of `lemma_12_rounding`: its table, exactly, and what it leaves.

Values of A are integers in units of 1/`UNIT`; six times as fine where a sixth is needed.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from bern_exact.exact.enclosures import power_bounds

BITS = 20
UNIT = 2**BITS
LEAST = 5
"""With fewer lines nothing is to be shown: A(K) = 2 K."""

FEW = 24
"""Up to so many lines A - B has to be positive."""

MANY = 64
"""From so many lines on A(K) >= c K^x."""

Integers = NDArray[np.int64]


@dataclass(frozen=True)
class Potential:
    """A(K) = c K^x from `size` lines on; below, the least that leaves `slack` in the recursion.

    Parameters
    ----------
    exponent : mpq
        x.
    factor : mpq
        c.
    size : int
        N: A is a table below, and at N itself.
    slack : mpq
        A - B is at least this from `LEAST` to `FEW` lines; it is at least 0 up to N.
    """

    exponent: mpq
    factor: mpq
    size: int
    slack: mpq


class Table(NamedTuple):
    """A for 0 to N lines, and six times the functions of the docstring of `lemma_12_rounding`.

    `low` and `high` enclose c K^x; `b`, `alpha`, `beta`, `gamma` are 0 below `LEAST`.
    """

    a: Integers
    low: Integers
    high: Integers
    b: Integers
    alpha: Integers
    beta: Integers
    gamma: Integers


@lru_cache(maxsize=4)
def table_of(potential: Potential) -> Table:
    """The table, from few lines to many."""
    size = potential.size
    low, high = _powers(potential)
    a, b, gamma = (np.zeros(size + 1, np.int64) for _ in range(3))
    pairs = np.zeros((4, size + 2), np.int64)
    values = np.zeros((4, size + 1), np.int64)
    slack = int(potential.slack * UNIT)
    for lines in range(1, size + 1):
        if lines < LEAST:
            a[lines] = 2 * UNIT * lines
        else:
            middle = _middles(lines)
            rest = pairs[:, lines - middle]
            b[lines] = max((4 * a[middle] + rest[0]).max(), (5 * a[middle] + rest[1]).max())
            gamma[lines] = max(
                (8 * a[middle] + 8 * rest[2]).max(), (2 * a[middle] + 20 * rest[2]).max()
            )
            a[lines] = max(a[lines - 1], -(-b[lines] // 6) + slack * (lines <= FEW))
            if lines >= MANY:
                a[lines] = max(a[lines], high[lines])
        all_of_it, merged = a[lines], a[(lines + 2) // 2]
        values[:, lines] = (
            4 * all_of_it + 2 * merged,
            2 * all_of_it + 4 * merged,
            all_of_it - merged,
            all_of_it,
        )
        sums = values[:, 1 : lines + 1] + values[:, lines:0:-1]
        pairs[:, lines + 1] = sums.max(axis=1)
    alpha, beta = _across(a, pairs[3])
    return Table(a, low, high, b, alpha, beta, gamma)


def _powers(potential: Potential) -> tuple[Integers, Integers]:
    """c K^x rounded down and up."""
    low, high = (np.zeros(potential.size + 1, np.int64) for _ in range(2))
    for lines in range(1, potential.size + 1):
        below, above = power_bounds(lines, potential.exponent, BITS)
        scaled = potential.factor * below * UNIT, potential.factor * above * UNIT
        low[lines] = int(scaled[0].numerator // scaled[0].denominator)
        high[lines] = -int(-scaled[1].numerator // scaled[1].denominator)
    return low, high


def _middles(lines: int) -> Integers:
    """All K_2 >= (K - 4)/3 that leave a line for K_1 and one for K_3."""
    return np.arange(max(1, -(-(lines - 4) // 3)), lines - 1)


def most_kept(lines: int, middle: Integers) -> Integers:
    """M' = M - e at most, M_2 being given: the lines left between l and r.

    >>> [int(n) for n in most_kept(13, np.array([3, 4, 5, 8]))]
    [10, 10, 10, 10]
    """
    rows = lines - 1
    higher = -(-rows // 3) - 1
    outside = lines - middle
    # floor((M_1 - 1)/2) + floor((M_3 - 1)/2) is the least for M_1 even.
    apart = np.where(outside % 2 == 0, np.maximum(outside - 4, 0), outside - 3) // 2
    kept: Integers = lines - np.maximum(-(-(rows - 1 - 2 * higher) // 2), apart)
    return kept


def _across(a: Integers, pairs: Integers) -> tuple[Integers, Integers]:
    """Six times alpha and beta."""
    alpha, beta = np.zeros_like(a), np.zeros_like(a)
    for lines in range(LEAST, len(a)):
        middle = _middles(lines)
        kept, ends = a[most_kept(lines, middle)], pairs[lines - middle]
        alpha[lines] = np.maximum(2 * kept + 4 * ends + 2 * a[middle], 6 * kept).max()
        more = 2 * ends + a[middle] - 2 * kept
        beta[lines] = (12 * a[middle] + np.minimum(4 * more, 6 * more)).max()
    return alpha, beta
