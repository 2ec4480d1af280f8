"""The judge for everyday use: the findings of `judge.py`, in homogeneous integers.

The conditions and why they suffice are stated in `judge.py`, which shares no code with this
module; tests compare the two word for word.  `sides.py` has the boundary.
"""

from __future__ import annotations

from collections.abc import Sequence

from gmpy2 import mpq, mpz, sign

from bern_exact.exact.angle_bound import AngleBound
from bern_exact.exact.points import HPoint
from bern_exact.oracle.shapes import Bounds, Extremes, Shape, angle_class, shape_of
from bern_exact.oracle.side_sweep import Side
from bern_exact.oracle.sides import look_at_sides
from bern_exact.oracle.verdict import ANGLE_CLASSES, Findings, Verdict, point_json
from bern_exact.plane.mesh import Mesh, Triangle
from bern_exact.plane.polygon import Polygon


def verify_mesh(
    mesh: Mesh,
    polygon: Polygon | None,
    *,
    max_angle: AngleBound | None = None,
    min_height_squared: mpq | None = None,
    max_triangles: int | None = None,
    limit: int = 100,
) -> Verdict:
    """Is this mesh a triangulation of this polygon, within these bounds?

    Parameters
    ----------
    mesh : Mesh
        Any vertices and triangles; whatever is wrong with them is a defect.
    polygon : Polygon or None
        A valid polygon; its vertices must be vertices of the mesh.  Without one the mesh must
        be a triangulation of what its boundary encloses.
    max_angle : AngleBound, optional
        No angle may be larger.
    min_height_squared : mpq, optional
        No triangle's squared height may be smaller.
    max_triangles : int, optional
        There may be no more triangles.
    limit : int
        How many defects are listed; further ones still make the mesh invalid.

    Notes
    -----
    O(m log m) for m triangles with a polygon or with few sides; without a polygon, or in order
    to name what is wrong with a boundary, up to quadratic in the number of sides.
    """
    found = Findings(limit)
    sound = _look_at_indices(mesh, found)
    shapes = _Shapes(mesh.vertices, sound)
    sides = _look_at_edges(mesh.vertices, sound, shapes.signs, found)
    look_at_sides(mesh.vertices, sides, polygon, found)
    shapes.measure(Bounds(max_angle, min_height_squared), found)
    look_at_number(len(mesh.triangles), max_triangles, found)
    size = len(mesh.triangles), len(mesh.vertices)
    return verdict_of(found, *size, shapes.extremes, shapes.classes)


def look_at_number(triangles: int, most: int | None, found: Findings) -> None:
    """Say that there are too many triangles, if there are."""
    if most is not None and triangles > most:
        found.add("too-many-triangles", {}, {"triangles": triangles, "bound": most})


def verdict_of(
    found: Findings, triangles: int, vertices: int, extremes: Extremes, classes: Sequence[int]
) -> Verdict:
    """The verdict from all that was found."""
    return Verdict(
        valid=found.valid,
        defects=tuple(found.defects),
        triangles=triangles,
        vertices=vertices,
        max_angle=extremes.max_angle,
        max_angle_triangle=extremes.max_angle_triangle,
        min_height_squared=extremes.min_height_squared,
        min_height_triangle=extremes.min_height_triangle,
        angle_classes=dict(zip(ANGLE_CLASSES, classes, strict=True)),
    )


def _look_at_indices(mesh: Mesh, found: Findings) -> dict[int, Triangle]:
    """The triangles, by number, whose corners are three vertices; defects of the others."""
    size, sound = len(mesh.vertices), {}
    used = bytearray(size)
    for t, corners in enumerate(mesh.triangles):
        a, b, c = corners
        inside = 0 <= a < size and 0 <= b < size and 0 <= c < size
        if inside and a != b and b != c and c != a:
            sound[t] = corners
            used[a] = used[b] = used[c] = 1
            continue
        for v in corners:
            if 0 <= v < size:
                used[v] = 1
        name_bad_corners(t, corners, size, found)
    first: dict[HPoint, int] = {}
    for v, p in enumerate(mesh.vertices):
        name_bad_vertex(v, p, first.setdefault(p, v), bool(used[v]), found)
    return sound


def name_bad_corners(t: int, corners: Sequence[int], size: int, found: Findings) -> None:
    """Say what is wrong with a triangle whose corners are not three vertices."""
    bad = [v for v in corners if not 0 <= v < size]
    if bad:
        found.add("index-out-of-range", {"triangle": t}, {"index": str(mpz(bad[0]))})
    else:
        found.add("repeated-index", {"triangle": t}, {"corners": list(corners)})


def name_bad_vertex(v: int, p: HPoint, first: int, is_used: bool, found: Findings) -> None:
    """Say of a vertex that it is not the first at its point, and that nothing uses it."""
    if first != v:
        found.add("duplicate-vertex", {"vertex": v}, {"first": first, "point": point_json(p)})
    if not is_used:
        found.add("unused-vertex", {"vertex": v}, {"point": point_json(p)})


def _look_at_edges(
    vertices: Sequence[HPoint], sound: dict[int, Triangle], signs: dict[int, int], found: Findings
) -> list[Side]:
    """The directed edges that are used more often than their reverses.

    Vertices at one point count as one.  An edge ab is packed as a V + b, V the number of vertices.
    """
    first: dict[HPoint, int] = {}
    same = [first.setdefault(p, v) for v, p in enumerate(vertices)]
    size = len(vertices)
    owner: dict[int, int] = {}
    others: dict[int, list[int]] = {}
    for t, (a, b, c) in sound.items():
        a, b, c = same[a], same[b], same[c]
        orientation = signs.get(t, 1)
        if orientation < 0:  # and is counted as turned over
            found.add("clockwise-triangle", {"triangle": t}, {})
            b, c = c, b
        elif orientation == 0:
            found.add("degenerate-triangle", {"triangle": t}, {})
        for edge in (a * size + b, b * size + c, c * size + a):
            if edge in owner:
                others.setdefault(edge, []).append(t)
            else:
                owner[edge] = t
    sides = []
    for edge, t in owner.items():
        tail, head = divmod(edge, size)
        times = 1
        if edge in others:
            times += len(others[edge])
            witness = {"triangles": [t, *others[edge]]}
            found.add("edge-used-twice", {"edge": [tail, head]}, witness)
        reverse = head * size + tail
        if reverse in owner:
            times -= 1 + len(others.get(reverse, ()))
        if times > 0 and tail != head:
            sides.append((tail, head, times))
    return sides


class _Shapes:
    """Orientation, largest angle and least height of every triangle."""

    def __init__(self, vertices: Sequence[HPoint], sound: dict[int, Triangle]) -> None:
        self.signs: dict[int, int] = {}  # of the triangles that are not counter-clockwise
        self.classes = [0] * len(ANGLE_CLASSES)
        self.extremes = Extremes()
        self._shapes: dict[int, Shape] = {}
        for t, (a, b, c) in sound.items():
            shape = shape_of(vertices[a], vertices[b], vertices[c])
            if shape[1] <= 0:
                self.signs[t] = int(sign(shape[1]))
            if shape[1] != 0:
                self._shapes[t] = shape

    def measure(self, bounds: Bounds, found: Findings) -> None:
        """Find the extremes and the classes, and compare with the bounds."""
        for t, shape in self._shapes.items():
            self.classes[angle_class(shape[0], abs(shape[1]))] += 1
            self.extremes.see_angle(t, shape)
            self.extremes.see_height(t, shape)
            bounds.look_at(t, shape, found)
