"""The vertices of a mesh in arrays as a sequence of exact points, made when they are asked for."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import overload

import numpy as np

from bern_exact.exact.points import HPoint
from bern_exact.oracle.sides import PointSet
from bern_exact.plane.array_mesh import Doubles, Indices, Points, nearest_double


class LazyPoints(PointSet):
    """Exact points of a mesh's vertices, each made once.

    Parameters
    ----------
    points : Points
        The vertices.
    """

    def __init__(self, points: Points) -> None:
        self.points = points
        self._made: dict[int, HPoint] = {}

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

        The vertices are sorted once; then O(log V) a point, if few have the same doubles.
        """
        if not isinstance(point, tuple) or len(point) != 3:
            return False
        order, columns = self._sorted
        low, high = 0, len(order)
        for k, column in enumerate(columns):
            key, part = nearest_double(point[k], point[2]), column[low:high]
            low, high = (low + int(np.searchsorted(part, key, side)) for side in ("left", "right"))
        return any(self[v] == point for v in order[low:high].tolist())

    @cached_property
    def _sorted(self) -> tuple[Indices, Doubles]:
        """The vertices in the order of their doubles, x before y; and the doubles, (2, V)."""
        order = np.lexsort(self.points.doubles.T[::-1])
        return order, self.points.doubles[order].T.copy()
