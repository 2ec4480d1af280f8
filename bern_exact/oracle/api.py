"""`verify`: the judge for vertices and triangles as users have them."""

from __future__ import annotations

import operator
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from gmpy2 import mpq, mpz

from bern_exact.exact.angle_bound import AngleBound, parse_angle_bound
from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import parse_rational
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.oracle.fast import verify_mesh
from bern_exact.oracle.verdict import Verdict
from bern_exact.plane.feature_size import feature_size
from bern_exact.plane.mesh import Mesh, Triangle
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings


def verify(
    vertices: Iterable[Any],
    triangles: Iterable[Any],
    polygon: Polygon | Mapping[str, Any] | Iterable[Any] | None = None,
    *,
    max_angle: AngleBound | str | int | float | Fraction | None = None,
    min_height_squared: Any = None,
    max_triangles: int | None = None,
    limit: int = 100,
) -> Verdict:
    """Is this a triangulation of the polygon, within these bounds?  Decided exactly.

    Parameters
    ----------
    vertices : iterable of (x, y)
        Coordinates: int, Fraction, mpq, text as in files (`"1/3"`, `"0.1"`: the exact decimal), or
        float (exactly the double that it is).  A numpy array of shape (V, 2) will do.
    triangles : iterable of (int, int, int)
        0-based and counter-clockwise.  A numpy array of shape (T, 3) will do.
    polygon : Polygon, rings or mapping, optional
        What the mesh should triangulate: a `Polygon`; a ring; a list of rings, the outer one
        first; or `{"outer": ring, "holes": [ring, ...]}`.  Without it, whatever the mesh's
        boundary encloses.
    max_angle : optional
        Degrees (`150`, `"149.5"`; a float is read as the decimal that it prints as) or
        `"cos:S:p/q"`; no angle may be larger.
    min_height_squared : number, optional
        No triangle's squared height may be smaller.
    max_triangles : int, optional
        There may be no more triangles.
    limit : int
        How many defects are listed.

    Returns
    -------
    Verdict
        True if there is no defect.

    Raises
    ------
    InputError
        If the arguments are not of these forms, or the polygon is not one.  Whatever is wrong
        with the mesh itself is a defect.

    Notes
    -----
    O(m log m) for m triangles, see `verify_mesh`, and a polygon's feature size, see `feature_size`.

    Examples
    --------
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> bool(verify(square, [(0, 1, 2), (0, 2, 3)], square, max_angle=90))
    True
    >>> verify(square, [(0, 1, 2)], square).defects[1].kind
    'region-not-covered'
    """
    points = _points(vertices, "vertices")
    corners = tuple(_triangle(item, t) for t, item in enumerate(_listed(triangles, "triangles")))
    if polygon is not None:
        polygon = polygon_of(polygon)
    bound = max_angle
    if bound is not None and not isinstance(bound, AngleBound):
        bound = parse_angle_bound(bound if isinstance(bound, str) else str(bound))
    height = min_height_squared
    return verify_with_feature_size(
        Mesh(tuple(points), corners),
        polygon,
        max_angle=bound,
        min_height_squared=None if height is None else exact(height, "min_height_squared"),
        max_triangles=max_triangles,
        limit=limit,
    )


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


def verify_with_feature_size(
    mesh: Mesh,
    polygon: Polygon | None,
    *,
    max_angle: AngleBound | None = None,
    min_height_squared: mpq | None = None,
    max_triangles: int | None = None,
    limit: int = 100,
) -> Verdict:
    """`verify_mesh`, and the polygon's feature size, which the least height can be held against."""
    verdict = verify_mesh(
        mesh,
        polygon,
        max_angle=max_angle,
        min_height_squared=min_height_squared,
        max_triangles=max_triangles,
        limit=limit,
    )
    if polygon is None:
        return verdict
    return replace(verdict, feature_size_squared=feature_size(polygon).squared)


def exact(value: Any, place: str) -> mpq:
    """The rational that a number of any of the usual types is.

    >>> exact("1/3", "x"), exact(0.5, "x"), exact(Fraction(1, 7), "x")
    (mpq(1,3), mpq(1,2), mpq(1,7))
    """
    if isinstance(value, mpq | mpz):
        return mpq(value)
    if isinstance(value, str):
        try:
            return parse_rational(value)
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


def _listed(value: Any, place: str) -> Sequence[Any]:
    """The items of a list, an iterator or a numpy array."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, str | bytes | Mapping) or not isinstance(value, Iterable):
        raise InputError("schema", f"{place}: a sequence is expected", {"path": place})
    return value if isinstance(value, Sequence) else list(value)


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
