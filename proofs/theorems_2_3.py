"""Theorems 2 and 3 with explicit constants."""

from __future__ import annotations

import sympy
from gmpy2 import mpq

from bern_exact.checkers import bounds, bounds_grid
from bern_exact.corpus.paper import spanning_tree_length
from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.exact.enclosures import sqrt_enclosure
from bern_exact.theorems.threshold import largest_angle_for, threshold_for
from proofs.algebra import demand_equal
from proofs.lemma_2.thresholds import LEAST
from proofs.merged_faces import left_out
from proofs.powers import log_bounds, rounded, shown
from proofs.section_2 import degrees_of_arctan
from proofs.statement import CERTIFICATE, IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements

BOUNDARY_A_VERTEX = 2837
"""Triangles not inside Q, for each vertex of P."""


@CHAPTER.proved(
    "Theorems 2 and 3",
    "At most 2837 n triangles lie outside Q, whose N is at most 858 n.",
    IDENTITY,
)
def boundary_and_fans() -> str:
    """Twice 924 n, and for the fans 65 n + 924 n."""
    n = sympy.Symbol("n", integer=True, positive=True)
    demand_equal(bounds.boundary_and_fan_triangles(n), BOUNDARY_A_VERTEX * n, "2837 n")
    demand_equal(bounds.region_edges(bounds.lopped_vertices(n)), 858 * n, "858 n")
    return "1848 + 65 + 924"


@CHAPTER.proved(
    "Theorem 2",
    "At most 5148 n log2 n + 51298 n triangles.",
    CERTIFICATE,
)
def theorem_2_count() -> str:
    """4 V of Lemma 6, N = 858 n: 4 (1.5 N log2 N - 0.5 N) + 2837 n, N >= 4.

    log2 (858 n) = log2 858 + log2 n.
    """
    slope = 4 * mpq(3, 2) * 858
    low, high = log_bounds(mpq(858))
    two = log_bounds(mpq(2))
    log = rounded(low / two[1], high / two[0])
    constant = slope * log[1] - 4 * mpq(1, 2) * 858 + BOUNDARY_A_VERTEX
    demand(slope == 5148, "6 * 858")
    demand(bool(constant <= 51298), "the linear term")
    demand(bounds.TILED_TRIANGLES_A_VERTEX == 4, "4 V")
    demand(bool(bounds.log2_above(858) >= log[0]), "log2_above()")
    # The checked bound rounds logarithms up by less than 1/64.
    for n in (1, 10, 10**6):
        more = bounds.theorem_2_triangles(n) - (constant + slope * bounds.log2_above(n)) * n
        demand(bool(more <= slope * n * mpq(1, 32)), f"theorem_2_triangles({n})")
    return f"log2 858 in {shown(log, 8)}"


@CHAPTER.proved(
    "Theorem 3",
    "At most 100530 n^1.5 + 9701 n triangles.",
    CERTIFICATE,
)
def theorem_3_count() -> str:
    """4 (2 N + N^1.5) + 2837 n, N = 858 n: 4 * 858^1.5 = 100529.1...; Lemma 8 is sharper now."""
    demand(bool(mpq(100530) ** 2 >= 16 * mpq(858) ** 3), "4 * 858^1.5 <= 100530")
    demand(8 * 858 + BOUNDARY_A_VERTEX == 9701, "the linear term")
    for n in (1, 4, 10**4):
        root = int(n**3) if n == 1 else {4: 8, 10**4: 10**6}[n]
        demand(bounds.theorem_3_triangles(n) <= 100530 * root + 9701 * n, f"n = {n}")
    return "4 * 858^1.5 <= 100530"


@CHAPTER.proved(
    "Theorems 2 and 3",
    "All heights are at least s/385.6, for tau = 1/8 and b = s'/8 (in blocks by the certificate of "
    "the shipped rule, which `--full` replays).",
    CERTIFICATE,
)
def height() -> str:
    """The least part is tau/2, of merged faces (`merged_faces.height_of_merged_faces`).

    Fans stand on sides of block faces, at least tau, and on pieces between projections, at least
    tau/sqrt 2 (`merged_faces.pieces_of_the_base`): they have at least tau/2.  Blocks have tau/sqrt
    2.  Rectangles that a moved corner alone joins to the boundary:
    `outside_blocks.faces_without_boundary`.
    """
    part = bounds.merged_height_squared()
    demand(bool(part <= bounds.boundary_height_squared()), "blocks")
    demand(bool(part <= bounds.base_piece_squared() / 2), "fans")
    demand(bool(part <= bounds.edge_squared() / 2), "fans, on sides of block faces")
    demand(bool(part <= bounds.TILING_HEIGHT_SQUARED), "Lemma 7, vertices of Q being 1 apart")
    rounding = (bounds.CUT_ROUNDING * bounds_grid.UNIT_ROUNDING) ** 2
    total = part * bounds.LOPPED_FEATURE_SQUARED * rounding / bounds_grid.FACTOR**2
    demand(bounds.theorem_2_height_squared() == total, "theorem_2_height_squared()")
    demand(bool(total * mpq(3856, 10) ** 2 >= 1), "s/385.6")
    return "s/height = {} .. {}".format(*sqrt_enclosure(1 / total, 6))


