"""Every constant of the checkers, exactly, with its place in the paper and its reason.

All are rationals (`gmpy2.mpq`) or integers.  Lengths are in grid units
(b = 1) where nothing else is said, and squared where the name says so.
The paper is Bern, Dobkin, Eppstein, *Triangulating Polygons without Large
Angles*.
"""

from __future__ import annotations

from gmpy2 import isqrt, mpq, mpz

from bern_exact.boundary.records import BlockShape
from bern_exact.checkers.bounds_grid import FACTOR, UNIT_ROUNDING, intervals_a_vertex

# Section 2, lopping (Lemma 1) -------------------------------------------------

CUT_FRACTION = mpq(1, 3)
"""Where an acute corner v is cut: |vw|/3 from v on both edges (Lemma 1; cutting line repaired)."""

CUT_ROUNDING = 1 - mpq(1, 2**9)
"""The least ratio of a cut's true distance from v to |vw|/3.

Cut parameters are rounded down to at least 10 significant bits, which loses
less than one part in 2^9.  They are never rounded up: a cut that takes less
than a third from each end leaves the proof of Lemma 1 as it is.
"""

LOPPED_FEATURE_SQUARED = CUT_FRACTION**2
"""(s'/s)^2 is at least this, times the squared rounding of the cuts (Lemma 1)."""

CUT_HEIGHT_SQUARED = mpq(1, 18)
"""(height/s)^2 of a cut triangle, (sqrt 2/6)^2, times the squared rounding of the cuts (Lemma 1).

Its edges are at least s/3, and all its angles at most 90 degrees, so that of
the two angles at its longest edge one is between 45 and 90: the height is at
least (s/3) sin 45.
"""

# Section 2, warping -------------------------------------------------------------

TAU = mpq(1, 8)
"""The snapping threshold of the second warping substep: b/8 (Section 2)."""

MOVED_BY_VERTICES_A_FACE = 1
"""Grid vertices of one face that move in substep 1 (Section 2; since b <= s'/8)."""

CHOOSERS = 2
"""q-vertices that choose the same grid vertex or exterior instance in substep 2 (Section 2)."""

FACE_SIDES = 6
"""Sides of a face outside the blocks: a rectangle that at most two edges cross (Lemma 2)."""

EDGES_A_FACE = 2
"""Edges of P' that cut corners off the rectangle of a face outside the blocks (Lemma 2)."""

PRINTED_MOVED = 2
"""Moved vertices of a face outside the blocks, as printed (Lemma 2); false, three may move."""


def slope(tau: mpq = TAU) -> mpq:
    """The slope that almost-horizontal edges outside blocks may have, 2 tau.

    The paper's arctan((b/4)/b) < 14.04 degrees: at worst one end of an edge of
    length at least b goes up by tau and the other down by tau.  An end that
    moves along the edge has not moved across it, so the length stays b.
    """
    return 2 * tau


def edge_squared(tau: mpq = TAU) -> mpq:
    """The least squared length of an edge after warping, tau^2 ("at least b/8", Section 2)."""
    return tau * tau


# Section 2, Lemma 2 ---------------------------------------------------------------

BLOCK_COTANGENT = mpq(-1)
"""The cotangent of each angle in a block is at least this: at most 135 degrees (Lemma 2)."""


def boundary_height_squared(tau: mpq = TAU) -> mpq:
    """The least squared height of a boundary triangle, (tau/sqrt 2)^2 (Lemma 2, repaired).

    The paper's "almost b/8" is too optimistic: an edge of length tau at 45
    degrees to the longest edge of its triangle gives tau/sqrt 2.
    """
    return tau * tau / 2


# Section 2, Lemma 3 ---------------------------------------------------------------

REGION_FEATURE = 1
"""The feature size of Q in grid units: axis-parallel edges between integer points."""

INTERIOR_HEIGHT_SQUARED = mpq(1, 2)
"""The least squared height of an interior triangle, (b/sqrt 2)^2 (Lemma 3, repaired).

The unit square attains it: "height at least b" is false as printed.
"""

SUBDIVISIONS_A_SIDE = 1
"""Unmatched points on a vertical side between matched ones, after both sweeps (Lemma 3)."""


def added_points(left: int, right: int) -> int:
    """How many points Lemma 3's sweeps may add: 2 B_L + B_R.

    B_L (B_R) boundary vertices lie strictly inside left (right) sides of
    columns.  Every second point of a side goes on, rounded down, so that one
    point causes at most 1/2 + 1/4 + ... < 1 further ones: B_L in the first sweep,
    and B_R + B_L in the second, which meets the points of the first as well.
    """
    return 2 * left + right


