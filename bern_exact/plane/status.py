"""What the plane sweeps share: the order of events, and the status as a flat list.

Every sweep goes over the vertices in lexicographic order.  That is a sweep by a vertical line
after an infinitesimal shear, so vertical edges and vertices of equal x need no cases of their
own: an edge is directed from its lexicographically smaller end to its larger one, and a point is
above it exactly if it lies to its left (a shear keeps orientations).

The status is a plain list of edges, from bottom to top, searched by bisection.  Its insertions
and deletions are moves of memory, for 100,000 edges still faster than any balanced tree in Python.
"""

from __future__ import annotations

from collections.abc import Sequence

from gmpy2 import mpq

from bern_exact.exact.points import HPoint, Line, line_through
from bern_exact.exact.predicates import orientation


def lexicographic_ranks(points: Sequence[HPoint]) -> tuple[list[int], list[int]]:
    """The indices of the points in lexicographic order, and for each point its rank.

    Equal points keep the order of their indices.  O(n log n).

    >>> from bern_exact.exact.points import grid_point
    >>> lexicographic_ranks([grid_point(1, 0), grid_point(0, 5), grid_point(0, 2)])
    ([2, 1, 0], [2, 1, 0])
    """
    keys = [(mpq(x, w), mpq(y, w)) for x, y, w in points]
    order = sorted(range(len(points)), key=keys.__getitem__)
    rank = [0] * len(points)
    for position, v in enumerate(order):
        rank[v] = position
    return order, rank


def rightward_lines(
    points: Sequence[HPoint], after: Sequence[int], rank: Sequence[int] | Sequence[mpq]
) -> list[Line]:
    """The line of each edge, directed from its end of lower rank (or x): positive above."""
    return [
        line_through(points[v], points[w])
        if rank[v] < rank[w]
        else line_through(points[w], points[v])
        for v, w in enumerate(after)
    ]


def count_below(status: Sequence[int], lines: Sequence[Line], p: HPoint) -> int:
    """How many edges of the status run strictly below p.  O(log of the status)."""
    x, y, w = p
    low, high = 0, len(status)
    while low < high:
        middle = (low + high) >> 1
        a, b, c = lines[status[middle]]
        if a * x + b * y + c * w > 0:
            low = middle + 1
        else:
            high = middle
    return low


def beginning_edges(
    points: Sequence[HPoint],
    v: int,
    previous: int,
    following: int,
    rank: Sequence[int] | Sequence[mpq],
) -> list[int]:
    """The edges at v that lead to a vertex of higher rank (or x), the lower one first.

    Parameters
    ----------
    previous, following : int
        The vertices before and after v along its ring; the edges at v are named `previous` and v.
    """
    beginning = [e for e, end in ((previous, previous), (v, following)) if rank[end] > rank[v]]
    if len(beginning) == 2 and orientation(points[v], points[previous], points[following]) < 0:
        beginning.reverse()
    return beginning
