"""Diagonals onto an edge: the pieces tile, keep the bounds, and end faces stay high."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

import pytest
from gmpy2 import mpq

from bern_exact.boundary.merge import Objective
from bern_exact.boundary.optimal import Demand, largest_kappa, rate
from bern_exact.boundary.project import (
    MOST_SPARED,
    Cuttable,
    UncutFace,
    best_cuts,
    cuttable,
    fewest_cuts,
    project,
)
from bern_exact.boundary.records import Projected
from bern_exact.checkers.lemma_5 import check_lemma_5
from bern_exact.checkers.printed_ends import check_merged_as_printed
from bern_exact.exact.points import coordinates
from bern_exact.exact.predicates import side, squared_height
from bern_exact.plane.polygon import Polygon
from tests.boundary.merging import Boundary, merged, merged_polygon, points_of
from tests.boundary.naive import area
from tests.boundary.samples import every_family
from tests.checkers.merged_samples import END_FACE, LOW_CORNER, SLENDER

TAU = mpq(1, 8)
APART = TAU * TAU / 2
OBJECTIVES: tuple[Objective, ...] = ("height", "angle")
every_objective = pytest.mark.parametrize("objective", ("fewest", *OBJECTIVES))


def cut_faces(boundary: Boundary) -> Iterator[tuple[Projected, Cuttable]]:
    """Every merged face, with all of its possible diagonals."""
    lines = boundary.warped.traced.diced.framed.polygon.lines
    for item in boundary.mesh.projected:
        face = item.merged
        yield item, cuttable(face, lines[face.edge], points_of(boundary, face.staircase), APART)


@every_family
@every_objective
def test_the_pieces_tile_the_face(kind: str, seed: int, objective: Objective) -> None:
    boundary = merged(kind, seed, objective)
    for item in boundary.mesh.projected:
        stairs = item.merged.staircase
        whole = area(points_of(boundary, (stairs[0], *reversed(stairs[1:]))))
        pieces = [area(points_of(boundary, ring)) for ring, _ in item.pieces]
        assert min(pieces) > 0 and sum(pieces) == whole
        for ring, triangles in item.pieces:
            parts = [area(points_of(boundary, triangle)) for triangle in triangles]
            assert min(parts) > 0 and sum(parts) == area(points_of(boundary, ring))


@every_family
def test_projections_lie_on_the_edge_and_on_a_diagonal(kind: str, seed: int) -> None:
    boundary = merged(kind, seed)
    lines = boundary.warped.traced.diced.framed.polygon.lines
    for item in boundary.mesh.projected:
        line = lines[item.merged.edge]
        for stair, foot in item.cuts:
            (x, y), (u, v) = (coordinates(p) for p in points_of(boundary, (stair, foot)))
            assert side(line, boundary.mesh.point_of(foot)) == 0
            # A positive slope, -a/b > 0, is met along x + y = const, a negative one along x - y.
            assert (x + y == u + v) if line[0] * line[1] < 0 else (x - y == u - v)


@every_family
def test_at_most_the_first_and_the_last_diagonal_are_left_out(kind: str, seed: int) -> None:
    for item, possible in cut_faces(merged(kind, seed)):
        all_stairs = [item.merged.staircase[i] for i in possible.cuts]
        used = [stair for stair, _ in item.cuts]
        variants = (all_stairs, all_stairs[1:], all_stairs[:-1], all_stairs[1:-1])
        assert used in variants


@every_family
def test_no_other_choice_of_diagonals_is_higher(kind: str, seed: int) -> None:
    boundary, demand = merged(kind, seed), Demand(largest_kappa(TAU))
    for item, possible in cut_faces(boundary):
        heights = [
            squared_height(*points_of(boundary, triangle))
            for _, triangles in item.pieces
            for triangle in triangles
        ]
        best = best_cuts(possible, demand)
        assert best is not None and best.value == min(heights)
        kept = [path for path in every_choice(possible, demand) if path is not None]
        assert min(heights) == max(kept)


def every_choice(face: Cuttable, demand: Demand) -> Iterator[mpq | None]:
    """The least height of each choice of end diagonals, None where the demand cannot be kept."""
    last = len(face.cuts)
    for start in {0, min(1, last)}:
        for end in {last, max(last - 1, start)}:
            chosen = [-1, *range(start, end), last]
            values = [
                best_triangulation_value(face, i, j, demand)
                for i, j in zip(chosen, chosen[1:], strict=False)
            ]
            kept = [value for value in values if value is not None]
            yield min(kept) if len(kept) == len(values) else None


def best_triangulation_value(face: Cuttable, i: int, j: int, demand: Demand) -> mpq | None:
    """The greatest least height of a piece."""
    ring = face.ring(i, j)

    @cache
    def best(a: int, b: int) -> mpq | None:
        values = []
        for k in range(a + 1, b):
            parts = [rate(ring[a], ring[k], ring[b], demand)]
            parts += [best(c, d) for c, d in ((a, k), (k, b)) if d > c + 1]
            if None not in parts:
                values.append(min(part for part in parts if part is not None))
        return max(values, default=None)

    return best(0, len(ring) - 1)


@every_family
def test_no_choice_of_diagonals_within_the_bounds_is_smaller(kind: str, seed: int) -> None:
    demand = Demand(largest_kappa(TAU), TAU * TAU / 2)
    for item, possible in cut_faces(merged(kind, seed, "fewest")):
        least = fewest_pieces(possible, demand)
        found = fewest_cuts(possible, demand)
        assert (found is None) == (least is None)
        if least is not None:
            assert len(item.pieces) == least


def fewest_pieces(face: Cuttable, demand: Demand) -> int | None:
    """The least number of pieces, by trying every next one."""
    last = len(face.cuts)
    least: dict[int, int] = {last: 0}
    for i in range(last - 1, -2, -1):
        others = [j for j in range(i + 1, min(last, i + 1 + MOST_SPARED) + 1) if j in least]
        for j in sorted(others, key=lambda j: least[j]):
            if best_triangulation_value(face, i, j, demand) is not None:
                least[i] = 1 + least[j]
                break
    return least.get(-1)


@every_family
def test_few_diagonals_keep_the_bounds(kind: str, seed: int) -> None:
    few, high = (merged(kind, seed, objective) for objective in ("fewest", "height"))
    assert len(few.mesh.projections) <= len(high.mesh.projections)
    failed = [f.claim for f in check_lemma_5(few.mesh) if not f.holds]
    assert failed == []


def least_cotangent(boundary: Boundary, item: Projected) -> mpq:
    """Of the largest angle in a merged face."""
    by_angle = Demand(for_angle=True)
    rated = (
        rate(*points_of(boundary, triangle), by_angle)
        for _, triangles in item.pieces
        for triangle in triangles
    )
    return min(value for value in rated if value is not None)


def least_height(boundary: Boundary, item: Projected) -> mpq:
    """The least squared height in a merged face."""
    return min(
        squared_height(*points_of(boundary, triangle))
        for _, triangles in item.pieces
        for triangle in triangles
    )


@every_family
def test_the_angle_objective_has_no_larger_angles(kind: str, seed: int) -> None:
    by_height, by_angle = (merged(kind, seed, objective) for objective in OBJECTIVES)
    for one, other in zip(by_height.mesh.projected, by_angle.mesh.projected, strict=True):
        if least_height(by_height, one) >= TAU**2 / 2:
            assert least_cotangent(by_angle, other) >= least_cotangent(by_height, one)


@every_family
def test_the_angle_objective_keeps_tau_over_root_two_where_it_can(kind: str, seed: int) -> None:
    by_height, by_angle = (merged(kind, seed, objective) for objective in OBJECTIVES)
    for one, other in zip(by_height.mesh.projected, by_angle.mesh.projected, strict=True):
        reachable = least_height(by_height, one) >= TAU**2 / 2
        assert least_height(by_angle, other) >= (TAU**2 / 2 if reachable else TAU**2 / 4)


@every_family
@pytest.mark.parametrize("tau", [mpq(43, 983), mpq(5, 573)])
def test_smaller_thresholds_keep_their_own_bounds(kind: str, seed: int, tau: mpq) -> None:
    if seed == 0:
        findings = check_lemma_5(merged(kind, seed, "height", tau).mesh, tau=tau)
        assert all(found.holds for found in findings)


@every_objective
@pytest.mark.parametrize(
    ("polygon", "printed"), [(SLENDER, mpq(1, 2000)), (END_FACE, mpq(1, 30_000_000))]
)
def test_end_faces_do_not_come_for_free(
    polygon: Polygon, printed: mpq, objective: Objective
) -> None:
    """With every diagonal drawn an end face is too low; as built none is."""
    mesh = merged_polygon(polygon, objective).mesh
    (claim,) = (f for f in check_merged_as_printed(mesh) if f.claim.endswith("end-height"))
    assert not claim.holds and mpq(claim.measured) < printed
    assert all(found.holds for found in check_lemma_5(mesh))


@every_objective
def test_where_tau_over_root_two_is_out_of_reach(objective: Objective) -> None:
    boundary = merged_polygon(LOW_CORNER, objective)
    heights = [least_height(boundary, item) for item in boundary.mesh.projected]
    assert TAU**2 / 4 <= min(heights) < TAU**2 / 2


def test_a_demand_that_cannot_be_kept() -> None:
    boundary = merged("triangle", 0)
    _, possible = next(iter(cut_faces(boundary)))
    with pytest.raises(UncutFace):
        project(possible, [(best_cuts, Demand(squared_floor=mpq(100)))], 0)


def test_the_first_demand_that_can_be_kept_decides() -> None:
    boundary = merged("triangle", 0)
    _, possible = next(iter(cut_faces(boundary)))
    hopeless = best_cuts, Demand(squared_floor=mpq(100))
    demand = best_cuts, Demand(largest_kappa(TAU))
    assert project(possible, [hopeless, demand], 7) == project(possible, [demand], 7)
