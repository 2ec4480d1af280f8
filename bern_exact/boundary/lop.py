"""Lopping off the acute corners (Section 2, Lemma 1).

The paper cuts an isosceles triangle at each acute vertex v by a line across
vw at a third, w being the vertex nearest to v.  With that line Lemma 1 is
false: its legs can reach (sqrt 2 / 3) |vw|.  The repair: both incident edges
are cut at distance |vw|/3 from v.  That length is irrational, so the two
parameters along the edges are rounded down, more and more finely until the
base angles of the triangle are within [45, 90] degrees exactly: then its fan
has no angle above 135 degrees, and P' no angle below 90 at the cut.
"""

from __future__ import annotations

from bern_exact.boundary.records import Cut, Lopped
from bern_exact.exact.angles import tangent_pair
from bern_exact.exact.points import HPoint, along, direction
from bern_exact.exact.predicates import dot, orientation, squared_distance
from bern_exact.exact.roots import sqrt_below
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import Triangulation
from bern_exact.plane.visibility import nearest_visible_vertex

FIRST_BITS = 10
"""Significant bits of the cut parameters to begin with."""


def is_acute(polygon: Polygon, v: int) -> bool:
    """Is the interior angle at vertex v strictly below 90 degrees?"""
    p = polygon.points
    before, after = p[polygon.before[v]], p[polygon.after[v]]
    return orientation(before, p[v], after) > 0 and bool(
        dot(direction(p[v], before), direction(p[v], after)) > 0
    )


def lop(polygon: Polygon, triangulation: Triangulation) -> Lopped:
    """Cut off every acute corner a third of the way to its nearest visible vertex.

    Section 2: "The first step of our maxmin-height algorithm is to 'lop off' acute
    vertices of P."

    Parameters
    ----------
    polygon : Polygon
        P, validated.
    triangulation : Triangulation
        The constrained Delaunay triangulation of P, as `triangulate_polygon` makes it: it
        finds nearest visible vertices.

    Returns
    -------
    Lopped
        P' has no angle below 90 degrees.

    Notes
    -----
    Near-linear in practice: one exploration of the triangulation for each acute vertex.
    A spike of nearly 90 degrees needs about 34 bits.
    """
    points: list[HPoint] = []
    origin: list[int] = []
    rings: list[tuple[int, ...]] = []
    cuts: list[Cut] = []
    for ring in polygon.rings:
        start = len(points)
        for v in ring:
            if not is_acute(polygon, v):
                points.append(polygon.points[v])
                origin.append(v)
                continue
            nearest, (before, after) = _cut(polygon, triangulation, v)
            cuts.append(Cut(v, nearest, len(points), len(points) + 1))
            points += (before, after)
            origin += (-1, -1)
        rings.append(tuple(range(start, len(points))))
    lopped = Polygon(tuple(points), tuple(rings), polygon.name)
    return Lopped(polygon, lopped, tuple(origin), tuple(sorted(cuts)))


def _cut(
    polygon: Polygon, triangulation: Triangulation, v: int
) -> tuple[int, tuple[HPoint, HPoint]]:
    """The nearest visible vertex of v, and the cut points on the edges into and out of v."""
    nearest, squared = nearest_visible_vertex(polygon, triangulation, v)
    p = polygon.points
    apex, before, after = p[v], p[polygon.before[v]], p[polygon.after[v]]
    squared_in = squared / (9 * squared_distance(apex, before))
    squared_out = squared / (9 * squared_distance(apex, after))
    bits = FIRST_BITS
    while True:
        a = along(apex, before, sqrt_below(squared_in, bits))
        b = along(apex, after, sqrt_below(squared_out, bits))
        # Rounding makes the triangle slightly scalene; it ends, as the limit's base
        # angles lie strictly between 45 and 90 degrees.
        if _is_base_angle(apex, b, a) and _is_base_angle(b, a, apex):
            return nearest, (a, b)
        bits += FIRST_BITS // 2


def _is_base_angle(before: HPoint, apex: HPoint, after: HPoint) -> bool:
    """Is the angle turned at `apex` from `after` to `before` within [45, 90] degrees?"""
    product, area = tangent_pair(before, apex, after)
    return bool(0 <= product <= area)
