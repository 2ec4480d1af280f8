"""Lopping: which corners, where they are cut, and what is left."""

from __future__ import annotations

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.boundary.lop import is_acute
from bern_exact.boundary.records import Cut, Lopped
from bern_exact.exact.points import HPoint, coordinates, hpoint
from bern_exact.exact.predicates import orientation, squared_distance
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings
from tests.boundary.samples import drawn, every_family, lopped
from tests.plane.by_definition import inside, sees
from tests.plane.shapes import polygons

Vector = tuple[mpq, mpq]


def run(a: HPoint, b: HPoint) -> Vector:
    (x, y), (u, v) = coordinates(a), coordinates(b)
    return u - x, v - y


def dot(u: Vector, v: Vector) -> mpq:
    return u[0] * v[0] + u[1] * v[1]


def triangle_of(record: Lopped, cut: Cut) -> tuple[HPoint, HPoint, HPoint]:
    """Corner, after and before: counter-clockwise."""
    points = record.lopped.points
    return record.polygon.points[cut.corner], points[cut.after], points[cut.before]


def check_all(record: Lopped) -> None:
    """Everything that lopping promises."""
    check_who_is_cut(record)
    for cut in record.cuts:
        check_base_angles(record, cut)
        check_distances(record, cut)


def check_who_is_cut(record: Lopped) -> None:
    """Exactly the corners below 90 degrees, and none is left."""
    polygon = record.polygon
    acute = [
        v
        for v, p in enumerate(polygon.points)
        if orientation(polygon.points[polygon.before[v]], p, polygon.points[polygon.after[v]]) > 0
        and dot(run(p, polygon.points[polygon.before[v]]), run(p, polygon.points[polygon.after[v]]))
        > 0
    ]
    assert [cut.corner for cut in record.cuts] == acute
    assert not any(is_acute(record.lopped, v) for v in range(record.lopped.n))
    kept = [v for v in record.origin if v >= 0]
    assert sorted([*kept, *acute]) == list(range(polygon.n))
    assert all(
        record.lopped.points[i] == polygon.points[v] for i, v in enumerate(record.origin) if v >= 0
    )


def check_base_angles(record: Lopped, cut: Cut) -> None:
    """Both are from 45 to 90 degrees: dot >= 0 and dot <= cross."""
    corner, after, before = triangle_of(record, cut)
    for apex, first, second in ((after, before, corner), (before, corner, after)):
        u, v = run(apex, first), run(apex, second)
        assert 0 <= dot(u, v) <= u[0] * v[1] - u[1] * v[0]


def check_distances(record: Lopped, cut: Cut) -> None:
    """On the two edges, at most |vw|/3 from the corner, and less by at most 2^-9 of it."""
    corner, after, before = triangle_of(record, cut)
    polygon = record.polygon
    third = squared_distance(corner, polygon.points[cut.nearest]) / 9
    assert inside(after, corner, polygon.points[polygon.after[cut.corner]])
    assert inside(before, corner, polygon.points[polygon.before[cut.corner]])
    for end in (after, before):
        assert third * (1 - mpq(1, 2**9)) ** 2 <= squared_distance(corner, end) <= third


@every_family
def test_all_promises(kind: str, seed: int) -> None:
    check_all(drawn(kind, seed).lopped)


@given(polygons())
def test_all_promises_on_random_polygons(polygon: Polygon) -> None:
    check_all(lopped(polygon))


@given(polygons())
def test_nearest_is_the_nearest_that_is_seen(polygon: Polygon) -> None:
    points = polygon.points
    for cut in lopped(polygon).cuts:
        v = points[cut.corner]
        seen = [
            squared_distance(v, w)
            for i, w in enumerate(points)
            if i != cut.corner and sees(polygon, v, w)
        ]
        assert squared_distance(v, points[cut.nearest]) == min(seen)


@pytest.mark.parametrize("digits", [1, 3, 6, 9, 12, 15, 30])
@pytest.mark.parametrize("sign", [-1, 0, 1])
def test_corners_within_a_hair_of_ninety_degrees(digits: int, sign: int) -> None:
    off = sign * mpq(1, 10**digits)
    rings = [[hpoint(0, 0), hpoint(1, 0), hpoint(1, 1), hpoint(off, 1)]]
    record = lopped(polygon_from_rings(rings))
    check_all(record)
    # At the bottom left and at the top left the angle is off on opposite sides.
    assert [cut.corner for cut in record.cuts] == {-1: [3], 0: [], 1: [0]}[sign]


@given(st.integers(1, 10**6), st.integers(1, 10**15), st.integers(1, 100))
def test_thin_spikes(height: int, length: int, denominator: int) -> None:
    apex = hpoint(length, mpq(height, denominator))
    rings = [[hpoint(0, 0), apex, hpoint(0, mpq(height, denominator) * 2)]]
    check_all(lopped(polygon_from_rings(rings)))


def test_reflex_corners_of_holes_are_left_and_acute_ones_cut() -> None:
    outer = [hpoint(x, y) for x, y in ((0, 0), (20, 0), (20, 20), (0, 20))]
    # A dart: its three tips are reflex for P, its notch is obtuse.
    dart = [hpoint(x, y) for x, y in ((5, 5), (10, 14), (15, 5), (10, 8))]
    record = lopped(polygon_from_rings([outer, dart]))
    check_all(record)
    assert [cut.corner for cut in record.cuts] == []
    # Between two prongs the notch is an acute corner of P.
    notched = [hpoint(x, y) for x, y in ((5, 5), (9, 15), (10, 6), (11, 15), (15, 5))]
    record = lopped(polygon_from_rings([outer, notched]))
    check_all(record)
    assert [cut.corner for cut in record.cuts] == [6]


def test_the_numbering_follows_the_rings() -> None:
    record = drawn("simple_with_holes", 0).lopped
    assert [v for ring in record.lopped.rings for v in ring] == list(range(record.lopped.n))
    for ring, cut_ring in zip(record.polygon.rings, record.lopped.rings, strict=True):
        kept = [record.origin[i] for i in cut_ring if record.origin[i] >= 0]
        corners = {cut.corner for cut in record.cuts}
        assert kept == [v for v in ring if v not in corners]
