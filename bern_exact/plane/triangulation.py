"""A triangulation of a polygon by its own vertices: constrained Delaunay, exactly.

It is constrained Delaunay: what a vertex sees nearby is joined to it, which
`bern_exact.plane.visibility` and `bern_exact.plane.feature_size` prove and use.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from gmpy2 import mpq

from bern_exact.exact.points import HPoint
from bern_exact.exact.predicates import orientation
from bern_exact.plane.flips import make_delaunay
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.status import (
    beginning_edges,
    count_below,
    lexicographic_ranks,
    rightward_lines,
)


@dataclass(frozen=True)
class Triangulation:
    """Triangles as half-edges in flat arrays.

    Triangle t has the half-edges 3t, 3t + 1, 3t + 2, counter-clockwise.

    Parameters
    ----------
    origin : sequence of int
        For each half-edge the vertex that it leaves.
    twin : sequence of int
        For each half-edge the opposite one in the neighbouring triangle; -1 on the boundary,
        where the half-edge from v is the polygon's edge v.
    leaving : sequence of int
        For each vertex v the half-edge that is the polygon's edge v.
    """

    origin: Sequence[int]
    twin: Sequence[int]
    leaving: Sequence[int]

    def around(self, v: int) -> Iterator[int]:
        """The half-edges that leave v, one in each triangle at v, counter-clockwise."""
        h = self.leaving[v]
        while h >= 0:
            yield h
            h = self.twin[before(h)]

    def triangles(self) -> Iterator[tuple[int, int, int]]:
        """Every triangle as its vertices, counter-clockwise."""
        corners = iter(self.origin)
        return zip(corners, corners, corners, strict=True)


def following(h: int) -> int:
    """The next half-edge of the same triangle."""
    return h + 1 if h % 3 < 2 else h - 2


def before(h: int) -> int:
    """The previous half-edge of the same triangle."""
    return h - 1 if h % 3 else h + 2


def triangulate_polygon(polygon: Polygon) -> Triangulation:
    """A triangulation of a valid polygon, with holes or without, by its vertices alone.

    Every triangle has positive area, also where the polygon has 180-degree vertices.  It is
    constrained Delaunay: the circle through a triangle's corners has no vertex inside that is
    visible from inside the triangle (which of several such triangulations, if visible points lie
    on one circle, depends on the input alone).

    Parameters
    ----------
    polygon : Polygon
        As `polygon_from_rings` makes it; on other input the result is undefined.

    Notes
    -----
    A sweep in O(n log n), then Lawson's flips: quadratic at worst, a few a vertex as a rule.
    """
    corners: list[int] = []
    for triangle in _Sweep(polygon).triangles():
        corners.extend(triangle)
    twin = _twins(corners)
    make_delaunay(polygon.points, corners, twin)
    leaving = [-1] * polygon.n
    for h, opposite in enumerate(twin):
        if opposite < 0:
            leaving[corners[h]] = h
    return Triangulation(corners, twin, leaving)


DIRECTIONS = ((1, 0), (2, 1), (1, 1), (1, 2), (0, 1), (-1, 2), (-1, 1), (-2, 1))
"""The directions in which a sweep may go."""


def _laid_along(points: Sequence[HPoint]) -> Sequence[HPoint]:
    """The points turned (and scaled) so that they are about as wide as they can be.

    A sweep across a long polygon, such as a tall ellipse, would join points that are far apart
    and leave quadratically many flips; a sweep along it leaves few.
    """
    extents = []
    for a, b in DIRECTIONS:
        positions = [mpq(a * x + b * y, w) for x, y, w in points]
        extents.append((max(positions) - min(positions)) ** 2 / mpq(a * a + b * b))
    a, b = DIRECTIONS[extents.index(max(extents))]
    return [(a * x + b * y, a * y - b * x, w) for x, y, w in points]


def _twins(origin: Sequence[int]) -> list[int]:
    """For each half-edge the opposite one, -1 on the boundary."""
    at: dict[tuple[int, int], int] = {}
    twin = [-1] * len(origin)
    for h, a in enumerate(origin):
        b = origin[following(h)]
        opposite = at.pop((b, a), -1)
        if opposite < 0:
            at[a, b] = h
        else:
            twin[h], twin[opposite] = opposite, h
    return twin


@dataclass
class _Gap:
    """The interior between two neighbouring edges of the status, as far as it is triangulated.

    Its frontier is a chain of vertices from the lower to the upper edge, weakly convex towards the
    right; the last swept vertex is the rightmost.  It is kept as two stacks that share this
    vertex as their top.

    Parameters
    ----------
    lower, upper : list of int
        From the lower (upper) edge's vertex to the rightmost one.
    """

    lower: list[int]
    upper: list[int]


class _Sweep:
    """The sweep that triangulates (after Hertel and Mehlhorn).

    Triangles are emitted as soon as the swept vertex sees both ends of an edge of the frontier.
    Why this works: the swept vertex lies right of the whole frontier, which is convex towards it,
    so it sees one connected part of it, which contains the rightmost vertex; and the whole
    lower stack if it ends the lower edge, since that edge then is a tangent (likewise above).
    Every emitted triangle is strictly positive: a frontier edge collinear with the
    swept vertex is left to a later one, and in a stack seen as a whole there is none.
    """

    def __init__(self, polygon: Polygon) -> None:
        self.points: Sequence[HPoint] = _laid_along(polygon.points)
        self.polygon = polygon
        self.order, self.rank = lexicographic_ranks(self.points)
        self.lines = rightward_lines(self.points, polygon.after, self.rank)
        self.status: list[int] = []
        self.gaps: dict[int, _Gap] = {}  # by the gap's lower edge
        self.found: list[tuple[int, int, int]] = []

    def triangles(self) -> list[tuple[int, int, int]]:
        """Run the sweep."""
        for v in self.order:
            position = count_below(self.status, self.lines, self.points[v])
            previous, following = self.polygon.before[v], self.polygon.after[v]
            starting = beginning_edges(self.points, v, previous, following, self.rank)
            ending = self.status[position : position + 2 - len(starting)]
            self.status[position : position + len(ending)] = starting
            if len(starting) == 2:
                self._open(v, position, starting)
            elif len(starting) == 1:
                self._pass(v, position, ending[0], starting[0])
            else:
                self._close(v, position, ending)
        return self.found

    def _open(self, v: int, position: int, starting: list[int]) -> None:
        """Both edges begin at v: a new gap, or one gap split in two."""
        if position % 2 == 0:
            self.gaps[starting[0]] = _Gap([v], [v])
            return
        gap = self.gaps[self.status[position - 1]]
        self._take_seen_below(v, gap)
        above = _Gap([v], gap.upper)
        self._take_seen_above(v, above)
        gap.upper = [v]
        self.gaps[starting[1]] = above

    def _pass(self, v: int, position: int, ending: int, starting: int) -> None:
        """One edge gives way to another at v."""
        if position % 2 == 0:
            gap = self.gaps[starting] = self.gaps.pop(ending)
            self._take_lower(v, gap)
        else:
            self._take_upper(v, self.gaps[self.status[position - 1]])

    def _close(self, v: int, position: int, ending: list[int]) -> None:
        """Both edges end at v: a gap ends, or two become one."""
        if position % 2 == 0:
            gap = self.gaps.pop(ending[0])
            self._fan(v, gap.lower)
            self._fan(v, gap.upper[::-1])
            return
        below, above = self.gaps[self.status[position - 1]], self.gaps.pop(ending[1])
        self._take_upper(v, below)
        self._take_lower(v, above)
        below.upper = above.upper

    def _take_lower(self, v: int, gap: _Gap) -> None:
        """v ends the gap's lower edge: it sees the whole lower stack and part of the upper one."""
        self._fan(v, gap.lower)
        gap.lower = [v]
        self._take_seen_above(v, gap)

    def _take_upper(self, v: int, gap: _Gap) -> None:
        """v ends the gap's upper edge."""
        self._fan(v, gap.upper[::-1])
        gap.upper = [v]
        self._take_seen_below(v, gap)

    def _take_seen_below(self, v: int, gap: _Gap) -> None:
        """Emit what v sees of the lower stack, from its top down, and put v on top."""
        stack, points = gap.lower, self.points
        while len(stack) > 1 and orientation(points[stack[-2]], points[v], points[stack[-1]]) > 0:
            top = stack.pop()
            self.found.append((stack[-1], v, top))
        stack.append(v)

    def _take_seen_above(self, v: int, gap: _Gap) -> None:
        """Emit what v sees of the upper stack, from its top up, and put v on top."""
        stack, points = gap.upper, self.points
        while len(stack) > 1 and orientation(points[stack[-1]], points[v], points[stack[-2]]) > 0:
            top = stack.pop()
            self.found.append((top, v, stack[-1]))
        stack.append(v)

    def _fan(self, v: int, chain: Sequence[int]) -> None:
        """Join v to every edge of a chain that runs upwards."""
        self.found.extend((a, v, b) for a, b in pairwise(chain))
