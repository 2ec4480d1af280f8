"""Sentences false as printed: each on an input that refutes it, and on one that does not."""

from __future__ import annotations

import json

from gmpy2 import mpq

from bern_exact import triangulate
from bern_exact.boundary.records import Cut, Lopped
from bern_exact.checkers.as_printed import (
    check_boundary_as_printed,
    check_framed_as_printed,
    check_lopped_as_printed,
    check_swept_as_printed,
    check_warped_as_printed,
)
from bern_exact.checkers.definition_1 import admissible_distance
from bern_exact.checkers.findings import Finding, demand
from bern_exact.checkers.printed_cut import printed_boxes
from bern_exact.corpus.errata import BY_NAME
from bern_exact.exact.points import grid_point, hpoint
from bern_exact.exact.predicates import squared_distance
from bern_exact.interior.records import Column, Rectilinear, Swept, SweptColumn
from bern_exact.plane.feature_size import FeatureSize
from bern_exact.plane.polygon import Polygon
from tests.checkers.samples import THINGS, replace, stages_of


def feature(polygon: Polygon) -> FeatureSize:
    """The least candidate by brute force."""
    best = min(squared_distance(polygon.points[v], polygon.points[w]) for v, w in polygon.edges())
    for v in range(polygon.n):
        for e, w in polygon.edges():
            distance = None if v in (e, w) else admissible_distance(polygon, v, e)
            best = min(best, best if distance is None else distance)
    return FeatureSize(best, None, 0)


def enclosure(found: Finding) -> tuple[mpq, mpq]:
    assert isinstance(found.measured, dict)
    return mpq(found.measured["lower"]), mpq(found.measured["upper"])


def test_the_papers_cutting_line_loses_more_than_a_third() -> None:
    stages = stages_of("guide")
    (found,) = check_lopped_as_printed(stages.lopped, stages.feature)
    low, high = enclosure(found)
    assert not found.holds
    # s'/s = 0.192, as a trial run gave.
    assert mpq(1915, 10000) ** 2 < low <= high < mpq(1925, 10000) ** 2
    demand([found])


def test_the_papers_cutting_line_is_harmless_on_a_triangle() -> None:
    stages = stages_of("triangle")
    (found,) = check_lopped_as_printed(stages.lopped, stages.feature)
    low, high = enclosure(found)
    assert found.holds
    assert 0 < high - low < mpq(1, 2**50)


def test_an_enclosure_holds_the_exact_value_where_the_cut_is_rational() -> None:
    """Both edges at the corner being 5 long, the paper's cut is rational."""
    polygon = Polygon(
        tuple(hpoint(x, y) for x, y in [(0, 0), (5, 0), (8, 9), (3, 4)]), ((0, 1, 2, 3),)
    )
    shorter = [(mpq(5, 3), mpq(0)), (5, 0), (8, 9), (3, 4), (mpq(1), mpq(4, 3))]
    lopped = Lopped(
        polygon,
        Polygon(tuple(hpoint(x, y) for x, y in shorter), ((0, 1, 2, 3, 4),)),
        (-1, 1, 2, 3, -1),
        (Cut(corner=0, nearest=3, before=4, after=0),),
    )
    (found,) = check_lopped_as_printed(lopped, feature(polygon))
    low, high = enclosure(found)
    exact = feature(lopped.lopped).squared / feature(polygon).squared
    assert low <= exact <= high
    assert high - low < mpq(1, 2**50)


def test_boxes_hold_the_papers_cuts() -> None:
    """The base of the paper's cut meets vw at a third: the middle of each base does, nearly."""
    stages = stages_of("plate")
    boxes = printed_boxes(stages.lopped, stages.feature)
    assert len(boxes) == stages.lopped.lopped.n
    for cut in stages.lopped.cuts:
        vx, vy, w = stages.polygon.points[cut.corner]
        nx, ny, nw = stages.polygon.points[cut.nearest]
        third = (2 * mpq(vx, w) + mpq(nx, nw)) / 3, (2 * mpq(vy, w) + mpq(ny, nw)) / 3
        (ax, ay), (bx, by) = (
            tuple((low + high) / 2 for low, high in boxes[end]) for end in (cut.before, cut.after)
        )
        area = (bx - ax) * (third[1] - ay) - (by - ay) * (third[0] - ax)
        assert abs(area) < mpq(1, 2**40)


