"""Triangle meshes in arrays: what the filtered judge reads, and the readers of large files make.

A mesh has a million triangles more often than it has rationals that no double holds.  So its
vertices are kept as doubles next to them, in one array, and the exact points are made one by one,
where the doubles do not decide.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol

import numpy as np
from gmpy2 import lcm, mpq, mpz
from numpy.typing import NDArray

from bern_exact.exact.errors import InputError
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.plane.mesh import Mesh

Doubles = NDArray[np.float64]
Flags = NDArray[np.bool_]
Indices = NDArray[Any]
"""int64; of objects if an index is longer than that."""

Lattice = NDArray[np.int64]
"""(V, 4): the parts of integers, x and y of points times one and the same; see `lattice_of`."""

UNIT = mpq(1, 2**52)
"""A double of `Points.doubles` differs from its coordinate x by at most this times |x|."""

LARGE, SMALL = 2**100, 2**-100
"""Doubles whose sizes are 0 or between these neither overflow nor underflow in the filters."""

WHOLE = 2**53
"""Integers below this are doubles."""

PART = 60
"""An integer n of a lattice is split into n >> PART and the rest, whose differences are 64 bits."""

LONG = 2 ** (2 * PART)
"""The integers of a lattice are below this in size."""


class Points(Protocol):
    """Exact points, and the doubles next to them."""

    @property
    def doubles(self) -> Doubles:
        """(V, 2): the doubles nearest to the coordinates, infinite beyond all doubles.

        So equal coordinates have equal doubles; and a double is within `UNIT` of its coordinate,
        relatively, wherever that is not `wild`.
        """

    @property
    def exact(self) -> bool:
        """Are the doubles the coordinates?"""

    @property
    def wild(self) -> Flags:
        """(V,): is a coordinate neither 0 nor between `SMALL` and `LARGE` in size?"""

    @property
    def tame(self) -> bool:
        """Is no vertex wild?"""

    @property
    def lattice(self) -> Lattice | None:
        """All coordinates times one positive integer, in parts; None if that is not at hand.

        Vectors between vertices whose parts have equal differences are equal.
        """

    def __len__(self) -> int: ...

    def point(self, v: int) -> HPoint:
        """The point of a vertex, exactly."""

    def are_equal(self, v: int, w: int, axis: int) -> bool:
        """Do two vertices have the same x (axis 0), or the same y (axis 1)?"""


@dataclass(frozen=True)
class DoublePoints:
    """Points whose coordinates are doubles, exactly.

    Parameters
    ----------
    doubles : array of float64, (V, 2)
        Finite.
    """

    doubles: Doubles

    @property
    def exact(self) -> bool:
        """The doubles are the coordinates."""
        return True

    @cached_property
    def wild(self) -> Flags:
        """(V,): is a coordinate neither 0 nor between `SMALL` and `LARGE` in size?"""
        return are_wild(self.doubles)

    @property
    def tame(self) -> bool:
        """Is no vertex wild?"""
        return not self.wild.any()

    @property
    def lattice(self) -> Lattice | None:
        """None: the doubles themselves tell equal vectors."""
        return None

    def __len__(self) -> int:
        return len(self.doubles)

    def point(self, v: int) -> HPoint:
        """The point of a vertex, exactly.

        >>> DoublePoints(np.array([[0.5, 3.0]])).point(0)
        (mpz(1), mpz(6), mpz(2))
        """
        x, y = self.doubles[v].tolist()
        return hpoint(mpq(*x.as_integer_ratio()), mpq(*y.as_integer_ratio()))

    def are_equal(self, v: int, w: int, axis: int) -> bool:
        """Do two vertices have the same x (axis 0), or the same y (axis 1)?"""
        return bool(self.doubles[v, axis] == self.doubles[w, axis])


@dataclass(frozen=True)
class ExactPoints:
    """Points of any coordinates.

    Parameters
    ----------
    points : sequence of HPoint
        The points.
    """

    points: Sequence[HPoint]

    @property
    def exact(self) -> bool:
        """The doubles are not the coordinates (or it is not known that they are)."""
        return False

    @cached_property
    def doubles(self) -> Doubles:
        """The doubles nearest to the coordinates; infinite beyond all doubles."""
        flat = [nearest_double(c, w) for x, y, w in self.points for c in (x, y)]
        return np.array(flat, dtype=np.float64).reshape(-1, 2)

    @cached_property
    def wild(self) -> Flags:
        """(V,): is a coordinate neither 0 nor between `SMALL` and `LARGE` in size?"""
        wild = are_wild(self.doubles)
        for v, k in np.argwhere(self.doubles == 0).tolist():
            wild[v] |= self.points[v][k] != 0
        return wild

    @property
    def tame(self) -> bool:
        """Is no vertex wild?"""
        return not self.wild.any()

    @cached_property
    def lattice(self) -> Lattice | None:
        """The coordinates times their common denominator, if these are below `LONG` in size."""
        scale = common_multiple(w for _, _, w in self.points)
        if scale is None:
            return None
        flat = [c * (scale // w) for x, y, w in self.points for c in (x, y)]
        return lattice_of(flat)

    def __len__(self) -> int:
        return len(self.points)

    def point(self, v: int) -> HPoint:
        """The point of a vertex, exactly."""
        return self.points[v]

    def are_equal(self, v: int, w: int, axis: int) -> bool:
        """Do two vertices have the same x (axis 0), or the same y (axis 1)?"""
        p, q = self.points[v], self.points[w]
        return p[axis] * q[2] == q[axis] * p[2]


def common_multiple(numbers: Iterable[mpz | int]) -> int | None:
    """The least common multiple of positive integers, if it is below `LONG`.

    >>> common_multiple([4, 6]), common_multiple([2**90, 3**90])
    (12, None)
    """
    multiple = mpz(1)
    for number in numbers:
        if multiple % number:
            multiple = lcm(multiple, number)
            if multiple >= LONG:
                return None
    return int(multiple)


def lattice_of(integers: Sequence[mpz | int]) -> Lattice | None:
    """Integers x0, y0, x1, y1, ... in two parts each, if all are below `LONG` in size.

    >>> lattice_of([2**60 + 7, -1]).tolist()
    [[1, -1, 7, 1152921504606846975]]
    """
    if integers and max(max(integers), -min(integers)) >= LONG:
        return None
    rest = 2**PART - 1
    parts = [[int(n >> PART) for n in integers], [int(n & rest) for n in integers]]
    return np.hstack([np.array(part, dtype=np.int64).reshape(-1, 2) for part in parts])


def nearest_double(numerator: mpz, denominator: mpz) -> float:
    """The double nearest to a quotient, denominator > 0; infinite beyond all doubles."""
    try:
        return int(numerator) / int(denominator)  # Python rounds the quotient of ints once
    except OverflowError:
        return float("inf" if numerator > 0 else "-inf")


def are_wild(doubles: Doubles) -> Flags:
    """Of which rows is a double neither 0 nor between `SMALL` and `LARGE` in size?"""
    sizes = np.abs(doubles)
    wild: Flags = ~((sizes == 0) | ((sizes >= SMALL) & (sizes <= LARGE))).all(axis=1)
    return wild


@dataclass(frozen=True)
class ArrayMesh:
    """A triangle mesh that nobody has judged, in arrays.

    Parameters
    ----------
    points : Points
        The vertices.
    triangles : array of int64, (T, 3)
        0-based; an index may be out of range.  Of objects if one is beyond 64 bits.
    """

    points: Points
    triangles: Indices

    @staticmethod
    def of_doubles(doubles: Any, triangles: Any) -> ArrayMesh:
        """The mesh of an array (V, 2) and an array (T, 3).

        Raises
        ------
        InputError
            Kind `schema`: other shapes, or indices that are no integers; `number`: an infinity or
            no number at all.
        """
        points = np.asarray(doubles, dtype=np.float64)
        if points.ndim != 2 or points.shape[1] != 2:
            raise InputError("schema", f"vertices: (V, 2) is expected, not {points.shape}")
        bad = np.flatnonzero(~np.isfinite(points).all(axis=1))
        if len(bad):
            path = f"vertices[{int(bad[0])}]"
            raise InputError("number", f"{path}: a coordinate is not finite", {"path": path})
        return ArrayMesh(DoublePoints(points), index_array(triangles))

    @staticmethod
    def of_mesh(mesh: Mesh) -> ArrayMesh:
        """The same mesh in arrays."""
        return ArrayMesh(ExactPoints(mesh.vertices), index_array(mesh.triangles))

    @cached_property
    def mesh(self) -> Mesh:
        """The same mesh, every point exact: much larger."""
        vertices = tuple(self.points.point(v) for v in range(len(self.points)))
        return Mesh(vertices, tuple((a, b, c) for a, b, c in self.triangles.tolist()))


def index_array(triangles: Any) -> Indices:
    """An array (T, 3) of int64, or of Python's integers if one is longer.

    Raises
    ------
    InputError
        Kind `schema`: another shape, or no integers.

    >>> index_array([(0, 1, 2)]).dtype, index_array([(0, 1, 2**70)]).dtype
    (dtype('int64'), dtype('O'))
    """
    given = triangles if isinstance(triangles, np.ndarray) else list(triangles)
    if len(given) == 0:
        return np.empty((0, 3), dtype=np.int64)
    try:
        array = np.asarray(given)
    except ValueError:  # rows of different lengths
        array = np.empty(0)
    if array.ndim != 2 or array.shape[1] != 3:
        raise InputError("schema", "triangles: three vertex numbers each are expected")
    if array.dtype.kind == "u" and int(array.max()) >= 2**63:
        array = array.astype(object)
    elif array.dtype.kind == "f":  # numpy makes doubles of integers beyond 64 bits
        array = np.array(given, dtype=object)
    if array.dtype.kind in "iu":
        return array.astype(np.int64)
    if array.dtype.kind != "O" or not all(type(v) is int for v in array.flat):
        raise InputError("schema", "triangles: vertex numbers are expected")
    return array
