"""The paper's example polygons, as families with a parameter.

Section 2 has two polygons on which triangulations without Steiner points are poor,
Section 3.2 one on which every matching partition is large.
"""

from __future__ import annotations

from collections.abc import Sequence

from gmpy2 import mpq

from bern_exact.corpus.shapes import Point, Ring
from bern_exact.exact.enclosures import cos_degrees_bounds
from bern_exact.interior.records import Rectilinear

_RADIUS_BITS = 40

HOLE = 1
"""The side of the tiny holes of `hole_grid`, whose positions are multiples of 4."""


def regular_polygon(n: int) -> list[Ring]:
    """A regular n-gon, its vertices rounded to the integers, radius 2^40.

    Section 2, after Mitchell: with side length s, "any triangulation without Steiner points must
    contain a triangle with two adjacent sides, and hence height s sin(pi/n).  A single Steiner
    point at the center of the n-gon, however, gives height about s."

    Parameters
    ----------
    n : int
        At least 3.

    >>> regular_polygon(4) == [[(2**40, 0), (0, 2**40), (-(2**40), 0), (0, -(2**40))]]
    True
    """
    degrees = [mpq(360 * i, n) for i in range(n)]
    return [[(_cosine(d), _cosine(d - 90)) for d in degrees]]


def _cosine(degrees: mpq) -> int:
    """2^40 times the cosine, rounded to the nearest integer."""
    folded = min(degrees % 360, 360 - degrees % 360)
    low, high = cos_degrees_bounds(folded, 2 * _RADIUS_BITS)
    scaled = (low + high) / 2 * 2**_RADIUS_BITS + mpq(1, 2)
    return int(scaled.numerator // scaled.denominator)


def thin_rectangle(k: int) -> list[Ring]:
    """The rectangle of 2 k by 1 with subdivision points at k and k + 1 on its lower side.

    Section 2, after Mitchell: "the difference between Steiner and non-Steiner triangulations
    depends on k, rather than n.  Though all edges necessarily measure at least s in a non-Steiner
    triangulation, arbitrarily large angles allow much smaller height."  s is 1; the triangle on
    the edge between the subdivision points has height at most 1/sqrt(k^2 + 1).

    Parameters
    ----------
    k : int
        At least 2.

    >>> thin_rectangle(2)
    [[(0, 0), (2, 0), (3, 0), (4, 0), (4, 1), (0, 1)]]
    """
    return [[(0, 0), (k, 0), (k + 1, 0), (2 * k, 0), (2 * k, 1), (0, 1)]]


def hole_grid(side: int) -> list[Ring]:
    """A square with a turned grid of side x side tiny square holes.

    Section 3.2: "a square of side n containing a regular square grid of n - 4 point (or tiny
    square) holes.  The grid of holes has spacing about n^(1/2); we rotate it slightly with
    respect to the square frame so that the difference between the y-coordinates of two
    successive holes in the same row is about 1.  The minimum spanning tree of the polygon's
    vertices has total length Omega(n^(3/2)) in the L1 metric."

    Hole (i, j) stands at 4 (i side - j, j side + i): the step along a row is (side, 1) in
    units of 4, and no two holes share a line.  Axis-parallel, holes of 1 by 1.

    Parameters
    ----------
    side : int
        At least 1.

    >>> hole_grid(1)
    [[(-4, -4), (5, -4), (5, 5), (-4, 5)], [(0, 0), (0, 1), (1, 1), (1, 0)]]
    """
    corners = _hole_corners(side)
    left, right = min(x for x, _ in corners) - 4, max(x for x, _ in corners) + HOLE + 4
    bottom, top = min(y for _, y in corners) - 4, max(y for _, y in corners) + HOLE + 4
    rings = [[(left, bottom), (right, bottom), (right, top), (left, top)]]
    return rings + [_hole(x, y) for x, y in corners]


def _hole_corners(side: int) -> list[Point]:
    """The lower left corners of the holes."""
    return [(4 * (i * side - j), 4 * (j * side + i)) for j in range(side) for i in range(side)]


def _hole(x: int, y: int) -> Ring:
    """A hole, clockwise."""
    return [(x, y), (x, y + HOLE), (x + HOLE, y + HOLE), (x + HOLE, y)]


def hole_grid_region(side: int) -> Rectilinear:
    """The grid of holes as a rectilinear polygon with the matching condition (Definition 2).

    The lines from each hole's corners run unhindered to the frame: a vertex is added there.
    N = 12 side^2 + 4.

    >>> hole_grid_region(3).edges
    112
    """
    (frame, *holes) = hole_grid(side)
    (left, bottom), (right, top) = frame[0], frame[2]
    xs = sorted({x for hole in holes for x, _ in hole})
    ys = sorted({y for hole in holes for _, y in hole})
    loop = [(left, bottom), *((x, bottom) for x in xs)]
    loop += [(right, bottom), *((right, y) for y in ys)]
    loop += [(right, top), *((x, top) for x in reversed(xs))]
    loop += [(left, top), *((left, y) for y in reversed(ys))]
    return Rectilinear((tuple(loop), *(tuple(hole) for hole in holes)))


def spanning_tree_length(points: Sequence[Point]) -> int:
    """The length of a minimum spanning tree in the L1 metric, exactly (Prim, quadratic time).

    >>> spanning_tree_length([(0, 0), (2, 1), (2, 0), (5, 5)])
    10
    """
    distance = {p: abs(p[0] - points[0][0]) + abs(p[1] - points[0][1]) for p in points[1:]}
    length = 0
    while distance:
        nearest = min(distance, key=lambda p: (distance[p], p))
        length += distance.pop(nearest)
        for p in distance:
            distance[p] = min(distance[p], abs(p[0] - nearest[0]) + abs(p[1] - nearest[1]))
    return length


def in_lattice_units(points: Sequence[Point], region: Rectilinear) -> list[Point]:
    """Points with coordinates counted in lines of the region's vertices."""
    column = {x: i for i, x in enumerate(sorted({x for loop in region.loops for x, _ in loop}))}
    row = {y: i for i, y in enumerate(sorted({y for loop in region.loops for _, y in loop}))}
    return [(column[x], row[y]) for x, y in points]


def fewest_partition_vertices(side: int) -> int:
    """A lower bound for the vertices of a matching partition of `hole_grid_region`: MST/3.

    Section 3.2: "any partition of the input into rectangles forms a network that spans the
    vertices", and by the matching condition its length in lattice units is the number of its
    edges, for each line crosses the entire figure.  The paper takes the minimum spanning
    tree of the vertices as a lower bound for the network, which may however branch
    elsewhere: that makes it a Steiner tree, of at least 2/3 of the length in the L1
    metric (Hwang 1976).  A vertex has at most 4 edges, so there are at most 2 edges a vertex.

    >>> fewest_partition_vertices(4)
    50
    """
    region = hole_grid_region(side)
    holes = [loop[0] for loop in region.loops[1:]]
    length = spanning_tree_length(in_lattice_units(holes, region))
    return -(-length // 3)
