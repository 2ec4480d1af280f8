"""The constants of Lemmas 10 to 12, exactly, with their places in the paper and their reasons.

A rectangle has m rows and k columns here.  Lemma 11 counts the m subdivisions on a side instead,
which makes m + 1 rows; below, S stands for them.
"""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.exact.enclosures import power_bounds

RIGHT_COTANGENT = mpq(0)
"""The cotangent of each angle is at least this: at most 90 degrees (Lemmas 10 and 12)."""

LEAST_WIDTH_SQUARED = mpq(1)
"""a^2/(c d) of each use of Lemma 10 is at least this (Lemma 10, in its exact form).

A rectangle A = (0, 0), B = (a, 0), C = (a, c + d), D = (0, c + d) with a subdivision s = (0, c)
is a pentagon.  Without Steiner points it has three triangles that share a corner.  That is s:
with B it would be s B D, whose dot product at s is (a, -c) (0, d) = -c d < 0, with C likewise
s C A, and with A or D the side A D would be a diagonal.  Of the three triangles at s only s B C
may be obtuse, at s, where the dot product is (a, -c) (a, d) = a^2 - c d.  The printed condition,
a greater than c and d, is sufficient and not necessary: on uniform grids it allows nothing.
"""

EPSILON = mpq(1, 6)
"""Lemma 11's epsilon as the paper uses it; the printed text has lost the letter."""


def eliminated(subdivisions: int, epsilon: mpq = EPSILON) -> mpq:
    """At least so many lines are eliminated: epsilon S - 1 (Lemma 11).

    >>> eliminated(12)
    mpq(1,1)
    """
    return epsilon * subdivisions - 1


def eliminated_between_medians(rows: int) -> mpq:
    """At least so many lines are eliminated between l and r: (m - 1)/6 of m - 1.

    Sharper than Lemma 11, since M is a row height itself: at most ceil(m/3) - 1 <= (m - 1)/3 rows
    are higher.  They protect at most twice as many lines, and half of the others go.
    """
    return mpq(rows - 1, 6)


def eliminated_in_outer_part(columns: int) -> mpq:
    """At least so many lines are eliminated in an outer part: (k' - 1)/2 of k' - 1.

    All columns are narrower than both rows are high, so that no line is protected.
    """
    return mpq(columns - 1, 2)


SEPARATION = mpq(1, 3)
"""l, r and what is between are at least this part of the columns (Section 5.1).

At least ceil(k/3) columns are as wide as their own 2/3-median, which is at least the rows'.  The
printed "separated by at least n/3 columns" counts l and r.
"""


def grid_triangles(columns: int, rows: int) -> int:
    """Two triangles a rectangle, 2 m k: the baseline, which removing lines never exceeds."""
    return 2 * columns * rows


def strip_triangles(rows: int) -> int:
    """The most triangles of one of the columns l and r: 2 m, minus one for each line removed.

    The printed "m triangles" for both is too few: they have 2 m rectangles.
    """
    return 2 * rows


EXPONENT = mpq(339, 400)
"""x = 0.8475: (5/6 + 4/3) 3^-x + (2/3) 6^-x = 1 at 0.8474777... (Section 5.1)."""

POWER_CONSTANT = mpq(5, 2)
"""c in the count's bound c (m^x k + m k^x) (Lemma 12, made explicit and symmetric).

Proved for all m and k, with every rounding term, in `proofs/lemma_12_rounding.py`: by what
`lemma-11.most`, `lemma-12.parts`, `.medians`, `.separation` and `.count` claim of each node.  The
checker evaluates it on each block of each run.  2 m k triangles always suffice, and are within the
bound if m and k are both at most 406, or one of them is at most 4.  c cannot be less than
2 3^(1 - x) = 2.3647... in the worst case: 3 rows, the middle one tall, and k columns, none wide,
are not reduced at all.
"""

POWER_BITS = 16
"""Powers are enclosed to 2^-16."""


def power_sum(columns: int, rows: int) -> mpq:
    """A rational below m^x k + m k^x, by less than (m + k)/2^16.

    >>> power_sum(1, 1)
    mpq(2,1)
    """
    of_rows, _ = power_bounds(rows, EXPONENT, POWER_BITS)
    of_columns, _ = power_bounds(columns, EXPONENT, POWER_BITS)
    return of_rows * columns + of_columns * rows
