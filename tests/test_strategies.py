"""Strategies: everything drawn is valid and within the options, and shrinks to what is small."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Callable
from typing import Any, TypeVar

import pytest
from gmpy2 import mpq
from hypothesis import Phase, find, given, settings
from hypothesis import strategies as st
from hypothesis.errors import InvalidArgument

from bern_exact import Mesh, Polygon, verify
from bern_exact.exact.predicates import orientation
from bern_exact.oracle.arguments import mesh_of, polygon_of
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.strategies import (
    convex_polygons,
    polygons_with_holes,
    rectilinear_polygons,
    simple_polygons,
    triangulations,
)
from bern_exact.strategies.rings import untangled
from tests.theorems.families import is_valid
from tests.theorems.families import ring as exact_ring

T = TypeVar("T")
few = settings(max_examples=8, database=None)

POLYGONS: dict[str, Callable[..., st.SearchStrategy[Polygon]]] = {
    "simple": simple_polygons,
    "holes": polygons_with_holes,
    "convex": convex_polygons,
    "rectilinear": rectilinear_polygons,
}
every_kind = pytest.mark.parametrize("kind", POLYGONS)


def turns(polygon: Polygon) -> list[int]:
    """At each vertex 1 for convex, 0 for flat, -1 for reflex."""
    at, after, before = polygon.points, polygon.after, polygon.before
    return [orientation(at[before[v]], at[v], at[after[v]]) for v in range(polygon.n)]


def numbers(polygon: Polygon) -> list[mpq]:
    return [mpq(c, p[2]) for p in polygon.points for c in p[:2]]


def smallest(strategy: st.SearchStrategy[T], condition: Callable[[T], bool]) -> T:
    """What an example shrinks to.  All of Hypothesis' health checks are on."""
    phases = (Phase.generate, Phase.shrink)
    return find(
        strategy,
        condition,
        settings=settings(max_examples=150, database=None, phases=phases, derandomize=True),
    )


# Valid, and within the options -----------------------------------------------------------


@every_kind
def test_what_is_drawn_is_a_polygon(kind: str) -> None:
    @few
    @given(POLYGONS[kind]())
    def check(polygon: Polygon) -> None:
        rings = [list(polygon.input_ring(r)) for r in range(len(polygon.rings))]
        assert polygon_from_rings(rings) == polygon
        assert (polygon.holes > 0) == (kind == "holes")
        assert 3 <= len(polygon.rings[0]) <= 20

    check()


@every_kind
def test_options_hold(kind: str) -> None:
    options = st.fixed_dictionaries(
        {
            "min_vertices": st.integers(4, 9),
            "max_vertices": st.integers(10, 14),
            "max_value": st.integers(60, 10**4),
            "max_denominator": st.integers(1, 12),
            "allow_flat": st.booleans(),
        }
    )

    @settings(max_examples=10, database=None)
    @given(st.data(), options)
    def check(data: st.DataObject, options: dict[str, Any]) -> None:
        polygon = data.draw(POLYGONS[kind](**options))
        count = len(polygon.rings[0])
        assert options["min_vertices"] <= count <= options["max_vertices"]
        values = numbers(polygon)
        assert max(map(abs, values)) <= options["max_value"]
        assert max(x.denominator for x in values) <= options["max_denominator"]
        assert options["allow_flat"] or 0 not in turns(polygon)

    check()


@few
@given(st.data(), st.integers(0, 3), st.integers(3, 6))
def test_holes_are_as_many_and_as_large_as_asked(data: st.DataObject, k: int, most: int) -> None:
    polygon = data.draw(polygons_with_holes(min_holes=k, max_holes=k, max_hole_vertices=most))
    assert polygon.holes == k
    assert all(3 <= len(ring) <= most for ring in polygon.rings[1:])


@few
@given(convex_polygons(allow_flat=False), convex_polygons())
def test_convex_ones_are_convex(strict: Polygon, weak: Polygon) -> None:
    assert set(turns(strict)) == {1} and min(turns(weak)) >= 0


@few
@given(rectilinear_polygons())
def test_rectilinear_ones_are_rectilinear(polygon: Polygon) -> None:
    assert all(0 in line[:2] for line in polygon.lines)


@pytest.mark.parametrize("count", [3, 4, 5, 12])
def test_exactly_so_many_vertices(count: int) -> None:
    @settings(max_examples=8, database=None)
    @given(st.data())
    def check(data: st.DataObject) -> None:
        for strategy in (simple_polygons, convex_polygons, rectilinear_polygons):
            if strategy is not rectilinear_polygons or count in (4, 12):
                drawn = data.draw(strategy(min_vertices=count, max_vertices=count))
                assert drawn.n == count

    check()


@settings(max_examples=12, database=None)
@given(triangulations())
def test_triangulations_are_valid(pair: tuple[Polygon, Mesh]) -> None:
    polygon, mesh = pair
    assert verify(mesh, None, polygon).valid
    assert mesh.vertices[: polygon.n] == polygon.points


