"""The first conflicts of sides are the same, however they are found."""

from __future__ import annotations

import random

from hypothesis import given
from hypothesis import strategies as st

from bern_exact import verify
from bern_exact.exact.points import grid_point
from bern_exact.oracle.conflicts import conflicts
from bern_exact.oracle.side_sweep import meet_in_ends_alone

MANY = 10**6
POINTS = [grid_point(x, y) for x in range(4) for y in range(4)]
NUMBERS = st.integers(0, len(POINTS) - 1)
SIDES = st.lists(st.tuples(NUMBERS, NUMBERS).filter(lambda ends: ends[0] != ends[1]), unique=True)


@given(SIDES, st.integers(0, 20))
def test_the_first_are_the_first_of_all(ends: list[tuple[int, int]], limit: int) -> None:
    sides = [(a, b, 1) for a, b in ends]
    every = conflicts(POINTS, sides, MANY)
    assert conflicts(POINTS, sides, limit, many=0) == every[:limit]
    assert conflicts(POINTS, sides, limit) == every[:limit]


@given(SIDES)
def test_without_conflicts_sides_meet_in_ends_alone(ends: list[tuple[int, int]]) -> None:
    sides = [(a, b, 1) for a, b in dict.fromkeys((min(e), max(e)) for e in ends)]
    assert meet_in_ends_alone(POINTS, sides) == (not conflicts(POINTS, sides, MANY))


def test_nested_triangles_overlap() -> None:
    vertices = [p for r in range(1, 2_001) for p in ((-r, -r), (r, -r), (0, r))]
    triangles = [(v, v + 1, v + 2) for v in range(0, 6_000, 3)]
    verdict = verify(vertices, triangles, limit=5)
    assert [defect.kind for defect in verdict.defects] == ["overlap"] * 5


def test_a_heap_of_triangles_is_judged_without_looking_at_every_pair() -> None:
    draw = random.Random(5)
    vertices = [(draw.randrange(10**6), draw.randrange(10**6)) for _ in range(9_000)]
    triangles = [(v, v + 1, v + 2) for v in range(0, 9_000, 3)]
    verdict = verify(vertices, triangles, limit=4_000)
    assert len(verdict.defects) == 4_000
    kinds = [defect.kind for defect in verdict.defects]
    assert kinds == sorted(kinds, reverse=True)  # clockwise triangles, then crossings


def test_nothing_is_looked_for_that_is_not_listed() -> None:
    square, cross = [(0, 0), (9, 0), (9, 9), (0, 9)], [(0, 1, 2), (0, 1, 3)]
    every = verify(square, cross, limit=100).defects
    for limit in range(len(every)):
        verdict = verify(square, cross, limit=limit)
        assert not verdict.valid
        assert verdict.defects == every[:limit]
