"""Dicing (Section 2): general position, one vertex a sheet, and which intervals are kept."""

from __future__ import annotations

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterator

from gmpy2 import mpq

from bern_exact.boundary.records import HORIZONTAL, VERTICAL, Crossing, Diced, Framed, Interval
from bern_exact.checkers import bounds_grid
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.exact.points import direction, grid_point
from bern_exact.exact.predicates import is_in_wedge
from bern_exact.plane.polygon import Polygon

FRAMED = "framed"
STAGE = "diced"

Square = tuple[int, int]
Box = tuple[Square, Square]
"""The lower left and the upper right corner of a block."""


def check_frame(framed: Framed) -> list[Finding]:
    """Check the grid unit, the similarity and general position (Section 2, step 4 of the guide).

    Linear time.
    """
    return [
        *_check_unit(framed),
        _check_similarity(framed),
        *_check_general_position(framed.polygon),
        _check_sheets(framed),
    ]


def check_dicing(diced: Diced) -> list[Finding]:
    """Check the kept intervals (Section 2): how many, where they end, and that none is missing.

    O(n log n).
    """
    n, most = diced.framed.polygon.n, bounds_grid.intervals_a_vertex(diced.framed.blocks)
    kept = Extreme(greatest=True)
    kept.offer(len(diced.vertical) + len(diced.horizontal), 1, {"n'": n})
    return [
        kept.finding(
            "dicing.intervals",
            STAGE,
            f"at most {most} intervals of grid lines are kept per vertex of P'",
            most * n,
        ),
        _check_crossings(diced),
        _check_covered(diced),
    ]


