"""Replaying a certificate: at every leaf, for every pair of types, some corner is good.

For each leaf the types are found that its rays can have.  For each pair of types the block
program says which faces each corner leaves.  A leaf is good if for every possible pair there
is a corner such that for every answer to the open questions every face has a triangulation
that keeps the bound over the whole box.  Integers only.

**Slabs.**  A claim may be for all thresholds tau of an interval at once.  A type, what the block
program makes of it, and where its points are do not depend on tau; only which types a ray has
does.  So a leaf is good for the whole slab if it is good for every type that a ray has for some
tau of it.  Each test of a type is weakened to what holds for some tau:

- the sections of rows, and the parts of gaps in which columns are crossed, become their unions
  over the slab, closed (`points.Bounds.part`): `Rays._in_section`, `Boxes._on_column`;
- a column is crossed below the upper end of its part, and above the lower end: both are tested
  at the outer ends of the unions (`Rays._in_part`).  As a ray's X is monotone in the height, it
  is beyond the column at the outer upper end if it is at the inner one; likewise below;
- which combinations of parts are types at all (`rays.ray_types`: a column crossed within tau of
  a grid vertex has its row crossed within tau, and so on; `block._on_segments`: the order of two
  crossings of one segment) is argued for each tau < 1/2 by itself, |m| <= 1 being all that is
  used.  The types are the same set for each, and so for the union.

That both rays, and all crossings of one, have the same tau is not used: more pairs of types are
asked about than occur.  Nothing else of a claim about angles depends on tau; `sections` and the
lengths of sides do, and are refused with a slab.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from proofs.lemma_2.block import CORNERS, LEFT, RIGHT, UP, Block, block
from proofs.lemma_2.forms import BITS, ONE
from proofs.lemma_2.points import Bounds, Boxes
from proofs.lemma_2.rays import HIGH, LOW, MIDDLE, E, F, GridNode, RayType, ray_types
from proofs.lemma_2.triangles import triangulates
from proofs.lemma_2.warping import Ring, crowded, outcomes

Array = Any

CHUNK = 1 << 15
"""Leaves that are treated together."""

Plan = tuple[tuple[frozenset[Ring], ...], ...]
"""For each corner, in the order of CORNERS, its outcomes: the rings that must be good."""

Plans = Callable[[int, RayType, RayType], Plan | None]
"""By the class and the types of both rays."""


class Replayed(NamedTuple):
    """What a replay found.

    Parameters
    ----------
    leaves : int
        How many were looked at.
    empty : int
        Of them, those that a mirror image or the angle of at least 90 degrees leaves out.
    failed : tuple of int
        The leaves at which some pair of types has no good corner.
    """

    leaves: int
    empty: int
    failed: tuple[int, ...]


def is_left_out(low: Array, high: Array, cls: int) -> Array:
    """Is a box outside of the class, or beyond its mirror line?

    Its inner points are; those on its rim that are not are in another box too.
    """
    if cls == UP:  # m_f > m_e
        return high[3] <= low[2]
    if cls == LEFT:  # m_f <= m_e, and x + y <= 1
        return (low[3] >= high[2]) | (low[0] + low[1] >= ONE)
    if cls == RIGHT:  # x <= y
        return low[0] >= high[1]
    return np.zeros(low.shape[1], dtype=bool)


class Rays:
    """Where the rays cross rows, as exact ranges over boxes.

    Parameters
    ----------
    boxes : Boxes
        The boxes.
    """

    def __init__(self, boxes: Boxes) -> None:
        self.bounds = boxes.bounds
        self._slopes = (boxes.low[2:], boxes.high[2:])
        (x, y), (u, v) = boxes.low[:2], boxes.high[:2]
        turned = (
            (x, u, y, v),
            (y, v, ONE - u, ONE - x),
            (ONE - u, ONE - x, ONE - v, ONE - y),
            (ONE - v, ONE - y, x, u),
        )
        self._own = (turned[0], turned[boxes.cls])
        self._known: dict[tuple[int, int], tuple[Array, Array]] = {}

    def range(self, ray: int, height: int) -> tuple[Array, Array]:
        """The least and the greatest X of a ray at a height, at the scale 2^(2 BITS)."""
        if (ray, height) not in self._known:
            x, u, y, v = self._own[ray]
            low, high = self._slopes[0][ray], self._slopes[1][ray]
            ends = [rise * m for rise in (height - v, height - y) for m in (low, high)]
            least = np.minimum.reduce(ends) + x * ONE
            greatest = np.maximum.reduce(ends) + u * ONE
            self._known[ray, height] = least, greatest
        return self._known[ray, height]

    def possible(self, ray: int, kind: RayType) -> Array:
        """Can a ray have a type somewhere in each box?

        A crossing exactly at tau from a grid vertex counts for both sections; edges through grid
        vertices and axis-parallel edges do not occur.
        """
        may = self._in_section(ray, 1, kind.cell_1, kind.part_1)
        may = may & self._in_section(ray, 2, kind.cell_2, kind.part_2)
        if kind.sign > 0:
            may = may & (self._slopes[1][ray] > 0)
        if kind.sign < 0:
            may = may & (self._slopes[0][ray] < 0)
        for level, part in ((0, kind.below), (1, kind.above)):
            if part >= 0:
                column = kind.column_above if level else kind.column_below
                may = may & self._in_part(ray, level, column, part, kind.sign > 0)
        return may

    def _in_section(self, ray: int, row: int, cell: int, part: int) -> Array:
        """Can X be in a part of a cell of this row?"""
        least, greatest = self.range(ray, row * ONE)
        low, high = ((cell * ONE + end) * ONE for end in self.bounds.part(part))
        above = greatest > low if part == LOW else greatest >= low
        below = least < high if part == HIGH else least <= high
        if part == MIDDLE and cell == 2:
            return above
        if part == MIDDLE and cell == -2:
            return below
        return above & below

    def _in_part(self, ray: int, level: int, column: int, part: int, rightwards: bool) -> Array:
        """Can a column be crossed in this part of the gap above row `level`?

        It is crossed below a height if at that height the ray is beyond it; and v is below it.
        """
        may: Array = True
        at = column * ONE * ONE
        lowest, highest = (level * ONE + end for end in self.bounds.part(part))
        if part != HIGH:
            may = may & (self._own[ray][2] < highest)
            least, greatest = self.range(ray, highest)
            may = may & (greatest >= at if rightwards else least <= at)
        if part != LOW:
            least, greatest = self.range(ray, lowest)
            may = may & (least <= at if rightwards else greatest >= at)
        return may


@cache
def plan_of(cls: int, kind_e: RayType, kind_f: RayType) -> Plan | None:
    """What the block program makes of two types; None if no rays of the class have them."""
    made = block(cls, kind_e, kind_f)
    return None if made is None else tuple(_outcomes(made, corner) for corner in CORNERS)


@cache
def crowded_plan_of(cls: int, kind_e: RayType, kind_f: RayType) -> Plan | None:
    """The same of a block with more than two wishes for a grid vertex: only v may take it.

    None for other blocks, of which nothing is asked.
    """
    made = block(cls, kind_e, kind_f)
    corner = None if made is None else crowded(made)
    return None if made is None or corner is None else (_outcomes(made, corner),)


def _outcomes(made: Block, corner: GridNode) -> tuple[frozenset[Ring], ...]:
    found = {frozenset(outcome.rings) for outcome in outcomes(made, corner)}
    return tuple(sorted(found, key=lambda rings: sorted(map(repr, rings))))


def replay(
    low: Array,
    high: Array,
    cls: int,
    bounds: Bounds,
    nearest: bool = False,
    plans: Plans = plan_of,
) -> Replayed:
    """Replay leaves.

    Parameters
    ----------
    low, high : int64 arrays, 4 x n
        Their bounds.
    cls : int
        The class of f.
    bounds : Bounds
        What is claimed.
    nearest : bool
        Only the closest corner may be taken, as printed; equally close ones must all be good.
    plans : callable
        Which corners may be taken with two types of rays, and what becomes of the block.

    Raises
    ------
    ValueError
        If more than angles is claimed of a slab of thresholds.
    """
    if bounds.slab and (bounds.height[0] or bounds.edges):
        raise ValueError("heights and sides are claimed for one threshold")
    left_out = is_left_out(low, high, cls)
    wanted = np.nonzero(~left_out)[0]
    failed: list[int] = []
    for start in range(0, len(wanted), CHUNK):
        chosen = wanted[start : start + CHUNK]
        bad = bad_leaves(Boxes(low[:, chosen], high[:, chosen], cls, bounds), nearest, plans)
        failed += [int(i) for i in chosen[bad]]
    return Replayed(low.shape[1], int(left_out.sum()), tuple(failed))


def bad_leaves(boxes: Boxes, nearest: bool = False, plans_of: Plans = plan_of) -> Array:
    """At which boxes has some possible pair of types no good corner?"""
    plans = possible_plans(boxes, plans_of)
    wanted: dict[Ring, Array] = {}
    for plan, where in plans.items():
        for ring in {ring for corner in plan for rings in corner for ring in rings}:
            wanted[ring] = wanted[ring] | where if ring in wanted else where
    good = {ring: good_at(boxes, ring, where) for ring, where in wanted.items()}
    may_be_nearest = nearest_corners(boxes) if nearest else None
    bad = np.zeros(boxes.low.shape[1], dtype=bool)
    for plan, where in plans.items():
        by_corner = [all_good(good, corner, where) for corner in plan]
        if may_be_nearest is None:
            bad |= where & ~np.logical_or.reduce(by_corner)
        else:
            for fine, near in zip(by_corner, may_be_nearest, strict=True):
                bad |= where & near & ~fine
    return bad


def all_good(good: dict[Ring, Array], corner: tuple[frozenset[Ring], ...], where: Array) -> Array:
    """Where every ring of every outcome is good."""
    fine = where
    for rings in corner:
        for ring in rings:
            fine = fine & good[ring]
    return fine


def good_at(boxes: Boxes, ring: Ring, where: Array) -> Array:
    """At which of the boxes where it is asked for is a ring good?"""
    which = np.nonzero(where)[0]
    good = np.zeros(len(where), dtype=bool)
    good[which] = triangulates(boxes.chosen(which), ring)
    return good


def possible_plans(boxes: Boxes, plans_of: Plans) -> dict[Plan, Array]:
    """The plans of all pairs of types that occur, and at which boxes."""
    rays = Rays(boxes)
    plans: dict[Plan, Array] = {}
    by_ray = [[(kind, rays.possible(ray, kind)) for kind in ray_types()] for ray in (E, F)]
    for kind_e, may_e in by_ray[E]:
        if not may_e.any():
            continue
        for kind_f, may_f in by_ray[F]:
            both = may_e & may_f
            if both.any():
                plan = plans_of(boxes.cls, kind_e, kind_f)
                if plan is not None:
                    plans[plan] = plans[plan] | both if plan in plans else both
    return plans


def nearest_corners(boxes: Boxes) -> list[Array]:
    """For each corner, at which boxes it may be the closest to v: v is in its quarter."""
    half, (low, high) = ONE // 2, (boxes.low, boxes.high)
    return [
        np.logical_and.reduce(
            [high[i] >= half if c else low[i] <= half for i, c in enumerate(corner)]
        )
        for corner in CORNERS
    ]


def samples(count: int, total: int) -> Iterator[int]:
    """`count` positions spread over `total`, always the same."""
    for i in range(min(count, total)):
        yield i * total // min(count, total) + (i * 7919) % max(1, total // count)


def scaled(numerator: int, denominator: int) -> int:
    """A dyadic rational at the scale 2^BITS."""
    value, rest = divmod(numerator << BITS, denominator)
    if rest:
        raise ValueError(f"{numerator}/{denominator} is no multiple of 2^-{BITS}")
    return value
