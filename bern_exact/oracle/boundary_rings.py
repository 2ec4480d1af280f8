"""The boundary of a mesh as rings of vertices, from its triangles' indices alone."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from bern_exact.plane.array_mesh import Indices

Edge = tuple[int, int]

LARGEST = 2**31
"""Of so many vertices, an edge still fits into 64 bits."""


def boundary_rings(triangles: Indices, size: int) -> list[list[int]] | None:
    """The rings that the sides of a mesh, its edges without a reverse, form; or None.

    Where several rings touch in a vertex, each is followed along its own triangles.

    Parameters
    ----------
    triangles : array of int64, (T, 3)
        Vertex numbers.
    size : int
        The number of vertices.

    Returns
    -------
    list of list of int, or None
        Each ring with its triangles on the left, from its least vertex on, in the order of these.
        None if an index is out of range or repeated, or a directed edge is used twice: then there
        is no such boundary.

    Notes
    -----
    O(m log m) for m triangles: a sort.

    Examples
    --------
    >>> boundary_rings(np.array([(0, 1, 2), (0, 2, 3)]), 4)
    [[0, 1, 2, 3]]
    >>> boundary_rings(np.array([(0, 1, 2), (0, 3, 4)]), 5)
    [[0, 1, 2], [0, 3, 4]]
    """
    if triangles.dtype == object or size >= LARGEST:
        return None
    a, b, c = triangles.T
    if ((triangles < 0) | (triangles >= size)).any():
        return None
    tails, heads = np.concatenate([a, b, c]), np.concatenate([b, c, a])
    edges = np.sort(tails * size + heads)
    if (edges[1:] == edges[:-1]).any() or (tails == heads).any():
        return None
    alone = edges[~np.isin(edges, heads * size + tails, assume_unique=True)]
    sides = list(zip((alone // size).tolist(), (alone % size).tolist(), strict=True))
    return list(_rings(sides, triangles))


def _rings(sides: list[Edge], triangles: Indices) -> Iterator[list[int]]:
    """Follow the sides, sorted, until each is in a ring."""
    ahead = dict(sides)
    pinched = len(ahead) < len(sides)
    third = _third_corners(sides, triangles) if pinched else {}
    left = set(sides)
    for start in sides:
        ring, side = list[int](), start
        while side in left:
            left.discard(side)
            ring.append(side[0])
            behind, at = side
            side = at, _turn(behind, at, third) if at in third else ahead[at]
        if ring:
            yield ring


Fan = dict[int, dict[int, int]]
"""Vertex v -> vertex u -> the third corner of the triangle to the left of uv."""


def _third_corners(sides: list[Edge], triangles: Indices) -> Fan:
    """The triangles round the vertices that several sides leave."""
    tails = np.array([tail for tail, _ in sides])
    values, counts = np.unique(tails, return_counts=True)
    shared = values[counts > 1]
    third: Fan = {int(v): {} for v in shared}
    for corners in triangles[np.isin(triangles, shared).any(axis=1)].tolist():
        for u, v, w in (corners, corners[1:] + corners[:1], corners[2:] + corners[:2]):
            if v in third:
                third[v][u] = w
    return third


def _turn(behind: int, at: int, third: Fan) -> int:
    """The vertex after the side from `behind` to `at`: across all triangles between."""
    while behind in third[at]:
        behind = third[at][behind]
    return behind
