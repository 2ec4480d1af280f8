"""Section 5: Lemmas 9, 10 and 11."""

from __future__ import annotations

from itertools import product

import sympy
from gmpy2 import mpq

from bern_exact.checkers import bounds_bounce, bounds_convex
from bern_exact.checkers.lemma_10 import AT_SUBDIVISION, nonobtuse_triangulation
from bern_exact.convex.reduction import is_mergeable, removable, two_thirds_median
from proofs.algebra import demand_equal
from proofs.statement import ENUMERATION, IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements

MOST_ROWS = 12
"""Rows in the enumeration of patterns."""


@CHAPTER.proved(
    "Lemma 9",
    "A right triangle with one subdivision on a leg is cut into three right triangles by the line "
    "from the far leg's end to the subdivision and the altitude from there.",
    IDENTITY,
)
def lemma_9() -> str:
    """C = (0, 0), B = (a, 0), A = (0, c + d), S = (0, c); F the foot of S on AB.

    C B S is right at C.  F = B + t (A - B), t = (S - B)(A - B)/|A - B|^2, is strictly within AB:
    both t and 1 - t have positive terms only.
    """
    a, c, d = sympy.symbols("a c d", positive=True)
    corner, tip, point = sympy.Matrix([a, 0]), sympy.Matrix([0, c + d]), sympy.Matrix([0, c])
    run = tip - corner
    t = (point - corner).dot(run) / run.dot(run)
    foot = corner + t * run
    demand_equal((point - foot).dot(run), 0, "a right angle at F")
    demand_equal(t, (a**2 + c * (c + d)) / (a**2 + (c + d) ** 2), "t > 0")
    demand_equal(1 - t, d * (c + d) / (a**2 + (c + d) ** 2), "t < 1")
    demand(bounds_bounce.RIGHT_TRIANGLES == 3, "three")
    return "F within AB: t and 1 - t are quotients of positive polynomials"


@CHAPTER.proved(
    "Lemma 10 (exact form)",
    "A rectangle a wide with one subdivision on a vertical side, c and d from its ends, has a "
    "nonobtuse triangulation by its own vertices if and only if a^2 >= c d.",
    IDENTITY,
)
def lemma_10() -> str:
    """The five triangulations of the pentagon A = (0, 0), B, C, D and s = (0, c), by their fan.

    At B there is s B D with the dot product -c d at s, at C its mirror image s C A with
    -c d; at A and at D a triangle with A, s, D is flat.  At s: A B s and D s C are right, and
    s B C has the dot products a^2 - c d at s, and c (c + d) and d (c + d) at B and C.
    """
    a, c, d = sympy.symbols("a c d", positive=True)
    zero = sympy.Integer(0)
    s, low, right, far, high = (
        sympy.Matrix(p) for p in ((zero, c), (zero, zero), (a, zero), (a, c + d), (zero, c + d))
    )
    demand_equal((right - s).dot(high - s), -c * d, "fan at B")
    demand_equal((far - s).dot(low - s), -c * d, "fan at C")
    demand_equal(sympy.Matrix.hstack(s - low, high - low).det(), 0, "fans at A and D")
    demand_equal((right - s).dot(far - s), a**2 - c * d, "at s")
    demand_equal((s - right).dot(far - right), c * (c + d), "at B")
    demand_equal((s - far).dot(right - far), d * (c + d), "at C")
    demand(bool(bounds_convex.LEAST_WIDTH_SQUARED == 1), "a^2/(c d) >= 1")
    for width, near, rest in product(range(1, 6), repeat=3):
        lengths = mpq(width), mpq(near), mpq(rest)
        found = nonobtuse_triangulation(*lengths)
        holds = width * width >= near * rest
        demand((found == AT_SUBDIVISION) == holds, "the checker")
        demand(is_mergeable(lengths[1], lengths[2], lengths[0]) == holds, "the product")
    return "dot product a^2 - c d"


