"""Pictures of Section 5: Figure 9's bounced paths, and the grid that they make."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator

from gmpy2 import mpq

from bern_exact.convex.chains import Sigma
from bern_exact.convex.records import UPPER, Bounced, ConvexFrame, Gridded, RightTriangle
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.view.layers import Layer

Line = list[HPoint]


def frame_layers(record: ConvexFrame) -> list[Layer]:
    """P and its diameter."""
    diameter = [hpoint(0, 0), hpoint(1, 0)]
    return [Layer("line", [diameter]), _outline(record)]


def bounced_layers(record: Bounced) -> list[Layer]:
    """Figure 9: verticals and horizontals; those of bounced and of closed paths in colour."""
    styles: dict[str, list[Line]] = {"line": [[hpoint(0, 0), hpoint(1, 0)]]}
    styles |= {"bounced": [], "closed": []}
    kind = {x: "closed" for path in record.closed for x in path}
    kind |= {step.x: "bounced" for step in record.steps}
    kind |= {x: "line" for x, _ in record.frame.places}
    sides = [Sigma(chain) for chain in record.frame.chains]
    for x in record.verticals[1:-1]:
        styles[kind[x]] += _lines_at(record, sides, x)
    layers = [Layer(style, lines) for style, lines in styles.items()]
    return [*layers, _outline(record.frame)]


def _lines_at(record: Bounced, sides: list[Sigma], x: mpq) -> Iterator[Line]:
    """A vertical, and the horizontals from its ends to their last verticals."""
    heights = [side.height(x) for side in sides]
    yield [hpoint(x, heights[0]), hpoint(x, -heights[1])]
    for number, (side, height) in enumerate(zip(sides, heights, strict=True)):
        other = side.partner(x)
        if other is None:
            continue
        # The first vertical at or right of the other end, or the last one at or left of it.
        i = bisect_left(record.verticals, other)
        if other > x and record.verticals[i] != other:
            i -= 1
        y = height if number == UPPER else -height
        yield [hpoint(x, y), hpoint(record.verticals[i], y)]


def grid_layers(record: Gridded) -> list[Layer]:
    """The cells, by their columns and rows, and the right triangles along the boundary."""
    xs, ys = record.cells.xs, record.cells.ys
    columns = [
        [hpoint(xs[j + right], ys[i]) for right, i in ((0, low), (1, low), (1, high), (0, high))]
        for j, (low, high) in enumerate(zip(record.cells.low, record.cells.high, strict=True))
        if low < high
    ]
    rows = [[hpoint(xs[start], ys[i]), hpoint(xs[end], ys[i])] for i, start, end in _rows(record)]
    rim = [_ring(record, triangle) for leg in record.legs for triangle in leg.triangles]
    outline = _outline(record.bounced.frame)
    return [Layer("cell", columns), Layer("line", rows), Layer("rim", rim), outline]


def _rows(record: Gridded) -> Iterator[tuple[int, int, int]]:
    """Each horizontal with the first and the last vertical that it meets."""
    low, high = record.cells.low, record.cells.high
    first: dict[int, int] = {}
    last: dict[int, int] = {}
    for j in range(len(low)):
        for i in range(low[j], high[j] + 1) if low[j] < high[j] else ():
            first.setdefault(i, j)
            last[i] = j + 1
    return ((i, first[i], last[i]) for i in first)


def _ring(record: Gridded, triangle: RightTriangle) -> Line:
    return [hpoint(*record.position(corner)) for corner in triangle]


def _outline(record: ConvexFrame) -> Layer:
    ring = record.polygon.rings[0]
    return Layer("outline", [[hpoint(*record.places[v]) for v in ring]])
