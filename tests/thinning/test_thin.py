"""Thinning keeps every guarantee and takes away nearly all: both judges, real and random."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import pytest
from gmpy2 import mpq

from bern_exact.checkers.thinning import check_thinning
from bern_exact.exact.angle_bound import AngleBound, parse_angle_bound
from bern_exact.exact.errors import InputError
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.exact.similarity import Similarity
from bern_exact.formats.mesh_json import mesh_document
from bern_exact.formats.polygon_json import dump_polygon
from bern_exact.oracle.fast import verify_mesh
from bern_exact.oracle.judge import judge
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.thinning.records import Thinned
from bern_exact.thinning.thin import thin
from tests.theorems.families import FAMILIES, some_polygon
from tests.thinning.samples import DEGREES_150, SQUARE, example, raw_mesh, wheel

OUTLINES = [
    ("mdi_puzzle", 1),
    ("mdi_puzzle", 2),
    ("us_county_51015_augusta", 3),
    pytest.param("ne_united_arab_emirates_50m", 3, marks=pytest.mark.long),
    pytest.param("ne_italy_50m", 3, marks=pytest.mark.long),
]


def thinned_and_judged(
    polygon: Polygon, mesh: Mesh, bound: AngleBound | None, thin_angle: AngleBound | None = None
) -> Thinned:
    """The thinned mesh, if the checker and both judges let it pass."""
    thinned = thin(mesh, polygon, max_angle=bound, thin_angle=thin_angle)
    verdict = verify_mesh(thinned.mesh, polygon, max_angle=bound)
    findings = check_thinning(thinned, polygon, verdict, max_angle=bound, thin_angle=thin_angle)
    assert [found for found in findings if not found.holds] == []
    alone = judge(
        mesh_document(thinned.mesh),
        dump_polygon(polygon),
        max_angle=None if bound is None else bound.text,
    )
    assert alone["valid"], alone["defects"][:3]
    return thinned


@pytest.mark.parametrize(("name", "theorem"), OUTLINES)
def test_real_outlines_need_little_more_than_a_triangle_a_vertex(name: str, theorem: int) -> None:
    polygon, mesh, bound = example(name, theorem)
    thinned = thinned_and_judged(polygon, mesh, bound)
    fewest = polygon.n + 2 * polygon.holes - 2  # of any triangulation
    assert len(thinned.mesh.triangles) - fewest <= mpq(3, 10) * polygon.n


@pytest.mark.parametrize("kind", FAMILIES)
@pytest.mark.parametrize("theorem", [1, 2])
def test_random_polygons(kind: str, theorem: int) -> None:
    polygon = some_polygon(kind, 5)
    thinned = thinned_and_judged(polygon, *raw_mesh(polygon, theorem))
    assert thinned.removed > 0


def test_thinning_again_removes_nothing() -> None:
    polygon, mesh, bound = example("mdi_chip", 3)
    once = thin(mesh, polygon, max_angle=bound, thin_angle=parse_angle_bound("120")).mesh
    assert len(once.vertices) > polygon.n
    again = thin(once, polygon, max_angle=bound, thin_angle=parse_angle_bound("120"))
    assert (again.removed, again.mesh.vertices) == (0, once.vertices)
    assert again.mesh.triangles == once.triangles


@pytest.mark.parametrize("degrees", ["140", "120", "100.5"])
def test_a_smaller_angle_on_new_triangles(degrees: str) -> None:
    polygon, mesh, bound = example("mdi_chip", 3)
    asked = parse_angle_bound(degrees)
    thinned = thinned_and_judged(polygon, mesh, bound, asked)
    without = thin(mesh, polygon, max_angle=bound)
    assert without.removed >= thinned.removed > len(mesh.vertices) // 2


def test_no_angle_is_small_enough_to_leave_a_mesh_as_it_is() -> None:
    """Where triangles are above the angle asked for, as many that are no worse will do."""
    polygon, mesh, bound = example("glyph_dejavusans_A", 3)
    thinned = thinned_and_judged(polygon, mesh, bound, parse_angle_bound("90"))
    assert len(thinned.mesh.triangles) < 15 * polygon.n


def test_two_that_can_only_go_together() -> None:
    inner = (hpoint(1, 2), hpoint(3, 2))
    both = Mesh(
        (*SQUARE.points, *inner),
        ((0, 1, 4), (1, 5, 4), (1, 2, 5), (2, 4, 5), (2, 3, 4), (3, 0, 4)),
    )
    thinned = thinned_and_judged(SQUARE, both, parse_angle_bound("90"), None)
    assert thinned.mesh.vertices == SQUARE.points and thinned.removed == 2


def test_a_larger_angle_than_the_bound_changes_nothing() -> None:
    polygon, mesh, bound = example("mdi_chip", 3)
    wider = thin(mesh, polygon, max_angle=bound, thin_angle=parse_angle_bound("170"))
    assert wider.mesh == thin(mesh, polygon, max_angle=bound).mesh


def test_theorem_1_may_ask_for_an_angle_too() -> None:
    polygon, mesh, _ = example("mdi_puzzle", 1)
    thinned_and_judged(polygon, mesh, None, DEGREES_150)


def test_vertices_at_the_edges_go_too() -> None:
    middle = hpoint(2, 0)
    split = Mesh((*SQUARE.points, middle), ((0, 4, 3), (4, 2, 3), (4, 1, 2)))
    thinned = thinned_and_judged(SQUARE, split, DEGREES_150)
    assert thinned.mesh.vertices == SQUARE.points
    assert thinned.removed == 1


def test_a_vertex_that_the_angle_bound_needs_stays() -> None:
    centred = Mesh((*SQUARE.points, hpoint(2, 2)), ((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)))
    kept = thin(centred, SQUARE, max_angle=parse_angle_bound("89"))
    assert (kept.removed, len(kept.mesh.triangles)) == (0, 4)


@pytest.mark.parametrize(("spokes", "removed"), [(12, 1), (20, 1), (48, 1), (60, 0)])
def test_the_largest_stars_stay(spokes: int, removed: int) -> None:
    polygon, mesh = wheel(spokes)
    # Such a ring has flat corners, so that without the centre some triangles are very low.
    lowered = Mesh((*mesh.vertices[:-1], hpoint(2, mpq(1, 10**3))), mesh.triangles)
    thinned = thinned_and_judged(polygon, lowered, None)
    assert thinned.removed == removed


def moved(points: tuple[HPoint, ...], move: Callable[[HPoint], HPoint]) -> tuple[HPoint, ...]:
    return tuple(move(p) for p in points)


@pytest.mark.parametrize(
    "move",
    [
        Similarity.of((mpq(1), mpq(0)), (mpq(10**12, 7), mpq(-3))),
        Similarity.of((mpq(22, 7), mpq(0)), (mpq(0), mpq(0))),
        Similarity.rotation(mpq(2, 5)),
    ],
    ids=["translated", "scaled", "turned"],
)
def test_similar_meshes_are_thinned_alike(move: Similarity) -> None:
    polygon, mesh, bound = example("mdi_chip", 3)
    image = polygon.with_points([move.apply(p) for p in polygon.points])
    there = thin(Mesh(moved(mesh.vertices, move.apply), mesh.triangles), image, max_angle=bound)
    here = thin(mesh, polygon, max_angle=bound)
    assert there.mesh == Mesh(moved(here.mesh.vertices, move.apply), here.mesh.triangles)


def test_the_order_of_the_triangles_does_not_matter() -> None:
    polygon, mesh, bound = example("mdi_chip", 3)
    turned = tuple((b, c, a) for a, b, c in reversed(mesh.triangles))
    there = thin(Mesh(mesh.vertices, turned), polygon, max_angle=bound)
    assert there.mesh == thin(mesh, polygon, max_angle=bound).mesh


def test_the_triangles_are_sorted() -> None:
    polygon, mesh, bound = example("mdi_chip", 3)
    triangles = thin(mesh, polygon, max_angle=bound).mesh.triangles
    assert all(a < b for a, b in pairwise(triangles))
    assert all(t[0] == min(t) for t in triangles)


def test_another_polygon_is_refused() -> None:
    polygon, mesh, bound = example("mdi_chip", 3)
    with pytest.raises(InputError) as refused:
        thin(mesh, SQUARE, max_angle=bound)
    assert refused.value.kind == "schema"


@pytest.mark.parametrize("triangles", [(), ((0, 1, 2), (0, 2, 3), (0, 0, 1))])
def test_a_flat_triangle_is_refused(triangles: tuple[tuple[int, int, int], ...]) -> None:
    with pytest.raises(InputError) as refused:
        thin(Mesh(SQUARE.points, triangles), SQUARE, max_angle=None)
    assert refused.value.kind == "zero-area"
