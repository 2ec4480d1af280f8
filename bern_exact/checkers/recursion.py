"""The recursion behind Lemma 12: its parts, its medians and its recurrence (Section 5.1)."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from gmpy2 import mpq

from bern_exact.checkers.block_lines import Cut, Measured
from bern_exact.checkers.bounds_convex import SEPARATION, grid_triangles, strip_triangles
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.convex.block_records import LEAF, OUTER, SPLIT, Node, Reduced, ReducedBlock

STAGE = "reduced"
Lists = tuple[tuple[int, ...], tuple[int, ...]]
"""The verticals and the horizontals of a rectangle."""


def check_recursion(reduced: Reduced, measured: Measured) -> tuple[Finding, ...]:
    """What the recursion claims of each of its nodes.

    Parameters
    ----------
    reduced : Reduced
        The record.
    measured : Measured
        Its lines.

    Returns
    -------
    tuple of Finding
        `lemma-12.parts`, `.medians`, `.separation`, `.count`, `.recurrence`.
    """
    parts, medians, count = Violations(), Violations(), Violations()
    separation, recurrence = Extreme(), Extreme(greatest=True)
    for block in reduced.blocks:
        place = block.block
        count.case(_is_whole(block), place)
        bounds: list[int] = []
        if block.nodes:
            parts.case(_is_divided_afresh(block.nodes[-1]), (place, len(block.nodes) - 1))
        for i, node in enumerate(block.nodes):
            parts.case(_parts_are_right(block, i), (place, i))
            known = [bounds[j] for j in node.parts if 0 <= j < i]
            bounds.append(recurrence_of(node, known))
            recurrence.offer(node.triangles, max(bounds[i], 1), (place, i))
            made = [block.nodes[j].triangles for j in node.parts if 0 <= j < i]
            count.case(node.triangles == _counted(node, made), (place, i))
            if node.level != LEAF and 0 <= node.first <= node.last < node.size[0]:
                cut = measured.cut((place, i), node)
                separation.offer(node.last - node.first + 1, len(cut.strips), cut.place)
                if node.level == SPLIT:
                    medians.case(_medians_are_right(block, cut, measured), cut.place)
    return (
        parts.finding(
            "lemma-12.parts",
            STAGE,
            "A rectangle of the recursion is what is before, between and after the strips l and "
            "r, with all lines but those removed between; the last is the block. What is before "
            "or after in two strips or more is cut across, as an outer part; all others are "
            "divided afresh.",
        ),
        medians.finding(
            "lemma-12.medians",
            STAGE,
            "l and r are the first and the last strip at least M wide, M being the lesser of the "
            "2/3-medians; all strips of the outer parts are narrower, and these are cut "
            "along the first and the last line strip that is at least M wide.",
        ),
        separation.finding(
            "lemma-12.separation",
            STAGE,
            "l, r and the strips between them are at least a third of the strips.",
            SEPARATION,
        ),
        count.finding(
            "lemma-12.count",
            STAGE,
            "A rectangle has the triangles of its parts, and 2 m minus the lines removed for each "
            "of l and r.",
        ),
        recurrence.finding(
            "lemma-12.recurrence",
            STAGE,
            "It has at most as many triangles as the recurrence gives, with 2 m for each of l "
            "and r (ratio).",
            mpq(1),
        ),
    )


def recurrence_of(node: Node, parts: list[int]) -> int:
    """R of a node from the R of its parts: 2 m more for each of l and r; in a leaf 2 m k.

    "R(m, k) = R(l - 1, m) + R(r - l - 1, 5m/6) + R(k - r, m) + m", but for the last term.
    """
    strips, rows = node.size
    if node.level == LEAF:
        return grid_triangles(strips, rows)
    return sum(parts) + strip_triangles(rows) * (2 if node.first < node.last else 1)


def _counted(node: Node, parts: list[int]) -> int:
    """How many triangles it has: as the recurrence, minus one a line removed in each strip."""
    saved = len(node.removed) * (2 if node.first < node.last else 0)
    return recurrence_of(node, parts) - saved


def _is_whole(block: ReducedBlock) -> bool:
    """Is the last node the block, with all triangles, and each other one a part of one node?"""
    if not block.nodes:
        return False
    x0, x1, y0, y1 = block.block
    root = block.nodes[-1]
    lists = (tuple(range(x0, x1 + 1)), tuple(range(y0, y1 + 1)))
    used = sorted(j for node in block.nodes for j in node.parts if j >= 0)
    return (
        (root.columns, root.rows) == lists
        and root.triangles == len(block.triangles)
        and used == list(range(len(block.nodes) - 1))
    )


def _parts_are_right(block: ReducedBlock, number: int) -> bool:
    """Are its parts the three rectangles that l and r leave?"""
    node = block.nodes[number]
    if min(node.size) < 1:
        return False
    if node.level == LEAF:
        none = (node.parts, node.first, node.last) == ((-1, -1, -1), -1, -1)
        return none and 1 in node.size and not (node.removed or node.turned)
    if node.level not in (SPLIT, OUTER) or not 0 <= node.first <= node.last < node.size[0]:
        return False
    if not all(a < b for lines in (node.strips, node.lines) for a, b in pairwise(lines)):
        return False
    for position, (columns, rows) in enumerate(_rectangles(node)):
        j = node.parts[position]
        if len(columns) < 2 or len(rows) < 2:
            if j != -1:
                return False
        elif not 0 <= j < number:
            return False
        else:
            part = block.nodes[j]
            if (part.columns, part.rows) != (columns, rows) or not _fits(node, position, part):
                return False
    return True


def _fits(node: Node, position: int, part: Node) -> bool:
    """Is a part of the level that its place in Figure 11 asks for?

    Of a split, what is before l and after r is divided across by Figure 11(b) if it has two strips
    or more.  Everything else is divided afresh.  Without this a split would be excused from its
    medians by the label of an outer part.
    """
    if node.level == SPLIT and position != 1:
        strips = len(part.columns if not node.turned else part.rows) - 1
        if strips >= 2:
            return part.level == OUTER and part.turned != node.turned
    return _is_divided_afresh(part)


def _is_divided_afresh(node: Node) -> bool:
    """Is a rectangle with a single row or column a leaf, and any other one split by its medians?"""
    return node.level == (LEAF if 1 in node.size else SPLIT)


def _rectangles(node: Node) -> Iterator[Lists]:
    """The lines before, between and after l and r."""
    gone = set(node.removed)
    kept = tuple(line for line in node.lines if line not in gone)
    strips, first, last = node.strips, node.first, node.last
    for near, lines in (
        (strips[: first + 1], node.lines),
        (strips[first + 1 : last + 1], kept),
        (strips[last + 1 :], node.lines),
    ):
        yield (lines, near) if node.turned else (near, lines)


def _medians_are_right(block: ReducedBlock, cut: Cut, measured: Measured) -> bool:
    """l and r of a split, and of its outer parts."""
    of_columns, of_rows = (_median(widths) for widths in measured.sizes(cut.node))
    least = min(of_columns, of_rows)
    if cut.node.turned != (of_columns < of_rows) or not _are_outermost(cut, least):
        return False
    for j in (cut.node.parts[0], cut.node.parts[2]):
        if 0 <= j < len(block.nodes) and block.nodes[j].level == OUTER:
            outer = measured.cut((cut.place[0], j), block.nodes[j])
            if outer.node.turned == cut.node.turned or not _are_outermost(outer, least):
                return False
    return True


def _median(widths: list[mpq]) -> mpq:
    """The least width that fewer than a third of all exceed, or as many at most: see `medians`."""
    return sorted(widths)[2 * len(widths) // 3]


def _are_outermost(cut: Cut, least: mpq) -> bool:
    """Are l and r the first and the last strip of at least this width?"""
    wide = [i for i, width in enumerate(cut.strips) if width >= least]
    return bool(wide) and (wide[0], wide[-1]) == (cut.node.first, cut.node.last)
