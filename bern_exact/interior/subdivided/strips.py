"""Lemma 8: a rectilinear polygon with holes into matching subdivided rectangles, O(N^1.5) vertices.

The paper cuts along every t-th vertical grid line, then along horizontals from the vertices that
remain inside.  Cut so, a guide line can meet the boundary between vertices and put new ones
there, which nothing outside Q knows of.  Here each guide line is *snapped*: instead of it, the
chords at the left sides of the columns that it passes through are cut.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from gmpy2 import isqrt, mpz

from bern_exact.interior.records import GridNode, Rectilinear
from bern_exact.interior.subdivided.lattice import Lattice, Strips, vertices_by_euler
from bern_exact.interior.subdivided.records import Partition
from bern_exact.interior.subdivided.sweep_count import Sweep


class Reflex(NamedTuple):
    """A 270-degree vertex and the chords that leave it.

    Parameters
    ----------
    x, y : int
        The vertex.
    up, east : bool
        Whether its vertical chord goes up, its horizontal one east.
    """

    x: int
    y: int
    up: bool
    east: bool


class Box(NamedTuple):
    """A rectangle of the partition, not yet subdivided.

    Parameters
    ----------
    x0, x1, y0, y1 : int
        [x0, x1] x [y0, y1].
    columns : int
        How many columns it crosses.
    """

    x0: int
    x1: int
    y0: int
    y1: int
    columns: int


def strips(region: Rectilinear, spacing: int | None = None) -> Partition:
    """Partition any region into matching subdivided rectangles.

    Lemma 8: "An n-vertex rectilinear polygon Q with holes can be partitioned into a set of
    matching subdivided rectangles with a total of O(n^{3/2}) vertices."

    Parameters
    ----------
    region : Rectilinear
        Satisfying the matching condition.
    spacing : int, optional
        t, at least 1: how many distinct abscissas apart guide lines are; `default_spacing` if
        not given.

    Returns
    -------
    Partition
        With at most N + ceil(|D|/t) Hc + R (t - 1) vertices, for |D| abscissas, Hc
        horizontal chords and R reflex vertices; 2 N + N^1.5 with the default.

    Notes
    -----
    - A reflex vertex whose own vertical chord is not cut sends a horizontal cut along the
      other, as far as a cut chord or the boundary.  180-degree vertices need no cut.
    - O((N + V) log N) for V vertices of the partition.
    """
    lattice = Lattice.of(region)
    boxes = _boxes(region, lattice, spacing)
    rectangles = sorted(lattice.subdivided(*box[:4]) for box in boxes)
    return Partition(region, tuple(rectangles), (0,) * len(rectangles))


def count_strips(region: Rectilinear, spacing: int | None = None) -> int:
    """The vertices that `strips` would make, without making them.

    A vertex where the region touches itself counts once for each sector.

    Notes
    -----
    O((N + R t) log N).
    """
    lattice = Lattice.of(region)
    boxes = list(_boxes(region, lattice, spacing))
    sides = 2 * sum(box.columns for box in boxes) + 2 * _rows_crossed(lattice.rows, boxes)
    return vertices_by_euler(region, len(boxes), sides)


def default_spacing(region: Rectilinear) -> int:
    """sqrt(|D| Hc / R), rounded, at least 1: where the bound on the vertices is least.

    Without reflex vertices every component is a rectangle: |D|, no guide line at all.
    """
    reflex = sum(1 for _ in _reflex_vertices(region))
    abscissas = len(_abscissas(region))
    if not reflex:
        return max(1, abscissas)
    chords = len(Lattice.of(region).rows.chords())
    return max(1, (int(isqrt(mpz(4 * abscissas * chords // reflex))) + 1) // 2)


def _abscissas(region: Rectilinear) -> list[int]:
    """D, sorted."""
    return sorted({x for loop in region.loops for x, _ in loop})


def _reflex_vertices(region: Rectilinear) -> Iterator[Reflex]:
    """The vertices where a loop turns right; both edges go on straight as chords."""
    for loop in region.loops:
        for i, (x, y) in enumerate(loop):
            (px, py), (qx, qy) = loop[i - 1], loop[i + 1 - len(loop)]
            if (x - px) * (qy - y) - (y - py) * (qx - x) < 0:
                # Straight on from the edge that arrives, straight back from the one that leaves.
                yield Reflex(x, y, up=y > py or y > qy, east=x > px or x > qx)


def _boxes(region: Rectilinear, lattice: Lattice, spacing: int | None) -> Iterator[Box]:
    """The rectangles."""
    columns = lattice.columns
    cut = _cut_columns(region, columns, default_spacing(region) if spacing is None else spacing)
    drawn: list[set[int]] = [set() for _ in columns.strips]
    for vertex in _reflex_vertices(region):
        below = columns.after(vertex.x, vertex.y if vertex.up else vertex.y - 1)
        if not cut[below]:
            _draw(columns, vertex, cut, drawn)
    return _merged(columns, cut, drawn)


def _cut_columns(region: Rectilinear, columns: Strips, spacing: int) -> list[bool]:
    """For each column whether a guide line passes: x0 <= line < x1."""
    abscissas = _abscissas(region)
    cut = []
    for strip in columns.strips:
        first, beyond = (bisect_left(abscissas, x) for x in (strip.near, strip.far))
        # The next multiple of the spacing, 0 excluded.
        guide = max(1, -(-first // spacing)) * spacing
        cut.append(guide < beyond)
    return cut


def _draw(columns: Strips, vertex: Reflex, cut: Sequence[bool], drawn: Sequence[set[int]]) -> None:
    """A horizontal cut from a reflex vertex to a cut chord, the boundary or a cut drawn before."""
    y = vertex.y
    find = columns.after if vertex.east else columns.before
    column = find(vertex.x, y)
    while column >= 0 and columns.strips[column].low < y and y not in drawn[column]:
        drawn[column].add(y)
        if vertex.east:
            column = columns.after(columns.strips[column].far, y)
            if cut[column]:
                return
        elif cut[column]:
            return
        else:
            column = columns.before(columns.strips[column].near, y)


def _merged(columns: Strips, cut: Sequence[bool], drawn: Sequence[set[int]]) -> Iterator[Box]:
    """The columns between the cuts across them, joined to the same between the columns before."""
    open_boxes: dict[GridNode, Box] = {}
    order = sorted(range(len(columns.strips)), key=lambda c: columns.strips[c])
    for c in order:
        strip = columns.strips[c]
        ends = [strip.low, *sorted(drawn[c]), strip.high]
        for low, high in zip(ends, ends[1:], strict=False):
            box = Box(strip.near, strip.far, low, high, 1)
            before = None if cut[c] else open_boxes.get((strip.near, low))
            if before is not None and before.y1 == high:
                del open_boxes[(strip.near, low)]
                box = Box(before.x0, strip.far, low, high, before.columns + 1)
            open_boxes[(strip.far, low)] = box
    return iter(open_boxes.values())


def _rows_crossed(rows: Strips, boxes: Sequence[Box]) -> int:
    """How many rows all left sides cross in sum: one sweep, from left to right."""
    sweep = Sweep(rows)
    total = 0
    for box in sorted(boxes):
        sweep.advance(box.x0)
        total += sweep.count(box.y0, box.y1)
    return total
