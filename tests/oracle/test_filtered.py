"""The filtered judge says what the others say, and leaves little to integers."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from gmpy2 import mpq
from numpy.typing import NDArray

from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.exact.points import hpoint
from bern_exact.oracle import api, estimates, filters
from bern_exact.oracle.estimates import distinct_shapes, estimate, frame_of
from bern_exact.oracle.fast import verify_mesh
from bern_exact.oracle.filtered import Effort, verify_arrays
from bern_exact.oracle.filters import UNDECIDED
from bern_exact.oracle.lazy_points import LazyPoints
from bern_exact.oracle.shapes import shape_of
from bern_exact.plane.array_mesh import ArrayMesh, DoublePoints, ExactPoints
from bern_exact.plane.text_points import points_of_numbers
from tests.oracle import campaign
from tests.oracle.agreement import all_forms, forms
from tests.oracle.meshes import Case, damage, good, grid, point
from tests.oracle.variants import as_doubles, equilateral_grid, rotated_grid, scaled


def array_grid(n: int, jitter: float = 0.0) -> ArrayMesh:
    """n x n squares, each cut in two, the vertices moved by chance."""
    rng = np.random.default_rng(3)
    x, y = (c.astype(float) for c in np.meshgrid(np.arange(n + 1), np.arange(n + 1)))
    x[1:-1, 1:-1] += rng.uniform(-jitter, jitter, (n - 1, n - 1))
    y[1:-1, 1:-1] += rng.uniform(-jitter, jitter, (n - 1, n - 1))
    a = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    corners = [(a, a + 1, a + n + 2), (a, a + n + 2, a + n + 1)]
    triangles = np.concatenate([np.stack(row, axis=1) for row in corners])
    return ArrayMesh.of_doubles(np.stack((x.ravel(), y.ravel()), axis=1), triangles)


def same(mesh: ArrayMesh, **bounds: Any) -> Effort:
    """Both judges of the package agree; what was left to integers."""
    effort = Effort()
    filtered = verify_arrays(mesh, None, effort=effort, **bounds)
    assert filtered.to_json() == verify_mesh(mesh.mesh, None, **bounds).to_json()
    return effort


@pytest.mark.parametrize("seed", range(2))
def test_the_three_judges_agree(seed: int) -> None:
    failures, seen, effort = campaign.run(seconds=600, seed=500 + seed, most=40)
    assert not failures
    assert seen["valid"] and seen["not valid"]
    assert effort.undecided and effort.near_bounds and effort.evaluated


def test_a_radius_too_small_would_be_found(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(estimates, "INPUT", 0.0)
    monkeypatch.setattr(filters, "ROUNDING", 0.0)
    failures, _, _ = campaign.run(seconds=600, seed=500, most=20)
    assert failures
    assert '"mesh": {' in capsys.readouterr().out


def test_doubles_decide_alone_but_for_the_extremes() -> None:
    effort = same(array_grid(20, 0.2), max_angle=parse_angle_bound("90"))
    assert (effort.undecided, effort.near_bounds) == (0, 0)
    assert effort.candidates <= 4


@pytest.mark.parametrize("bound", ["90", "60", "89.999"])
def test_right_angles_are_decided_by_doubles(bound: str) -> None:
    effort = same(array_grid(20), max_angle=parse_angle_bound(bound), limit=3)
    assert (effort.undecided, effort.near_bounds) == (0, 0)
    assert effort.evaluated < 10


@pytest.mark.parametrize("seed", range(5))
def test_right_angles_of_any_direction_are_decided_by_doubles(seed: int) -> None:
    case = rotated_grid(random.Random(seed))
    for _, mesh in list(forms(case))[1:]:
        effort = Effort()
        bound = parse_angle_bound("90")
        assert not verify_arrays(mesh, None, max_angle=bound, effort=effort).defects
        assert (effort.undecided, effort.near_bounds) == (0, 0)


@pytest.mark.parametrize("power", [0, 1, -40])
def test_a_grid_is_few_shapes_whatever_the_numbers(power: int) -> None:
    """A hundred thousand equal heights, known inexactly, are one comparison."""
    numbers = [f"{n}/{q}" for q in (2**31 - 1, 2**31 - 19) for n in range(21)]
    x, y = numbers[:21], numbers[21:]
    points = points_of_numbers([c for b in y for a in x for c in (a, b)], binary64=False)
    assert points is not None
    mesh = ArrayMesh(points, array_grid(20).triangles)
    assert same(mesh).evaluated < 10


def test_hundreds_of_undecided_triangles_are_few_shapes() -> None:
    case = as_doubles(equilateral_grid(random.Random(1)))
    mesh = dict(forms(case))["doubles"]
    wide = np.arange(20)[:, None, None] * np.array([[64.0, 0.0]])
    doubles = (mesh.points.doubles[None] + wide).reshape(-1, 2)
    shift = np.arange(20)[:, None, None] * len(mesh.points)
    many = ArrayMesh.of_doubles(doubles, (mesh.triangles[None] + shift).reshape(-1, 3))
    effort = same(many)
    assert effort.candidates > 20 * effort.evaluated or effort.undecided < 20


@pytest.mark.parametrize("exponent", [-400, -35, 35, 400])
def test_wild_meshes_go_to_integers_and_are_judged_alike(exponent: int) -> None:
    case = scaled(grid(2, 2), Fraction(10) ** exponent)
    effort = Effort()
    verdict = all_forms(case, effort)
    assert verdict is not None and verdict["valid"]
    assert effort.undecided >= 8


def test_a_wild_vertex_concerns_its_own_triangles_alone() -> None:
    case = grid(4, 4)
    case.rings = []
    case.vertices[0] = point(Fraction(1, 10**40), 0)
    effort = Effort()
    assert all_forms(case, effort) is not None
    assert effort.undecided == 2 * len(list(forms(case)))


def test_bounds_that_are_hit_are_kept_and_just_below_them_not() -> None:
    case = grid(3, 2).mapped(lambda p: (p[0] + p[1] / 3, p[1]))
    verdict = all_forms(case)
    assert verdict is not None
    angle, height = verdict["max_angle"], mpq(verdict["min_height_squared"])
    text = f"cos:{angle['cos_sign']}:"
    square = mpq(angle["cos_squared"])
    effort = Effort()
    hit = {"max_angle": f"{text}{square}", "min_height_squared": str(height)}
    kept = all_forms(case, effort, **hit)
    assert kept is not None and kept["valid"] and effort.near_bounds
    tiny = mpq(1, 10**50)
    for bounds in (
        {"max_angle": f"{text}{square + (tiny if angle['cos_sign'] > 0 else -tiny)}"},
        {"min_height_squared": str(height + tiny)},
    ):
        broken = all_forms(case, **bounds)
        assert broken is not None and not broken["valid"]


def test_an_index_beyond_64_bits_is_out_of_range() -> None:
    case = grid(1, 1)
    case.triangles.append((0, 10**30, 1))
    verdict = all_forms(case)
    assert verdict is not None
    assert verdict["defects"][0]["kind"] == "index-out-of-range"


def test_the_first_of_equal_triangles_is_named_in_every_order() -> None:
    rng = random.Random(4)
    for _ in range(20):
        case = grid(3, 3, rng)
        rng.shuffle(case.triangles)
        verdict = all_forms(case)
        assert verdict is not None and verdict["max_angle"]["triangle"] == 0


@pytest.mark.parametrize("seed", range(6))
def test_verify_says_the_same_whichever_judge_it_asks(
    seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    rng = random.Random(seed)
    case = as_doubles(good(rng))
    if seed % 2:
        damage(case, rng)
    polygon, told = case.polygon(), []
    for many in (0, 10**9):
        monkeypatch.setattr(api, "MANY", many)
        for mesh in (case.mesh(), ArrayMesh.of_mesh(case.mesh())):
            told.append(api.verdict_on(mesh, polygon, tolerance=mpq(1, 10**9)).to_json())
    assert told == [told[0]] * 4


def hard_triangles(seed: int, kind: str) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Triangles with a corner next to the line, or the circle, through the others."""
    rng = np.random.default_rng(seed)
    p, q = rng.uniform(-1, 1, (2, 400, 2))
    if kind == "flat":
        r = p + rng.uniform(0, 1, (400, 1)) * (q - p) + 10.0 ** rng.uniform(-17, -7, (400, 2))
    else:  # on Thales' circle: a right angle but for rounding
        turn = rng.uniform(0, 2 * np.pi, 400)
        radius = np.hypot(*(q - p).T) / 2
        r = (p + q) / 2 + radius[:, None] * np.stack((np.cos(turn), np.sin(turn)), axis=1)
    far = np.where(rng.uniform(size=(400, 1)) < 0.3, 2.0**20, 0.0)
    points = np.stack((p + far, q + far, r + far), axis=1).reshape(-1, 2)
    return points, np.arange(1200).reshape(-1, 3)


