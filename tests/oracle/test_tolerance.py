"""Boundary vertices off their edges: how far exactly, and what a tolerance accepts."""

from __future__ import annotations

import json
from importlib import resources
from typing import Any

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st
from jsonschema import Draft202012Validator

from bern_exact.exact.errors import InputError
from bern_exact.exact.points import hpoint
from bern_exact.exact.predicates import squared_distance
from bern_exact.oracle.api import verify
from bern_exact.oracle.departures import Near, ulp
from bern_exact.oracle.verdict import Verdict

SCHEMA = json.loads((resources.files("bern_exact") / "schemas/verdict.schema.json").read_text())
SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
FAN = [(4, 0, 1), (4, 1, 2), (4, 2, 3), (4, 3, 0)]
EPSILON = mpq(1, 10**16)


def judged(x: Any = 2, y: Any = 0, *, ring: Any = SQUARE, **options: Any) -> Verdict:
    """A square of four triangles round its middle, the lower one split by a vertex at (x, y)."""
    vertices = [*SQUARE, (2, 2), (x, y)]
    triangles = [(4, 0, 5), (4, 5, 1), *FAN[1:]]
    verdict = verify(vertices, triangles, ring, **options)
    Draft202012Validator(SCHEMA).validate(verdict.to_json())
    return verdict


@pytest.mark.parametrize("sign", [1, -1], ids=["inside", "outside"])
def test_a_vertex_off_its_edge_is_a_defect_that_says_how_far(sign: int) -> None:
    verdict = judged(y=sign * EPSILON)
    assert not verdict and not verdict.valid and verdict.within_tolerance is None
    defect = next(d for d in verdict.defects if d.kind == "boundary-vertex-off-edge")
    assert defect.where == {"vertex": 5}
    assert defect.witness["polygon_edge"] == [0, 0]
    assert mpq(defect.witness["distance_squared"]) == EPSILON**2
    assert defect.witness["distance"] == ["1e-16", "1e-16"]
    # The vertex is at x = 2, so that its last place is 2^-51.
    low, high = (mpq(text) for text in map(as_fraction, defect.witness["ulps"]))
    assert low <= EPSILON * 2**51 <= high


def as_fraction(decimal: str) -> str:
    whole, _, part = decimal.partition(".")
    return f"{whole}{part}/{10 ** len(part)}"


def test_the_furthest_is_summed_up() -> None:
    off_edge = judged(y=-EPSILON).off_edge
    assert off_edge is not None
    assert off_edge["vertices"] == 1 and off_edge["vertex"] == 5
    assert off_edge["polygon_edge"] == [0, 0]
    assert judged().off_edge is None


@pytest.mark.parametrize("sign", [1, -1], ids=["inside", "outside"])
def test_a_tolerance_accepts_that_distance_and_no_more(sign: int) -> None:
    accepted = judged(y=sign * EPSILON, tolerance=EPSILON)
    assert accepted and not accepted.valid and accepted.within_tolerance is True
    assert [d.kind for d in accepted.defects] == ["boundary-vertex-off-edge"]
    assert accepted.state == "valid within 1e-16"
    refused = judged(y=sign * EPSILON, tolerance=EPSILON * (1 - EPSILON))
    assert not refused and refused.within_tolerance is False
    assert refused.state.startswith("not valid, not even within")


def test_an_exactly_valid_mesh_is_valid_within_any_tolerance() -> None:
    for tolerance in (0, EPSILON, "0.5"):
        verdict = judged(tolerance=tolerance)
        assert verdict.valid and verdict.within_tolerance is True and not verdict.defects


def test_a_float_is_the_decimal_that_it_prints_as() -> None:
    assert judged(y=EPSILON, tolerance=1e-16)
    assert not judged(y=EPSILON, tolerance=0.99e-16)


