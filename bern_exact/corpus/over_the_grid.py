"""Polygons made in grid coordinates and moved back, so that their frame is known beforehand.

If no corner is acute, P' = P; if the feature size is from 8 to just above 8, the
grid unit is 1; and then the first frame moves the input just to where it was made.
"""

from __future__ import annotations

from functools import cache
from random import Random

from gmpy2 import mpq

from bern_exact.boundary.frame import frame
from bern_exact.boundary.lop import lop
from bern_exact.corpus.draws import pick
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.exact.roots import sqrt_below
from bern_exact.exact.similarity import Similarity
from bern_exact.plane.feature_size import feature_size
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import triangulate_polygon

Vector = tuple[mpq, mpq]


@cache
def frame_of(attempt: int) -> Similarity:
    """The similarity of this attempt if the grid unit is 1."""
    # Special in no frame.
    corners = pentagon_on((mpq(0), mpq(0)), (mpq(24, 5), mpq(32, 5)))
    pentagon = Polygon(tuple(hpoint(x, y) for x, y in corners), ((0, 1, 2, 3, 4),))
    lopped = lop(pentagon, triangulate_polygon(pentagon))
    return frame(lopped, feature_size(pentagon), attempt).similarity


def pentagon_on(tail: Vector, head: Vector) -> list[Vector]:
    """A pentagon on the left of an edge, its shortest: its feature size is that edge's length.

    Its corners are obtuse, and its edges share no directions that the frame would turn to the axes.
    """
    (x, y), (u, v) = tail, head
    # Complex multiples of the edge: a fixed pentagon whose first edge is 24 + 32 i.
    a, b = (u - x) / 1600, (v - y) / 1600
    rest = [(c * 24 + d * 32, d * 24 - c * 32) for c, d in ((-1, 72), (-46, 67), (-56, 22))]
    return [tail, head, *((x + a * c - b * d, y + a * d + b * c) for c, d in rest)]


def moved_back(points: list[Vector], attempt: int = 0) -> list[HPoint]:
    """The points that this attempt's frame moves to the given grid coordinates."""
    back = frame_of(attempt).inverse()
    return [back.apply(hpoint(x, y)) for x, y in points]


def special_in_first_frames(random: Random) -> list[list[HPoint]]:
    """A pentagon of side 8 or so: axis-parallel, diagonal, or on grid lines in frame 0, 1 or 2."""
    x, y = mpq(random.randrange(4), 2), mpq(random.randrange(4), 3)
    corners = pentagon_on((x, y), (x + 8, y))
    way = random.randrange(3)
    if way == 1:  # exactly diagonal; the side is irrational, the unit just any
        corners = [(u - v, u + v) for u, v in corners]
    if way == 2:  # turned by a 3-4-5 triangle: the corners alone can lie on grid lines
        corners = [((4 * u - 3 * v) / 5, (3 * u + 4 * v) / 5) for u, v in corners]
        shift = -corners[0][0] + random.randrange(3)
        corners = [(u + shift, v) for u, v in corners]
    return [moved_back(corners, random.randrange(3))]


def aimed_at_grid_points(random: Random) -> list[list[HPoint]]:
    """One vertex v near the middle of its square; its edges pass near grid points of its block.

    The outgoing edge is just above 8 long.  Nothing is promised about the other corners:
    if one is acute, or the feature size below 8, the frame is another.
    """
    v = (_near_half(random), _near_half(random))
    out, into = (_aim(random, v) for _ in range(2))
    return [moved_back(around(v, out, into, random.randrange(8)))]


def around(v: Vector, out: Vector, into: Vector, far: int = 0) -> list[Vector]:
    """A polygon with the vertex v, its edges leaving in directions `out` and `into`.

    The edge along `out` is just above 8 long, that along `into` just above 9.
    """
    first, last = _step(v, out, mpq(8)), _step(v, into, mpq(9))
    if out[0] * into[1] > out[1] * into[0] and 2 * _dot(out, into) > -_length(out) * _length(into):
        # Narrow: a pentagon whose far corners are obtuse.
        return [v, first, *_far_side(v, out, into), last]
    after = _step(_step(first, (-out[1], out[0]), mpq(20)), out, mpq(8 + far))
    before = _step(_step(last, (into[1], -into[0]), mpq(20)), into, mpq(9))
    return [v, first, after, *_round(v, after, before), before, last]


def _far_side(v: Vector, out: Vector, into: Vector) -> list[Vector]:
    """Two corners that close a narrow wedge."""
    return [
        _step(_step(v, out, along), into, across)
        for along, across in ((mpq(39, 2), mpq(12)), (mpq(12), mpq(20)))
    ]


def _dot(u: Vector, v: Vector) -> mpq:
    return u[0] * v[0] + u[1] * v[1]


def _length(u: Vector) -> mpq:
    return sqrt_below(_dot(u, u), 16)


def _round(v: Vector, after: Vector, before: Vector) -> list[Vector]:
    """Far points counter-clockwise from one direction to another, where they are far apart."""
    compass = ((41, 3), (37, 44), (-5, 47), (-43, 38), (-40, -7), (-36, -45), (6, -42), (39, -46))
    a, b = (after[0] - v[0], after[1] - v[1]), (before[0] - v[0], before[1] - v[1])
    start = max(range(8), key=lambda i: _turn_key(a, compass[i]))
    found = []
    for i in range(8):
        d = compass[(start + i) % 8]
        if _is_between(a, d, b):
            found.append((v[0] + d[0], v[1] + d[1]))
    return found


def _turn_key(a: Vector, d: tuple[int, int]) -> tuple[bool, mpq]:
    """Greatest for the first direction counter-clockwise from a."""
    cross, dot = a[0] * d[1] - a[1] * d[0], a[0] * d[0] + a[1] * d[1]
    return (cross > 0, dot / (1 + abs(cross)))


def _is_between(a: Vector, d: tuple[int, int], b: Vector) -> bool:
    """Is the direction d strictly within the counter-clockwise angle from a to b?"""
    left_of_a = a[0] * d[1] - a[1] * d[0] > 0
    right_of_b = d[0] * b[1] - d[1] * b[0] > 0
    if a[0] * b[1] - a[1] * b[0] > 0:
        return bool(left_of_a and right_of_b)
    return bool(left_of_a or right_of_b)


def _step(p: Vector, d: Vector, length: mpq) -> Vector:
    """p moved along d by a length between the given one and 1 + 2^-12 times it."""
    square = length * length * (1 + mpq(1, 2**11)) / (d[0] * d[0] + d[1] * d[1])
    t = sqrt_below(square, 16)
    return p[0] + t * d[0], p[1] + t * d[1]


def _near_half(random: Random) -> mpq:
    """A coordinate in (0, 1): anywhere, or within some power of ten of 1/2."""
    if random.randrange(3) == 0:
        return mpq(random.randrange(1, 1000), 1000)
    return mpq(1, 2) + mpq(pick(random, (-1, 1)), 10 ** random.randrange(1, 9))


def _aim(random: Random, v: Vector) -> Vector:
    """A direction from v towards a place near a grid point of its block, about tau from it."""
    while True:
        x, y = mpq(random.randrange(-1, 3)), mpq(random.randrange(-1, 3))
        near = mpq(random.randrange(-9, 10), 64) + mpq(pick(random, (-1, 1)), 10**6)
        if random.randrange(2):
            x += near
        else:
            y += near
        if (x - v[0]) ** 2 + (y - v[1]) ** 2 > 1:
            return x - v[0], y - v[1]
