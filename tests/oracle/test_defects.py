"""Each kind of damage is reported under its own name, at its place, by both judges."""

from __future__ import annotations

from fractions import Fraction

from tests.oracle.agreement import both, found, kinds
from tests.oracle.meshes import Case, grid, point


def square() -> Case:
    """The square of side 2 with its centre and the middles of its sides."""
    return grid(2, 2)


def test_nothing_is_wrong_with_a_good_mesh() -> None:
    verdict = both(square())
    assert verdict["valid"] and verdict["defects"] == []
    assert verdict["max_angle"]["degrees"] == ["90", "90"]
    assert verdict["min_height_squared"] == "1/2"
    assert verdict["angle_classes"]["le90"] == 8


def test_index_out_of_range() -> None:
    case = square()
    case.triangles[0] = (0, 1, 9)
    assert found(case, "index-out-of-range")[0]["where"] == {"triangle": 0}


def test_negative_and_huge_indices_are_out_of_range() -> None:
    case = square()
    case.triangles += [(0, 1, -1), (0, 1, 10**40)]
    witnesses = [d["witness"]["index"] for d in found(case, "index-out-of-range")]
    assert witnesses == ["-1", str(10**40)]


def test_repeated_index() -> None:
    case = square()
    case.triangles.append((0, 1, 1))
    assert kinds(case) == ["repeated-index"]


def test_duplicate_vertex() -> None:
    case = square()
    case.vertices.append(case.vertices[4])
    case.triangles = [tuple(9 if v == 4 else v for v in t) for t in case.triangles[:1]] + (
        case.triangles[1:]
    )
    assert kinds(case) == ["duplicate-vertex"]
    assert found(case, "duplicate-vertex")[0]["witness"]["first"] == 4


def test_unused_vertex() -> None:
    case = square()
    case.vertices.append(point("1/2", "1/3"))
    assert kinds(case) == ["unused-vertex"]


def test_degenerate_triangle() -> None:
    case = grid(1, 1)
    case.vertices.append(point("1/2", 0))
    case.triangles = [(0, 4, 1), (0, 1, 2), (0, 2, 3)]
    assert "degenerate-triangle" in kinds(case)


def test_clockwise_triangle() -> None:
    case = square()
    a, b, c = case.triangles[3]
    case.triangles[3] = (b, a, c)
    assert kinds(case) == ["clockwise-triangle"]
    assert found(case, "clockwise-triangle")[0]["where"] == {"triangle": 3}


def test_edge_used_twice() -> None:
    case = square()
    case.triangles.append(case.triangles[2])
    assert kinds(case) == ["edge-used-twice", "overlap"]
    assert found(case, "edge-used-twice")[0]["witness"]["triangles"] == [2, 8]


def test_hanging_vertex() -> None:
    case = Case(
        [point(0, 0), point(2, 0), point(2, 2), point(0, 2), point(1, 1)],
        [(0, 1, 2), (0, 4, 3), (4, 2, 3)],
        [[point(0, 0), point(2, 0), point(2, 2), point(0, 2)]],
    )
    assert kinds(case) == ["hanging-vertex"]
    assert found(case, "hanging-vertex")[0]["where"] == {"vertex": 4}


def test_hanging_vertex_without_a_polygon() -> None:
    case = Case(
        [point(0, 0), point(2, 0), point(2, 2), point(0, 2), point(1, 1)],
        [(0, 1, 2), (0, 4, 3), (4, 2, 3)],
    )
    assert "hanging-vertex" in kinds(case)


def star_of_david(*, with_polygon: bool) -> Case:
    up = [point(0, 0), point(6, 0), point(3, 6)]
    down = [point(3, -2), point(6, 4), point(0, 4)]
    return Case([*up, *down], [(0, 1, 2), (3, 4, 5)], [up] if with_polygon else [])


def test_crossing_edges() -> None:
    case = star_of_david(with_polygon=True)
    assert len(found(case, "crossing-edges")) == 6
    assert "overlap" in kinds(case)


def test_boundary_not_simple() -> None:
    assert "boundary-not-simple" in kinds(star_of_david(with_polygon=False))


