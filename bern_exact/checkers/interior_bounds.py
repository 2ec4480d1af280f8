"""Constants of Lemmas 6 to 8."""

from __future__ import annotations

from gmpy2 import mpq, mpz

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


def halving_vertices_hold(vertices: int, edges: int) -> bool:
    """Is V <= 1.5 N log2 N - 0.5 N (Lemma 6)?  Exactly: 2^(2 V + N) <= N^(3 N).

    >>> halving_vertices_hold(10, 4), halving_vertices_hold(11, 4)
    (True, False)
    """
    return bool(mpz(1) << (2 * vertices + edges) <= mpz(edges) ** (3 * edges))


def strips_vertices_hold(vertices: int, edges: int) -> bool:
    """Is V <= 2 N + N^1.5 (Lemma 8)?  Exactly, by squaring.

    >>> strips_vertices_hold(16, 4), strips_vertices_hold(17, 4)
    (True, False)
    """
    beyond = vertices - 2 * edges
    return beyond <= 0 or beyond * beyond <= edges**3
