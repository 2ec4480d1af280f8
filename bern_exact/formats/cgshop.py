"""CG:SHOP 2025, "Minimum Non-Obtuse Triangulation": instances in and out, solutions out, as JSON.

An instance has integer points, `region_boundary` (their indices round a simple polygon,
counter-clockwise) and perhaps further constraints; a solution its Steiner points, rationals, and
the edges of a triangulation.  Only instances that are a polygon and nothing else are read: every
point on the boundary, no further constraints.

Names of fields and what they must hold are those of the contest's verifier, the PyPI package
`cgshop2025-pyutils`.  It reads integers of instances as 64-bit numbers, and rounds longer ones.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from gmpy2 import lcm, mpq, mpz

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import (
    JSON_INT_DIGITS,
    format_rational,
    json_kind,
    rational_from_json,
)
from bern_exact.exact.points import HPoint, coordinates, grid_point, hpoint
from bern_exact.formats import fields, safe_json
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings

INSTANCE = "CG_SHOP_2025_Instance"
SOLUTION = "CG_SHOP_2025_Solution"

VERIFIER_BITS = 63
"""The most bits, besides the sign, of a coordinate that the contest's verifier reads exactly."""


@dataclass(frozen=True)
class Instance:
    """An instance whose points are the vertices of a simple polygon.

    Parameters
    ----------
    uid : str
        Its name.
    points : tuple of HPoint
        In the instance's order, integers.
    boundary : tuple of int
        `region_boundary`.
    scale : mpz
        What a polygon's coordinates were multiplied by to become these integers.
    made : bool
        Whether it was made of a polygon and is not in a file yet.
    """

    uid: str
    points: tuple[HPoint, ...]
    boundary: tuple[int, ...]
    scale: mpz = mpz(1)
    made: bool = False

    @property
    def bits(self) -> int:
        """The most bits that a coordinate has, without its sign."""
        return max(max(abs(x), abs(y)).bit_length() for x, y, _ in self.points)

    @property
    def polygon(self) -> Polygon:
        """The polygon, its vertices in the order of the boundary, named as the instance.

        Raises
        ------
        InputError
            If the boundary is no simple polygon; the kinds of `polygon_from_rings`.
        """
        return polygon_from_rings([[self.points[i] for i in self.boundary]], self.uid)


def is_instance(document: Any) -> bool:
    """Is this JSON document meant to be an instance, sound or not?

    >>> is_instance({"instance_uid": "a", "region_boundary": []}), is_instance({"outer": []})
    (True, False)
    """
    return isinstance(document, dict) and (
        document.get("content_type") == INSTANCE
        or ("region_boundary" in document and "outer" not in document)
    )


def load_instance(source: safe_json.Source) -> Instance:
    """The instance in a JSON file or stream.

    Raises
    ------
    InputError
        The text is not JSON, or the document is refused by `read_instance`.
    OSError
        The file cannot be read.
    """
    return read_instance(safe_json.load(source))


def read_instance(document: Any) -> Instance:
    """The instance of a JSON document.

    Members other than the format's are ignored; `content_type` and an empty
    `additional_constraints` may be missing.

    Raises
    ------
    InputError
        Kind `schema` or `number`, with the path.  Kind `unsupported`, with the path: another
        `content_type`; constraints besides the boundary; points that are not on it.

    Examples
    --------
    >>> read_instance({"instance_uid": "t", "num_points": 3, "points_x": [0, 0, 4],
    ...                "points_y": [0, 3, 0], "region_boundary": [0, 2, 1]}).polygon.area
    mpq(6,1)
    """
    document = fields.as_object(document, "$")
    kind = document.get("content_type", INSTANCE)
    if kind != INSTANCE:
        raise fields.refuse("unsupported", f"{INSTANCE} is expected", "$.content_type")
    uid = fields.as_name(fields.member(document, "instance_uid", "$"), "$.instance_uid")
    xs, ys = (_integers(document, name) for name in ("points_x", "points_y"))
    count = _whole(fields.member(document, "num_points", "$"), "$.num_points")
    for name, values in (("points_x", xs), ("points_y", ys)):
        if len(values) != count:
            message = f"{count} numbers are expected, as num_points says, not {len(values)}"
            raise fields.refuse("schema", message, f"$.{name}")
    boundary = _boundary(document, len(xs))
    _refuse_constraints(document)
    stray = set(range(len(xs))) - set(boundary)
    if stray:
        message = f"point {min(stray)} is not on region_boundary: only polygons are read"
        raise fields.refuse("unsupported", message, f"$.points_x[{min(stray)}]")
    points = tuple(hpoint(x, y) for x, y in zip(xs, ys, strict=True))
    return Instance(uid, points, boundary)


def _integers(document: dict[str, Any], name: str) -> list[mpq]:
    """An array of integers of any length."""
    path = f"$.{name}"
    values = fields.as_list(fields.member(document, name, "$"), path)
    numbers = []
    for i, value in enumerate(values):
        number = rational_from_json(value, f"{path}[{i}]")
        if number.denominator != 1:
            raise fields.refuse("number", "instances have integer coordinates", f"{path}[{i}]")
        numbers.append(number)
    return numbers