def test_the_edge_of_a_clockwise_ring_is_named_as_in_the_input() -> None:
    off_edge = judged(y=EPSILON, ring=SQUARE[::-1]).off_edge
    assert off_edge is not None and off_edge["polygon_edge"] == [0, 2]


@pytest.mark.parametrize(
    "options",
    [
        {"max_angle": 90},
        {"min_height_squared": 3},
        {"max_triangles": 4},
    ],
    ids=lambda options: next(iter(options)),
)
def test_every_other_test_stays_exact(options: dict[str, Any]) -> None:
    assert judged(y=EPSILON, tolerance=EPSILON)
    verdict = judged(y=EPSILON, tolerance=EPSILON, **options)
    assert verdict.within_tolerance is False
    assert len({defect.kind for defect in verdict.defects}) == 2


def test_a_boundary_that_crosses_itself_is_not_accepted() -> None:
    # Vertices 5 and 6 of the lower edge change places.
    vertices = [*SQUARE, (2, 2), (3, EPSILON), (1, 0)]
    triangles = [(4, 0, 5), (4, 5, 6), (4, 6, 1), *FAN[1:]]
    verdict = verify(vertices, triangles, SQUARE, tolerance=10)
    assert verdict.within_tolerance is False
    assert "clockwise-triangle" in {defect.kind for defect in verdict.defects}


def test_a_vertex_drawn_across_another_edge_is_not_accepted() -> None:
    # A slit from above: the vertex on its left wall, moved beyond its right wall.
    ring = [(0, 0), (4, 0), (4, 4), ("21/10", 4), (2, 1), ("19/10", 4), (0, 4)]
    vertices = [*ring, ("9/4", 3)]
    triangles = [(0, 4, 7), (0, 7, 5), (0, 5, 6), (0, 1, 4), (1, 3, 4), (1, 2, 3)]
    vertices[7] = ("39/20", "5/2")
    assert verify(vertices, triangles, ring)
    vertices[7] = ("9/4", 3)
    verdict = verify(vertices, triangles, ring, tolerance=1)
    assert verdict.within_tolerance is False
    assert "boundary-not-simple" in {defect.kind for defect in verdict.defects}


def test_a_polygon_vertex_may_be_rounded_too() -> None:
    ring = [*SQUARE[:1], (2, -EPSILON), *SQUARE[1:]]
    verdict = judged(ring=ring)
    missing = next(d for d in verdict.defects if d.kind == "polygon-vertex-missing")
    assert missing.where == {"polygon_vertex": [0, 1]} and missing.witness["nearest"] == 5
    assert mpq(missing.witness["distance_squared"]) == EPSILON**2
    assert verdict.off_edge is not None and verdict.off_edge["polygon_vertex"] == [0, 1]
    accepted = judged(ring=ring, tolerance=EPSILON)
    assert accepted.within_tolerance is True
    assert [d.kind for d in accepted.defects] == ["polygon-vertex-missing"]
    assert not judged(ring=ring, tolerance=EPSILON / 2)


def test_a_missing_polygon_vertex_is_not_accepted() -> None:
    ring = [*SQUARE[:1], (2, -1), *SQUARE[1:]]
    verdict = verify(SQUARE, [(0, 1, 2), (0, 2, 3)], ring, tolerance=10)
    assert verdict.within_tolerance is False and verdict.off_edge is None
    assert {"polygon-vertex-missing"} <= {defect.kind for defect in verdict.defects}


def test_vertices_in_another_order_are_not_accepted() -> None:
    ring = [(0, 0), (2, 0), (2 - 2 * EPSILON, -EPSILON), (4, -4), (4, 4), (0, 4)]
    verdict = verify(ring, [(0, 1, 5)], [*ring[:1], ring[2], ring[1], *ring[3:]], tolerance=1)
    assert verdict.within_tolerance is False


