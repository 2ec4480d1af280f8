"""Widths between the lines of blocks, and the cuts of the recursion, for the checkers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from gmpy2 import mpq, mpz

from bern_exact.convex.block_records import LEAF, Block, Node, Reduced
from bern_exact.convex.cells import Cells

Place = tuple[Block, int]
"""A block and the number of a node in it."""


class Widths:
    """Distances of lines, each subtracted once.

    Parameters
    ----------
    coordinates : sequence of mpq
        Of the verticals or of the horizontals.
    """

    def __init__(self, coordinates: Sequence[mpq]) -> None:
        self._coordinates = coordinates
        self._known: dict[tuple[int, int], mpq] = {}

    def between(self, near: int, far: int) -> mpq:
        """The distance from one line to another one."""
        found = self._known.get((near, far))
        if found is None:
            found = self._coordinates[far] - self._coordinates[near]
            self._known[near, far] = found
        return found

    def of(self, lines: Sequence[int]) -> list[mpq]:
        """The distance from each line to the next."""
        return [self.between(a, b) for a, b in pairwise(lines)]


class Cut(NamedTuple):
    """A node with its true measures.

    Parameters
    ----------
    place : Place
        Where it is.
    node : Node
        The node, not a leaf.
    strips, gaps : list of mpq
        The widths of its strips, and between the lines across them.
    """

    place: Place
    node: Node
    strips: list[mpq]
    gaps: list[mpq]

    @property
    def is_double(self) -> bool:
        """Are there two strips between which lines can be removed?"""
        return self.node.first < self.node.last

    @property
    def width(self) -> mpq:
        """The lesser width of l and r."""
        return min(self.strips[self.node.first], self.strips[self.node.last])


class Measured:
    """The lines of a region, measured."""

    def __init__(self, cells: Cells) -> None:
        self._along = Widths(cells.xs), Widths(cells.ys)

    def cuts(self, reduced: Reduced) -> Iterator[Cut]:
        """All nodes but leaves."""
        for block in reduced.blocks:
            for i, node in enumerate(block.nodes):
                if node.level != LEAF:
                    yield self.cut((block.block, i), node)

    def cut(self, place: Place, node: Node) -> Cut:
        """One node."""
        across, along = self._along[node.turned], self._along[not node.turned]
        return Cut(place, node, across.of(node.strips), along.of(node.lines))

    def sizes(self, node: Node) -> tuple[list[mpq], list[mpq]]:
        """The widths of its columns and the heights of its rows."""
        return self._along[0].of(node.columns), self._along[1].of(node.rows)

    def width(self, a: int, b: int) -> mpq:
        """The distance of two verticals, in either order."""
        return self._along[0].between(min(a, b), max(a, b))

    def height(self, a: int, b: int) -> mpq:
        """The distance of two horizontals, in either order."""
        return self._along[1].between(min(a, b), max(a, b))


def squared_ratio(a: mpq, c: mpq, d: mpq) -> tuple[mpz, mpz]:
    """a^2/(c d), not reduced."""
    return (
        a.numerator**2 * c.denominator * d.denominator,
        a.denominator**2 * c.numerator * d.numerator,
    )
