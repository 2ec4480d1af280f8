"""The frame: general position, the grid unit, and the way back."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from bern_exact.boundary.blocks import FACTOR
from bern_exact.boundary.dice import dice
from bern_exact.boundary.frame import Degenerate, frame
from bern_exact.corpus.over_the_grid import around, moved_back, pentagon_on
from bern_exact.exact.points import coordinates, hpoint
from bern_exact.exact.predicates import squared_distance
from bern_exact.plane.feature_size import feature_size
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings
from tests.boundary.samples import diced, drawn, every_family, lopped


@every_family
def test_nothing_is_special(kind: str, seed: int) -> None:
    polygon = drawn(kind, seed).framed.polygon
    points = [coordinates(p) for p in polygon.points]
    assert all(x.denominator > 1 and y.denominator > 1 for x, y in points)
    for tail, head in polygon.edges():
        (x, y), (u, v) = points[tail], points[head]
        assert 0 != abs(u - x) != abs(v - y) != 0


@every_family
def test_the_unit_is_an_eighth_of_the_feature_size_rounded_down(kind: str, seed: int) -> None:
    framed = drawn(kind, seed).framed
    assert framed.factor == FACTOR == 8
    squared = feature_size(framed.lopped.lopped).squared
    assert framed.feature.squared == squared
    ratio = 64 * framed.unit**2 / squared
    assert (1 - mpq(1, 2**9)) ** 2 < ratio <= 1
    assert feature_size(framed.polygon).squared == squared / framed.unit**2 >= 64


@every_family
def test_the_similarity_is_undone_exactly(kind: str, seed: int) -> None:
    framed = drawn(kind, seed).framed
    back = framed.similarity.inverse()
    original = framed.lopped.lopped
    assert tuple(map(framed.similarity.apply, original.points)) == framed.polygon.points
    assert tuple(map(back.apply, framed.polygon.points)) == original.points
    assert framed.similarity.squared_scale * framed.unit**2 == 1
    p, q = original.points[0], original.points[1]
    u, v = framed.polygon.points[0], framed.polygon.points[1]
    assert squared_distance(p, q) == squared_distance(u, v) * framed.unit**2


def test_orientation_is_kept() -> None:
    framed = drawn("plate", 0).framed
    assert framed.polygon.area * framed.unit**2 == framed.lopped.lopped.area > 0


OTHER_CORNERS = [(mpq(9, 2), 20), (mpq(-31, 3), mpq(41, 3))]

SPECIAL = {
    "horizontal": [(mpq(1, 2), mpq(1, 3)), (mpq(17, 2), mpq(1, 3))],
    "vertical": [(mpq(1, 2), mpq(-23, 3)), (mpq(1, 2), mpq(1, 3))],
    # 8 is no rational multiple of sqrt 2; so the unit comes from another edge, just above 8.
    "on a vertical line": [(2, mpq(1, 3)), (2 + mpq(24, 5), mpq(1, 3) + mpq(32, 5))],
    "on a horizontal line": [(mpq(1, 3), 2), (mpq(1, 3) + mpq(24, 5), 2 + mpq(32, 5))],
}


def special(name: str, attempt: int) -> Polygon:
    """A pentagon with a side of 8, special in the frame of this attempt."""
    tail, head = ((mpq(a), mpq(b)) for a, b in SPECIAL[name])
    return polygon_from_rings([moved_back(pentagon_on(tail, head), attempt)])


@pytest.mark.parametrize("attempt", [0, 1, 2])
@pytest.mark.parametrize("name", SPECIAL)
def test_special_positions_are_refused(name: str, attempt: int) -> None:
    cut = lopped(special(name, attempt))
    with pytest.raises(Degenerate):
        frame(cut, feature_size(cut.lopped), attempt)
    assert frame(cut, feature_size(cut.lopped), attempt + 7).unit == 1


def test_a_diagonal_edge_is_refused() -> None:
    corners = [(mpq(1, 3), mpq(1, 7)), (mpq(31, 3), mpq(71, 7)), (mpq(-9), mpq(30))]
    # The unit does not matter: the frame's rotation makes the edge diagonal.
    cut = lopped(polygon_from_rings([moved_back(corners)]))
    with pytest.raises(Degenerate, match="diagonal"):
        frame(cut, feature_size(cut.lopped), 0)


def test_an_edge_through_a_grid_point_is_refused() -> None:
    # From (1/2, 1/2) through (2, 1), at the rim of the block.
    v = (mpq(1, 2), mpq(1, 2))
    polygon = polygon_from_rings([moved_back(around(v, (mpq(3), mpq(1)), (mpq(-5), mpq(12))))])
    cut = lopped(polygon)
    framed = frame(cut, feature_size(cut.lopped), 0)
    assert framed.unit == 1 and framed.polygon.points[0] == hpoint(*v)
    with pytest.raises(Degenerate, match="grid point"):
        dice(framed)
    assert diced(polygon).framed.polygon != framed.polygon


def test_each_attempt_is_another_frame() -> None:
    cut = lopped(drawn("simple", 0).polygon)
    size = feature_size(cut.lopped)
    frames = {frame(cut, size, attempt).polygon.points for attempt in range(5)}
    assert len(frames) == 5
    assert frame(cut, size, 3) == frame(cut, size, 3)
