"""All small regions of unit squares without holes: cases for Lemma 6."""

from __future__ import annotations

from collections.abc import Iterator

from bern_exact.interior.records import GridNode, Rectilinear

Cells = frozenset[tuple[int, int]]

TURNS = {(1, 0): (0, 1), (0, 1): (-1, 0), (-1, 0): (0, -1), (0, -1): (1, 0)}
"""Each direction, and what is left of it."""


def polyominoes(size: int) -> Iterator[Cells]:
    """All edge-connected sets of so many unit squares, up to translation."""
    level: set[Cells] = {frozenset({(0, 0)})}
    for _ in range(size - 1):
        level = {_normal(cells | {cell}) for cells in level for cell in _beside(cells)}
    yield from sorted(level, key=sorted)


def _beside(cells: Cells) -> Iterator[tuple[int, int]]:
    for x, y in cells:
        for dx, dy in TURNS:
            if (x + dx, y + dy) not in cells:
                yield x + dx, y + dy


def _normal(cells: Cells) -> Cells:
    left, bottom = min(x for x, _ in cells), min(y for _, y in cells)
    return frozenset((x - left, y - bottom) for x, y in cells)


def outline(cells: Cells) -> Rectilinear | None:
    """The region, a vertex at every lattice point of its boundary; None if it has a hole.

    At a point where two squares touch the boundary turns left, so that they count as apart there.

    >>> outline(frozenset({(0, 0)})).edges
    4
    """
    ahead: dict[GridNode, list[tuple[int, int]]] = {}
    for x, y in cells:
        for start, step, outside in (
            ((x, y), (1, 0), (x, y - 1)),
            ((x + 1, y), (0, 1), (x + 1, y)),
            ((x + 1, y + 1), (-1, 0), (x, y + 1)),
            ((x, y + 1), (0, -1), (x - 1, y)),
        ):
            if outside not in cells:
                ahead.setdefault(start, []).append(step)
    edges = sum(len(steps) for steps in ahead.values())
    loop: list[GridNode] = []
    here, way = min(ahead), (1, 0)
    while True:
        ahead[here].remove(way)
        loop.append(here)
        here = here[0] + way[0], here[1] + way[1]
        left = TURNS[way]
        ways = [w for w in (left, way, TURNS[TURNS[left]]) if w in ahead[here]]
        if not ways:
            break
        way = ways[0]
    return Rectilinear((tuple(loop),)) if len(loop) == edges else None
