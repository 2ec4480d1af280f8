"""Vertices, triangles and polygons in the forms in which users have them."""

from __future__ import annotations

import operator
from collections.abc import Iterable, Mapping, Sequence, Set
from decimal import Decimal
from typing import Any

import numpy as np
from gmpy2 import mpq, mpz

from bern_exact.exact.angle_bound import AngleBound, parse_angle_bound
from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import parse_rational
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.plane.array_mesh import ArrayMesh
from bern_exact.plane.mesh import Mesh, Triangle
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings


def mesh_of(vertices: Any, triangles: Any) -> Mesh | ArrayMesh:
    """A mesh from the forms in which users have one.

    Parameters
    ----------
    vertices, triangles : object
        As in `verify`; arrays of doubles stay arrays.

    Raises
    ------
    InputError
        If they are of none of these forms.

    Examples
    --------
    >>> mesh_of([(0, 0), ("1/3", 0), (0, 0.5)], [(0, 1, 2)]).coordinates[1]
    (mpq(1,3), mpq(0,1))
    """
    if triangles is None:
        vertices, triangles = _parts(vertices)
        if isinstance(vertices, Mesh):
            return vertices
    if _is_array(vertices, "f", 2) and _is_array(triangles, "iu", 3):
        _refuse_masked(vertices, "vertices")
        _refuse_masked(triangles, "triangles")
        return ArrayMesh.of_doubles(vertices, triangles)
    points = _points(vertices, "vertices")
    corners = (_triangle(item, t) for t, item in enumerate(_listed(triangles, "triangles")))
    return Mesh(tuple(points), tuple(corners))


def _is_array(value: Any, kinds: str, columns: int) -> bool:
    """Is this an array of so many columns, of doubles (or narrower) or of integers?"""
    return (
        isinstance(value, np.ndarray)
        and value.dtype.kind in kinds
        and value.dtype.itemsize <= 8
        and value.shape[1:] == (columns,)
    )


def _parts(mesh: Any) -> tuple[Any, Any]:
    """The vertices and triangles of an object that is a whole mesh."""
    inner = getattr(mesh, "mesh", mesh)  # the result of `triangulate` has one
    if isinstance(inner, Mesh):
        return inner, inner.triangles
    if hasattr(mesh, "points") and hasattr(mesh, "cells_dict"):
        return _meshio_parts(mesh)
    raise InputError("schema", "triangles are missing", {"path": "triangles"})


def _meshio_parts(mesh: Any) -> tuple[Any, Any]:
    """The vertices and triangles of a mesh of meshio, or of anything with its two names.

    Points and lines among its cells do not matter; neither does a third coordinate that is 0.
    """
    points, cells = np.asarray(mesh.points), mesh.cells_dict
    for kind in cells:
        if kind not in ("triangle", "line", "vertex"):
            message = f"cells of kind {kind!r} are not triangles"
            raise InputError("unsupported", message, {"path": f"cells[{kind!r}]"})
    if points.ndim == 2 and points.shape[1] == 3:
        raised = np.flatnonzero(points[:, 2] != 0)
        if len(raised):
            path = f"points[{int(raised[0])}]"
            raise InputError("unsupported", f"{path} is not in the plane z = 0", {"path": path})
        points = points[:, :2]
    return points, np.asarray(cells.get("triangle", np.empty((0, 3), dtype=np.int64)))


def angle_of(value: Any) -> AngleBound | None:
    """An angle bound from degrees or text, or none.

    A float is read as the decimal that it prints as.
    """
    if value is None or isinstance(value, AngleBound):
        return value
    return parse_angle_bound(value if isinstance(value, str) else str(value))


def distance_of(tolerance: Any) -> mpq | None:
    """A tolerance, or none; a float is read as the decimal that it prints as, as an angle is.

    >>> distance_of(1e-3), distance_of(None)
    (mpq(1,1000), None)
    """
    if tolerance is None:
        return None
    written = str(tolerance) if isinstance(tolerance, float | np.floating) else tolerance
    return exact(written, "tolerance")


