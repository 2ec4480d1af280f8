"""The triangulation is one: it tiles the polygon, keeps its edges, and is Delaunay inside."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from bern_exact.exact.points import HPoint, coordinates, grid_point
from bern_exact.exact.predicates import orientation
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import Triangulation, before, following, triangulate_polygon

from .by_definition import twice_area
from .shapes import comb, oriented, plate, polygons, spiral, star


def check(polygon: Polygon, t: Triangulation) -> None:
    """Positive triangles, twins opposite, boundary exactly the polygon's, right area and count."""
    area = 0
    for a, b, c in t.triangles():
        corners = [polygon.points[v] for v in (a, b, c)]
        assert orientation(*corners) > 0
        area += twice_area(corners)
    assert area == 2 * polygon.area
    assert len(t.origin) == 3 * (polygon.n + 2 * polygon.holes - 2)
    for h, g in enumerate(t.twin):
        ends = t.origin[h], t.origin[following(h)]
        if g < 0:
            assert polygon.after[ends[0]] == ends[1] and t.leaving[ends[0]] == h
        else:
            assert t.twin[g] == h and (t.origin[following(g)], t.origin[g]) == ends
    assert sorted(t.origin[h] for h in t.leaving) == list(range(polygon.n))


def in_circle(a: HPoint, b: HPoint, c: HPoint, d: HPoint) -> bool:
    """Is d strictly inside the circle through the counter-clockwise a, b, c?  By determinant."""
    rows = []
    dx, dy = coordinates(d)
    for p in (a, b, c):
        x, y = (own - its for own, its in zip(coordinates(p), (dx, dy), strict=True))
        rows.append((x, y, x * x + y * y))
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = rows
    return ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx) > 0


def check_delaunay(polygon: Polygon, t: Triangulation) -> None:
    for h, g in enumerate(t.twin):
        if g >= 0:
            corners = [polygon.points[t.origin[k]] for k in (h, following(h), before(h))]
            assert not in_circle(*corners, polygon.points[t.origin[before(g)]])


@given(polygons())
def test_any_polygon(polygon: Polygon) -> None:
    t = triangulate_polygon(polygon)
    check(polygon, t)
    check_delaunay(polygon, t)


def test_large_ones() -> None:
    for rings in ([star(500)], [spiral(200)], [comb(200)], plate(60)):
        polygon = oriented(rings)
        t = triangulate_polygon(polygon)
        check(polygon, t)
        check_delaunay(polygon, t)


def test_the_half_edges_around_a_vertex_fill_its_wedge() -> None:
    polygon = oriented(plate(9))
    t = triangulate_polygon(polygon)
    for v in range(polygon.n):
        spokes = list(t.around(v))
        assert t.origin[following(spokes[0])] == polygon.after[v]
        assert t.origin[before(spokes[-1])] == polygon.before[v]
        assert len(spokes) == list(t.origin).count(v)


@given(st.integers(1, 6))
def test_subdivided_sides_need_no_flat_triangles(k: int) -> None:
    side = [(i, 0) for i in range(k)] + [(k, i) for i in range(k)]
    side += [(k - i, k) for i in range(k)] + [(0, k - i) for i in range(k)]
    polygon = oriented([[grid_point(x, y) for x, y in side]])
    check(polygon, triangulate_polygon(polygon))
