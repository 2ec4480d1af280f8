"""Solutions of CG:SHOP 2025 as meshes: the faces of their edges, recovered exactly.

A solution has edges and no triangles.  As in the contest's own verifier the edges of the
instance's boundary are there whether listed or not, and an edge through a vertex is two edges.
Faces of three sides become triangles; others are left out, and the judge finds them missing.  What
no face shows is kept as a triangle that no judge accepts: an edge ab that bounds no triangle, or
has no vertex at an end, as the triangle abb; two edges that cross as two triangles on them, which
overlap.  A judge then accepts the mesh if and only if the edges are those of a triangulation.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import JsonNumber, rational_from_json, shown
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.exact.predicates import orientation
from bern_exact.formats import fields, safe_json
from bern_exact.formats.cgshop import SOLUTION, Instance, is_instance, read_instance
from bern_exact.plane.edge_faces import Edge, faces_of_edges
from bern_exact.plane.mesh import Mesh, Triangle
from bern_exact.plane.polygon import Polygon


def is_solution(document: Any) -> bool:
    """Is this JSON document meant to be a solution, sound or not?

    >>> is_solution({"steiner_points_x": []}), is_solution({"vertices": [], "triangles": []})
    (True, False)
    """
    return isinstance(document, dict) and (
        document.get("content_type") == SOLUTION
        or ("steiner_points_x" in document and "triangles" not in document)
    )


def load_mesh(
    source: Path, /, *, binary64: bool, polygon: Path | None
) -> tuple[Mesh, Polygon | None]:
    """The mesh of a solution, and the polygon of its instance.

    Parameters
    ----------
    source : Path
        The solution.
    binary64 : bool
        Read each decimal as the double nearest to it, then exactly.
    polygon : Path, optional
        The instance.  Otherwise it is looked for beside the solution `NAME.solution.json`, as
        `NAME.instance.json` and by the name that the solution says.

    Raises
    ------
    InputError
        Kind `schema`: the instance is not there, or is another; else as `read_mesh`.
    OSError
        A file cannot be read.
    """
    return read_solution(safe_json.load(source), source, binary64=binary64, polygon=polygon)


def read_solution(
    document: Any, source: Path, *, binary64: bool, polygon: Path | None
) -> tuple[Mesh, Polygon | None]:
    """The mesh of a solution's document, whose file tells where the instance may be.

    Raises
    ------
    InputError
        As `load_mesh`.
    """
    document = fields.as_object(document, "$")
    if document.get("content_type", SOLUTION) != SOLUTION:
        raise fields.refuse("unsupported", f"{SOLUTION} is expected", "$.content_type")
    uid = fields.as_name(fields.member(document, "instance_uid", "$"), "$.instance_uid")
    instance = _instance(source, polygon, uid)
    return read_mesh(document, instance, binary64=binary64), instance.polygon


def _instance(source: Path, polygon: Path | None, uid: str) -> Instance:
    """The instance that a solution solves."""
    stem = source.name.removesuffix(".json").removesuffix(".solution")
    names = [f"{stem}.instance.json"]
    if uid and Path(uid).name == uid and "\0" not in uid:
        names += [f"{uid}.instance.json", f"{uid}.json"]
    beside = [source.with_name(name) for name in names]
    for path in (*([polygon] if polygon else []), *beside):
        if path.suffix.lower() != ".json" or not path.is_file():
            continue
        document = safe_json.load(path)
        if is_instance(document):
            instance = read_instance(document)
            if instance.uid != uid:
                message = f"the solution is of instance {shown(uid)}, not of {shown(instance.uid)}"
                raise fields.refuse("schema", message, "$.instance_uid")
            return instance
    message = (
        "a CG:SHOP solution has points only in its instance: name its file by --polygon, or put it "
        f"beside the solution as {names[0]}"
    )
    raise InputError("schema", message, {"file": names[0]})


def read_mesh(document: dict[str, Any], instance: Instance, *, binary64: bool) -> Mesh:
    """The mesh of a solution: the instance's points, then the Steiner points.

    Raises
    ------
    InputError
        Kind `schema` or `number`, with the path.  What is wrong with the edges is for a judge.

    Notes
    -----
    O(m log m) comparisons for m edges.
    """
    xs, ys = (_numbers(document, f"steiner_points_{axis}", binary64) for axis in "xy")
    if len(xs) != len(ys):
        message = f"{len(xs)} numbers are expected, as in steiner_points_x, not {len(ys)}"
        raise fields.refuse("schema", message, "$.steiner_points_y")
    points = (*instance.points, *(hpoint(x, y) for x, y in zip(xs, ys, strict=True)))
    edges = [
        _edge(item, f"$.edges[{i}]")
        for i, item in enumerate(fields.as_list(fields.member(document, "edges", "$"), "$.edges"))
    ]
    return Mesh(points, tuple(_triangles(points, edges, instance.boundary)))


def _numbers(document: dict[str, Any], name: str, binary64: bool) -> list[Any]:
    """An array of rationals."""
    values = fields.as_list(fields.member(document, name, "$"), f"$.{name}")
    return [
        rational_from_json(value, f"$.{name}[{i}]", binary64=binary64)
        for i, value in enumerate(values)
    ]


def _edge(value: Any, path: str) -> Edge:
    """A pair of integers, whatever they are."""
    pair = fields.as_list(value, path)
    if len(pair) != 2:
        raise fields.refuse("schema", f"an edge has two indices, not {len(pair)}", path)
    a, b = (_index(index, f"{path}[{k}]") for k, index in enumerate(pair))
    return a, b


def _index(value: Any, path: str) -> int:
    """An index, however long."""
    if type(value) is int:
        return value
    if isinstance(value, JsonNumber) and value.removeprefix("-").isdigit():
        return int(rational_from_json(value, path).numerator)
    raise fields.refuse("schema", "an edge's ends are integers", path)


def _triangles(
    points: Sequence[HPoint], edges: Sequence[Edge], boundary: Sequence[int]
) -> list[Triangle]:
    """The triangles that edges bound, and what tells a judge of edges that are amiss."""
    size = len(points)
    implied = list(zip(boundary, (*boundary[1:], boundary[0]), strict=True)) if boundary else []
    sound = [(a, b) for a, b in edges if 0 <= a < size and 0 <= b < size and a != b]
    amiss = [(a, b, b) for a, b in edges if not (0 <= a < size and 0 <= b < size) or a == b]
    found = faces_of_edges(points, sound, implied)
    if found.crossing is not None:
        e, f = found.crossing
        clear = [t for t in found.triangles if not (set(e) <= set(t) or set(f) <= set(t))]
        return [*clear, _on(points, e, f), _on(points, f, e), *amiss]
    return [*found.triangles, *((a, b, b) for a, b in found.stray), *amiss]


def _on(points: Sequence[HPoint], e: Edge, f: Edge) -> Triangle:
    """The triangle of an edge and the end of another that lies to its left."""
    left = f[0] if orientation(points[e[0]], points[e[1]], points[f[0]]) > 0 else f[1]
    return e[0], e[1], left