@pytest.mark.parametrize("kind", ["flat", "right"])
@pytest.mark.parametrize("exact", [True, False])
def test_estimates_hold_the_exact_values(kind: str, exact: bool) -> None:
    doubles, corners = hard_triangles(7, kind)
    points: Any = DoublePoints(doubles)
    if not exact:  # and moved by half an ulp and less
        rng = random.Random(8)
        moved = [
            hpoint(*(mpq(c) * (1 + mpq(rng.randint(-9, 9), 9 * 2**54)) for c in row))
            for row in doubles.tolist()
        ]
        points = ExactPoints(moved)
    told = estimate(frame_of(points), corners)
    decided = 0
    for t, (a, b, c) in enumerate(corners.tolist()):
        dot, cross, longest, scale = shape_of(points.point(a), points.point(b), points.point(c))
        if told.signs[t] != UNDECIDED:
            decided += 1
            assert told.signs[t] == (cross > 0) - (cross < 0)
        height = mpq(cross * cross, longest * scale)
        for low, value, high in (
            (told.cot_low[t], mpq(dot, 2 * abs(cross)) if cross else None, told.cot_high[t]),
            (told.height_low[t], height, told.height_high[t]),
        ):
            if value is not None and np.isfinite([low, high]).all():
                assert mpq(float(low)) <= value <= mpq(float(high))
    assert decided > 200


