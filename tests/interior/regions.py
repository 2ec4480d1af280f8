"""Rectilinear regions made of cells, by brute force: what the near-linear code is tested on."""

from __future__ import annotations

import random
from collections.abc import Sequence
from itertools import accumulate

from hypothesis import strategies as st

from bern_exact.interior.records import GridNode, Rectilinear
from bern_exact.interior.subdivided.records import Partition, SubdividedRectangle

Cells = frozenset[GridNode]
"""Cell (i, j) is [i, i + 1] x [j, j + 1]."""

STEPS = ((1, 0), (0, 1), (-1, 0), (0, -1))


def region_of(
    cells: Cells, xs: Sequence[int], ys: Sequence[int], *, every_line: bool = False
) -> Rectilinear:
    """The union of cells of the grid with these lines, with the vertices that matching needs.

    These are the corners and the other ends of the chords from corners; with `every_line` all
    grid points of the boundary.
    """
    loops = _loops(cells)
    if not every_line:
        needed = _vertices(cells)
        loops = [[p for p in loop if p in needed] for loop in loops]
    return Rectilinear(tuple(tuple((xs[i], ys[j]) for i, j in loop) for loop in loops))


def unit_region(cells: Cells, *, every_line: bool = False) -> Rectilinear:
    """The union of cells of the unit grid."""
    lines = range(2 + max((max(cell) for cell in cells), default=0))
    return region_of(cells, lines, lines, every_line=every_line)


def _quadrants(cells: Cells, p: GridNode) -> tuple[bool, bool, bool, bool]:
    """Which of the cells around a point are there, counter-clockwise from the north-east."""
    i, j = p
    return tuple((i + a, j + b) in cells for a, b in ((0, 0), (-1, 0), (-1, -1), (0, -1)))  # type: ignore[return-value]


def _is_corner(cells: Cells, p: GridNode) -> bool:
    around = _quadrants(cells, p)
    return sum(around) in (1, 3) or (sum(around) == 2 and around[0] == around[2])


def _vertices(cells: Cells) -> set[GridNode]:
    """Corners, and where the chords from them end."""
    points = {(i + a, j + b) for i, j in cells for a in (0, 1) for b in (0, 1)}
    corners = {p for p in points if _is_corner(cells, p)}
    return corners | {_end(cells, p, heading) for p in corners for heading in range(4)}


def _end(cells: Cells, p: GridNode, heading: int) -> GridNode:
    """Where the chord from p ends; p itself if no chord leaves it that way."""
    dx, dy = STEPS[heading]
    while True:
        around = _quadrants(cells, p)
        # The cells left and right of the next lattice edge.
        if not (around[heading] and around[heading - 1]):
            return p
        p = (p[0] + dx, p[1] + dy)
        if not all(_quadrants(cells, p)):
            return p


def _loops(cells: Cells) -> list[list[GridNode]]:
    """The boundary as unit edges, interior on the left, turning left where it touches itself."""
    out: dict[GridNode, set[int]] = {}
    for i, j in cells:
        for heading, (p, other) in enumerate(
            [
                ((i, j), (i, j - 1)),
                ((i + 1, j), (i + 1, j)),
                ((i + 1, j + 1), (i, j + 1)),
                ((i, j + 1), (i - 1, j)),
            ]
        ):
            if other not in cells:
                out.setdefault(p, set()).add(heading)
    used: set[tuple[GridNode, int]] = set()
    loops = []
    for start in sorted(out):
        for first in sorted(out[start]):
            loop, p, heading = [], start, first
            while (p, heading) not in used:
                used.add((p, heading))
                loop.append(p)
                p = (p[0] + STEPS[heading][0], p[1] + STEPS[heading][1])
                heading = next(h for t in (1, 0, 3) if (h := (heading + t) % 4) in out[p])
            if loop:
                loops.append(loop)
    return loops


def has_holes(cells: Cells) -> bool:
    """Is there something outside that cannot be reached, diagonal steps allowed?"""
    xs, ys = zip(*cells, strict=True)
    box = {
        (i, j) for i in range(min(xs) - 1, max(xs) + 2) for j in range(min(ys) - 1, max(ys) + 2)
    } - cells
    waiting = [(min(xs) - 1, min(ys) - 1)]
    seen = set(waiting)
    while waiting:
        i, j = waiting.pop()
        for near in ((i + a, j + b) for a in (-1, 0, 1) for b in (-1, 0, 1)):
            if near in box and near not in seen:
                seen.add(near)
                waiting.append(near)
    return len(seen) < len(box)


def grown(size: int, seed: int) -> Cells:
    """A random connected set of cells without holes and without touching corners."""
    rng = random.Random(seed)
    ring = ((1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1))
    cells = {(0, 0)}
    grown_from = [(0, 0)]
    while len(cells) < size:
        i, j = rng.choice(grown_from[-rng.choice((20, size)) :])
        dx, dy = rng.choice(STEPS)
        new = (i + dx, j + dy)
        around = [(new[0] + a, new[1] + b) in cells for a, b in ring]
        if new not in cells and sum(around[k] != around[k - 1] for k in range(8)) == 2:
            cells.add(new)
            grown_from.append(new)
    low = min(min(cell) for cell in cells)
    return frozenset((i - low, j - low) for i, j in cells)


def cells_of(rectangle: SubdividedRectangle) -> list[GridNode]:
    """The unit cells of a rectangle."""
    x0, x1, y0, y1 = rectangle[:4]
    return [(i, j) for i in range(x0, x1) for j in range(y0, y1)]


def surface_vertices(partition: Partition) -> int:
    """Distinct vertices, and one more for each second sector where the region touches itself."""
    points = {p for rectangle in partition.rectangles for p in rectangle.ring()}
    corners = [p for loop in partition.region.loops for p in loop]
    return len(points) + len(corners) - len(set(corners))


GRID_LINES = st.lists(st.integers(1, 9), min_size=8, max_size=8).map(
    lambda steps: list(accumulate(steps, initial=0))
)


@st.composite
def cell_sets(draw: st.DrawFn, *, holes: bool | None = None) -> Cells:
    """Any cells of a small grid: several components, touching vertices, holes if allowed."""
    width, height = draw(st.integers(1, 8)), draw(st.integers(1, 8))
    seed = draw(st.integers(0, 2**32))
    share = draw(st.sampled_from((40, 60, 80, 90, 97, 100)))
    rng = random.Random(seed)
    cells = {(i, j) for i in range(width) for j in range(height) if rng.randrange(100) < share} or {
        (0, 0)
    }
    if holes is False:
        _fill(cells)
    return frozenset(cells)


def _fill(cells: set[GridNode]) -> None:
    """Take whole rows off from above until no hole is left."""
    while has_holes(frozenset(cells)):
        top = max(j for _, j in cells)
        cells -= {cell for cell in cells if cell[1] == top}


@st.composite
def regions(draw: st.DrawFn, *, holes: bool | None = None) -> Rectilinear:
    """Regions on non-uniform grids."""
    cells, xs, ys = draw(cell_sets(holes=holes)), draw(GRID_LINES), draw(GRID_LINES)
    return region_of(cells, xs, ys, every_line=draw(st.booleans()))
