"""The judge for large meshes: the verdict of `fast.py`, word for word, mostly from doubles.

Sorting finds the edges (`incidence.py`).  Doubles with proved error bounds decide orientations,
classes of angles and bounds (`estimates.py`, `filters.py`, `proofs/float_filter.py`), and which few
triangles may have the largest angle or the least height.  What they leave open is decided in
integers, triangles of the same shape once.  `sides.py` has the boundary, exactly as ever.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from gmpy2 import mpq, sign
from numpy.typing import NDArray

from bern_exact.exact.angle_bound import AngleBound
from bern_exact.oracle import fast
from bern_exact.oracle.estimates import (
    UNKNOWN,
    Frame,
    distinct_shapes,
    estimate,
    frame_of,
)
from bern_exact.oracle.filters import UNDECIDED, cotangent_bounds, doubles_around
from bern_exact.oracle.incidence import (
    first_at_its_point,
    look_at_edges,
    look_at_vertices,
    note,
    sound_triangles,
)
from bern_exact.oracle.lazy_points import LazyPoints
from bern_exact.oracle.shapes import Bounds, Extremes, Shape, angle_class, shape_of
from bern_exact.oracle.sides import look_at_sides
from bern_exact.oracle.verdict import ANGLE_CLASSES, Findings, Verdict
from bern_exact.plane.array_mesh import ArrayMesh, Doubles, Flags, Indices
from bern_exact.plane.polygon import Polygon

MOST_VERTICES = 2**31
"""Meshes with fewer vertices have edges that fit into 64 bits."""

MOST_KEPT = 2**20
"""So many shapes in integers are kept, at 400 bytes each."""


@dataclass
class Effort:
    """What the filters left to integers.

    Parameters
    ----------
    undecided : int
        Triangles whose orientation or class of angle doubles did not decide.
    near_bounds : int
        Times that doubles did not tell on which side of a bound a triangle is.
    candidates : int
        Triangles that may have had the largest angle, and those that may have had the least height.
    evaluated : int
        Shapes that were made in integers in order to decide.
    """

    undecided: int = 0
    near_bounds: int = 0
    candidates: int = 0
    evaluated: int = 0


def verify_arrays(
    mesh: ArrayMesh,
    polygon: Polygon | None,
    *,
    max_angle: AngleBound | None = None,
    min_height_squared: mpq | None = None,
    max_triangles: int | None = None,
    limit: int = 100,
    effort: Effort | None = None,
) -> Verdict:
    """Is this mesh a triangulation of this polygon, within these bounds?

    Parameters
    ----------
    mesh : ArrayMesh
        Any vertices and triangles; whatever is wrong with them is a defect.
    polygon, max_angle, min_height_squared, max_triangles, limit
        As in `fast.verify_mesh`.
    effort : Effort, optional
        Is added what was left to integers.

    Notes
    -----
    O(m log m) for m triangles, with `look_at_sides` for the boundary as in `fast.verify_mesh`.
    A million triangles take a few seconds; in the worst case, when doubles decide nothing, as
    long as `fast.verify_mesh`.  A mesh with indices beyond 64 bits goes there as a whole.
    """
    if mesh.triangles.dtype == object or len(mesh.points) >= MOST_VERTICES:
        return fast.verify_mesh(
            mesh.mesh,
            polygon,
            max_angle=max_angle,
            min_height_squared=min_height_squared,
            max_triangles=max_triangles,
            limit=limit,
        )
    found = Findings(limit)
    vertices, frame = LazyPoints(mesh.points), frame_of(mesh.points)
    numbers, used = sound_triangles(mesh, found)
    first = first_at_its_point(frame, vertices)
    look_at_vertices(vertices, first, used, found)
    corners = mesh.triangles if len(numbers) == len(mesh.triangles) else mesh.triangles[numbers]
    shapes = _Shapes(vertices, frame, corners, effort or Effort())
    sides = look_at_edges(first[corners], numbers, shapes.estimates.signs, found)
    look_at_sides(vertices, sides, polygon, found)
    shapes.hold_against(Bounds(max_angle, min_height_squared), numbers, found)
    fast.look_at_number(len(mesh.triangles), max_triangles, found)
    extremes = shapes.extremes(numbers)
    return fast.verdict_of(
        found, len(mesh.triangles), len(vertices), extremes, shapes.count_classes()
    )


class _Shapes:
    """Orientation, largest angle and least height of every sound triangle."""

    def __init__(
        self, vertices: LazyPoints, frame: Frame, corners: Indices, effort: Effort
    ) -> None:
        self.vertices, self.frame, self.corners, self.effort = vertices, frame, corners, effort
        self._made: dict[int, Shape] = {}
        self.estimates = estimate(frame, corners)
        self.classes = self.estimates.classes()
        self._decide()
        self.with_area: Flags = self.estimates.signs != 0

    def _decide(self) -> None:
        """Decide the orientations and classes that are open."""
        signs = self.estimates.signs
        is_open = (signs == UNDECIDED) | ((self.classes == UNKNOWN) & (signs != 0))
        some = np.flatnonzero(is_open)
        self.effort.undecided += len(some)

        def ask(shape: Shape) -> tuple[int, int]:
            cross = shape[1]
            return int(sign(cross)), angle_class(shape[0], abs(cross)) if cross else UNKNOWN

        answers = self._settle(some, ask)
        signs[some], self.classes[some] = answers[:, 0], answers[:, 1]

    def _settle(self, some: Indices, ask: Callable[[Shape], tuple[int, ...]]) -> NDArray[np.int8]:
        """Answers to a question about triangles that depends on their shapes alone, exactly."""
        first, shape = distinct_shapes(self.frame, self.corners[some])
        answers = [ask(self._shape(i)) for i in some[first].tolist()]
        return np.array(answers or [(0, 0)], dtype=np.int8)[shape]

    def _shape(self, i: int) -> Shape:
        """The shape of a triangle in integers; the first `MOST_KEPT` are kept."""
        shape = self._made.get(i)
        if shape is None:
            self.effort.evaluated += 1
            a, b, c = self.corners[i].tolist()
            shape = shape_of(self.vertices[a], self.vertices[b], self.vertices[c])
            if len(self._made) < MOST_KEPT:
                self._made[i] = shape
        return shape

    def count_classes(self) -> list[int]:
        """The number of triangles with area in each class of angles."""
        classes = self.classes[self.with_area]
        counts: list[int] = np.bincount(classes, minlength=len(ANGLE_CLASSES)).tolist()
        return counts

    def hold_against(self, bounds: Bounds, numbers: Indices, found: Findings) -> None:
        """Name the triangles that do not keep the bounds."""
        bad = self._beyond_angle(bounds) | self._beyond_height(bounds)

        def name(i: int) -> None:
            bounds.look_at(int(numbers[i]), self._shape(i), found)

        note(np.flatnonzero(bad).tolist(), found, name)

    def _beyond_angle(self, bounds: Bounds) -> Flags:
        """Which triangles have an angle above the bound?"""
        if bounds.max_angle is None:
            return np.zeros(len(self.corners), dtype=np.bool_)
        low, high = cotangent_bounds(*bounds.max_angle.enclosure())
        bad = self.estimates.cot_high < low
        return self._below(bad, self.estimates.cot_low >= high, bounds.admit_angle)

    def _beyond_height(self, bounds: Bounds) -> Flags:
        """Which triangles have a height below the bound?"""
        if bounds.min_height_squared is None:
            return np.zeros(len(self.corners), dtype=np.bool_)
        low, high = doubles_around(bounds.min_height_squared, bounds.min_height_squared)
        bad = self.estimates.height_high < low
        return self._below(bad, self.estimates.height_low >= high, bounds.admit_height)

    def _below(self, bad: Flags, good: Flags, admit: Callable[[Shape], bool]) -> Flags:
        """The bad triangles with area, the ones that are neither good nor bad decided exactly."""
        some = np.flatnonzero(self.with_area & ~bad & ~good)
        self.effort.near_bounds += len(some)
        bad[some] = self._settle(some, lambda shape: (not admit(shape), 0))[:, 0] != 0
        below: Flags = bad & self.with_area
        return below

    def extremes(self, numbers: Indices) -> Extremes:
        """The largest angle and the least height, with their first triangles."""
        found, estimates = Extremes(), self.estimates
        for i in self._least(estimates.cot_low, estimates.cot_high):
            found.see_angle(int(numbers[i]), self._shape(i))
        for i in self._least(estimates.height_low, estimates.height_high):
            found.see_height(int(numbers[i]), self._shape(i))
        return found

    def _least(self, low: Doubles, high: Doubles) -> list[int]:
        """The triangles with area that may be the first with the least of values between bounds.

        They ascend.  Of triangles whose value is known exactly, and of those of the same shape, the
        first alone is among them.
        """
        best = np.fmin.reduce(high[self.with_area], initial=np.inf)
        may_be = self.with_area & ~(low > best)
        ties = np.flatnonzero(may_be & (low == high) & (high == best))
        may_be[ties[1:]] = False
        some = np.flatnonzero(may_be)
        self.effort.candidates += len(some)
        first, _ = distinct_shapes(self.frame, self.corners[some])
        few: list[int] = some[first].tolist()
        return few
