"""Lemma 6: at most 1.5 N log2 N - 0.5 N vertices, and a boundary that never grows.

**Setting.**  At the beginning of a half-step a piece has c runs, u lattice cells wide, in the
direction that is halved, and r runs across, u' wide.  Every run has two ends on the boundary and
all boundary edges are ends of runs: the boundary has a + b edges, a = 2 c u on the ends of the
runs and b = 2 r u' on their long sides.  Within a level first u' = u, then u' = 2 u.  N is the
number of edges at the start.

**(1) Tree.**  Without holes each chord between neighbouring runs parts the piece: runs and chords
are a tree, c - 1 chords; those of one parity are at most (c - 1)/2.

**(2) The boundary.**  Let g be the number of pairs glued, and a' = 2 g (2 u), b' what comes of b.
Each run across is shortened to at most one: b' <= b.  With the parity of fewer pairs
a' <= 2 u (c - 1) < a; the other parity is taken only if a' + b is within the piece's budget.  So
in both cases **a' + b <= the budget**, a' + b' too; and when what is left falls into parts
the budget is shared in proportion to boundaries, rounded down, which leaves each part at
least its own boundary.  All budgets together are at most N.

**(3) Strips.**  What a half-step cuts off are maximal uncovered parts of runs, s of them, with
lengths L.  (i) The sum of L is at most b: next to its line of the chosen parity an uncovered part
is at the boundary.  (ii) s <= c.  A pair is the piece that two runs have in common, so
its lower end is the start of one of them at least, beyond which at most the other run is uncovered.
So each of the 2 g ends of pairs is next to at most one strip.  Every strip is next to one, but
for the c_0 runs without a pair; in a run with k >= 1 pairs each of the k - 1 gaps between
neighbouring pairs is a strip next to two ends, or empty with two ends next to none.
With X the sum of k - 1 over these runs: s <= 2 g - X + c_0, and 2 g = sum k = X + (c - c_0).

**(4) A half-step** contributes sum (u + L) <= c u + b = a/2 + b <= N/2 + b/2.  A piece that is a
rectangle is put out whole; it contributes (a + b)/2, less than that.

**(5) Neighbouring half-steps.**  The b of the next half-step is a'.  By (2) the b of two
neighbouring ones are together at most N.

**(6) How many.**  A piece at a half-step has a boundary of at least 2 (u + u') >= 4 u: 4 * 2^j <= N
at level j, and there are at most log2 N - 1 levels of two half-steps.

**(7) Sum.**  The drawing has E = (N + sum of perimeters)/2 lattice edges, F rectangles, and
V = E - F + components <= E by Euler's formula.  A perimeter is 2 (u + L).  So
V <= N/2 + sum over half-steps <= N/2 + (log2 N - 1)(2 N/2 + N/2) = 1.5 N log2 N - N.

That is N/2 fewer than the claim.
"""

from __future__ import annotations

from bern_exact.checkers import bounds
from bern_exact.interior.subdivided.erosion import Piece, half_step
from bern_exact.interior.subdivided.halving import _first_piece, count_halving
from proofs.algebra import demand_equal, demand_nonnegative, symbols
from proofs.polyominoes import outline, polyominoes
from proofs.statement import IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements

MOST_CELLS, MANY_CELLS = 7, 9
"""Squares of the regions that every step of the proof is checked on."""


@CHAPTER.proved(
    "Lemma 6 (repaired)",
    "With the parity chosen as it is, what is left after each half-step has a boundary of at most "
    "N.",
    IDENTITY,
)
def boundary() -> str:
    """Steps (1) and (2) of the module's docstring."""
    c, u, rest = symbols("c u rest")
    runs = c + 1
    a, glued = 2 * runs * u, 2 * (runs - 1) / 2 * 2 * u
    demand_nonnegative(a - glued, "(2) a' <= 2 u (c - 1) <= a")
    part, total = symbols("part total")
    demand_equal((total + rest) * part / total - part, rest * part / total, "(2) shares")
    return "a' + b <= budget"


