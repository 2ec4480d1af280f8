"""Lemma 11: how many lines go between two strips."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby, pairwise

from gmpy2 import mpq

from bern_exact.checkers.block_lines import Cut, Measured, squared_ratio
from bern_exact.checkers.bounds_convex import (
    EPSILON,
    eliminated,
    eliminated_between_medians,
    eliminated_in_outer_part,
)
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.convex.block_records import SPLIT, Reduced

STAGE = "reduced"


def check_lemma_11(reduced: Reduced) -> tuple[Finding, ...]:
    """The claims of Lemma 11 at each pair of strips.

    Lemma 11: "Let a rectangle be given with m subdivisions on its vertical sides [...]. Let a and
    b be the widths of two columns, with min{a, b} at least as large as (1/2 + eps) m of the row
    heights. Then eps m - 1 horizontal lines can be eliminated between the columns."

    Parameters
    ----------
    reduced : Reduced
        The record.

    Returns
    -------
    tuple of Finding
        `lemma-11.alone`, `.most`, `.lines`, `.any-epsilon`, `.medians`, `.outer`.
    """
    measured = Measured(reduced.merged.cells)
    alone, most = Violations(), Violations()
    sixth, every, medians, outer = Extreme(), Extreme(), Extreme(), Extreme()
    for cut in measured.cuts(reduced):
        gone = len(cut.node.removed)
        alone.case(_are_apart(cut), cut.place)
        if not cut.is_double:
            most.case(gone == 0, cut.place)
            continue
        most.case(gone == sum(_runs(cut)), cut.place)
        _offer_epsilons(cut, sixth, every)
        rows = len(cut.gaps)
        if cut.node.level == SPLIT:
            _offer(medians, gone - eliminated_between_medians(rows), cut)
        else:
            _offer(outer, gone - eliminated_in_outer_part(rows), cut)
    zero = mpq(0)
    return (
        alone.finding(
            "lemma-11.alone",
            STAGE,
            "No two of the lines removed at a time are next to each other, and none is a side.",
        ),
        most.finding(
            "lemma-11.most",
            STAGE,
            "As many lines are removed as can be, half of each run of removable ones, rounded up; "
            "with one strip alone, none.",
        ),
        sixth.finding(
            "lemma-11.lines",
            STAGE,
            "Of S lines, if both widths are at least (1/2 + 1/6) S of the distances, at least "
            "S/6 - 1 are eliminated (lines beyond that).",
            zero,
        ),
        every.finding(
            "lemma-11.any-epsilon",
            STAGE,
            "Of S lines, if both widths are at least h = (1/2 + epsilon) S of the distances, at "
            "least epsilon S - 1 are eliminated, for the greatest epsilon (lines beyond that).",
            zero,
        ),
        medians.finding(
            "lemma-11.medians",
            STAGE,
            "Between l and r, found by the 2/3-median, at least a sixth of the lines is "
            "eliminated (lines beyond that).",
            zero,
        ),
        outer.finding(
            "lemma-11.outer",
            STAGE,
            "In an outer part at least half of the lines is eliminated (lines beyond that).",
            zero,
        ),
    )


def check_lemma_11_as_printed(reduced: Reduced) -> tuple[Finding, ...]:
    """ "By Lemma 11 we can eliminate m/6 rows between the two columns": (m - 1)/6, exactly."""
    measured = Measured(reduced.merged.cells)
    sixth = Extreme()
    for cut in measured.cuts(reduced):
        if cut.is_double and cut.node.level == SPLIT:
            _offer(sixth, len(cut.node.removed) - EPSILON * len(cut.gaps), cut)
    return (
        sixth.finding(
            "lemma-11.printed-sixth",
            STAGE,
            "At least m/6 of m rows are eliminated between l and r (rows beyond that).",
            mpq(0),
            role="as-printed",
        ),
    )


def _offer(extreme: Extreme, value: mpq, cut: Cut) -> None:
    extreme.offer(value.numerator, value.denominator, cut.place)


def _offer_epsilons(cut: Cut, sixth: Extreme, every: Extreme) -> None:
    """Lemma 11 with epsilon = 1/6, if its hypothesis holds, and with the greatest epsilon > 0."""
    lines, gone, width = len(cut.gaps) - 1, len(cut.node.removed), cut.width
    if lines == 0:
        return
    covered = sum(gap <= width for gap in cut.gaps)
    if covered >= (mpq(1, 2) + EPSILON) * lines:
        _offer(sixth, gone - eliminated(lines), cut)
    epsilon = mpq(covered, lines) - mpq(1, 2)
    if epsilon > 0:
        _offer(every, gone - eliminated(lines, epsilon), cut)


def _are_apart(cut: Cut) -> bool:
    """Are the removed lines inside, increasing, and each after one that stays?"""
    position = {line: i for i, line in enumerate(cut.node.lines[1:-1])}
    found = [position.get(line, -1) for line in cut.node.removed]
    return min(found, default=0) >= 0 and all(b - a > 1 for a, b in pairwise(found))


def _runs(cut: Cut) -> Iterator[int]:
    """How many of each run of lines that Lemma 10 lets go can go together."""
    width = cut.width

    def goes(pair: tuple[mpq, mpq]) -> bool:
        above, below = squared_ratio(width, *pair)
        return bool(above >= below)

    for able, run in groupby(pairwise(cut.gaps), key=goes):
        if able:
            yield (len(list(run)) + 1) // 2
