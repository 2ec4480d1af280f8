"""Lemma 8 with its guide lines snapped to columns: at most 1.5 N + N^1.5 vertices.

**Symbols.**  N boundary vertices, |D| distinct abscissas, Hc horizontal chords, R reflex vertices,
guide lines at the abscissas number t, 2t, ... below |D|.

**(1)** |D| <= N/2: on each vertical line with a vertex there is another one, the other end of
its vertical edge, or of its chord, by the matching condition.  2 Hc = F + R <= N: each end of
a horizontal chord is a 180-degree vertex on a vertical edge or a reflex vertex, and has no other.

**(2)** Vertices of the partition off the boundary are crossings of cut chords and horizontals.
A horizontal chord crosses a guide line once at most, and the cut left side of the column through
which the line passes there: at most (ceil(|D|/t) - 1) Hc vertices on cut chords.  A horizontal cut
from a reflex vertex goes through columns without a guide line up to one with a line: between two
lines there are t - 1 abscissas: at most R (t - 1) vertices.

**(3)** V <= N + (ceil(|D|/t) - 1) Hc + R (t - 1) <= N + |D| Hc/t + R (t - 1).

**(4)** Let x = sqrt(|D| Hc/R).  |D| Hc/t + R t = R (2 x + (x - t)^2/t).  t is x rounded, at least
1: (x - t)^2/t <= 1 (1/4 if x >= 1/2; for x < 1/2, t = 1).  So V <= N + 2 sqrt(|D| Hc R), which is
at most N + 2 sqrt((N/2)(N/2) N) = N + N^1.5.  If R = 0 there are no cuts: V = N.

That is N fewer than the claim.
"""

from __future__ import annotations

import sympy

from bern_exact.checkers import bounds
from bern_exact.interior.subdivided.lattice import Lattice
from bern_exact.interior.subdivided.strips import _abscissas, _reflex_vertices, count_strips
from proofs.algebra import demand_equal, demand_nonnegative, symbols
from proofs.polyominoes import outline, polyominoes
from proofs.statement import ENUMERATION, IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements


@CHAPTER.proved(
    "Lemma 8 (repaired)",
    "The partition has at most N + N^1.5 vertices: N fewer than the checked bound.",
    IDENTITY,
)
def vertices() -> str:
    """The module's docstring."""
    x, t, reflex = sympy.symbols("x t R", positive=True)
    spread = reflex * x**2 / t + reflex * t
    demand_equal(spread, reflex * (2 * x + (x - t) ** 2 / t), "(4)")
    a, e = symbols("a e")
    # x >= 1/2: t >= 1 and |x - t| <= 1/2; then 4 (x - t)^2 <= 1 <= t.
    demand_nonnegative((1 + a) - 1, "t >= 1")
    # x < 1/2: t = 1 and (1 - x)^2 <= 1, x = 1/(2 + e).
    small = 1 / (2 + e)
    demand_nonnegative(sympy.cancel((1 - (1 - small) ** 2) * (2 + e) ** 2), "x < 1/2")
    edges = sympy.Symbol("N", positive=True)
    most = 2 * sympy.sqrt(edges / 2 * edges / 2 * edges)
    demand_equal(most, edges ** sympy.Rational(3, 2), "2 sqrt(N^3/4)")
    for n in (4, 6, 8, 64, 1000):
        over = bounds.strips_vertices(n) - 2 * n
        demand(over * over <= n**3 < (over + 1) ** 2, "strips_vertices()")
    return "N + R (2 x + (x - t)^2/t) - R <= N + 2 sqrt(|D| Hc R)"


MOST_CELLS, MOST_SPACING = 6, 4
"""Squares of the regions, and spacings, that steps (1) and (3) are checked on."""


@CHAPTER.proved(
    "Lemma 8 (repaired)",
    "V <= N + (ceil(|D|/t) - 1) Hc + R (t - 1), |D| <= N/2 and Hc <= N/2, in the product on all "
    "regions of up to 6 unit squares without holes and t from 1 to 4.",
    ENUMERATION,
)
def counts_on_small_regions() -> str:
    """Steps (1) and (3) of the module's docstring."""
    cases = 0
    for size in range(1, MOST_CELLS + 1):
        for region in filter(None, map(outline, polyominoes(size))):
            edges, reflex = region.edges, sum(1 for _ in _reflex_vertices(region))
            abscissas, chords = len(_abscissas(region)), len(Lattice.of(region).rows.chords())
            demand(2 * abscissas <= edges and 2 * chords <= edges, "(1)")
            for t in range(1, MOST_SPACING + 1):
                most = edges + (-(-abscissas // t) - 1) * chords + reflex * (t - 1)
                demand(count_strips(region, t) <= most, f"(3) {region.loops}, t = {t}")
                cases += 1
    return f"{cases} partitions"
