"""Boundary vertices off their edges: how far exactly, and what a tolerance accepts."""

from __future__ import annotations

import json
from importlib import resources
from typing import Any

import pytest
from gmpy2 import mpq
from jsonschema import Draft202012Validator

from bern_exact.exact.errors import InputError
from bern_exact.exact.points import hpoint
from bern_exact.oracle.api import verify
from bern_exact.oracle.departures import ulp
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


def test_a_missing_polygon_vertex_is_not_accepted() -> None:
    ring = [*SQUARE[:1], (2, -EPSILON), *SQUARE[1:]]
    verdict = judged(ring=ring, tolerance=1)
    assert verdict.within_tolerance is False and verdict.off_edge is None
    assert {"polygon-vertex-missing"} <= {defect.kind for defect in verdict.defects}


def test_a_missing_triangle_is_not_accepted() -> None:
    vertices = [*SQUARE, (2, 2), (2, EPSILON)]
    verdict = verify(vertices, [(4, 0, 5), (4, 5, 1), *FAN[1:3]], SQUARE, tolerance=1)
    assert verdict.within_tolerance is False


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
