"""Lemma 7: triangulate a matching subdivided rectangle with angles of at most 135 degrees."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from bern_exact.interior.subdivided.records import (
    HalfNode,
    Partition,
    SubdividedRectangle,
    Tiled,
    Tiling,
)

Triangle = tuple[HalfNode, HalfNode, HalfNode]


def tile(partition: Partition) -> Tiled:
    """Triangulate every rectangle of a partition (Lemma 7).  Linear in the output."""
    return Tiled(partition, tuple(triangulate(r) for r in partition.rectangles))


def triangulate(rectangle: SubdividedRectangle) -> Tiling:
    """Triangulate one matching subdivided rectangle, adding points to its interior only.

    Lemma 7: "A subdivided rectangle, satisfying the matching condition, with subdivision
    points at least b apart, can be triangulated into O(n) triangles with maximum angle 135
    and minimum height Omega(s), adding Steiner points only to its interior."

    Parameters
    ----------
    rectangle : SubdividedRectangle
        With equal subdivisions on opposite sides.

    Returns
    -------
    Tiling
        Angles at most 135 degrees; heights at least beta/sqrt 5 for the least spacing
        beta of neighbouring vertices on a side.  Coordinates are in half units, since the
        Steiner points lie midway between the two longer sides.

    Notes
    -----
    - With a pair of opposite sides unsubdivided the partners on the other pair are joined,
      and each piece is cut by a diagonal: no Steiner point.
    - A rectangle no longer than its width plus 2 beta gets one Steiner point, its centre.
    - Where the lines between partners cut it into so few cells that two triangles for each are
      no more than what follows, those are taken: right angles, and heights of beta/sqrt 2.
    - Otherwise Steiner points go on the long axis.  The printed choice of the outermost ones
      (v/2 - b <= d <= v/2 + b) admits d = 0, on the boundary, and angles of 143 degrees.  Here
      d = v/2, unless a subdivision projects to within beta of there: then d is that
      projection, the nearest of several.

    Linear in the number of vertices.

    >>> len(triangulate(SubdividedRectangle(0, 2, 0, 2, (1,), (1,), (1,), (1,))).triangles)
    8
    """
    x0, x1, y0, y1, left, _, bottom, _ = rectangle
    if x1 - x0 >= y1 - y0:
        steiner, triangles = _lying(_doubled(x0, bottom, x1), _doubled(y0, left, y1))
        return Tiling(rectangle, tuple(steiner), tuple(triangles))
    steiner, triangles = _lying(_doubled(y0, left, y1), _doubled(x0, bottom, x1))
    # Swapping the axes turns triangles round: so does swapping two corners.
    return Tiling(
        rectangle,
        tuple((x, y) for y, x in steiner),
        tuple(((p[1], p[0]), (r[1], r[0]), (q[1], q[0])) for p, q, r in triangles),
    )


def steiner_points(rectangle: SubdividedRectangle) -> int:
    """How many Steiner points `triangulate` adds, without the triangles."""
    x0, x1, y0, y1, left, _, bottom, _ = rectangle
    xs, ys = _doubled(x0, bottom, x1), _doubled(y0, left, y1)
    if x1 - x0 < y1 - y0:
        xs, ys = ys, xs
    on_axis = len(_axis(xs, ys))
    return (len(xs) - 2) * (len(ys) - 2) if _cells_are_fewer(xs, ys, on_axis) else on_axis


def triangles_of(rectangle: SubdividedRectangle) -> int:
    """How many triangles `triangulate` makes: vertices on the boundary + 2 Steiner points - 2."""
    on_boundary = 4 + 2 * (len(rectangle.left) + len(rectangle.bottom))
    return on_boundary + 2 * steiner_points(rectangle) - 2


def _doubled(low: int, inside: Sequence[int], high: int) -> list[int]:
    """All coordinates on a side, in half units."""
    return [2 * c for c in (low, *inside, high)]


def _lying(xs: Sequence[int], ys: Sequence[int]) -> tuple[list[HalfNode], list[Triangle]]:
    """Steiner points and triangles of a rectangle at least as long (in x) as it is high."""
    axis = _axis(xs, ys)
    if axis and _cells_are_fewer(xs, ys, len(axis)):
        inner = [(x, y) for x in xs[1:-1] for y in ys[1:-1]]
        return inner, [t for low, high in pairwise(ys) for t in _ladder(xs, (low, high))]
    if axis:
        middle = (ys[0] + ys[-1]) // 2
        return [(x, middle) for x in axis], list(_around(xs, ys, axis, middle))
    return [], list(_ladder(xs, ys) if len(ys) == 2 else _steps(xs, ys))


def _cells_are_fewer(xs: Sequence[int], ys: Sequence[int], on_axis: int) -> bool:
    """Have the lines between partners no more crossings than there would be Steiner points?"""
    return (len(xs) - 2) * (len(ys) - 2) <= on_axis


def _axis(xs: Sequence[int], ys: Sequence[int]) -> list[int]:
    """The abscissas of the Steiner points, all at mid-height; none if none is needed."""
    if len(xs) == 2 or len(ys) == 2:
        return []
    length, height = xs[-1] - xs[0], ys[-1] - ys[0]
    beta = min(b - a for side in (xs, ys) for a, b in pairwise(side))
    if length <= height + 2 * beta:
        return [(xs[0] + xs[-1]) // 2]
    first = _outermost(xs[1:-1], xs[0] + height // 2, beta)
    last = _outermost(xs[-2:0:-1], xs[-1] - height // 2, beta)
    if first == last:
        return [first]
    return [first, *(x for x in xs[1:-1] if first < x < last), last]


def _outermost(inside: Sequence[int], ideal: int, beta: int) -> int:
    """The projection nearest to the ideal abscissa among those within beta of it, else that."""
    near = [x for x in inside if abs(x - ideal) < beta]
    return min(near, key=lambda x: abs(x - ideal), default=ideal)


def _ladder(xs: Sequence[int], ys: Sequence[int]) -> Iterator[Triangle]:
    """Vertical sides unsubdivided: join partners, cut each piece by its rising diagonal."""
    low, high = ys
    for a, b in pairwise(xs):
        yield ((a, low), (b, low), (b, high))
        yield ((a, low), (b, high), (a, high))


def _steps(xs: Sequence[int], ys: Sequence[int]) -> Iterator[Triangle]:
    """Horizontal sides unsubdivided: the same, turned."""
    left, right = xs
    for a, b in pairwise(ys):
        yield ((left, a), (right, a), (right, b))
        yield ((left, a), (right, b), (left, b))


def _around(
    xs: Sequence[int], ys: Sequence[int], axis: Sequence[int], middle: int
) -> Iterator[Triangle]:
    """Join the Steiner points to the four sides."""
    first, last = (axis[0], middle), (axis[-1], middle)
    for a, b in pairwise(ys):
        yield (first, (xs[0], b), (xs[0], a))
        yield (last, (xs[-1], a), (xs[-1], b))
    for y in (ys[0], ys[-1]):
        for p, q, r in _strip(axis, xs, middle, y):
            yield (p, q, r) if y > middle else (p, r, q)


def _strip(axis: Sequence[int], side: Sequence[int], middle: int, y: int) -> Iterator[Triangle]:
    """Triangles between the axis and a horizontal side, counter-clockwise if it lies above."""
    i = j = 0
    while i + 1 < len(axis) or j + 1 < len(side):
        here, there = (axis[i], middle), (side[j], y)
        if _side_goes_on(axis, side, i, j, abs(y - middle)):
            yield (here, (side[j + 1], y), there)
            j += 1
        else:
            yield (here, (axis[i + 1], middle), there)
            i += 1


def _side_goes_on(axis: Sequence[int], side: Sequence[int], i: int, j: int, rise: int) -> bool:
    """Is the next triangle's base on the side rather than on the axis?

    No subdivision lies strictly between neighbouring Steiner points, so that where both
    could go on, they bound a trapezoid with a choice of two diagonals.
    """
    if i + 1 == len(axis):
        return True
    if j + 1 == len(side) or side[j] > axis[i]:
        return False
    s, t = axis[i], side[j]
    s_next, t_next = axis[i + 1], side[j + 1]
    if t_next <= s:
        return True
    # The diagonal from s to t_next: only the angles at s and at s_next can be above 135.
    dot_and_cross = (t - s) * (t_next - s) + rise * rise + (t_next - t) * rise
    return dot_and_cross >= 0 and t_next - s_next <= rise