@CHAPTER.proved(
    "Theorems 2 and 3",
    "No angle is above 135 degrees + arctan(2 tau) = 149.04 degrees, for tau = 1/8 (in blocks by "
    "the certificate of the shipped rule, which `--full` replays).",
    IDENTITY,
)
def largest_angle() -> str:
    """Lemma 7 inside Q: 135.  The fans: 135 (Lemma 1).  Blocks: 135 (`lemma_2.statements`).

    Merged faces: `merged_faces.every_merged_face`.  Rectangles that a moved corner alone joins to
    the boundary: `outside_blocks.faces_without_boundary`.
    """
    demand(bool(bounds.TILING_COTANGENT >= bounds.boundary_cotangent()), "Lemma 7")
    demand(bool(bounds.BLOCK_COTANGENT >= bounds.boundary_cotangent()), "blocks")
    slope = bounds.slope()
    demand(bool(2 * slope < 1 - slope * slope), "2 arctan(2 tau) < 45 degrees")
    worst = bounds.boundary_cotangent()
    demand(bool(worst < 0 and worst * worst < 3), "below 150 degrees")
    return f"least cotangent {worst}; 150 degrees has -1.732..."


@CHAPTER.proved(
    "Theorems 2 and 3, --max-angle",
    f"No angle is above A, for every A from 135 degrees + arctan({2 * LEAST}) to 150 degrees (in "
    "blocks by the certificates of `lemma_2.thresholds`, which `--full` replays).",
    CERTIFICATE,
)
def any_bound() -> str:
    """tau is the largest p/q <= 1/8, q <= 1000, with 135 degrees + arctan(2 tau) <= A.

    The least tau of the certificates is such a fraction: for these A, and for no smaller ones, tau
    is at least that.  The parts are those of `largest_angle`, each for every tau <= 1/8: 135 inside
    Q, in fans and in blocks; merged faces and rectangles by written proofs with tau as a symbol.
    What these, `outside_blocks` and `lemma_4` compare at tau = 1/8 alone holds all the more below,
    with two exceptions.  One comparison of `merged_faces.every_merged_face` is worst at tau = 0.
    And projections nearer than tau/sqrt 2 to an end are not drawn: those are among the ones that
    `every_merged_face` leaves out (`merged_faces.base_pieces`) if `left_out(tau)` is above tau.
    """
    angle = largest_angle_for(LEAST)
    bound = parse_angle_bound(f"cos:-1:{angle.cos_squared}")
    demand(threshold_for(bound) == LEAST, "the least tau is taken, just where it may be")
    common = 5  # squared: 5 (1 - tau)^2 at tau = 0
    demand(4 * 32 * common < (bounds_grid.FACTOR**2 - 32 - common) ** 2, "`every_merged_face`")
    tau = sympy.Symbol("tau", positive=True)
    y = tau / (1 + 2 * tau * tau)
    demand_equal(left_out(tau), 2 * y / (1 + y), "left_out() > tau if 2 y > tau (1 + y)")
    more = (2 * y - tau * (1 + y)) * (1 + 2 * tau * tau)
    demand_equal(more, tau * (1 + tau) * (1 - 2 * tau), "above 0 for tau < 1/2")
    low, high = degrees_of_arctan(2 * LEAST)
    demand(bool(135 + high < 150 and bounds.boundary_cotangent(LEAST) < -1), "a range")
    return f"tau from {LEAST} to 1/8: A from {shown((135 + low, 135 + high), 8)} degrees"


CROSS = ((1, 0), (0, 1), (-1, 0), (0, -1))
"""Four points that a network of length 4 joins."""


@CHAPTER.refuted(
    "Section 3.2, lower bound",
    "A network of rectangles is at least as long as the minimum spanning tree of the vertices.",
)
def mst_step() -> str:
    """Every spanning tree of the four points has length 6, in the L1 metric; the cross has 4."""
    tree, cross = spanning_tree_length(CROSS), sum(abs(x) + abs(y) for x, y in CROSS)
    demand((tree, cross) == (6, 4), "the cross")
    return "(1, 0), (0, 1), (-1, 0), (0, -1): cross 4, spanning tree 6"


@CHAPTER.proved(
    "Section 3.2, lower bound (repaired)",
    "A partition of the grid of holes has at least a third of the spanning tree's length as "
    "vertices: Omega(n^1.5) as printed.",
    "written proof, from Hwang's theorem",
)
def steiner_ratio() -> str:
    """A network that spans points is a Steiner tree: at least 2/3 of the least one (Hwang 1976).

    Its length in lattice units is the number of its edges; a vertex has at most 4, so there are
    at most 2 V edges: V >= MST/3.
    """
    demand(3 * sum(abs(x) + abs(y) for x, y in CROSS) == 2 * spanning_tree_length(CROSS), "2/3")
    return "V >= (2/3 MST)/2; 2/3 is attained by the cross"
