"""Lemma 6 on the cells of the bounced grid: each in one block, and few vertices."""

from __future__ import annotations

from bern_exact.checkers.bounds import halving_vertices
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.lemma_12 import ring_of
from bern_exact.convex.block_records import Blocks
from bern_exact.convex.cells import Cells

STAGE = "merged"


def check_merged_cells(blocks: Blocks, gridded: Cells) -> tuple[Finding, ...]:
    """The claims of Lemma 6 on Q, an orthoconvex region of unit squares in index space.

    Parameters
    ----------
    blocks : Blocks
        The record.
    gridded : Cells
        The cells of the grid that was merged, by the record of the stage before.

    Returns
    -------
    tuple of Finding
        `lemma-6.cells`, `lemma-6.cover`, `lemma-6.vertices`.

    Notes
    -----
    That blocks match needs no check: each line is whole within Q, so each side of a block has
    a vertex at every line across it.  O(V) for V vertices.
    """
    same, cover, vertices = Violations(), Violations(), Extreme(greatest=True)
    cells = blocks.cells
    same.case(cells == gridded, {"cells": cells.number, "of the grid": gridded.number})
    stacks: list[list[tuple[int, int]]] = [[] for _ in cells.low]
    for block in blocks.blocks:
        inside = 0 <= block.x0 < block.x1 <= len(stacks)
        cover.case(inside and block.y0 < block.y1, block)
        if inside:
            for stack in stacks[block.x0 : block.x1]:
                stack.append((block.y0, block.y1))
    for j, stack in enumerate(stacks):
        cover.case(_fills(sorted(stack), cells.low[j], cells.high[j]), j)
    points = {p for block in blocks.blocks for p in ring_of(block)}
    vertices.offer(len(points), 1, None)
    return (
        same.finding("lemma-6.cells", STAGE, "The merged cells are those of the grid."),
        cover.finding("lemma-6.cover", STAGE, "Each cell lies in exactly one block."),
        vertices.finding(
            "lemma-6.vertices",
            STAGE,
            "The blocks have at most 1.5 N log2 N - 0.5 N vertices, for N edges of cells on the "
            "boundary of Q.",
            halving_vertices(boundary_edges(cells)),
        ),
    )


def _fills(stack: list[tuple[int, int]], low: int, high: int) -> bool:
    """Do these intervals, from the lowest on, fill low to high?"""
    for start, stop in stack:
        if start != low:
            return False
        low = stop
    return low == high


def boundary_edges(cells: Cells) -> int:
    """N: the edges of cells on the boundary of Q.

    >>> boundary_edges(Cells((), (), (0, 1), (2, 2)))
    8
    """
    edges, before, stop = 0, 0, 0
    for low, high in zip((*cells.low, 0), (*cells.high, 0), strict=True):
        edges += 2 if low < high else 0
        shared = max(0, min(stop, high) - max(before, low))
        edges += (stop - before) + (high - low) - 2 * shared
        before, stop = low, high
    return edges
