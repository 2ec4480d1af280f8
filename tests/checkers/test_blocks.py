"""The checkers of Section 5.1 hold on what is built, and notice every damage."""

from __future__ import annotations

from dataclasses import replace
from itertools import product

import pytest
from gmpy2 import mpq
from hypothesis import given, settings

from bern_exact.checkers import bounds_convex, lemma_10
from bern_exact.checkers.findings import Finding, demand
from bern_exact.checkers.lemma_10 import check_lemma_10, check_lemma_10_as_printed
from bern_exact.checkers.lemma_11 import check_lemma_11, check_lemma_11_as_printed
from bern_exact.checkers.lemma_12 import check_lemma_12
from bern_exact.checkers.merged_cells import boundary_edges, check_merged_cells
from bern_exact.checkers.printed_recursion import check_lemma_12_as_printed
from bern_exact.convex.block_records import LEAF, OUTER, SPLIT, Block, Blocks, Reduced
from bern_exact.convex.cells import Cells
from bern_exact.convex.merge import merge, outline
from bern_exact.convex.reduction import reduce_blocks
from tests.convex.samples import SCALES, disc, lines, rectangle, rectangles, staircases
from tests.convex.worst_case import worst_cases

UNIFORM = reduce_blocks(rectangle([mpq(1)] * 9, [mpq(1)] * 8))
"""One block with a split at its root, and lines removed."""

WIDE = reduce_blocks(
    rectangle([mpq(i % 3, 4) + 1 for i in range(12)], [mpq(i % 5, 3) + 1 for i in range(11)])
)
"""One block with all widths mixed."""

OUTERS = reduce_blocks(rectangle([mpq(1, 9)] * 4 + [mpq(3)] * 3 + [mpq(1, 9)] * 2, [mpq(1)] * 9))
"""One block with outer parts on both sides."""


def every(reduced: Reduced) -> list[Finding]:
    return [
        *check_merged_cells(reduced.merged, reduced.merged.cells),
        *check_lemma_10(reduced),
        *check_lemma_11(reduced),
        *check_lemma_12(reduced),
    ]


def failing(reduced: Reduced) -> set[str]:
    return {f.claim for f in every(reduced) if not f.holds}


def root_with(reduced: Reduced, **changes: object) -> Reduced:
    """The record with its last node changed."""
    (block,) = reduced.blocks
    nodes = (*block.nodes[:-1], block.nodes[-1]._replace(**changes))
    return replace(reduced, blocks=(block._replace(nodes=nodes),))


def node_with(reduced: Reduced, number: int, **changes: object) -> Reduced:
    """The record with one node changed."""
    (block,) = reduced.blocks
    nodes = list(block.nodes)
    nodes[number] = nodes[number]._replace(**changes)
    return replace(reduced, blocks=(block._replace(nodes=tuple(nodes)),))


def with_triangles(reduced: Reduced, triangles: tuple[object, ...]) -> Reduced:
    (block,) = reduced.blocks
    return replace(reduced, blocks=(block._replace(triangles=triangles),))


def with_cells(reduced: Reduced, cells: Cells) -> Reduced:
    return replace(reduced, merged=replace(reduced.merged, cells=cells))


@given(rectangles())
def test_every_claim_holds_on_a_rectangle(blocks: Blocks) -> None:
    demand(every(reduce_blocks(blocks)))


@settings(max_examples=50)
@given(staircases())
def test_every_claim_holds_on_a_region(cells: Cells) -> None:
    demand(every(reduce_blocks(merge(cells))))


def test_every_claim_holds_with_many_lines() -> None:
    demand(every(reduce_blocks(merge(disc(300)))))


@settings(max_examples=30)
@given(staircases())
def test_the_boundary_is_counted(cells: Cells) -> None:
    assert boundary_edges(cells) == outline(cells).edges


@pytest.mark.parametrize("reduced", [UNIFORM, WIDE])
def test_the_samples_are_what_they_should_be(reduced: Reduced) -> None:
    assert not failing(reduced)
    root = reduced.blocks[0].nodes[-1]
    assert root.level == SPLIT
    assert root.first < root.last
    assert root.removed


# Damage to the blocks ----------------------------------------------------------------


@pytest.mark.parametrize(
    "blocks",
    [(), (Block(0, 9, 0, 7),), (Block(0, 9, 0, 8), Block(3, 4, 2, 3)), (Block(0, 10, 0, 8),)],
)
def test_cells_in_no_block_or_in_two(blocks: tuple[Block, ...]) -> None:
    damaged = Blocks(UNIFORM.merged.cells, blocks)
    found = check_merged_cells(damaged, damaged.cells)
    assert [f.claim for f in found if not f.holds] == ["lemma-6.cover"]