def _whole(value: Any, path: str) -> int:
    """A short integer."""
    if type(value) is not int:
        raise fields.refuse("schema", f"an integer is expected, not {json_kind(value)}", path)
    return value


def _boundary(document: dict[str, Any], count: int) -> tuple[int, ...]:
    """`region_boundary`, its indices in range."""
    path = "$.region_boundary"
    indices = []
    for k, value in enumerate(fields.as_list(fields.member(document, path[2:], "$"), path)):
        index = _whole(value, f"{path}[{k}]")
        if not 0 <= index < count:
            raise fields.refuse("schema", f"there is no point {index}", f"{path}[{k}]")
        indices.append(index)
    return tuple(indices)


def _refuse_constraints(document: dict[str, Any]) -> None:
    """Refuse constraints besides the boundary, by the field's name."""
    path = "$.additional_constraints"
    constraints = fields.as_list(document.get(path[2:], []), path)
    said = _whole(document.get("num_constraints", len(constraints)), "$.num_constraints")
    if constraints or said:
        message = f"additional_constraints are not read, and there are {len(constraints) or said}"
        raise fields.refuse("unsupported", message, path if constraints else "$.num_constraints")


def instance_of(polygon: Polygon, uid: str = "") -> Instance:
    """The instance that is this polygon, scaled to integers by the least common denominator.

    Parameters
    ----------
    polygon : Polygon
        Without holes.
    uid : str
        The instance's name, if the polygon has none.

    Raises
    ------
    InputError
        Kind `has-holes`: the format has no place for holes.  Kind `number`: the integers would
        have more digits than readers of JSON can be expected to take.

    Examples
    --------
    >>> from bern_exact.oracle.arguments import polygon_of
    >>> instance = instance_of(polygon_of([(0, 0), ("1/2", 0), (0, "1/3")]), "third")
    >>> instance.scale, instance.points[1], instance.boundary
    (mpz(6), (mpz(3), mpz(0), mpz(1)), (0, 1, 2))
    """
    if polygon.holes:
        message = "CG:SHOP 2025 has no polygons with holes: a region has one boundary"
        raise InputError("has-holes", message, {"ring": 1})
    pairs = [coordinates(p) for p in polygon.points]
    scale = mpz(1)
    for pair in pairs:
        for value in pair:
            scale = lcm(scale, value.denominator)
    points = tuple(grid_point(int(x * scale), int(y * scale)) for x, y in pairs)
    made = Instance(polygon.name or uid, points, polygon.rings[0], scale, made=True)
    if made.bits > 3 * JSON_INT_DIGITS:
        message = f"scaled to integers the polygon's coordinates would have {made.bits:,} bits"
        raise InputError("number", message)
    return made


def instance_document(instance: Instance) -> dict[str, Any]:
    """The document of an instance."""
    return {
        "content_type": INSTANCE,
        "instance_uid": instance.uid,
        "num_points": len(instance.points),
        "points_x": [int(x) for x, _, _ in instance.points],
        "points_y": [int(y) for _, y, _ in instance.points],
        "region_boundary": list(instance.boundary),
        "num_constraints": 0,
        "additional_constraints": [],
    }


def solution_document(mesh: Mesh, instance: Instance) -> dict[str, Any]:
    """The document of a mesh as a solution of an instance.

    The instance's points keep their numbers, whatever their order in the mesh; the others follow as
    Steiner points in the mesh's order.  Their coordinates are strings, integers too: the verifier
    rounds long JSON integers.

    Parameters
    ----------
    mesh : Mesh
        In the coordinates of the polygon that the instance was made of.
    instance : Instance
        Its polygon's vertices must be vertices of the mesh.

    Raises
    ------
    InputError
        Kind `schema`: the mesh lacks a point of the instance.

    Notes
    -----
    O(m log m) for m triangles; each edge once, (less, greater), sorted.
    """
    number = {point: i for i, point in enumerate(instance.points)}
    known = len(number)
    vertices = [_scaled(point, instance.scale) for point in mesh.vertices]
    numbers = [number.setdefault(point, len(number)) for point in vertices]
    missing = set(range(known)) - set(numbers)
    if missing:
        message = f"the mesh has no vertex at point {min(missing)} of the instance"
        raise InputError("schema", message, {"point": min(missing)})
    steiner = list(number)[known:]
    return {
        "content_type": SOLUTION,
        "instance_uid": instance.uid,
        "steiner_points_x": [format_rational(mpq(x, w)) for x, _, w in steiner],
        "steiner_points_y": [format_rational(mpq(y, w)) for _, y, w in steiner],
        "edges": [list(edge) for edge in _edges(mesh, numbers)],
    }


def _scaled(point: HPoint, scale: mpz) -> HPoint:
    """The point with its coordinates multiplied."""
    if scale == 1:
        return point
    x, y = coordinates(point)
    return hpoint(x * scale, y * scale)


def _edges(mesh: Mesh, numbers: Sequence[int]) -> list[tuple[int, int]]:
    """The edges of a mesh by its vertices' numbers, sorted."""
    edges = set()
    for triangle in mesh.triangles:
        a, b, c = sorted(numbers[v] for v in triangle)
        edges |= {(a, b), (a, c), (b, c)}
    return sorted(edges)
