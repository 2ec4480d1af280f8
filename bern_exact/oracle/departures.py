"""How far the boundary of a mesh departs from a polygon: rounding, told from a bug.

A mesher that computes in doubles puts a vertex on a sloped edge almost never exactly on it, and one
that prints 16 digits moves the polygon's own vertices.  So each vertex of the polygon is matched
with the nearest vertex of the boundary; the boundary is followed from one to the next; and what
lies between is held against the edge that joins them.  All of that is exact.
"""

from __future__ import annotations

from bisect import bisect
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gmpy2 import mpq

from bern_exact.exact.enclosures import sqrt_enclosure
from bern_exact.exact.points import HPoint, coordinates
from bern_exact.exact.predicates import squared_distance, squared_distance_to_segment
from bern_exact.oracle.verdict import point_json
from bern_exact.plane.polygon import Polygon

MANTISSA, LEAST = 52, -1074
"""A double of size 2^e to 2^(e+1) is a multiple of 2^(e-MANTISSA), and of 2^LEAST at any rate."""


@dataclass(frozen=True)
class Departure:
    """A boundary vertex of the mesh that is not on its edge, or not at its vertex, of the polygon.

    Parameters
    ----------
    vertex : int
        Of the mesh.
    point : HPoint
        Where it is.
    where : mapping
        `{"polygon_edge": [ring, number]}`, the edge that it belongs to, or `{"polygon_vertex":
        [ring, number]}`, the vertex that it stands for.
    squared : mpq
        Its squared distance from that.
    """

    vertex: int
    point: HPoint
    where: Mapping[str, list[int]]
    squared: mpq

    @property
    def is_vertex(self) -> bool:
        """Does it stand for a vertex of the polygon?"""
        return "polygon_vertex" in self.where

    def to_json(self) -> dict[str, Any]:
        """The edge or vertex and the distance from it, exactly, enclosed, and in ulps."""
        unit = ulp(self.point)
        return {
            **self.where,
            "distance_squared": str(self.squared),
            "distance": list(sqrt_enclosure(self.squared)),
            "ulps": list(sqrt_enclosure(self.squared / (unit * unit), 3)),
        }


def ulp(point: HPoint) -> mpq:
    """The unit in the last place of a double as large as the larger coordinate.

    >>> from bern_exact.exact.points import hpoint
    >>> ulp(hpoint(3, mpq(-5, 4))) == mpq(1, 2**51)
    True
    """
    size = max(abs(c) for c in coordinates(point))
    if size == 0:
        return mpq(2) ** LEAST
    exponent = size.numerator.bit_length() - size.denominator.bit_length()
    if mpq(2) ** exponent > size:
        exponent -= 1
    return mpq(2) ** max(exponent - MANTISSA, LEAST)


Point = Callable[[int], HPoint]
"""The point of a vertex of the mesh."""


@dataclass(frozen=True)
class Followed:
    """A mesh's boundary, followed along the polygon.

    Parameters
    ----------
    departures : tuple of Departure
        The boundary vertices that are not where they belong, by vertex.
    gaps : frozenset of int
        The vertices of rings that pass no vertex of the polygon: gaps and overlaps within the mesh,
        not its outline.
    """

    departures: tuple[Departure, ...]
    gaps: frozenset[int]


def followed(rings: Sequence[Sequence[int]], point: Point, polygon: Polygon) -> Followed | None:
    """The boundary of a mesh along the polygon that it should triangulate.

    Parameters
    ----------
    rings : sequence of rings
        The boundary of the mesh, see `boundary_rings`.
    point : callable
        The point of a vertex.
    polygon : Polygon
        What the mesh should triangulate.

    Returns
    -------
    Followed or None
        None if the boundary does not pass every vertex of the polygon (or the boundary vertex
        nearest to it), once each, ring by ring and in order: then it is not known which edge a
        vertex belongs to.

    Notes
    -----
    O(m log m) for m boundary vertices if the polygon's vertices have one near by, up to O(n m) for
    n of them if not.
    """
    stands_for = _matched({v: point(v) for ring in rings for v in ring}, polygon)
    if stands_for is None:
        return None
    found: list[Departure] = []
    gaps = set[int]()
    visited = 0
    for ring in rings:
        stops = [stands_for[v] for v in ring if v in stands_for]
        visited += len(stops)
        if not stops:
            gaps.update(ring)
            continue
        if not _is_a_ring(stops, polygon):
            return None
        edge = stops[-1]
        for v in ring:
            edge = stands_for.get(v, edge)
            found.append(_departure(v, point(v), polygon, edge, is_stop=v in stands_for))
    if visited != polygon.n:
        return None
    off = sorted((each for each in found if each.squared != 0), key=lambda each: each.vertex)
    return Followed(tuple(off), frozenset(gaps))


