"""Bars, slits, spikes, combs: valid, and as many triangles whatever the aspect ratio."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from bern_exact.corpus.shapes import Ring
from bern_exact.corpus.slits import bar, comb, slit, spike
from bern_exact.exact.points import grid_point
from bern_exact.plane.feature_size import feature_size
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import triangulate_polygon
from bern_exact.plane.validation import polygon_from_rings
from tests.theorems.judged import proved_without_large_angles

Family = Callable[[int], list[Ring]]


def five_teeth(aspect: int) -> list[Ring]:
    """A comb of 20 vertices."""
    return comb(5, aspect)


MOST = {bar: 100, slit: 700, spike: 300, five_teeth: 800}
"""Triangles, for every aspect ratio."""

every = pytest.mark.parametrize("family", MOST, ids=lambda family: family.__name__)


def polygon(family: Family, aspect: int) -> Polygon:
    """A member of a family, validated."""
    return polygon_from_rings([[grid_point(x, y) for x, y in ring] for ring in family(aspect)])


@pytest.mark.parametrize("family", [bar, slit, five_teeth])
@pytest.mark.parametrize("exponent", [1, 3, 9, 30])
def test_the_feature_size_is_the_width(family: Family, exponent: int) -> None:
    made = polygon(family, 10**exponent)
    assert feature_size(made, triangulate_polygon(made)).squared == 1


@every
@pytest.mark.parametrize("exponent", [1, 3, 9, 30])
def test_the_aspect_ratio_does_not_matter(family: Family, exponent: int) -> None:
    made = proved_without_large_angles(polygon(family, 10**exponent))
    assert len(made.assembled.mesh.triangles) <= MOST[family]


@every
@pytest.mark.parametrize("exponent", [2, 9])
def test_better_angles_too(family: Family, exponent: int) -> None:
    made = proved_without_large_angles(polygon(family, 10**exponent), "136")
    assert len(made.assembled.mesh.triangles) <= MOST[family]


def test_a_spike_is_two_wide() -> None:
    squared = feature_size(polygon(spike, 10**9)).squared
    assert 4 - squared > 0
    assert (4 - squared) * 10**15 < 1


@pytest.mark.parametrize("teeth", [1, 2, 30])
def test_a_comb_has_four_vertices_a_tooth(teeth: int) -> None:
    made = polygon_from_rings([[grid_point(x, y) for x, y in ring] for ring in comb(teeth, 7)])
    assert made.n == 4 * teeth
    assert made.area == 7 * teeth + 2 * teeth - 1