@given(
    st.lists(st.tuples(st.integers(-20, 20), st.integers(-20, 20)), min_size=1, unique=True),
    st.tuples(st.fractions(-30, 30), st.fractions(-30, 30)),
)
def test_the_nearest_vertex_is_nearest(pairs: list[tuple[int, int]], place: Any) -> None:
    points = {v: hpoint(x, y) for v, (x, y) in enumerate(pairs)}
    p = hpoint(*(mpq(c.numerator, c.denominator) for c in place))
    best = min((squared_distance(p, q), v) for v, q in points.items())
    assert Near(points).vertex(p) == best[1]


def test_a_missing_triangle_is_not_accepted() -> None:
    vertices = [*SQUARE, (2, 2), (2, EPSILON)]
    verdict = verify(vertices, [(4, 0, 5), (4, 5, 1), *FAN[1:3]], SQUARE, tolerance=1)
    assert verdict.within_tolerance is False


def test_a_gap_inside_is_no_vertex_off_its_edge() -> None:
    inner = [(1, 1), (3, 1), (3, 3), (1, 3), (2, 2)]
    fan = [(4, 5, 8), (5, 6, 8), (6, 7, 8), (7, 4, 8)]
    frame = [(0, 1, 4), (1, 5, 4), (1, 2, 5), (2, 6, 5), (2, 3, 6), (3, 7, 6), (3, 0, 7), (0, 4, 7)]
    assert verify([*SQUARE, *inner], frame + fan, SQUARE)
    for tolerance in (None, 1):
        verdict = verify([*SQUARE, *inner], frame + fan[1:], SQUARE, tolerance=tolerance)
        assert not verdict and {defect.kind for defect in verdict.defects} == {"region-not-covered"}
    assert len(verify([*SQUARE, *inner], frame + fan[1:], SQUARE, limit=1).defects) == 1


def test_where_no_edge_is_known_the_nearest_is_told() -> None:
    verdict = verify([*SQUARE, (2, -1), (2, 2)], [(5, 0, 4), (5, 4, 1)], SQUARE)
    off = [d for d in verdict.defects if d.kind == "boundary-vertex-off-edge"]
    assert {d.where["vertex"]: d.witness["polygon_edge"] for d in off}[4] == [0, 0]


def test_holes_have_edges_too() -> None:
    hole = [(1, 1), (1, 3), (3, 3), (3, 1)]
    vertices = [*SQUARE, *hole, (1, 2 - EPSILON), (1 - EPSILON, 2)]
    around = [(0, 1, 7), (0, 7, 4), (1, 2, 6), (1, 6, 7), (2, 3, 5), (2, 5, 6)]
    left = [(0, 4, 9), (0, 9, 3), (3, 9, 5)]
    verdict = verify(vertices[:8] + vertices[9:], [*around, *fix(left)], [SQUARE, hole])
    assert verdict.off_edge is not None and verdict.off_edge["polygon_edge"] == [1, 0]


def fix(triangles: list[tuple[int, int, int]]) -> list[tuple[int, int, int]]:
    """The same with vertex 9 as 8."""
    return [(min(a, 8), min(b, 8), min(c, 8)) for a, b, c in triangles]


@pytest.mark.parametrize("tolerance", [-1, "-1e-9", "x", None.__class__])
def test_tolerances_that_are_refused(tolerance: Any) -> None:
    with pytest.raises(InputError):
        judged(tolerance=tolerance)


def test_a_tolerance_needs_a_polygon() -> None:
    with pytest.raises(InputError, match="polygon"):
        verify(SQUARE, [(0, 1, 2), (0, 2, 3)], tolerance=1)


@pytest.mark.parametrize(
    "x, exponent", [(1, -52), (2, -51), (mpq(3, 2), -52), (mpq(1, 2), -53), (0, -1074)]
)
def test_the_last_place(x: Any, exponent: int) -> None:
    assert ulp(hpoint(x, 0)) == ulp(hpoint(0, -mpq(x))) == mpq(2) ** exponent
    assert ulp(hpoint(mpq(1, mpq(2) ** 2000), 0)) == mpq(2) ** -1074