@pytest.mark.parametrize("lone_key", [False, True])
def test_triangles_of_one_shape_are_that(lone_key: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Also if all their keys are the same by chance."""
    monkeypatch.setattr(estimates, "FEW", 1)
    if lone_key:
        monkeypatch.setattr(estimates, "_MULTIPLIERS", np.zeros(8, dtype=np.uint64))
    case = grid(3, 3, random.Random(2))
    case.vertices[5] = point(Fraction(6, 5), Fraction(4, 3))
    for name, mesh in forms(as_doubles(case)):
        first, shape = distinct_shapes(frame_of(mesh.points), mesh.triangles)
        assert first.tolist() == sorted(set(first.tolist()))
        if name != "exact" and not lone_key:
            assert len(first) < len(mesh.triangles)
        for t, k in enumerate(shape.tolist()):
            assert first[k] <= t
            assert vectors(case, mesh, t) == vectors(case, mesh, int(first[k]))


def vectors(case: Case, mesh: ArrayMesh, t: int) -> list[mpq]:
    """The edges of a triangle from its first corner, exactly."""
    p, q, r = (mesh.points.point(v) for v in mesh.triangles[t].tolist())
    return [mpq(end[k], end[2]) - mpq(p[k], p[2]) for end in (q, r) for k in (0, 1)]


def test_points_are_found_among_them() -> None:
    numbers: list[Any] = ["1/3", "0.1", "1/3", "1e-400", "0", "0", "-1e400", 7, "1/3", "2e-400"]
    points = points_of_numbers(numbers, binary64=False)
    assert points is not None
    lazy = LazyPoints(points)
    exact = [points.point(v) for v in range(5)]
    assert list(lazy) == exact and lazy[1:3] == exact[1:3]
    assert all(p in lazy for p in exact)
    third = mpq(1, 3)
    others = [(third, mpq(3, 10**400)), (third, mpq(0)), (mpq(-(10**401)), mpq(7)), (mpq(9), third)]
    assert not any(hpoint(x, y) in lazy for x, y in others)
    assert "0" not in lazy
