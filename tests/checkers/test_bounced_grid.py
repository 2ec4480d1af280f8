"""The checkers of the grid, of Lemma 9 and of Theorem 4 notice every damage."""

from __future__ import annotations

from dataclasses import replace

import pytest
from gmpy2 import mpq

from bern_exact.checkers import bounds_bounce, bounds_convex
from bern_exact.checkers.bounced_grid import check_grid
from bern_exact.checkers.lemma_9 import check_lemma_9
from bern_exact.checkers.theorem_4 import check_theorem_4
from bern_exact.convex.block_records import Block, Reduced
from bern_exact.convex.bounce import bounce
from bern_exact.convex.faces import faces
from bern_exact.convex.frame import convex_frame
from bern_exact.convex.records import Gridded
from bern_exact.oracle.fast import verify_mesh
from bern_exact.plane.mesh import Mesh
from bern_exact.theorems.theorem_4 import theorem_4
from tests.convex.polygons import family

POLYGON = family("random-hull", 12)
MADE = theorem_4(POLYGON)
MESH = MADE.assembled.mesh
GOOD = faces(bounce(convex_frame(POLYGON)))
REDUCED = MADE.records["reduced"]
CUT = next(i for i, leg in enumerate(GOOD.legs) if leg.subdivision is not None)
WHOLE = next(i for i, leg in enumerate(GOOD.legs) if leg.subdivision is None)


def failing(record: Gridded) -> set[str]:
    return {f.claim for f in (*check_grid(record), *check_lemma_9(record)) if not f.holds}


def with_leg(i: int, **changes: object) -> Gridded:
    legs = list(GOOD.legs)
    legs[i] = legs[i]._replace(**changes)
    return replace(GOOD, legs=tuple(legs))


def with_cells(**changes: object) -> Gridded:
    return replace(GOOD, cells=replace(GOOD.cells, **changes))


def test_the_good_one_passes() -> None:
    assert not failing(GOOD)


def test_a_horizontal_moved() -> None:
    ys = list(GOOD.cells.ys)
    ys[1] = (ys[0] + ys[1]) / 2
    assert "grid.lines" in failing(with_cells(ys=tuple(ys)))


def test_a_vertical_too_many() -> None:
    xs = (*GOOD.cells.xs, mpq(2))
    assert "grid.lines" in failing(with_cells(xs=xs))


def test_a_cell_too_few() -> None:
    low = (*GOOD.cells.low[:3], GOOD.cells.low[3] + 1, *GOOD.cells.low[4:])
    assert {"grid.cells", "grid.area"} <= failing(with_cells(low=low))


def test_a_triangle_left_out() -> None:
    less = replace(GOOD, legs=GOOD.legs[1:])
    assert failing(less) == {"grid.triangles", "grid.area"}


def test_a_triangle_twice() -> None:
    more = replace(GOOD, legs=(*GOOD.legs, GOOD.legs[0]))
    assert failing(more) == {"grid.triangles", "grid.area"}


def test_a_triangle_of_no_column() -> None:
    stranger = GOOD.legs[0]._replace(column=10**6)
    assert "grid.triangles" in failing(replace(GOOD, legs=(*GOOD.legs, stranger)))


def test_a_subdivision_that_is_not_recorded() -> None:
    leg = GOOD.legs[CUT]
    ring = (leg.low, leg.right, leg.high)
    found = failing(with_leg(CUT, subdivision=None, triangles=(ring,)))
    assert "grid.triangles" in found


def test_two_subdivisions() -> None:
    # The grid of the vertices alone: nothing has been bounced.
    frame = convex_frame(family("clustered-spiral", 12))
    verticals = tuple(sorted(x for x, _ in frame.places))
    unbounced = faces(replace(bounce(frame), verticals=verticals, events=()))
    assert "grid.subdivisions" in failing(unbounced)


@pytest.mark.parametrize("part", [0, 1, 2])
def test_a_right_triangle_turned_over(part: int) -> None:
    triangles = list(GOOD.legs[CUT].triangles)
    triangles[part] = triangles[part][::-1]
    assert failing(with_leg(CUT, triangles=tuple(triangles))) == {"lemma-9.right", "lemma-9.tiling"}


def test_a_whole_triangle_turned_over() -> None:
    (ring,) = GOOD.legs[WHOLE].triangles
    assert failing(with_leg(WHOLE, triangles=(ring[::-1],))) == {"lemma-9.right", "lemma-9.tiling"}


def test_a_right_triangle_missing() -> None:
    triangles = GOOD.legs[CUT].triangles[1:]
    assert failing(with_leg(CUT, triangles=triangles)) == {"lemma-9.tiling"}


def test_a_right_triangle_twice() -> None:
    triangles = GOOD.legs[CUT].triangles
    found = failing(with_leg(CUT, triangles=(*triangles, triangles[0])))
    assert found == {"lemma-9.tiling", "lemma-9.triangles"}


def test_a_foot_beside_the_hypotenuse() -> None:
    (x, y), *rest = GOOD.feet
    found = failing(replace(GOOD, feet=((x, y + mpq(1, 10**40)), *rest)))
    assert found == {"lemma-9.right", "lemma-9.tiling"}


def test_a_foot_that_is_not_the_altitudes() -> None:
    leg = next(leg for leg in GOOD.legs if any(0 in t for t in leg.triangles))
    (px, py), (qx, qy) = GOOD.position(leg.low), GOOD.position(leg.high)
    middle = ((px + qx) / 2, (py + qy) / 2)
    assert failing(replace(GOOD, feet=(middle, *GOOD.feet[1:]))) == {"lemma-9.right"}


