"""The cells between the verticals, and the triangles along the boundary (Section 5, Lemma 9)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gmpy2 import mpq

from bern_exact.convex.cells import Cells, GridPoint
from bern_exact.convex.chains import Sigma
from bern_exact.convex.records import (
    LOWER,
    UPPER,
    Bounced,
    Gridded,
    Leg,
    Position,
    RightTriangle,
)


def faces(bounced: Bounced) -> Gridded:
    """Draw the horizontals, and cut the triangles along the boundary into right ones.

    Section 5: "we draw a horizontal line segment through each vertex and extend each line segment
    to the last possible vertical segment."  Between two verticals there are then rectangles and,
    at either end, a right triangle unless the boundary is parallel to AB there.

    Parameters
    ----------
    bounced : Bounced
        At most one subdivision a triangle.

    Notes
    -----
    O(v log v) for v verticals: cells are told by their columns.
    """
    xs = bounced.verticals
    upper, lower = (list(map(Sigma(chain).height, xs)) for chain in bounced.frame.chains)
    ys = sorted({mpq(0), *upper, *(-h for h in lower)})
    row = {y: i for i, y in enumerate(ys)}
    top, bottom = [row[h] for h in upper], [row[-h] for h in lower]
    columns = range(len(xs) - 1)
    cells = Cells(
        xs,
        tuple(ys),
        tuple(max(bottom[j], bottom[j + 1]) for j in columns),
        tuple(min(top[j], top[j + 1]) for j in columns),
    )
    cutter = _Cutter(cells)
    legs = [leg for j in columns for leg in cutter.legs(j, top, bottom)]
    return Gridded(bounced, cells, tuple(legs), tuple(cutter.feet))


class _Cutter:
    """Makes the triangles along the boundary, and collects the feet of their altitudes."""

    def __init__(self, cells: Cells) -> None:
        self._cells = cells
        self.feet: list[Position] = []

    def legs(self, column: int, top: Sequence[int], bottom: Sequence[int]) -> Iterator[Leg]:
        """The triangles of one column, whose chains are at these rows on each vertical."""
        for side, rows in ((UPPER, top), (LOWER, bottom)):
            near, far = (column, rows[column]), (column + 1, rows[column + 1])
            if near[1] == far[1]:
                continue
            if (near[1] < far[1]) == (side == UPPER):
                yield self._leg(column, side, near, far)
            else:
                yield self._leg(column, side, far, near)

    def _leg(self, column: int, side: int, low: GridPoint, high: GridPoint) -> Leg:
        """The right triangle over the hypotenuse from `low` to `high`."""
        right = (high[0], low[1])
        between = abs(high[1] - low[1]) - 1
        turns_left = (low[0] < high[0]) == (low[1] < high[1])
        if not between:
            corners = (low, right, high) if turns_left else (low, high, right)
            return Leg(column, side, low, right, high, None, (corners,))
        # One only, if the bouncing was right: the checker looks at it.
        s = (high[0], (low[1] + high[1]) // 2)
        foot = len(self.feet)
        self.feet.append(self._foot(low, high, s))
        parts: tuple[RightTriangle, ...] = ((low, right, s), (low, s, foot), (foot, s, high))
        if not turns_left:
            parts = ((low, s, right), (low, foot, s), (foot, high, s))
        return Leg(column, side, low, right, high, s, parts)

    def _foot(self, low: GridPoint, high: GridPoint, s: GridPoint) -> Position:
        """The foot of the altitude from s on the line from `low` to `high`."""
        (px, py), (qx, qy), (sx, sy) = map(self._at, (low, high, s))
        dx, dy = qx - px, qy - py
        t = ((sx - px) * dx + (sy - py) * dy) / (dx * dx + dy * dy)
        return px + t * dx, py + t * dy

    def _at(self, point: GridPoint) -> Position:
        return self._cells.xs[point[0]], self._cells.ys[point[1]]
