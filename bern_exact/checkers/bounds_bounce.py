"""The constants of Section 5 up to Lemma 9, exactly, with their reasons; Lemmas 10 to 12 follow
in `bounds_convex`.
"""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.checkers.bounds_convex import EXPONENT, POWER_CONSTANT
from bern_exact.exact.enclosures import power_bounds

RIGHT_TRIANGLES = 3
"""Right triangles that a subdivided right triangle is cut into (Lemma 9)."""

SUBDIVISIONS_A_TRIANGLE = 1
"""Subdivision points of a triangle along the boundary after bouncing (Section 5)."""


def first_subdivisions(n: int) -> int:
    """Subdivision points before bouncing: at most two for each vertex but A and B.

    A vertical meets the boundary twice, and from each end one horizontal goes to the other side.
    """
    return max(0, 2 * (n - 2))


def half_steps(first: int, turned: int) -> int:
    """How many subdivisions may be bounced: those there are at first, and those in the middle.

    Outside the middle each half-step leaves one subdivision alone in its triangle for good.
    Of two in a triangle the farther along is bounced, to a place still farther, and all later
    ones of its strip come from places at least as far: conflicts are settled in the order of
    the places where the farther one is on the right or would come to be next, which only grow.
    A path is either bounced on or left alone, so that no more half-steps settle than there are
    paths.
    """
    return first + turned


def middle_steps(first: int) -> int:
    """How many subdivisions may be bounced in the middle: one a path.

    From there a path goes on in the sense that never turns, unless the other end of its
    vertical lies inside a flat, where it ends.
    """
    return first


def closed_paths(first: int) -> int:
    """How many closed paths may be added: one for each subdivision there is at first.

    One that closes by itself is charged to the subdivision on it.  Another parts two neighbouring
    subdivisions of a triangle.  Join these by an edge: a path is on the same side of each closed
    path for ever, so that an edge spans its own closed path and none that was added before.  Of the
    edges of a cycle the first one's closed path would be spanned by a later one.  So edges are a
    forest, fewer than paths.  Proved, with the other counts, in `proofs/bouncing.py`.
    """
    return first


def verticals(n: int) -> int:
    """How many verticals there are after bouncing: 9 n.

    n for the vertices, at most 2 (2 n) for half-steps, and 2 for each of at most 2 n closed paths.
    """
    return 9 * n


def horizontals(n: int) -> int:
    """How many horizontals: AB, and one for each end of each vertical."""
    return 2 * verticals(n) + 1


def rim_triangles(columns: int) -> int:
    """Triangles along the boundary: two right triangles a column, cut into at most three each."""
    return 2 * RIGHT_TRIANGLES * columns


def baseline_triangles(n: int) -> int:
    """The explicit O(n^2) of the bouncing algorithm: all cells split, and the rim.

    >>> baseline_triangles(10)
    32940
    """
    return 2 * verticals(n) * (horizontals(n) - 1) + rim_triangles(verticals(n))


LONG_SIDES = mpq(1)
"""The long sides of the blocks with 2^i <= short side < 2^(i+1), at most so many times N.

N is the number of edges of cells on the boundary of Q.  Blocks of one such class are cut off
by the two half-steps of one level of Lemma 6.  Each has a long side on the boundary of what was
left, no two the same piece of it.  What is left stays orthoconvex, and so its boundary is at most
N edges long.  Proved, for blocks put out whole as well, in `proofs/theorem_4.py`; at most 1/2 is
seen.
"""

COUNT_CONSTANT = mpq(63, 10)
"""Triangles of blocks are at most so many times N^(1 + x), x = 0.8475.

A block with short side s and long side l has at most POWER_CONSTANT (s^x l + l^x s) <= 5 s^x l
triangles.  A class of blocks has less than 5 (2^(i+1))^x N, and 2^i <= N/4 as a block has four
sides within the boundary of its bounding box.  Summed over i that is less than
5 (2^x 2^x/(2^x - 1)) (N/4)^x N = 5/(2^x - 1) N^(1+x), and 2^x > 1.794.
"""


def boundary_edges(columns: int, rows: int) -> int:
    """N for an orthoconvex Q in one piece: the sides of its bounding box."""
    return 2 * (columns + rows)


def theorem_4_triangles(n: int) -> int:
    """The explicit O(n^1.8475) of Theorem 4: 6.3 N^1.8475 and the rim, N = 54 n.

    There are at most 9 n columns and 18 n rows.  A crude bound that follows from the parts:
    `baseline_triangles` is less for all n up to 5.8 10^9, and more from 5.9 10^9 on.

    >>> theorem_4_triangles(10), theorem_4_triangles(10**6) // 10**12
    (704328, 1216)
    """
    edges = boundary_edges(verticals(n), horizontals(n) - 1)
    _, power = power_bounds(edges, EXPONENT, 8)
    return int(COUNT_CONSTANT * power * edges) + rim_triangles(verticals(n))


def blocks_triangles(powers: mpq, columns: int) -> int:
    """Triangles for a sum of m^x k + m k^x over blocks, with the rim."""
    return int(POWER_CONSTANT * powers) + rim_triangles(columns)
