"""The vertices of a mesh in arrays as a sequence of exact points, made when they are asked for."""

from __future__ import annotations

from collections.abc import Iterator
from typing import overload

import numpy as np

from bern_exact.exact.points import HPoint
from bern_exact.oracle.sides import PointSet
from bern_exact.plane.array_mesh import Indices, Points, nearest_double


class LazyPoints(PointSet):
    """Exact points of a mesh's vertices, each made once.

    Parameters
    ----------
    points : Points
        The vertices.
    order : array of int64, optional
        Their numbers in the order of their `points.doubles`, x before y.
    """

    def __init__(self, points: Points, order: Indices | None = None) -> None:
        self.points = points
        self._made: dict[int, HPoint] = {}
        self._order = order

    def __len__(self) -> int:
        return len(self.points)

    @overload
    def __getitem__(self, v: int) -> HPoint: ...

    @overload
    def __getitem__(self, v: slice) -> list[HPoint]: ...

    def __getitem__(self, v: int | slice) -> HPoint | list[HPoint]:
        if isinstance(v, slice):
            return [self[i] for i in range(*v.indices(len(self)))]
        point = self._made.get(v)
        if point is None:
            point = self._made[v] = self.points.point(v)
        return point

    def __iter__(self) -> Iterator[HPoint]:
        return (self[v] for v in range(len(self)))

    def __contains__(self, point: object) -> bool:
        """Is this point among them?  Two binary searches in the doubles, and a look at equal ones.

        The mesh's vertices are sorted once; then O(log V) a point, if few have the same doubles.
        """
        if not isinstance(point, tuple) or len(point) != 3:
            return False
        if self._order is None:
            self._order = np.lexsort(self.points.doubles.T[::-1])
        order = self._order
        low, high = 0, len(order)
        for axis in (0, 1):
            column = self.points.doubles[:, axis]
            key = nearest_double(point[axis], point[2])
            low, high = (
                low + int(np.searchsorted(column[order[low:high]], key, side="left")),
                low + int(np.searchsorted(column[order[low:high]], key, side="right")),
            )
        return any(self[v] == point for v in order[low:high].tolist())
