"""The checker of thinning: it passes what is right, and each claim fails on a damaged record."""

from __future__ import annotations

from dataclasses import replace

import pytest
from gmpy2 import mpq

from bern_exact.checkers.findings import Finding
from bern_exact.checkers.thinning import check_thinning
from bern_exact.exact.angle_bound import AngleBound, parse_angle_bound
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.oracle.fast import verify_mesh
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.thinning.records import Thinned


def points(*pairs: tuple[int | mpq, int | mpq]) -> tuple[HPoint, ...]:
    return tuple(hpoint(x, y) for x, y in pairs)


SQUARE = polygon_from_rings([points((0, 0), (4, 0), (4, 4), (0, 4))])
INNER = hpoint(1, 2)
OTHER = hpoint(3, 2)
WHEEL = ((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4))

RAW = Mesh(
    (*SQUARE.points, INNER, OTHER),
    ((0, 1, 4), (1, 5, 4), (1, 2, 5), (2, 4, 5), (2, 3, 4), (3, 0, 4)),
)
GOOD = Thinned(RAW, Mesh(SQUARE.points, ((0, 1, 2), (0, 2, 3))), 2)
HALF = Thinned(RAW, Mesh((*SQUARE.points, INNER), WHEEL), 1)


def check(
    thinned: Thinned, max_angle: str | None = "150", thin_angle: str | None = None
) -> dict[str, Finding]:
    def bound(text: str | None) -> AngleBound | None:
        return None if text is None else parse_angle_bound(text)

    findings = check_thinning(
        thinned,
        SQUARE,
        verify_mesh(thinned.mesh, SQUARE),
        max_angle=bound(max_angle),
        thin_angle=bound(thin_angle),
    )
    return {found.claim: found for found in findings}


def failing(found: dict[str, Finding]) -> set[str]:
    for finding in found.values():
        assert finding.holds or finding.witness is not None
    return {claim for claim, finding in found.items() if not finding.holds}


@pytest.mark.parametrize("thinned", [GOOD, HALF, Thinned(RAW, RAW, 0)])
@pytest.mark.parametrize("max_angle", ["150", None])
def test_what_is_right_passes(thinned: Thinned, max_angle: str | None) -> None:
    found = check(thinned, max_angle)
    assert not failing(found)
    assert ("thinning.angle" in found) == (max_angle is not None)


def test_a_mesh_that_leaves_a_part_out() -> None:
    torn = replace(GOOD, mesh=Mesh(SQUARE.points, ((0, 1, 2),)))
    assert failing(check(torn)) == {"thinning.valid"}


def test_more_triangles() -> None:
    more = Thinned(GOOD.mesh, HALF.mesh, -1)
    assert "thinning.count" in failing(check(more))


def test_a_lower_triangle() -> None:
    low = hpoint(2, mpq(1, 9))
    lowered = Thinned(RAW, Mesh((*SQUARE.points, low), WHEEL), 1)
    found = check(lowered, None)
    assert failing(found) == {"thinning.height", "thinning.vertices"}
    assert found["thinning.height"].measured == "1/81"


def test_more_triangles_above_the_angle_asked_for() -> None:
    # The raw mesh has four triangles with an angle of more than 80 degrees, and none with 91.
    assert failing(check(HALF, "150", "80")) == failing(check(GOOD, "150", "80")) == set()
    assert check(GOOD, "150", "80")["thinning.above-asked"].measured == 2
    centred = Mesh((*SQUARE.points, hpoint(2, 2)), WHEEL)
    assert failing(check(Thinned(centred, GOOD.mesh, 1), "150", "89.9")) == set()
    assert "thinning.above-asked" in failing(check(Thinned(GOOD.mesh, centred, -1), "150", "80"))


def test_a_larger_angle_above_the_one_asked_for() -> None:
    lower = Mesh((*SQUARE.points, hpoint(2, 1)), WHEEL)
    centred = Mesh((*SQUARE.points, hpoint(2, 2)), WHEEL)
    assert failing(check(Thinned(lower, lower, 0), "150", "80")) == set()
    broken = failing(check(Thinned(centred, lower, 0), "150", "80"))
    assert {"thinning.asked-angle"} <= broken and "thinning.above-asked" not in broken


def test_an_angle_above_the_bound_of_the_mesh() -> None:
    found = check(HALF, "80")
    assert "thinning.angle" in failing(found)
    assert check(GOOD, "90")["thinning.angle"].measured == "0"


def test_a_bound_that_is_irrational_is_given_by_an_enclosure() -> None:
    bound = check(GOOD, "149.5")["thinning.angle"].bound
    assert isinstance(bound, dict) and mpq(bound["lower"]) < mpq(bound["upper"])


def test_a_clockwise_triangle_has_180_degrees() -> None:
    turned = replace(GOOD, mesh=Mesh(SQUARE.points, ((0, 2, 1), (0, 2, 3))))
    broken = failing(check(turned, "179.9"))
    assert broken == {"thinning.valid", "thinning.height", "thinning.angle"}


def test_a_mesh_without_triangles_is_not_valid() -> None:
    assert "thinning.valid" in failing(check(replace(GOOD, mesh=Mesh(SQUARE.points, ()))))


def test_vertices_in_another_order() -> None:
    swapped = Mesh(
        (*SQUARE.points, OTHER, INNER),
        tuple(tuple({4: 5, 5: 4}.get(v, v) for v in t) for t in RAW.triangles),  # type: ignore[misc]
    )
    assert failing(check(Thinned(RAW, swapped, 0))) == {"thinning.vertices"}


def test_a_polygon_vertex_that_is_not_first() -> None:
    turned = SQUARE.points[1:] + SQUARE.points[:1]
    mesh = Mesh(turned, ((0, 1, 2), (0, 2, 3)))
    assert "thinning.vertices" in failing(check(replace(GOOD, mesh=mesh)))


def test_a_wrong_number_of_vertices_that_went() -> None:
    assert failing(check(replace(GOOD, removed=1))) == {"thinning.vertices"}
