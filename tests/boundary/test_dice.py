"""Dicing: the kept intervals, against shooting rays at all edges."""

from __future__ import annotations

import pytest

from bern_exact.boundary.records import HORIZONTAL, VERTICAL
from tests.boundary.naive import NaiveArrangement, hits, kept_intervals, square
from tests.boundary.samples import drawn, every_family
from tests.theorems.families import FAMILIES


@every_family
def test_kept_intervals_are_those_of_the_definition(kind: str, seed: int) -> None:
    diced = drawn(kind, seed).diced
    polygon = diced.framed.polygon
    assert set(diced.vertical) == kept_intervals(polygon, VERTICAL)
    assert set(diced.horizontal) == kept_intervals(polygon, HORIZONTAL)


@every_family
def test_no_interval_is_kept_twice(kind: str, seed: int) -> None:
    diced = drawn(kind, seed).diced
    for intervals in (diced.vertical, diced.horizontal):
        assert len(set(intervals)) == len(intervals)


@every_family
def test_at_most_sixteen_intervals_a_vertex(kind: str, seed: int) -> None:
    diced = drawn(kind, seed).diced
    assert len(diced.vertical) + len(diced.horizontal) <= 16 * diced.framed.polygon.n


@every_family
def test_intervals_are_sorted_by_line_and_place(kind: str, seed: int) -> None:
    diced = drawn(kind, seed).diced
    for axis, intervals in ((VERTICAL, diced.vertical), (HORIZONTAL, diced.horizontal)):
        places = [
            (each.line, diced.crossings[diced.crossing_at[axis, each.line, each.low]].at)
            for each in intervals
        ]
        assert places == sorted(places)


@every_family
def test_crossings_are_where_edges_cross_lines(kind: str, seed: int) -> None:
    diced = drawn(kind, seed).diced
    for q in diced.crossings:
        crossed = hits(diced.framed.polygon, q.axis, q.line)
        i = crossed.index((q.at, q.edge))
        # Even ones are low ends: the interval's other end is the next one up.
        assert crossed[i ^ 1][1] == q.far
        assert q.at.denominator != 1


@every_family
def test_crossings_are_in_order_along_their_edges(kind: str, seed: int) -> None:
    diced = drawn(kind, seed).diced
    naive = NaiveArrangement(diced)
    for edge, chain in enumerate(naive.chains[-naive.n :]):
        assert [naive.n + j for j in diced.on_edge[edge]] == chain[1:-1]


@every_family
def test_lines_in_use_are_those_of_the_blocks(kind: str, seed: int) -> None:
    diced = drawn(kind, seed).diced
    squares = [square(p) for p in diced.framed.polygon.points]
    assert diced.xs == tuple(sorted({x + i for x, _ in squares for i in (-1, 0, 1, 2)}))
    assert diced.ys == tuple(sorted({y + i for _, y in squares for i in (-1, 0, 1, 2)}))


@pytest.mark.parametrize("kind", FAMILIES)
def test_blocks_on_one_sheet_are_disjoint(kind: str) -> None:
    polygon = drawn(kind, 0).framed.polygon
    for v, w in polygon.edges():
        (x, y), (u, t) = square(polygon.points[v]), square(polygon.points[w])
        assert max(abs(x - u), abs(y - t)) >= 3