@CHAPTER.proved(
    "Lemma 6 (repaired)",
    "The partition has at most 1.5 N log2 N - N vertices: N/2 fewer than the checked bound.",
    IDENTITY,
)
def vertices() -> str:
    """Steps (3) to (7) of the module's docstring."""
    c, unpaired, surplus, edges, log = symbols("c c0 X N log2N")
    twice_pairs = surplus + c - unpaired
    demand_equal(twice_pairs - surplus + unpaired, c, "(3) s <= c")
    b, rest = symbols("b rest")
    a = edges - b - rest
    demand_nonnegative(edges / 2 + b / 2 - (a / 2 + b), "(4) a/2 + b <= N/2 + b/2")
    total = edges / 2 + (log - 1) * (2 * edges / 2 + edges / 2)
    demand_equal(total, 3 * edges * log / 2 - edges, "(7)")
    for n in (4, 6, 8, 64, 1000):  # the floor of 1.5 N log2 N - 0.5 N, as `bounds` computes it
        most = bounds.halving_vertices(n)
        demand(2 ** (2 * most + n) <= n ** (3 * n) < 2 ** (2 * most + 2 + n), "halving_vertices()")
    return "N/2 + (log2 N - 1) 3 N/2"


@CHAPTER.proved(
    "Lemma 6 (repaired)",
    "Steps (1) to (5) of the proof hold in the product on all regions of up to 7 unit squares "
    "without holes.",
    "exhaustive exact enumeration",
)
def steps_on_small_regions() -> str:
    """Every half-step of every region."""
    return _enumerate(range(1, MOST_CELLS + 1))


@CHAPTER.proved(
    "Lemma 6 (repaired)",
    "The same on all regions of 8 and 9 unit squares.",
    "exhaustive exact enumeration",
    full=True,
)
def steps_on_larger_regions() -> str:
    """Every half-step of every region."""
    return _enumerate(range(MOST_CELLS + 1, MANY_CELLS + 1))


def _enumerate(sizes: range) -> str:
    regions = half_steps = 0
    for size in sizes:
        for cells in polyominoes(size):
            region = outline(cells)
            if region is None:
                continue
            regions += 1
            half_steps += _follow(_first_piece(region.loops[0], False), region.edges)
            demand(count_halving(region) <= bounds.halving_vertices(region.edges), "V")
    return f"{regions} regions, {half_steps} half-steps"


def _follow(first: Piece, edges: int) -> int:
    """All half-steps on one region; how many."""
    done, waiting = 0, [first]
    while waiting:
        piece = waiting.pop()
        done += 1
        web, cross = piece.web, piece.cross
        a, b = 2 * len(web.runs) * web.unit, 2 * len(cross.runs) * cross.unit
        demand(len(web.chords) == len(web.runs) - 1, "(1) a tree")
        demand(a + b == piece.boundary <= piece.budget <= edges, "(2) the budget")
        clippings, parts = half_step(piece)
        demand(len(clippings) <= len(web.runs), "(3) s <= c")
        demand(sum(clipping.along for clipping in clippings) <= b, "(3) lengths")
        later_b = sum(2 * len(part.web.runs) * part.web.unit for part in parts)
        later_a = sum(2 * len(part.cross.runs) * part.cross.unit for part in parts)
        demand(later_b <= b and later_a + b <= piece.budget, "(2) a' + b <= budget")
        demand(sum(part.budget for part in parts) <= piece.budget, "(2) shares")
        waiting += parts
    return done


@CHAPTER.proved(
    "Lemma 6, use",
    "A partition with V vertices makes at most 4 V triangles by Lemma 7, 6 N log2 N for Lemma 6's.",
    IDENTITY,
)
def tiled_triangles() -> str:
    """T = 2 (V + I) - N - 2 components + 2 holes, a hole has 4 edges: T <= 2 (V + I).

    A rectangle has at most k + 2 <= k + l + 1 Steiner points, if l >= 1, else none.  At its
    vertices it uses 180 degrees a subdivision, 90 a corner; a vertex has at most 360: I <= V.
    """
    k, less = symbols("k l")
    demand_equal((180 * (2 * k + 2 * less) + 4 * 90) / 360, k + less + 1, "angles")
    steiner = bounds.tiling_steiner_points(k)
    demand_nonnegative((k + (less + 1) + 1) - steiner, "k + 2 <= k + l + 1 for l >= 1")
    vertices, edges, components, holes = symbols("V N c h")
    made = 2 * (vertices + vertices) - (edges + 4 * holes) - 2 * components + 2 * holes
    demand_nonnegative(bounds.TILED_TRIANGLES_A_VERTEX * vertices - made, "T <= 4 V")
    return "2 (V + V)"