def interior_triangles(edges: int, holes: int) -> int:
    """How many triangles Lemma 3 may make: 4 N + 2 holes.

    By Euler's formula T = N + 2 I - 2 components + 2 holes for I added points.
    I <= 2 B_L + B_R, and B_L = B_R <= N/2: a vertex strictly inside a left side
    looks right along a chord which, by the matching condition, ends at a vertex
    strictly inside a right side, and conversely.  So 2 I <= 3 N.
    """
    return 4 * edges + 2 * holes


# Section 2, Theorem 1 ---------------------------------------------------------------

CORNERS_A_FACE = 6
"""Grid vertices of a face that has a piece of the boundary, before warping.

A face turns by 360 degrees in all: by 90 at each grid vertex (two whole
intervals cross there), by at least 0 at each q-vertex, by more than -180 at a
vertex of P'.  It has at most one vertex of P', in whose block it lies.  So
90 g - 180 < 360 + 180 leaves g <= 5 with one, g <= 4 with none; 6 is safe.
"""


def lopped_vertices(n: int) -> int:
    """Vertices of P': each acute vertex becomes two."""
    return 2 * n


def crossings(lopped: int, shape: BlockShape = "square") -> int:
    """q-vertices of P' with this many vertices: both ends of the kept intervals."""
    return 2 * intervals_a_vertex(shape) * lopped


def touched_triangles(lopped: int, shape: BlockShape = "square") -> int:
    """Triangles of the touched faces, for n' vertices and X q-vertices of P'.

    - The edges of P' are n' + X pieces, each on one face; so at most n' + X faces have a
      piece.  Such a face has at most 6 grid vertices and its pieces' ends: a face of m nodes
      makes at most m - 2 triangles, together at most (6 - 2)(n' + X) + 2 (n' + X).
    - A rectangle without a piece is touched because a corner of it moves.  At most n' grid
      vertices move in substep 1 and X in substep 2, each the corner of at most 4 rectangles
      of 2 triangles: 8 (n' + X).
    """
    pieces = lopped + crossings(lopped, shape)
    return (CORNERS_A_FACE - 2 + 2) * pieces + 8 * pieces


def region_edges(lopped: int, shape: BlockShape = "square") -> int:
    """N, the boundary edges of Q, for n' vertices and X q-vertices of P'.

    Each is an edge of a touched face between two grid vertices.  A face with a
    piece of the boundary has at most 5 such; round a moved grid vertex all four
    faces are touched, so their edges at it are inside, and 8 remain.
    """
    pieces = lopped + crossings(lopped, shape)
    return (CORNERS_A_FACE - 1) * pieces + 8 * pieces


def fan_triangles(n: int, lopped: int, shape: BlockShape = "square") -> int:
    """Triangles of the lopped corners: one a cut, and one more for each q-vertex on a cut."""
    return n + crossings(lopped, shape)


