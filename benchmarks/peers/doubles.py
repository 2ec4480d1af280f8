"""What meshers that compute in doubles are given: nearest doubles, and points in holes."""

from __future__ import annotations

from collections.abc import Sequence

from gmpy2 import mpq

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import nearest_binary64
from bern_exact.exact.points import HPoint, coordinates, hpoint
from bern_exact.exact.predicates import orientation
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings

Double = tuple[float, float]


def rounded(polygon: Polygon) -> Polygon:
    """The polygon with every coordinate rounded to the nearest double.

    Raises
    ------
    InputError
        If that is no polygon any more.
    """
    rings = [[_nearest(p) for p in polygon.input_ring(r)] for r in range(len(polygon.rings))]
    return polygon_from_rings(rings, polygon.name)


def _nearest(point: HPoint) -> HPoint:
    x, y = coordinates(point)
    return hpoint(nearest_binary64(x), nearest_binary64(y))


def rings_of_doubles(polygon: Polygon) -> list[list[Double]]:
    """The rings of a polygon of doubles, interior on the left, as floats."""
    return [[_floats(polygon.points[v]) for v in ring] for ring in polygon.rings]


def _floats(point: HPoint) -> Double:
    """A point of doubles as what it is: nothing is rounded here."""
    x, y = coordinates(point)
    return nearest_float(x), nearest_float(y)


def nearest_float(value: mpq) -> float:
    """The double nearest to a rational.

    >>> nearest_float(mpq(1, 3)), nearest_float(mpq(-5))
    (0.3333333333333333, -5.0)
    """
    return int(value.numerator) / int(value.denominator)


def points_in_holes(polygon: Polygon) -> list[Double]:
    """For each hole a double strictly inside it, as meshers want to be told of holes.

    Raises
    ------
    InputError
        If a hole is too thin for the few doubles that are tried.
    """
    return [
        _point_inside([polygon.points[v] for v in reversed(ring)], r)
        for r, ring in enumerate(polygon.rings[1:], 1)
    ]


def _point_inside(ring: Sequence[HPoint], number: int) -> Double:
    """A double inside a counter-clockwise ring.

    At a convex corner abc, the middle of the triangle abc is inside; or, if other vertices are
    in it, the middle between b and the one farthest from ac.  Every corner is tried.
    """
    for i, b in enumerate(ring):
        a, c = ring[i - 1], ring[(i + 1) % len(ring)]
        if orientation(a, b, c) <= 0:
            continue
        blocking = [p for p in ring if p not in (a, b, c) and _in_triangle(p, (a, b, c))]
        corners = [b, max(blocking, key=lambda p: _off(p, a, c))] if blocking else [a, b, c]
        middle = _nearest(_mean(corners))
        if _is_inside(middle, ring):
            return _floats(middle)
    raise InputError("unsupported", f"no double found in hole {number}", {"ring": number})


def _mean(points: Sequence[HPoint]) -> HPoint:
    pairs = [coordinates(p) for p in points]
    x, y = (sum(values, mpq(0)) / len(points) for values in zip(*pairs, strict=True))
    return hpoint(x, y)


def _in_triangle(p: HPoint, corners: Sequence[HPoint]) -> bool:
    """Is a point in a closed triangle, given counter-clockwise?"""
    return all(orientation(corners[i - 1], corners[i], p) >= 0 for i in range(3))


def _off(p: HPoint, a: HPoint, c: HPoint) -> mpq:
    """Something that grows with the distance of p from ac, to its right."""
    (px, py), (ax, ay), (cx, cy) = map(coordinates, (p, a, c))
    return (px - ax) * (cy - ay) - (py - ay) * (cx - ax)


def _is_inside(point: HPoint, ring: Sequence[HPoint]) -> bool:
    """Is a point strictly inside a ring?  By the edges that a ray in direction +x meets."""
    _, y = coordinates(point)
    odd = False
    for i, q in enumerate(ring):
        p = ring[i - 1]
        low, high = (p, q) if coordinates(p)[1] <= coordinates(q)[1] else (q, p)
        turn = orientation(low, high, point)
        if turn == 0 and min(p, q, key=coordinates) != point != max(p, q, key=coordinates):
            (ax, ay), (bx, by), (x, _) = map(coordinates, (p, q, point))
            if min(ax, bx) <= x <= max(ax, bx) and min(ay, by) <= y <= max(ay, by):
                return False
        if coordinates(low)[1] <= y < coordinates(high)[1] and turn > 0:
            odd = not odd
    return odd
