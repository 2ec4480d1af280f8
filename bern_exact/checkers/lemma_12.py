"""Lemma 12: few nonobtuse triangles in each block, and no new vertex on its sides."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from gmpy2 import mpq, mpz

from bern_exact.checkers.block_lines import Measured
from bern_exact.checkers.bounds_convex import (
    POWER_CONSTANT,
    RIGHT_COTANGENT,
    grid_triangles,
    power_sum,
)
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.recursion import check_recursion
from bern_exact.convex.block_records import Block, Reduced, ReducedBlock, Triangle
from bern_exact.convex.cells import GridPoint

STAGE = "reduced"
UNDEFINED = (-1, 0)
"""What is offered for a triangle that is none: no value, which is worse than any."""


def check_lemma_12(reduced: Reduced) -> tuple[Finding, ...]:
    """The claims of Lemma 12 on each block, and of the recursion on each of its nodes.

    Lemma 12: "A rectangle subdivided into m rows and k columns, with m < k, can be triangulated
    using O(m^0.8475 k) nonobtuse triangles, without introducing any new subdivisions."

    Parameters
    ----------
    reduced : Reduced
        The record; nothing but coordinates and lists of lines is believed.

    Returns
    -------
    tuple of Finding
        `lemma-12.tiling`, `.angle`, `.cells`, `.power`, and those of `check_recursion`.

    Notes
    -----
    Linear in the triangles, and in the lines of all nodes but for sorting.
    """
    measured = Measured(reduced.merged.cells)
    tiling, angle = Violations(), Extreme()
    cells, power = Extreme(greatest=True), Extreme(greatest=True)
    listed = tuple(block.block for block in reduced.blocks)
    tiling.case(listed == reduced.merged.blocks, "the list of blocks")
    for block in reduced.blocks:
        columns, rows = block.block.x1 - block.block.x0, block.block.y1 - block.block.y0
        tiling.case(_is_tiling(block), block.block)
        for triangle in block.triangles:
            angle.offer(*least_cotangent(triangle, measured), triangle)
        count = len(block.triangles)
        cells.offer(count, grid_triangles(columns, rows), block.block)
        powers = power_sum(columns, rows)
        power.offer(count * powers.denominator, powers.numerator, block.block)
    return (
        tiling.finding(
            "lemma-12.tiling",
            STAGE,
            "The triangles of a block fill it, and the vertices on its sides are exactly the "
            "ends of its lines.",
        ),
        angle.finding(
            "lemma-12.angle",
            STAGE,
            "No angle is obtuse (least cotangent).",
            RIGHT_COTANGENT,
        ),
        cells.finding(
            "lemma-12.cells",
            STAGE,
            "A block of m rows and k columns has at most 2 m k triangles (ratio).",
            mpq(1),
        ),
        power.finding(
            "lemma-12.power",
            STAGE,
            "It has at most 5/2 (m^x k + m k^x) triangles, x = 0.8475 (ratio to a rational just "
            "below the sum of powers).",
            POWER_CONSTANT,
        ),
        *check_recursion(reduced, measured),
    )


def _is_tiling(block: ReducedBlock) -> bool:
    """Positive triangles, each directed edge once, those without a reverse exactly the sides.

    Orientation is that of the indices: a triangle with an axis-parallel side has the same there,
    and others are refused.
    """
    edges: set[tuple[GridPoint, GridPoint]] = set()
    for p, q, r in block.triangles:
        sides = ((p, q), (q, r), (r, p))
        if not any(a[0] == b[0] or a[1] == b[1] for a, b in sides) or _cross(p, q, r) <= 0:
            return False
        if any(side in edges for side in sides):
            return False
        edges.update(sides)
    free = {(a, b) for a, b in edges if (b, a) not in edges}
    ring = list(ring_of(block.block))
    return free == set(pairwise([*ring, ring[0]]))


def ring_of(block: Block) -> Iterator[GridPoint]:
    """The ends of all lines of a block, counter-clockwise."""
    x0, x1, y0, y1 = block
    yield from ((x, y0) for x in range(x0, x1))
    yield from ((x1, y) for y in range(y0, y1))
    yield from ((x, y1) for x in range(x1, x0, -1))
    yield from ((x0, y) for y in range(y1, y0, -1))


def _cross(p: GridPoint, q: GridPoint, r: GridPoint) -> int:
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def least_cotangent(triangle: Triangle, measured: Measured) -> tuple[int | mpz, int | mpz]:
    """The cotangent of the one angle that need not be acute, if there is an axis-parallel side.

    0 if two sides are axis-parallel.  Otherwise, with an axis-parallel side c + d long, the foot
    of the third corner's height a being c and d from its ends, (a^2 - c d)/(a (c + d)): the other
    two angles are acute, and so the largest angle is this one whenever it is 90 degrees or more;
    of an acute triangle it may be another one.  `UNDEFINED` of a degenerate triangle and of one
    of another shape.
    """
    for i in range(3):
        p, q, r = triangle[i], triangle[i - 2], triangle[i - 1]
        if p[0] == q[0] and p[1] == r[1]:
            return _right(measured.height(p[1], q[1]), measured.width(p[0], r[0]))
        if p[1] == q[1] and p[0] == r[0]:
            return _right(measured.width(p[0], q[0]), measured.height(p[1], r[1]))
        if q[0] == r[0] and min(q[1], r[1]) < p[1] < max(q[1], r[1]):
            a = measured.width(p[0], q[0])
            return _cotangent(a, measured.height(p[1], q[1]), measured.height(p[1], r[1]))
        if q[1] == r[1] and min(q[0], r[0]) < p[0] < max(q[0], r[0]):
            a = measured.height(p[1], q[1])
            return _cotangent(a, measured.width(p[0], q[0]), measured.width(p[0], r[0]))
    return UNDEFINED


def _right(a: mpq, b: mpq) -> tuple[int, int]:
    """0, if the legs have lengths."""
    return (0, 1) if a > 0 and b > 0 else UNDEFINED


def _cotangent(a: mpq, c: mpq, d: mpq) -> tuple[int | mpz, int | mpz]:
    """(a^2 - c d)/(a (c + d)), not reduced."""
    if a <= 0 or c <= 0 or d <= 0:
        return UNDEFINED
    x = a.numerator * (c.denominator * d.denominator)
    low = c.numerator * (a.denominator * d.denominator)
    high = d.numerator * (a.denominator * c.denominator)
    return x * x - low * high, x * (low + high)
