"""Pictures of Section 5.1: the merged blocks, Figure 10 and Figure 11."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from bern_exact.convex.block_records import (
    LEAF,
    OUTER,
    Block,
    Blocks,
    Node,
    Reduced,
    ReducedBlock,
)
from bern_exact.convex.cells import Cells, GridPoint
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.view.layers import Layer

PARTS = ("outer", "halfway", "between")
"""Corners of a block, outer parts with every second line, and the middle (Figure 11(b))."""


class Places:
    """The grid points of a region, each turned into a homogeneous point once."""

    def __init__(self, cells: Cells) -> None:
        self._cells = cells
        self._known: dict[GridPoint, HPoint] = {}

    def all(self, points: Sequence[GridPoint]) -> list[HPoint]:
        """Where these grid points are."""
        return [self._at(p) for p in points]

    def box(self, x0: int, x1: int, y0: int, y1: int) -> list[HPoint]:
        """The corners of a rectangle between lines."""
        return self.all(((x0, y0), (x1, y0), (x1, y1), (x0, y1)))

    def _at(self, point: GridPoint) -> HPoint:
        found = self._known.get(point)
        if found is None:
            found = hpoint(self._cells.xs[point[0]], self._cells.ys[point[1]])
            self._known[point] = found
        return found


def merged_layers(record: Blocks) -> list[Layer]:
    """The blocks, and all lines through them."""
    places = Places(record.cells)
    lines = [
        places.all(ends)
        for block in record.blocks
        for ends in _lines(_all_lines(block), inner=True)
    ]
    boxes = [places.box(*block) for block in record.blocks]
    return [Layer("cell", boxes), Layer("line", lines), Layer("outline", boxes)]


def _all_lines(block: Block) -> tuple[range, range]:
    return range(block.x0, block.x1 + 1), range(block.y0, block.y1 + 1)


def _lines(lists: tuple[Sequence[int], Sequence[int]], *, inner: bool) -> Iterator[list[GridPoint]]:
    """The segments of verticals and horizontals in their rectangle."""
    xs, ys = lists
    part = slice(1, -1) if inner else slice(None)
    yield from ([(x, ys[0]), (x, ys[-1])] for x in xs[part])
    yield from ([(xs[0], y), (xs[-1], y)] for y in ys[part])


def reduced_layers(record: Reduced) -> list[Layer]:
    """Figure 10: the triangles, those of Lemma 10 marked, and the lines removed."""
    places = Places(record.merged.cells)
    halved: list[list[HPoint]] = []
    others: list[list[HPoint]] = []
    removed: list[list[HPoint]] = []
    for block in record.blocks:
        apexes = {apex for node in block.nodes for apex in _apexes(node)}
        for triangle in block.triangles:
            ring = places.all(triangle)
            (halved if _is_halved(triangle, apexes) else others).append(ring)
        removed += [places.all(ends) for node in block.nodes for ends in _removed(node)]
    boxes = [places.box(*block) for block in record.merged.blocks]
    return [
        Layer("cell", others),
        Layer("halved", halved),
        Layer("removed", removed),
        Layer("outline", boxes),
    ]


def _apexes(node: Node) -> Iterator[tuple[GridPoint, GridPoint, GridPoint]]:
    """For each use of Lemma 10 the subdivision and the two corners that it is joined to."""
    for strip, low, middle, high, far in node.halved():
        sides = node.strips[strip : strip + 2]
        outer, inner = (sides[1], sides[0]) if far else (sides[0], sides[1])
        corners = (outer, middle), (inner, low), (inner, high)
        if node.turned:
            corners = (middle, outer), (low, inner), (high, inner)
        yield corners


def _is_halved(
    triangle: tuple[GridPoint, GridPoint, GridPoint],
    apexes: set[tuple[GridPoint, GridPoint, GridPoint]],
) -> bool:
    """Is it the middle one of the three triangles of Lemma 10?"""
    for i in range(3):
        p, q, r = triangle[i], triangle[i - 2], triangle[i - 1]
        if (p, q, r) in apexes or (p, r, q) in apexes:
            return True
    return False


def _removed(node: Node) -> Iterator[list[GridPoint]]:
    """The pieces of lines that are not there any more, from the outer side of l to that of r."""
    if node.level != LEAF:
        near, far = node.strips[node.first], node.strips[node.last + 1]
        for line in node.removed:
            yield [(line, near), (line, far)] if node.turned else [(near, line), (far, line)]


def part_layers(record: Reduced) -> list[Layer]:
    """Figure 11: the seven parts of each block, and the strips between them, with their lines."""
    places = Places(record.merged.cells)
    kinds: dict[str, list[list[HPoint]]] = {name: [] for name in ("cell", "strip", *PARTS)}
    lines: list[list[HPoint]] = []
    for block in record.blocks:
        root = block.nodes[-1]
        if root.level == LEAF:
            kinds["cell"].append(places.box(*block.block))
        for kind, node in _parts(block, root):
            if kind == "strip":
                kinds[kind] += [places.box(*box) for box in _strips(node)]
                continue
            columns, rows = node.columns, node.rows
            kinds[kind].append(places.box(columns[0], columns[-1], rows[0], rows[-1]))
            lines += [places.all(ends) for ends in _lines((columns, rows), inner=True)]
    boxes = [places.box(*block) for block in record.merged.blocks]
    layers = [Layer(name, rings) for name, rings in kinds.items()]
    return [*layers, Layer("line", lines), Layer("outline", boxes)]


def _parts(block: ReducedBlock, root: Node) -> Iterator[tuple[str, Node]]:
    """The nodes that a block is first divided into, by kind; those with strips as "strip"."""
    if root.level == LEAF:
        return
    yield "strip", root
    for place, j in enumerate(root.parts):
        if j < 0:
            continue
        part = block.nodes[j]
        if place == 1 or part.level != OUTER:
            yield ("between" if place == 1 else "outer"), part
            continue
        yield "strip", part
        for inside, i in enumerate(part.parts):
            if i >= 0:
                yield ("halfway" if inside == 1 else "outer"), block.nodes[i]


def _strips(node: Node) -> Iterator[tuple[int, int, int, int]]:
    """l and r of a node."""
    for strip in sorted({node.first, node.last}):
        near, far = node.strips[strip : strip + 2]
        low, high = node.lines[0], node.lines[-1]
        yield (low, high, near, far) if node.turned else (near, far, low, high)
