"""Lemma 10: where a line may end in the middle of a side without an obtuse angle."""

from __future__ import annotations

from gmpy2 import mpq, sign

from bern_exact.checkers.block_lines import Cut, Measured, squared_ratio
from bern_exact.checkers.bounds_convex import LEAST_WIDTH_SQUARED
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.convex.block_records import Reduced

STAGE = "reduced"


def check_lemma_10(reduced: Reduced) -> tuple[Finding, ...]:
    """The claims of Lemma 10, at each line of the recursion and both strips that it may end at.

    Parameters
    ----------
    reduced : Reduced
        The record; lines that were not removed are looked at as well.

    Returns
    -------
    tuple of Finding
        `lemma-10.iff`, `.sufficient`, `.removed`.

    Notes
    -----
    Constant time for each line of each node.
    """
    measured = Measured(reduced.merged.cells)
    iff, sufficient, removed = Violations(), Violations(), Extreme()
    for cut in measured.cuts(reduced):
        if cut.is_double:
            _look_at(cut, iff, sufficient, removed)
    return (
        iff.finding(
            "lemma-10.iff",
            STAGE,
            "A rectangle a wide with one subdivision, c and d from its ends, has no obtuse "
            "angle at the subdivision if and only if a^2 >= c d.",
        ),
        sufficient.finding(
            "lemma-10.sufficient",
            STAGE,
            "If the width is greater than either distance, as printed, the rectangle is "
            "triangulated into nonobtuse triangles.",
        ),
        removed.finding(
            "lemma-10.removed",
            STAGE,
            "Where a line was removed, a^2 is at least c d (ratio).",
            LEAST_WIDTH_SQUARED,
        ),
    )


def check_lemma_10_as_printed(reduced: Reduced) -> tuple[Finding, ...]:
    """Whether the printed condition alone would have allowed to remove the same lines.

    "Its width is greater than either of the distances between the subdivision and the top or
    bottom": on a uniform grid it never is.
    """
    measured = Measured(reduced.merged.cells)
    strict = Violations()
    for cut in measured.cuts(reduced):
        lines, gone = cut.node.lines, set(cut.node.removed)
        for i in range(1, len(lines) - 1):
            if lines[i] in gone:
                wide = cut.is_double and cut.width > max(cut.gaps[i - 1 : i + 1])
                strict.case(wide, (cut.place, lines[i]))
    return (
        strict.finding(
            "lemma-10.printed-width",
            STAGE,
            "Lines are removed only where the columns are wider than both rows beside the line.",
            role="as-printed",
        ),
    )


def _look_at(cut: Cut, iff: Violations, sufficient: Violations, removed: Extreme) -> None:
    """All lines of one node, with l and with r."""
    node, gone = cut.node, set(cut.node.removed)
    for strip in (node.first, node.last):
        a = cut.strips[strip]
        for i in range(1, len(node.lines) - 1):
            c, d = cut.gaps[i - 1], cut.gaps[i]
            place = (cut.place, strip, node.lines[i])
            above, below = squared_ratio(a, c, d)
            nonobtuse = dot_at_subdivision(a, c, d) >= 0
            iff.case(nonobtuse == (above >= below), place)
            if a > c and a > d:
                sufficient.case(nonobtuse, place)
            if node.lines[i] in gone:
                removed.offer(above, below, place)


def dot_at_subdivision(a: mpq, c: mpq, d: mpq) -> int:
    """The sign of the dot product at (0, c) of the directions to (a, 0) and to (a, c + d).

    In integers, the coordinates times their common denominator.

    >>> dot_at_subdivision(mpq(1), mpq(1, 2), mpq(2))
    0
    """
    x = a.numerator * (c.denominator * d.denominator)
    low, middle = 0, c.numerator * (a.denominator * d.denominator)
    high = middle + d.numerator * (a.denominator * c.denominator)
    return int(sign(x * x + (low - middle) * (high - middle)))
