"""Which way P' is turned over the grid: close to the axes where most of its edges let it be.

The paper turns the polygon "so that no edge is horizontal or vertical".  Any rotation will do, but
an edge that is nearly axis-parallel crosses few grid lines, and so has few faces along it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from gmpy2 import mpq

from bern_exact.exact.points import direction
from bern_exact.exact.roots import sqrt_below
from bern_exact.exact.similarity import Similarity
from bern_exact.plane.polygon import Polygon

SMALL = 100_000
"""The rotation away from the axes is 2 arctan(1/100000), about 0.001 degrees."""

SPREAD = mpq(1, 1000)
"""Edges share two perpendicular directions if their directions differ by no more than this, as
y/(x + y) of the direction turned into the first quadrant: about 0.1 degrees."""

SHARE = mpq(1, 2)
"""A pair of directions is worth a turn if more than this part of the boundary's length has it."""

ROOT_BITS = 64
"""Significant bits of the length of an edge, and ..."""

TURN_BITS = 24
"""... fractional bits of the half angle's tangent: less than a hundredth of the small rotation."""


class Side(NamedTuple):
    """An edge turned into the first quadrant.

    Parameters
    ----------
    angle : mpq
        y/(x + y): from 0 to 1 as the direction turns through the quadrant.
    x, y : mpq
        x > 0 and y >= 0.
    length : mpq
        Its length, rounded down.
    """

    angle: mpq
    x: mpq
    y: mpq
    length: mpq


def rotation(polygon: Polygon, attempt: int) -> Similarity:
    """The rotation of P' before it is laid over the grid.

    Parameters
    ----------
    polygon : Polygon
        P'.
    attempt : int
        0, 1, 2, ...: each gives another rotation.

    Returns
    -------
    Similarity
        By the small rotation, after the two perpendicular directions that most of the boundary
        has, if more than half of its length has them, have been turned to the axes.

    Notes
    -----
    O(n log n).
    """
    slight = Similarity.rotation(mpq(1, SMALL + attempt))
    shared = shared_direction(polygon)
    if shared is None:
        return slight
    return Similarity.rotation(-_half_angle_tangent(shared)).then(slight)


def shared_direction(polygon: Polygon) -> Side | None:
    """The direction in the first quadrant that, with its perpendicular, most of the boundary has.

    Returns
    -------
    Side or None
        One of the edges.  None if no pair of perpendicular directions has more than half of the
        length, or if it is the axes' already.

    Examples
    --------
    >>> from bern_exact.exact.points import hpoint
    >>> from bern_exact.plane.validation import polygon_from_rings
    >>> corners = [(0, 0), (4, 3), (1, 7), (-3, 4)]
    >>> shared_direction(polygon_from_rings([[hpoint(x, y) for x, y in corners]]))[1:3]
    (mpq(4,1), mpq(3,1))
    """
    sides = sorted(_in_first_quadrant(polygon))
    again = [side._replace(angle=side.angle + 1) for side in sides]
    shared = _fullest_window([*sides, *again])
    if sum(side.length for side in shared) <= SHARE * sum(side.length for side in sides):
        return None
    # A window round the axes holds both ends of the quadrant, or begins at its lower end.
    if shared[0].angle == 0 or shared[-1].angle >= 1:
        return None
    return shared[len(shared) // 2]


def _in_first_quadrant(polygon: Polygon) -> Iterator[Side]:
    """Each edge, turned by quarters until x > 0 and y >= 0."""
    for tail, head in polygon.edges():
        p, q = polygon.points[tail], polygon.points[head]
        x, y = (mpq(part, p[2] * q[2]) for part in direction(p, q))
        while not (x > 0 and y >= 0):
            x, y = -y, x
        yield Side(y / (x + y), x, y, sqrt_below(x * x + y * y, ROOT_BITS))


def _fullest_window(sides: Sequence[Side]) -> Sequence[Side]:
    """Of two turns of edges by angle, the first run within SPREAD that is longest in all."""
    best, most, end, length = (0, 0), mpq(0), 0, mpq(0)
    for start in range(len(sides) // 2):
        while end < len(sides) and sides[end].angle <= sides[start].angle + SPREAD:
            length += sides[end].length
            end += 1
        if length > most:
            best, most = (start, end), length
        length -= sides[start].length
    return sides[slice(*best)]


def _half_angle_tangent(side: Side) -> mpq:
    """tan(theta/2) = y/(x + |d|) of an edge's direction, rounded down to TURN_BITS bits."""
    tangent = side.y / (side.x + side.length)
    scale = 1 << TURN_BITS
    return mpq((tangent.numerator * scale) // tangent.denominator, scale)
