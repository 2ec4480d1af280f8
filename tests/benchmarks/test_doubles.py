"""What peers are given: nearest doubles, and a point in each hole."""

from __future__ import annotations

from itertools import pairwise

import pytest
from gmpy2 import mpq

from benchmarks.peers.cases import EXAMPLES
from benchmarks.peers.doubles import nearest_float, points_in_holes, rings_of_doubles, rounded
from bern_exact.corpus.slits import comb
from bern_exact.exact.errors import InputError
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.exact.predicates import orientation
from bern_exact.oracle.arguments import polygon_of
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import triangulate_polygon

LARGE = [(-100, -100), (100, -100), (100, 100), (-100, 100)]


def is_inside(point: tuple[float, float], ring: list[HPoint]) -> bool:
    """Is a double strictly inside a ring?  By a triangulation of the ring, not by a ray."""
    inside = polygon_of([tuple(mpq(c, p[2]) for c in p[:2]) for p in ring])
    at = hpoint(*(mpq(*c.as_integer_ratio()) for c in point))
    on_edge = any(
        orientation(p, q, at) == 0 for p, q in pairwise([*inside.points, inside.points[0]])
    )
    corners = [[inside.points[v] for v in t] for t in triangulate_polygon(inside).triangles()]
    return not on_edge and any(
        all(orientation(t[i - 1], t[i], at) >= 0 for i in range(3)) for t in corners
    )


def holes_of(polygon: Polygon) -> list[list[HPoint]]:
    return [list(polygon.input_ring(r)) for r in range(1, len(polygon.rings))]


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.json")), ids=lambda path: path.stem)
def test_each_hole_of_a_real_polygon_has_its_point(path: object) -> None:
    polygon = rounded(Polygon.load(str(path)))
    points = points_in_holes(polygon)
    assert len(points) == polygon.holes
    assert all(map(is_inside, points, holes_of(polygon)))


@pytest.mark.parametrize(
    "hole",
    [
        comb(4, 30)[0],
        [(x, -y) for x, y in comb(4, 30)[0]],
        [(0, 0), (30, 1), (60, 0), (30, 2)],
        [(0, 0), (9, 0), (9, 9), (8, 1)],
    ],
    ids=["comb", "comb turned over", "arrow", "hook"],
)
def test_a_winding_hole_has_its_point(hole: list[tuple[int, int]]) -> None:
    polygon = polygon_of([LARGE, hole])
    (point,) = points_in_holes(polygon)
    (ring,) = holes_of(polygon)
    assert is_inside(point, ring)


def test_a_hole_without_a_double_is_refused() -> None:
    x = mpq(1) + mpq(1, 2**60)
    hole = [(x, 0), (x + mpq(1, 2**60), 0), (x, 1)]
    with pytest.raises(InputError, match="no double found in hole 1"):
        points_in_holes(polygon_of([LARGE, hole]))


def test_doubles_stay_as_they_are() -> None:
    polygon = polygon_of([(0.1, 0.0), (1e300, 0.3), (0.5, 1e-300)])
    assert rounded(polygon) == polygon
    assert rings_of_doubles(polygon) == [[(0.1, 0.0), (1e300, 0.3), (0.5, 1e-300)]]


def test_thirds_become_the_nearest_doubles() -> None:
    polygon = rounded(polygon_of([(0, 0), (1, 0), ("1/3", "2/3")]))
    assert rings_of_doubles(polygon)[0][2] == (1 / 3, 2 / 3)
    assert nearest_float(mpq(1, 3)) == 1 / 3


def test_what_rounding_breaks_is_refused() -> None:
    thin = [(1, 0), (2, 0), (1, mpq(1, 10**400))]
    with pytest.raises(InputError):
        rounded(polygon_of(thin))