@pytest.mark.parametrize("theorem, angle", [(1, 180), (2, 150), (3, 150), (4, 90)])
def test_triangulations_by_a_theorem(theorem: int, angle: int) -> None:
    @settings(max_examples=2, database=None)
    @given(triangulations(theorem=theorem))
    def check(pair: tuple[Polygon, Mesh]) -> None:
        polygon, mesh = pair
        assert verify(mesh, None, polygon, max_angle=angle).valid

    check()


@few
@given(triangulations(polygons=convex_polygons(max_vertices=5), max_steps=2))
def test_triangulations_of_polygons_of_ones_own(pair: tuple[Polygon, Mesh]) -> None:
    polygon, mesh = pair
    assert min(turns(polygon)) >= 0
    assert len(mesh.vertices) <= polygon.n + 2


# They reach what is special -----------------------------------------------------------------


NEAR = mpq(1, 10**6)


def nearly_flat(polygon: Polygon) -> bool:
    """Is there a vertex that is not flat, but nearly?"""
    at = polygon.points
    for v, turn in enumerate(turns(polygon)):
        if turn != 0:
            p, q, r = (at[u] for u in (polygon.before[v], v, polygon.after[v]))
            (ax, ay), (bx, by) = (
                (mpq(s[0], s[2]) - mpq(t[0], t[2]), mpq(s[1], s[2]) - mpq(t[1], t[2]))
                for s, t in ((q, p), (r, q))
            )
            if (ax * by - ay * bx) ** 2 < NEAR * (ax * ax + ay * ay) * (bx * bx + by * by):
                return True
    return False


@pytest.mark.parametrize(
    "strategy, condition",
    [
        (simple_polygons(), lambda p: turns(p).count(-1) >= 4),
        (simple_polygons(), lambda p: 0 in turns(p)),
        (simple_polygons(), nearly_flat),
        (simple_polygons(), lambda p: max(x.denominator for x in numbers(p)) == 1000),
        (simple_polygons(), lambda p: p.rings[0][1] != 1),
        (convex_polygons(), nearly_flat),
        (rectilinear_polygons(), lambda p: turns(p).count(-1) >= 4),
        (polygons_with_holes(), lambda p: p.holes == 3),
        (polygons_with_holes(), lambda p: any(len(ring) > 3 for ring in p.rings[1:])),
    ],
)
def test_what_is_special_is_reached(
    strategy: st.SearchStrategy[Polygon], condition: Callable[[Polygon], bool]
) -> None:
    find(
        strategy,
        condition,
        settings=settings(
            max_examples=400, database=None, derandomize=True, phases=(Phase.generate,)
        ),
    )


# They shrink -------------------------------------------------------------------------------


def is_small(polygon: Polygon, bound: int) -> bool:
    return all(x.denominator == 1 and abs(x) <= bound for x in numbers(polygon))


@pytest.mark.parametrize("strategy", [simple_polygons(), convex_polygons()])
def test_the_smallest_polygon_is_a_triangle(strategy: st.SearchStrategy[Polygon]) -> None:
    polygon = smallest(strategy, lambda p: True)
    assert polygon.n == 3 and is_small(polygon, 1)


def test_the_smallest_rectilinear_polygon_is_the_unit_square() -> None:
    polygon = smallest(rectilinear_polygons(), lambda p: True)
    assert polygon.n == 4 and polygon.area == 1 and is_small(polygon, 1)
    corner = smallest(rectilinear_polygons(max_vertices=8), lambda p: -1 in turns(p))
    assert corner.n == 6 and is_small(corner, 2)


def test_the_smallest_with_a_reflex_vertex_has_four() -> None:
    polygon = smallest(simple_polygons(max_vertices=6), lambda p: -1 in turns(p))
    assert polygon.n == 4 and is_small(polygon, 3)


def test_the_smallest_with_a_flat_vertex_has_four() -> None:
    polygon = smallest(convex_polygons(max_vertices=5), lambda p: 0 in turns(p))
    assert polygon.n == 4 and is_small(polygon, 20)  # the last steps are not always found


def test_the_smallest_with_a_hole_has_triangles() -> None:
    polygon = smallest(polygons_with_holes(max_vertices=4, max_holes=1), lambda p: True)
    assert polygon.n == 6 and is_small(polygon, 12)


def test_the_smallest_that_is_not_integer_has_halves() -> None:
    polygon = smallest(simple_polygons(max_vertices=5), lambda p: not is_small(p, 10**9))
    assert polygon.n == 3 and max(x.denominator for x in numbers(polygon)) == 2


