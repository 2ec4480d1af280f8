"""Where the points of the block program are, over boxes of parameters."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from proofs.lemma_2.forms import LIMIT, ONE, Form, integer, lowered, product, quotient
from proofs.lemma_2.rays import HIGH, LOW, E
from proofs.lemma_2.warping import Point

Array = Any


class Place(NamedTuple):
    """A point as two forms."""

    x: Form
    y: Form

    def __sub__(self, other: Place) -> Place:
        return Place(self.x - other.x, self.y - other.y)


class Bounds(NamedTuple):
    """What is claimed of every triangle.

    Parameters
    ----------
    kappa : (int, int)
        dot + kappa cross > 0 at each corner: numerator and denominator, at most 16.
    tau : int
        The snapping threshold at the scale 2^BITS.
    height : (int, int), optional
        k <= 256 and j <= 10: every height is above k / 2^j, or at least tau/sqrt 2 by `sections`.
    edges : bool
        Is every side of a face at least tau long?
    slab : int, optional
        The claim is for every threshold from tau to tau + slab at once; then only of angles, as
        heights and sides would be measured with one of them.
    """

    kappa: tuple[int, int]
    tau: int
    height: tuple[int, int] = (0, 0)
    edges: bool = False
    slab: int = 0

    @property
    def tau_high(self) -> int:
        """The greatest threshold."""
        return self.tau + self.slab

    def part(self, part: int) -> tuple[int, int]:
        """Where a part of the unit segment from 0 to 1 begins and ends.

        For a slab: its union over all thresholds, so that a point that is in this part for one of
        them is between these ends.
        """
        if part == LOW:
            return 0, self.tau_high
        return (ONE - self.tau_high, ONE) if part == HIGH else (self.tau, ONE - self.tau)


def unturned(quarters: int, p: Place) -> Place:
    """A point of the block's frame in the frame that is turned by these quarters."""
    if quarters == 0:
        return p
    if quarters == 1:
        return Place(p.y, p.x.times(-1).plus(ONE))
    if quarters == 2:
        return Place(p.x.times(-1).plus(ONE), p.y.times(-1).plus(ONE))
    return Place(p.y.times(-1).plus(ONE), p.x)


class Boxes:
    """Boxes of parameters: centres and half widths of x, y, m_e, m_f.

    Parameters
    ----------
    low, high : int64 arrays, 4 x n
        Their bounds at the scale 2^BITS, even distances apart.
    cls : int
        Where f goes.
    bounds : Bounds
        What is claimed.
    """

    def __init__(self, low: Array, high: Array, cls: int, bounds: Bounds) -> None:
        self.low, self.high, self.cls, self.bounds = low, high, cls, bounds
        half = (high - low) >> 1
        self.parameters = [Form(low[i] + half[i], {i: half[i]}) for i in range(4)]
        v = Place(self.parameters[0], self.parameters[1])
        self._v = v
        self._own = [unturned(0, v), unturned(cls, v)]
        self._places: dict[Point, Place] = {}

    def chosen(self, which: Array) -> Boxes:
        """Some of the boxes."""
        return Boxes(self.low[:, which], self.high[:, which], self.cls, self.bounds)

    def _quarters(self, ray: int) -> int:
        return 0 if ray == E else self.cls

    def _at(self, ray: int, height: Form) -> Form:
        """X of a ray at a height, in its own frame."""
        v = self._own[ray]
        return v.x + lowered(product(height - v.y, self.parameters[2 + ray]))

    def place(self, point: Point) -> Place:
        """Where a symbolic point is."""
        if point not in self._places:
            self._places[point] = self._place(point)
        return self._places[point]

    def _place(self, point: Point) -> Place:
        name = point[0]
        if name == "v":
            return self._v
        if name == "g":
            return Place(integer(point[1]), integer(point[2]))
        if name == "slid":
            return self._slid(point)
        back = -self._quarters(point[1]) % 4
        if name == "row":
            height = integer(point[2])
            return unturned(back, Place(self._at(point[1], height), height))
        return unturned(back, self._on_column(*point[1:5]))

    def _on_column(self, ray: int, level: int, column: int, part: int) -> Place:
        """Where a ray crosses a column: in a known part of the gap between rows level, level + 1.

        Below row 1 it is also above v.
        """
        v = self._own[ray]
        low, high = (level * ONE + end for end in self.bounds.part(part))
        lowest = low if level else np.clip(v.y.c - v.y.radius(), low, high)
        symbol = 4 + 2 * ray + level
        rise = integer(column) - v.x
        y = quotient(rise, self.parameters[2 + ray], lowest, high, symbol, v.y)
        return Place(integer(column), y)

    def _slid(self, point: Point) -> Place:
        """Where the segment from a place to a grid vertex crosses a ray."""
        _, q, inner, node = point
        quarters = self._quarters(q[1])
        a = unturned(quarters, self.place(inner))
        b = unturned(quarters, Place(integer(node[0]), integer(node[1])))
        off_a, off_b = (p.x - self._at(q[1], p.y) for p in (a, b))
        # Between 0 and 1, but that is not used: a corner that is not to be taken may be odd.
        s = quotient(off_a, off_a - off_b, -LIMIT, LIMIT, None)
        x, y = (p + lowered(product(s, towards - p)) for p, towards in ((a.x, b.x), (a.y, b.y)))
        return unturned(-quarters % 4, Place(x, y))
