"""What is known of a polygon before any triangulation: sizes, corners, the bound on heights."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cmp_to_key
from typing import Any

from gmpy2 import mpq

from bern_exact.exact.numbers import format_rational
from bern_exact.exact.points import HPoint, direction
from bern_exact.exact.predicates import compare_xy, cross, dot, orientation, squared_distance
from bern_exact.plane.feature_size import FeatureSize, feature_size
from bern_exact.plane.polygon import Polygon


@dataclass(frozen=True)
class Facts:
    """The facts of a polygon.

    Parameters
    ----------
    polygon : Polygon
        The polygon.
    feature : FeatureSize
        Definition 1, squared, and where it is attained.
    diameter_squared : mpq
        The largest squared distance of two vertices.
    acute : tuple of int
        The vertices with an interior angle strictly below 90 degrees.
    convex : bool
        No hole and no reflex vertex; 180-degree vertices are allowed.
    """

    polygon: Polygon
    feature: FeatureSize
    diameter_squared: mpq
    acute: tuple[int, ...]
    convex: bool

    @property
    def max_height_squared(self) -> mpq:
        """A squared bound on the least height of any triangulation: the feature size's."""
        return self.feature.squared

    def to_json(self) -> dict[str, Any]:
        """The facts as `facts --json` prints them."""
        place = self.polygon.place
        at: dict[str, Any] = {"edge": list(self.polygon.edge_place(self.feature.edge))}
        if self.feature.vertex is not None:
            at = {"vertex": list(place(self.feature.vertex)), **at}
        return {
            "n": self.polygon.n,
            "holes": self.polygon.holes,
            "area": format_rational(self.polygon.area),
            "feature_size_squared": format_rational(self.feature.squared),
            "feature_size_at": at,
            "diameter_squared": format_rational(self.diameter_squared),
            "acute_vertices": [list(place(v)) for v in self.acute],
            "convex": self.convex,
            "max_height_squared": format_rational(self.max_height_squared),
        }


def facts_of(polygon: Polygon) -> Facts:
    """All facts of a polygon, exactly; O(n log n) but for the feature size.

    Parameters
    ----------
    polygon : Polygon
        A valid polygon.
    """
    return Facts(
        polygon,
        feature_size(polygon),
        squared_diameter(polygon.points),
        tuple(v for v in range(polygon.n) if is_acute(polygon, v)),
        polygon.holes == 0 and all(turn(polygon, v) >= 0 for v in range(polygon.n)),
    )


def turn(polygon: Polygon, vertex: int) -> int:
    """1 at a convex vertex, 0 at a 180-degree one, -1 at a reflex one."""
    points = polygon.points
    return orientation(
        points[polygon.before[vertex]], points[vertex], points[polygon.after[vertex]]
    )


def is_acute(polygon: Polygon, vertex: int) -> bool:
    """Is the interior angle strictly below 90 degrees?"""
    apex = polygon.points[vertex]
    back = direction(apex, polygon.points[polygon.before[vertex]])
    ahead = direction(apex, polygon.points[polygon.after[vertex]])
    return turn(polygon, vertex) > 0 and dot(back, ahead) > 0


def squared_diameter(points: Sequence[HPoint]) -> mpq:
    """The largest squared distance of two points, by rotating calipers round their hull.

    Parameters
    ----------
    points : sequence of HPoint
        At least three, not all on one line.

    >>> from bern_exact.exact.points import hpoint
    >>> squared_diameter([hpoint(0, 0), hpoint(3, 0), hpoint(3, 4), hpoint(2, 1)])
    mpq(25,1)
    """
    hull = convex_hull(points)
    size, largest, far = len(hull), mpq(0), 1
    for i, p in enumerate(hull):
        q = hull[(i + 1) % size]
        edge = direction(p, q)
        # `far` goes on while that leads away from the edge; parallel edges pair all four ends.
        while (turned := cross(edge, direction(hull[far], hull[(far + 1) % size]))) > 0:
            far = (far + 1) % size
        opposite = [hull[far], hull[(far + 1) % size]] if turned == 0 else [hull[far]]
        largest = max(largest, *(squared_distance(end, r) for end in (p, q) for r in opposite))
    return largest


def convex_hull(points: Sequence[HPoint]) -> list[HPoint]:
    """The strictly convex corners of the hull, counter-clockwise from the leftmost (Andrew)."""
    ordered = sorted(points, key=cmp_to_key(compare_xy))
    return _half_hull(ordered)[:-1] + _half_hull(ordered[::-1])[:-1]


def _half_hull(ordered: Sequence[HPoint]) -> list[HPoint]:
    """The chain of left turns from the first to the last point."""
    chain: list[HPoint] = []
    for p in ordered:
        while len(chain) > 1 and orientation(chain[-2], chain[-1], p) <= 0:
            chain.pop()
        chain.append(p)
    return chain