def test_two_vertices_in_one_square_across_a_slit() -> None:
    stages = stages_of("slit")
    crowded, _ = check_framed_as_printed(stages.framed, stages.feature)
    assert not crowded.holds
    assert crowded.witness is not None
    alone, _ = check_framed_as_printed(stages_of("square").framed, stages_of("square").feature)
    assert alone.holds


def test_blocks_of_the_papers_unit_can_overlap() -> None:
    stages = stages_of("plate")
    small = replace(stages.framed.feature, squared=stages.feature.squared / 9)
    _, overlap = check_framed_as_printed(replace(stages.framed, feature=small), stages.feature)
    assert not overlap.holds
    _, fine = check_framed_as_printed(stages.framed, stages.framed.feature)
    assert fine.holds


def test_a_refused_corner_refutes_the_closest_one() -> None:
    warped = stages_of("plate").warped
    found, _ = check_warped_as_printed(replace(warped, rank=(0,) * len(warped.rank)))
    assert found.holds
    found, _ = check_warped_as_printed(replace(warped, rank=(1, *warped.rank[1:])))
    assert not found.holds and found.measured == 1


def test_the_block_angle_of_a_refused_corner_is_that_of_its_best_triangulation() -> None:
    # A kite whose short diagonal leaves 143.13 degrees at both ends, the long one 73.74.
    kite = (grid_point(0, 0), grid_point(3, -1), grid_point(6, 0), grid_point(3, 1))
    dart = (grid_point(0, 0), grid_point(3, -1), grid_point(6, 0))
    warped = stages_of("plate").warped
    _, found = check_warped_as_printed(replace(warped, refused={0: (kite,)}))
    assert found.holds
    _, found = check_warped_as_printed(replace(warped, refused={0: (kite, dart)}))
    assert not found.holds and found.measured == "-4/3"


def test_almost_an_eighth_is_too_optimistic_only_where_it_is() -> None:
    found, _ = check_boundary_as_printed(stages_of("plate").boundary)
    assert found.cases > 0
    assert isinstance(found.measured, str)
    assert found.holds == (mpq(found.measured) >= mpq(1, 64))


def test_three_corners_of_a_face_may_move() -> None:
    made = triangulate(BY_NAME["three-corners"].rings, theorem=1)
    _, moved = check_boundary_as_printed(made.stages["boundary"])
    assert not moved.holds and moved.measured == 3
    assert len(moved.witness) == 4


def test_the_unit_square_refutes_height_b() -> None:
    square = Rectilinear((((0, 0), (1, 0), (1, 1), (0, 1)),))
    triangles = (((0, 0), (1, 0), (1, 1)), ((0, 0), (1, 1), (0, 1)))
    column = SweptColumn(Column(0, 1, 0, 1), (0, 1), (0, 1), triangles)
    height, zig_zag = check_swept_as_printed(Swept(square, (column,), frozenset()))
    assert not height.holds and height.measured == "1/2"
    assert zig_zag.holds


def test_a_late_subdivision_refutes_the_zig_zag() -> None:
    for side in (8, 9, 20):
        loop = ((0, 0), (1, 0), (1, side - 1), (1, side), (0, side))
        column = SweptColumn(Column(0, 1, 0, side), (0, side), (0, side - 1, side), ())
        _, zig_zag = check_swept_as_printed(Swept(Rectilinear((loop,)), (column,), frozenset()))
        assert not zig_zag.holds
        assert zig_zag.measured == str(mpq(1, side**2 + 1))


def test_all_are_reported_and_never_raised() -> None:
    stages = stages_of("plate")
    findings = [
        *check_lopped_as_printed(stages.lopped, stages.feature),
        *check_framed_as_printed(stages.framed, stages.feature),
        *check_warped_as_printed(stages.warped),
        *check_boundary_as_printed(stages.boundary),
        *check_swept_as_printed(stages.swept),
    ]
    assert len(demand(findings)) == len({f.claim for f in findings}) == 9
    assert all(f.role == "as-printed" for f in findings)
    json.dumps([[f.to_json(), f.witness] for f in findings])


def test_nothing_cut_is_no_case() -> None:
    stages = stages_of("square")
    assert THINGS["square"] is stages.polygon
    (found,) = check_lopped_as_printed(stages.lopped, stages.feature)
    assert found.holds and found.cases == 0 and found.measured is None
