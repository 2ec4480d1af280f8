"""Lemma 10: where a line may end in the middle of a side without an obtuse angle."""

from __future__ import annotations

from itertools import pairwise

from gmpy2 import mpq, mpz

from bern_exact.checkers.block_lines import Cut, Measured, squared_ratio
from bern_exact.checkers.bounds_convex import LEAST_WIDTH_SQUARED
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.convex.block_records import Reduced

STAGE = "reduced"
AT_SUBDIVISION = 0
"""The subdivision, among the vertices of the pentagon."""


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
            "A rectangle a wide with one subdivision, c and d from its ends, has a triangulation "
            "without an obtuse angle, of the five there may be, if and only if a^2 >= c d.",
        ),
        sufficient.finding(
            "lemma-10.sufficient",
            STAGE,
            "If the width is greater than either distance, as printed, none of the nine angles of "
            "the three triangles at the subdivision is obtuse.",
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
            found = nonobtuse_triangulation(a, c, d)
            iff.case((found is not None) == (above >= below), place)
            if a > c and a > d:
                sufficient.case(found == AT_SUBDIVISION, place)
            if node.lines[i] in gone:
                removed.offer(above, below, place)


def nonobtuse_triangulation(a: mpq, c: mpq, d: mpq) -> int | None:
    """A triangulation of the rectangle with one subdivision, without an obtuse angle.

    All five of the pentagon of its corners and the subdivision are looked at, each the three
    triangles at one of its vertices; those with a flat triangle are none.

    Returns
    -------
    int or None
        The vertex at which the three triangles are, `AT_SUBDIVISION` if that is possible; None
        if each triangulation has an obtuse angle.

    Examples
    --------
    >>> nonobtuse_triangulation(mpq(1), mpq(1, 2), mpq(2))
    0
    >>> nonobtuse_triangulation(mpq(1), mpq(2, 3), mpq(2))
    """
    pentagon = _pentagon(a, c, d)
    for vertex in range(len(pentagon)):
        if _is_nonobtuse_fan(pentagon[vertex:] + pentagon[:vertex]):
            return vertex
    return None


def _pentagon(a: mpq, c: mpq, d: mpq) -> list[tuple[mpz, mpz]]:
    """The subdivision and the corners after it, counter-clockwise, times a common denominator."""
    x = a.numerator * (c.denominator * d.denominator)
    middle = c.numerator * (a.denominator * d.denominator)
    high = middle + d.numerator * (a.denominator * c.denominator)
    zero = mpz(0)
    return [(zero, middle), (zero, zero), (x, zero), (x, high), (zero, high)]


def _is_nonobtuse_fan(pentagon: list[tuple[mpz, mpz]]) -> bool:
    """Are the triangles at the first vertex of positive area, and none of them obtuse?"""
    p, *others = pentagon
    return all(_is_nonobtuse(p, q, r) for q, r in pairwise(others))


def _is_nonobtuse(p: tuple[mpz, mpz], q: tuple[mpz, mpz], r: tuple[mpz, mpz]) -> bool:
    """Is a triangle counter-clockwise, with three angles of at most 90 degrees?"""
    ux, uy = q[0] - p[0], q[1] - p[1]
    vx, vy = r[0] - q[0], r[1] - q[1]
    wx, wy = p[0] - r[0], p[1] - r[1]
    return bool(
        ux * vy > uy * vx
        and ux * wx + uy * wy <= 0
        and ux * vx + uy * vy <= 0
        and vx * wx + vy * wy <= 0
    )
