"""The sides of a mesh, its edges without a reverse, against the polygon's boundary.

The conditions are those of `judge.py`, where it is proved that they suffice.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

from gmpy2 import gcd, mpq, mpz

from bern_exact.exact.points import (
    HPoint,
    Line,
    Vector,
    coordinates,
    direction,
    line_through,
    reduced,
)
from bern_exact.exact.predicates import cross, dot, orientation
from bern_exact.oracle.side_sweep import Side, enclose_once
from bern_exact.oracle.verdict import Findings, point_json
from bern_exact.plane.polygon import Polygon

Place = dict[str, Any]
"""A place as a defect has it, such as `{"edge": [3, 5]}`."""

Piece = tuple[HPoint, HPoint, int, Place]
"""From, to, how often run through (a polygon's edge: -1), and whose edge it is."""

Stretch = tuple[HPoint, HPoint, int, Place]
"""A part of a line, how much more sides than edges run there, and one of them."""

Spot = tuple[HPoint, Vector, Vector]
"""(m, d, n): the point m + e n + e^2 d for all small e > 0."""


class PointSet(Sequence[HPoint]):
    """Points of which it is told quickly whether one is among them."""


def look_at_sides(
    vertices: Sequence[HPoint], sides: Sequence[Side], polygon: Polygon | None, found: Findings
) -> None:
    """Do the sides run just where the polygon does, or (without one) enclose a region once?

    Parameters
    ----------
    vertices : sequence of HPoint
        The mesh's vertices.
    sides : sequence of Side
        Its edges without a reverse; vertices at one point count as one.
    polygon : Polygon or None
        What the mesh should triangulate.
    found : Findings
        Takes the defects.
    """
    outline = [] if polygon is None else _outline(polygon)
    lines: dict[Line, list[Piece]] = defaultdict(list)
    for a, b, times in sides:
        p, q = vertices[a], vertices[b]
        lines[_line(p, q)].append((p, q, times, {"edge": [a, b]}))
    for p, q, times, place in outline:
        lines[_line(p, q)].append((p, q, times, place))
    if polygon is not None:
        corners = vertices if isinstance(vertices, PointSet) else set(vertices)
        for p, (_, _, _, place) in zip(polygon.points, outline, strict=True):
            if p not in corners:
                where = {"polygon_vertex": place["polygon_edge"]}
                found.add("polygon-vertex-missing", where, {"point": point_json(p)})
    wrong = [stretch for pieces in lines.values() for stretch in _unmatched(pieces)]
    if wrong:
        _name_what_is_wrong(vertices, sides, polygon, outline, wrong, found)
    if not sides:
        found.add("region-not-covered", {}, {"point": "any point"})


def _outline(polygon: Polygon) -> list[Piece]:
    """The polygon's directed edges, one for each vertex, in input order."""
    pieces: list[Piece] = []
    for r, ring in enumerate(polygon.rings):
        first, n = len(pieces), len(ring)
        for i in range(n):
            a, b = first + i, first + (i + 1) % n
            if polygon.after[a] != b:
                a, b = b, a
            place = {"polygon_edge": [r, i]}
            pieces.append((polygon.points[a], polygon.points[b], -1, place))
    return pieces


def _line(p: HPoint, q: HPoint) -> Line:
    """The line through two points: the same triple for any two of its points."""
    a, b, c = line_through(p, q)
    divisor = gcd(gcd(a, b), c)
    if a < 0 or (a == 0 and b < 0):
        divisor = -divisor
    return a // divisor, b // divisor, c // divisor


def _unmatched(pieces: Sequence[Piece]) -> Iterator[Stretch]:
    """The stretches of one line where sides overlap, or do not match the polygon's edges."""
    if len(pieces) == 2:  # most often: a side that is an edge
        (p, q, times, _), (v, w, others, _) = pieces
        if p == v and q == w and times == 1 and others == -1:
            return
    at = {p: coordinates(p) for piece in pieces for p in piece[:2]}
    net, sides = dict.fromkeys(at, 0), dict.fromkeys(at, 0)
    for p, q, times, _ in pieces:
        net[p] += times
        net[q] -= times
        if times > 0:
            low, high = (p, q) if at[p] < at[q] else (q, p)
            sides[low] += times
            sides[high] -= times
    for p, q in pairwise(sorted(at, key=at.__getitem__)):
        net[q] += net[p]
        sides[q] += sides[p]
        if net[p] or sides[p] > 1:
            place = next(place for v, w, _, place in pieces if _spans(at, v, w, p, q))
            yield p, q, net[p], place


def _spans(at: dict[HPoint, tuple[mpq, mpq]], v: HPoint, w: HPoint, p: HPoint, q: HPoint) -> bool:
    """Of points on one line, p before q: does vw contain pq?"""
    low, high = sorted((at[v], at[w]))
    return low <= at[p] and at[q] <= high


def _name_what_is_wrong(
    vertices: Sequence[HPoint],
    sides: Sequence[Side],
    polygon: Polygon | None,
    outline: Sequence[Piece],
    wrong: Sequence[Stretch],
    found: Findings,
) -> None:
    """Defects where sides are not the polygon's boundary (without a polygon: if they are amiss)."""
    if polygon is None and enclose_once(vertices, sides):
        return
    clashes = conflicts(vertices, sides)
    for kind, i, j in clashes:
        edge = list(sides[i][:2])
        if kind == "hanging":
            witness = {"edge": edge, "point": point_json(vertices[j])}
            found.add("hanging-vertex", {"vertex": j}, witness)
        else:
            kind = "boundary-not-simple" if polygon is None else "crossing-edges"
            found.add(kind, {"edge": edge}, {"other": list(sides[j][:2])})
    if polygon is not None:
        ends = {u for p, q, net, _ in wrong if net for u in (p, q)}
        _name_vertices_off_edges(vertices, sides, ends, outline, found)
    directed = [(vertices[a], vertices[b], times) for a, b, times in sides]
    if polygon is None and not clashes and _is_covered_once(vertices, sides, directed):
        return
    boundary = [(p, q, 1) for p, q, _, _ in outline]
    outer = len(polygon.rings[0]) if polygon is not None else 0
    for p, q, _, place in wrong:
        if found.valid or not found.full:
            for spot in _beside(p, q):
                covered = _winding(directed, spot)
                point = point_json(spot[0])
                if covered > 1:
                    found.add("overlap", place, {"point": point, "covered": covered})
                elif polygon is not None:
                    wanted = _winding(boundary, spot)
                    if covered < wanted:
                        found.add("region-not-covered", place, {"point": point})
                    elif covered > wanted:
                        in_hole = _winding(boundary[:outer], spot) != 0
                        kind = "hole-filled" if in_hole else "triangle-outside"
                        found.add(kind, place, {"point": point})


def _name_vertices_off_edges(
    vertices: Sequence[HPoint],
    sides: Sequence[Side],
    ends: set[HPoint],
    outline: Sequence[Piece],
    found: Findings,
) -> None:
    """Those of the ends of wrong stretches that lie on no edge of the polygon."""
    boxes = [_box(coordinates(p), coordinates(q)) for p, q, _, _ in outline]
    for v in sorted({v for side in sides for v in side[:2]}):
        point = vertices[v]
        if found.full:
            break
        if point not in ends:
            continue
        x, y = coordinates(point)
        if not any(
            left <= x <= right and low <= y <= high and orientation(p, q, point) == 0
            for (p, q, _, _), (left, right, low, high) in zip(outline, boxes, strict=True)
        ):
            witness = {"point": point_json(point)}
            found.add("boundary-vertex-off-edge", {"vertex": v}, witness)


def _box(p: tuple[mpq, mpq], q: tuple[mpq, mpq]) -> tuple[mpq, mpq, mpq, mpq]:
    """Left, right, low, high of a segment."""
    return min(p[0], q[0]), max(p[0], q[0]), min(p[1], q[1]), max(p[1], q[1])


def conflicts(vertices: Sequence[HPoint], sides: Sequence[Side]) -> list[tuple[str, int, int]]:
    """Where sides meet other than in common endpoints.

    Returns
    -------
    list of (str, int, int)
        `("crossing", i, j)` for sides i < j, `("hanging", i, v)` for a vertex v inside side i;
        sorted, each once.

    Notes
    -----
    Only sides whose bounding boxes meet are compared: a sweep over x, quadratic at worst.
    """
    found: set[tuple[str, int, int]] = set()
    boxes = [_box(coordinates(vertices[a]), coordinates(vertices[b])) for a, b, _ in sides]
    active: list[int] = []
    for j in sorted(range(len(sides)), key=lambda j: boxes[j][0]):
        left, _, low, high = boxes[j]
        active = [i for i in active if boxes[i][1] >= left]
        for i in active:
            if boxes[i][2] <= high and low <= boxes[i][3]:
                found.update(_meeting(vertices, sides, i, j))
        active.append(j)
    return sorted(found)


def _meeting(
    vertices: Sequence[HPoint], sides: Sequence[Side], i: int, j: int
) -> Iterator[tuple[str, int, int]]:
    """The conflicts of two sides."""
    crossing = True
    for k, other in ((i, j), (j, i)):
        p, q = vertices[sides[k][0]], vertices[sides[k][1]]
        turns = [orientation(p, q, vertices[v]) for v in sides[other][:2]]
        for v, turn in zip(sides[other][:2], turns, strict=True):
            if turn == 0 and dot(direction(vertices[v], p), direction(vertices[v], q)) < 0:
                yield "hanging", k, v
        crossing = crossing and turns[0] * turns[1] < 0
    if crossing:
        yield "crossing", min(i, j), max(i, j)


def _is_covered_once(
    vertices: Sequence[HPoint],
    sides: Sequence[Side],
    directed: Sequence[tuple[HPoint, HPoint, int]],
) -> bool:
    """Do sides without conflicts have one triangle on their left and none on their right?

    That is the same all along a path of sides up to a vertex where several paths meet.
    """
    ahead: dict[int, list[Side]] = defaultdict(list)
    for side in sides:
        ahead[side[0]].append(side)
    seen: set[Side] = set()
    for side in sides:
        if side not in seen:
            spots = _beside(vertices[side[0]], vertices[side[1]])
            if [_winding(directed, spot) for spot in spots] != [1, 0]:
                return False
        while side not in seen:
            seen.add(side)
            if len(ahead[side[1]]) == 1:
                side = ahead[side[1]][0]
    return True


def _beside(p: HPoint, q: HPoint) -> tuple[Spot, Spot]:
    """The spots just left and just right of the middle of pq."""
    middle = reduced(p[0] * q[2] + q[0] * p[2], p[1] * q[2] + q[1] * p[2], 2 * p[2] * q[2])
    x, y = direction(p, q)
    return (middle, (x, y), (-y, x)), (middle, (x, y), (y, -x))


def _winding(directed: Sequence[tuple[HPoint, HPoint, int]], spot: Spot) -> int:
    """How often directed segments wind round a spot: those that a ray in direction +x meets."""
    (mx, my, mw), d, n = spot
    above = (n[1] or d[1]) > 0
    total = 0
    for p, q, times in directed:
        from_p, from_q = my * p[2] - p[1] * mw, my * q[2] - q[1] * mw
        if (from_p >= 0) == (from_q >= 0) if above else (from_p > 0) == (from_q > 0):
            continue
        along = direction(p, q)
        left: mpz | int = orientation(p, q, spot[0]) or cross(along, n) or cross(along, d)
        if (left > 0) == (along[1] > 0):
            total += times if along[1] > 0 else -times
    return total