def test_overlap() -> None:
    case = grid(3, 3)
    n = len(case.vertices)
    inner = [point("5/4", "5/4"), point("7/4", "5/4"), point("5/4", "7/4")]
    case.vertices += inner
    case.triangles.append((n, n + 1, n + 2))
    assert {"overlap"} <= set(kinds(case))
    case.rings = []
    assert kinds(case) == ["overlap"]


def test_overlap_of_two_layers_that_share_an_edge() -> None:
    case = Case(
        [point(0, 0), point(2, 0), point(1, 2), point(1, 1)],
        [(0, 1, 2), (1, 0, 3)],
    )
    assert set(kinds(case)) == {"edge-used-twice", "overlap", "clockwise-triangle"}


def test_triangle_outside() -> None:
    case = square()
    case.vertices.append(point(3, 1))
    case.triangles.append((2, 9, 8))
    assert "triangle-outside" in kinds(case)
    case.rings = []
    assert kinds(case) == ["hanging-vertex"]  # vertex 5 inside edge 2-8


def test_a_triangle_far_outside() -> None:
    case = square()
    case.vertices += [point(9, 9), point(10, 9), point(9, 10)]
    case.triangles.append((9, 10, 11))
    assert set(kinds(case)) == {"triangle-outside", "boundary-vertex-off-edge"}


def test_hole_filled() -> None:
    case = grid(3, 3)
    case.rings.append([point(1, 1), point(2, 1), point(2, 2), point(1, 2)])
    assert kinds(case) == ["hole-filled"]
    assert found(case, "hole-filled")[0]["where"] == {"polygon_edge": [1, 0]}


def test_region_not_covered() -> None:
    case = grid(3, 3, hole=True)
    case.rings.pop()
    assert {"region-not-covered"} <= set(kinds(case))
    case.rings = []
    assert both(case)["valid"]


def test_no_triangles() -> None:
    case = Case([], [], square().rings)
    assert set(kinds(case)) == {"polygon-vertex-missing", "region-not-covered"}
    assert kinds(Case([], [])) == ["region-not-covered"]


def test_boundary_vertex_off_edge() -> None:
    case = square()
    case.vertices[1] = point(1, Fraction(1, 10**30))
    assert kinds(case) == ["boundary-vertex-off-edge", "region-not-covered"]
    assert found(case, "boundary-vertex-off-edge")[0]["where"] == {"vertex": 1}
    case.vertices[1] = point(1, Fraction(-1, 10**30))
    assert kinds(case) == ["boundary-vertex-off-edge", "triangle-outside"]


def test_polygon_vertex_missing() -> None:
    case = square()
    case.rings[0].insert(1, point("1/3", 0))  # a 180-degree vertex
    assert kinds(case) == ["polygon-vertex-missing"]
    assert found(case, "polygon-vertex-missing")[0]["where"] == {"polygon_vertex": [0, 1]}


def test_angle_above_bound() -> None:
    assert kinds(square(), max_angle="90") == []
    assert len(found(square(), "angle-above-bound", max_angle="89.999999999999")) == 8


def test_height_below_bound() -> None:
    assert kinds(square(), min_height_squared="1/2") == []
    assert len(found(square(), "height-below-bound", min_height_squared="0.5000000001")) == 8


def test_too_many_triangles() -> None:
    assert kinds(square(), max_triangles=8) == []
    assert kinds(square(), max_triangles=7) == ["too-many-triangles"]


def test_the_limit_cuts_the_list_and_not_the_verdict() -> None:
    case = square()
    case.vertices += [point(9, y) for y in range(10)]
    assert len(both(case, limit=3)["defects"]) == 3
    assert both(case, limit=0) == {**both(case), "defects": []}
    case = grid(3, 3)
    del case.triangles[8]
    assert not both(case, limit=0)["valid"]


def test_rings_may_touch_in_a_vertex_without_a_polygon() -> None:
    case = grid(3, 3)
    case.triangles = [t for i, t in enumerate(case.triangles) if i // 2 not in (0, 4)]
