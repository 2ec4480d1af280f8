"""Theorem 4: from the blocks' triangles to O(n^1.8475), with explicit constants.

**Long sides.**  Let a block have short side s and long side l, in cells, and class i if
2^i <= s < 2^(i+1).  Claim: the long sides of one class are at most N together, N being the edges of
cells on the boundary of Q.  Notation and steps are those of `lemma_6`.

- Strips cut off at level i are 2^i wide and at least as long: they are of class i, and no others.
  In the two half-steps of level i their lengths are at most b and a' by step (3), and
  a' + b is at most the budget, by (2).
- A piece put out whole at a half-step of level j has all sides at least 2^j: its class is at
  least j.  It keeps its budget, of which its boundary is a part and its long side at most half.
  Budgets are shared out and never grow: those of all pieces ever put out whole, and of those still
  there, are at most N together.
- So of class i there are wholes put out before level i or at its first half-step, with budgets W
  in all and long sides of at most W/2; and of the other pieces of level i, with budgets of at
  most N - W, strips of at most b in the first half-step, and what the second makes of the parts.
  These have ends a' with a' + b <= N - W.  A part is cut into strips of at most its share of a' or
  put out whole; then its sides are g (2u) and r u for u = 2^i, and it is of class i only if r = 1,
  as 2u is of class i + 1: its long side is g (2u), half of its share of a'.
  In all at most W/2 + (N - W) <= N.

**Count.**  A block has at most C (s^x l + l^x s) <= 2 C s^x l triangles, as (s/l)^(1-x) <= 1.  A
class has at most 2 C 2^((i+1) x) N, and 2^i <= N/4, as a block has four sides.  The sum over i is
at most 2 C 2^x (N/4)^x 2^x/(2^x - 1) N = 2 C/(2^x - 1) N^(1+x).
"""

from __future__ import annotations

import sympy
from gmpy2 import mpq

from bern_exact.checkers import bounds_bounce, bounds_convex
from proofs.algebra import demand_equal, demand_nonnegative, symbols
from proofs.lemma_12 import X
from proofs.lemma_12_rounding import BETTER, BETTER_CONSTANT
from proofs.powers import Bounds, power_between, shown
from proofs.statement import CERTIFICATE, IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements


SHARPER = mpq(81, 10)
"""Of N^1.8."""


def count_constant(c: mpq, exponent: mpq) -> Bounds:
    """2 c/(2^x - 1)."""
    low, high = power_between(mpq(2), exponent)
    return 2 * c / (high - 1), 2 * c / (low - 1)


@CHAPTER.proved(
    "Theorem 4",
    "The long sides of all blocks with short sides from 2^i to 2^(i+1) - 1 are at most N together, "
    "blocks put out whole included.",
    IDENTITY,
)
def long_sides() -> str:
    """The module's docstring; `lemma_6.steps_on_small_regions` checks the steps it uses."""
    demand(bool(bounds_bounce.LONG_SIDES == 1), "N")
    whole, rest, edges = symbols("W rest N")
    total = whole + rest
    demand_nonnegative(total - (whole / 2 + (total - whole)), "W/2 + (N - W) <= N")
    demand_equal(edges / 2 * 2, edges, "a rectangle's long side is at most half its boundary")
    return "W/2 + (N - W)"


@CHAPTER.proved(
    "Theorem 4",
    "At most 6.3 N^1.8475 triangles in the blocks, and at most 8.1 N^1.8.",
    CERTIFICATE,
)
def count_of_blocks() -> str:
    """The module's docstring, Count, with C = 5/2, and with C = 3 for the exponent 0.8."""
    printed = count_constant(bounds_convex.POWER_CONSTANT, X)
    better = count_constant(BETTER_CONSTANT, BETTER.exponent)
    demand(bool(printed[1] <= bounds_bounce.COUNT_CONSTANT), "COUNT_CONSTANT")
    demand(bool(better[1] <= SHARPER), "8.1")
    return f"2 C/(2^x - 1) is {shown(printed, 6)} and {shown(better, 6)}"


@CHAPTER.proved(
    "Theorem 4",
    "N <= 54 n and at most 54 n triangles along the boundary, with at most 9 n verticals: at most "
    "6.3 (54 n)^1.8475 + 54 n triangles, and at most 8.1 (54 n)^1.8 + 54 n.",
    IDENTITY,
)
def count() -> str:
    """9 n columns, 18 n rows: N is the perimeter of the bounding box of an orthoconvex region."""
    n = sympy.Symbol("n", integer=True, positive=True)
    columns, rows = bounds_bounce.verticals(n), bounds_bounce.horizontals(n) - 1
    demand_equal(bounds_bounce.boundary_edges(columns, rows), 54 * n, "N")
    demand_equal(bounds_bounce.rim_triangles(columns), 54 * n, "the rim")
    demand_equal(bounds_bounce.baseline_triangles(n), 324 * n**2 + 54 * n, "the O(n^2) bound")
    demand(bool(X + 1 < mpq(1848, 1000)), "1.8475 < 1.848")
    return "2 (9 n + 18 n) = 54 n"


@CHAPTER.proved(
    "Theorem 4",
    "The checked bound 6.3 N^1.8475 + 54 n is above the O(n^2) bound 324 n^2 + 54 n for all "
    "n <= 5.8 10^9, and below it for all n >= 5.9 10^9.",
    CERTIFICATE,
)
def where_the_exponent_pays() -> str:
    """6.3 * 54^(1+x) against 324 n^(1-x), which grows with n."""
    _, high = power_between(mpq(54), 1 + X)
    low = power_between(mpq(54), 1 + X)[0]
    before, after = (power_between(mpq(n), 1 - X) for n in (58 * 10**8, 59 * 10**8))
    constant = bounds_bounce.COUNT_CONSTANT
    demand(bool(constant * low > 324 * before[1]), "at 5.8 10^9")
    demand(bool(constant * high < 324 * after[0]), "at 5.9 10^9")
    for n, above in ((1, True), (58 * 10**8, True), (59 * 10**8, False)):
        bound, square = bounds_bounce.theorem_4_triangles(n), bounds_bounce.baseline_triangles(n)
        demand((bound > square) == above, f"n = {n}")
    return f"54^1.8475 = {shown((low, high), 8)}"


@CHAPTER.proved(
    "Theorem 4 (sharper)",
    "8.1 N^1.8 + 54 n is below 6.3 N^1.8475 + 54 n for all n >= 4, and below 324 n^2 + 54 n for "
    "all n >= 3.9 10^7.",
    CERTIFICATE,
)
def where_the_better_exponent_pays() -> str:
    """8.1 against 6.3 (54 n)^0.0475, and 8.1 * 54^1.8 against 324 n^0.2; both grow with n."""
    better = BETTER.exponent
    least = power_between(mpq(54 * 4), X - better)[0]
    demand(bool(SHARPER < bounds_bounce.COUNT_CONSTANT * least), "n = 4")
    high = power_between(mpq(54), 1 + better)[1]
    after = power_between(mpq(39 * 10**6), 1 - better)[0]
    demand(bool(SHARPER * high < 324 * after), "at 3.9 10^7")
    return f"54^1.8 <= {shown((high, high), 8).split('..')[1]}"