@CHAPTER.proved(
    "Lemma 11 (epsilon = 1/6)",
    "Of S lines, if both widths are at least (1/2 + epsilon) S of the S + 1 distances, at least "
    "epsilon S - 1 can be removed; between 2/3-medians at least (m - 1)/6 of m - 1, in outer parts "
    "at least half; and, m_1 and m_3 rows being before and after all those at least as high as the "
    "median, at least floor(m_1/2) + floor(m_3/2).",
    IDENTITY,
)
def lemma_11() -> str:
    """At most S + 1 - (1/2 + e) S distances are higher; each keeps at most the two lines at it.

    The others satisfy Lemma 10, c and d being at most a.  Of a run of such lines half can go,
    rounded up.  At the median M = sorted[floor(2 m/3)]: ceil(m/3) - 1 <= (m - 1)/3 are higher.
    The m_1 - 1 lines among the first m_1 rows, all lower than M, satisfy Lemma 10 as well, and so
    do m_3 - 1; no line of the one kind is next to one of the other, some row being as high as M.
    """
    count, epsilon = sympy.symbols("S epsilon", positive=True)
    higher = count + 1 - (sympy.Rational(1, 2) + epsilon) * count
    left = count - 2 * higher
    demand_equal(left, 2 * epsilon * count - 2, "2 epsilon S - 2 can go one by one")
    demand_equal(left / 2, bounds_convex.eliminated(count, epsilon), "epsilon S - 1")
    demand(bounds_convex.EPSILON == mpq(1, 6), "1/6")
    m = sympy.Symbol("m", positive=True)
    others = (m - 1) - 2 * (m - 1) / 3
    demand_equal(others / 2, (m - 1) / 6, "between medians")
    for rows in range(1, 10):
        demand(bounds_convex.eliminated_between_medians(rows) == mpq(rows - 1, 6), "(m - 1)/6")
        demand(bounds_convex.eliminated_in_outer_part(rows) == mpq(rows - 1, 2), "(k - 1)/2")
    for rows in range(1, 400):  # exact for all residues; the formulas have period 3
        most = -(-rows // 3) - 1
        demand(rows - 1 - 2 * rows // 3 == most and 3 * most <= rows - 1, "ceil(m/3) - 1")
        demand(3 * (rows - 2 * rows // 3) >= rows, "a third is at least as wide")
    return "S - 2 (S/2 - epsilon S + 1) = 2 epsilon S - 2"


@CHAPTER.proved(
    "Lemma 11 (epsilon = 1/6)",
    "The product removes as many for every pattern of low and high rows, up to 12 rows.",
    ENUMERATION,
)
def lemma_11_patterns() -> str:
    """Low rows are 1 high, high ones 2, the strips 1 wide: a line beside a high row stays."""
    cases = 0
    for rows in range(2, MOST_ROWS + 1):
        for pattern in product((mpq(1), mpq(2)), repeat=rows):
            width = two_thirds_median(pattern)
            gone = len(removable(pattern, width))
            demand(bool(gone >= bounds_convex.eliminated_between_medians(rows)), f"{pattern}")
            as_high = [i for i, row in enumerate(pattern) if row >= width]
            ends = as_high[0] // 2 + (rows - 1 - as_high[-1]) // 2
            demand(gone >= ends, f"{pattern}: the ends")
            lines, covered = rows - 1, sum(row <= 1 for row in pattern)
            epsilon = mpq(covered, lines) - mpq(1, 2)
            gone = len(removable(pattern, mpq(1)))
            if epsilon > 0:
                demand(bool(gone >= bounds_convex.eliminated(lines, epsilon)), f"{pattern}")
            cases += 1
    return f"{cases} patterns"


@CHAPTER.proved(
    "Section 5.1",
    "l, r and what is between are at least a third of the strips; l = r is only possible with at "
    "most three.",
    IDENTITY,
)
def separation() -> str:
    """k - floor(2 k/3) = ceil(k/3) strips are at least as wide as the median M of their own."""
    demand(bounds_convex.SEPARATION == mpq(1, 3), "a third")
    for k in range(1, 400):  # exact for all residues; the formulas have period 3
        demand(k - 2 * k // 3 == -(-k // 3), "ceil(k/3)")
        demand((-(-k // 3) > 1) == (k > 3), "two of them for k > 3")
    return "ceil(k/3) >= k/3"