def test_a_subdivision_on_no_leg() -> None:
    leg = GOOD.legs[CUT]
    column, row = leg.subdivision or (0, 0)
    away = (column + 1, row)
    triangles = tuple(
        tuple(away if p == leg.subdivision else p for p in corners) for corners in leg.triangles
    )
    found = failing(with_leg(CUT, subdivision=away, triangles=triangles))
    assert {"grid.triangles", "lemma-9.tiling"} <= found


# Theorem 4 -------------------------------------------------------------------------------


def failing_theorem(
    mesh: Mesh = MESH, gridded: Gridded = GOOD, reduced: object = REDUCED
) -> set[str]:
    assert isinstance(reduced, Reduced)
    verdict = verify_mesh(mesh, POLYGON)
    found = check_theorem_4(POLYGON, mesh, gridded, reduced, verdict)
    return {f.claim for f in found if not f.holds}


def test_the_mesh_passes() -> None:
    assert not failing_theorem()


def test_a_hole_in_the_mesh() -> None:
    assert failing_theorem(replace(MESH, triangles=MESH.triangles[1:])) == {
        "theorem-4.record",
        "theorem-4.valid",
    }


def test_a_vertex_moved_makes_an_obtuse_angle() -> None:
    # A crossing with right angles round it, moved by a hair: only the angles change.
    inside = len(MESH.vertices) - len(GOOD.feet) - 1
    x, y, w = MESH.vertices[inside]
    moved = (x * 10**40 + 1, y * 10**40, w * 10**40)
    vertices = (*MESH.vertices[:inside], moved, *MESH.vertices[inside + 1 :])
    assert "theorem-4.angle" in failing_theorem(replace(MESH, vertices=vertices))


def test_vertices_in_another_order() -> None:
    swap = {0: 1, 1: 0}
    vertices = (MESH.vertices[1], MESH.vertices[0], *MESH.vertices[2:])
    triangles = tuple(tuple(swap.get(v, v) for v in t) for t in MESH.triangles)
    assert failing_theorem(Mesh(vertices, triangles)) == {"theorem-4.vertices"}


def test_more_triangles_than_the_baseline() -> None:
    many = replace(MESH, triangles=MESH.triangles * 9)
    assert {"theorem-4.baseline-count", "theorem-4.valid"} <= failing_theorem(many)


@pytest.mark.parametrize(
    ("claim", "name"),
    [
        ("theorem-4.quadratic-count", "baseline_triangles"),
        ("theorem-4.count", "theorem_4_triangles"),
    ],
)
def test_more_triangles_than_the_bound(
    claim: str, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(bounds_bounce, name, lambda n: len(MESH.triangles) - 1)
    assert failing_theorem() == {claim}


def test_blocks_too_small_for_their_triangles() -> None:
    assert isinstance(REDUCED, Reduced)
    none = replace(REDUCED, blocks=())
    assert failing_theorem(reduced=none) == {"theorem-4.power-count", "theorem-4.record"}


def test_long_sides_longer_than_the_boundary() -> None:
    assert isinstance(REDUCED, Reduced)
    long = REDUCED.blocks[0]._replace(block=Block(0, 10**6, 0, 1), triangles=())
    longer = replace(REDUCED, blocks=(*REDUCED.blocks, long))
    assert failing_theorem(reduced=longer) == {"theorem-4.long-sides"}


def test_blocks_of_other_cells() -> None:
    """As many triangles, of cells that are not the grid's."""
    assert isinstance(REDUCED, Reduced)
    cells = REDUCED.merged.cells
    stretched = replace(cells, xs=tuple(1000 * x for x in cells.xs))
    other = replace(REDUCED, merged=replace(REDUCED.merged, cells=stretched))
    assert failing_theorem(reduced=other) == {"theorem-4.record"}


def test_a_mesh_of_other_blocks() -> None:
    """One triangle more in a block than in the mesh."""
    assert isinstance(REDUCED, Reduced)
    first, *rest = REDUCED.blocks
    more = first._replace(triangles=(*first.triangles, first.triangles[0]))
    other = replace(REDUCED, blocks=(more, *rest))
    assert failing_theorem(reduced=other) == {"theorem-4.record"}


def test_a_baseline_that_splits_not_every_cell() -> None:
    verdict = verify_mesh(MESH, POLYGON)
    found = check_theorem_4(POLYGON, MESH, GOOD, None, verdict)
    assert [f.claim for f in found if not f.holds] == ["theorem-4.record"]


@pytest.mark.parametrize(
    ("n", "less"), [(10, False), (58 * 10**8, False), (59 * 10**8, True), (10**12, True)]
)
def test_where_the_bound_falls_below_the_quadratic_one(n: int, less: bool) -> None:
    """As the statement of `theorem-4.count` says."""
    quadratic = bounds_bounce.baseline_triangles(n)
    assert quadratic == 324 * n * n + 54 * n
    assert (bounds_bounce.theorem_4_triangles(n) < quadratic) == less


@pytest.mark.parametrize(("rows", "less"), [(2, False), (406, False), (407, True), (10**5, True)])
def test_where_the_powers_fall_below_two_a_cell(rows: int, less: bool) -> None:
    """As the statement of `theorem-4.power-count` says."""
    powers = bounds_convex.POWER_CONSTANT * bounds_convex.power_sum(rows, rows)
    assert (powers < bounds_convex.grid_triangles(rows, rows)) == less
