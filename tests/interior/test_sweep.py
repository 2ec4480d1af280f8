"""Lemma 3 against its bounds, on random regions."""

from __future__ import annotations

from itertools import pairwise

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.checkers.findings import demand
from bern_exact.checkers.lemma_3 import check_lemma_3
from bern_exact.exact.points import grid_point
from bern_exact.exact.predicates import squared_height
from bern_exact.interior.records import Rectilinear, Swept
from bern_exact.interior.rectilinear import UnmatchedEdge, columns, ordinates, strictly_between
from bern_exact.interior.sweep import sweep
from tests.interior.regions import regions


def side_vertices(region: Rectilinear) -> tuple[int, int]:
    """B_L and B_R: boundary vertices strictly inside left and right sides of columns."""
    on_line = ordinates(region)
    found = columns(region)
    left = sum(len(strictly_between(on_line[c.x0], c.y0, c.y1)) for c in found)
    right = sum(len(strictly_between(on_line[c.x1], c.y0, c.y1)) for c in found)
    return left, right


def boundary_of(region: Rectilinear) -> set[tuple[int, int]]:
    return {v for loop in region.loops for v in loop}


@given(regions())
def test_every_claim_of_lemma_3(region: Rectilinear) -> None:
    demand(check_lemma_3(sweep(region)))


@given(regions())
def test_points_added(region: Rectilinear) -> None:
    left, right = side_vertices(region)
    assert left == right <= region.edges // 2
    assert len(sweep(region).added) <= 2 * left + right


@given(regions())
def test_triangles(region: Rectilinear) -> None:
    swept = sweep(region)
    triangles = [t for column in swept.columns for t in column.triangles]
    # Each loop but one a component is a hole at most.
    assert len(triangles) <= 4 * region.edges + 2 * len(region.loops)
    twice = sum(
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) for a, b, c in triangles
    )
    area = sum(
        loop[k - 1][0] * y - loop[k - 1][1] * x
        for loop in region.loops
        for k, (x, y) in enumerate(loop)
    )
    assert twice == area
    for triangle in triangles:
        assert 2 * squared_height(*(grid_point(*v) for v in triangle)) >= 1


@given(regions())
def test_the_boundary_gets_no_vertex(region: Rectilinear) -> None:
    swept = sweep(region)
    edges = {(loop[k - 1], v) for loop in region.loops for k, v in enumerate(loop)}
    assert not swept.added & boundary_of(region)
    for x, y in swept.added:
        for a, b in edges:
            if a[0] == b[0] == x:
                assert not min(a[1], b[1]) < y < max(a[1], b[1])


@given(regions())
def test_neighbouring_triangles_share_whole_edges(region: Rectilinear) -> None:
    darts = [
        (t[k - 1], t[k])
        for column in sweep(region).columns
        for t in column.triangles
        for k in range(3)
    ]
    assert len(set(darts)) == len(darts)
    border = {(loop[k - 1], v) for loop in region.loops for k, v in enumerate(loop)}
    assert {(a, b) for a, b in darts if (b, a) not in set(darts)} == border


@given(regions())
def test_at_most_one_subdivision_between_matched_points(region: Rectilinear) -> None:
    for column in sweep(region).columns:
        matched = sorted({*column.left} & {*column.right})
        for low, high in pairwise(matched):
            for ys in (column.left, column.right):
                assert sum(low < y < high for y in ys) <= 1


@given(regions(), st.integers(-(10**20), 10**20), st.integers(-(10**20), 10**20))
def test_translation(region: Rectilinear, dx: int, dy: int) -> None:
    moved = Rectilinear(tuple(tuple((x + dx, y + dy) for x, y in loop) for loop in region.loops))
    before, after = sweep(region), sweep(moved)
    assert after.added == {(x + dx, y + dy) for x, y in before.added}
    assert [len(c.triangles) for c in before.columns] == [len(c.triangles) for c in after.columns]


def rectangle(left: list[int], right: list[int], height: int) -> Rectilinear:
    """A column of width 1 with these vertices on its sides, as the sweeps leave it."""
    side = [(1, y) for y in right]
    return Rectilinear(
        (((0, 0), (1, 0), *side, (1, height), (0, height), *((0, y) for y in reversed(left))),)
    )


def least_height(swept: Swept) -> mpq:
    return min(
        squared_height(*(grid_point(*v) for v in t))
        for column in swept.columns
        for t in column.triangles
    )


@pytest.mark.parametrize("height", [2, 3, 10, 1000])
def test_a_tall_column_with_a_subdivision_near_its_end(height: int) -> None:
    # The printed zig-zag has squared height 1/(H^2 + 1) here.
    for left, right in (([height - 1], []), ([], [height - 1]), ([1], []), ([], [1])):
        assert least_height(sweep(rectangle(left, right, height))) >= mpq(1, 2)


@pytest.mark.parametrize("height", [3, 4, 50])
def test_ladders_with_one_subdivision_on_each_side(height: int) -> None:
    for low in range(1, height):
        for high in range(1, height):
            assert least_height(sweep(rectangle([low], [high], height))) >= mpq(1, 2)


def test_the_unit_square_attains_the_bound() -> None:
    swept = sweep(rectangle([], [], 1))
    assert least_height(swept) == mpq(1, 2) and not swept.added


def test_every_second_point_is_projected() -> None:
    right = [(2, y) for y in range(1, 8)]
    left = [(0, y) for y in reversed(range(1, 8))]
    loop = ((0, 0), (1, 0), (2, 0), *right, (2, 8), (1, 8), (0, 8), *left)
    assert sweep(Rectilinear((loop,))).added == {(1, 2), (1, 4), (1, 6)}


def test_columns_without_matching_raise() -> None:
    step = ((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2))
    with pytest.raises(UnmatchedEdge):
        sweep(Rectilinear((step,)))
