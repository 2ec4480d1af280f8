"""A case in other people's formats: polygons as .poly, WKT, GeoJSON, meshes as .node and .ele."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from bern_exact.corpus.files import File
from bern_exact.exact.errors import InputError
from bern_exact.formats import geojson, triangle_mesh, triangle_poly, wkt
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon

_POLYGONS: Mapping[str, Callable[[Polygon], tuple[str, int]]] = {
    "polygon.poly": triangle_poly.dumps_polygon,
    "polygon.wkt": wkt.dumps_polygon,
    "polygon.geojson": geojson.dumps_polygon,
}


def foreign_polygons(polygon: Polygon) -> Iterator[File]:
    """The polygon in every format that can hold it, be it rounded."""
    for path, dumps in _POLYGONS.items():
        try:
            yield File(path, *dumps(polygon))
        except InputError:  # a coordinate beyond all doubles: there is no such file
            continue


def foreign_mesh(name: str, mesh: Mesh) -> Iterator[File]:
    """A mesh as .node and .ele, if doubles reach so far."""
    try:
        nodes, elements, rounded = triangle_mesh.dumps_mesh(mesh)
    except InputError:
        return
    yield File(f"{name}.node", nodes, rounded)
    yield File(f"{name}.ele", elements)
