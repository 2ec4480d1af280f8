"""Definition 2: the matching condition of Q, by sorting and without ray shooting.

**Claim.** Group the horizontal edges by their x-range and sort each group by y.
Suppose that they alternate, first a bottom (interior above), then a top, and
that the rectangles between partners, the *columns*, do not overlap.  Then every
vertical line extended from a vertex across the interior first meets the
boundary at another vertex.

*Proof.* The boundary of all columns together has the same horizontal edges as
the boundary of Q, so the two differ by a cycle of vertical edges, which is
empty: Q is the union of its columns, and no edge passes through one.  So a
vertex lies on the vertical side of a column or at its corner, never inside, nor
inside its top or bottom edge.  Going up from a vertex between two columns one
arrives at the top of the column that ends first: a corner of it, which is a vertex.  QED.

Rows give the same for horizontal lines.
"""

from __future__ import annotations

from bisect import bisect_left, insort
from collections import defaultdict
from collections.abc import Iterable

from bern_exact.checkers import bounds
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.interior.records import Column, GridNode, Rectilinear

STAGE = "interior"

Edge = tuple[GridNode, GridNode]


def check_definition_2(region: Rectilinear) -> list[Finding]:
    """Check that Q is rectilinear, matching, and has feature size at least b (Definition 2).

    Parameters
    ----------
    region : Rectilinear
        Q.

    Notes
    -----
    All coordinates being integers, every distance within Q is at least
    1 as soon as the edges are axis-parallel and no two overlap.  O(N log N).
    """
    edges = directed_edges(region)
    crooked, shortest = Violations(), Extreme()
    for (x0, y0), (x1, y1) in edges:
        integral = all(isinstance(c, int) for c in (x0, y0, x1, y1))
        crooked.case(integral and (x0 == x1) != (y0 == y1), ((x0, y0), (x1, y1)))
        shortest.offer(abs(x1 - x0) + abs(y1 - y0), 1, ((x0, y0), (x1, y1)))
    if len(set(edges)) != len(edges):
        crooked.broken("an edge occurs twice")
    return [
        crooked.finding(
            "definition-2.rectilinear",
            STAGE,
            "Q is bounded by axis-parallel edges between grid points, none of them twice",
        ),
        shortest.finding(
            "definition-2.feature-size",
            STAGE,
            "Q has feature size at least b: its edges join grid points (least length)",
            bounds.REGION_FEATURE,
        ),
        _check_matching(edges),
    ]


def directed_edges(region: Rectilinear) -> list[Edge]:
    """All edges of the loops, interior on the left."""
    return [(loop[i - 1], b) for loop in region.loops for i, b in enumerate(loop)]


def _check_matching(edges: Iterable[Edge]) -> Finding:
    """Columns and, after a quarter turn, rows."""
    broken = Violations()
    upright = list(edges)
    turned = [((-ay, ax), (-by, bx)) for (ax, ay), (bx, by) in upright]
    for name, kind in ((("column", upright)), ("row turned by 90 degrees", turned)):
        columns = stack_columns(kind, broken)
        _find_overlaps(columns, name, broken)
    return broken.finding(
        "definition-2.matching",
        STAGE,
        "each line from a vertex of Q across the interior first meets the boundary at another "
        "vertex: columns and rows alternate bottom and top, and do not overlap",
    )


def stack_columns(edges: Iterable[Edge], broken: Violations) -> list[Column]:
    """The columns between partners among the horizontal edges, by (x0, x1, y0).

    Parameters
    ----------
    edges : iterable of edges
        Directed, interior on the left: bottoms go right, tops go left.
    broken : Violations
        Takes one case a column, and what does not alternate.
    """
    groups: dict[tuple[int, int], list[tuple[int, bool]]] = defaultdict(list)
    for (ax, ay), (bx, by) in edges:
        if ay == by:
            groups[min(ax, bx), max(ax, bx)].append((ay, ax < bx))
    columns = []
    for (x0, x1), heights in sorted(groups.items()):
        heights.sort()
        for i, (y, is_bottom) in enumerate(heights):
            if is_bottom != (i % 2 == 0) or (i and heights[i - 1][0] == y):
                broken.broken({"x": [x0, x1], "y": y})
        for (y0, _), (y1, _) in zip(heights[::2], heights[1::2], strict=False):
            broken.case(y0 < y1, {"x": [x0, x1], "y": [y0, y1]})
            columns.append(Column(x0, x1, y0, y1))
        if len(heights) % 2:
            broken.broken({"x": [x0, x1], "y": heights[-1][0]})
    return columns


def _find_overlaps(columns: Iterable[Column], name: str, broken: Violations) -> None:
    """Sweep from left to right over columns, kept by their y-ranges."""
    events = sorted(
        (x, starts, column.y0, column.y1)
        for column in columns
        for x, starts in ((column.x0, 1), (column.x1, 0))
    )
    active: list[tuple[int, int]] = []
    for x, starts, y0, y1 in events:
        place = bisect_left(active, (y0, y1))
        if not starts:
            if place < len(active) and active[place] == (y0, y1):
                active.pop(place)
            continue
        above = place < len(active) and active[place][0] < y1
        below = place > 0 and active[place - 1][1] > y0
        if above or below:
            broken.broken({name: [y0, y1], "from x": x})
        insort(active, (y0, y1))
