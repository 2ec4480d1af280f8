"""Families of integer polygons: valid, of the size asked for, the same on every machine."""

from __future__ import annotations

import hashlib
from collections.abc import Callable

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.corpus.shapes import SIZE, Ring, maze, on_circle, plate, spiral, star
from bern_exact.exact.points import grid_point
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems.theorem_1 import theorem_1

Family = Callable[[int, int], list[Ring]]

FAMILIES: dict[str, Family] = {"star": star, "maze": maze, "spiral": spiral, "plate": plate}

every_family = pytest.mark.parametrize("name", FAMILIES)
sizes = pytest.mark.parametrize("n", [8, 13, 50, 333])


def polygon(name: str, n: int, seed: int) -> Polygon:
    """A member of a family, validated."""
    rings = FAMILIES[name](n, seed)
    return polygon_from_rings([[grid_point(x, y) for x, y in ring] for ring in rings])


@every_family
@sizes
@pytest.mark.parametrize("seed", range(3))
def test_members_are_polygons_about_as_large_as_asked(name: str, n: int, seed: int) -> None:
    made = polygon(name, n, seed)
    assert n / 2 <= made.n <= 2 * n + 4


@every_family
def test_outer_rings_run_counter_clockwise(name: str) -> None:
    made = polygon(name, 40, 1)
    assert made.rings[0] == tuple(range(len(made.rings[0])))


@every_family
def test_a_member_is_a_function_of_size_and_seed(name: str) -> None:
    family = FAMILIES[name]
    assert family(40, 3) == family(40, 3)
    assert family(40, 3) != family(40, 4)


@every_family
def test_coordinates_are_whole_numbers(name: str) -> None:
    for ring in FAMILIES[name](40, 2):
        assert all(type(x) is int and type(y) is int for x, y in ring)


@every_family
def test_members_go_through_theorem_1(name: str) -> None:
    theorem_1(polygon(name, 30, 9))


def test_only_plates_have_holes() -> None:
    assert [polygon(name, 100, 0).holes for name in FAMILIES] == [0, 0, 0, 25]


@given(st.integers(3, 10**6), st.integers(1, 10**9), st.data())
def test_points_on_a_circle_are_within_rounding_of_it(
    n: int, radius: int, data: st.DataObject
) -> None:
    i = data.draw(st.integers(0, n - 1))
    x, y = on_circle(i, n, radius)
    assert (radius - 2) ** 2 - 4 <= x * x + y * y <= radius * radius or radius < 3


@pytest.mark.parametrize("n", [3, 4, 5, 7, 12, 100])
def test_points_on_a_circle_go_round_it_once(n: int) -> None:
    points = [on_circle(i, n, SIZE) for i in range(n)]
    turns = [points[i - 1][0] * y - points[i - 1][1] * x > 0 for i, (x, y) in enumerate(points)]
    assert all(turns) and len(set(points)) == n
    assert all(x * x + y * y > mpq(99, 100) * SIZE**2 for x, y in points)


def test_the_first_members_never_change() -> None:
    # A corpus is reproduced from its seed: another digest is another version of the generator.
    text = repr([FAMILIES[name](20, 7) for name in sorted(FAMILIES)])
    assert hashlib.sha256(text.encode()).hexdigest()[:16] == "fbc66b1e41086a49"