def polygon_of(value: Polygon | Mapping[str, Any] | Iterable[Any]) -> Polygon:
    """A polygon from the forms in which users have one, validated exactly.

    Parameters
    ----------
    value : Polygon, rings or mapping
        A `Polygon`; a ring; a list of rings, the outer one first; or `{"outer": ring,
        "holes": [ring, ...]}`, with coordinates as in `verify`.

    Raises
    ------
    InputError
        If it is none of these, or not a polygon.

    Examples
    --------
    >>> polygon_of([(0, 0), ("1/3", 0), (0, 0.5)]).area
    mpq(1,12)
    """
    return value if isinstance(value, Polygon) else polygon_from_rings(_rings(value))


def exact(value: Any, place: str) -> mpq:
    """The rational that a number of any of the usual types is.

    >>> exact("1/3", "x"), exact(0.5, "x"), exact(7, "x")
    (mpq(1,3), mpq(1,2), mpq(7,1))
    """
    if isinstance(value, mpq | mpz):
        return mpq(value)
    if isinstance(value, str | Decimal):  # a decimal's exponent may be enormous
        try:
            return parse_rational(str(value))
        except InputError as error:
            raise InputError(error.kind, f"{place}: {error.message}", {"path": place}) from error
    try:
        if not isinstance(value, bool):
            if hasattr(value, "as_integer_ratio"):
                return mpq(*map(int, value.as_integer_ratio()))
            return mpq(operator.index(value))
    except (TypeError, ValueError, OverflowError):
        pass
    raise InputError("number", f"{place}: {value!r:.60} is not an exact number", {"path": place})


def whole(value: Any, place: str) -> int:
    """A number of things, of any type of integers.

    >>> whole(np.int64(7), "limit")
    7
    """
    try:
        if not isinstance(value, bool | np.bool):
            number = operator.index(value)
            if number >= 0:
                return number
    except TypeError:
        pass
    message = f"{place}: {value!r:.60} is not an integer from 0 on"
    raise InputError("number", message, {"path": place})


def _listed(value: Any, place: str) -> Sequence[Any]:
    """The items of a list, an iterator or a numpy array."""
    if hasattr(value, "tolist"):
        _refuse_masked(value, place)
        value = value.tolist()
    no_order = isinstance(value, str | bytes | Mapping | Set)
    if no_order or not isinstance(value, Iterable):
        raise InputError("schema", f"{place}: a sequence is expected", {"path": place})
    return value if isinstance(value, Sequence) else list(value)


def _refuse_masked(value: Any, place: str) -> None:
    """Refuse an array in which an entry is masked: nobody says what it is."""
    if np.ma.is_masked(value):
        raise InputError("number", f"{place}: an entry is masked", {"path": place})


def _points(value: Any, place: str) -> list[HPoint]:
    points = []
    for i, item in enumerate(_listed(value, place)):
        pair = _listed(item, f"{place}[{i}]")
        if len(pair) != 2:
            where = {"path": f"{place}[{i}]"}
            raise InputError("schema", f"{place}[{i}]: a point (x, y) is expected", where)
        x, y = (exact(part, f"{place}[{i}][{k}]") for k, part in enumerate(pair))
        points.append(hpoint(x, y))
    return points


def _triangle(item: Any, t: int) -> Triangle:
    corners = _listed(item, f"triangles[{t}]")
    try:
        if len(corners) == 3 and not any(isinstance(v, bool) for v in corners):
            a, b, c = (operator.index(v) for v in corners)
            return a, b, c
    except TypeError:
        pass
    message = f"triangles[{t}]: three vertex numbers are expected"
    raise InputError("schema", message, {"path": f"triangles[{t}]"})


def _rings(value: Mapping[str, Any] | Iterable[Any]) -> list[list[HPoint]]:
    """The rings of a polygon: `{"outer", "holes"}`, a list of rings, or one ring."""
    if isinstance(value, Mapping):
        value = [value.get("outer"), *_listed(value.get("holes", []), "holes")]
    rings = [_listed(ring, f"ring {r}") for r, ring in enumerate(_listed(value, "polygon"))]
    if rings and rings[0] and not _is_pair(rings[0][0]):
        return [_points(rings, "ring 0")]
    return [_points(ring, f"ring {r}") for r, ring in enumerate(rings)]


def _is_pair(value: Any) -> bool:
    """Is this a point rather than a coordinate?"""
    return isinstance(value, Iterable) and not isinstance(value, str)
