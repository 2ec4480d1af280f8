"""`bern-exact/mesh`, version 1: triangle meshes, their polygon and their certificate as JSON."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import chain
from typing import Any

import numpy as np

from bern_exact.exact.numbers import JsonNumber, json_kind, rational_from_json
from bern_exact.formats import fields, safe_json
from bern_exact.formats.polygon_json import dump_polygon, point_texts, read_polygon
from bern_exact.plane.array_mesh import ArrayMesh, Indices, Points
from bern_exact.plane.mesh import Mesh, Triangle
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.text_points import points_of_numbers

FORMAT = "bern-exact/mesh"


def load_mesh(source: safe_json.Source, *, binary64: bool = False) -> tuple[Mesh, Polygon | None]:
    """The mesh in a JSON file or stream, and its polygon if it has one.

    Raises
    ------
    InputError
        The text is not JSON, or the document is refused by `read_mesh`.
    OSError
        The file cannot be read.
    """
    return read_mesh(safe_json.load(source), binary64=binary64)


def read_mesh(document: Any, *, binary64: bool = False) -> tuple[Mesh, Polygon | None]:
    """The mesh of a JSON document, and its polygon if it has one.

    The mesh is not judged: an index may be out of range, a triangle clockwise or degenerate.

    Parameters
    ----------
    document : object
        A `bern-exact/mesh`, or a bare object with `vertices` and `triangles`.  Members other
        than these and `polygon` are ignored.
    binary64 : bool
        Read each decimal as the double nearest to it, in the polygon too.

    Raises
    ------
    InputError
        Kind `schema`, `unsupported` or `number`, with the path; for the polygon as `read_polygon`.
    """
    document = fields.as_object(document, "$")
    fields.check_format(document, FORMAT, "$")
    points = fields.as_points(
        fields.member(document, "vertices", "$"), "$.vertices", binary64=binary64
    )
    triangles = fields.as_list(fields.member(document, "triangles", "$"), "$.triangles")
    mesh = Mesh(tuple(points), tuple(_triangle(t, i) for i, t in enumerate(triangles)))
    polygon = document.get("polygon")
    if polygon is None:
        return mesh, None
    return mesh, read_polygon(polygon, binary64=binary64, path="$.polygon")


def load_array_mesh(
    source: safe_json.Source, *, binary64: bool = False
) -> tuple[ArrayMesh, Polygon | None]:
    """`load_mesh`, into arrays: for a million triangles."""
    return read_array_mesh(safe_json.load(source), binary64=binary64)


def read_array_mesh(document: Any, *, binary64: bool = False) -> tuple[ArrayMesh, Polygon | None]:
    """The mesh of a JSON document in arrays, and its polygon if it has one.

    Parameters, refusals and what is read are those of `read_mesh`.

    Notes
    -----
    Linear; vertices and triangles are looked at all at once, and one by one only where something
    is unusual, or to be refused.
    """
    document = fields.as_object(document, "$")
    fields.check_format(document, FORMAT, "$")
    points = _points_at_once(document.get("vertices"), binary64=binary64)
    triangles = _triangles_at_once(document.get("triangles"))
    if points is None or triangles is None:
        mesh, polygon = read_mesh(document, binary64=binary64)
        return ArrayMesh.of_mesh(mesh), polygon
    polygon = document.get("polygon")
    if polygon is None:
        return ArrayMesh(points, triangles), None
    polygon = read_polygon(polygon, binary64=binary64, path="$.polygon")
    return ArrayMesh(points, triangles), polygon


def _points_at_once(value: Any, *, binary64: bool) -> Points | None:
    """The points of an array of `[x, y]`; None if it is better read one by one."""
    if not _are_rows(value, 2):
        return None
    return points_of_numbers(list(chain.from_iterable(value)), binary64=binary64)


def _triangles_at_once(value: Any) -> Indices | None:
    """The triangles of an array of three integers each; None if it is better read one by one."""
    if not _are_rows(value, 3):
        return None
    flat = list(chain.from_iterable(value))
    if not set(map(type, flat)) <= {int}:
        return None
    try:
        return np.fromiter(flat, dtype=np.int64, count=len(flat)).reshape(-1, 3)
    except OverflowError:
        return None


def _are_rows(value: Any, length: int) -> bool:
    """Is this an array of arrays of this length?"""
    return (
        isinstance(value, list)
        and set(map(type, value)) <= {list}
        and set(map(len, value)) <= {length}
    )


def _triangle(value: Any, number: int) -> Triangle:
    """A triangle: three integers, whatever they are."""
    if isinstance(value, list | tuple) and len(value) == 3:
        a, b, c = value
        if type(a) is int and type(b) is int and type(c) is int:
            return a, b, c
    path = f"$.triangles[{number}]"
    indices = fields.as_list(value, path)
    if len(indices) != 3:
        raise fields.refuse("schema", f"a triangle has 3 indices, not {len(indices)}", path)
    a, b, c = (_index(index, f"{path}[{k}]") for k, index in enumerate(indices))
    return a, b, c


def _index(value: Any, path: str) -> int:
    """An index, however long: a judge says that there is no such vertex."""
    if type(value) is int:
        return value
    if not isinstance(value, JsonNumber):
        raise fields.refuse("schema", f"an integer is expected, not {json_kind(value)}", path)
    if not value.removeprefix("-").isdigit():
        raise fields.refuse("number", "the number is not an index", path)
    return int(rational_from_json(value, path).numerator)


def mesh_document(
    mesh: Mesh, polygon: Polygon | None = None, certificate: Mapping[str, Any] | None = None
) -> dict[str, Any]:
    """The document of a mesh, without `polygon` or `certificate` if there is none."""
    document: dict[str, Any] = {
        "format": FORMAT,
        "version": 1,
        "vertices": point_texts(mesh.vertices),
        "triangles": [list(triangle) for triangle in mesh.triangles],
    }
    if polygon is not None:
        document["polygon"] = dump_polygon(polygon)
    if certificate is not None:
        document["certificate"] = dict(certificate)
    return document


def dumps_mesh(
    mesh: Mesh, polygon: Polygon | None = None, certificate: Mapping[str, Any] | None = None
) -> str:
    """The text of a mesh's document, the same bytes always; one vertex and one triangle a line."""
    return safe_json.dumps(mesh_document(mesh, polygon, certificate))
