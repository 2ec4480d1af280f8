"""Section 3.2's alternative for holes: join them to the boundary by slits, then Lemma 6."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from heapq import heappop, heappush
from itertools import pairwise
from typing import NamedTuple

from bern_exact.interior.records import GridNode, Rectilinear
from bern_exact.interior.rectilinear import chained
from bern_exact.interior.subdivided.halving import count_vertices, cuts, subdivide
from bern_exact.interior.subdivided.lattice import Lattice, is_hole, mirrored
from bern_exact.interior.subdivided.records import Edge, Partition
from bern_exact.interior.subdivided.sweep_count import Sweep


def bridged(region: Rectilinear, *, squares: bool = False) -> Partition:
    """Partition a region with holes by Lemma 6, after slits have joined the holes to the boundary.

    "An alternative approach connects holes to the boundary to form a simple polygon and then
    applies Lemma 6."

    Parameters
    ----------
    region : Rectilinear
        Satisfying the matching condition.
    squares : bool
        As for `halving`.

    Returns
    -------
    Partition
        Of the region itself.  Lemma 6's bounds hold with the two sides of each slit
        counted in N.  Without holes it is the partition of `halving`.

    Notes
    -----
    O((N + V) log N) for V vertices of the partition.
    """
    edges = bridges(region)
    partition = subdivide(region, cuts(slit(region, edges), squares=squares), squares=squares)
    return Partition(region, partition.rectangles, partition.steps, edges)


def count_bridged(region: Rectilinear, *, squares: bool = False) -> int:
    """The vertices that `bridged` would make, without making them."""
    pieces = cuts(slit(region, bridges(region)), squares=squares)
    return count_vertices(region, pieces, squares=squares)


def slit(region: Rectilinear, edges: Sequence[Edge]) -> Rectilinear:
    """The region cut open along edges of its lattice: they become boundary on both sides."""
    if not edges:
        return region
    darts = {(loop[i - 1], node) for loop in region.loops for i, node in enumerate(loop)}
    for tail, head in edges:
        darts |= {(tail, head), (head, tail)}
    return chained(darts)


def bridges(region: Rectilinear) -> tuple[Edge, ...]:
    """Lattice edges along which the region has to be slit so that no hole is left.

    Each hole is joined by an L-shaped path: along the chord from its rightmost vertex, then
    along a vertical chord to its end.  That is a vertex further to the right, so its
    loop reaches further to the right, and the paths join every hole to an outer loop.  Where
    paths cross, the region falls apart into more components without holes.

    Returns
    -------
    tuple of Edge
        Sorted; the fewer of these and of those of the region mirrored in the diagonal.

    Notes
    -----
    Of the L-shaped paths from that vertex the one with the fewest lattice edges, found in
    O(log N) for each edge of it: a path that has gone as far as the best is given up.
    """
    if all(not is_hole(loop) for loop in region.loops):
        return ()
    upright = _edges(region)
    turned = _edges(Rectilinear(tuple(tuple(loop) for loop in mirrored(region.loops))))
    lying = {((ty, tx), (hy, hx)) for (tx, ty), (hx, hy) in turned}
    return tuple(sorted(upright if len(upright) <= len(lying) else lying))


class _Path(NamedTuple):
    """From a hole's rightmost vertex east to the line x, then up or down to y."""

    edges: int
    x: int
    y: int


class _Walk(NamedTuple):
    """A chord followed to the right, as far as the line x.

    Parameters
    ----------
    x : int
        The line.
    start : GridNode
        The hole's rightmost vertex.
    edges : int
        How many columns have been crossed.
    column : int
        The last one.
    """

    x: int
    start: GridNode
    edges: int
    column: int


def _edges(region: Rectilinear) -> set[Edge]:
    """The edges of all paths."""
    lattice = Lattice.of(region)
    return {
        edge
        for start, path in sorted(_paths(region, lattice).items())
        for edge in _edges_of(lattice, start, path)
    }


def _paths(region: Rectilinear, lattice: Lattice) -> dict[GridNode, _Path]:
    """The best path for each hole, all followed together from left to right."""
    columns, sweep = lattice.columns, Sweep(lattice.rows)
    best: dict[GridNode, _Path] = {}
    walks: list[_Walk] = []
    for loop in region.loops:
        if is_hole(loop):
            start = max(loop)
            column = columns.after(*start)
            heappush(walks, _Walk(columns.strips[column].far, start, 1, column))
    while walks:
        walk = heappop(walks)
        sweep.advance(walk.x)
        x, start, edges, _ = walk
        column = columns.after(x, start[1])
        for path in _ends(lattice, sweep, walk, column):
            if start not in best or path < best[start]:
                best[start] = path
        if start not in best or edges + 1 < best[start].edges:
            heappush(walks, _Walk(columns.strips[column].far, start, edges + 1, column))
    return best


def _ends(lattice: Lattice, sweep: Sweep, walk: _Walk, column: int) -> Iterator[_Path]:
    """The paths that leave the walk here: at the boundary itself, or up and down a chord."""
    y = walk.start[1]
    strips = lattice.columns.strips
    if column < 0 or strips[column].low == y:
        yield _Path(walk.edges, walk.x, y)
        return
    last, following = strips[walk.column], strips[column]
    low, high = max(last.low, following.low), min(last.high, following.high)
    yield _Path(walk.edges + sweep.count(low, y), walk.x, low)
    yield _Path(walk.edges + sweep.count(y, high), walk.x, high)


def _edges_of(lattice: Lattice, start: GridNode, path: _Path) -> Iterator[Edge]:
    """The lattice edges of a path, each from its lower or left end."""
    x, y = start
    across = [x, *lattice.columns.crossed(y, x, path.x), path.x]
    yield from (((a, y), (b, y)) for a, b in pairwise(across))
    if path.y != y:
        low, high = sorted((y, path.y))
        up = [low, *lattice.rows.crossed(path.x, low, high), high]
        yield from (((path.x, a), (path.x, b)) for a, b in pairwise(up))
