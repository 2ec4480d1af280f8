"""Which triangles and faces keep a claim all over a box."""

from __future__ import annotations

from typing import Any

import numpy as np

from proofs.lemma_2.forms import (
    BITS,
    Form,
    bounded,
    is_not_negative,
    is_positive,
    lowered,
    product,
)
from proofs.lemma_2.points import Bounds, Boxes, Place
from proofs.lemma_2.sections import asides, is_long
from proofs.lemma_2.warping import Point, Ring

Array = Any

SHIFT = 16
"""Products are lowered by this before they are multiplied by a length."""

LONGEST = 16 << (2 * BITS - SHIFT)
"""The square of no side of interest is longer."""

Sides = tuple[Place, Place, Place]
"""The sides of a triangle from its first corner on, counter-clockwise."""

NOT_KNOWN = (False, False, False)


def is_wide(bounds: Bounds, u: Place, w: Place) -> Array:
    """Is dot + kappa cross > 0 for two sides u, w from a corner, w to the left of u?"""
    num, den = bounds.kappa
    along = product(u.x, w.x.times(den) + w.y.times(num))
    across = product(u.y, w.y.times(den) - w.x.times(num))
    return is_positive(along + across)


def is_good(
    bounds: Bounds, sides: Sides, angles: Any = NOT_KNOWN, altitudes: Any = NOT_KNOWN
) -> Array:
    """Does a triangle keep the claim?

    With all angles tested it is counter-clockwise and not flat: kappa >= 3/5 (see the package).

    Parameters
    ----------
    bounds : Bounds
        The claim.
    sides : Sides
        Of the triangle.
    angles : three arrays, optional
        Where the angle at each corner is known to be at most 135 degrees.
    altitudes : three arrays, optional
        Where the altitude on each side is known to be at least tau/sqrt 2.
    """
    good: Array = True
    for side in sides:
        good = good & bounded(side.x) & bounded(side.y)
    for i, known in enumerate(angles):
        good = good & (known | is_wide(bounds, sides[i], _reversed(sides[i - 1])))
    if not bounds.height[0]:
        return good
    (a, b), (c, d) = sides[:2]
    cross = product(a, d) - product(b, c)
    good = good & is_positive(cross)
    cross = lowered(cross, SHIFT)
    for side, known in zip(sides, altitudes, strict=True):
        if np.any(good & ~np.asarray(known)):
            good = good & (known | is_high(bounds, cross, side))
    return good


def is_high(bounds: Bounds, cross: Form, side: Place) -> Array:
    """Is cross > height |side|, for cross at the scale 2^(2 BITS - SHIFT)?

    As |side| <= (side^2 / l + l) / 2 for any l > 0, it is if 2 l cross > height (side^2 + l^2);
    l is the side's length at the centre, in multiples of 2^-8.
    """
    k, j = bounds.height
    x, y = side
    square = lowered(product(x, x) + product(y, y), SHIFT)
    length = 1 + roots(np.clip(square.c, 0, LONGEST) >> (2 * BITS - SHIFT - 16))
    times_cross = cross.scaled(length << (j + 1))
    enough = square.times(k << 8).plus(k * length * length << (2 * BITS - SHIFT - 8))
    return is_positive(times_cross - enough)


def is_known(boxes: Boxes, corners: tuple[Point, Point, Point]) -> tuple[list[Array], list[Array]]:
    """Where `sections` tells of a triangle: its angles at corners, its altitudes on sides."""
    angles: list[Array] = [False, False, False]
    altitudes: list[Array] = [False, False, False]
    axes: list[int | None] = [None, None, None]
    for g, _, w, axis, steep in asides(boxes.cls, corners):
        off = boxes.place(corners[w]) - boxes.place(corners[g])
        across, along = off[axis], off[1 - axis]
        within: Array = False
        for positive in (across, across.times(-1)):
            within = within | (
                is_not_negative(positive - along) & is_not_negative(positive + along)
            )
        angles[g] = angles[g] | within
        altitudes[g if w == (g + 1) % 3 else w] |= within
        if steep or axes[g] == 1 - axis:
            altitudes[(g + 1) % 3] = True  # opposite g
        axes[g] = axis
    return angles, altitudes


def is_triangle(boxes: Boxes, corners: tuple[Point, Point, Point]) -> Array:
    """Does a triangle keep the claim all over each box?"""
    a, b, c = (boxes.place(point) for point in corners)
    sides = (b - a, c - b, a - c)
    num, den = boxes.bounds.kappa
    if not boxes.bounds.height[0] or num < den:  # less than 135 degrees
        return is_good(boxes.bounds, sides)
    return is_good(boxes.bounds, sides, *is_known(boxes, corners))


def is_side(boxes: Boxes, p: Point, q: Point) -> Array:
    """Is a side at least tau long all over each box?"""
    if is_long(boxes.cls, p, q):
        return True
    x, y = boxes.place(p) - boxes.place(q)
    squared = product(x, x) + product(y, y)
    return bounded(x) & bounded(y) & is_positive(squared.plus(-(boxes.bounds.tau**2)))


def triangulates(boxes: Boxes, ring: Ring) -> Array:
    """For each box: does one triangulation of this ring keep the claim all over it?"""
    size = len(ring)
    good: dict[tuple[int, int], Array] = {(i, i + 1): True for i in range(size - 1)}
    for width in range(2, size):
        for i in range(size - width):
            j = i + width
            good[i, j] = False
            for k in range(i + 1, j):
                parts = good[i, k] & good[k, j]
                if np.any(parts):
                    own = is_triangle(boxes, (ring[i], ring[k], ring[j]))
                    good[i, j] = good[i, j] | (parts & own)
    found = good[0, size - 1] & np.ones(boxes.low.shape[1], dtype=bool)
    if boxes.bounds.edges:
        for i, point in enumerate(ring):
            found &= is_side(boxes, ring[i - 1], point)
    return found


def roots(squares: Array) -> Array:
    """Integers near the square roots of numbers below 2^20, by Newton's iteration."""
    root = np.full_like(squares, 1 << 10)
    for _ in range(12):
        root = (root + squares // root) >> 1
        root = np.maximum(root, 1)
    return root


def _reversed(u: Place) -> Place:
    return Place(u.x.times(-1), u.y.times(-1))
