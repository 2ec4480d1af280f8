"""What doubles say of triangles: orientation, largest angle and least height, within bounds.

The vertices' doubles are differences first, so that a mesh far from the origin loses nothing that
its own doubles have not lost.  A right angle, the one angle that structured meshes are full of, is
recognised exactly where the differences of the coordinates are doubles.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bern_exact.exact.angles import ANGLE_60, ANGLE_90, ANGLE_120, ANGLE_135, ANGLE_150
from bern_exact.oracle.filters import (
    INPUT,
    UNDECIDED,
    Ball,
    Signs,
    are_exact,
    cotangent_bounds,
    difference,
    rounding_of_difference,
    signs_of_two_products,
)
from bern_exact.plane.array_mesh import Doubles, Indices, Points

BLOCK = 1 << 15
"""So many triangles at a time: their balls stay in the processor's cache."""

FEW = 256
"""So few triangles are not worth telling the same shapes."""

UNKNOWN = -1
"""Where the class of an angle is not decided."""

_MULTIPLIERS = np.array(
    [0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9, 0xD6E8FEB86659FD93]
    + [0xFF51AFD7ED558CCD, 0xC4CEB9FE1A85EC53, 0x2545F4914F6CDD1D, 0x9FB21C651E98DF25],
    dtype=np.uint64,
)

_CLASS_ANGLES = (ANGLE_60, ANGLE_90, ANGLE_120, ANGLE_135, ANGLE_150)
_CLASS_BOUNDS = [cotangent_bounds(a.signed_square, a.signed_square) for a in _CLASS_ANGLES]


@dataclass(frozen=True, eq=False)
class Frame:
    """The doubles that the filters compute with.

    Parameters
    ----------
    points : Points
        The mesh's vertices.
    doubles : array of float64, (2, V)
        All their x, and all their y, or next to that.
    spread : array of float64, (2, V), or None
        How far they may be from it: infinite for wild vertices.  None if not at all.
    told_apart : bool
        Have different coordinates on an axis different doubles?
    """

    points: Points
    doubles: Doubles
    spread: Doubles | None
    told_apart: bool

    def differences(self, tails: Indices, heads: Indices) -> list[Ball]:
        """The vectors between vertices: their x, and their y."""
        balls = []
        for axis in (0, 1):
            first, second, given = self.doubles[axis, tails], self.doubles[axis, heads], None
            if self.spread is not None:
                given = self.spread[axis, tails] + self.spread[axis, heads]
                if self.told_apart:
                    given[first == second] = 0
            balls.append(difference(second, first, given))
        return balls

    @cached_property
    def lattice(self) -> NDArray[Any] | None:
        """Doubles or integers, (k, V), whose equal differences are equal vectors; if at hand."""
        if self.points.exact:
            return self.doubles
        parts = self.points.lattice
        return None if parts is None else np.ascontiguousarray(parts.T)


def frame_of(points: Points) -> Frame:
    """The doubles of a mesh's vertices."""
    doubles = np.ascontiguousarray(points.doubles.T)
    if points.exact and points.tame:
        return Frame(points, doubles, None, True)
    with np.errstate(invalid="ignore"):
        given = np.zeros_like(doubles) if points.exact else INPUT * np.abs(doubles)
    spread = np.where(points.wild, np.inf, given)
    return Frame(points, doubles, spread, points.exact or _are_told_apart(points))


def _are_told_apart(points: Points) -> bool:
    """Have different coordinates different doubles, on both axes?"""
    for axis in (0, 1):
        column = points.doubles[:, axis]
        order = np.argsort(column, kind="stable")
        ties = np.flatnonzero(column[order[1:]] == column[order[:-1]])
        pairs = zip(order[ties].tolist(), order[ties + 1].tolist(), strict=True)
        if not all(points.are_equal(v, w, axis) for v, w in pairs):
            return False
    return True


@dataclass(frozen=True, eq=False)
class Estimates:
    """What doubles say of some triangles.

    Parameters
    ----------
    signs : array of int8
        Orientations: 1 is counter-clockwise; `UNDECIDED` in places.
    cot_low, cot_high : array of float64
        Bounds of the largest angle's cotangent; not a number, or infinite, where nothing is known.
    height_low, height_high : array of float64
        Bounds of the least squared height.
    """

    signs: Signs
    cot_low: Doubles
    cot_high: Doubles
    height_low: Doubles
    height_high: Doubles

    def classes(self) -> NDArray[np.int8]:
        """The numbers of the classes of angles; `UNKNOWN` in places."""
        surely = np.zeros(self.signs.shape, dtype=np.int8)
        perhaps = np.zeros(self.signs.shape, dtype=np.int8)
        for low, high in _CLASS_BOUNDS:
            surely += self.cot_high < low
            perhaps += ~(self.cot_low >= high)
        return np.where(surely == perhaps, surely, np.int8(UNKNOWN))


