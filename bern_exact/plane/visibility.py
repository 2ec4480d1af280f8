"""Nearest visible vertices, read off the constrained Delaunay triangulation."""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.exact.predicates import squared_distance
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import Triangulation, following


def nearest_visible_vertex(
    polygon: Polygon, triangulation: Triangulation, v: int
) -> tuple[int, mpq]:
    """The vertex nearest to v among those that v sees within P, and the squared distance.

    Section 2: "the closest distinct vertex w (by geodesic distance within P)".  The nearest
    vertex by geodesic distance is visible: a geodesic that bends does so at a nearer vertex.

    Parameters
    ----------
    polygon : Polygon
        P, validated.
    triangulation : Triangulation
        Its constrained Delaunay triangulation.
    v : int
        A vertex.

    Returns
    -------
    (int, mpq)
        The vertex w != v, of several nearest ones the lowest, and |vw|^2.

    Notes
    -----
    Every nearest visible vertex w is joined to v by an edge of the triangulation.  Suppose that
    the segment vw, which meets no other vertex, leaves v through the inside of a triangle vab.
    The circle through v, a, b has no vertex inside that is visible from inside the triangle,
    so w is not inside it: the angles of the quadrilateral vawb at v and w add up to at most 180
    degrees, and one of those at a and b, say at a, is at least 90 degrees.  Then |va| < |vw|,
    and v sees a.

    Linear in the degree of v, the sum of which is linear in n.

    Examples
    --------
    >>> from bern_exact.exact.points import grid_point
    >>> from bern_exact.plane.triangulation import triangulate_polygon
    >>> corners = [grid_point(x, y) for x, y in ((0, 0), (9, 0), (2, 1), (0, 9))]
    >>> dart = Polygon(tuple(corners), ((0, 1, 2, 3),))
    >>> nearest_visible_vertex(dart, triangulate_polygon(dart), 0)
    (2, mpq(5,1))
    """
    points = polygon.points
    seen = [polygon.before[v]]
    seen += (triangulation.origin[following(h)] for h in triangulation.around(v))
    squared, nearest = min((squared_distance(points[v], points[x]), x) for x in seen)
    return nearest, squared
