"""The experimental blocks and grids: every claim holds, both judges agree, and what is refused."""

from __future__ import annotations

from typing import Any

import pytest
from gmpy2 import mpq

from bern_exact import triangulate
from bern_exact.boundary.records import BlockShape
from bern_exact.exact.errors import InputError
from bern_exact.theorems.grid import LEAST_SQUARED, grid_for
from bern_exact.theorems.stages import RefusedOption
from bern_exact.theorems.theorem_1 import theorem_1
from tests.boundary.test_blocks import WIDE
from tests.theorems.families import some_polygon
from tests.theorems.judged import proved, proved_without_large_angles

GRIDS: list[tuple[BlockShape, str]] = [("corner", "9/2"), ("square", "6")]

KINDS = ("triangle", "star", "plate", "threshold", "nearly_right", "folded_slit", "comb")

every_grid = pytest.mark.parametrize(("blocks", "factor"), GRIDS)


@every_grid
@pytest.mark.parametrize("kind", KINDS)
def test_theorem_1_holds(kind: str, blocks: BlockShape, factor: str) -> None:
    made = proved(some_polygon(kind, 2), blocks=blocks, factor=mpq(factor))
    assert made.framed.factor == mpq(factor)


@every_grid
@pytest.mark.parametrize("kind", KINDS)
def test_theorems_2_and_3_hold(kind: str, blocks: BlockShape, factor: str) -> None:
    polygon = some_polygon(kind, 2)
    proved_without_large_angles(polygon, "145", blocks=blocks, factor=mpq(factor))


@pytest.mark.parametrize(("blocks", "factor"), [("square", "17/3"), ("corner", "17/4")])
def test_the_coarsest_grids_hold(blocks: BlockShape, factor: str) -> None:
    proved_without_large_angles(some_polygon("plate", 4), blocks=blocks, factor=mpq(factor))


@every_grid
def test_baselines_hold(blocks: BlockShape, factor: str) -> None:
    for theorem in (1, 3):
        made = triangulate(
            some_polygon("plate", 0), theorem=theorem, baseline=True, blocks=blocks, factor=factor
        )
        assert made.certificate.holds


@pytest.mark.parametrize("theorem", [1, 2])
def test_the_papers_choice_is_the_default(theorem: int) -> None:
    polygon = some_polygon("star", 1)
    said, unsaid = (
        triangulate(polygon, theorem=theorem, check="none", **options).document
        for options in ({"blocks": "square", "factor": 8}, {})
    )
    assert said == unsaid


def test_the_default_factor_of_corner_blocks() -> None:
    certificate = triangulate(some_polygon("simple", 0), blocks="corner").certificate
    assert (certificate.blocks, certificate.factor) == ("corner", mpq(9, 2))
    assert certificate.to_json()["factor"] == "9/2"


def test_the_promise_of_a_coarser_grid_is_higher() -> None:
    heights = []
    for blocks, factor in (("square", mpq(8)), ("square", mpq(6)), ("corner", mpq(9, 2))):
        found = theorem_1(some_polygon("star", 1), blocks=blocks, factor=factor).findings
        (height,) = (f for f in found if f.claim == "theorem-1.height")
        assert str(3 * factor) in height.statement
        heights.append(mpq(str(height.bound)))
    assert heights[1] / heights[0] == mpq(8, 6) ** 2
    # tau b/2 in place of tau b/sqrt 2.
    assert heights[2] / heights[0] == mpq(16, 9) ** 2 / 2


@pytest.mark.parametrize(
    ("blocks", "factor"),
    [("square", "11/2"), ("square", "5.656"), ("corner", 4), ("corner", "4.24"), ("square", -8)]
    + [("corner", 0), ("square", "64.001"), ("corner", 65)],
)
def test_a_factor_out_of_range_is_refused(blocks: BlockShape, factor: Any) -> None:
    with pytest.raises(RefusedOption, match=rf"factor .*: {blocks} blocks need more than sqrt\("):
        triangulate(some_polygon("triangle", 1), blocks=blocks, factor=factor)


@pytest.mark.parametrize("blocks", LEAST_SQUARED)
def test_the_least_factor_is_decided_exactly(blocks: BlockShape) -> None:
    # Convergents of sqrt 2 on both sides: 4 sqrt 2 and 3 sqrt 2, off by 10^-12 or so.
    times = {"square": 4, "corner": 3}[blocks]
    p, q = 1, 1
    for _ in range(16):
        p, q = p + 2 * q, p + q
        factor = mpq(times * p, q)
        if p * p > 2 * q * q:
            assert grid_for(blocks, factor).factor == factor
        else:
            with pytest.raises(RefusedOption):
                grid_for(blocks, factor)


@pytest.mark.parametrize(
    ("theorem", "options", "said"),
    [
        (4, {"blocks": "corner"}, "blocks is not an option of Theorem 4"),
        (4, {"factor": 6}, "factor is not an option of Theorem 4"),
        (1, {"blocks": "round"}, "blocks 'round': one of square, corner"),
    ],
)
def test_what_does_not_go_together(theorem: int, options: dict[str, Any], said: str) -> None:
    with pytest.raises(RefusedOption, match=said):
        triangulate(some_polygon("triangle", 1), theorem=theorem, **options)


@pytest.mark.parametrize("written", ["9/2", "4.50", 4.5, mpq(9, 2)])
def test_a_factor_is_exact_however_it_is_written(written: Any) -> None:
    made = triangulate(some_polygon("triangle", 1), blocks="corner", factor=written, check="none")
    factor = made.certificate.factor
    assert factor == mpq(9, 2) and isinstance(factor, mpq)


def test_given_up_135_degrees_are_counted() -> None:
    made = triangulate(some_polygon(*WIDE), theorem=1, blocks="corner", check="none")
    assert made.certificate.counts["warped"]["blocks_above_135"] == 1


def test_a_factor_that_is_no_number() -> None:
    with pytest.raises(InputError):
        triangulate(some_polygon("triangle", 1), factor="many")


def test_sentences_about_the_papers_blocks_are_not_put_to_others() -> None:
    found = theorem_1(some_polygon("simple", 0), blocks="corner", as_printed=True).findings
    assert "lemma-2.printed-closest-corner" not in {f.claim for f in found}
