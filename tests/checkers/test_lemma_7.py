"""The checker of Lemma 7 notices every damage."""

from __future__ import annotations

from dataclasses import replace

import pytest

from bern_exact.checkers.lemma_7 import check_lemma_7
from bern_exact.interior.records import Rectilinear
from bern_exact.interior.subdivided.records import Partition, SubdividedRectangle, Tiled, Tiling
from bern_exact.interior.subdivided.rectangle import tile

RECTANGLE = SubdividedRectangle(0, 9, 0, 4, (2,), (2,), (4, 5), (4, 5))
GOOD = tile(Partition(Rectilinear(()), (RECTANGLE,), (1,)))


def damaged(**changes: object) -> Tiled:
    (tiling,) = GOOD.tilings
    return replace(GOOD, tilings=(tiling._replace(**changes),))


def failing(tiled: Tiled) -> set[str]:
    return {f.claim for f in check_lemma_7(tiled) if not f.holds}


def moved(tiling: Tiling, point: tuple[int, int], to: tuple[int, int]) -> dict[str, object]:
    """The tiling with a Steiner point elsewhere."""
    triangles = tuple(
        tuple(to if p == point else p for p in triangle) for triangle in tiling.triangles
    )
    return {
        "steiner": tuple(to if p == point else p for p in tiling.steiner),
        "triangles": triangles,
    }


def test_the_good_one_passes() -> None:
    assert not failing(GOOD)


@pytest.mark.parametrize(
    ("to", "claims"),
    [
        ((4, 7), {"lemma-7.angle"}),
        ((-1, 4), {"lemma-7.interior", "lemma-7.tiling"}),
        ((0, 4), {"lemma-7.interior", "lemma-7.tiling"}),
    ],
)
def test_a_moved_steiner_point(to: tuple[int, int], claims: set[str]) -> None:
    (tiling,) = GOOD.tilings
    assert claims <= failing(damaged(**moved(tiling, tiling.steiner[0], to)))


def test_a_missing_triangle() -> None:
    assert failing(damaged(triangles=GOOD.tilings[0].triangles[1:])) == {"lemma-7.tiling"}


def test_a_triangle_twice() -> None:
    triangles = GOOD.tilings[0].triangles
    assert "lemma-7.tiling" in failing(damaged(triangles=(*triangles, triangles[0])))


def test_a_clockwise_triangle() -> None:
    first, *rest = GOOD.tilings[0].triangles
    claims = failing(damaged(triangles=(first[::-1], *rest)))
    assert claims == {"lemma-7.tiling", "lemma-7.angle", "lemma-7.height"}


def test_a_steiner_point_that_nothing_uses() -> None:
    steiner = GOOD.tilings[0].steiner
    assert "lemma-7.tiling" in failing(damaged(steiner=(*steiner, (3, 3))))


def test_too_many_steiner_points() -> None:
    steiner = GOOD.tilings[0].steiner
    more = (*steiner, (3, 3), (3, 5), (3, 6))
    assert failing(damaged(steiner=more)) == {"lemma-7.tiling", "lemma-7.steiner"}


def test_too_many_triangles() -> None:
    triangles = GOOD.tilings[0].triangles
    claims = failing(damaged(triangles=triangles * 3))
    assert claims == {"lemma-7.tiling", "lemma-7.triangles"}
