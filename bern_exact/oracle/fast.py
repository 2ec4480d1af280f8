"""The judge for everyday use: the findings of `judge.py`, in homogeneous integers.

The conditions and why they suffice are stated in `judge.py`, which shares no code with this
module; tests compare the two word for word.  `sides.py` has the boundary.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gmpy2 import mpq, mpz, sign

from bern_exact.exact.angle_bound import AngleBound
from bern_exact.exact.angles import Angle
from bern_exact.exact.points import HPoint
from bern_exact.oracle.sides import Side, look_at_sides
from bern_exact.oracle.verdict import ANGLE_CLASSES, Findings, Verdict, angle_json, point_json
from bern_exact.plane.mesh import Mesh, Triangle
from bern_exact.plane.polygon import Polygon

Shape = tuple[mpz, mpz, mpz, mpz]
"""(2 dot, cross, longest, product): the largest angle's cot, and what heights are made of."""


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
    shapes.measure(max_angle, min_height_squared, found)
    if max_triangles is not None and len(mesh.triangles) > max_triangles:
        witness = {"triangles": len(mesh.triangles), "bound": max_triangles}
        found.add("too-many-triangles", {}, witness)
    return Verdict(
        valid=found.valid,
        defects=tuple(found.defects),
        triangles=len(mesh.triangles),
        vertices=len(mesh.vertices),
        max_angle=shapes.max_angle,
        max_angle_triangle=shapes.max_angle_triangle,
        min_height_squared=shapes.min_height_squared,
        min_height_triangle=shapes.min_height_triangle,
        angle_classes=dict(zip(ANGLE_CLASSES, shapes.classes, strict=True)),
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
        if inside:
            found.add("repeated-index", {"triangle": t}, {"corners": list(corners)})
        else:
            bad = next(v for v in corners if not 0 <= v < size)
            found.add("index-out-of-range", {"triangle": t}, {"index": str(mpz(bad))})
    first: dict[HPoint, int] = {}
    for v, p in enumerate(mesh.vertices):
        other = first.setdefault(p, v)
        if other != v:
            found.add("duplicate-vertex", {"vertex": v}, {"first": other, "point": point_json(p)})
        if not used[v]:
            found.add("unused-vertex", {"vertex": v}, {"point": point_json(p)})
    return sound


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
        self.vertices, self.sound = vertices, sound
        self.signs: dict[int, int] = {}  # of the triangles that are not counter-clockwise
        self.classes = [0] * len(ANGLE_CLASSES)
        self.max_angle: Angle | None = None
        self.max_angle_triangle: int | None = None
        self.min_height_squared: mpq | None = None
        self.min_height_triangle: int | None = None
        self._shapes: dict[int, Shape] = {}
        for t, (a, b, c) in sound.items():
            shape = _shape(vertices[a], vertices[b], vertices[c])
            if shape[1] <= 0:
                self.signs[t] = int(sign(shape[1]))
            if shape[1] != 0:
                self._shapes[t] = shape

    def measure(
        self, max_angle: AngleBound | None, min_height_squared: mpq | None, found: Findings
    ) -> None:
        """Find the extremes and the classes, and compare with the bounds."""
        if not self._shapes:
            return
        worst = flattest = -1
        low = mpz(0), mpz(1)  # the least cot so far
        least = mpz(0), mpz(1)  # the least squared height so far
        for t, (dot, cross, longest, scale) in self._shapes.items():
            cross = abs(cross)
            self.classes[_angle_class(dot, cross)] += 1
            if worst < 0 or dot * low[1] < low[0] * cross:
                worst, low = t, (dot, cross)
            height = cross * cross, longest * scale
            if flattest < 0 or height[0] * least[1] < least[0] * height[1]:
                flattest, least = t, height
            if max_angle is not None and not max_angle.admits_corner(dot, 2 * cross):
                witness: dict[str, Any] = {"bound": max_angle.text}
                if not found.full:
                    witness |= angle_json(_angle_of(dot, cross))
                found.add("angle-above-bound", {"triangle": t}, witness)
            if min_height_squared is not None and mpq(*height) < min_height_squared:
                witness = {"bound": str(min_height_squared), "height_squared": str(mpq(*height))}
                found.add("height-below-bound", {"triangle": t}, witness)
        self.max_angle, self.max_angle_triangle = _angle_of(*low), worst
        self.min_height_squared, self.min_height_triangle = mpq(*least), flattest


def _shape(p: HPoint, q: HPoint, r: HPoint) -> Shape:
    """Twice the dot product at the largest angle, cross product, longest edge squared, and scale.

    The first three are multiplied by the scale, (pw qw rw)^2, so that they are integers.
    """
    px, py, pw = p
    qx, qy, qw = q
    rx, ry, rw = r
    ax, ay = qx * pw - px * qw, qy * pw - py * qw
    bx, by = rx * pw - px * rw, ry * pw - py * rw
    cx, cy = rx * qw - qx * rw, ry * qw - qy * rw
    cross = (ax * by - ay * bx) * qw * rw
    first = (ax * ax + ay * ay) * rw * rw
    second = (bx * bx + by * by) * qw * qw
    third = (cx * cx + cy * cy) * pw * pw
    longest = max(first, second, third)
    return first + second + third - 2 * longest, cross, longest, (pw * qw * rw) ** 2


def _angle_class(dot: mpz, cross: mpz) -> int:
    """The number of the class of the angle with this 2 dot and this cross > 0."""
    if dot > 0:
        return 0 if 4 * cross * cross <= 3 * dot * dot else 1
    if dot == 0:
        return 1
    squared_dot, squared_cross = dot * dot, cross * cross
    if 3 * squared_dot <= 4 * squared_cross:
        return 2
    if squared_dot <= 4 * squared_cross:
        return 3
    return 4 if squared_dot <= 12 * squared_cross else 5


def _angle_of(dot: mpz, cross: mpz) -> Angle:
    """The angle with this 2 dot and this cross."""
    return Angle(int(sign(dot)), mpq(dot * dot, dot * dot + 4 * cross * cross))
