"""Where sides of a mesh meet other than in common endpoints: all such places, or the first few."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gmpy2 import mpq

from bern_exact.exact.points import HPoint, coordinates, direction
from bern_exact.exact.predicates import dot, orientation
from bern_exact.oracle.side_sweep import Side

Conflict = tuple[str, int, int]
"""`("crossing", i, j)` for sides i < j, `("hanging", i, v)` for a vertex v inside side i."""

Box = tuple[mpq, mpq, mpq, mpq]
"""Left, right, low, high."""

MANY = 10_000
"""So many conflicts are found by one sweep; where there are more, the first are looked for."""


def conflicts(
    vertices: Sequence[HPoint], sides: Sequence[Side], limit: int, many: int = MANY
) -> list[Conflict]:
    """Where sides meet other than in common endpoints.

    Returns
    -------
    list of Conflict
        The first `limit`, sorted, each once.

    Notes
    -----
    Only sides whose bounding boxes meet are compared: a sweep over x, quadratic at worst.  Where it
    finds `many` conflicts (and more than `limit`), it is given up, and each side is compared with
    all others until `limit` are found: among many conflicts, that is soon.

    Examples
    --------
    >>> from bern_exact.exact.points import grid_point
    >>> points = [grid_point(x, y) for x, y in [(0, 0), (2, 2), (0, 2), (2, 0)]]
    >>> conflicts(points, [(0, 1, 1), (2, 3, 1)], 5)
    [('crossing', 0, 1)]
    """
    boxes = [box(coordinates(vertices[a]), coordinates(vertices[b])) for a, b, _ in sides]
    found: set[Conflict] = set()
    for met in _by_sweep(vertices, sides, boxes):
        found.update(met)
        if len(found) > max(many, limit):
            return _first(vertices, sides, boxes, limit)
    return sorted(found)[:limit]


def box(p: tuple[mpq, mpq], q: tuple[mpq, mpq]) -> Box:
    """Left, right, low, high of a segment."""
    return min(p[0], q[0]), max(p[0], q[0]), min(p[1], q[1]), max(p[1], q[1])


def _by_sweep(
    vertices: Sequence[HPoint], sides: Sequence[Side], boxes: Sequence[Box]
) -> Iterator[Iterator[Conflict]]:
    """The conflicts of each two sides whose boxes meet, in the order of x."""
    active: list[int] = []
    for j in sorted(range(len(sides)), key=lambda j: boxes[j][0]):
        left, _, low, high = boxes[j]
        active = [i for i in active if boxes[i][1] >= left]
        for i in active:
            if boxes[i][2] <= high and low <= boxes[i][3]:
                yield _meeting(vertices, sides, i, j)
        active.append(j)


def _first(
    vertices: Sequence[HPoint], sides: Sequence[Side], boxes: Sequence[Box], limit: int
) -> list[Conflict]:
    """The first conflicts in their order, which is that of the kinds and then of the sides."""
    found: list[Conflict] = []
    for kind in ("crossing", "hanging"):
        for i, (left, right, low, high) in enumerate(boxes):
            if len(found) >= limit:
                return found[:limit]
            own = {
                conflict
                for j, (start, end, bottom, top) in enumerate(boxes)
                if j != i and start <= right and left <= end and bottom <= high and low <= top
                for conflict in _meeting(vertices, sides, i, j)
                if conflict[:2] == (kind, i)
            }
            found += sorted(own)
    return found[:limit]


def _meeting(
    vertices: Sequence[HPoint], sides: Sequence[Side], i: int, j: int
) -> Iterator[Conflict]:
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
