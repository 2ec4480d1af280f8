"""Meshes that are valid but for rounding: what is off, by how much, and whether that is allowed."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from gmpy2 import mpq

from bern_exact.exact.points import HPoint
from bern_exact.oracle.boundary_rings import boundary_rings
from bern_exact.oracle.departures import (
    Departure,
    Followed,
    Point,
    beyond,
    followed,
    furthest,
    nearest_edge,
)
from bern_exact.oracle.verdict import Defect, Verdict, point_json
from bern_exact.plane.array_mesh import ArrayMesh, Indices, index_array
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon


def with_departures(
    verdict: Verdict,
    mesh: Mesh | ArrayMesh,
    polygon: Polygon,
    judge: Callable[[None], Verdict],
    tolerance: mpq | None,
    limit: int,
) -> Verdict:
    """The verdict on a mesh that is not valid, with the distances of what is not where it belongs.

    Within a tolerance is a mesh that is a triangulation of what its own boundary encloses, and
    keeps the bounds, all shown exactly, if that boundary passes the polygon's vertices in order
    and its edges, each no further away than that.

    Parameters
    ----------
    verdict : Verdict
        Of a judge, exact.
    mesh : Mesh or ArrayMesh
        What was judged.
    polygon : Polygon
        What it should triangulate.
    judge : callable
        Judges the same mesh without a polygon.
    tolerance : mpq or None
        The distance that is allowed, if that was asked.
    limit : int
        How many defects are listed.
    """
    point, rings = _points_of(mesh), boundary_rings(*_indices_of(mesh))
    along = None if rings is None else followed(rings, point, polygon)
    if along is not None and along.departures:
        verdict = replace(verdict, off_edge=furthest(along.departures))
    if tolerance is None or along is None or along.gaps:
        within = None if tolerance is None else False
        explained = tuple(_explained(verdict.defects, along or UNKNOWN, point, polygon))
        # Where the limit cut off all but corners of gaps, these are better than nothing.
        return replace(verdict, defects=explained or verdict.defects, within_tolerance=within)
    alone = judge(None)
    allowed = next(beyond(along.departures, tolerance), None) is None
    listed = (*(_defect(each, polygon) for each in along.departures[:limit]), *alone.defects)
    return replace(verdict, defects=listed[:limit], within_tolerance=alone.valid and allowed)


UNKNOWN = Followed((), frozenset())
"""Of a boundary that cannot be followed nothing is known."""


def _explained(
    defects: Sequence[Defect], along: Followed, point: Point, polygon: Polygon
) -> Iterator[Defect]:
    """The defects, with the distance of what is not where it belongs, where that is known.

    The corners of gaps and overlaps within the mesh are off all edges, and should be: these gaps
    and overlaps are listed, their corners are not.
    """
    by_vertex = {each.vertex: each for each in along.departures}
    by_place = {
        tuple(each.where["polygon_vertex"]): each for each in along.departures if each.is_vertex
    }
    for defect in defects:
        if defect.kind == "boundary-vertex-off-edge":
            v = defect.where["vertex"]
            if v not in along.gaps:
                yield _off_edge(by_vertex.get(v) or nearest_edge(v, point(v), polygon))
        elif defect.kind == "polygon-vertex-missing":
            departure = by_place.get(tuple(defect.where["polygon_vertex"]))
            yield defect if departure is None else _missing(departure, polygon)
        else:
            yield defect


def _defect(departure: Departure, polygon: Polygon) -> Defect:
    """The one defect that a departure is."""
    return _missing(departure, polygon) if departure.is_vertex else _off_edge(departure)


def _off_edge(departure: Departure) -> Defect:
    """The defect of a boundary vertex that is off its edge."""
    witness = {"point": point_json(departure.point), **departure.to_json()}
    return Defect.of("boundary-vertex-off-edge", {"vertex": departure.vertex}, witness)


def _missing(departure: Departure, polygon: Polygon) -> Defect:
    """The defect of a polygon's vertex that the mesh has near by, but not there."""
    ring, number = departure.where["polygon_vertex"]
    witness = {
        "point": point_json(polygon.input_ring(ring)[number]),
        "nearest": departure.vertex,
        "nearest_point": point_json(departure.point),
        **departure.to_json(),
    }
    return Defect.of("polygon-vertex-missing", {"polygon_vertex": [ring, number]}, witness)


def _points_of(mesh: Mesh | ArrayMesh) -> Callable[[int], HPoint]:
    """The point of a vertex, exactly."""
    return mesh.points.point if isinstance(mesh, ArrayMesh) else mesh.vertices.__getitem__


def _indices_of(mesh: Mesh | ArrayMesh) -> tuple[Indices, int]:
    """The triangles as an array, and the number of vertices."""
    if isinstance(mesh, ArrayMesh):
        return mesh.triangles, len(mesh.points)
    return index_array(mesh.triangles), len(mesh.vertices)
