"""How a ray leaves v through its block: the finitely many types, by sections of grid lines.

A ray is looked at in its own frame, turned by quarters about the centre of the square of v, so
that it goes up: its direction is (m, 1) with |m| <= 1.  It crosses row 1 at X1 and row 2 at X2,
and at most one column below row 1 and one between the rows.  Its type says in which section of a
row each X lies, and how near to grid vertices it crosses the columns.

Three parts of a unit segment: within tau of its lower end, of its upper end, or of neither.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

GridNode = tuple[int, int]

LOW, MIDDLE, HIGH = range(3)
"""The parts of a unit segment: nearer than tau to its lower end, to neither, to its upper end."""

E, F = 0, 1
"""The rays: e, the outgoing edge, with the interior on its left, and f, the incoming edge."""


class RayType(NamedTuple):
    """The type of a ray in its own frame.

    Parameters
    ----------
    cell_1, part_1 : int
        X1 lies in [cell, cell + 1], in this part of it: -1, 0 or 1.
    cell_2, part_2 : int
        Likewise X2, from -2 to 2; at -2 and 2 only being within tau of the block matters.
    below, above : int
        The part in which a column is crossed below row 1 (row 1 and row 2); -1 if none is.
    """

    cell_1: int
    part_1: int
    cell_2: int
    part_2: int
    below: int
    above: int

    @property
    def column_below(self) -> int:
        """The column that is crossed below row 1."""
        return 1 if self.cell_1 == 1 else 0

    @property
    def column_above(self) -> int:
        """The column that is crossed between row 1 and row 2."""
        return max(self.cell_1, self.cell_2)

    @property
    def section_1(self) -> int:
        """The section of row 1, from left to right."""
        return 3 * self.cell_1 + self.part_1

    @property
    def section_2(self) -> int:
        """The section of row 2, from left to right."""
        return 3 * self.cell_2 + self.part_2

    @property
    def sign(self) -> int:
        """The sign of m, or 0 if the type leaves it open."""
        if self.cell_1:
            return self.cell_1
        if self.section_2 != self.section_1:
            return 1 if self.section_2 > self.section_1 else -1
        return 0

    @property
    def clear_below(self) -> int:
        """`Cross.clear` of the column below row 1; of row 0 nothing is known."""
        return 0 if self.part_1 == (LOW if self.cell_1 == 1 else HIGH) else 2

    @property
    def clear_above(self) -> int:
        """`Cross.clear` of the column between row 1 and row 2."""
        before, beyond = (HIGH, LOW) if self.cell_2 > self.cell_1 else (LOW, HIGH)
        return (self.part_1 != before) + 2 * (self.part_2 != beyond)


@cache
def ray_types() -> tuple[RayType, ...]:
    """All types that a ray with |m| <= 1 can have.

    X1 - x = (1 - y) m and X2 - X1 = m have the same sign.  A column that is crossed within tau
    of a grid vertex has the row through it crossed within tau of it, as |m| <= 1.  A row that is
    crossed further than 1 - tau from such a column, in its cell beyond, has the column crossed
    further than 1 - tau from itself.
    """
    return tuple(_types())


def _types() -> Iterator[RayType]:
    for cell_1 in (-1, 0, 1):
        for part_1 in (LOW, MIDDLE, HIGH):
            for cell_2, part_2 in _second_sections(cell_1, part_1):
                for below in _parts_below(cell_1, part_1):
                    for above in _parts_above(cell_1, part_1, cell_2, part_2):
                        yield RayType(cell_1, part_1, cell_2, part_2, below, above)


def _second_sections(cell: int, part: int) -> Iterator[tuple[int, int]]:
    for cell_2 in (cell - 1, cell, cell + 1):
        for part_2 in (LOW, MIDDLE, HIGH):
            if (cell_2, part_2) in ((2, HIGH), (-2, LOW)):
                continue  # not told apart from the middle: both far from the block
            if cell == 1 and (cell_2, part_2) < (cell, part):
                continue
            if cell == -1 and (cell_2, part_2) > (cell, part):
                continue
            yield cell_2, part_2


def _parts_below(cell_1: int, part_1: int) -> Iterator[int]:
    if cell_1 == 0:
        yield -1
        return
    near, far = (LOW, HIGH) if cell_1 == 1 else (HIGH, LOW)
    yield LOW
    if part_1 != far:
        yield MIDDLE
    if part_1 == near:
        yield HIGH


def _parts_above(cell_1: int, part_1: int, cell_2: int, part_2: int) -> Iterator[int]:
    if cell_1 == cell_2:
        yield -1
        return
    low, high = (LOW, HIGH) if cell_2 > cell_1 else (HIGH, LOW)
    if part_1 == high:
        yield LOW
    if part_1 != low and part_2 != high:
        yield MIDDLE
    if part_2 == low:
        yield HIGH


class Cross(NamedTuple):
    """A q-vertex of a ray.

    Parameters
    ----------
    ray : int
        E or F.
    kind : str
        "row" or "column" of the ray's own frame ...
    level : int
        ... row 1 or 2; or 0 for the column below row 1, 1 for that between the rows.
    column : int
        The column, for a column.
    segment : (GridNode, GridNode)
        The unit segment that it lies on, from its lower or left end, in the frame of the block.
    part : int
        Where on this segment.
    own : int
        The same in the ray's own frame.
    inner, anchor : GridNode
        The ends of the segment on the interior and on the exterior side.
    inside : bool
        Is it in the block?
    clear : int
        Of a column: 1 if the ray crosses the row below at least tau from it, plus 2 if the row
        above.
    """

    ray: int
    kind: str
    level: int
    column: int
    segment: tuple[GridNode, GridNode]
    part: int
    own: int
    inner: GridNode
    anchor: GridNode
    inside: bool
    clear: int


def turned(quarters: int, node: GridNode) -> GridNode:
    """A node of a ray's own frame in that of the block: turned about the centre of v's square.

    >>> [turned(quarters, (0, 2)) for quarters in range(4)]
    [(0, 2), (-1, 0), (1, -1), (2, 1)]
    """
    k, l = node  # noqa: E741
    return ((k, l), (1 - l, k), (1 - k, 1 - l), (l, 1 - k))[quarters]


def turned_cell(quarters: int, cell: GridNode) -> GridNode:
    """A unit cell, given by its lower left corner, likewise."""
    ends = (turned(quarters, cell), turned(quarters, (cell[0] + 1, cell[1] + 1)))
    return min(ends[0][0], ends[1][0]), min(ends[0][1], ends[1][1])


def crossings(ray: int, quarters: int, kind: RayType) -> list[tuple[Cross, GridNode]]:
    """The q-vertices of a ray from v outwards, each with the cell that the ray enters there.

    The crossing of row 2 is left out if it is further than tau from the block.
    """
    found: list[tuple[Cross, GridNode]] = []

    def add(
        name: str, level: int, low: GridNode, part: int, enters: GridNode, clear: int = 0
    ) -> None:
        along = (1, 0) if name == "row" else (0, 1)
        high = (low[0] + along[0], low[1] + along[1])
        # The left of the ray is the lower end of a row, and the upper one of a column if m > 0.
        rightwards = enters[0] == low[0]
        left, right = (low, high) if name == "row" or not rightwards else (high, low)
        inner, anchor = (left, right) if ray == E else (right, left)
        own, ends = part, (turned(quarters, low), turned(quarters, high))
        if ends[0] > ends[1]:
            ends, part = (ends[1], ends[0]), 2 - part
        inside = -1 <= low[0] and high[0] <= 2
        found.append(
            (
                Cross(
                    ray,
                    name,
                    level,
                    low[0],
                    ends,
                    part,
                    own,
                    turned(quarters, inner),
                    turned(quarters, anchor),
                    inside,
                    clear,
                ),
                turned_cell(quarters, enters),
            )
        )

    if kind.below >= 0:
        add("column", 0, (kind.column_below, 0), kind.below, (kind.cell_1, 0), kind.clear_below)
    add("row", 1, (kind.cell_1, 1), kind.part_1, (kind.cell_1, 1))
    if kind.above >= 0:
        enters = (kind.cell_2, 1)
        add("column", 1, (kind.column_above, 1), kind.above, enters, kind.clear_above)
    if abs(kind.cell_2) < 2 or kind.part_2 != MIDDLE:
        add("row", 2, (kind.cell_2, 2), kind.part_2, (kind.cell_2, 2))
    return found
