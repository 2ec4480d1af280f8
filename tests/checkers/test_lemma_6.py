"""The checkers of Lemmas 6 and 8 notice every damage."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from bern_exact.checkers.findings import Finding
from bern_exact.checkers.lemma_6 import check_lemma_6
from bern_exact.checkers.lemma_8 import check_lemma_8
from bern_exact.interior.subdivided.halving import halving
from bern_exact.interior.subdivided.records import Partition, SubdividedRectangle
from tests.interior.regions import grown, unit_region

GOOD = halving(unit_region(grown(60, 7)))
CHECKERS = pytest.mark.parametrize("check", [check_lemma_6, check_lemma_8])
Check = Callable[[Partition], tuple[Finding, ...]]


def failing(check: Check, partition: Partition) -> set[str]:
    """The failing claims, without the lemma."""
    return {f.claim.split(".")[1] for f in check(partition) if not f.holds}


def with_rectangle(k: int, *instead: SubdividedRectangle) -> Partition:
    rectangles, steps = GOOD.rectangles, GOOD.steps
    return replace(
        GOOD,
        rectangles=(*rectangles[:k], *instead, *rectangles[k + 1 :]),
        steps=(*steps[:k], *(steps[k] for _ in instead), *steps[k + 1 :]),
    )


def first_subdivided() -> int:
    return next(k for k, r in enumerate(GOOD.rectangles) if r.left)


@CHECKERS
def test_the_good_one_passes(check: Check) -> None:
    assert not failing(check, GOOD)


@CHECKERS
def test_a_missing_rectangle(check: Check) -> None:
    assert failing(check, with_rectangle(3)) - {"boundary"} == {"shared"}


@CHECKERS
def test_a_rectangle_twice(check: Check) -> None:
    rectangle = GOOD.rectangles[3]
    assert "shared" in failing(check, with_rectangle(3, rectangle, rectangle))


@CHECKERS
def test_a_vertex_without_a_partner(check: Check) -> None:
    k = first_subdivided()
    broken = GOOD.rectangles[k]._replace(right=())
    assert failing(check, with_rectangle(k, broken)) - {"boundary"} == {"matching", "shared"}


@CHECKERS
def test_a_vertex_that_a_neighbour_lacks(check: Check) -> None:
    k = first_subdivided()
    broken = GOOD.rectangles[k]._replace(left=(), right=())
    assert failing(check, with_rectangle(k, broken)) - {"boundary"} == {"shared"}


@CHECKERS
def test_a_vertex_beyond_the_corner(check: Check) -> None:
    rectangle = GOOD.rectangles[0]
    beyond = (rectangle.y1 + 1,)
    broken = rectangle._replace(left=beyond, right=beyond)
    assert failing(check, with_rectangle(0, broken)) - {"boundary"} == {"matching", "shared"}


@CHECKERS
def test_too_many_vertices(check: Check) -> None:
    far = [
        SubdividedRectangle(1000 + 2 * k, 1001 + 2 * k, 0, 1, (), (), (), ())
        for k in range(GOOD.region.edges**2)
    ]
    assert "vertices" in failing(check, with_rectangle(0, *far))


def test_a_boundary_that_grows() -> None:
    """A checkerboard of cells is left after the first half-step."""
    cells = sorted((i, j) for i in range(6) for j in range(4))
    board = Partition(
        unit_region(frozenset(cells), every_line=True),
        tuple(SubdividedRectangle(i, i + 1, j, j + 1, (), (), (), ()) for i, j in cells),
        tuple(1 + (i + j) % 2 for i, j in cells),
    )
    assert failing(check_lemma_6, board) == {"boundary"}
    assert not failing(check_lemma_8, board)
