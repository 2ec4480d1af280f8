"""The edges first met above and below each vertex: one plane sweep over a valid polygon."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cmp_to_key

from bern_exact.exact.points import HPoint
from bern_exact.exact.predicates import compare_xy, orientation


def first_edges(points: Sequence[HPoint], after: Sequence[int]) -> list[tuple[int, int]]:
    """For each vertex the first edges that the upward and the downward ray from it meet.

    The rays are vertical but for an infinitesimal turn to the left (upward) and
    right (downward), which is to say that vertices are swept in lexicographic
    order.  Edges at the vertex itself do not count.

    Parameters
    ----------
    points : sequence of HPoint
        The vertices of a valid polygon: its edges meet at common ends only.
    after : sequence of int
        The edges i -> after[i].

    Returns
    -------
    list of (int, int)
        For each vertex (below, above): edges as indices of tails, -1 if none.

    Examples
    --------
    >>> from bern_exact.exact.points import hpoint
    >>> box = [hpoint(0, 0), hpoint(4, 0), hpoint(4, 3), hpoint(2, 1), hpoint(0, 3)]
    >>> first_edges(box, [1, 2, 3, 4, 0])[3]
    (0, -1)
    """

    def before(v: int, w: int) -> int:
        return compare_xy(points[v], points[w])

    order = sorted(range(len(points)), key=cmp_to_key(before))
    rank = [0] * len(points)
    for position, v in enumerate(order):
        rank[v] = position
    ends: list[list[int]] = [[] for _ in points]
    for tail, head in enumerate(after):
        ends[tail].append(tail)
        ends[head].append(tail)
    # The left and right end of each edge in the order of the sweep.
    left = [t if rank[t] < rank[h] else h for t, h in enumerate(after)]
    right = [h if rank[t] < rank[h] else t for t, h in enumerate(after)]
    status: list[int] = []  # the edges across the sweep line, from below upwards
    result = [(-1, -1)] * len(points)
    for v in order:
        p = points[v]
        low = _first_not_below(status, points, left, right, p)
        high = low
        while high < len(status) and right[status[high]] == v:
            high += 1
        below = status[low - 1] if low else -1
        above = status[high] if high < len(status) else -1
        result[v] = (below, above)
        starting = [e for e in ends[v] if left[e] == v]
        if len(starting) == 2 and orientation(p, *(points[right[e]] for e in starting)) < 0:
            starting.reverse()
        status[low:high] = starting
    return result


def _first_not_below(
    status: Sequence[int],
    points: Sequence[HPoint],
    left: Sequence[int],
    right: Sequence[int],
    p: HPoint,
) -> int:
    """The index of the first edge in the status that passes through p or above it."""
    low, high = 0, len(status)
    while low < high:
        middle = (low + high) // 2
        edge = status[middle]
        if orientation(points[left[edge]], points[right[edge]], p) > 0:
            low = middle + 1
        else:
            high = middle
    return low