def test_cells_that_are_not_the_grids() -> None:
    """Stretched, they would be reduced otherwise, and all other claims of the stage hold."""
    cells = UNIFORM.merged.cells
    stretched = Blocks(replace(cells, xs=tuple(1000 * x for x in cells.xs)), UNIFORM.merged.blocks)
    found = check_merged_cells(stretched, cells)
    assert [f.claim for f in found if not f.holds] == ["lemma-6.cells"]


def test_too_many_small_blocks() -> None:
    side = 80
    cells = rectangle([mpq(1)] * side, [mpq(1)] * side).cells
    single = tuple(Block(j, j + 1, i, i + 1) for j, i in product(range(side), repeat=2))
    found = check_merged_cells(Blocks(cells, single), cells)
    assert [f.claim for f in found if not f.holds] == ["lemma-6.vertices"]


def test_another_list_of_blocks() -> None:
    damaged = replace(UNIFORM, blocks=())
    assert failing(damaged) == {"lemma-12.tiling"}


# Damage to the triangles -------------------------------------------------------------


def test_a_missing_triangle() -> None:
    damaged = with_triangles(UNIFORM, UNIFORM.triangles[1:])
    assert failing(damaged) == {"lemma-12.tiling", "lemma-12.count"}


def test_a_triangle_twice() -> None:
    damaged = with_triangles(UNIFORM, (*UNIFORM.triangles, UNIFORM.triangles[0]))
    assert {"lemma-12.tiling", "lemma-12.count"} <= failing(damaged)


def test_a_clockwise_triangle() -> None:
    first, *rest = UNIFORM.triangles
    damaged = with_triangles(UNIFORM, (first[::-1], *rest))
    assert failing(damaged) == {"lemma-12.tiling"}


def test_a_triangle_without_an_upright_side() -> None:
    damaged = with_triangles(UNIFORM, (((0, 0), (2, 1), (1, 2)), *UNIFORM.triangles[1:]))
    assert failing(damaged) >= {"lemma-12.tiling", "lemma-12.angle"}


def test_a_vertex_on_a_side_that_is_not_used() -> None:
    """Two triangles on a side become one: its vertex is left out."""
    blocks = rectangle([mpq(1), mpq(1)], [mpq(1)])
    reduced = reduce_blocks(blocks)
    larger = (((0, 0), (2, 0), (2, 1)), ((0, 0), (2, 1), (0, 1)))
    assert "lemma-12.tiling" in failing(with_triangles(reduced, larger))


def test_an_obtuse_triangle() -> None:
    """The rows apart, what had right angles at the subdivisions gets obtuse ones."""
    cells = replace(UNIFORM.merged.cells, ys=lines([mpq(11, 10)] * 8))
    damaged = with_cells(UNIFORM, cells)
    assert {"lemma-10.removed", "lemma-12.angle", "lemma-11.most"} <= failing(damaged)


@pytest.mark.parametrize("turn", [0, 1, 2])
@pytest.mark.parametrize("first", [False, True])
@pytest.mark.parametrize(
    "degenerate",
    [((0, 0), (0, 2), (0, 1)), ((0, 0), (2, 0), (1, 0)), ((1, 1), (1, 1), (1, 1))],
)
def test_a_degenerate_triangle(
    degenerate: tuple[tuple[int, int], ...], first: bool, turn: int
) -> None:
    """It fails the claim, and hides no obtuse triangle."""
    degenerate = (*degenerate[turn:], *degenerate[:turn])
    obtuse = ((0, 0), (1, 0), (9, 1))
    more = (degenerate, obtuse) if first else (obtuse, degenerate)
    found = check_lemma_12(with_triangles(UNIFORM, (*UNIFORM.triangles, *more)))
    angle = next(f for f in found if f.claim == "lemma-12.angle")
    assert (angle.holds, angle.measured) == (False, None)


def test_rows_without_height() -> None:
    ys = (mpq(0),) * len(UNIFORM.merged.cells.ys)
    damaged = with_cells(UNIFORM, replace(UNIFORM.merged.cells, ys=ys))
    assert {"lemma-12.angle", "lemma-10.removed"} <= failing(damaged)


def test_more_triangles_than_two_a_cell() -> None:
    damaged = with_triangles(UNIFORM, UNIFORM.triangles * 5)
    assert {"lemma-12.cells", "lemma-12.power"} <= failing(damaged)


# Damage to the recursion -------------------------------------------------------------


def test_a_removed_line_too_few() -> None:
    removed = UNIFORM.blocks[0].nodes[-1].removed[1:]
    assert failing(root_with(UNIFORM, removed=removed)) >= {
        "lemma-11.most",
        "lemma-12.parts",
        "lemma-12.count",
    }


