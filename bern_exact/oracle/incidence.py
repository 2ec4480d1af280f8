"""Vertices and edges of a mesh in arrays, by sorting: the loops of `fast.py` for large meshes."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from bern_exact.exact.points import HPoint
from bern_exact.oracle.estimates import Frame
from bern_exact.oracle.fast import name_bad_corners, name_bad_vertex
from bern_exact.oracle.filters import Signs
from bern_exact.oracle.lazy_points import LazyPoints
from bern_exact.oracle.side_sweep import Side
from bern_exact.oracle.verdict import Findings
from bern_exact.plane.array_mesh import ArrayMesh, Flags, Indices


def note(items: Iterable[int], found: Findings, name: Callable[[int], None]) -> None:
    """Name what is wrong with each item, until no more is listed."""
    for item in items:
        name(item)
        if found.full:
            return


def sound_triangles(mesh: ArrayMesh, found: Findings) -> tuple[Indices, Flags]:
    """The numbers of the triangles whose corners are three vertices; which vertices are used."""
    size, triangles = len(mesh.points), mesh.triangles
    there = (triangles >= 0) & (triangles < size)
    a, b, c = triangles.T
    sound = there.all(axis=1) & (a != b) & (b != c) & (c != a)

    def name(t: int) -> None:
        name_bad_corners(t, triangles[t].tolist(), size, found)

    note(np.flatnonzero(~sound).tolist(), found, name)
    used = np.zeros(size, dtype=np.bool_)
    used[triangles[there]] = True
    return np.flatnonzero(sound), used


def first_at_its_point(frame: Frame, vertices: LazyPoints) -> Indices:
    """For each vertex the first one at the same point.

    Equal points have equal doubles; the converse is true if these are told apart.
    """
    first = np.arange(len(vertices))
    order = np.lexsort(frame.doubles[::-1])
    x, y = frame.doubles[:, order]
    starts = np.flatnonzero(np.concatenate(([True], (x[1:] != x[:-1]) | (y[1:] != y[:-1]))))
    ends = np.append(starts[1:], len(order))
    several = np.flatnonzero(ends - starts > 1)
    for start, end in zip(starts[several].tolist(), ends[several].tolist(), strict=True):
        group = order[start:end]  # ascending, since the sort is stable
        if frame.told_apart:
            first[group] = group[0]
            continue
        seen: dict[HPoint, int] = {}
        for v in group.tolist():
            first[v] = seen.setdefault(vertices[v], v)
    return first


def look_at_vertices(vertices: LazyPoints, first: Indices, used: Flags, found: Findings) -> None:
    """Name the vertices that are not the first at their point, and those that nothing uses."""

    def name(v: int) -> None:
        name_bad_vertex(v, vertices[v], int(first[v]), bool(used[v]), found)

    note(np.flatnonzero((first != np.arange(len(first))) | ~used).tolist(), found, name)


def look_at_edges(corners: Indices, numbers: Indices, signs: Signs, found: Findings) -> list[Side]:
    """The directed edges that are used more often than their reverses.

    Parameters
    ----------
    corners : array of int64, (T, 3)
        Of the sound triangles, vertices at one point replaced by the first there.
    numbers : array of int64, (T,)
        The numbers of these triangles in the mesh.
    signs : array of int8, (T,)
        Their orientations; the clockwise ones are counted as turned over.
    found : Findings
        Takes the defects.
    """

    def name_orientation(i: int) -> None:
        kind = "clockwise-triangle" if signs[i] < 0 else "degenerate-triangle"
        found.add(kind, {"triangle": int(numbers[i])}, {})

    note(np.flatnonzero(signs <= 0).tolist(), found, name_orientation)
    clockwise = signs < 0
    if clockwise.any():
        corners = np.where(clockwise[:, None], corners[:, [0, 2, 1]], corners)
    runs = _runs_of_edges(corners)

    def name_edge(i: int) -> None:
        edge = [int(runs.tails[i]), int(runs.heads[i])]
        triangles = numbers[runs.uses(i) // 3].tolist()
        found.add("edge-used-twice", {"edge": edge}, {"triangles": triangles})

    note(runs.in_order(runs.counts > 1).tolist(), found, name_edge)
    open_runs = runs.in_order((runs.surplus > 0) & (runs.tails != runs.heads))
    sides = (runs.tails[open_runs], runs.heads[open_runs], runs.surplus[open_runs])
    return list(zip(*(column.tolist() for column in sides), strict=True))


@dataclass(frozen=True, eq=False)
class _Runs:
    """The directed edges, each once; edge k of triangle t is use 3 t + k.

    Parameters
    ----------
    order : array of int64
        The uses sorted by edge.
    starts, counts : array of int64
        The uses of each edge in `order`.
    tails, heads : array of int64
        The vertices of each edge.
    surplus : array of int64
        How much more often it is used than its reverse.
    """

    order: Indices
    starts: Indices
    counts: Indices
    tails: Indices
    heads: Indices
    surplus: Indices

    def uses(self, run: int) -> Indices:
        """The uses of an edge, ascending."""
        start = int(self.starts[run])
        uses: Indices = self.order[start : start + int(self.counts[run])]
        return uses

    def in_order(self, chosen: Flags) -> Indices:
        """The chosen edges, by their first uses."""
        some = np.flatnonzero(chosen)
        picked: Indices = some[np.argsort(self.order[self.starts[some]])]
        return picked


def _runs_of_edges(corners: Indices) -> _Runs:
    """Sort the directed edges of triangles, an edge next to its reverse.

    An edge is packed with its smaller vertex first, and one bit for its direction: with fewer
    than 2^31 vertices that is less than 2^63.
    """
    tails, heads = corners.ravel(), corners[:, [1, 2, 0]].ravel()
    size = int(corners.max(initial=0)) + 1
    codes = np.minimum(tails, heads) * (2 * size)
    codes += 2 * np.maximum(tails, heads) + (tails > heads)
    order = np.argsort(codes, kind="stable")
    codes = codes[order]
    starts = np.flatnonzero(np.concatenate((codes[:1] >= 0, codes[1:] != codes[:-1])))
    counts = np.diff(np.append(starts, len(codes)))
    keys = codes[starts] >> 1
    surplus = counts.copy()
    pairs = np.flatnonzero(keys[1:] == keys[:-1])
    surplus[pairs] -= counts[pairs + 1]
    surplus[pairs + 1] -= counts[pairs]
    uses = order[starts]
    return _Runs(order, starts, counts, tails[uses], heads[uses], surplus)