def _matched(boundary: Mapping[int, HPoint], polygon: Polygon) -> dict[int, int] | None:
    """Boundary vertex -> the vertex of the polygon that it is, or is the nearest to.

    None if one would stand for two.
    """
    at = {p: v for v, p in boundary.items()}
    near = Near(boundary)
    matched: dict[int, int] = {}
    for u, p in enumerate(polygon.points):
        v = at[p] if p in at else near.vertex(p)
        if v is None or v in matched:
            return None
        matched[v] = u
    return matched


class Near:
    """Boundary vertices in the order of their x, to find the one that is nearest to a point.

    Parameters
    ----------
    boundary : mapping
        Their points.
    """

    def __init__(self, boundary: Mapping[int, HPoint]) -> None:
        self._points = boundary
        self._order = sorted((mpq(p[0], p[2]), v) for v, p in boundary.items())

    def vertex(self, p: HPoint) -> int | None:
        """The nearest vertex, the one with the least number of several; None if there is none.

        Looks outwards from the point's x, as far as the best so far.
        """
        x = mpq(p[0], p[2])
        middle = bisect(self._order, (x, -1))
        best: tuple[mpq, int] | None = None
        for side in (self._order[middle:], self._order[:middle][::-1]):
            for other, v in side:
                if best is not None and (other - x) ** 2 > best[0]:
                    break
                found = squared_distance(p, self._points[v]), v
                best = found if best is None else min(best, found)
        return None if best is None else best[1]


def _is_a_ring(visited: Sequence[int], polygon: Polygon) -> bool:
    """Are these the vertices of one of the polygon's rings, each once and in order?"""
    if len(visited) != len(polygon.rings[polygon.ring_of[visited[0]]]):
        return False
    after = [*visited[1:], visited[0]]
    return all(polygon.after[v] == w for v, w in zip(visited, after, strict=True))


def _departure(vertex: int, p: HPoint, polygon: Polygon, edge: int, *, is_stop: bool) -> Departure:
    """How far a vertex is from where it belongs: an edge, or the vertex where that begins."""
    if is_stop:
        where = {"polygon_vertex": list(polygon.place(edge))}
        return Departure(vertex, p, where, squared_distance(p, polygon.points[edge]))
    where = {"polygon_edge": list(polygon.edge_place(edge))}
    return Departure(vertex, p, where, _squared(p, polygon, edge))


def _squared(p: HPoint, polygon: Polygon, edge: int) -> mpq:
    """The squared distance of a point from an edge of the polygon."""
    return squared_distance_to_segment(p, polygon.points[edge], polygon.points[polygon.after[edge]])


def nearest_edge(vertex: int, p: HPoint, polygon: Polygon) -> Departure:
    """The departure of a vertex from the nearest edge, where it is not known which is its own.

    Linear in the polygon's vertices.
    """
    _, edge = min((_squared(p, polygon, edge), edge) for edge in range(polygon.n))
    return _departure(vertex, p, polygon, edge, is_stop=False)


def furthest(found: Sequence[Departure]) -> dict[str, Any]:
    """How many vertices depart from where they belong, and the one that does by most."""
    worst = max(found, key=lambda departure: departure.squared)
    record = {"vertices": len({departure.vertex for departure in found}), "vertex": worst.vertex}
    return {**record, "point": point_json(worst.point), **worst.to_json()}


def beyond(found: Sequence[Departure], tolerance: mpq) -> Iterator[Departure]:
    """Those that are further than a tolerance."""
    return (departure for departure in found if departure.squared > tolerance * tolerance)
