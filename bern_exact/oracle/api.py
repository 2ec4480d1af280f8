"""`verify`: the judge for vertices and triangles as users have them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from gmpy2 import mpq

from bern_exact.exact.angle_bound import AngleBound
from bern_exact.exact.errors import InputError
from bern_exact.oracle.arguments import angle_of, distance_of, exact, mesh_of, polygon_of, whole
from bern_exact.oracle.fast import verify_mesh
from bern_exact.oracle.filtered import verify_arrays
from bern_exact.oracle.tolerance import with_departures
from bern_exact.oracle.verdict import Verdict
from bern_exact.plane.array_mesh import ArrayMesh
from bern_exact.plane.feature_size import feature_size
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon

MANY = 300
"""So many triangles are judged by the filtered judge, which takes 2 ms to get going."""


def verify(
    vertices: Any,
    triangles: Iterable[Any] | None = None,
    polygon: Polygon | Mapping[str, Any] | Iterable[Any] | None = None,
    *,
    max_angle: AngleBound | str | int | float | Fraction | None = None,
    min_height_squared: Any = None,
    max_triangles: int | None = None,
    tolerance: Any = None,
    limit: int = 100,
) -> Verdict:
    """Is this a triangulation of the polygon, within these bounds?  Decided exactly.

    Parameters
    ----------
    vertices : iterable of (x, y), or a mesh
        Coordinates: int, Fraction, mpq, text as in files (`"1/3"`, `"0.1"`: the exact decimal), or
        float (exactly the double that it is).  A numpy array of shape (V, 2) will do.  A whole
        mesh, without `triangles`: a `Mesh`, a `Result`, or a mesh of meshio.
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
    tolerance : number, optional
        Accept boundary vertices that are at most so far from their edges of the polygon; every
        other test stays exact.  A float is read as the decimal that it prints as.  The verdict is
        then true if `within_tolerance` is.
    limit : int
        How many defects are listed.

    Returns
    -------
    Verdict
        True if there is no defect (with `tolerance`: none but the ones that it allows).

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
    return verdict_on(
        mesh_of(vertices, triangles),
        None if polygon is None else polygon_of(polygon),
        max_angle=angle_of(max_angle),
        min_height_squared=_exact_or_none(min_height_squared, "min_height_squared"),
        max_triangles=None if max_triangles is None else whole(max_triangles, "max_triangles"),
        tolerance=distance_of(tolerance),
        limit=whole(limit, "limit"),
    )


def _exact_or_none(value: Any, place: str) -> mpq | None:
    return None if value is None else exact(value, place)


def verdict_on(
    mesh: Mesh | ArrayMesh,
    polygon: Polygon | None,
    *,
    max_angle: AngleBound | None = None,
    min_height_squared: mpq | None = None,
    max_triangles: int | None = None,
    tolerance: mpq | None = None,
    limit: int = 100,
) -> Verdict:
    """The judge's verdict, and with a polygon what can be held against it.

    Parameters are those of `verify`, in their exact forms.

    Raises
    ------
    InputError
        Kind `number`: a negative tolerance; `schema`: a tolerance without a polygon.
    """
    if tolerance is not None and polygon is None:
        raise InputError("schema", "a tolerance is a distance from a polygon's edges: give one")
    if tolerance is not None and tolerance < 0:
        raise InputError("number", f"the tolerance {tolerance} is negative")

    form = _form_of(mesh)  # made once, though a tolerance asks the judge twice

    def judge(polygon: Polygon | None) -> Verdict:
        return _judge(
            form,
            polygon,
            max_angle=max_angle,
            min_height_squared=min_height_squared,
            max_triangles=max_triangles,
            limit=limit,
        )

    verdict = judge(polygon)
    if polygon is None:
        return verdict
    if not verdict.valid:
        verdict = with_departures(verdict, form, polygon, judge, tolerance, limit)
    elif tolerance is not None:
        verdict = replace(verdict, within_tolerance=True)
    return replace(
        verdict,
        tolerance=tolerance,
        feature_size_squared=feature_size(polygon).squared,
        polygon_vertices=polygon.n,
    )


def _form_of(mesh: Mesh | ArrayMesh) -> Mesh | ArrayMesh:
    """The mesh in the form of the judge that is faster; both judges say the same."""
    if len(mesh.triangles) < MANY:
        return mesh if isinstance(mesh, Mesh) else mesh.mesh
    return mesh if isinstance(mesh, ArrayMesh) else ArrayMesh.of_mesh(mesh)


def _judge(form: Mesh | ArrayMesh, polygon: Polygon | None, **bounds: Any) -> Verdict:
    """The verdict of the judge for a mesh of this form."""
    if isinstance(form, Mesh):
        return verify_mesh(form, polygon, **bounds)
    return verify_arrays(form, polygon, **bounds)
