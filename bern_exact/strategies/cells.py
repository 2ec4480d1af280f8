"""Rectilinear rings: outlines of sets of unit cells that grow without holes."""

from __future__ import annotations

from collections.abc import Sequence

from bern_exact.strategies.rings import Place, Ring

SIDES = ((1, 0), (0, 1), (-1, 0), (0, -1))
AROUND = ((1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1))
"""The eight cells round a cell, in order; those at even places share an edge with it."""


class Cells:
    """A set of unit cells whose outline is one simple ring.

    A cell may be added if those of the eight round it that are there form one chain, with a side
    of it in common: then the outline stays one ring that does not touch itself.
    """

    def __init__(self) -> None:
        self.there: dict[Place, None] = {(0, 0): None}

    def candidates(self) -> list[Place]:
        """The cells that may be added, in order."""
        beside = {
            (x + dx, y + dy): None
            for x, y in self.there
            for dx, dy in SIDES
            if (x + dx, y + dy) not in self.there
        }
        return [cell for cell in sorted(beside) if self._may_be_added(cell)]

    def _may_be_added(self, cell: Place) -> bool:
        x, y = cell
        around = [(x + dx, y + dy) in self.there for dx, dy in AROUND]
        # A cell at a corner counts only with a neighbour of both: alone it would touch at a point.
        starts = sum(here and not around[i - 1] for i, here in enumerate(around))
        first = next((i for i, here in enumerate(around) if here and not around[i - 1]), 0)
        length = 0
        while length < len(AROUND) and around[(first + length) % len(AROUND)]:
            length += 1
        return starts == 1 and (length > 1 or first % 2 == 0)

    def corners_with(self, cell: Place | None = None) -> int:
        """How many corners the outline has, with one more cell."""
        there = self.there if cell is None else {**self.there, cell: None}
        count = 0
        for x, y in {(x + i, y + j): None for x, y in there for i in (0, 1) for j in (0, 1)}:
            filled = [(x - i, y - j) in there for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
            count += sum(filled) % 2
        return count

    def add(self, cell: Place) -> None:
        """Add a cell."""
        self.there[cell] = None

    def ring(self) -> Ring:
        """The corners of the outline, counter-clockwise, from the lowest of the leftmost on."""
        ahead: dict[Place, Place] = {}
        for x, y in self.there:
            corners = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
            for (dx, dy), p, q in zip(
                ((0, -1), (1, 0), (0, 1), (-1, 0)), corners, corners[1:] + corners[:1], strict=True
            ):
                if (x + dx, y + dy) not in self.there:
                    ahead[p] = q
        start = min(ahead)
        walk = [start]
        while (at := ahead[walk[-1]]) != start:
            walk.append(at)
        n = len(walk)
        return [
            p
            for i, p in enumerate(walk)
            if (walk[i - 1][0] == p[0]) != (p[0] == walk[(i + 1) % n][0])
        ]


def stretched(ring: Sequence[Place], columns: Sequence[int], rows: Sequence[int]) -> Ring:
    """A ring on other lines: the leftmost at 0, then these distances apart; likewise the lowest."""
    xs, ys = (dict.fromkeys(sorted({p[k] for p in ring}), 0) for k in (0, 1))
    for at, gaps in ((xs, columns), (ys, rows)):
        place = 0
        for line, gap in zip(at, (0, *gaps), strict=False):
            place += gap
            at[line] = place
    return [(xs[x], ys[y]) for x, y in ring]
