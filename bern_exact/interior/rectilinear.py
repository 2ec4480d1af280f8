"""The rectilinear polygon Q that is left inside (Section 2, Definition 2)."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Sequence

from bern_exact.interior.records import Column, GridNode, Rectilinear

Dart = tuple[GridNode, GridNode]

LEFT_STRAIGHT_RIGHT = (1, 0, 3)
"""Turns in the order in which they are taken at a vertex where Q touches itself."""


def interior(touched: Iterable[Sequence[object]]) -> Rectilinear:
    """Q: the faces that no touched face is, given by its boundary.

    Section 2: "Erasing each rectangle diagonal and each edge bordering two interior
    rectangles leaves a set of rectilinear polygons".

    Parameters
    ----------
    touched : iterable of rings
        The touched faces before warping, as rings of nodes; grid vertices are pairs.

    Returns
    -------
    Rectilinear
        Bounded by the edges of touched faces whose other side is no touched face,
        reversed; none of the interior rectangles is looked at.

    Notes
    -----
    O(n log n).
    """
    darts: set[Dart] = set()
    for ring in touched:
        for i, node in enumerate(ring):
            previous = ring[i - 1]
            if isinstance(node, tuple) and isinstance(previous, tuple):
                darts.add((previous, node))
    return chained((head, tail) for tail, head in darts if (head, tail) not in darts)


def chained(darts: Iterable[Dart]) -> Rectilinear:
    """The region that these directed edges bound, interior on the left.

    Where it touches itself its sectors are kept apart.  An edge in both directions
    is a slit.  O(n log n).
    """
    outgoing: dict[GridNode, dict[int, GridNode]] = {}
    for tail, head in darts:
        outgoing.setdefault(tail, {})[_heading(tail, head)] = head
    return Rectilinear(tuple(_loops(outgoing)))


def _loops(outgoing: dict[GridNode, dict[int, GridNode]]) -> Iterator[tuple[GridNode, ...]]:
    """Chain darts into loops: after arriving, the first way on among left, straight and right."""
    used: set[tuple[GridNode, int]] = set()
    for start in sorted(outgoing):
        for first in sorted(outgoing[start]):
            loop: list[GridNode] = []
            node, heading = start, first
            while (node, heading) not in used:
                used.add((node, heading))
                loop.append(node)
                node = outgoing[node][heading]
                heading = next(
                    turned
                    for turn in LEFT_STRAIGHT_RIGHT
                    if (turned := (heading + turn) % 4) in outgoing[node]
                )
            if loop:
                yield tuple(loop)


def _heading(tail: GridNode, head: GridNode) -> int:
    """The direction of an axis-parallel dart: 0 east, 1 north, 2 west, 3 south."""
    if tail[1] == head[1]:
        return 0 if tail[0] < head[0] else 2
    return 1 if tail[1] < head[1] else 3


class UnmatchedEdge(Exception):
    """Horizontal edges that do not alternate bottom, top: Q breaks the matching condition."""


def columns(region: Rectilinear) -> tuple[Column, ...]:
    """The columns of cells of Q, by (x0, x1, y0).

    By the matching condition a vertical line runs from vertex to vertex, so a column's
    bottom and top are boundary edges with the same two abscissas: grouping the
    horizontal edges by them and sorting by ordinate pairs every bottom with its top.

    Raises
    ------
    UnmatchedEdge
        If bottoms and tops do not alternate, which refutes the matching condition.

    Notes
    -----
    O(N log N) for N boundary edges.
    """
    stacks: dict[tuple[int, int], list[tuple[int, bool]]] = {}
    for loop in region.loops:
        for i, (x, y) in enumerate(loop):
            px, py = loop[i - 1]
            if py == y:
                # Interior on the left: an edge heading east is a bottom.
                stacks.setdefault((min(px, x), max(px, x)), []).append((y, px > x))
    found = []
    for (x0, x1), stack in sorted(stacks.items()):
        stack.sort()
        if len(stack) % 2 or any(is_top != bool(i % 2) for i, (_, is_top) in enumerate(stack)):
            raise UnmatchedEdge(f"between x = {x0} and x = {x1}: {stack}")
        found += [Column(x0, x1, stack[i][0], stack[i + 1][0]) for i in range(0, len(stack), 2)]
    return tuple(found)


def ordinates(region: Rectilinear) -> dict[int, list[int]]:
    """For each vertical line the sorted ordinates of the boundary vertices on it."""
    found: dict[int, set[int]] = {}
    for loop in region.loops:
        for x, y in loop:
            found.setdefault(x, set()).add(y)
    return {x: sorted(ys) for x, ys in found.items()}


def strictly_between(values: Sequence[int], low: int, high: int) -> Sequence[int]:
    """The part of a sorted sequence strictly between two values."""
    return values[bisect_right(values, low) : bisect_left(values, high)]