def test_no_removed_line() -> None:
    assert failing(root_with(UNIFORM, removed=())) >= {
        "lemma-11.most",
        "lemma-11.lines",
        "lemma-11.any-epsilon",
        "lemma-11.medians",
    }


def test_no_removed_line_in_an_outer_part() -> None:
    columns = [mpq(1, 9)] * 4 + [mpq(3)] * 3 + [mpq(1, 9)] * 2
    reduced = reduce_blocks(rectangle(columns, [mpq(1)] * 9))
    assert not failing(reduced)
    (block,) = reduced.blocks
    outer = block.nodes[-1].parts[0]
    nodes = list(block.nodes)
    nodes[outer] = nodes[outer]._replace(removed=())
    damaged = replace(reduced, blocks=(block._replace(nodes=tuple(nodes)),))
    assert {"lemma-11.outer", "lemma-11.most", "lemma-12.parts"} <= failing(damaged)


@pytest.mark.parametrize("removed", [(1, 2), (0,), (8,), (3, 1)])
def test_lines_that_cannot_go_together(removed: tuple[int, ...]) -> None:
    assert "lemma-11.alone" in failing(root_with(UNIFORM, removed=removed))


@pytest.mark.parametrize(("first", "last"), [(1, 8), (0, 7), (3, 3), (0, 1)])
def test_other_strips(first: int, last: int) -> None:
    claims = failing(root_with(UNIFORM, first=first, last=last))
    assert "lemma-12.parts" in claims


def test_strips_that_are_not_the_outermost() -> None:
    """All parts right, but between the wrong strips: of narrow ones l may be any."""
    narrow, wide = mpq(1, 2), mpq(5)
    reduced = reduce_blocks(rectangle([narrow, wide, wide, wide], [mpq(1)] * 2))
    cells = replace(reduced.merged.cells, xs=lines([wide, narrow, wide, wide]))
    assert "lemma-12.medians" in failing(with_cells(reduced, cells))


def test_strips_too_close_to_each_other() -> None:
    claims = failing(root_with(UNIFORM, first=0, last=1))
    assert {"lemma-12.separation", "lemma-12.medians"} <= claims


@pytest.mark.parametrize("triangles", [0, 1000])
def test_a_wrong_count(triangles: int) -> None:
    claims = failing(root_with(UNIFORM, triangles=triangles))
    assert "lemma-12.count" in claims
    assert ("lemma-12.recurrence" in claims) == (triangles > 0)


def test_no_recursion_at_all() -> None:
    (block,) = UNIFORM.blocks
    damaged = replace(UNIFORM, blocks=(block._replace(nodes=()),))
    assert failing(damaged) == {"lemma-12.count"}


@pytest.mark.parametrize("parts", [(-1, -1, -1), (0, 0, 0), (99, 1, 2)])
def test_parts_that_are_not_its_own(parts: tuple[int, int, int]) -> None:
    assert {"lemma-12.parts", "lemma-12.count"} <= failing(root_with(UNIFORM, parts=parts))


@pytest.mark.parametrize("reduced", [UNIFORM, WIDE, OUTERS])
@pytest.mark.parametrize("level", [LEAF, SPLIT, OUTER])
def test_any_node_labelled_as_another_level(reduced: Reduced, level: int) -> None:
    for i, node in enumerate(reduced.blocks[0].nodes):
        if node.level != level:
            assert "lemma-12.parts" in failing(node_with(reduced, i, level=level)), (i, node)


def test_a_block_with_no_medians_at_all() -> None:
    """Every split labelled as an outer part: each is noticed, not the root alone."""
    (block,) = WIDE.blocks
    nodes = tuple(n._replace(level=OUTER) if n.level == SPLIT else n for n in block.nodes)
    damaged = replace(WIDE, blocks=(block._replace(nodes=nodes),))
    assert "lemma-12.parts" in failing(damaged)


def test_an_outer_part_cut_along_its_own_strips() -> None:
    (block,) = OUTERS.blocks
    i = next(i for i, node in enumerate(block.nodes) if node.level == OUTER)
    node = block.nodes[i]
    along = node_with(
        OUTERS, i, turned=not node.turned, strips=node.lines, lines=node.strips, removed=()
    )
    assert "lemma-12.parts" in {f.claim for f in check_lemma_12(along) if not f.holds}


@pytest.mark.parametrize("changes", [{"first": 0}, {"last": 5}, {"removed": (1,)}])
def test_a_leaf_with_strips_of_its_own(changes: dict[str, object]) -> None:
    nodes = UNIFORM.blocks[0].nodes
    leaf = next(i for i, node in enumerate(nodes) if node.level == LEAF)
    assert "lemma-12.parts" in failing(node_with(UNIFORM, leaf, **changes))


