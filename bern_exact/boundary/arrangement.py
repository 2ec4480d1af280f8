"""Walking in the arrangement of the boundary and the kept intervals, without building it.

The kept intervals cross Theta(n^2) times in the worst case.  A `Arrangement`
answers "which crossing comes next on this interval?" in O(log^2 n), which
is all that tracing a face needs.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from typing import NamedTuple

from gmpy2 import mpq

from bern_exact.boundary.records import (
    HORIZONTAL,
    VERTICAL,
    Diced,
    GridNode,
)

EAST, NORTH, WEST, SOUTH = range(4)
"""Directions, counter-clockwise: turning left adds one."""


class StabbingIndex:
    """Intervals on parallel lines: which is the next one above or below a place?

    A segment tree over the perpendicular lines.  An interval lies in O(log n) nodes,
    each of which lists its intervals by line; a query bisects in the O(log n) nodes above one
    leaf.

    Parameters
    ----------
    spans : sequence of (line, first, last)
        For each interval its line and the first and last perpendicular line that it
        crosses, as indices in 0 ... size - 1 (first > last if none); sorted by line.
    size : int
        The number of perpendicular lines.
    """

    def __init__(self, spans: Sequence[tuple[int, int, int]], size: int) -> None:
        leaves = 1
        while leaves < size:
            leaves *= 2
        self._leaves = leaves
        self._lines: list[list[int]] = [[] for _ in range(2 * leaves)]
        self._ids: list[list[int]] = [[] for _ in range(2 * leaves)]
        for number, (line, first, last) in enumerate(spans):
            low, high = first + leaves, last + leaves + 1
            while low < high:
                if low & 1:
                    self._lines[low].append(line)
                    self._ids[low].append(number)
                    low += 1
                if high & 1:
                    high -= 1
                    self._lines[high].append(line)
                    self._ids[high].append(number)
                low >>= 1
                high >>= 1

    def next_from(self, leaf: int, line: int) -> tuple[int, int] | None:
        """The lowest (line, interval) at or above `line` that crosses perpendicular `leaf`."""
        best: tuple[int, int] | None = None
        node = leaf + self._leaves
        while node:
            lines = self._lines[node]
            i = bisect_left(lines, line)
            if i < len(lines) and (best is None or lines[i] < best[0]):
                best = (lines[i], self._ids[node][i])
            node >>= 1
        return best

    def last_until(self, leaf: int, line: int) -> tuple[int, int] | None:
        """The highest (line, interval) at or below `line` that crosses perpendicular `leaf`."""
        best: tuple[int, int] | None = None
        node = leaf + self._leaves
        while node:
            lines = self._lines[node]
            i = bisect_right(lines, line)
            if i and (best is None or lines[i - 1] > best[0]):
                best = (lines[i - 1], self._ids[node][i - 1])
            node >>= 1
        return best


class Step(NamedTuple):
    """Where a walk along an interval arrives.

    Parameters
    ----------
    crossing : int
        The q-vertex at the interval's end, or -1.
    line : int
        Otherwise the perpendicular line that is met ...
    interval : int
        ... and the perpendicular interval.
    """

    crossing: int
    line: int
    interval: int


class Arrangement:
    """The boundary of P' and the kept intervals, for walking.

    Parameters
    ----------
    diced : Diced
        The kept intervals.
    """

    def __init__(self, diced: Diced) -> None:
        self.diced = diced
        self.n = diced.framed.polygon.n
        self.intervals = (diced.vertical, diced.horizontal)
        self.lines = (diced.xs, diced.ys)
        self._position = tuple({k: i for i, k in enumerate(lines)} for lines in self.lines)
        self._ends = tuple(self._floors(axis) for axis in (VERTICAL, HORIZONTAL))
        # A vertical walk meets horizontal intervals, and the other way round.
        self._index = tuple(self._stabbing(1 - axis) for axis in (VERTICAL, HORIZONTAL))
        self.interval_of = self._interval_of_crossings()
        self.through: dict[GridNode, tuple[int, int]] = {}
        """The vertical and the horizontal interval through every grid vertex walked over."""

    def _first_crossing(self, axis: int) -> int:
        """The index of the lower end of the first interval of this direction."""
        return 0 if axis == VERTICAL else 2 * len(self.diced.vertical)

    def _floors(self, axis: int) -> list[tuple[int, int]]:
        """The floors of both ends of each interval."""
        first = self._first_crossing(axis)
        q = self.diced.crossings
        return [
            (_floor(q[first + 2 * i].at), _floor(q[first + 2 * i + 1].at))
            for i in range(len(self.intervals[axis]))
        ]

    def _stabbing(self, axis: int) -> StabbingIndex:
        """The index of the intervals of this direction, over the perpendicular lines."""
        across = self.lines[1 - axis]
        spans = [
            (interval.line, bisect_right(across, low), bisect_right(across, high) - 1)
            for interval, (low, high) in zip(self.intervals[axis], self._ends[axis], strict=True)
        ]
        return StabbingIndex(spans, len(across))

    def _interval_of_crossings(self) -> tuple[int, ...]:
        """For each crossing the interval (of its axis) that it ends."""
        found = []
        for intervals in self.intervals:
            for i in range(len(intervals)):
                found += [i, i]
        return tuple(found)

    def crossing_at_end(self, axis: int, interval: int, upper: bool) -> int:
        """The index of the crossing at an end of an interval."""
        return self._first_crossing(axis) + 2 * interval + upper

    def inwards(self, crossing: int) -> int:
        """The direction from a crossing into P' along its interval."""
        q = self.diced.crossings[crossing]
        upper = (crossing - self._first_crossing(q.axis)) & 1
        if q.axis == VERTICAL:
            return SOUTH if upper else NORTH
        return WEST if upper else EAST

    def step(self, axis: int, interval: int, place: int, up: bool) -> Step:
        """The next crossing along an interval strictly beyond a place between grid lines.

        Parameters
        ----------
        axis, interval : int
            The interval walked on.
        place : int
            Going up, the least line that may be met; going down, the greatest.
        up : bool
            Towards larger coordinates?
        """
        line = self.intervals[axis][interval].line
        leaf = self._position[axis][line]
        low, high = self._ends[axis][interval]
        if up:
            met = self._index[axis].next_from(leaf, place)
            if met is None or met[0] > high:
                return Step(self.crossing_at_end(axis, interval, True), 0, -1)
        else:
            met = self._index[axis].last_until(leaf, place)
            if met is None or met[0] <= low:
                return Step(self.crossing_at_end(axis, interval, False), 0, -1)
        node = (line, met[0]) if axis == VERTICAL else (met[0], line)
        self.through[node] = (interval, met[1]) if axis == VERTICAL else (met[1], interval)
        return Step(-1, met[0], met[1])

    def step_from_crossing(self, crossing: int) -> Step:
        """The first crossing inwards from a q-vertex."""
        q = self.diced.crossings[crossing]
        upper = (crossing - self._first_crossing(q.axis)) & 1
        interval = self.interval_of[crossing]
        floor = self._ends[q.axis][interval][upper]
        return self.step(q.axis, interval, floor if upper else floor + 1, not upper)

    def step_from_node(self, node: GridNode, heading: int) -> Step:
        """The next crossing from a grid vertex already walked over, in a direction."""
        axis = VERTICAL if heading in (NORTH, SOUTH) else HORIZONTAL
        up = heading in (NORTH, EAST)
        place = node[1] if axis == VERTICAL else node[0]
        return self.step(axis, self.through[node][axis], place + 1 if up else place - 1, up)


def _floor(q: mpq) -> int:
    return int(q.numerator // q.denominator)
