"""Do the sides of a mesh enclose a region, each point of it once?  An exact sweep.

As in `plane/simplicity.py`, two edges are tested when they become neighbours in the status, and an
edge through a vertex is found by the bisection there; but any even number of sides may meet in a
vertex.  Sides that meet in common ends alone have one triangle on their left and none on their
right just if, from below, every vertical line meets them alternately running right and left.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from functools import cmp_to_key

from bern_exact.exact.points import HPoint, Line, line_through
from bern_exact.exact.predicates import orientation, side
from bern_exact.plane.status import count_below, lexicographic_ranks

Side = tuple[int, int, int]
"""Tail, head, and how much more often the edge is used than its reverse."""


def enclose_once(vertices: Sequence[HPoint], sides: Sequence[Side]) -> bool:
    """Do sides meet in common ends alone, and wind once round what is on their left, alone?

    Parameters
    ----------
    vertices : sequence of HPoint
        The mesh's vertices.
    sides : sequence of Side
        Tail, head (two different points) and how often; vertices at one point are one number.

    Notes
    -----
    O(n log n) comparisons for n sides, and moves of memory in a list.

    Examples
    --------
    >>> from bern_exact.exact.points import grid_point
    >>> square = [grid_point(0, 0), grid_point(1, 0), grid_point(1, 1), grid_point(0, 1)]
    >>> enclose_once(square, [(0, 1, 1), (1, 2, 1), (2, 3, 1), (3, 0, 1)])
    True
    >>> enclose_once(square, [(1, 0, 1), (2, 1, 1), (3, 2, 1), (0, 3, 1)])
    False
    """
    return all(times == 1 for _, _, times in sides) and _Sweep(vertices, sides).run()


class _Sweep:
    """The sweep over the ends of the sides in lexicographic order."""

    def __init__(self, vertices: Sequence[HPoint], sides: Sequence[Side]) -> None:
        numbers = sorted({v for side_ in sides for v in side_[:2]})
        place = {v: i for i, v in enumerate(numbers)}
        self.points = [vertices[v] for v in numbers]
        self.order, rank = lexicographic_ranks(self.points)
        self.runs_right = [rank[place[a]] < rank[place[b]] for a, b, _ in sides]
        self.ends: list[tuple[int, int]] = []  # the first and the second that the sweep meets
        self.beginning: dict[int, list[int]] = defaultdict(list)
        self.ending: dict[int, list[int]] = defaultdict(list)
        for e, (a, b, _) in enumerate(sides):
            first, second = (place[a], place[b]) if self.runs_right[e] else (place[b], place[a])
            self.ends.append((first, second))
            self.beginning[first].append(e)
            self.ending[second].append(e)
        self.lines: list[Line] = [
            line_through(self.points[v], self.points[w]) for v, w in self.ends
        ]
        self.status: list[int] = []

    def run(self) -> bool:
        """Sweep until something is amiss."""
        return all(map(self._passes, self.order))

    def _passes(self, v: int) -> bool:
        """Is all well at a vertex?  Its sides to the left are replaced by those to the right."""
        status, ending, beginning = self.status, self.ending[v], self._from_below(v)
        if len(ending) % 2 != len(beginning) % 2:
            return False
        position = count_below(status, self.lines, self.points[v])
        above = position + len(ending)
        if sorted(status[position:above]) != sorted(ending):
            return False
        if above < len(status) and side(self.lines[status[above]], self.points[v]) == 0:
            return False
        status[position:above] = beginning
        top = position + len(beginning)
        return (
            all(self.runs_right[status[i]] == (i % 2 == 0) for i in range(position, top))
            and all(self._turn_left(v, *status[i : i + 2]) for i in range(position, top - 1))
            and self._are_apart(position)
            and self._are_apart(top)
        )

    def _from_below(self, v: int) -> list[int]:
        """The sides that begin at a vertex, from below."""
        p, beginning = self.points[v], self.beginning[v]

        def compare(e: int, f: int) -> int:
            return -orientation(p, self._head(e), self._head(f))

        return sorted(beginning, key=cmp_to_key(compare)) if len(beginning) > 1 else beginning

    def _head(self, e: int) -> HPoint:
        """The end of a side that the sweep meets second."""
        return self.points[self.ends[e][1]]

    def _turn_left(self, v: int, e: int, f: int) -> bool:
        """Is f above e, both of which begin at v?  If not, they overlap."""
        return orientation(self.points[v], self._head(e), self._head(f)) > 0

    def _are_apart(self, position: int) -> bool:
        """Do the sides just below and from `position` on not meet, but for a common end?"""
        if not 0 < position < len(self.status):
            return True
        e, f = self.status[position - 1], self.status[position]
        if set(self.ends[e]) & set(self.ends[f]):
            return True  # if they overlap, that is found at their ends
        return self._on_one_side(e, f) or self._on_one_side(f, e)

    def _on_one_side(self, e: int, f: int) -> bool:
        """Are both ends of e strictly on one side of f's line?"""
        first, second = (side(self.lines[f], self.points[v]) for v in self.ends[e])
        return first * second > 0
