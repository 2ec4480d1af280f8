"""The checkers on other blocks and grids: a record of one kind taken for another must fail."""

from __future__ import annotations

from functools import cache
from types import SimpleNamespace
from typing import Any

import pytest
from gmpy2 import mpq

from bern_exact.boundary.records import BlockShape, BoundaryMesh
from bern_exact.checkers import bounds
from bern_exact.checkers.dicing import check_dicing, check_frame
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.lemma_2 import check_lemma_2
from bern_exact.checkers.theorem_1 import check_theorem_1
from bern_exact.checkers.theorem_2 import check_theorem_2
from bern_exact.checkers.warping import check_warping
from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.exact.angles import Angle
from bern_exact.theorems.stages import Construction
from bern_exact.theorems.theorem_1 import theorem_1
from bern_exact.theorems.theorem_2 import theorem_2
from tests.boundary.test_blocks import WIDE, low_block
from tests.checkers.samples import THINGS, replace
from tests.theorems.families import some_polygon


@cache
def made(blocks: BlockShape, factor: int | str) -> Construction:
    """Theorem 1's construction for the plate."""
    return theorem_1(THINGS["plate"], blocks=blocks, factor=mpq(factor), check="none")


def records(blocks: BlockShape, factor: int | str) -> Any:
    return SimpleNamespace(**made(blocks, factor).records)


def pick(found: list[Finding], claim: str) -> Finding:
    (one,) = (f for f in found if f.claim == claim)
    return one


@pytest.mark.parametrize(
    ("blocks", "factor", "least"),
    [("square", "6", "11/2"), ("square", "6", "0"), ("corner", "9/2", "4"), ("corner", "5", "-9")],
)
def test_a_factor_that_lets_blocks_overlap(blocks: BlockShape, factor: str, least: str) -> None:
    framed = records(blocks, factor).framed
    assert pick(check_frame(framed), "dicing.frame").holds
    found = pick(check_frame(replace(framed, factor=mpq(least))), "dicing.frame")
    assert not found.holds and "factor" in str(found.witness)


def test_a_factor_for_corner_blocks_is_too_small_for_square_ones() -> None:
    framed = replace(records("corner", "9/2").framed, blocks="square")
    assert not pick(check_frame(framed), "dicing.frame").holds


@pytest.mark.parametrize(("blocks", "factor"), [("square", "6"), ("corner", "9/2")])
def test_a_unit_for_another_factor(blocks: BlockShape, factor: str) -> None:
    framed = records(blocks, factor).framed
    larger = replace(framed, factor=framed.factor * mpq(101, 100))
    smaller = replace(framed, factor=framed.factor * mpq(99, 100))
    assert not pick(check_frame(larger), "dicing.unit").holds
    assert not pick(check_frame(smaller), "dicing.unit-rounding").holds


def test_a_second_vertex_in_a_corner_block() -> None:
    framed = records("corner", "9/2").framed
    polygon = framed.polygon
    x, y, w = polygon.points[0]
    head = (x * 100 + w, y * 100 + w, w * 100)
    points = list(polygon.points)
    points[polygon.after[0]] = head
    crowded = replace(framed, polygon=polygon.with_points(points))
    assert not pick(check_frame(crowded), "dicing.one-vertex-a-sheet").holds


def test_corner_blocks_do_not_cover_square_ones() -> None:
    diced = records("corner", "9/2").diced
    assert pick(check_dicing(diced), "dicing.blocks-covered").holds
    taken = replace(diced, framed=replace(diced.framed, blocks="square"))
    assert not pick(check_dicing(taken), "dicing.blocks-covered").holds


def test_corner_blocks_lose_a_line() -> None:
    diced = records("corner", "9/2").diced
    lost = replace(diced, vertical=diced.vertical[1:])
    assert not pick(check_dicing(lost), "dicing.blocks-covered").holds


def test_intervals_beyond_twelve_a_vertex() -> None:
    diced = records("corner", "9/2").diced
    spare = tuple((k, 0, 1) for k in range(13 * diced.framed.polygon.n))
    found = pick(check_dicing(replace(diced, vertical=spare, horizontal=())), "dicing.intervals")
    assert not found.holds and "at most 12 " in found.statement


