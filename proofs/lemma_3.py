"""Lemma 3: the counts of the sweeps, and height b/sqrt 2 by triangles whose apex is in range."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product

import sympy
from gmpy2 import mpq

from bern_exact.checkers import bounds
from bern_exact.checkers.lemma_3 import faces_between_matches, squared_grid_height
from bern_exact.interior.records import Column, GridNode, SweptColumn
from bern_exact.interior.sweep import _ladder, _project_every_other
from proofs.algebra import demand_equal, demand_nonnegative, symbols
from proofs.statement import ENUMERATION, IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements

MOST_POINTS = 5
"""Points on a side of a column in the enumeration."""


@CHAPTER.proved(
    "Lemma 3", "The sweeps add at most 2 B_L + B_R points, and B_L = B_R <= N/2.", IDENTITY
)
def added_points() -> str:
    """A point strictly inside a side of a column lies strictly inside sides on both its sides.

    For its line is that of a vertex and runs on to another.  Let A be the points that the first
    sweep adds.  Each column adds at most half of what is strictly inside its left side,
    and a point lies strictly inside one left side at most: A <= (B_L + A)/2, so A <= B_L.
    In the second sweep, A' <= (B_R + A + A')/2, so A' <= B_R + A <= B_R + B_L.

    A boundary vertex strictly inside a left side looks right along a chord, which ends at a
    vertex (matching) that is strictly inside a right side, and conversely: B_L = B_R.
    No vertex is inside both, so B_L + B_R <= N.
    """
    left, right = symbols("B_L B_R")
    first = sympy.solve(sympy.Symbol("A") - (left + sympy.Symbol("A")) / 2, sympy.Symbol("A"))[0]
    demand_equal(first, left, "A <= B_L")
    later = sympy.Symbol("A2")
    second = sympy.solve(later - (right + first + later) / 2, later)[0]
    demand_equal(second, left + right, "A' <= B_L + B_R")
    demand_equal(bounds.added_points(left, right), first + second, "added_points()")
    return "B_L + (B_L + B_R)"


@CHAPTER.proved("Lemma 3", "There are at most 4 N + 2 holes triangles.", IDENTITY)
def triangles() -> str:
    """Euler's formula: T = N + 2 I - 2 components + 2 holes; I <= 2 B_L + B_R = 3 B_L <= 3 N/2."""
    edges, holes, left, rest, components = symbols("N h B_L r c")
    added = bounds.added_points(left, left)
    made = edges + 2 * added - 2 * components + 2 * holes
    slack = bounds.interior_triangles(edges, holes) - made
    demand_nonnegative(slack.subs(edges, 2 * left + rest), "T <= 4 N + 2 holes for N >= 2 B_L")
    return "2 (2 B_L + B_R) = 6 B_L <= 3 N"


@CHAPTER.proved(
    "Lemma 3",
    "After both sweeps there is at most one point on each vertical side of a column between "
    "heights that both sides share.",
    ENUMERATION,
)
def one_subdivision() -> str:
    """The 2nd, 4th, ... of a side's points go on: of two neighbours one is matched.

    Columns that end at a line are treated before those that begin there, in the first sweep;
    the other way round in the second.  So a side has all its points when it is projected,
    but for those that the second sweep puts on left sides, which are matched.  Every way in which
    up to five points on each side can be interleaved is tried with the product's own projection.
    """
    cases = 0
    for left, right in _sides(MOST_POINTS):
        column = Column(0, 1, 0, 8)
        sides = [column.y0, *left, column.y1], [column.y0, *right, column.y1]
        _project_every_other(column, sides[0], sides[1])
        _project_every_other(column, sides[1], sides[0])
        swept = SweptColumn(column, tuple(sides[0]), tuple(sides[1]), ())
        for face in faces_between_matches(swept):
            most = max(len(side) for side in face) - 2
            demand(most <= bounds.SUBDIVISIONS_A_SIDE, f"{left} | {right}")
        cases += 1
    return f"{cases} interleavings"


def _sides(most: int) -> Iterator[tuple[tuple[int, ...], ...]]:
    """Points on two sides: all ways to choose up to `most` of 7 heights for each."""
    heights = range(1, 8)
    chosen = [c for size in range(most + 1) for c in combinations(heights, size)]
    return iter(product(chosen, repeat=2))


@CHAPTER.proved(
    "Lemma 3 (repaired)",
    "Every triangle in Q has height at least b/sqrt 2; the unit square attains it.",
    IDENTITY,
)
def height() -> str:
    """Every triangle has a vertical base d >= 1, its apex w >= 1 beside it, level with the base.

    Then its sides are at most sqrt(w^2 + d^2) long and twice its area is d w:
    1/height^2 <= 1/d^2 + 1/w^2 <= 2.  Which point is next depends only on comparisons of heights;
    with at most one point on each side there are seven orders, and in each the product's
    triangles have their apex within the range of the base.
    """
    demand(bounds.REGION_FEATURE == 1, "integer coordinates")
    d, w = symbols("d w")
    wide, high = 1 + w, 1 + d
    slack = 2 * wide**2 * high**2 - wide**2 - high**2
    demand_nonnegative(slack, "d^2 w^2/(d^2 + w^2) >= 1/2")
    demand(mpq(1, 2) == bounds.INTERIOR_HEIGHT_SQUARED, "1/2")
    cases = 0
    for left, right in product(((), (1,), (2,)), repeat=2):
        column = Column(0, 1, 0, 3)
        for triangle in _ladder(column, (0, *left, 3), (0, *right, 3)):
            demand(_apex_is_in_range(triangle), f"{left} | {right}: {triangle}")
        cases += 1
    attained = squared_grid_height((0, 0), (1, 0), (1, 1))
    demand(mpq(*attained) == mpq(1, 2), "the unit square")
    return f"{cases} orders of at most one point on each side"


def _apex_is_in_range(triangle: tuple[GridNode, GridNode, GridNode]) -> bool:
    """Has it a vertical side, and a third corner level with a point of that?"""
    for i in range(3):
        p, q, apex = triangle[i - 2], triangle[i - 1], triangle[i]
        if p[0] == q[0]:
            low, high = sorted((p[1], q[1]))
            return low <= apex[1] <= high
    return False
