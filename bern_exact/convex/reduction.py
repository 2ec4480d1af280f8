"""Lemma 12: blocks of cells into fewer right and acute triangles, by removing lines inside them.

A strip is a column or a row of a rectangle.  Between two strips l and r wide enough for Lemma 10
every second line across them ends at their outer sides (Lemma 11); l and r are triangulated, and
the rectangles before, between and after them are treated alike.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

from gmpy2 import mpq

from bern_exact.convex.block_records import (
    LEAF,
    OUTER,
    SPLIT,
    Block,
    Blocks,
    Node,
    Reduced,
    ReducedBlock,
    Triangle,
)
from bern_exact.convex.cells import GridPoint

NOTHING = -1


def reduce_blocks(blocks: Blocks) -> Reduced:
    """Triangulate every block (Lemmas 10 to 12).

    Lemma 12: "A rectangle subdivided into m rows and k columns, with m < k, can be triangulated
    using O(m^0.8475 k) nonobtuse triangles, without introducing any new subdivisions."

    Parameters
    ----------
    blocks : Blocks
        Matching blocks.

    Returns
    -------
    Reduced
        At most 2 m k triangles a block, none obtuse; no block's sides get a new vertex.

    Notes
    -----
    Blocks are lists of lines, cells are never enumerated: apart from the sorting at each node
    the time is linear in the number of triangles.
    """
    columns, rows = Lines.between(blocks.cells.xs), Lines.between(blocks.cells.ys)
    return Reduced(blocks, tuple(reduce_block(block, columns, rows) for block in blocks.blocks))


class Lines(NamedTuple):
    """Parallel lines and the widths of the strips between them.

    Parameters
    ----------
    lines : tuple of int
        Indices of lines, increasing, at least one.
    gaps : tuple of mpq
        The width between each and the next.
    """

    lines: tuple[int, ...]
    gaps: tuple[mpq, ...]

    @classmethod
    def between(cls, coordinates: Sequence[mpq]) -> Lines:
        """All lines at these coordinates."""
        gaps = tuple(b - a for a, b in pairwise(coordinates))
        return cls(tuple(range(len(coordinates))), gaps)

    def part(self, first: int, stop: int) -> Lines:
        """The strips from `first` to before `stop`, with the lines on both sides."""
        return Lines(self.lines[first : stop + 1], self.gaps[first:stop])

    def without(self, removed: Sequence[int]) -> Lines:
        """The rest without the lines at some positions, increasing and never two in a row."""
        lines, gaps = list(self.lines), list(self.gaps)
        for i in reversed(removed):
            gaps[i - 1 : i + 1] = [gaps[i - 1] + gaps[i]]
            del lines[i]
        return Lines(tuple(lines), tuple(gaps))


def reduce_block(block: Block, columns: Lines, rows: Lines) -> ReducedBlock:
    """One block of a grid of columns and rows.

    >>> uniform = Lines.between([mpq(i) for i in range(5)])
    >>> len(reduce_block(Block(0, 4, 0, 4), uniform, uniform).triangles)
    18
    """
    recursion = _Recursion()
    recursion.divide(columns.part(block.x0, block.x1), rows.part(block.y0, block.y1))
    return ReducedBlock(block, tuple(recursion.nodes), tuple(recursion.triangles))


class _Cut(NamedTuple):
    """A rectangle cut along two of its strips.

    Parameters
    ----------
    first, last : int
        l and r, equal if only one strip is wide enough.
    before, between, after : Lines
        The strips around them.
    removed : tuple of int
        The lines removed between l and r.
    kept : Lines
        The lines across what is between.
    """

    first: int
    last: int
    before: Lines
    between: Lines
    after: Lines
    removed: tuple[int, ...]
    kept: Lines


class _Recursion:
    """The nodes and triangles of one block so far."""

    def __init__(self) -> None:
        self.nodes: list[Node] = []
        self.triangles: list[Triangle] = []

    def divide(self, columns: Lines, rows: Lines) -> int:
        """A rectangle with all these lines: Figure 11(a), the outer parts as in (b).

        Returns
        -------
        int
            The node, or `NOTHING` if the rectangle is empty.
        """
        if not columns.gaps or not rows.gaps:
            return NOTHING
        if len(columns.gaps) == 1 or len(rows.gaps) == 1:
            return self._leaf(columns, rows)
        of_columns, of_rows = two_thirds_median(columns.gaps), two_thirds_median(rows.gaps)
        turned = of_columns < of_rows
        strips, lines = (rows, columns) if turned else (columns, rows)
        least = min(of_columns, of_rows)
        start = len(self.triangles)
        cut = self._cut(strips, lines, least, turned)
        parts = (
            self._outer(cut.before, lines, least, turned),
            self._oriented(cut.between, cut.kept, turned),
            self._outer(cut.after, lines, least, turned),
        )
        return self._node(SPLIT, turned, strips, lines, cut, parts, start)

    def _outer(self, strips: Lines, lines: Lines, least: mpq, turned: bool) -> int:
        """Strips all narrower than `least`, cut across: Figure 11(b)."""
        if len(strips.gaps) < 2:
            return self._oriented(strips, lines, turned)
        start = len(self.triangles)
        cut = self._cut(lines, strips, least, not turned)
        parts = (
            self._oriented(cut.before, strips, not turned),
            self._oriented(cut.between, cut.kept, not turned),
            self._oriented(cut.after, strips, not turned),
        )
        return self._node(OUTER, not turned, lines, strips, cut, parts, start)

    def _oriented(self, strips: Lines, lines: Lines, turned: bool) -> int:
        """`divide` for strips that are rows if turned."""
        return self.divide(lines, strips) if turned else self.divide(strips, lines)

    def _node(
        self,
        level: int,
        turned: bool,
        strips: Lines,
        lines: Lines,
        cut: _Cut,
        parts: tuple[int, int, int],
        start: int,
    ) -> int:
        made = len(self.triangles) - start
        self.nodes.append(
            Node(
                level,
                turned,
                strips.lines,
                lines.lines,
                cut.first,
                cut.last,
                cut.removed,
                parts,
                made,
            )
        )
        return len(self.nodes) - 1

    def _leaf(self, columns: Lines, rows: Lines) -> int:
        """One row or one column: each of its rectangles is cut by a diagonal."""
        start = len(self.triangles)
        for near, far in pairwise(columns.lines):
            self.triangles += _strip(near, far, rows.lines, set(), near, False)
        made = len(self.triangles) - start
        none = (NOTHING, NOTHING, NOTHING)
        self.nodes.append(
            Node(LEAF, False, columns.lines, rows.lines, NOTHING, NOTHING, (), none, made)
        )
        return len(self.nodes) - 1

    def _cut(self, strips: Lines, lines: Lines, least: mpq, turned: bool) -> _Cut:
        """Find l and r, remove lines between them, and triangulate both."""
        gaps = strips.gaps
        first = next(i for i, gap in enumerate(gaps) if gap >= least)
        last = next(i for i in reversed(range(len(gaps))) if gaps[i] >= least)
        positions = removable(lines.gaps, min(gaps[first], gaps[last])) if first < last else ()
        removed = tuple(lines.lines[i] for i in positions)
        gone = set(removed)
        near, far = strips.lines[first : first + 2]
        self.triangles += _strip(near, far, lines.lines, gone, near, turned)
        if first < last:
            near, far = strips.lines[last : last + 2]
            self.triangles += _strip(near, far, lines.lines, gone, far, turned)
        return _Cut(
            first,
            last,
            strips.part(0, first),
            strips.part(first + 1, max(last, first + 1)),
            strips.part(last + 1, len(gaps)),
            removed,
            lines.without(positions),
        )


def two_thirds_median(gaps: Sequence[mpq]) -> mpq:
    """The 2/3-median: "m/3 rows are higher than M and 2 m/3 are less high".

    At most floor(2 m/3) are less, and at most ceil(m/3) - 1 are more.

    >>> two_thirds_median([mpq(3), mpq(1), mpq(2), mpq(4)])
    mpq(3,1)
    """
    return sorted(gaps)[2 * len(gaps) // 3]


def removable(gaps: Sequence[mpq], width: mpq) -> tuple[int, ...]:
    """Which lines between two strips of at least this width to remove (Lemma 11).

    Parameters
    ----------
    gaps : sequence of mpq
        The distances of neighbouring lines.
    width : mpq
        The lesser width of the two strips.

    Returns
    -------
    tuple of int
        The positions of as many lines as possible (line i lies between gaps i - 1 and i), no two
        next to each other, each satisfying Lemma 10 between its neighbours.

    >>> removable([mpq(1)] * 6, mpq(1))
    (1, 3, 5)
    """
    found: list[int] = []
    for i in range(1, len(gaps)):
        if (not found or found[-1] < i - 1) and is_mergeable(gaps[i - 1], gaps[i], width):
            found.append(i)
    return tuple(found)


def is_mergeable(c: mpq, d: mpq, a: mpq) -> bool:
    """Can a rectangle a wide with one subdivision, c and d from its ends, do without another?

    Lemma 10, in its exact form: the angle at the subdivision, whose legs end in the two opposite
    corners, has dot product a^2 - c d.  "Its width is greater than either of the distances" is
    sufficient; a^2 >= c d is necessary as well.

    >>> is_mergeable(mpq(4), mpq(1), mpq(2)), is_mergeable(mpq(4), mpq(2), mpq(2))
    (True, False)
    """
    if c <= a and d <= a:
        return True
    if c >= a and d >= a:
        return False
    # Without reducing fractions, which would cost most of the time.
    product = c.numerator * d.numerator * a.denominator**2
    return bool(product <= a.numerator**2 * c.denominator * d.denominator)


def _strip(
    near: int, far: int, lines: Sequence[int], removed: set[int], outer: int, turned: bool
) -> list[Triangle]:
    """One strip, triangulated: all lines end on its side `outer`, on the other those not removed.

    Two triangles a rectangle; three for two rectangles with the line between them removed.
    """
    found: list[Triangle] = []
    swapped = turned != (outer == far)
    inner = near if outer == far else far

    def add(p: GridPoint, q: GridPoint, r: GridPoint) -> None:
        found.append((p, r, q) if swapped else (p, q, r))

    def at(strip: int, line: int) -> GridPoint:
        return (line, strip) if turned else (strip, line)

    below = at(outer, lines[0]), at(inner, lines[0])
    i = 1
    while i < len(lines):
        if lines[i] in removed:
            middle = at(outer, lines[i])
            above = at(outer, lines[i + 1]), at(inner, lines[i + 1])
            add(below[0], below[1], middle)
            add(below[1], above[1], middle)
            add(middle, above[1], above[0])
            i += 2
        else:
            above = at(outer, lines[i]), at(inner, lines[i])
            add(below[0], below[1], above[1])
            add(below[0], above[1], above[0])
            i += 1
        below = above
    return found
