"""Meshes that are valid but for rounding: what is off, by how much, and whether that is allowed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from gmpy2 import mpq

from bern_exact.exact.points import HPoint
from bern_exact.oracle.boundary_rings import boundary_rings
from bern_exact.oracle.departures import (
    Departure,
    Point,
    beyond,
    departures,
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
    found, point = None, _points_of(mesh)
    rings = boundary_rings(*_indices_of(mesh))
    if rings is not None:
        found = departures(rings, point, polygon)
    if found:
        verdict = replace(verdict, off_edge=furthest(found))
    if tolerance is not None and found is not None:
        alone = judge(None)
        within = alone.valid and next(beyond(found, tolerance), None) is None
        listed = (*(_defect(each, polygon) for each in found[:limit]), *alone.defects)
        return replace(verdict, defects=listed[:limit], within_tolerance=within)
    defects = tuple(_explained(verdict.defects, found or (), point, polygon))
    return replace(verdict, defects=defects, within_tolerance=None if tolerance is None else False)


def _explained(
    defects: Sequence[Defect], found: Sequence[Departure], point: Point, polygon: Polygon
) -> list[Defect]:
    """The defects, with the distance of what is not where it belongs, where that is known."""
    by_vertex = {each.vertex: each for each in found}
    by_place = {tuple(each.where["polygon_vertex"]): each for each in found if each.is_vertex}
    explained = []
    for defect in defects:
        if defect.kind == "boundary-vertex-off-edge":
            v = defect.where["vertex"]
            defect = _off_edge(by_vertex.get(v) or nearest_edge(v, point(v), polygon))
        elif defect.kind == "polygon-vertex-missing":
            departure = by_place.get(tuple(defect.where["polygon_vertex"]))
            defect = defect if departure is None else _missing(departure, polygon)
        explained.append(defect)
    return explained


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
