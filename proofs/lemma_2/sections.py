"""What sections of grid lines say exactly, where boxes could not: bounds that are attained.

A q-vertex in place in the middle part of its unit segment is at least tau from every grid vertex
on its line.  Let it be q, on a line through the grid vertex g, and let w be a third corner of a
triangle, at (a, c) from g, a along this line and c across it.  If |a| <= |c|, then

- the angle at g is between 45 and 135 degrees: its cotangent is a/|c|, or -a/|c|;
- the altitude on gw, |gq| |c| / |gw|, is at least tau/sqrt 2, as |gw| <= sqrt 2 |c|.

If w is on q's own ray, and this ray crosses the row of its frame through g at least tau from g,
then the altitude on qw is at least tau/sqrt 2: the ray is within 45 degrees of the upright.  For q
on that row it does; for q on the column `rays.Cross.clear` tells.  If w is a q-vertex in the
middle, too, on the other line through g, then the triangle has a right angle at g: the altitude on
qw is the product of legs of at least tau over the root of the sum of their squares, at least
tau/sqrt 2; and |qw| >= sqrt 2 tau.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

from proofs.lemma_2.rays import MIDDLE, E, turned
from proofs.lemma_2.warping import Point

Line = tuple[int, int]
"""An axis, 0 for a column x = k and 1 for a row y = k of the block, and k."""


class Aside(NamedTuple):
    """A corner of a triangle that is a grid vertex, with a q-vertex beside it.

    Parameters
    ----------
    g, q, w : int
        Which corners they are, and which is the third.
    axis : int
        0 if q is on the column through g, 1 if on the row.
    steep : bool
        Is w on q's ray, which keeps tau from g on a row of its frame?
    """

    g: int
    q: int
    w: int
    axis: int
    steep: bool


@cache
def line(cls: int, point: Point) -> Line | None:
    """The line that a q-vertex in place in the middle part of a segment is on; else None."""
    row = point[0] == "row"
    if not (row or point[0] == "column") or point[3 if row else 4] != MIDDLE:
        return None
    ends = ((0, point[2]), (1, point[2])) if row else ((point[3], 0), (point[3], 1))
    first, second = (turned(0 if point[1] == E else cls, node) for node in ends)
    axis = 0 if first[0] == second[0] else 1
    return axis, first[axis]


def is_on(node: Point, where: Line | None) -> bool:
    """Is a point a grid vertex on this line?"""
    return bool(node[0] == "g" and where is not None and node[1 + where[0]] == where[1])


def is_on_ray(point: Point, ray: int) -> bool:
    """Is a point on a ray wherever it is: v, a q-vertex in place or slid along it?"""
    if point[0] == "slid":
        point = point[1]
    return bool(point[0] == "v" or (point[0] != "g" and point[1] == ray))


def is_clear(cls: int, q: Point, node: Point) -> bool:
    """Does the ray of q, which is beside a grid vertex, cross the row there at least tau away?"""
    if q[0] == "row":
        return True
    _, ray, level, column, _, clear = q
    quarters = 0 if ray == E else cls
    return any(clear & 1 << i and turned(quarters, (column, level + i)) == node[1:] for i in (0, 1))


@cache
def asides(cls: int, corners: tuple[Point, Point, Point]) -> tuple[Aside, ...]:
    """All pairs of a grid vertex and a q-vertex beside it among a triangle's corners."""
    return tuple(_asides(cls, corners))


def _asides(cls: int, corners: tuple[Point, Point, Point]) -> Iterator[Aside]:
    for g in range(3):
        for q, w in (((g + 1) % 3, (g + 2) % 3), ((g + 2) % 3, (g + 1) % 3)):
            where = line(cls, corners[q])
            if where is not None and is_on(corners[g], where):
                steep = is_clear(cls, corners[q], corners[g]) and is_on_ray(
                    corners[w], corners[q][1]
                )
                yield Aside(g, q, w, where[0], steep)


@cache
def is_long(cls: int, p: Point, q: Point) -> bool:
    """Do sections tell that two points are at least tau apart?"""
    lines = line(cls, p), line(cls, q)
    if p[0] == q[0] == "g":
        return p != q
    if is_on(p, lines[1]) or is_on(q, lines[0]):
        return True
    # Each is at least tau from where the two lines cross.
    return lines[0] is not None and lines[1] is not None and lines[0][0] != lines[1][0]