def test_another_corner_of_the_square_is_on_the_rim() -> None:
    warped = records("corner", "9/2").warped
    x, y = warped.corners[0]
    px, _, w = warped.traced.diced.framed.polygon.points[0]
    other = (2 * (px // w) + 1 - x, y)
    # Everything says that this corner moved; as one of a square block it would do.
    before = warped.traced.diced.framed.polygon.before[0]
    instances = {**warped.instances, (0, *other): 0, (before, *other): 0}
    moved = {g: t for g, t in warped.moved.items() if t != 0} | {other: 0}
    corners = (other, *warped.corners[1:])
    damaged = replace(warped, corners=corners, instances=instances, moved=moved)
    assert not pick(check_warping(damaged), "warping.corner").holds


def test_an_angle_in_a_corner_block_is_too_large_for_a_smaller_tau() -> None:
    boundary: Any = theorem_1(some_polygon(*WIDE), blocks="corner").records["boundary"]
    found = pick(check_lemma_2(boundary), "lemma-2.block-angle")
    assert found.holds and mpq(str(found.measured)) < -1
    stricter = pick(check_lemma_2(boundary, tau=mpq(1, 1000)), "lemma-2.block-angle")
    assert not stricter.holds and stricter.witness is not None


def as_square(boundary: BoundaryMesh) -> BoundaryMesh:
    """The record says of its blocks that they are square."""
    warped = boundary.warped
    diced = warped.traced.diced
    square = replace(diced, framed=replace(diced.framed, blocks="square"))
    return replace(boundary, warped=replace(warped, traced=replace(warped.traced, diced=square)))


def test_the_same_angle_is_too_large_for_a_square_block() -> None:
    boundary: Any = theorem_1(some_polygon(*WIDE), blocks="corner").records["boundary"]
    assert not pick(check_lemma_2(as_square(boundary)), "lemma-2.block-angle").holds


def test_a_height_in_a_corner_block_is_too_small_for_a_square_one() -> None:
    boundary: Any = theorem_1(low_block(mpq(1, 100)), blocks="corner").records["boundary"]
    assert pick(check_lemma_2(boundary), "lemma-2.block-height").holds
    assert not pick(check_lemma_2(boundary, tau=mpq(1, 5)), "lemma-2.block-height").holds
    assert not pick(check_lemma_2(as_square(boundary)), "lemma-2.block-height").holds


@pytest.mark.parametrize(("blocks", "factor"), [("square", "6"), ("corner", "9/2")])
def test_the_height_promised_by_a_coarser_grid(blocks: BlockShape, factor: str) -> None:
    run = made(blocks, factor)
    valid = SimpleNamespace(valid=True, defects=())
    # A height just below the promise for this factor, and well above that for 8.
    (least,) = (
        f
        for f in check_theorem_1(run.polygon, run.assembled.mesh, run.framed, run.feature, valid)
        if f.claim == "theorem-1.height"
    )
    short = bounds.theorem_1_height_squared(factor=mpq(factor), shape=blocks) * mpq(99, 100)
    assert short > bounds.theorem_1_height_squared()
    feature = replace(run.feature, squared=run.feature.squared * mpq(str(least.measured)) / short)
    found = check_theorem_1(run.polygon, run.assembled.mesh, run.framed, feature, valid)
    assert not pick(found, "theorem-1.height").holds


def test_theorem_2_promises_by_the_factor_too() -> None:
    run = theorem_2(THINGS["triangle"], blocks="corner", check="none")
    merged: Any = run.records["merged"]
    right = Angle(0, mpq(0))
    verdict = SimpleNamespace(valid=True, defects=(), max_angle=right, max_angle_triangle=0)

    def height(squared: mpq) -> Finding:
        found = check_theorem_2(
            run.polygon,
            run.assembled.mesh,
            run.framed,
            replace(run.feature, squared=squared),
            verdict,
            merged,
            tau=bounds.TAU,
            angle_bound=parse_angle_bound("150"),
        )
        return pick(found, "theorem-2.height")

    least = mpq(str(height(run.feature.squared).measured)) * run.feature.squared
    promise = bounds.theorem_2_height_squared(factor=mpq(9, 2))
    assert height(least / promise).holds and "tau s/27 " in height(least).statement
    assert not height(least / promise * mpq(101, 100)).holds