def estimate(frame: Frame, corners: Indices) -> Estimates:
    """The estimates of triangles with these corners, (T, 3)."""
    signs = np.empty(len(corners), dtype=np.int8)
    bounds = np.empty((4, len(corners)), dtype=np.float64)
    with np.errstate(all="ignore"):
        for start in range(0, len(corners), BLOCK):
            part = slice(start, start + BLOCK)
            signs[part] = _estimate_block(frame, corners[part], bounds[:, part])
    return Estimates(signs, *bounds)


def _estimate_block(frame: Frame, corners: Indices, bounds: Doubles) -> Signs:
    """The signs; the bounds are put where they belong."""
    a, b, c = corners.T
    ux, uy = frame.differences(a, b)
    vx, vy = frame.differences(a, c)
    wx, wy = frame.differences(b, c)
    cross, signs = _sum_of_products(ux, vy, -uy, vx)
    at_a, _ = _sum_of_products(ux, vx, uy, vy)
    at_b, _ = _sum_of_products(-ux, wx, -uy, wy)
    at_c, _ = _sum_of_products(vx, wx, vy, wy)
    dot = at_a.least(at_b).least(at_c)
    minus_squares = [-(x * x + y * y) for x, y in ((ux, uy), (vx, vy), (wx, wy))]
    longest = -minus_squares[0].least(minus_squares[1]).least(minus_squares[2])
    cot = dot.over(cross.size())
    height = (cross * cross).over(longest)
    bounds[0], bounds[1], bounds[2], bounds[3] = cot.low(), cot.high(), height.low(), height.high()
    return signs


def _sum_of_products(x: Ball, y: Ball, z: Ball, w: Ball) -> tuple[Ball, Signs]:
    """x y + z w and its sign; an exact 0 is found where the factors are exact."""
    total = x * y + z * w
    signs = total.signs()
    hard = np.flatnonzero((signs == UNDECIDED) & are_exact(x, y, z, w))
    if len(hard):
        signs[hard] = signs_of_two_products(*(ball.value[hard] for ball in (x, y, z, w)))
        zeros = hard[signs[hard] == 0]
        total.value[zeros] = total.radius[zeros] = 0
    return total, signs


def distinct_shapes(frame: Frame, corners: Indices) -> tuple[Indices, Indices]:
    """Triangles of the same shape, where that is quickly told.

    Returns
    -------
    first : array of int64
        The first triangle of each shape, ascending.
    shape : array of int64, (T,)
        For each triangle the number of its shape in `first`.

    Notes
    -----
    O(T log T).  Triangles with the same edge vectors have the same shape.
    """
    every = np.arange(len(corners))
    if len(corners) < FEW or frame.lattice is None:
        return every, every
    rows = _edge_vectors(frame.lattice, corners)
    with np.errstate(over="ignore"):
        keys = (rows.view(np.uint64) * _MULTIPLIERS).sum(axis=1, dtype=np.uint64)
    _, first, shape = np.unique(keys, return_index=True, return_inverse=True)
    # The same key by chance, or beyond all doubles, where nothing is exact.
    alike = (rows == rows[first[shape]]) & np.isfinite(rows)
    other = np.flatnonzero(~alike.all(axis=1))
    shape[other] = len(first) + np.arange(len(other))
    first = np.concatenate((first, other))
    order = np.argsort(first)
    place = np.empty_like(order)
    place[order] = np.arange(len(order))
    return first[order], place[shape]


def _edge_vectors(lattice: NDArray[Any], corners: Indices) -> NDArray[Any]:
    """(T, 8): the differences of corners b and c to a.

    Of integers in parts; of doubles the rounded value and the rounding error.
    """
    a, b, c = corners.T
    columns = []
    with np.errstate(all="ignore"):
        for axis in lattice:
            for heads in (b, c):
                value = axis[heads] - axis[a]
                columns.append(value)
                if lattice.dtype == np.float64:
                    columns.append(rounding_of_difference(axis[heads], axis[a], value))
        return np.stack(columns, axis=1) + 0  # no -0
