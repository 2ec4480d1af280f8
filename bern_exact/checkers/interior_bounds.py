"""Constants of Lemmas 6 to 8."""

from __future__ import annotations

from gmpy2 import isqrt, mpq, mpz

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
    piece of it; that boundary is at most N long, and there are at most 2 log2 N half-steps.
    Exact: the greatest V with 2^(2 V + N) <= N^(3 N).

    >>> [halving_vertices(edges) for edges in (0, 4, 6, 1000)]
    [0, 10, 20, 14448]
    """
    log = (mpz(edges) ** (3 * edges)).bit_length() - 1
    return (log - edges) // 2


def strips_vertices(edges: int) -> int:
    """The most vertices of Lemma 8's partition: the floor of 2 N + N^1.5.

    >>> [strips_vertices(edges) for edges in (0, 4, 6, 1000)]
    [0, 16, 26, 33622]
    """
    return 2 * edges + int(isqrt(mpz(edges) ** 3))
