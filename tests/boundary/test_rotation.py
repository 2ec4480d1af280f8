"""The rotation over the grid: close to the axes where much of the boundary lets it be."""

from __future__ import annotations

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.boundary.rotation import SPREAD, rotation, shared_direction
from bern_exact.corpus.shapes import plate, star
from bern_exact.exact.points import direction, hpoint
from bern_exact.exact.similarity import Similarity
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems.theorem_2 import theorem_2
from tests.rationals import many_fractions

ZERO = mpq(0)
RECTANGLE = [(0, 0), (40, 0), (40, 9), (0, 9)]
ELL = [(0, 0), (40, 0), (40, 9), (11, 9), (11, 30), (0, 30)]


def polygon_of(ring: list[tuple[int, int]], t: mpq = ZERO) -> Polygon:
    """A polygon turned by 2 arctan(t)."""
    turn = Similarity.rotation(t)
    return polygon_from_rings([[turn.apply(hpoint(x, y)) for x, y in ring]])


def slopes(polygon: Polygon) -> list[mpq]:
    """How far each edge is from the nearer axis."""
    found = []
    for tail, head in polygon.edges():
        x, y = (abs(part) for part in direction(polygon.points[tail], polygon.points[head]))
        found.append(mpq(min(x, y), max(x, y)))
    return found


tangents = many_fractions(-1, 1, 997).map(lambda t: mpq(t.numerator, t.denominator))


@given(tangents, st.sampled_from([RECTANGLE, ELL]), st.integers(0, 5))
def test_a_turned_rectilinear_polygon_comes_close_to_the_axes(
    t: mpq, ring: list[tuple[int, int]], attempt: int
) -> None:
    polygon = polygon_of(ring, t)
    turn = rotation(polygon, attempt)
    found = slopes(polygon.with_points([turn.apply(p) for p in polygon.points]))
    # The small rotation, not the one left over from rounding the large one.
    assert mpq(1, 60_000) < min(found) <= max(found) < mpq(1, 45_000)


@pytest.mark.parametrize("ring", [RECTANGLE, ELL, plate(60)[0]])
def test_the_axes_themselves_need_no_turn(ring: list[tuple[int, int]]) -> None:
    polygon = polygon_of(ring)
    if all(slope == 0 for slope in slopes(polygon)):
        assert shared_direction(polygon) is None


def test_directions_all_over_are_left_alone() -> None:
    polygon = polygon_of(star(400)[0])
    assert shared_direction(polygon) is None


def test_each_attempt_gives_another_rotation() -> None:
    polygon = polygon_of(ELL, mpq(2, 7))
    turns = [rotation(polygon, attempt) for attempt in range(20)]
    assert len({(turn.a, turn.b, turn.d) for turn in turns}) == 20
    assert all(turn.squared_scale == 1 for turn in turns)


def test_nearly_equal_directions_count_together() -> None:
    ring = [(0, 0), (3000, 4000), (-1000, 7001), (-4000, 2999)]
    found = shared_direction(polygon_of(ring))
    assert found is not None and abs(found.angle - mpq(4, 7)) < SPREAD


def test_a_turned_polygon_has_about_as_many_triangles() -> None:
    sizes = [
        len(theorem_2(polygon_of(ELL, t), check="none").assembled.mesh.triangles)
        for t in (mpq(0), mpq(2, 7), mpq(-5, 9))
    ]
    # Not the same: the quarter turns over the grid differ.
    assert 5 * max(sizes) <= 6 * min(sizes)
