"""Vertical ray shooting among a polygon's edges, for many points at once.

Dicing (Section 2) draws grid lines through the polygon: the edges that stop them below and above
a point are found for all points in one sweep.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

from gmpy2 import mpq

from bern_exact.exact.points import HPoint, Line
from bern_exact.plane.status import (
    beginning_edges,
    count_below,
    lexicographic_ranks,
    rightward_lines,
)

Events = Iterator[tuple[mpq, list[int]]]


def edges_around(
    points: Sequence[HPoint], after: Sequence[int], queries: Sequence[HPoint]
) -> list[tuple[int, int]]:
    """For each query point the edges first met strictly below and strictly above it.

    Parameters
    ----------
    points : sequence of HPoint
        The vertices.
    after : sequence of int
        The next vertex along the ring, a permutation; edge i joins vertices i and `after[i]`.
        Edges meet at common vertices only.  The orientation of the rings does not matter.
    queries : sequence of HPoint
        Any points, repeated ones too, whose x is no vertex's x.

    Returns
    -------
    list of (int, int)
        For each query (below, above): the edges, by tail, that the vertical line through it meets
        next; -1 if there is none.  Edges that pass exactly through the point are skipped.

    Raises
    ------
    ValueError
        If an edge is vertical or a query has the x of a vertex: its vertical line would meet a
        vertex, and the answer would not be one edge.

    Notes
    -----
    A sweep from left to right: O((n + m) log(n + m)) for m queries.

    Examples
    --------
    >>> from bern_exact.exact.points import grid_point
    >>> triangle = [grid_point(0, 0), grid_point(9, 1), grid_point(1, 9)]
    >>> edges_around(triangle, [1, 2, 0], [grid_point(5, 2), grid_point(5, 9), grid_point(12, 0)])
    [(0, 1), (1, -1), (-1, -1)]
    """
    xs = [mpq(p[0], p[2]) for p in points]
    for tail, head in enumerate(after):
        if xs[tail] == xs[head]:
            raise ValueError(f"edge {tail} is vertical")
    vertices = _by_x(xs)
    lines = rightward_lines(points, after, xs)
    before = _inverse(after)
    answers = [(-1, -1)] * len(queries)
    status: list[int] = []
    x, batch = next(vertices, (None, []))
    for query_x, asked in _by_x([mpq(q[0], q[2]) for q in queries]):
        while x is not None and x < query_x:
            for v in batch:
                position = count_below(status, lines, points[v])
                _pass_vertex(status, position, points, v, before[v], after[v], xs)
            x, batch = next(vertices, (None, []))
        if x == query_x:
            raise ValueError(f"query {asked[0]} has the x of vertex {batch[0]}")
        for i in asked:
            answers[i] = _neighbours(status, lines, queries[i])
    return answers


def edges_around_vertices(points: Sequence[HPoint], after: Sequence[int]) -> list[tuple[int, int]]:
    """For each vertex the edges first met below and above it, other than its own.

    Parameters
    ----------
    points, after
        As for `edges_around`; here vertical edges are allowed.

    Returns
    -------
    list of (int, int)
        (below, above), by tail; -1 if there is none.  Edges at the vertex itself do not count,
        on whichever side of them the ray runs.

    Notes
    -----
    The vertical is turned infinitesimally, its upper end to the left, so that it meets no second
    vertex and runs along no edge.  O(n log n).

    Examples
    --------
    >>> from bern_exact.exact.points import grid_point
    >>> square = [grid_point(0, 0), grid_point(2, 0), grid_point(2, 2), grid_point(0, 2)]
    >>> edges_around_vertices(square, [1, 2, 3, 0])
    [(-1, -1), (-1, 2), (-1, -1), (0, -1)]
    """
    order, rank = lexicographic_ranks(points)
    lines = rightward_lines(points, after, rank)
    before = _inverse(after)
    answers = [(-1, -1)] * len(points)
    status: list[int] = []
    for v in order:
        position = count_below(status, lines, points[v])
        added = _pass_vertex(status, position, points, v, before[v], after[v], rank)
        below = status[position - 1] if position else -1
        beyond = position + added
        answers[v] = below, status[beyond] if beyond < len(status) else -1
    return answers


def _inverse(after: Sequence[int]) -> list[int]:
    """For each vertex the previous one along its ring."""
    before = [0] * len(after)
    for tail, head in enumerate(after):
        before[head] = tail
    return before


def _by_x(xs: Sequence[mpq]) -> Events:
    """The indices by increasing x, those of equal x together."""
    order = sorted(range(len(xs)), key=xs.__getitem__)
    for x, group in groupby(order, key=xs.__getitem__):
        yield x, list(group)


def _pass_vertex(
    status: list[int],
    position: int,
    points: Sequence[HPoint],
    v: int,
    previous: int,
    following: int,
    rank: Sequence[int] | Sequence[mpq],
) -> int:
    """Replace the edges that end at vertex v by those that begin there; how many these are."""
    beginning = beginning_edges(points, v, previous, following, rank)
    status[position : position + 2 - len(beginning)] = beginning
    return len(beginning)


def _neighbours(status: Sequence[int], lines: Sequence[Line], q: HPoint) -> tuple[int, int]:
    """The edges of the status next below and next above q."""
    x, y, w = q
    above = below = count_below(status, lines, q)
    while above < len(status):
        a, b, c = lines[status[above]]
        if a * x + b * y + c * w < 0:
            break
        above += 1
    return status[below - 1] if below else -1, status[above] if above < len(status) else -1
