"""The sweep over a mesh's own boundary says what comparing all of its sides says."""

from __future__ import annotations

from collections import Counter
from itertools import product
from random import Random

import pytest

from bern_exact.exact.points import HPoint, grid_point
from bern_exact.exact.predicates import orientation
from bern_exact.oracle.side_sweep import Side, enclose_once
from bern_exact.oracle.sides import _is_covered_once, conflicts

LATTICE = [grid_point(x, y) for x, y in product(range(4), range(4))]


def by_comparing(vertices: list[HPoint], sides: list[Side]) -> bool:
    directed = [(vertices[a], vertices[b], times) for a, b, times in sides]
    if any(times != 1 for _, _, times in sides) or overlapping(vertices, sides):
        return False
    return not conflicts(vertices, sides) and _is_covered_once(vertices, sides, directed)


def overlapping(vertices: list[HPoint], sides: list[Side]) -> bool:
    """Do two sides with both ends in common run along each other?"""
    return len({frozenset(side[:2]) for side in sides}) < len(sides)


def boundary_of(triangles: list[tuple[int, int, int]]) -> list[Side]:
    """The edges that are used more often than their reverses."""
    uses: Counter[tuple[int, int]] = Counter()
    for a, b, c in triangles:
        uses.update([(a, b), (b, c), (c, a)])
    return [(a, b, n - uses[b, a]) for (a, b), n in uses.items() if n > uses[b, a]]


def some_triangles(rng: Random, vertices: list[HPoint]) -> list[tuple[int, int, int]]:
    """A few small triangles, nearly all counter-clockwise."""
    triangles = []
    for _ in range(rng.randint(1, 6)):
        a = rng.randrange(len(vertices))
        near = [v for v in range(16) if abs(v // 4 - a // 4) <= 1 and abs(v % 4 - a % 4) <= 1]
        b, c = rng.sample([v for v in near if v != a], 2)
        turn = orientation(vertices[a], vertices[b], vertices[c])
        if turn:
            triangles.append((a, b, c) if (turn > 0) != (rng.random() < 0.03) else (a, c, b))
    return triangles


@pytest.mark.parametrize("seed", range(8))
def test_it_agrees_on_boundaries_of_random_triangles(seed: int) -> None:
    rng, seen = Random(seed), Counter[bool]()
    for _ in range(250):
        sides = boundary_of(some_triangles(rng, LATTICE))
        if sides:
            expected = by_comparing(LATTICE, sides)
            assert enclose_once(LATTICE, sides) is expected, sides
            seen[expected] += 1
    assert min(seen[True], seen[False]) > 20


def ring(*numbers: int) -> list[Side]:
    return [(a, b, 1) for a, b in zip(numbers, numbers[1:] + numbers[:1], strict=True)]


@pytest.mark.parametrize(
    "sides, expected",
    [
        (ring(0, 12, 15, 3), True),
        (ring(0, 3, 15, 12), False),  # clockwise
        (ring(0, 12, 15, 3) + ring(5, 6, 9), True),  # with a hole
        (ring(0, 12, 15, 3) + ring(5, 9, 6), False),  # covered twice in it
        (ring(0, 4, 5) + ring(5, 9, 10), True),  # touching in a vertex
        (ring(0, 12, 15, 3) + ring(0, 5, 4), False),  # a hole that runs along the outside
        (ring(0, 8, 9) + ring(4, 5, 1), False),  # a vertex inside a side
        (ring(0, 15, 3) + ring(12, 13, 2), False),  # crossing
        ([(0, 12, 2), (12, 15, 2), (15, 0, 2)], False),
    ],
)
def test_it_tells_regions_from_others(sides: list[Side], expected: bool) -> None:
    assert enclose_once(LATTICE, sides) is expected


@pytest.mark.parametrize("count", [40])
def test_many_rings_are_a_region(count: int) -> None:
    vertices = [
        grid_point(3 * (v % count) + dx, 3 * (v // count) + dy)
        for v in range(count * count)
        for dx, dy in ((0, 0), (1, 0), (0, 1))
    ]
    sides = [s for t in range(count * count) for s in ring(3 * t, 3 * t + 1, 3 * t + 2)]
    assert enclose_once(vertices, sides)
    a, b, _ = sides[7]
    assert not enclose_once(vertices, [*sides[:7], (b, a, 1), *sides[8:]])