def squares(polygon: Polygon) -> list[Square]:
    """The grid square (floor x, floor y) of each vertex."""
    return [(int(x // w), int(y // w)) for x, y, w in polygon.points]


def blocks(framed: Framed) -> list[Box]:
    """The block of each vertex: (low x, low y), (high x, high y).

    Its square and the eight round it, or the four squares round the nearest grid vertex; of two
    coordinates equally near the lower.
    """
    if framed.blocks == "square":
        return [((x - 1, y - 1), (x + 2, y + 2)) for x, y in squares(framed.polygon)]
    # The least integer k with x - k <= 1/2.
    near = [[int(-((w - 2 * z) // (2 * w))) for z in (x, y)] for x, y, w in framed.polygon.points]
    return [((x - 1, y - 1), (x + 1, y + 1)) for x, y in near]


def _check_unit(framed: Framed) -> list[Finding]:
    """(8 b/s')^2, if the factor is 8, is at most 1, and not much less."""
    ratio = framed.factor**2 * framed.unit**2 / framed.feature.squared
    above, below, factor = Extreme(greatest=True), Extreme(), framed.factor
    part = f"s'/{factor}" if factor.denominator == 1 else f"s'/({factor})"
    square = f"({factor} b/s')^2"
    for extreme in (above, below):
        extreme.offer(ratio.numerator, ratio.denominator, {"unit": str(framed.unit)})
    return [
        above.finding(
            "dicing.unit",
            FRAMED,
            f"the grid unit b is at most {part}, so that blocks are disjoint within P' ({square})",
            mpq(1),
        ),
        below.finding(
            "dicing.unit-rounding",
            FRAMED,
            f"the grid unit b is {part} rounded down by less than 1 part in 2^9 ({square})",
            bounds_grid.UNIT_ROUNDING**2,
            strict=True,
        ),
    ]


def _check_similarity(framed: Framed) -> Finding:
    """The polygon must be the image of P', and the scale 1/b."""
    broken = Violations()
    original = framed.lopped.lopped
    broken.case(framed.similarity.squared_scale * framed.unit**2 == 1, "scale")
    broken.case(bounds_grid.blocks_are_disjoint(framed.blocks, framed.factor), "factor")
    broken.case(original.rings == framed.polygon.rings and original.n == framed.polygon.n, "rings")
    for v, (p, q) in enumerate(zip(original.points, framed.polygon.points, strict=False)):
        broken.case(framed.similarity.apply(p) == q, {"vertex of P'": v})
    return broken.finding(
        "dicing.frame",
        FRAMED,
        "the framed polygon is the exact image of P' under a similarity of scale 1/b",
    )


def _check_general_position(polygon: Polygon) -> list[Finding]:
    """No vertex on a grid line, no edge axis-parallel or exactly diagonal."""
    off_grid, parallel, diagonal = Violations(), Violations(), Violations()
    for v, (x, y, w) in enumerate(polygon.points):
        off_grid.case(bool(x % w and y % w), {"vertex of P'": v})
    for tail, head in polygon.edges():
        dx, dy = direction(polygon.points[tail], polygon.points[head])
        parallel.case(bool(dx and dy), {"edge of P'": tail})
        diagonal.case(abs(dx) != abs(dy), {"edge of P'": tail})
    return [
        off_grid.finding("dicing.off-grid", FRAMED, "no vertex of P' lies on a grid line"),
        parallel.finding("dicing.no-axis-parallel", FRAMED, "no edge of P' is axis-parallel"),
        diagonal.finding("dicing.no-diagonal", FRAMED, "no edge of P' is exactly diagonal"),
    ]


def _check_sheets(framed: Framed) -> Finding:
    """No second vertex in the block of v within the wedge of v."""
    polygon = framed.polygon
    occupants: dict[Square, list[int]] = defaultdict(list)
    for v, square in enumerate(squares(polygon)):
        occupants[square].append(v)
    points, broken = polygon.points, Violations()
    for v, (low, high) in enumerate(blocks(framed)):
        before, after = points[polygon.before[v]], points[polygon.after[v]]
        others = (
            w
            for x in range(low[0], high[0])
            for y in range(low[1], high[1])
            for w in occupants.get((x, y), ())
            if w != v and is_in_wedge(points[w], before, points[v], after)
        )
        broken.case(not (found := list(others)), {"vertices of P'": [v, *found]})
    return broken.finding(
        "dicing.one-vertex-a-sheet",
        FRAMED,
        "the sheet of a vertex in its block (block and wedge) holds no other vertex of P'",
    )


def _check_crossings(diced: Diced) -> Finding:
    """Each interval has two ends, each exactly on its line and strictly inside its edge."""
    polygon, at = diced.framed.polygon, diced.crossing_at
    broken = Violations()
    ends = set()
    for axis, intervals in ((VERTICAL, diced.vertical), (HORIZONTAL, diced.horizontal)):
        for line, low, high in intervals:
            keys = [(axis, line, low), (axis, line, high)]
            ends.update(keys)
            broken.case(
                all(key in at for key in keys)
                and diced.crossings[at[keys[0]]].at < diced.crossings[at[keys[1]]].at
                and diced.crossings[at[keys[0]]].far == high
                and diced.crossings[at[keys[1]]].far == low,
                {"axis": axis, "interval": [line, low, high]},
            )
    if ends != at.keys() or len(at) != len(diced.crossings):
        broken.broken("crossings that end no interval")
    for j, q in enumerate(diced.crossings):
        broken.case(_is_on_edge(polygon, q), {"crossing": j})
    listed = sorted(j for edge in diced.on_edge for j in edge)
    if listed != list(range(len(diced.crossings))) or any(
        diced.crossings[j].edge != e for e, edge in enumerate(diced.on_edge) for j in edge
    ):
        broken.broken("crossings listed on other edges than theirs")
    return broken.finding(
        "dicing.crossings",
        STAGE,
        "each kept interval ends at two q-vertices, exactly on its line and strictly inside their "
        "edges, off the grid vertices",
    )


def _is_on_edge(polygon: Polygon, q: Crossing) -> bool:
    """Is the crossing on its edge's line, strictly between the edge's ends, and no grid vertex?"""
    a, b, c = polygon.lines[q.edge]
    if q.axis == HORIZONTAL:
        a, b = b, a
    on_line = b * q.at.numerator + (a * q.line + c) * q.at.denominator == 0
    ends = polygon.points[q.edge], polygon.points[polygon.after[q.edge]]
    first, second = (p[q.axis] - q.line * p[2] for p in ends)
    return bool(on_line and first * second < 0 and q.at.denominator != 1)


def _check_covered(diced: Diced) -> Finding:
    """Each piece of a block line within the block and its vertex's wedge must be kept.

    Such a piece has an end on an incident edge, or both ends at grid vertices
    on the rim of the block, within the wedge.
    """
    polygon = diced.framed.polygon
    lines = {
        axis: _by_line(diced, axis, intervals)
        for axis, intervals in ((VERTICAL, diced.vertical), (HORIZONTAL, diced.horizontal))
    }
    broken = Violations()
    for v, block in enumerate(blocks(diced.framed)):
        for key in _edge_ends(polygon, v, block):
            broken.case(key in diced.crossing_at, {"vertex of P'": v, "crossing": key})
        for axis, line, across in _rim_ends(polygon, v, block):
            kept = _contains(lines[axis].get(line), across)
            broken.case(kept, {"vertex of P'": v, "axis": axis, "line": line, "at": across})
    return broken.finding(
        "dicing.blocks-covered",
        STAGE,
        "every piece of a block's lines within the block's sheet belongs to a kept interval",
    )


def _by_line(
    diced: Diced, axis: int, intervals: tuple[Interval, ...]
) -> dict[int, tuple[list[mpq], list[mpq]]]:
    """For each line the low and the high ends of its intervals, increasing."""
    ends: dict[int, tuple[list[mpq], list[mpq]]] = defaultdict(lambda: ([], []))
    for line, low, high in intervals:
        for side, edge in enumerate((low, high)):
            j = diced.crossing_at.get((axis, line, edge))
            if j is not None:
                ends[line][side].append(diced.crossings[j].at)
    for sides in ends.values():
        for side_ends in sides:
            side_ends.sort()
    return ends


def _contains(ends: tuple[list[mpq], list[mpq]] | None, at: int) -> bool:
    """Does one of these disjoint intervals, in increasing order, contain this coordinate?"""
    if ends is None:
        return False
    lows, highs = ends
    position = bisect_right(lows, at) - 1
    return 0 <= position < len(highs) and bool(highs[position] > at)


def _edge_ends(polygon: Polygon, v: int, block: Box) -> Iterator[tuple[int, int, int]]:
    """Where the two edges at v leave across the lines of its block: (axis, line, edge)."""
    x, y, w = polygon.points[v]
    for edge, other in ((v, polygon.after[v]), (polygon.before[v], polygon.before[v])):
        run = direction(polygon.points[v], polygon.points[other])
        a, b, c = polygon.lines[edge]
        for axis, slope, offset in ((VERTICAL, b, a), (HORIZONTAL, a, b)):
            first, last = (corner[1 - axis] for corner in block)
            for line in range(block[0][axis], block[1][axis] + 1):
                ahead = (line * w - (x, y)[axis]) * run[axis]
                # The other coordinate of the crossing is value/slope.
                value = -(offset * line + c)
                if slope < 0:
                    value, divisor = -value, -slope
                else:
                    divisor = slope
                if ahead > 0 and first * divisor <= value <= last * divisor:
                    yield axis, line, edge


def _rim_ends(polygon: Polygon, v: int, block: Box) -> Iterator[tuple[int, int, int]]:
    """The ends of block lines on the rim of the block within the wedge: (axis, line, where)."""
    points = polygon.points
    before, apex, after = points[polygon.before[v]], points[v], points[polygon.after[v]]
    inside: dict[Square, bool] = {}
    for axis in (VERTICAL, HORIZONTAL):
        for line in range(block[0][axis], block[1][axis] + 1):
            for across in (corner[1 - axis] for corner in block):
                node = (line, across) if axis == VERTICAL else (across, line)
                if node not in inside:
                    inside[node] = is_in_wedge(grid_point(*node), before, apex, after)
                if inside[node]:
                    yield axis, line, across
