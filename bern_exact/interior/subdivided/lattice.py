"""Columns and rows of cells, the chords between neighbours, and look-ups among them.

Rows are the columns of the region mirrored in the diagonal x = y, so everything is
written once, for columns.  A region may be slit: an edge and its reverse may both be
on the boundary (`bridges`).
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from bern_exact.interior.records import GridNode, Rectilinear
from bern_exact.interior.rectilinear import UnmatchedEdge
from bern_exact.interior.subdivided.records import SubdividedRectangle


class Strip(NamedTuple):
    """A column [near, far] x [low, high], or the row [low, high] x [near, far].

    Parameters
    ----------
    near, far : int
        The lines along it.
    low, high : int
        The lines that end it.
    """

    near: int
    far: int
    low: int
    high: int


class End(NamedTuple):
    """A boundary edge that ends a strip: from vertex `head - 1` to `head` of a loop."""

    loop: int
    head: int


class Strips:
    """Strips with disjoint interiors, to be found by the line where they begin.

    Parameters
    ----------
    strips : sequence of Strip
        In any order; positions in it are what is found.
    """

    def __init__(self, strips: Sequence[Strip]) -> None:
        self.strips = strips
        self._by_near = _grouped((s.near, s.low, i) for i, s in enumerate(strips))
        self._by_far = _grouped((s.far, s.low, i) for i, s in enumerate(strips))

    def after(self, line: int, at: int) -> int:
        """The strip that begins at the line and has low <= at < high, -1 if none."""
        return self._found(self._by_near, line, at)

    def before(self, line: int, at: int) -> int:
        """The strip that ends at the line and has low <= at < high, -1 if none."""
        return self._found(self._by_far, line, at)

    def _found(self, groups: dict[int, tuple[list[int], list[int]]], line: int, at: int) -> int:
        lows, which = groups.get(line, ((), ()))
        place = bisect_right(lows, at) - 1
        if place < 0 or self.strips[which[place]].high <= at:
            return -1
        return which[place]

    def crossed(self, at: int, start: int, stop: int) -> tuple[int, ...]:
        """The lines strictly between two others that a segment just beyond `at` crosses.

        The segment runs across strips, from the line `start` to the line `stop`, and lies
        inside the region.
        """
        lines = []
        line = self.strips[self.after(start, at)].far
        while line < stop:
            lines.append(line)
            line = self.strips[self.after(line, at)].far
        return tuple(lines)

    def chords(self) -> list[tuple[int, int]]:
        """All pairs of strips, one ending where the other begins, with a common piece.

        By (line, low).  The piece is max(lows) to min(highs).  Walls of slits are not looked at.
        """
        pairs = []
        for line in sorted(self._by_near.keys() & self._by_far.keys()):
            pairs += self._common(self._by_far[line][1], self._by_near[line][1])
        return pairs

    def _common(self, ending: Sequence[int], beginning: Sequence[int]) -> list[tuple[int, int]]:
        """The pairs of overlapping strips of two sorted lists."""
        pairs = []
        i = j = 0
        while i < len(ending) and j < len(beginning):
            first, second = self.strips[ending[i]], self.strips[beginning[j]]
            if max(first.low, second.low) < min(first.high, second.high):
                pairs.append((ending[i], beginning[j]))
            if first.high <= second.high:
                i += 1
            else:
                j += 1
        return pairs


def _grouped(items: Iterable[tuple[int, int, int]]) -> dict[int, tuple[list[int], list[int]]]:
    """line -> (lows, indices), sorted."""
    groups: dict[int, tuple[list[int], list[int]]] = {}
    for line, low, index in sorted(items):
        lows, indices = groups.setdefault(line, ([], []))
        lows.append(low)
        indices.append(index)
    return groups


Loops = Sequence[Sequence[GridNode]]


def mirrored(loops: Loops) -> list[list[GridNode]]:
    """The loops mirrored in the diagonal, interior still on the left."""
    return [[(y, x) for x, y in reversed(loop)] for loop in loops]


def is_hole(loop: Sequence[GridNode]) -> bool:
    """Is the loop clockwise?"""
    return sum(loop[i - 1][0] * y - x * loop[i - 1][1] for i, (x, y) in enumerate(loop)) < 0


def strips_of(loops: Loops) -> tuple[list[Strip], list[tuple[End, End]]]:
    """The columns of a region with the matching condition, and the edges that end them.

    Raises
    ------
    UnmatchedEdge
        If bottoms and tops between two lines do not alternate.

    Notes
    -----
    O(N log N).  In a slit region a top and a bottom can coincide; the top is that of
    the lower column.
    """
    stacks: dict[tuple[int, int], list[tuple[int, bool, End]]] = {}
    for number, loop in enumerate(loops):
        for i, (x, y) in enumerate(loop):
            px, py = loop[i - 1]
            if py == y:
                stack = stacks.setdefault((min(px, x), max(px, x)), [])
                stack.append((y, px < x, End(number, i)))
    strips, ends = [], []
    for (near, far), stack in sorted(stacks.items()):
        stack.sort()
        if len(stack) % 2 or any(entry[1] is bool(i % 2) for i, entry in enumerate(stack)):
            heights = [y for y, _, _ in stack]
            raise UnmatchedEdge(f"between lines {near} and {far}: {heights}")
        for bottom, top in zip(stack[::2], stack[1::2], strict=True):
            strips.append(Strip(near, far, bottom[0], top[0]))
            ends.append((bottom[2], top[2]))
    return strips, ends


def components(region: Rectilinear) -> tuple[Rectilinear, ...]:
    """The connected components of a region, holes with what they are in.

    A column joins the loops at its two ends.  That is enough: from the top of a hole a
    column leads to a loop that reaches higher.

    Notes
    -----
    By their first loops.  O(N log N).
    """
    parent = list(range(len(region.loops)))

    def root(loop: int) -> int:
        while parent[loop] != loop:
            parent[loop] = loop = parent[parent[loop]]
        return loop

    for bottom, top in strips_of(region.loops)[1]:
        first, second = sorted((root(bottom.loop), root(top.loop)))
        parent[second] = first
    members: dict[int, list[tuple[GridNode, ...]]] = {}
    for number, loop in enumerate(region.loops):
        members.setdefault(root(number), []).append(loop)
    return tuple(Rectilinear(tuple(loops)) for loops in members.values())


def vertices_by_euler(region: Rectilinear, faces: int, sides: int) -> int:
    """V of a partition into `faces` rectangles with `sides` edges in all, by Euler's formula.

    V - E + F = components - holes, which is columns minus vertical chords; each edge is a side
    of two rectangles, or of one and of the region.  A vertex where the region touches itself
    counts once for each sector.
    """
    columns = Strips(strips_of(region.loops)[0])
    euler = len(columns.strips) - len(columns.chords())
    return (sides + region.edges) // 2 - faces + euler


@dataclass(frozen=True)
class Lattice:
    """A region's columns and rows.

    Parameters
    ----------
    columns, rows : Strips
        All of them.
    """

    columns: Strips
    rows: Strips

    @classmethod
    def of(cls, region: Rectilinear) -> Lattice:
        """The lattice of a region with the matching condition.  O(N log N)."""
        return cls(Strips(strips_of(region.loops)[0]), Strips(strips_of(mirrored(region.loops))[0]))

    def subdivided(self, x0: int, x1: int, y0: int, y1: int) -> SubdividedRectangle:
        """A rectangle of cells with a vertex where each line crosses its sides.

        All of them are needed: each line ends in boundary vertices, and the matching
        condition carries these on through every rectangle that the line crosses.
        """
        up = self.rows.crossed(x0, y0, y1)
        across = self.columns.crossed(y0, x0, x1)
        return SubdividedRectangle(x0, x1, y0, y1, up, up, across, across)
