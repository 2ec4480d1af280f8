"""Polygons of Shewchuk's Triangle: `.poly`, read and written.

Segments must form closed rings, and nothing else.  Which ring is the outer one follows from how
they lie; every other one must have a hole point inside.  A ring inside without a hole point is a
constraint on the triangulation, and no part of the polygon.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from gmpy2 import mpq

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import nearest_binary64
from bern_exact.exact.points import HPoint, coordinates, hpoint
from bern_exact.exact.predicates import compare_xy, orientation
from bern_exact.formats.doubles import Rounding
from bern_exact.formats.token_text import TokenText, columns
from bern_exact.formats.triangle_mesh import (
    Nodes,
    beside,
    check_end,
    load_nodes,
    read_nodes,
    rows,
)
from bern_exact.plane.array_mesh import Indices
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import triangulate_polygon
from bern_exact.plane.validation import polygon_from_rings


def load_polygon(source: Path, /, *, binary64: bool) -> Polygon:
    """The polygon in a `.poly`; its vertices may be in the `.node` of the same name.

    The outer ring comes first, then the holes in the order of their first vertices.  Vertices on no
    segment are refused, as constraints, but for those of a `.node`, which may be a mesh's.

    Raises
    ------
    InputError
        Kind `unsupported`: vertices on no segment, segments that form no rings, rings inside
        without a hole point; `schema`: a hole point of the polygon, no such vertex, or no `.node`;
        `syntax` or `number` with the line; or the kinds of `polygon_from_rings`.
    OSError
        A file cannot be read.

    Notes
    -----
    O(n log n) for the validation, and linear in a ring's size for each hole point in its box.
    """
    text = TokenText.of_file(source, comments=True, name=source.name)
    nodes, row = read_nodes(text, binary64=binary64)
    elsewhere = len(nodes.points) == 0
    if elsewhere:
        nodes = load_nodes(beside(source, ".node"), binary64=binary64)
    points = [nodes.points.point(v) for v in range(len(nodes.points))]
    segments, row = _segments(text, row, nodes)
    hole_points, row = _hole_points(text, row, binary64)
    if row < len(text.row_first):  # regional attributes: what Triangle's -A and -a use
        count = text.whole(int(text.row_first[row]), "the number of regions")
        rows(text, row + 1, count, 3, "region")
        check_end(text, row + 1 + count)
    rings = [
        [points[v] for v in ring] for ring in _rings(segments, len(points), nodes.first, elsewhere)
    ]
    if not rings:
        raise InputError("too-few-vertices", "the outer ring has no vertices", {"ring": 0})
    outer = _outermost(rings)
    polygon = polygon_from_rings([rings[outer], *rings[:outer], *rings[outer + 1 :]])
    _check_holes(polygon, hole_points)
    return polygon


def _segments(text: TokenText, row: int, nodes: Nodes) -> tuple[Indices, int]:
    """The segments as pairs of vertices, 0-based, and the row after them."""
    if row >= len(text.row_first):
        raise text.refuse("syntax", "the file ends before the segments", len(text))
    count = text.whole(int(text.row_first[row]), "the number of segments")
    first = rows(text, row + 1, count, 3, "segment")
    text.integers(first)
    pairs = text.integers(columns(first, 1, 2)) - nodes.first
    size = len(nodes.points)
    bad = np.flatnonzero(((pairs < 0) | (pairs >= size)).any(axis=1))
    if len(bad):
        raise text.refuse("schema", "there is no such vertex", int(first[bad[0]]))
    return pairs, row + 1 + count


def _hole_points(text: TokenText, row: int, binary64: bool) -> tuple[list[HPoint], int]:
    """The points that holes are marked by, and the row after them."""
    if row >= len(text.row_first):
        raise text.refuse("syntax", "the file ends before the number of holes", len(text))
    count = text.whole(int(text.row_first[row]), "the number of holes")
    first = rows(text, row + 1, count, 3, "hole")
    found = text.points(columns(first, 1, 2), binary64=binary64)
    return [found.point(i) for i in range(count)], row + 1 + count


def _rings(segments: Indices, size: int, base: int, elsewhere: bool) -> list[list[int]]:
    """The rings that segments form, each from its least vertex along its first segment there.

    Vertices on no segment are passed over if they stand in another file.

    Raises
    ------
    InputError
        Kind `unsupported`: a vertex is not on two segments.
    """
    neighbours: list[list[int]] = [[] for _ in range(size)]
    leaving: dict[int, int] = {}
    for a, b in segments.tolist():
        neighbours[a].append(b)
        neighbours[b].append(a)
        leaving.setdefault(a, b)
    for v, around in enumerate(neighbours):
        if len(around) != 2 and not (elsewhere and not around):
            message = f"vertex {v + base} is on {len(around)} segments: only closed rings are read"
            raise InputError("unsupported", message, {"vertex": v + base})
    rings, seen = [], bytearray(size)
    for start in range(size):
        if seen[start] or not neighbours[start]:
            continue
        ring, v, following = [], start, leaving.get(start, neighbours[start][0])
        while not seen[v]:
            seen[v] = 1
            ring.append(v)
            first, second = neighbours[following]
            v, following = following, second if first == v else first
        rings.append(ring)
    return rings


def _outermost(rings: Sequence[Sequence[HPoint]]) -> int:
    """The ring with the lexicographically first point: no other can be around it."""
    best, first = 0, rings[0][0]
    for r, ring in enumerate(rings):
        for p in ring:
            if compare_xy(p, first) < 0:
                best, first = r, p
    return best


def _check_holes(polygon: Polygon, hole_points: Sequence[HPoint]) -> None:
    """Refuse holes without a point inside, and points of the polygon; others do no harm."""
    holes = [polygon.input_ring(r) for r in range(1, len(polygon.rings))]
    boxes = [_box(hole) for hole in holes]
    marked = bytearray(len(holes))
    for i, p in enumerate(hole_points):
        x, y = coordinates(p)
        around = next(
            (
                h
                for h, (left, right, low, high) in enumerate(boxes)
                if left < x < right and low < y < high and _place(p, holes[h]) > 0
            ),
            None,
        )
        if around is not None:
            marked[around] = 1
        elif _place(p, polygon.input_ring(0)) >= 0:
            message = f"hole point {i} of the .poly lies inside no hole"
            raise InputError("schema", message, {"hole_point": i})
    if 0 in marked:
        ring = marked.index(0) + 1
        message = (
            f"ring {ring} lies inside and has no hole point: constraints inside are not read, "
            "only polygons"
        )
        raise InputError("unsupported", message, {"ring": ring})


def _box(ring: Sequence[HPoint]) -> tuple[mpq, mpq, mpq, mpq]:
    """The least and greatest x and y."""
    xs = [mpq(x, w) for x, _, w in ring]
    ys = [mpq(y, w) for _, y, w in ring]
    return min(xs), max(xs), min(ys), max(ys)


def _place(p: HPoint, ring: Sequence[HPoint]) -> int:
    """1 if p is strictly inside a simple ring, 0 if on it, -1 if outside."""
    y = mpq(p[1], p[2])
    inside = False
    for i, b in enumerate(ring):
        a = ring[i - 1]
        turn = orientation(a, b, p)
        if turn == 0 and _is_between(a, p, b):
            return 0
        above_a, above_b = mpq(a[1], a[2]) > y, mpq(b[1], b[2]) > y
        if above_a != above_b and (turn > 0) == above_b:
            inside = not inside
    return 1 if inside else -1


def _is_between(a: HPoint, p: HPoint, b: HPoint) -> bool:
    """Does p, on the line ab, lie on the closed segment?"""
    return compare_xy(a, p) * compare_xy(b, p) <= 0


def dumps_polygon(polygon: Polygon) -> tuple[str, int]:
    """A polygon as `.poly`, 1-based, and the number of coordinates that were rounded to doubles.

    Each hole is marked by the middle of the largest triangle of a triangulation of it whose
    middle, rounded, is still inside.

    Raises
    ------
    InputError
        Kind `number`: a coordinate is beyond all doubles, or no hole point is found.

    Notes
    -----
    O(n log n) usually, for the triangulations of the holes.
    """
    rounding = Rounding()
    lines = [f"{polygon.n} 2 0 0"]
    pairs = rounding.pairs(polygon.points)
    lines += [f"{v} {x} {y}" for v, (x, y) in enumerate(pairs, 1)]
    lines.append(f"{polygon.n} 0")
    for ring in polygon.rings:
        size, first = len(ring), ring[0]
        steps = ((first + i, first + (i + 1) % size) for i in range(size))
        lines += [f"{a + 1} {a + 1} {b + 1}" for a, b in steps]
    lines.append(f"{polygon.holes}")
    for r in range(1, len(polygon.rings)):
        x, y = _inside(polygon.input_ring(r), r)
        lines.append(f"{r} {x} {y}")
    return "\n".join(lines) + "\n", rounding.rounded


def _inside(ring: Sequence[HPoint], number: int) -> tuple[str, str]:
    """A point of doubles inside a ring, also after its coordinates were rounded to doubles."""
    hole = polygon_from_rings([ring])
    read = [_rounded(p) for p in ring]
    middles = []
    for corners in triangulate_polygon(hole).triangles():
        a, b, c = (coordinates(hole.points[v]) for v in corners)
        area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        middles.append((-area, hpoint((a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3)))
    for _, middle in sorted(middles):
        p = _rounded(middle)
        if _place(p, read) > 0 and _place(p, ring) > 0:
            return Rounding().pairs([p])[0]
    message = f"hole {number} has no double inside that .poly could mark it by"
    raise InputError("number", message, {"ring": number})


def _rounded(p: HPoint) -> HPoint:
    """The point with both coordinates rounded to doubles."""
    x, y = coordinates(p)
    return hpoint(nearest_binary64(x), nearest_binary64(y))
