"""Lemma 3: the interior with O(n) triangles, by two sweeps that project every other point."""

from __future__ import annotations

from bisect import insort
from collections.abc import Callable, Iterator, Sequence

from bern_exact.interior.records import Column, GridNode, Rectilinear, Swept, SweptColumn
from bern_exact.interior.rectilinear import columns, ordinates, strictly_between


def sweep(region: Rectilinear) -> Swept:
    """Triangulate Q with O(N) triangles, adding Steiner points to its interior only.

    Lemma 3: "First draw in all interior vertical line segments between vertices of Q.
    We treat these verticals in order from left to right.  We horizontally project every
    other vertex from the leftmost vertical line onto the next vertical line."  "The next
    vertical line" means the other side of the same column.  Of the points strictly inside a
    side the 2nd, 4th, ... are projected, which adds fewer than the printed 1st, 3rd, ...

    Parameters
    ----------
    region : Rectilinear
        Q, satisfying the matching condition.

    Returns
    -------
    Swept
        Each column with the points on its sides, triangulated.

    Notes
    -----
    A projected point never falls inside a boundary edge: its horizontal line is that of a
    vertex, and runs on to another vertex.  O(N log N).
    """
    return _swept(region, _project_every_other)


class TooManyTriangles(ValueError):
    """The whole grid would have more triangles than the limit."""


def whole_grid(region: Rectilinear, limit: int) -> Swept:
    """Every interior rectangle split by a diagonal: the O(N^2) size that Lemma 3 improves on.

    Section 2: "a triangulation with good height, with O(n) triangles intersecting the
    boundary and O(n^2) rectangles (split by diagonals) interior".

    Parameters
    ----------
    region : Rectilinear
        Q, satisfying the matching condition.
    limit : int
        The most triangles.

    Raises
    ------
    TooManyTriangles
        As soon as it is clear that there would be more.
    """
    budget = limit

    def project_all(column: Column, source: Sequence[int], target: list[int]) -> None:
        nonlocal budget
        present = set(strictly_between(target, column.y0, column.y1))
        fresh = set(strictly_between(source, column.y0, column.y1)) - present
        # Each new point on a side splits at least one cell: two more triangles.
        budget -= 2 * len(fresh)
        if budget < 0:
            raise TooManyTriangles(f"the whole grid has more than {limit:,} triangles")
        for y in sorted(fresh):
            insort(target, y)

    swept = _swept(region, project_all)
    count = sum(len(column.triangles) for column in swept.columns)
    if count > limit:
        raise TooManyTriangles(f"the whole grid has {count:,} triangles, more than {limit:,}")
    return swept


Projector = Callable[[Column, Sequence[int], list[int]], None]


def _swept(region: Rectilinear, project: Projector) -> Swept:
    """Sweep right, then left, and triangulate each column."""
    on_line = ordinates(region)
    boundary = {(x, y) for x, ys in on_line.items() for y in ys}
    cells = columns(region)
    for column in sorted(cells, key=lambda c: (c.x0, c.x1, c.y0)):
        project(column, on_line[column.x0], on_line[column.x1])
    for column in sorted(cells, key=lambda c: (-c.x1, -c.x0, c.y0)):
        project(column, on_line[column.x1], on_line[column.x0])
    swept = []
    for column in sorted(cells, key=lambda c: (c.x0, c.y0)):
        left = _side(column, on_line[column.x0])
        right = _side(column, on_line[column.x1])
        swept.append(SweptColumn(column, left, right, tuple(_ladder(column, left, right))))
    added = frozenset((x, y) for x, ys in on_line.items() for y in ys) - boundary
    return Swept(region, tuple(swept), added)


def _project_every_other(column: Column, source: Sequence[int], target: list[int]) -> None:
    """Project every other point strictly inside one side of a column onto the other side."""
    present = set(strictly_between(target, column.y0, column.y1))
    for y in list(strictly_between(source, column.y0, column.y1))[1::2]:
        if y not in present:
            insort(target, y)


def _side(column: Column, on_line: Sequence[int]) -> tuple[int, ...]:
    """All points of one side of a column, corners included."""
    return (column.y0, *strictly_between(on_line, column.y0, column.y1), column.y1)


def _ladder(
    column: Column, left: Sequence[int], right: Sequence[int]
) -> Iterator[tuple[GridNode, GridNode, GridNode]]:
    """Triangles between the two sides, from the bottom up.

    The printed "zig-zag" has heights near 0 on tall columns.  Instead the side with the
    lower next point advances, and of two level ones the side that is behind.  With at
    most one subdivision a side between matched points the apex is then level with the base:
    no triangle has an obtuse angle at its base, and its height is at least 1/sqrt 2.
    """
    x0, x1 = column.x0, column.x1
    end = (column.y1 + 1, 0)
    i = j = 0
    while i + 1 < len(left) or j + 1 < len(right):
        next_left = (left[i + 1], left[i]) if i + 1 < len(left) else end
        next_right = (right[j + 1], right[j]) if j + 1 < len(right) else end
        if next_left <= next_right:
            yield ((x0, left[i]), (x1, right[j]), (x0, left[i + 1]))
            i += 1
        else:
            yield ((x0, left[i]), (x1, right[j]), (x1, right[j + 1]))
            j += 1
