"""Lemma 6: a simple rectilinear polygon into matching subdivided rectangles, O(N log N) vertices.

The paper shrinks Q to unit cells and cuts off unit squares until all corners are even, then
doubles the unit.  Cutting so is pairing: of the columns, those next to each other across
lines of one parity are glued, what a column does not share with its partner is cut off, and
the same is done with the rows (`erosion`).  Strips know their true coordinates, so neither
the shrunken polygon nor its Riemann sheets are needed.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from bern_exact.interior.records import GridNode, Rectilinear
from bern_exact.interior.subdivided.erosion import Clipping, Piece, Run, Web, half_step
from bern_exact.interior.subdivided.lattice import (
    Lattice,
    Strips,
    is_hole,
    mirrored,
    strips_of,
    vertices_by_euler,
)
from bern_exact.interior.subdivided.records import Partition, SubdividedRectangle


class HasHoles(Exception):
    """A region that is to be halved has a hole."""


class Cut(NamedTuple):
    """A rectangle cut off by the halving.

    Parameters
    ----------
    step : int
        The half-step, from 1.
    box : (int, int, int, int)
        x0, x1, y0, y1.
    across, along : int
        Its cells in its two directions, `across` the direction that was being halved.
    """

    step: int
    box: tuple[int, int, int, int]
    across: int
    along: int


def halving(region: Rectilinear, *, squares: bool = False, as_printed: bool = False) -> Partition:
    """Partition a region without holes into matching subdivided rectangles.

    Lemma 6: "A simple n-vertex rectilinear polygon Q can be partitioned into a set of
    matching subdivided rectangles with a total of O(n log n) vertices."

    Parameters
    ----------
    region : Rectilinear
        Components without holes, satisfying the matching condition.
    squares : bool
        Cut off the paper's squares of cells rather than whole strips: more vertices.
    as_printed : bool
        The paper's own halving: squares, and the corners always to even lines, with which
        the boundary can grow.

    Returns
    -------
    Partition
        With at most 1.5 N log2 N - 0.5 N vertices.

    Raises
    ------
    HasHoles
        If a loop is clockwise.
    UnmatchedEdge
        If the matching condition fails.

    Notes
    -----
    O((N + V) log N) for V vertices of the partition; cells are never enumerated.
    """
    squares = squares or as_printed
    return subdivide(region, cuts(region, squares=squares, even=as_printed), squares=squares)


def count_halving(region: Rectilinear, *, squares: bool = False) -> int:
    """The vertices that `halving` would make, without making them.  O(N log^2 N).

    A vertex where the region touches itself counts once for each sector.
    """
    return count_vertices(region, cuts(region, squares=squares), squares=squares)


def cuts(region: Rectilinear, *, squares: bool = False, even: bool = False) -> Iterator[Cut]:
    """The rectangles that the halving cuts off, loop by loop, not yet subdivided.

    Parameters
    ----------
    region : Rectilinear
        Each loop bounds a component of its own; slits are allowed (`bridges`).
    squares : bool
        Do not end early where a piece is one rectangle.
    even : bool
        Corners always to even lines.
    """
    for loop in region.loops:
        yield from _cuts_of(_first_piece(loop, even), early=not squares)


def _cuts_of(piece: Piece, *, early: bool) -> Iterator[Cut]:
    """All half-steps on one component."""
    level, step = [piece], 0
    while level:
        step += 1
        following: list[Piece] = []
        for piece in level:
            if early and piece.is_rectangle():
                clippings = [piece.whole()]
            else:
                clippings, rest = half_step(piece)
                following += rest
            yield from (_cut(step, clipping, piece.mirrored) for clipping in clippings)
        level = following


def _cut(step: int, clipping: Clipping, is_mirrored: bool) -> Cut:
    near, far, low, high = clipping.strip
    box = (low, high, near, far) if is_mirrored else (near, far, low, high)
    return Cut(step, box, clipping.across, clipping.along)


def _first_piece(loop: Sequence[GridNode], even: bool) -> Piece:
    """A component as columns and rows, each one cell wide.

    Raises
    ------
    HasHoles
        If the loop is clockwise, the boundary of a hole.
    """
    if is_hole(loop):
        raise HasHoles(f"the loop at {loop[0]} bounds a hole")
    places = _developed(loop)
    (turned,), (turned_places,) = mirrored([loop]), mirrored([places])
    return Piece(_web(loop, places), _web(turned, turned_places), len(loop), False, even)


def _developed(loop: Sequence[GridNode]) -> list[GridNode]:
    """Where the vertices of a loop come to lie if every edge has length 1, the first at (0, 0)."""
    places = [(0, 0)]
    for (px, py), (x, y) in pairwise(loop):
        i, j = places[-1]
        places.append((i + (x > px) - (x < px), j + (y > py) - (y < py)))
    return places


def _web(loop: Sequence[GridNode], places: Sequence[GridNode]) -> Web:
    """The columns of a component and the chords between them."""
    strips, ends = strips_of([loop])
    runs = []
    for strip, (bottom, top) in zip(strips, ends, strict=True):
        i, start = places[bottom.head - 1]
        runs.append(Run(strip, i, start, places[top.head][1]))
    walls = _walls(loop)
    chords = [
        (a, b)
        for a, b in Strips(strips).chords()
        if (strips[b].near, max(strips[a].low, strips[b].low)) not in walls
    ]
    return Web(runs, chords, 1)


def _walls(loop: Sequence[GridNode]) -> set[GridNode]:
    """The lower ends of vertical boundary edges: where one begins, a chord is slit."""
    return {(x, min(y, loop[i - 1][1])) for i, (x, y) in enumerate(loop) if x == loop[i - 1][0]}


def subdivide(region: Rectilinear, pieces: Iterator[Cut], *, squares: bool = False) -> Partition:
    """The partition into these rectangles, each with its vertices."""
    lattice = Lattice.of(region)
    found: list[tuple[SubdividedRectangle, int]] = []
    for cut in pieces:
        rectangle = lattice.subdivided(*cut.box)
        boxes = _squares(rectangle) if squares else [rectangle]
        found += [(box, cut.step) for box in boxes]
    found.sort()
    return Partition(region, tuple(r for r, _ in found), tuple(step for _, step in found))


def _squares(r: SubdividedRectangle) -> Iterator[SubdividedRectangle]:
    """A strip cut into squares of cells."""
    xs, ys = (r.x0, *r.bottom, r.x1), (r.y0, *r.left, r.y1)
    side = min(len(xs), len(ys)) - 1
    for i in range(0, len(xs) - 1, side):
        for j in range(0, len(ys) - 1, side):
            across, up = xs[i + 1 : i + side], ys[j + 1 : j + side]
            yield SubdividedRectangle(
                xs[i], xs[i + side], ys[j], ys[j + side], up, up, across, across
            )


def count_vertices(region: Rectilinear, pieces: Iterator[Cut], *, squares: bool = False) -> int:
    """The vertices of the partition into these rectangles."""
    faces = sides = 0
    for cut in pieces:
        if squares:
            side = min(cut.across, cut.along)
            number = cut.across * cut.along // (side * side)
            faces, sides = faces + number, sides + number * 4 * side
        else:
            faces, sides = faces + 1, sides + 2 * (cut.across + cut.along)
    return vertices_by_euler(region, faces, sides)