ROWS = reduce_blocks(rectangle([mpq(5)] * 4, [mpq(1), mpq(9), mpq(8), *[mpq(1)] * 6]))
"""Of its lines one, between rows 9 and 8 high, cannot end at a column 5 wide."""


@pytest.mark.parametrize(
    ("answer", "claims"),
    [
        (None, {"lemma-10.iff", "lemma-10.sufficient"}),
        (0, {"lemma-10.iff"}),
        (1, {"lemma-10.iff", "lemma-10.sufficient"}),
    ],
)
def test_the_condition_of_lemma_10_is_looked_at_both_ways(
    answer: int | None, claims: set[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert not failing(ROWS)
    monkeypatch.setattr(lemma_10, "nonobtuse_triangulation", lambda *_: answer)
    assert failing(ROWS) == claims


@pytest.mark.parametrize(("reduced", "factor"), [(UNIFORM, mpq(9, 10)), (ROWS, mpq(3))])
def test_another_condition_is_not_that_of_lemma_10(
    reduced: Reduced, factor: mpq, monkeypatch: pytest.MonkeyPatch
) -> None:
    def condition(a: mpq, c: mpq, d: mpq) -> tuple[mpq, mpq]:
        return factor * a * a, c * d

    monkeypatch.setattr(lemma_10, "squared_ratio", condition)
    assert "lemma-10.iff" in {f.claim for f in check_lemma_10(reduced) if not f.holds}


@given(SCALES, SCALES, SCALES)
def test_a_nonobtuse_triangulation_is_that_of_the_subdivision(a: mpq, c: mpq, d: mpq) -> None:
    """And there is one from a^2 = c d on."""
    expected = lemma_10.AT_SUBDIVISION if a * a >= c * d else None
    assert lemma_10.nonobtuse_triangulation(a, c, d) == expected
    assert lemma_10.nonobtuse_triangulation(a, a * c, a / c) == lemma_10.AT_SUBDIVISION
    assert lemma_10.nonobtuse_triangulation(a, a * c, a / c * mpq(1001, 1000)) is None


# The printed sentences -----------------------------------------------------------------


def printed(reduced: Reduced) -> dict[str, bool]:
    found = (
        *check_lemma_10_as_printed(reduced),
        *check_lemma_11_as_printed(reduced),
        *check_lemma_12_as_printed(reduced),
    )
    assert all(f.role == "as-printed" for f in found)
    return {f.claim: f.holds for f in found}


def test_as_printed_a_uniform_grid_could_not_be_reduced() -> None:
    assert not printed(UNIFORM)["lemma-10.printed-width"]


def test_as_printed_two_strips_would_have_few_triangles() -> None:
    assert not printed(UNIFORM)["lemma-12.printed-strips"]


def test_as_printed_a_sixth_of_the_rows_goes() -> None:
    """Of 7 columns two are too wide and protect all lines but one: 1 goes, which is 6/6."""
    columns = [mpq(w) for w in (1, 4, 1, 1, 1, 4, 1)]
    reduced = reduce_blocks(rectangle(columns, [mpq(4), mpq(1)]))
    assert not failing(reduced)
    assert not printed(reduced)["lemma-11.printed-sixth"]


def test_as_printed_a_third_of_the_columns_lies_between() -> None:
    columns = [mpq(1, 9)] * 4 + [mpq(9)] * 2
    assert not printed(reduce_blocks(rectangle(columns, [mpq(1)] * 6)))[
        "lemma-12.printed-separation"
    ]


def test_as_printed_all_parts_are_flat() -> None:
    """3 rows and 4 columns, split by rows: a part of 2 rows is left with 1 column."""
    columns = [mpq(w) for w in (2, 4, 1, 1)]
    reduced = reduce_blocks(rectangle(columns, [mpq(4), mpq(1), mpq(1)]))
    assert reduced.blocks[0].nodes[-1].turned
    assert not printed(reduced)["lemma-12.printed-aspect"]


# The constants -------------------------------------------------------------------------


def test_two_triangles_a_cell_are_within_the_powers_up_to_406() -> None:
    for rows, columns in ((1, 1), (406, 406), (1, 406), (4, 10**6), (10**9, 3)):
        bound = bounds_convex.POWER_CONSTANT * bounds_convex.power_sum(columns, rows)
        assert bounds_convex.grid_triangles(columns, rows) <= bound


def test_the_worst_recursion_is_within_the_powers() -> None:
    for (columns, rows), count in worst_cases(30).items():
        bound = bounds_convex.power_sum(columns, rows)
        assert count <= mpq(8, 5) * bound
