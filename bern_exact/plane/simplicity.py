"""Do rings meet themselves or each other?  The sweep of Shamos and Hoey, and what it shows.

As long as no two edges have met, the status is in order.  Let p be the lexicographically first
point where two edges meet that have no vertex in common.  Just before p, the edges through p that
began earlier stand next to one another in the status; two edges are tested when they become
neighbours.  So either two of them were tested, or only one of them began before p: then p is a
vertex, and the bisection at p finds that the edge passes through it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NoReturn

from bern_exact.exact.errors import InputError
from bern_exact.exact.points import HPoint, Line, meet
from bern_exact.exact.predicates import orientation, side
from bern_exact.plane.raw_rings import RawRings
from bern_exact.plane.status import (
    beginning_edges,
    count_below,
    lexicographic_ranks,
    rightward_lines,
)


@dataclass(frozen=True)
class Simplicity:
    """What the sweep shows of rings that do not meet.

    Parameters
    ----------
    is_ccw : list of bool
        For each ring whether it runs counter-clockwise in input order.
    leftmost : list of int
        For each ring its lexicographically first vertex.
    container : list of int
        For each ring the innermost ring around it, -1 if there is none.
    """

    is_ccw: list[bool]
    leftmost: list[int]
    container: list[int]


def check_simplicity(raw: RawRings) -> Simplicity:
    """Refuse edges that cross, touch or overlap; else say how the rings lie.

    Parameters
    ----------
    raw : RawRings
        All vertices distinct, at least 3 a ring, no spikes.

    Raises
    ------
    InputError
        `edges-cross`, `edges-touch` or `edges-overlap`, with the edges and the exact point.

    Notes
    -----
    O(n log n) comparisons.
    """
    return _Sweep(raw).run()


class _Sweep:
    """The sweep over the vertices in lexicographic order."""

    def __init__(self, raw: RawRings) -> None:
        self.raw = raw
        self.points: Sequence[HPoint] = raw.points
        self.order, self.rank = lexicographic_ranks(raw.points)
        self.lines: Sequence[Line] = rightward_lines(raw.points, raw.after, self.rank)
        self.status: list[int] = []
        rings = len(raw.rings)
        self.found = Simplicity([False] * rings, [-1] * rings, [-1] * rings)

    def run(self) -> Simplicity:
        """Sweep to the end."""
        raw, status = self.raw, self.status
        for v in self.order:
            position = count_below(status, self.lines, self.points[v])
            beginning = beginning_edges(self.points, v, raw.before[v], raw.after[v], self.rank)
            self._refuse_edges_through(v, position, 2 - len(beginning))
            status[position : position + 2 - len(beginning)] = beginning
            if len(beginning) == 2 and self.found.leftmost[raw.ring_of[v]] < 0:
                self._note_ring(v, position)
            top = position + len(beginning)
            self._test_neighbours(position)
            if beginning:
                self._test_neighbours(top)
        return self.found

    def _refuse_edges_through(self, v: int, position: int, ending: int) -> None:
        """From `position` on, the edges that end at v must stand, and then edges above v."""
        status, own = self.status, (self.raw.before[v], v)
        for e in status[position : position + ending + 1]:
            if e not in own and side(self.lines[e], self.points[v]) == 0:
                self._refuse_touch(v, e)

    def _note_ring(self, v: int, position: int) -> None:
        """v is the first vertex of its ring: note how the ring turns, and what is around it."""
        raw, found, r = self.raw, self.found, self.raw.ring_of[v]
        before, after = raw.points[raw.before[v]], raw.points[raw.after[v]]
        found.leftmost[r] = v
        found.is_ccw[r] = orientation(before, raw.points[v], after) > 0
        if position == 0:
            return
        below = self.status[position - 1]
        ring = raw.ring_of[below]
        runs_right = self.rank[below] < self.rank[raw.after[below]]
        found.container[r] = ring if runs_right == found.is_ccw[ring] else found.container[ring]

    def _test_neighbours(self, position: int) -> None:
        """Refuse the edges just below and from `position` on if they meet."""
        if not 0 < position < len(self.status):
            return
        e, f = self.status[position - 1], self.status[position]
        after, points = self.raw.after, self.points
        ends_e, ends_f = (e, after[e]), (f, after[f])
        if e in ends_f or after[e] in ends_f:
            return  # they share a vertex, and spikes are excluded
        sides_e = [side(self.lines[f], points[v]) for v in ends_e]
        sides_f = [side(self.lines[e], points[v]) for v in ends_f]
        if sides_e[0] * sides_e[1] > 0 or sides_f[0] * sides_f[1] > 0:
            return
        for ends, sides, other in ((ends_e, sides_e, f), (ends_f, sides_f, e)):
            for v, where in zip(ends, sides, strict=True):
                if where == 0 and self._is_between(v, other):
                    self._refuse_touch(v, other)
        if sides_e[0] * sides_e[1] < 0 and sides_f[0] * sides_f[1] < 0:
            crossing = meet(self.lines[e], self.lines[f])
            self._refuse("edges-cross", f"edges {self._pair(e, f)} cross", e, f, crossing)

    def _is_between(self, v: int, e: int) -> bool:
        """Is the vertex v, on the line of e, strictly inside e?"""
        low, high = self._span(e)
        return low < self.rank[v] < high

    def _refuse_touch(self, v: int, e: int) -> NoReturn:
        """v lies inside e: an overlap if an edge at v runs along e, else a touch."""
        for f in sorted((self.raw.before[v], v)):
            other = self.raw.after[f] if f == v else f
            if side(self.lines[e], self.points[other]) == 0 and self._share_a_piece(e, f):
                first = max(self._first_end(e), self._first_end(f), key=self.rank.__getitem__)
                message = f"edges {self._pair(e, f)} overlap"
                self._refuse("edges-overlap", message, e, f, self.points[first])
        message = f"vertex {self.raw.place(v)} lies on edge {self.raw.place(e)}"
        own = min(self.raw.before[v], v)
        self._refuse("edges-touch", message, e, own, self.points[v], v)

    def _share_a_piece(self, e: int, f: int) -> bool:
        """Have two edges on one line more than a point in common?"""
        (a, b), (c, d) = self._span(e), self._span(f)
        return max(a, c) < min(b, d)

    def _span(self, e: int) -> tuple[int, int]:
        """The ranks of the two ends of e, the lower first."""
        first, second = self.rank[e], self.rank[self.raw.after[e]]
        return min(first, second), max(first, second)

    def _first_end(self, e: int) -> int:
        """The end of e that the sweep meets first."""
        return min(e, self.raw.after[e], key=self.rank.__getitem__)

    def _pair(self, e: int, f: int) -> str:
        """Two edges by their places, in order."""
        return f"{self.raw.place(min(e, f))} and {self.raw.place(max(e, f))}"

    def _refuse(
        self, kind: str, message: str, e: int, f: int, point: HPoint, vertex: int | None = None
    ) -> NoReturn:
        """Raise the InputError."""
        raw = self.raw
        where: dict[str, object] = {
            "edges": [raw.place(min(e, f)), raw.place(max(e, f))],
            "point": raw.text(point),
        }
        if vertex is not None:
            where["vertex"] = raw.place(vertex)
        raise InputError(kind, message, where)
