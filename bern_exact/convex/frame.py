"""The diameter, and the frame in which it is horizontal (Section 5)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gmpy2 import mpq, mpz

from bern_exact.convex.records import Chain, ConvexFrame, Position
from bern_exact.exact.errors import InputError
from bern_exact.exact.points import HPoint, coordinates, direction
from bern_exact.exact.predicates import compare_xy, cross, orientation, squared_distance
from bern_exact.exact.similarity import Similarity
from bern_exact.plane.polygon import Polygon


def convex_frame(polygon: Polygon) -> ConvexFrame:
    """Map a convex polygon so that its diameter is from (0, 0) to (1, 0).

    Section 5: "We orient the polygon so that its longest diagonal is horizontal."  Edges count as
    diagonals here, so that A is the only leftmost and B the only rightmost vertex, and no edge is
    vertical.

    Parameters
    ----------
    polygon : Polygon
        Valid; 180-degree vertices are allowed.

    Raises
    ------
    InputError
        Kind `has-holes`, or `not-convex` naming the first reflex vertex.

    Notes
    -----
    Linear time.  Of equally long diameters the lexicographically first pair of points is taken.
    """
    require_convex(polygon)
    a, b = diameter(polygon)
    (ax, ay), (bx, by) = coordinates(polygon.points[a]), coordinates(polygon.points[b])
    dx, dy = bx - ax, by - ay
    squared = dx * dx + dy * dy
    # p -> (p - A) / (B - A), the complex quotient.
    u, v = dx / squared, -dy / squared
    similarity = Similarity.of((u, v), (-(ax * u - ay * v), -(ax * v + ay * u)))
    places = tuple(coordinates(similarity.apply(p)) for p in polygon.points)
    lower = [places[i] for i in _from_to(polygon, a, b)]
    upper = [places[i] for i in _from_to(polygon, b, a)][::-1]
    return ConvexFrame(polygon, a, b, similarity, places, (_chain(upper, 1), _chain(lower, -1)))


def require_convex(polygon: Polygon) -> None:
    """Refuse holes and reflex vertices.

    Raises
    ------
    InputError
        Kind `has-holes`, or `not-convex` naming the first reflex vertex.
    """
    if polygon.holes:
        raise InputError(
            "has-holes",
            f"Theorem 4 is for convex polygons and this one has {polygon.holes} "
            f"hole{'' if polygon.holes == 1 else 's'}",
            {"ring": 1},
        )
    points, before, after = polygon.points, polygon.before, polygon.after
    for v in range(polygon.n):
        if orientation(points[before[v]], points[v], points[after[v]]) < 0:
            place = list(polygon.place(v))
            raise InputError(
                "not-convex",
                f"Theorem 4 is for convex polygons and vertex {place} is reflex: "
                "Theorem 2 is meant",
                {"vertex": place},
            )


def diameter(polygon: Polygon) -> tuple[int, int]:
    """The vertices of a convex polygon that are farthest apart, by rotating calipers.

    Of equally long ones the lexicographically first pair (A, B), A before B.

    >>> from bern_exact.exact.points import grid_point
    >>> square = tuple(grid_point(x, y) for x, y in ((1, 0), (1, 1), (0, 1), (0, 0)))
    >>> diameter(Polygon(square, ((0, 1, 2, 3),)))  # from (0, 0) to (1, 1)
    (3, 1)
    """
    points = polygon.points
    best: tuple[mpq, int, int] | None = None
    for v, w in _antipodal(polygon):
        first, second = (v, w) if compare_xy(points[v], points[w]) < 0 else (w, v)
        squared = squared_distance(points[v], points[w])
        if (
            best is None
            or squared > best[0]
            or (squared == best[0] and _precedes(points, (first, second), best[1:]))
        ):
            best = (squared, first, second)
    if best is None:
        raise InputError("too-few-vertices", "a polygon has at least 3 corners")
    return best[1:]


def _precedes(points: Sequence[HPoint], pair: tuple[int, int], other: tuple[int, int]) -> bool:
    """Is a pair of points lexicographically before another?"""
    order = compare_xy(points[pair[0]], points[other[0]])
    return order < 0 or (order == 0 and compare_xy(points[pair[1]], points[other[1]]) < 0)


def _antipodal(polygon: Polygon) -> Iterator[tuple[int, int]]:
    """All pairs of corners that parallel lines of support may touch."""
    points, before, after = polygon.points, polygon.before, polygon.after
    hull = [
        v
        for v in polygon.rings[0]
        if orientation(points[before[v]], points[v], points[after[v]]) > 0
    ]
    size, far = len(hull), 1
    for i, v in enumerate(hull):
        w = hull[(i + 1) % size]
        edge = direction(points[v], points[w])
        while (turned := _turned(points, edge, hull, far)) > 0:
            far = (far + 1) % size
        yield from ((v, hull[far]), (w, hull[far]))
        if turned == 0:  # parallel edges pair all four ends
            beyond = hull[(far + 1) % size]
            yield from ((v, beyond), (w, beyond))


def _turned(points: Sequence[HPoint], edge: tuple[mpz, mpz], hull: Sequence[int], far: int) -> mpz:
    """Positive while the corner after `far` is farther from the edge."""
    return cross(edge, direction(points[hull[far]], points[hull[(far + 1) % len(hull)]]))


def _from_to(polygon: Polygon, start: int, end: int) -> Iterator[int]:
    """The vertices from one to another along the ring, both included."""
    yield start
    while start != end:
        start = polygon.after[start]
        yield start


def _chain(places: Sequence[Position], sign: int) -> Chain:
    """The chain through these places from A to B."""
    return Chain(tuple(x for x, _ in places), tuple(sign * y for _, y in places))
