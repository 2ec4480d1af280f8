"""Lemma 3: the rectilinear polygons inside, triangulated by two sweeps."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence

from bern_exact.checkers import bounds
from bern_exact.checkers.definition_2 import directed_edges, stack_columns
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.lemma_2 import tiles
from bern_exact.interior.records import Column, GridNode, Rectilinear, Swept, SweptColumn

STAGE = "swept"

Sides = Mapping[int, Sequence[int]]
"""The increasing y-coordinates of points on each vertical line."""


def check_lemma_3(swept: Swept) -> list[Finding]:
    """Check Lemma 3 (height and diagonals repaired).

    Parameters
    ----------
    swept : Swept
        Q, its columns with the points on their sides, and the triangles.

    Notes
    -----
    The columns are found again from Q's boundary.  O(T log T).
    """
    columns = stack_columns(directed_edges(swept.region), Violations())
    boundary = _by_line(node for loop in swept.region.loops for node in loop)
    added = _by_line(swept.added)
    return [
        _check_columns(swept, columns, boundary, added),
        _check_added(swept, columns, boundary),
        _check_interior(swept, columns, boundary),
        _check_subdivisions(swept),
        _check_height(swept),
        *_check_count(swept),
    ]


def _by_line(nodes: Iterable[GridNode]) -> Sides:
    lines: dict[int, set[int]] = defaultdict(set)
    for x, y in nodes:
        lines[x].add(y)
    return {x: sorted(ys) for x, ys in lines.items()}


def _strictly_between(sides: Sides, x: int, low: int, high: int) -> Sequence[int]:
    """The points of a line strictly between two heights."""
    ys = sides.get(x, ())
    return ys[bisect_right(ys, low) : bisect_left(ys, high)]


def _check_columns(
    swept: Swept, columns: Sequence[Column], boundary: Sides, added: Sides
) -> Finding:
    """The record's columns are Q's, carry all points on their sides, and are tiled."""
    broken = Violations()
    if sorted(columns) != sorted(item.column for item in swept.columns):
        broken.broken("other columns than those of Q")
    for item in swept.columns:
        x0, x1, y0, y1 = item.column
        fits = True
        for x, side in ((x0, item.left), (x1, item.right)):
            points = {*_strictly_between(boundary, x, y0, y1), *_strictly_between(added, x, y0, y1)}
            fits &= list(side) == [y0, *sorted(points), y1]
        ring = [*((x1, y) for y in item.right), *((x0, y) for y in reversed(item.left))]
        broken.case(fits and tiles(ring, item.triangles), item.column)
    return broken.finding(
        "lemma-3.columns",
        STAGE,
        "Q is the union of its columns, and each is tiled by triangles on all points of its two "
        "vertical sides and no others: the total area is that of Q",
    )


def _check_added(swept: Swept, columns: Sequence[Column], boundary: Sides) -> Finding:
    """At most 2 B_L + B_R points."""
    left = sum(len(_strictly_between(boundary, c.x0, c.y0, c.y1)) for c in columns)
    right = sum(len(_strictly_between(boundary, c.x1, c.y0, c.y1)) for c in columns)
    most = Extreme(greatest=True)
    most.offer(len(swept.added), 1, {"left": left, "right": right})
    return most.finding(
        "lemma-3.added",
        STAGE,
        "the sweeps add at most 2 B_L + B_R points, for B_L (B_R) boundary vertices strictly "
        "inside left (right) sides of columns",
        bounds.added_points(left, right),
    )


def _check_interior(swept: Swept, columns: Sequence[Column], boundary: Sides) -> Finding:
    """Every added point lies strictly inside sides of columns on both sides of its line."""
    starting = _ranges((c.x0, c.y0, c.y1) for c in columns)
    ending = _ranges((c.x1, c.y0, c.y1) for c in columns)
    corners = {x: set(ys) for x, ys in boundary.items()}
    broken = Violations()
    for x, y in sorted(swept.added):
        inside = _is_inside(starting.get(x), y) and _is_inside(ending.get(x), y)
        broken.case(inside and y not in corners.get(x, ()), (x, y))
    return broken.finding(
        "lemma-3.interior", STAGE, "all Steiner points that the sweeps add are interior to Q"
    )


def _ranges(sides: Iterable[tuple[int, int, int]]) -> dict[int, tuple[list[int], list[int]]]:
    """For each line the lower and upper ends of the disjoint sides on it, increasing."""
    lines: dict[int, tuple[list[int], list[int]]] = defaultdict(lambda: ([], []))
    for x, low, high in sorted(sides):
        lines[x][0].append(low)
        lines[x][1].append(high)
    return lines


def _is_inside(ranges: tuple[list[int], list[int]] | None, y: int) -> bool:
    """Is y strictly inside one of these disjoint ranges?"""
    if ranges is None:
        return False
    position = bisect_left(ranges[0], y) - 1
    return position >= 0 and y < ranges[1][position]


def _check_subdivisions(swept: Swept) -> Finding:
    """Between matched points of a column each side has at most one other point."""
    most = Extreme(greatest=True)
    for item in swept.columns:
        for left, right in faces_between_matches(item):
            most.offer(max(len(left), len(right)) - 2, 1, (item.column, left, right))
    return most.finding(
        "lemma-3.one-subdivision",
        STAGE,
        "after both sweeps each face has at most one subdivision point on each vertical side",
        bounds.SUBDIVISIONS_A_SIDE,
    )


def faces_between_matches(item: SweptColumn) -> list[tuple[tuple[int, ...], tuple[int, ...]]]:
    """The sides of the rectangles between heights that both sides of a column share.

    >>> column = SweptColumn(Column(0, 1, 0, 9), (0, 4, 5, 9), (0, 4, 9), ())
    >>> faces_between_matches(column)
    [((0, 4), (0, 4)), ((4, 5, 9), (4, 9))]
    """
    matched = sorted({*item.left} & {*item.right})
    faces = []
    for low, high in zip(matched, matched[1:], strict=False):
        faces.append(
            (
                item.left[bisect_left(item.left, low) : bisect_right(item.left, high)],
                item.right[bisect_left(item.right, low) : bisect_right(item.right, high)],
            )
        )
    return faces


def squared_grid_height(p: GridNode, q: GridNode, r: GridNode) -> tuple[int, int]:
    """The squared height of a triangle of grid points, as a fraction; -1 or 0 if not positive."""
    ax, ay, bx, by = q[0] - p[0], q[1] - p[1], r[0] - p[0], r[1] - p[1]
    area = ax * by - ay * bx
    if area <= 0:
        return (-1 if area < 0 else 0), 1
    cx, cy = bx - ax, by - ay
    return area * area, max(ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy)


def _check_height(swept: Swept) -> Finding:
    """Every triangle, in b^2."""
    least = Extreme()
    for item in swept.columns:
        for triangle in item.triangles:
            least.offer(*squared_grid_height(*triangle), triangle)
    return least.finding(
        "lemma-3.height",
        STAGE,
        "every triangle in Q has height at least b/sqrt(2) (squared, in b^2)",
        bounds.INTERIOR_HEIGHT_SQUARED,
    )


def components_and_holes(region: Rectilinear) -> tuple[int, int]:
    """How many loops run counter-clockwise, and how many clockwise.

    These are the components and holes of Q as a surface, where loops turn left
    at touching vertices.
    """
    positive = sum(_twice_area(loop) > 0 for loop in region.loops)
    return positive, len(region.loops) - positive


def _twice_area(loop: Sequence[GridNode]) -> int:
    return sum(loop[i - 1][0] * y - loop[i - 1][1] * x for i, (x, y) in enumerate(loop))


def _check_count(swept: Swept) -> list[Finding]:
    """T exactly, by Euler's formula, and its bound."""
    components, holes = components_and_holes(swept.region)
    sides = swept.region.edges
    triangles = sum(len(item.triangles) for item in swept.columns)
    expected = sides + 2 * len(swept.added) - 2 * components + 2 * holes
    most, euler = Extreme(greatest=True), Violations()
    most.offer(triangles, 1, {"N": sides, "holes": holes})
    euler.case(triangles == expected, {"triangles": triangles, "expected": expected})
    return [
        most.finding(
            "lemma-3.count",
            STAGE,
            "Q is triangulated with at most 4 N + 2 holes triangles",
            bounds.interior_triangles(sides, holes),
        ),
        euler.finding(
            "lemma-3.euler",
            STAGE,
            "Q has N + 2 I - 2 components + 2 holes triangles for I added points",
        ),
    ]
