"""Lawson's flips: from any triangulation of a polygon to a constrained Delaunay one."""

from __future__ import annotations

from collections.abc import Sequence

from bern_exact.exact.points import HPoint, direction
from bern_exact.exact.predicates import cross, dot


def make_delaunay(points: Sequence[HPoint], origin: list[int], twin: list[int]) -> int:
    """Flip edges that are not locally Delaunay, in place, and return the number of flips.

    Parameters
    ----------
    points : sequence of HPoint
        The vertices.
    origin, twin : list of int
        The half-edges, as in `Triangulation`; changed.  Edges without a twin stay.

    Notes
    -----
    It ends: each flip lowers the lifted surface z = x^2 + y^2 over the triangulation, so no edge
    comes back.  Then every edge is locally Delaunay, which makes the whole constrained Delaunay.
    """
    pending = [h for h, opposite in enumerate(twin) if h < opposite]
    flips = 0
    while pending:
        h = pending.pop()
        g = twin[h]
        if g < 0:
            continue
        h1, h2 = _others(h)
        g1, g2 = _others(g)
        if _is_delaunay(points, origin[h], origin[g], origin[h2], origin[g2]):
            continue
        _flip(origin, twin, h, h1, g, g1)
        flips += 1
        pending += (h, h2, g, g2)
    return flips


def _others(h: int) -> tuple[int, int]:
    """The next and the previous half-edge of the same triangle."""
    corner = h % 3
    return (h + 1 if corner < 2 else h - 2), (h - 1 if corner else h + 2)


def _is_delaunay(points: Sequence[HPoint], a: int, b: int, c: int, d: int) -> bool:
    """Is edge ab right between the triangles abc and bad: do c and d see it under <= 180 in sum?

    The sum of two angles in (0, 180) is above 180 exactly if its sine is negative; d then lies
    inside the circle through a, b, c, and the quadrilateral is strictly convex.
    """
    p, q = points[a], points[b]
    u, v = direction(points[c], p), direction(points[c], q)
    x, y = direction(points[d], q), direction(points[d], p)
    dot_c, dot_d = dot(u, v), dot(x, y)
    if dot_c >= 0 and dot_d >= 0:
        return True
    return bool(cross(u, v) * dot_d + dot_c * cross(x, y) >= 0)


def _flip(origin: list[int], twin: list[int], h: int, h1: int, g: int, g1: int) -> None:
    """Replace the edge a-b of h = ab, g = ba by the other diagonal c-d of its quadrilateral.

    Triangles (ab, bc, ca) and (ba, ad, db) become (ad, dc, ca) and (bc, cd, db), in the same slots.
    """
    c, d = origin[_others(h1)[0]], origin[_others(g1)[0]]
    beyond_bc, beyond_ad = twin[h1], twin[g1]
    origin[h1], origin[g1] = d, c
    twin[h1], twin[g1] = g1, h1
    twin[h], twin[g] = beyond_ad, beyond_bc
    if beyond_ad >= 0:
        twin[beyond_ad] = h
    if beyond_bc >= 0:
        twin[beyond_bc] = g