def test_the_smallest_triangulation_is_one_triangle() -> None:
    plain = triangulations(polygons=convex_polygons(max_vertices=4), max_steps=2)
    polygon, mesh = smallest(plain, lambda pair: True)
    assert polygon.n == 3 and is_small(polygon, 1) and len(mesh.triangles) == 1
    polygon, mesh = smallest(plain, lambda pair: len(pair[1].vertices) > pair[0].n)
    assert polygon.n == 3 and len(mesh.vertices) == 4


# Options are looked at when a strategy is asked for -----------------------------------------


@pytest.mark.parametrize(
    "options",
    [
        {"min_vertices": 2},
        {"min_vertices": 7, "max_vertices": 6},
        {"max_vertices": 4.0},
        {"max_vertices": True},
        {"max_value": 0},
        {"max_value": 5},
        {"max_value": "9"},
        {"max_denominator": 0},
        {"allow_flat": None},
    ],
    ids=str,
)
@every_kind
def test_options_that_are_refused(kind: str, options: dict[str, Any]) -> None:
    with pytest.raises(InvalidArgument, match=list(options)[0]):
        POLYGONS[kind](**options)


@pytest.mark.parametrize(
    "options",
    [
        {"min_holes": -1},
        {"min_holes": 3, "max_holes": 2},
        {"min_holes": 9, "max_holes": 9},
        {"max_hole_vertices": 2},
    ],
    ids=str,
)
def test_options_of_holes_that_are_refused(options: dict[str, Any]) -> None:
    with pytest.raises(InvalidArgument, match=list(options)[0]):
        polygons_with_holes(**options)


@pytest.mark.parametrize(
    "options", [{"polygons": []}, {"max_steps": -1}, {"theorem": 5}, {"theorem": "1"}], ids=str
)
def test_options_of_triangulations_that_are_refused(options: dict[str, Any]) -> None:
    with pytest.raises(InvalidArgument, match=list(options)[0]):
        triangulations(**options)


def test_rectilinear_polygons_have_an_even_number_of_corners() -> None:
    with pytest.raises(InvalidArgument, match="even"):
        rectilinear_polygons(min_vertices=7, max_vertices=7)


@pytest.mark.parametrize("strategy", [*POLYGONS.values(), triangulations])
def test_options_go_by_name(strategy: Callable[..., object]) -> None:
    with pytest.raises(TypeError):
        strategy(3)


# Untangling -----------------------------------------------------------------------------------


@given(
    st.lists(st.tuples(st.integers(0, 4), st.integers(0, 4)), min_size=3, max_size=12, unique=True)
)
@settings(max_examples=50, database=None)
def test_untangled_rings_are_simple_and_stay_as_they_are(points: list[tuple[int, int]]) -> None:
    (x, y), (u, v) = points[:2]
    if all((u - x) * (b - y) == (v - y) * (a - x) for a, b in points):
        return
    ring = untangled(points)
    assert set(ring) <= set(points)
    assert is_valid([exact_ring(ring)])
    assert untangled(ring) == ring


# A failure can be read and tried again ---------------------------------------------------------


def test_a_falsifying_example_is_text_that_gives_it_again() -> None:
    split = triangulations(polygons=convex_polygons(max_vertices=4), max_steps=2)

    @settings(
        max_examples=50, database=None, derandomize=True, phases=(Phase.generate, Phase.shrink)
    )
    @given(split)
    def check(pair: tuple[Polygon, Mesh]) -> None:
        seen.append(pair)
        assert len(pair[1].vertices) == pair[0].n

    seen: list[tuple[Polygon, Mesh]] = []
    with pytest.raises(AssertionError) as caught:
        check()
    shown = "".join(caught.value.__notes__)
    (text,) = re.findall(r"pair=(\(.*\)),", shown, re.DOTALL)
    assert "mpz" not in text
    assert eval(text, {"polygon_of": polygon_of, "mesh_of": mesh_of}) == seen[-1]


# Hypothesis knows the types -------------------------------------------------------------------


def test_types_are_registered() -> None:
    code = """
from hypothesis import given, settings, strategies as st
import sys
assert "bern_exact.strategies" not in sys.modules and "numpy" not in sys.modules
from bern_exact import Mesh, Polygon

def identity(p: Polygon) -> Polygon:
    return p

@settings(max_examples=5, database=None, deadline=None)
@given(st.builds(identity), st.from_type(Mesh))
def check(polygon: Polygon, mesh: Mesh) -> None:
    assert isinstance(polygon, Polygon) and isinstance(mesh, Mesh)

check()
"""
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize("kind", POLYGONS)
def test_health(kind: str) -> None:
    """With default settings, all health checks on, few draws are rejected."""
    tried = kept = 0

    @settings(max_examples=25, database=None, derandomize=True, phases=(Phase.generate,))
    @given(st.data())
    def check(data: st.DataObject) -> None:
        nonlocal tried, kept
        tried += 1
        data.draw(POLYGONS[kind]())
        kept += 1

    check()
    assert 4 * kept >= 3 * tried
