"""Cells merged into blocks."""

from __future__ import annotations

from collections import Counter

from gmpy2 import mpq
from hypothesis import given, settings

from bern_exact.convex.block_records import Block, Blocks
from bern_exact.convex.cells import Cells
from bern_exact.convex.merge import merge, outline
from tests.convex.samples import disc, staircases


def every_cell(cells: Cells) -> list[tuple[int, int]]:
    columns = enumerate(zip(cells.low, cells.high, strict=True))
    return [(j, i) for j, (low, high) in columns for i in range(low, high)]


def covered(blocks: Blocks) -> Counter[tuple[int, int]]:
    return Counter(
        (j, i) for b in blocks.blocks for j in range(b.x0, b.x1) for i in range(b.y0, b.y1)
    )


@settings(max_examples=40)
@given(staircases())
def test_each_cell_lies_in_one_block(cells: Cells) -> None:
    assert covered(merge(cells)) == Counter(every_cell(cells))


@settings(max_examples=40)
@given(staircases())
def test_the_outline_encloses_the_cells(cells: Cells) -> None:
    loops = outline(cells).loops
    area = sum(
        p[0] * q[1] - q[0] * p[1]
        for loop in loops
        for q, p in zip(loop, loop[1:] + loop[:1], strict=True)
    )
    assert -area == 2 * cells.number
    assert all(
        abs(loop[i - 1][0] - x) + abs(loop[i - 1][1] - y) == 1
        for loop in loops
        for i, (x, y) in enumerate(loop)
    )


def test_parts_that_touch_in_a_point_are_apart() -> None:
    lines = tuple(mpq(i) for i in range(3))
    cells = Cells(lines, lines, (0, 1), (1, 2))
    assert len(outline(cells).loops) == 2
    assert merge(cells).blocks == (Block(0, 1, 0, 1), Block(1, 2, 1, 2))


def test_columns_without_a_cell_are_skipped() -> None:
    lines = tuple(mpq(i) for i in range(4))
    cells = Cells(lines, lines, (1, 0, 1), (1, 2, 1))
    assert merge(cells).blocks == (Block(1, 2, 0, 2),)


def test_no_cells_no_blocks() -> None:
    assert merge(Cells((mpq(0), mpq(1)), (mpq(0),), (0,), (0,))).blocks == ()


def test_few_blocks() -> None:
    cells = disc(200)
    assert len(merge(cells).blocks) < 4 * len(cells.xs)
