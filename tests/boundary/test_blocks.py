"""Blocks of four squares round the nearest grid vertex, by definition and in the stages."""

from __future__ import annotations

from functools import cache
from itertools import product
from typing import Any

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.boundary.blocks import block_of, corner_near
from bern_exact.boundary.corners import TAU, warp
from bern_exact.boundary.faces import trace
from bern_exact.boundary.records import HORIZONTAL, VERTICAL, BlockShape, Diced, Warped
from bern_exact.checkers.dicing import blocks
from bern_exact.corpus.over_the_grid import around, moved_back
from bern_exact.exact.points import hpoint
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems.theorem_1 import theorem_1
from tests.boundary.naive import box, kept_intervals
from tests.boundary.samples import every_family
from tests.theorems.families import FAMILIES, some_polygon

WIDE = ("special_frame", 11000006)
"""A pentagon with an angle of 135.37 degrees in a block."""


@cache
def low_block(hair: mpq) -> Polygon:
    """An edge from v, near (1/2, 1/2), passes the grid vertex (1, 1) by tau: v takes (1, 0)."""
    v = (mpq(1, 2) + hair, mpq(1, 2) - hair)
    past = (1 + TAU + hair - v[0], 1 - v[1])
    corners = around(v, past, (mpq(-2), mpq(-1)))
    # Drawn for s' = 8 round v: made smaller for s' = 9/2, over the same grid.
    smaller = [tuple(c + (z - c) * mpq(9, 16) for z, c in zip(p, v, strict=True)) for p in corners]
    return polygon_from_rings([moved_back([(x, y) for x, y in smaller])])


@cache
def records(polygon: Polygon) -> Any:
    """All records with corner blocks, nothing checked."""
    return theorem_1(polygon, blocks="corner", check="none").records


def diced(kind: str, seed: int) -> Diced:
    found: Diced = records(some_polygon(kind, seed))["diced"]
    return found


off_grid = st.integers(-200, 200).filter(lambda i: i % 20).map(lambda i: mpq(i, 20))


@given(off_grid, off_grid)
def test_the_nearest_corner(x: mpq, y: mpq) -> None:
    p = hpoint(x, y)
    low, high = box(p, "corner")
    assert corner_near(p) == (low[0] + 1, low[1] + 1)
    assert block_of(p, "corner") == (low, high)
    assert block_of(p, "square") == box(p, "square")


@every_family
def test_kept_intervals_are_those_of_the_definition(kind: str, seed: int) -> None:
    record = diced(kind, seed)
    polygon = record.framed.polygon
    assert set(record.vertical) == kept_intervals(polygon, VERTICAL, "corner")
    assert set(record.horizontal) == kept_intervals(polygon, HORIZONTAL, "corner")


@every_family
def test_at_most_twelve_intervals_a_vertex(kind: str, seed: int) -> None:
    record = diced(kind, seed)
    assert len(record.vertical) + len(record.horizontal) <= 12 * record.framed.polygon.n


@pytest.mark.parametrize("kind", FAMILIES)
def test_the_checkers_find_the_same_blocks(kind: str) -> None:
    framed = diced(kind, 0).framed
    assert blocks(framed) == [box(p, "corner") for p in framed.polygon.points]


@pytest.mark.parametrize("kind", ["triangle", "star", "rectilinear", "octilinear"])
def test_blocks_of_neighbours_are_disjoint(kind: str) -> None:
    framed = diced(kind, 0).framed
    for v, w in framed.polygon.edges():
        (low, high), (lower, upper) = (box(framed.polygon.points[i], "corner") for i in (v, w))
        apart = [high[i] <= lower[i] or upper[i] <= low[i] for i in (0, 1)]
        assert any(apart)


@pytest.mark.parametrize(("shape", "least_squared"), [("corner", 18), ("square", 32)])
def test_blocks_of_points_far_enough_apart_are_disjoint(
    shape: BlockShape, least_squared: int
) -> None:
    for i, j, k, m in product(*[(1, 3, 6)] * 2, range(1, 48, 3), range(1, 48, 2)):
        if k % 7 and m % 7 and (k - i) ** 2 + (m - j) ** 2 > least_squared * 49:
            places = (hpoint(mpq(i, 7), mpq(j, 7)), hpoint(mpq(k, 7), mpq(m, 7)))
            (low, high), (lower, upper) = (block_of(p, shape) for p in places)
            apart = [high[axis] <= lower[axis] or upper[axis] <= low[axis] for axis in (0, 1)]
            assert any(apart)


@pytest.mark.parametrize("kind", FAMILIES)
def test_the_middle_of_the_block_moves_to_its_vertex(kind: str) -> None:
    warped: Warped = records(some_polygon(kind, 1))["warped"]
    points = warped.traced.diced.framed.polygon.points
    assert warped.corners == tuple(map(corner_near, points))


def test_without_135_degrees_the_nearest_corner_is_taken_all_the_same() -> None:
    made = theorem_1(some_polygon(*WIDE), blocks="corner")
    warped: Any = made.records["warped"]
    assert warped.rank == (0, 1, 0, 0, 0)
    (angle,) = (f for f in made.findings if f.claim == "lemma-2.block-angle")
    # Above 135 degrees: v is almost diagonally off a grid vertex, and a row kept for another
    # vertex ends within tau of the block's rim.  At most 135 + arctan(tau) in this way.
    assert -(1 + TAU) / (1 - TAU) < mpq(str(angle.measured)) < -1
    assert "135 degrees + arctan(2 tau)" in angle.statement and angle.bound == "-5/3"


def test_the_choice_is_a_function_of_the_record() -> None:
    made = records(some_polygon("threshold", 20))
    again, _ = warp(*trace(made["diced"]))
    assert again == made["warped"]


@pytest.mark.parametrize("hair", [mpq(1, 100), mpq(1, 10**6)])
def test_heights_in_a_block_may_fall_below_tau_over_sqrt_2(hair: mpq) -> None:
    made = theorem_1(low_block(hair), blocks="corner")
    warped: Any = made.records["warped"]
    assert made.framed.unit == 1 and warped.corners[0] == (1, 0)
    (found,) = (f for f in made.findings if f.claim == "lemma-2.block-height")
    infimum = TAU**2 / (1 + (1 + 2 * TAU) ** 2)
    assert TAU**2 / 4 < infimum < mpq(str(found.measured)) < TAU**2 / 2
