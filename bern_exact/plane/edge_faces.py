"""The faces that a set of edges bounds: one plane sweep, and a walk round each face.

Edges may pass through vertices and lie on one another: they are taken as the pieces between the
vertices on them.  The sweep is that of Shamos and Hoey, which finds a crossing if there is one
(`bern_exact.plane.simplicity` says why); edges that meet in a vertex do not cross, but end there.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cmp_to_key

from bern_exact.exact.points import HPoint, Line, line_through, meet
from bern_exact.exact.predicates import orientation, side
from bern_exact.plane.mesh import Triangle
from bern_exact.plane.status import count_below, lexicographic_ranks

Edge = tuple[int, int]


@dataclass(frozen=True)
class EdgeFaces:
    """What edges bound.

    Parameters
    ----------
    triangles : list of (int, int, int)
        The faces that are triangles, counter-clockwise.
    stray : list of (int, int)
        The pieces of edges that are no side of these, sorted.
    crossing : pair of edges, or None
        Two edges that cross; then faces and pieces are those that the sweep had come to.
    """

    triangles: list[Triangle]
    stray: list[Edge]
    crossing: tuple[Edge, Edge] | None


def faces_of_edges(
    points: Sequence[HPoint], edges: Iterable[Edge], implied: Iterable[Edge] = ()
) -> EdgeFaces:
    """The triangular faces that edges bound.

    Parameters
    ----------
    points : sequence of HPoint
        Of several at one place the first one stands for all.
    edges : iterable of (int, int)
        Indices in range; in any order, direction and number.  One whose ends are one point is
        passed over.
    implied : iterable of (int, int)
        Further edges, whose pieces are never called stray.

    Notes
    -----
    O((n + m) log n) comparisons for n points and m pieces of edges.

    Examples
    --------
    >>> from bern_exact.exact.points import grid_point
    >>> corners = [grid_point(x, y) for x, y in ((0, 0), (4, 0), (4, 4), (2, 0))]
    >>> faces_of_edges(corners, [(0, 1), (1, 2), (2, 0), (2, 3)]).triangles
    [(0, 3, 2), (1, 2, 3)]
    """
    first: dict[HPoint, int] = {}
    same = [first.setdefault(p, v) for v, p in enumerate(points)]
    sweep = _Sweep(points, first)
    for a, b in edges:
        sweep.add(same[a], same[b])
    for a, b in implied:
        sweep.add(same[a], same[b], implied=True)
    sweep.run()
    triangles = _triangles(points, sweep.rank, sweep.pieces)
    sides = {
        (min(a, b), max(a, b)) for t in triangles for a, b in zip(t, (*t[1:], t[0]), strict=True)
    }
    stray = sorted({(min(e), max(e)) for e in set(sweep.pieces) - sweep.spared} - sides)
    return EdgeFaces(triangles, stray, sweep.crossing)


@dataclass
class _Sweep:
    """Cuts edges at the vertices on them, until two cross."""

    points: Sequence[HPoint]
    number: dict[HPoint, int]
    pieces: list[Edge] = field(default_factory=list)
    spared: set[Edge] = field(default_factory=set)
    crossing: tuple[Edge, Edge] | None = None

    def __post_init__(self) -> None:
        self.order, self.rank = lexicographic_ranks(self.points)
        self.begin: list[list[int]] = [[] for _ in self.points]  # edges by their lower end
        self.upper: list[int] = []  # of each edge its other end
        self.lower: list[int] = []
        self.implied: list[bool] = []
        self.lines: list[Line] = []
        self.status: list[int] = []

    def add(self, a: int, b: int, implied: bool = False) -> None:
        """An edge yet to be swept, or what is left of one."""
        if a == b:
            return
        if self.rank[a] > self.rank[b]:
            a, b = b, a
        self.begin[a].append(len(self.upper))
        self.lower.append(a)
        self.upper.append(b)
        self.implied.append(implied)
        self.lines.append(line_through(self.points[a], self.points[b]))

    def run(self) -> None:
        """Sweep to the end, or to the first crossing that is seen."""
        for position, v in enumerate(self.order):
            self._pass(v)
            if self.crossing:
                left = [e for w in self.order[position + 1 :] for e in self.begin[w]]
                self.pieces += [(self.lower[e], self.upper[e]) for e in (*self.status, *left)]
                return

    def _pass(self, v: int) -> None:
        """Cut what goes through v, take out what ends there, put in what begins there."""
        status, p = self.status, self.points[v]
        low = high = count_below(status, self.lines, p)
        while high < len(status) and side(self.lines[status[high]], p) == 0:
            e = status[high]
            self.pieces.append((self.lower[e], v))
            if self.implied[e]:
                self.spared.add(self.pieces[-1])
            self.add(v, self.upper[e], self.implied[e])
            high += 1
        beginning = self._beginning(v)
        status[low:high] = beginning
        self._test(low)
        if beginning:
            self._test(low + len(beginning))

    def _beginning(self, v: int) -> list[int]:
        """The edges from v on, from below upwards; of those on one line the shortest alone."""
        at = self.points

        def compare(e: int, f: int) -> int:
            turn = orientation(at[v], at[self.upper[e]], at[self.upper[f]])
            return -turn or self.rank[self.upper[e]] - self.rank[self.upper[f]]

        kept: list[int] = []
        for e in sorted(self.begin[v], key=cmp_to_key(compare)):
            if kept and orientation(at[v], at[self.upper[kept[-1]]], at[self.upper[e]]) == 0:
                self.implied[kept[-1]] |= self.implied[e]
                self.add(self.upper[kept[-1]], self.upper[e], self.implied[e])
            else:
                kept.append(e)
        return kept

    def _test(self, position: int) -> None:
        """Do the edges just below and from `position` on cross?"""
        if self.crossing or not 0 < position < len(self.status):
            return
        e, f = self.status[position - 1], self.status[position]
        ends_e = (self.lower[e], self.upper[e])
        ends_f = (self.lower[f], self.upper[f])
        if _apart(self.points, self.lines[f], ends_e) or _apart(self.points, self.lines[e], ends_f):
            return
        if meet(self.lines[e], self.lines[f]) not in self.number:
            self.crossing = (ends_e, ends_f)


def _apart(points: Sequence[HPoint], line: Line, ends: Edge) -> bool:
    """Are both ends on one side of the line, or one of them on it?"""
    return side(line, points[ends[0]]) * side(line, points[ends[1]]) >= 0


def _triangles(
    points: Sequence[HPoint], rank: Sequence[int], pieces: Iterable[Edge]
) -> list[Triangle]:
    """The faces of three sides: round each the next side is the first one clockwise at its end."""
    around: dict[int, set[int]] = {}
    for a, b in pieces:
        around.setdefault(a, set()).add(b)
        around.setdefault(b, set()).add(a)
    following: dict[Edge, Edge] = {}
    for v, ends in around.items():
        turning = _by_angle(points, rank, v, ends)
        for w, clockwise in zip(turning, (turning[-1], *turning[:-1]), strict=True):
            following[w, v] = (v, clockwise)
    found = []
    for (a, b), (_, c) in following.items():
        closed = following[b, c] == (c, a) and following[c, a] == (a, b)
        if closed and a < b and a < c and orientation(points[a], points[b], points[c]) > 0:
            found.append((a, b, c))
    return sorted(found)


def _by_angle(
    points: Sequence[HPoint], rank: Sequence[int], v: int, ends: Iterable[int]
) -> list[int]:
    """The other ends of edges at v, counter-clockwise: right of v upwards, left of v downwards."""

    def compare(w: int, x: int) -> int:
        return -orientation(points[v], points[w], points[x]) or w - x

    key = cmp_to_key(compare)
    right = sorted((w for w in ends if rank[w] > rank[v]), key=key)
    left = sorted((w for w in ends if rank[w] < rank[v]), key=key)
    return right + left
