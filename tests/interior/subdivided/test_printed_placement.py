"""Where Lemma 7 as printed puts Steiner points there are angles above 135 degrees.

The printed condition is v/2 - b <= d <= v/2 + b for the distance d of the first Steiner point from
the left side, on the middle line of a rectangle v high with subdivisions at least b apart.
"""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from bern_exact.checkers.findings import demand
from bern_exact.checkers.lemma_7 import check_lemma_7
from bern_exact.exact.predicates import cross, dot
from bern_exact.interior.records import Rectilinear
from bern_exact.interior.subdivided.records import Partition, SubdividedRectangle
from bern_exact.interior.subdivided.rectangle import tile, triangulate

Pair = tuple[int | mpq, int | mpq]


def is_at_most_135(before: Pair, apex: Pair, after: Pair) -> bool:
    """Is the angle at the apex at most 135 degrees?"""
    (x, y), u, v = apex, after, before
    a, b = (mpq(u[0] - x), mpq(u[1] - y)), (mpq(v[0] - x), mpq(v[1] - y))
    return bool(dot(a, b) + cross(a, b) >= 0)


def test_too_near_to_an_undivided_side() -> None:
    """v = 3 b and d = b/2 are allowed; the triangle on the left side has 143.13 degrees."""
    assert mpq(3, 2) - 1 <= mpq(1, 2) <= mpq(3, 2) + 1
    assert not is_at_most_135((0, 3), (mpq(1, 2), mpq(3, 2)), (0, 0))


@pytest.mark.parametrize(
    "triangle",
    [
        ((10, 2), (0, 2), (2, 1)),  # 146.31 degrees at (2, 1)
        ((10, 1), (0, 2), (2, 1)),  # 153.43 degrees at (2, 1)
    ],
)
def test_a_top_subdivision_far_to_the_right(triangle: tuple[Pair, Pair, Pair]) -> None:
    """[0, 20] x [0, 2], b = 1, d = 2: either diagonal beside the first Steiner point is bad."""
    right, corner, steiner = triangle
    assert not is_at_most_135(corner, steiner, right)


@pytest.mark.parametrize(
    "rectangle",
    [
        SubdividedRectangle(0, 20, 0, 3, (), (), (10,), (10,)),
        SubdividedRectangle(0, 20, 0, 3, (1, 2), (1, 2), (10,), (10,)),
        SubdividedRectangle(0, 20, 0, 2, (1,), (1,), (), ()),
        SubdividedRectangle(0, 20, 0, 2, (1,), (1,), (10,), (10,)),
    ],
)
def test_the_repaired_placement_is_inside_and_has_no_such_angle(
    rectangle: SubdividedRectangle,
) -> None:
    demand(check_lemma_7(tile(Partition(Rectilinear(()), (rectangle,), (0,)))))
    for x, y in triangulate(rectangle).steiner:
        assert 2 * rectangle.x0 < x < 2 * rectangle.x1 and 2 * rectangle.y0 < y < 2 * rectangle.y1


def test_the_angle_test_itself() -> None:
    assert is_at_most_135((-1, 1), (0, 0), (1, 0)) and not is_at_most_135((-2, 1), (0, 0), (1, 0))
