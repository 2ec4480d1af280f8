"""Sentences of Sections 5.1 and 5.2 on the recursion that are false as printed."""

from __future__ import annotations

from collections.abc import Iterator

from gmpy2 import mpq

from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.convex.block_records import LEAF, OUTER, SPLIT, Node, Reduced, ReducedBlock

STAGE = "reduced"


def check_lemma_12_as_printed(reduced: Reduced) -> tuple[Finding, ...]:
    """What is printed of l, r and the seven parts.

    Parameters
    ----------
    reduced : Reduced
        The record.

    Returns
    -------
    tuple of Finding
        `lemma-12.printed-strips`, `.printed-separation`, `.printed-aspect`.
    """
    strips, separation, aspect = Extreme(greatest=True), Extreme(), Violations()
    for block in reduced.blocks:
        for i, node in enumerate(block.nodes):
            place = (block.block, i)
            if node.level == LEAF:
                continue
            columns, rows = node.size
            if node.first < node.last:
                strips.offer(2 * (2 * rows - len(node.removed)), rows, place)
            separation.offer(node.last - node.first - 1, columns, place)
            if node.level == SPLIT and node.turned and columns < rows:
                for part in seven_parts(block, node):
                    aspect.case(len(part.rows) < len(part.columns), place)
    return (
        strips.finding(
            "lemma-12.printed-strips",
            STAGE,
            "Columns l and r are triangulated using m triangles (ratio; it is 2 m - e for each).",
            mpq(1),
            role="as-printed",
        ),
        separation.finding(
            "lemma-12.printed-separation",
            STAGE,
            "l and r are separated by at least a third of the columns (true if these two count).",
            mpq(1, 3),
            role="as-printed",
        ),
        aspect.finding(
            "lemma-12.printed-aspect",
            STAGE,
            "If m < k and the first split is by rows, m' < k' in all seven parts.",
            role="as-printed",
        ),
    )


def seven_parts(block: ReducedBlock, node: Node) -> Iterator[Node]:
    """The parts of a split, those of its outer parts in place of these (Figure 11(b))."""
    for j in node.parts:
        if j >= 0 and block.nodes[j].level == OUTER and j != node.parts[1]:
            yield from (block.nodes[i] for i in block.nodes[j].parts if i >= 0)
        elif j >= 0:
            yield block.nodes[j]
