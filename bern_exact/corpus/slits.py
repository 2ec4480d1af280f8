"""Polygons of any aspect ratio: a bar, a slit between two holes, a spike, a comb.

Meant to break meshers whose size grows with the aspect ratio: the number of triangles that
Theorems 2 and 3 promise depends on the number of vertices alone.
"""

from __future__ import annotations

from bern_exact.corpus.shapes import Ring


def bar(aspect: int) -> list[Ring]:
    """The rectangle of 1 by `aspect`, standing.

    >>> bar(10)
    [[(0, 0), (1, 0), (1, 10), (0, 10)]]
    """
    return [[(0, 0), (1, 0), (1, aspect), (0, aspect)]]


def slit(aspect: int) -> list[Ring]:
    """A plate with two holes and a slit of width 1 between them, `aspect` long: 12 vertices.

    In units of `aspect` the slit has width 1/A; everything else is as wide as it is long.

    Parameters
    ----------
    aspect : int
        A, at least 1.

    >>> [len(ring) for ring in slit(10**9)]
    [4, 4, 4]
    >>> slit(10)[1:]
    [[(10, 10), (10, 20), (20, 20), (20, 10)], [(21, 10), (21, 20), (31, 20), (31, 10)]]
    """
    a = aspect
    outer = [(0, 0), (4 * a + 1, 0), (4 * a + 1, 3 * a), (0, 3 * a)]
    left, right = ([(x, a), (x, 2 * a), (x + a, 2 * a), (x + a, a)] for x in (a, 2 * a + 1))
    return [outer, left, right]


def spike(aspect: int) -> list[Ring]:
    """A square with a spike on its top, 2 wide and `aspect` high: 7 vertices.

    Its tip has an angle of about 2/A.  Meant to break meshers that promise a least angle: here
    they cannot keep it, and must notice.

    >>> spike(10)
    [[(-10, 0), (10, 0), (10, 20), (1, 20), (0, 30), (-1, 20), (-10, 20)]]
    """
    a = aspect
    return [[(-a, 0), (a, 0), (a, 2 * a), (1, 2 * a), (0, 3 * a), (-1, 2 * a), (-a, 2 * a)]]


def comb(teeth: int, aspect: int) -> list[Ring]:
    """A comb of teeth 1 wide, 1 apart and `aspect` long on a back 1 wide: 4 vertices a tooth.

    Meant to break meshers whose size is the aspect ratio times the number of vertices.

    >>> comb(2, 10)
    [[(0, -1), (3, -1), (3, 10), (2, 10), (2, 0), (1, 0), (1, 10), (0, 10)]]
    """
    ring = [(0, -1), (2 * teeth - 1, -1)]
    for x in range(2 * teeth - 2, -1, -2):
        ring += [(x + 1, aspect), (x, aspect), (x, 0), (x - 1, 0)]
    return [ring[:-2]]


def needles(n: int, length: int) -> Ring:
    """A comb of about n/2 triangular needles side by side, each 2 wide and `length` long.

    Meant to break what is done at acute corners: each tip has its own tiny angle.

    >>> needles(6, 10)
    [(0, 0), (4, 0), (4, 1), (3, 11), (2, 1), (1, 10), (0, 1)]
    """
    count = max(n // 2 - 1, 1)
    ring = [(0, 0), (2 * count, 0), (2 * count, 1)]
    for i in reversed(range(count)):
        ring += [(2 * i + 1, length + i % 7), (2 * i, 1)]
    return ring