def theorem_1_triangles(n: int, shape: BlockShape = "square") -> int:
    """The explicit O(n) of Theorem 1: at most 4850 n triangles (3674 n for corner blocks).

    The sum of `touched_triangles`, `interior_triangles` with at most N/4 holes
    (a loop has 4 edges) and `fan_triangles`, for n' = 2 n.  A crude bound that
    follows from the parts; 25 to 80 n is what is seen.

    >>> theorem_1_triangles(1), theorem_1_triangles(1, "corner")
    (4849, 3673)
    """
    lopped = lopped_vertices(n)
    edges = region_edges(lopped, shape)
    return (
        touched_triangles(lopped, shape)
        + interior_triangles(edges, edges // 4)
        + fan_triangles(n, lopped, shape)
    )


def theorem_1_height_squared(
    tau: mpq = TAU, factor: mpq = FACTOR, shape: BlockShape = "square"
) -> mpq:
    """The least (height/s)^2 of Theorem 1: about 1/272.6^2 for the default tau and factor.

    Every part has height at least tau b/sqrt 2: Lemma 2 near the boundary (tau b/2
    in blocks round a corner), 1/sqrt 2 inside (Lemma 3).  A lopped corner's fan
    triangle has a base of at least tau b with an angle of 45 to 90 degrees at one end
    of the base's line: its height is at least tau b sin 45, or the corner's own.  And
    b >= s'/factor, s' >= s/3, each up to its rounding.
    """
    rounding = CUT_ROUNDING * UNIT_ROUNDING
    least = boundary_height_squared(tau) if shape == "square" else merged_height_squared(tau)
    return least * LOPPED_FEATURE_SQUARED * rounding**2 / factor**2


# Section 3, Lemma 5 ---------------------------------------------------------------


def boundary_cotangent(tau: mpq = TAU) -> mpq:
    """The cotangent of each angle near the boundary is at least this: 135 degrees + arctan(2 tau).

    A diagonal leaves an edge of slope at most 2 tau to an axis.  cot(135 + a) =
    (cot 135 cot a - 1)/(cot 135 + cot a) = -(1 + tan a)/(1 - tan a).

    >>> boundary_cotangent()  # 149.04 degrees; 150 degrees is -1.732
    mpq(-5,3)
    """
    return -(1 + 2 * tau) / (1 - 2 * tau)


def merged_height_squared(tau: mpq = TAU) -> mpq:
    """The least squared height of a triangle of a merged face, (tau/2)^2 (Lemma 5, repaired).

    Where a row of the grid ends on e, at E, beyond a last crossing C with a line that hits
    e, a distance L = CE along the row and D along the line may both be tau.  The
    diagonal through C cuts off a triangle of height L D/(L + D) >= tau/2.  If e is at most
    45 degrees - arctan(2 tau) from the row, leaving that diagonal out may leave too large an
    angle at C: tau/sqrt 2 is then out of reach, even for tau = 1/8.
    """
    return tau * tau / 4


def base_piece_squared(tau: mpq = TAU) -> mpq:
    """The least squared length of a piece of e between projections, (tau/sqrt 2)^2 (Lemma 5).

    In the case above it is L D / (L + D) over the sine of e's angle to the row, whose tangent is
    D/L: sqrt(L^2 + D^2) L/(L + D), at least tau/sqrt 2.
    """
    return tau * tau / 2


def merged_triangles(lopped: int, shape: BlockShape = "square") -> int:
    """Triangles near the boundary after merging and projecting, for n' vertices of P'.

    A merged face of faces with m_1, m_2, ... nodes has at most sum (m_i - 2) + 2
    staircase vertices; all but the two ends may be projected, each adding a vertex on the
    base.  So it makes at most 2 sum (m_i - 2) triangles: twice what its faces would.
    """
    return 2 * touched_triangles(lopped, shape)


def projected_fan_triangles(n: int, lopped: int, shape: BlockShape = "square") -> int:
    """Triangles of the lopped corners, if also projections may lie on the cuts.

    A projection comes from a staircase vertex: `touched_triangles` bounds their number.
    """
    return fan_triangles(n, lopped, shape) + touched_triangles(lopped, shape)


# Section 3, Lemmas 6 to 8 -----------------------------------------------------------

TILING_COTANGENT = mpq(-1)
"""The cotangent of each angle in a subdivided rectangle is at least this: 135 degrees (Lemma 7)."""

TILING_HEIGHT_SQUARED = mpq(1, 5)
"""The least (height/beta)^2 in a rectangle with least spacing beta (Lemma 7, repaired).

Attained: a base of length beta with the apex beta below it and beta beside its end has a
longest edge of sqrt(5) beta.
"""


def tiling_steiner_points(subdivisions: int) -> int:
    """The most Steiner points of a rectangle, for the subdivisions of a longer side (Lemma 7)."""
    return subdivisions + 2


def tiling_triangles(on_boundary: int) -> int:
    """The most triangles of a rectangle, for the vertices on its boundary (Lemma 7).

    With B = 4 + 2 k + 2 l vertices, k and l subdivisions of a longer and a shorter side,
    and at most k + 2 Steiner points, only if l >= 1: at most B + 2 (k + 2) - 2 <= 2 B.
    """
    return 2 * on_boundary


def halving_vertices(edges: int) -> int:
    """The most vertices of Lemma 6's partition: the floor of 1.5 N log2 N - 0.5 N.

    Each strip cut off has a long side on the boundary of what was left, no two the same
    piece of it, and there are no more strips than there were runs.  Proved in
    `proofs/lemma_6.py`, even with N for 0.5 N.  Exact: the greatest V with 2^(2 V + N) <= N^(3 N).

    >>> [halving_vertices(edges) for edges in (0, 4, 6, 1000)]
    [0, 10, 20, 14448]
    """
    log = (mpz(edges) ** (3 * edges)).bit_length() - 1
    return (log - edges) // 2


def strips_vertices(edges: int) -> int:
    """The most vertices of Lemma 8's partition: the floor of 2 N + N^1.5.

    Proved in `proofs/lemma_8.py`, even with N for 2 N.

    >>> [strips_vertices(edges) for edges in (0, 4, 6, 1000)]
    [0, 16, 26, 33622]
    """
    return 2 * edges + int(isqrt(mpz(edges) ** 3))


# Section 3, Theorems 2 and 3 ---------------------------------------------------------

LOG_PRECISION = 64
"""Logarithms are rounded up to multiples of 1/64."""

TILED_TRIANGLES_A_VERTEX = 4
"""Triangles of Q a vertex of its partition into subdivided rectangles (Lemmas 6 to 8).

With I Steiner points Euler's formula gives T = 2 (V + I) - N - 2 components + 2 holes, and
a hole has at least 4 edges: T <= 2 (V + I).  A rectangle with k and l >= 1
subdivisions of a longer and a shorter side has at most k + 2 <= k + l + 1 Steiner
points.  Round a vertex of the partition rectangles use 180 degrees for each of the
2 k + 2 l subdivisions, 90 for each of the 4 corners, in all at most 360: summed over
rectangles, k + l + 1 is at most V.  So I <= V.
"""


def log2_above(value: int) -> mpq:
    """A rational at least log2(value), by less than 1/64 too large.

    >>> log2_above(1024), log2_above(1000)
    (mpq(10,1), mpq(319,32))
    """
    return mpq((value**LOG_PRECISION - 1).bit_length(), LOG_PRECISION)


def theorem_2_triangles(n: int, shape: BlockShape = "square") -> int:
    """The explicit O(n log n) of Theorem 2.

    The sum of `merged_triangles`, four a vertex of Lemma 6's at most
    1.5 N log2 N - 0.5 N, and `projected_fan_triangles`, for n' = 2 n and
    N <= `region_edges` (n') <= 858 n.  A crude bound that follows from the parts;
    70 to 175 n is what is seen.

    >>> theorem_2_triangles(1), theorem_2_triangles(10**6) // 10**6
    (51313, 153952)
    """
    edges = region_edges(lopped_vertices(n), shape)
    vertices = int((3 * edges * log2_above(edges) - edges) / 2)
    return _theorem_triangles(n, vertices, shape)


def theorem_3_triangles(n: int, shape: BlockShape = "square") -> int:
    """The explicit O(n^1.5) of Theorem 3: as for Theorem 2, with Lemma 8's 2 N + N^1.5 vertices.

    >>> theorem_3_triangles(1), theorem_3_triangles(10**6) // 10**9
    (110229, 100538)
    """
    edges = region_edges(lopped_vertices(n), shape)
    return _theorem_triangles(n, 2 * edges + int(isqrt(mpz(edges) ** 3)), shape)


def _theorem_triangles(n: int, partition_vertices: int, shape: BlockShape) -> int:
    return TILED_TRIANGLES_A_VERTEX * partition_vertices + boundary_and_fan_triangles(n, shape)


def boundary_and_fan_triangles(n: int, shape: BlockShape = "square") -> int:
    """Triangles that are not inside Q, for n vertices of P: linear in n.

    >>> boundary_and_fan_triangles(1), boundary_and_fan_triangles(1, "corner")
    (2837, 2149)
    """
    lopped = lopped_vertices(n)
    return merged_triangles(lopped, shape) + projected_fan_triangles(n, lopped, shape)


def theorem_2_height_squared(tau: mpq = TAU, factor: mpq = FACTOR) -> mpq:
    """The least (height/s)^2 of Theorems 2 and 3: about 1/384^2 for the default tau and factor.

    Every part has height at least tau b/2: tau/sqrt 2 in blocks (Lemma 2), tau/2 in merged
    faces (Lemma 5), 1/sqrt 5 inside, where vertices are at least b apart (Lemma 7).  A
    lopped corner's fan triangle has a base of at least tau/sqrt 2 (Lemma 5) with angles of
    45 to 135 degrees at its ends: its height is at least tau/sqrt 2 sin 45, or the corner's
    own.  And b >= s'/factor, s' >= s/3, each up to its rounding.
    """
    rounding = CUT_ROUNDING * UNIT_ROUNDING
    return merged_height_squared(tau) * LOPPED_FEATURE_SQUARED * rounding**2 / factor**2
