"""The grid of Section 5: cells and right triangles along the boundary, every line kept whole."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from itertools import pairwise

from gmpy2 import mpq

from bern_exact.checkers import bounds_bounce as bounds
from bern_exact.checkers.chords import Side
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.convex.records import LOWER, UPPER, Gridded, Leg

STAGE = "gridded"


def check_grid(gridded: Gridded) -> list[Finding]:
    """Check that cells and triangles are what the verticals make, and fill P.

    Parameters
    ----------
    gridded : Gridded
        The record; its frame, certified by `diameter`, is believed.

    Notes
    -----
    O(v log v) for v verticals.
    """
    cells = gridded.cells
    sides = [Side(chain) for chain in gridded.bounced.frame.chains]
    heights = [[side.height(x) for x in cells.xs] for side in sides]
    lines, columns, area = Violations(), Violations(), Violations()
    lines.case(cells.xs == gridded.bounced.verticals, "verticals")
    for x, y in pairwise(cells.xs):
        lines.case(x < y, {"x": x})
    expected = sorted({mpq(0), *heights[UPPER], *(-h for h in heights[LOWER])})
    lines.case(list(cells.ys) == expected, "horizontals")
    for j, (low, high) in enumerate(_columns(expected, heights)):
        recorded = (cells.low[j], cells.high[j]) if j < len(cells.low) else None
        columns.case(recorded == (low, high), {"column": j})
    columns.case(len(cells.low) == len(cells.high) == len(cells.xs) - 1, "columns")
    legs, most = _look_at_legs(gridded, heights)
    total, whole = _area(gridded), gridded.bounced.frame.polygon.area
    scaled = whole * gridded.bounced.frame.similarity.squared_scale
    area.case(total == scaled, {"cells and triangles": total, "P": scaled})
    return [
        lines.finding(
            "grid.lines",
            STAGE,
            "the horizontals are AB and those through the ends of verticals, and no others",
        ),
        columns.finding(
            "grid.cells",
            STAGE,
            "each horizontal runs on to the last vertical: a column's cells end where its chain "
            "is nearer to AB",
        ),
        legs.finding(
            "grid.triangles",
            STAGE,
            "what is left of a column are right triangles on the boundary, where it is not "
            "parallel to AB",
        ),
        most.finding(
            "grid.subdivisions",
            STAGE,
            "each triangle along the boundary has at most one subdivision, as recorded",
            bounds.SUBDIVISIONS_A_TRIANGLE,
        ),
        area.finding("grid.area", STAGE, "cells and triangles together have the area of P"),
    ]


def _columns(ys: Sequence[mpq], heights: Sequence[Sequence[mpq]]) -> Iterator[tuple[int, int]]:
    """The first row of each column, and the first that is not in it."""
    for (u0, u1), (l0, l1) in zip(pairwise(heights[UPPER]), pairwise(heights[LOWER]), strict=True):
        yield bisect_left(ys, -min(l0, l1)), bisect_left(ys, min(u0, u1))


def _look_at_legs(gridded: Gridded, heights: Sequence[Sequence[mpq]]) -> tuple[Violations, Extreme]:
    """Each right triangle against the two ends of its piece of the boundary."""
    ys = gridded.cells.ys
    broken, most = Violations(), Extreme(greatest=True)
    found = {(leg.column, leg.side): leg for leg in gridded.legs}
    broken.case(len(found) == len(gridded.legs), "twice")
    for side in (UPPER, LOWER):
        for j, (h, k) in enumerate(pairwise(heights[side])):
            leg = found.pop((j, side), None)
            broken.case((leg is None) == (h == k), {"column": j, "side": side})
            if leg is None or h == k:
                continue
            sign = 1 if side == UPPER else -1
            low, high = (j, j + 1) if h < k else (j + 1, j)
            rows = [bisect_left(ys, sign * height) for height in sorted((h, k))]
            corners = ((low, rows[0]), (high, rows[0]), (high, rows[1]))
            same = corners == (leg.low, leg.right, leg.high)
            broken.case(same, {"column": j, "side": side})
            inside = abs(rows[1] - rows[0]) - 1
            most.offer(inside, 1, {"column": j, "side": side})
            broken.case(_subdivided(leg, rows), {"column": j, "side": side})
    broken.case(not found, "more than there are")
    return broken, most


def _subdivided(leg: Leg, rows: Sequence[int]) -> bool:
    """Is the recorded subdivision the row between, if there is one?"""
    between = range(min(rows) + 1, max(rows))
    expected = (leg.high[0], between[0]) if len(between) == 1 else None
    return leg.subdivision == expected


def _area(gridded: Gridded) -> mpq:
    """The cells of each column as one rectangle, and the right triangles."""
    cells, total = gridded.cells, mpq(0)
    for j, (low, high) in enumerate(zip(cells.low, cells.high, strict=True)):
        total += (cells.xs[j + 1] - cells.xs[j]) * (cells.ys[high] - cells.ys[low])
    for leg in gridded.legs:
        (x0, y0), (x1, y1) = gridded.position(leg.low), gridded.position(leg.high)
        total += abs((x1 - x0) * (y1 - y0)) / 2
    return total
