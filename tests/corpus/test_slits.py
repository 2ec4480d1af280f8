"""Bars and slits: valid, and as many triangles whatever the aspect ratio."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from bern_exact.corpus.shapes import Ring
from bern_exact.corpus.slits import bar, slit
from bern_exact.exact.points import grid_point
from bern_exact.plane.feature_size import feature_size
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import triangulate_polygon
from bern_exact.plane.validation import polygon_from_rings
from tests.theorems.judged import proved_without_large_angles

Family = Callable[[int], list[Ring]]

MOST = {bar: 100, slit: 700}
"""Triangles, for every aspect ratio."""

both = pytest.mark.parametrize("family", MOST, ids=lambda family: family.__name__)


def polygon(family: Family, aspect: int) -> Polygon:
    """A member of a family, validated."""
    return polygon_from_rings([[grid_point(x, y) for x, y in ring] for ring in family(aspect)])


@both
@pytest.mark.parametrize("exponent", [1, 3, 9, 30])
def test_the_feature_size_is_the_width(family: Family, exponent: int) -> None:
    made = polygon(family, 10**exponent)
    assert feature_size(made, triangulate_polygon(made)).squared == 1


@both
@pytest.mark.parametrize("exponent", [1, 2, 3, 6, 9, 30])
def test_the_aspect_ratio_does_not_matter(family: Family, exponent: int) -> None:
    made = proved_without_large_angles(polygon(family, 10**exponent))
    assert len(made.assembled.mesh.triangles) <= MOST[family]


@both
@pytest.mark.parametrize("exponent", [2, 9])
def test_better_angles_too(family: Family, exponent: int) -> None:
    made = proved_without_large_angles(polygon(family, 10**exponent), "136")
    assert len(made.assembled.mesh.triangles) <= MOST[family]
