"""Definition 1: the feature size of a polygon, exactly and in O(n log n) but for the flips."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from gmpy2 import mpq, mpz

from bern_exact.exact.points import HPoint, Vector, direction
from bern_exact.exact.predicates import cross, dot, is_in_wedge
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.ray_shooting import edges_around_vertices
from bern_exact.plane.triangulation import Triangulation, following, triangulate_polygon


@dataclass(frozen=True)
class FeatureSize:
    """The feature size s of a polygon, squared, and the pair that attains it.

    Parameters
    ----------
    squared : mpq
        s^2.
    vertex : int or None
        The vertex, or None if s is the length of `edge`.
    edge : int
        The edge.
    """

    squared: mpq
    vertex: int | None
    edge: int


def feature_size(polygon: Polygon, triangulation: Triangulation | None = None) -> FeatureSize:
    """The least distance within P of a vertex from an edge that it is not an end of.

    Definition 1: "the length of a shortest line segment e joining a vertex of dP to a
    non-incident edge such that e n dP is either e or the endpoints of e".  180-degree vertices
    count as vertices.

    Parameters
    ----------
    polygon : Polygon
        P, validated.
    triangulation : Triangulation, optional
        Its constrained Delaunay triangulation; made if not given.

    Returns
    -------
    FeatureSize
        Where several pairs attain it: the lowest edge that is itself so short, else the lowest
        vertex, with its lowest edge.

    Notes
    -----
    A pair (v, e), e not an edge at v, is *seen* if the shortest segment vF from v to e lies in P.
    s is the length of an edge or the distance of a seen pair, whichever is less.  Any two vertices
    joined by a segment in P are at least s apart.

    *Only wedges need be tested.*  Let vF leave v inside its closed wedge, but meet the boundary on
    the way, first at y.  If y is on an edge f not at v, then vy lies in P, and f is nearer to v
    within P than e.  If y is on an edge vu at v, then vF runs along it to u and beyond, and |vu| is
    less.  So the pair is above s, and harmless among the candidates.

    *O(n) candidates suffice*: every edge; each v with the edges at its neighbours in the
    triangulation; each v with the edges that the rays from it in four directions, at right
    angles, meet first.  Let (v, e) attain s, with every edge longer than s.

    - If x is a point of e with |Fx| <= s, then the closed triangle vFx meets the boundary
      only in v and e.  Else sweep it from vF to x by perpendiculars to e.  An edge that enters
      over vx or from x ends inside, since it cannot leave over vF or e; an edge at v that enters
      ends inside, too.  The first vertex u met on the near side of the edges at v has nothing
      between it and e: (u, e) is seen and nearer than s, as v alone is at the distance s.
    - One of the rays is within 45 degrees of vF.  It meets the line of e at G, |FG| <= s.  If G
      is on e, then e is what it meets first, by the triangle vFG.
    - If not, e has an end x with |Fx| < s.  By the triangle vFx, v sees x, and
      |vx|^2 < 2 s^2.  (If F is itself an end of e, take x = F.)  Then vx is an edge of the
      triangulation: otherwise it leaves v inside a triangle vab, and as in
      `nearest_visible_vertex` a or b, say a, sees vx under at least 90 degrees.  Let Q be the
      polygon of v, the shortest path in P from a to x inside the triangle vax, and back to v.
      In a triangulation of Q the triangle at vx has an apex u; it lies in the triangle vax, so
      that |uv|^2 + |ux|^2 <= |vx|^2.  But uv and ux lie in P, and both are at least s.

    So every pair that attains s is a candidate.  The rays are those of two sweeps, infinitesimally
    turned off the axes, so that they meet no vertex (`edges_around_vertices`).

    Examples
    --------
    >>> from bern_exact.exact.points import grid_point
    >>> corners = [grid_point(x, y) for x, y in ((0, 0), (9, 0), (3, 2), (0, 9))]
    >>> feature_size(Polygon(tuple(corners), ((0, 1, 2, 3),)))
    FeatureSize(squared=mpq(4,1), vertex=2, edge=0)
    """
    if triangulation is None:
        triangulation = triangulate_polygon(polygon)
    best = _Best(polygon)
    for v, e in _across_triangulation(polygon, triangulation):
        best.offer(v, e)
    for v, e in _along_rays(polygon):
        best.offer(v, e)
    return FeatureSize(mpq(best.numerator, best.denominator), best.vertex, best.edge)


def _across_triangulation(
    polygon: Polygon, triangulation: Triangulation
) -> Iterator[tuple[int, int]]:
    """Each vertex with the edges at its neighbours in the triangulation."""
    origin = triangulation.origin
    for h, v in enumerate(origin):
        x = origin[following(h)]
        yield v, x
        yield v, polygon.before[x]
        if triangulation.twin[h] < 0:
            yield x, v
            yield x, polygon.before[v]


def _along_rays(polygon: Polygon) -> Iterator[tuple[int, int]]:
    """Each vertex with the edges that the four rays from it meet first."""
    turned = [(y, -x, w) for x, y, w in polygon.points]
    for points in (polygon.points, turned):
        for v, met in enumerate(edges_around_vertices(points, polygon.after)):
            yield from ((v, e) for e in met if e >= 0)


class _Best:
    """The best pair so far, with its squared distance as a fraction that is not reduced."""

    def __init__(self, polygon: Polygon) -> None:
        self.polygon = polygon
        self.vertex: int | None = None
        self.edge = -1
        self.numerator, self.denominator = mpz(0), mpz(0)
        for v, w in polygon.edges():
            to_head = direction(polygon.points[v], polygon.points[w])
            scale = polygon.points[v][2] * polygon.points[w][2]
            numerator, denominator = dot(to_head, to_head), scale * scale
            if self.edge < 0 or self._compare(numerator, denominator) < 0:
                self.numerator, self.denominator = numerator, denominator
                self.edge = v

    def offer(self, v: int, e: int) -> None:
        """Take the pair if it is better and leaves v into P.  Pairs can come in any order."""
        head = self.polygon.after[e]
        if v in (e, head):
            return
        points = self.polygon.points
        to_foot, numerator, denominator = shortest_to(points[v], points[e], points[head])
        order = self._compare(numerator, denominator)
        if order > 0 or (order == 0 and not self._precedes(v, e)):
            return
        if self._leaves_into_polygon(v, to_foot):
            self.vertex, self.edge = v, e
            self.numerator, self.denominator = numerator, denominator

    def _compare(self, numerator: mpz, denominator: mpz) -> mpz:
        """Below, equal to or above 0 as this squared distance is to the best."""
        return numerator * self.denominator - self.numerator * denominator

    def _precedes(self, v: int, e: int) -> bool:
        """Does (v, e) come before the best pair?  Nothing comes before an edge's own length."""
        return self.vertex is not None and (v, e) < (self.vertex, self.edge)

    def _leaves_into_polygon(self, v: int, to_foot: Vector) -> bool:
        """Is the direction inside the closed wedge of v?"""
        points = self.polygon.points
        x, y, w = apex = points[v]
        aim = (x + to_foot[0] * w, y + to_foot[1] * w, w)
        before, after = self.polygon.before[v], self.polygon.after[v]
        return is_in_wedge(aim, points[before], apex, points[after])


def shortest_to(p: HPoint, a: HPoint, b: HPoint) -> tuple[Vector, mpz, mpz]:
    """The shortest segment from p to the closed segment ab.

    Returns
    -------
    (Vector, mpz, mpz)
        Its direction, and numerator and denominator of its squared length, not reduced.

    >>> from bern_exact.exact.points import grid_point
    >>> direction, numerator, denominator = shortest_to(
    ...     grid_point(0, 0), grid_point(1, 0), grid_point(0, 1)
    ... )
    >>> direction, mpq(numerator, denominator)
    ((mpz(1), mpz(1)), mpq(1,2))
    """
    along, to_a, to_b = direction(a, b), direction(p, a), direction(p, b)
    if dot(along, to_a) >= 0:
        w = p[2] * a[2]
        return to_a, dot(to_a, to_a), w * w
    if dot(along, to_b) <= 0:
        w = p[2] * b[2]
        return to_b, dot(to_b, to_b), w * w
    area = cross(to_a, to_b)  # pw^2 aw bw times its true value; `along` is aw bw times its own
    w = p[2] * p[2]
    normal = (along[1], -along[0]) if area > 0 else (-along[1], along[0])
    return normal, area * area, w * w * dot(along, along)
