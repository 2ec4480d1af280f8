"""Dicing: the kept intervals of the grid lines around each vertex (Section 2).

The paper draws the whole grid and erases most of it.  Here only what
remains is ever made: for each vertex v and each of the eight lines of its
block, the maximal intervals inside P' that contain a piece of the line
within the block and the wedge of v, at most 16 a vertex (six lines and 12
intervals, if the block is that round the nearest corner).  Their crossings,
Theta(n^2) of them in the worst case, are never listed.

As s' >= 8 > 2 sqrt 2, or > 3 sqrt 2 in every grid allowed, nothing of the
boundary but the two edges at v comes into the block on v's sheet: the sheet
is the block intersected with the wedge, and the paper's Riemann sheets need not be copied anywhere.
"""

from __future__ import annotations

from collections.abc import Sequence

from gmpy2 import f_div, mpq

from bern_exact.boundary.blocks import block_at, block_of
from bern_exact.boundary.frame import Degenerate
from bern_exact.boundary.records import (
    HORIZONTAL,
    VERTICAL,
    BlockShape,
    Crossing,
    Diced,
    Framed,
    Interval,
)
from bern_exact.exact.points import HPoint, Line, grid_point, reduced
from bern_exact.exact.predicates import is_in_wedge
from bern_exact.plane.ray_shooting import edges_around


def dice(framed: Framed) -> Diced:
    """Keep the intervals around every vertex.

    Section 2: "erase all parts of remaining grid lines, except the boundaries of
    occupied and neighbor squares that intersect P' and the segments that support
    occupied and neighbor squares".

    Parameters
    ----------
    framed : Framed
        P' over the unit grid, in general position.

    Raises
    ------
    Degenerate
        If an edge passes through a grid point on a kept line.

    Notes
    -----
    O(n log n): two sweeps answer all ray-shooting queries.
    """
    polygon = framed.polygon
    shape = framed.blocks
    vertical = _intervals(polygon.points, polygon.after, polygon.lines, VERTICAL, shape)
    # Swapping x and y turns horizontal lines into vertical ones.
    mirrored = tuple((y, x, w) for x, y, w in polygon.points)
    horizontal = _intervals(
        mirrored, polygon.after, tuple((b, a, c) for a, b, c in polygon.lines), HORIZONTAL, shape
    )
    crossings = _crossings(polygon.lines, vertical, horizontal)
    blocks = [block_at(framed, v) for v in range(polygon.n)]
    return Diced(
        framed,
        vertical,
        horizontal,
        crossings,
        _order_along_edges(framed, crossings),
        tuple(sorted({k for low, high in blocks for k in range(low[0], high[0] + 1)})),
        tuple(sorted({k for low, high in blocks for k in range(low[1], high[1] + 1)})),
    )


def _intervals(
    points: Sequence[HPoint],
    after: Sequence[int],
    lines: Sequence[Line],
    axis: int,
    shape: BlockShape,
) -> tuple[Interval, ...]:
    """The kept intervals of vertical lines (of horizontal ones, given mirrored points)."""
    seeds: list[tuple[int, int]] = []
    queries: list[HPoint] = []
    before = [0] * len(points)
    for v, w in enumerate(after):
        before[w] = v
    for v in range(len(points)):
        for line, edge, point in _seeds(points, before, after, lines, v, axis, shape):
            seeds.append((line, edge))
            queries.append(point)
    high_of: dict[tuple[int, int], int] = {}
    for (line, edge), (below, above) in zip(
        seeds, edges_around(points, after, queries), strict=True
    ):
        if edge < 0:
            high_of[line, below] = above
        elif _interior_is_above(lines[edge]):
            high_of[line, edge] = above
        else:
            high_of[line, below] = edge
    intervals = [Interval(line, low, high) for (line, low), high in high_of.items()]
    return tuple(sorted(intervals, key=lambda i: (i.line, _height(lines[i.low], i.line))))


def _interior_is_above(line: Line) -> bool:
    """Is the interior above the edge with this line (in mirrored coordinates too)?

    The form a x + b y + c is positive on the interior side, and above the line if b > 0.
    """
    return bool(line[1] > 0)


def _seeds(
    points: Sequence[HPoint],
    before: Sequence[int],
    after: Sequence[int],
    lines: Sequence[Line],
    v: int,
    axis: int,
    shape: BlockShape,
) -> list[tuple[int, int, HPoint]]:
    """Points on the pieces of the vertical block lines in the sheet of v.

    Each seed is (line, edge, point): the point where an edge of v crosses the line
    within the block, or with edge -1 a grid point of a piece that no edge crosses.
    """
    low, high = block_of(points[v], shape)
    rays = ((v, after[v]), (before[v], before[v]))  # (edge, its other end)
    seeds = []
    for k in range(low[0], high[0] + 1):
        hits = []
        for edge, end in rays:
            # The edge leaves v towards its other end; it crosses x = k on that side only.
            leftwards = points[end][0] * points[v][2] < points[v][0] * points[end][2]
            if leftwards != (k * points[v][2] < points[v][0]):
                continue
            a, b, c = lines[edge]
            y = reduced(b * k, -(a * k + c), b)
            if y[1] % y[2] == 0:
                raise Degenerate("an edge passes through a grid point")
            if low[1] <= f_div(y[1], y[2]) < high[1]:
                hits.append((k, edge, y))
        if hits:
            seeds += hits
            continue
        node = grid_point(k, low[1] + 1)
        ends = (points[before[v]], points[after[v]])
        if axis == HORIZONTAL:  # mirroring reverses the turn round v
            ends = (ends[1], ends[0])
        if is_in_wedge(node, ends[0], points[v], ends[1]):
            seeds.append((k, -1, node))
    return seeds


def _height(line: Line, k: int) -> mpq:
    """The y-coordinate at which a line that is not vertical crosses x = k."""
    a, b, c = line
    return mpq(-(a * k + c), b)


def _crossings(
    lines: Sequence[Line], vertical: Sequence[Interval], horizontal: Sequence[Interval]
) -> tuple[Crossing, ...]:
    """The ends of all intervals: the lower and the upper end of each, in order."""
    crossings = []
    for axis, intervals in ((VERTICAL, vertical), (HORIZONTAL, horizontal)):
        for k, low, high in intervals:
            for edge, far in ((low, high), (high, low)):
                a, b, c = lines[edge]
                at = _height((a, b, c) if axis == VERTICAL else (b, a, c), k)
                if at.denominator == 1:
                    raise Degenerate("an edge passes through a grid point")
                crossings.append(Crossing(axis, k, edge, at, far))
    return tuple(crossings)


def _order_along_edges(
    framed: Framed, crossings: Sequence[Crossing]
) -> tuple[tuple[int, ...], ...]:
    """For each edge its crossings from tail to head."""
    on_edge: list[list[tuple[mpq, int]]] = [[] for _ in framed.polygon.points]
    for j, q in enumerate(crossings):
        x = mpq(q.line) if q.axis == VERTICAL else q.at
        on_edge[q.edge].append((x, j))
    ordered = []
    for edge, found in enumerate(on_edge):
        leftwards = framed.polygon.lines[edge][1] < 0
        ordered.append(tuple(j for _, j in sorted(found, reverse=leftwards)))
    return tuple(ordered)
