"""Lemma 12's reduction: nonobtuse, conforming, and never more triangles than two a cell."""

from __future__ import annotations

from itertools import pairwise

import pytest
from gmpy2 import mpq
from hypothesis import given, settings

from bern_exact.convex.block_records import Blocks, Reduced
from bern_exact.convex.cells import Cells
from bern_exact.convex.merge import merge
from bern_exact.convex.reduction import is_mergeable, reduce_blocks, removable, two_thirds_median
from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.oracle.fast import verify_mesh
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from tests.convex.samples import SCALES, disc, gap_lists, lines, rectangle, rectangles, staircases

RIGHT = parse_angle_bound("90")


def mesh_of(cells: Cells, triangles: object) -> Mesh:
    """The triangles with their grid points as vertices."""
    number: dict[tuple[int, int], int] = {}
    corners = tuple(tuple(number.setdefault(p, len(number)) for p in t) for t in triangles)
    points: tuple[HPoint, ...] = tuple(hpoint(cells.xs[j], cells.ys[i]) for j, i in number)
    return Mesh(points, corners)


def sides_of(blocks: Blocks) -> Polygon:
    """The one block, a vertex where each line ends."""
    (block,) = blocks.blocks
    xs, ys = range(block.x0, block.x1 + 1), range(block.y0, block.y1 + 1)
    ring = [(x, block.y0) for x in xs[:-1]] + [(block.x1, y) for y in ys[:-1]]
    ring += [(x, block.y1) for x in xs[:0:-1]] + [(block.x0, y) for y in ys[:0:-1]]
    points = tuple(hpoint(blocks.cells.xs[j], blocks.cells.ys[i]) for j, i in ring)
    return Polygon(points, (tuple(range(len(points))),))


def judged(reduced: Reduced) -> None:
    """Each block a triangulation that conforms to its lines, no angle above 90 degrees."""
    for block in reduced.blocks:
        alone = Blocks(reduced.merged.cells, (block.block,))
        verdict = verify_mesh(
            mesh_of(alone.cells, block.triangles), sides_of(alone), max_angle=RIGHT
        )
        assert verdict.valid, verdict.defects


@given(rectangles())
def test_a_rectangle_is_triangulated_without_obtuse_angles(blocks: Blocks) -> None:
    judged(reduce_blocks(blocks))


@given(rectangles())
def test_no_other_vertex_comes_to_lie_on_its_sides(blocks: Blocks) -> None:
    (block,) = blocks.blocks
    used = {p for t in reduce_blocks(blocks).triangles for p in t}
    on_sides = {p for p in used if p[0] in block[:2] or p[1] in block[2:]}
    assert len(on_sides) == 2 * (block.x1 + block.y1)


@given(rectangles(20))
def test_never_more_than_two_triangles_a_cell(blocks: Blocks) -> None:
    assert reduce_blocks(blocks).number <= 2 * blocks.cells.number


@given(gap_lists(), gap_lists(), SCALES)
def test_scaling_changes_nothing(columns: list[mpq], rows: list[mpq], factor: mpq) -> None:
    scaled = rectangle([factor * w for w in columns], [factor * h for h in rows])
    assert reduce_blocks(scaled).blocks == reduce_blocks(rectangle(columns, rows)).blocks


@settings(max_examples=40)
@given(staircases())
def test_a_region_is_triangulated_as_a_whole(cells: Cells) -> None:
    """The blocks match: the edges without a reverse are those of the outline."""
    reduced = reduce_blocks(merge(cells))
    judged(reduced)
    edges = {(t[i - 1], t[i]) for t in reduced.triangles for i in range(3)}
    free = {(p, q) for p, q in edges if (q, p) not in edges}
    assert all(abs(p[0] - q[0]) + abs(p[1] - q[1]) == 1 for p, q in free)
    doubled = sum(
        (cells.xs[t[1][0]] - cells.xs[t[0][0]]) * (cells.ys[t[2][1]] - cells.ys[t[0][1]])
        - (cells.xs[t[2][0]] - cells.xs[t[0][0]]) * (cells.ys[t[1][1]] - cells.ys[t[0][1]])
        for t in reduced.triangles
    )
    whole = sum(
        (cells.xs[j + 1] - cells.xs[j]) * (cells.ys[cells.high[j]] - cells.ys[cells.low[j]])
        for j in range(len(cells.low))
    )
    assert doubled == 2 * whole


@pytest.mark.parametrize("size", [1, 2, 7])
def test_one_row_or_column_is_cut_by_diagonals(size: int) -> None:
    gaps = [mpq(i + 1) for i in range(size)]
    for blocks in (rectangle(gaps, [mpq(1)]), rectangle([mpq(1)], gaps)):
        reduced = reduce_blocks(blocks)
        judged(reduced)
        assert reduced.number == 2 * size


def test_two_by_two_squares_need_six_triangles() -> None:
    """Nothing lies between l and r, and still the line through both is removed."""
    reduced = reduce_blocks(rectangle([mpq(1)] * 2, [mpq(1)] * 2))
    judged(reduced)
    assert reduced.number == 6


@given(SCALES, SCALES, SCALES)
def test_lemma_10_is_the_angle_at_the_subdivision(a: mpq, c: mpq, d: mpq) -> None:
    assert is_mergeable(c, d, a) == (a * a >= c * d)


def test_lemma_10_takes_equality() -> None:
    assert is_mergeable(mpq(9), mpq(4), mpq(6))
    assert not is_mergeable(mpq(9), mpq(4) + mpq(1, 10**50), mpq(6))


@given(gap_lists(9), SCALES)
def test_as_many_lines_as_possible_are_removed(gaps: list[mpq], width: mpq) -> None:
    able = [i for i in range(1, len(gaps)) if gaps[i - 1] * gaps[i] <= width**2]
    best = 0
    for chosen in range(1 << len(able)):
        kept = [able[j] for j in range(len(able)) if chosen >> j & 1]
        if all(b - a > 1 for a, b in pairwise(kept)):
            best = max(best, len(kept))
    assert len(removable(gaps, width)) == best


@pytest.mark.parametrize(("size", "part"), [(60, mpq(3, 5)), (160, mpq(2, 5))])
def test_many_lines(size: int, part: mpq) -> None:
    cells = disc(size)
    reduced = reduce_blocks(merge(cells))
    judged(reduced)
    assert reduced.number < 2 * cells.number * part


@pytest.mark.parametrize("ratio", [mpq(1), mpq(1, 2), mpq(99, 100), mpq(10)])
def test_geometric_progressions(ratio: mpq) -> None:
    gaps = [ratio**i for i in range(30)]
    for rows in (gaps, gaps[::-1], [mpq(1)] * 30):
        judged(reduce_blocks(rectangle(gaps, rows)))


def test_a_uniform_grid_is_reduced_at_every_level() -> None:
    """With the printed, strict form of Lemma 10 nothing would be."""
    blocks = rectangle([mpq(1)] * 64, [mpq(1)] * 64)
    reduced = reduce_blocks(blocks)
    assert 10 * reduced.number < 2 * blocks.cells.number
    assert lines([mpq(1)] * 2) == (0, 1, 2)


@given(gap_lists(20))
def test_half_of_the_lines_before_and_after_the_wide_strips_go(gaps: list[mpq]) -> None:
    """What the better exponent of Lemma 12 rests on."""
    width = two_thirds_median(gaps)
    wide = [i for i, gap in enumerate(gaps) if gap >= width]
    before, after = wide[0], len(gaps) - 1 - wide[-1]
    assert len(removable(gaps, width)) >= before // 2 + after // 2
