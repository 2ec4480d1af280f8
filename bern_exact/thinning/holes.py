"""The highest triangulation of a hole by its own vertices."""

from __future__ import annotations

from collections.abc import Sequence

from gmpy2 import mpz

from bern_exact.plane.mesh import Triangle
from bern_exact.thinning.grade import Grades

_NOTHING = mpz(0)


def fill(ring: Sequence[int], grades: Grades) -> list[Triangle] | None:
    """The triangulation of a ring whose least grade is greatest.

    Parameters
    ----------
    ring : sequence of int
        A simple polygon's vertices, counter-clockwise; its least vertex first.
    grades : Grades
        What its triangles must keep.

    Returns
    -------
    list of (int, int, int) or None
        None if there is no triangulation of triangles that may be made.  Of equally good ones,
        that with the least third corners.

    Notes
    -----
    The triangles of any choice of third corners form a combinatorial disc; if all are
    positively oriented over a simple ring they tile its interior.  Cubic in the ring's length.
    """
    size = len(ring)
    best: list[list[mpz]] = [[_NOTHING] * size for _ in ring]
    third = [[0] * size for _ in ring]
    for width in range(2, size):
        for i in range(size - width):
            best[i][i + width], third[i][i + width] = _third(ring, grades, best, i, i + width)
    if not best[0][size - 1]:
        return None
    return _chosen(ring, third, 0, size - 1)


def least_first(triangle: Triangle) -> Triangle:
    """The same triangle, its least vertex first."""
    a, b, c = triangle
    if b < a or c < a:
        return (b, c, a) if b < c else (c, a, b)
    return triangle


def _third(
    ring: Sequence[int], grades: Grades, best: Sequence[Sequence[mpz]], i: int, j: int
) -> tuple[mpz, int]:
    """The best least grade of the sub-polygon i ... j, and the third corner at its side ij."""
    most, corner = _NOTHING, 0
    for k in range(i + 1, j):
        low, high = best[i][k], best[k][j]
        # A side of the ring itself has nothing beyond it.
        if (k > i + 1 and low <= most) or (k + 1 < j and high <= most):
            continue
        least = grades.of(*least_first((ring[i], ring[k], ring[j])))
        if k > i + 1 and low < least:
            least = low
        if k + 1 < j and high < least:
            least = high
        if least > most:
            most, corner = least, k
    return most, corner


def _chosen(ring: Sequence[int], third: Sequence[Sequence[int]], i: int, j: int) -> list[Triangle]:
    """The triangles of the sub-polygon i ... j."""
    if j < i + 2:
        return []
    k = third[i][j]
    return [
        *_chosen(ring, third, i, k),
        (ring[i], ring[k], ring[j]),
        *_chosen(ring, third, k, j),
    ]
