"""How far the boundary of a mesh departs from a polygon: rounding, told from a bug.

A mesher that computes in doubles puts a vertex on a sloped edge almost never exactly on it.  So
the boundary is followed from polygon vertex to polygon vertex, and each vertex between two of them
is held against the edge that joins them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from gmpy2 import mpq

from bern_exact.exact.enclosures import sqrt_enclosure
from bern_exact.exact.points import HPoint, coordinates
from bern_exact.exact.predicates import squared_distance_to_segment
from bern_exact.oracle.verdict import point_json
from bern_exact.plane.polygon import Polygon

MANTISSA, LEAST = 52, -1074
"""A double of size 2^e to 2^(e+1) is a multiple of 2^(e-MANTISSA), and of 2^LEAST at any rate."""


@dataclass(frozen=True)
class Departure:
    """A boundary vertex of the mesh that is not on its edge of the polygon.

    Parameters
    ----------
    vertex : int
        Of the mesh.
    point : HPoint
        Where it is.
    polygon_edge : (int, int)
        Ring and number of the edge that it belongs to.
    squared : mpq
        Its squared distance from that edge.
    """

    vertex: int
    point: HPoint
    polygon_edge: tuple[int, int]
    squared: mpq

    def to_json(self) -> dict[str, Any]:
        """The edge and the distance from it, exactly, enclosed, and in ulps."""
        unit = ulp(self.point)
        return {
            "polygon_edge": list(self.polygon_edge),
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


def departures(
    rings: Sequence[Sequence[int]], point: Callable[[int], HPoint], polygon: Polygon
) -> list[Departure] | None:
    """The boundary vertices that are not on the edge that they belong to.

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
    list of Departure, or None
        By vertex.  None if the boundary does not visit every vertex of the polygon, once each, ring
        by ring and in order: then it is not known which edge a vertex belongs to.
    """
    number = {p: v for v, p in enumerate(polygon.points)}
    found: list[Departure] = []
    visited = 0
    for ring in rings:
        points = [point(v) for v in ring]
        stops = [i for i, p in enumerate(points) if p in number]
        visited += len(stops)
        if not _is_a_ring([number[points[i]] for i in stops], polygon):
            return None
        edge = number[points[stops[-1]]]
        for v, p in zip(ring, points, strict=True):
            edge = number.get(p, edge)
            squared = _squared(p, polygon, edge)
            if squared != 0:
                found.append(Departure(v, p, polygon.edge_place(edge), squared))
    if visited != polygon.n:
        return None
    return sorted(found, key=lambda departure: (departure.vertex, departure.polygon_edge))


def _is_a_ring(visited: Sequence[int], polygon: Polygon) -> bool:
    """Are these the vertices of one of the polygon's rings, each once and in order?"""
    if not visited or len(visited) != len(polygon.rings[polygon.ring_of[visited[0]]]):
        return False
    after = [*visited[1:], visited[0]]
    return all(polygon.after[v] == w for v, w in zip(visited, after, strict=True))


def _squared(p: HPoint, polygon: Polygon, edge: int) -> mpq:
    """The squared distance of a point from an edge of the polygon."""
    return squared_distance_to_segment(p, polygon.points[edge], polygon.points[polygon.after[edge]])


def nearest(vertex: int, p: HPoint, polygon: Polygon) -> Departure:
    """The departure of a vertex from the nearest edge, where it is not known which is its own.

    Linear in the polygon's vertices.
    """
    squared, edge = min((_squared(p, polygon, edge), edge) for edge in range(polygon.n))
    return Departure(vertex, p, polygon.edge_place(edge), squared)


def furthest(found: Sequence[Departure]) -> dict[str, Any]:
    """How many vertices depart from their edges, and the one that does by most."""
    worst = max(found, key=lambda departure: departure.squared)
    record = {"vertices": len({departure.vertex for departure in found}), "vertex": worst.vertex}
    return {**record, "point": point_json(worst.point), **worst.to_json()}


def beyond(found: Sequence[Departure], tolerance: mpq) -> Iterator[Departure]:
    """Those that are further from their edges than a tolerance."""
    return (departure for departure in found if departure.squared > tolerance * tolerance)
