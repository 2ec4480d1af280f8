"""What the paper says of its examples, shown on them."""

from __future__ import annotations

from itertools import pairwise

import pytest
from gmpy2 import mpq

from bern_exact.checkers import bounds
from bern_exact.checkers.as_printed import triangulations
from bern_exact.checkers.definition_2 import check_definition_2
from bern_exact.checkers.findings import demand
from bern_exact.corpus.paper import (
    fewest_partition_vertices,
    hole_grid,
    hole_grid_region,
    in_lattice_units,
    regular_polygon,
    spanning_tree_length,
    thin_rectangle,
)
from bern_exact.corpus.paper_graphs import (
    accordion,
    accordion_mesh,
    descents,
    dilemma,
    triangle_on_rectangle,
)
from bern_exact.exact.angles import ANGLE_135, ANGLE_150, Angle, largest_angle
from bern_exact.exact.enclosures import cos_degrees_bounds
from bern_exact.exact.points import HPoint, grid_point, hpoint
from bern_exact.exact.predicates import squared_distance, squared_height
from bern_exact.interior.subdivided.strips import strips
from bern_exact.oracle.fast import verify_mesh
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.plane_graph import PlaneGraph
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems.theorem_1 import theorem_1
from bern_exact.view.graph import draw_graph


def polygon(rings: list[list[tuple[int, int]]]) -> Polygon:
    return polygon_from_rings([[grid_point(*p) for p in ring] for ring in rings])


def best_without_steiner_points(ring: tuple[HPoint, ...]) -> mpq:
    """The greatest least squared height of a triangulation by the ring's own vertices."""
    return max(
        min(squared_height(*triangle) for triangle in triangles)
        for triangles in triangulations(ring)
    )


@pytest.mark.parametrize("n", range(4, 9))
def test_a_regular_polygon_needs_an_ear(n: int) -> None:
    """The best height without Steiner points is s sin(pi/n)."""
    ring = tuple(grid_point(*p) for p in regular_polygon(n)[0])
    side = squared_distance(ring[0], ring[1])
    low, high = cos_degrees_bounds(mpq(90) - mpq(180, n), 60)
    best = best_without_steiner_points(ring) / side
    assert low**2 * (1 - mpq(1, 2**30)) <= best <= high**2 * (1 + mpq(1, 2**30))


@pytest.mark.parametrize("n", [6, 40, 400])
def test_a_point_at_the_centre_of_a_regular_polygon_is_enough(n: int) -> None:
    """Then the height is about s: at least 85 % of it."""
    ring = [grid_point(*p) for p in regular_polygon(n)[0]]
    centre = grid_point(0, 0)
    side = squared_distance(ring[0], ring[1])
    heights = [squared_height(p, q, centre) for p, q in pairwise([*ring, ring[0]])]
    assert min(heights) > side * mpq(85, 100) ** 2


@pytest.mark.parametrize("k", [2, 5, 100])
def test_the_thin_rectangle_without_steiner_points(k: int) -> None:
    ring = tuple(grid_point(*p) for p in thin_rectangle(k)[0])
    assert best_without_steiner_points(ring) <= mpq(1, k * k + 1)


@pytest.mark.parametrize("k", [10**3, 10**6])
def test_the_thin_rectangle_with_steiner_points(k: int) -> None:
    """Theorem 1's height depends on s alone."""
    made = theorem_1(polygon(thin_rectangle(k)))
    assert made.feature.squared == 1
    verdict = verify_mesh(made.assembled.mesh, made.polygon)
    assert verdict.min_height_squared is not None
    assert verdict.min_height_squared >= bounds.theorem_1_height_squared()
    assert len(made.assembled.mesh.triangles) < 200


@pytest.mark.parametrize("side", [1, 2, 5])
def test_the_grid_of_holes(side: int) -> None:
    """n vertices, no two holes on a line, the matching condition."""
    made = polygon(hole_grid(side))
    assert made.holes == side * side
    region = hole_grid_region(side)
    assert region.edges == 12 * side * side + 4
    demand(check_definition_2(region))
    corners = [loop[0] for loop in region.loops[1:]]
    assert len({x for x, _ in corners}) == len({y for _, y in corners}) == side * side


@pytest.mark.parametrize("side", [2, 4, 8])
def test_the_spanning_tree_of_the_holes_has_length_n_to_the_three_halves(side: int) -> None:
    region = hole_grid_region(side)
    holes = [loop[0] for loop in region.loops[1:]]
    # In units of 4 each hole is side + 1 from its neighbour in the row and in the column.
    assert spanning_tree_length(holes) == 4 * (side * side - 1) * (side + 1)
    # In lattice units distances are no shorter than in these.
    lattice = spanning_tree_length(in_lattice_units(holes, region))
    assert lattice >= (side * side - 1) * (side + 1)


@pytest.mark.parametrize("side", [2, 4, 8])
def test_partitions_of_the_grid_of_holes_are_large(side: int) -> None:
    """Lemma 8's partition lies between the lower bound and 2 N + N^1.5."""
    region = hole_grid_region(side)
    rectangles = strips(region).rectangles
    vertices = {p for rectangle in rectangles for p in rectangle.ring()}
    assert fewest_partition_vertices(side) <= len(vertices)
    beyond = max(0, len(vertices) - 2 * region.edges)
    assert beyond**2 <= region.edges**3


def angles(mesh: Mesh) -> Angle:
    at = mesh.vertices
    found = [largest_angle(at[a], at[b], at[c])[0] for a, b, c in mesh.triangles]
    return min(found, key=lambda angle: angle.signed_square)


@pytest.mark.parametrize("n", [1, 2, 7])
def test_the_accordion_forces_n_squared_vertices(n: int) -> None:
    """A triangulation of bounded angle has n separate paths through n layers."""
    stack = accordion(n)
    mesh = accordion_mesh(stack)
    assert verify_mesh(mesh, None).valid
    assert angles(mesh).is_at_most(ANGLE_135)
    edges = {frozenset(pair) for a, b, c in mesh.triangles for pair in ((a, b), (b, c), (c, a))}
    found = descents(stack, mesh)
    assert found.separate
    assert found.vertices == n * (n + 1) == n * (stack.layers + 1)
    assert all(frozenset(edge) in edges for edge in stack.graph.edges[-n:])


def test_the_accordion_without_steiner_points_has_merging_paths_and_large_angles() -> None:
    n = 6
    stack = accordion(n)
    z = stack.zigzag
    fan = [(z[2], b, a) for b, a in pairwise((z[0], *stack.top, z[1]))]
    others = [
        (z[i], z[i + 2], z[i + 1]) if i % 2 == 0 else (z[i + 2], z[i], z[i + 1])
        for i in range(1, n)
    ]
    mesh = Mesh(stack.graph.points, (*fan, *others))
    mesh = Mesh(mesh.vertices, tuple(counter_clockwise(mesh)))
    assert verify_mesh(mesh, None).valid
    assert not descents(stack, mesh).separate
    assert not angles(mesh).is_at_most(ANGLE_150)


def counter_clockwise(mesh: Mesh) -> list[tuple[int, int, int]]:
    at = mesh.coordinates
    turned = []
    for a, b, c in mesh.triangles:
        (ax, ay), (bx, by), (cx, cy) = at[a], at[b], at[c]
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        turned.append((a, b, c) if area > 0 else (a, c, b))
    return turned


K = 50
NOTHING, ON_TOP, INSIDE = "nothing", "on top", "inside"


def triangulated(graph: PlaneGraph, where: str) -> Mesh:
    """The graph with no Steiner point, with one at (k, 1) or with one at (k, 1/2)."""
    new = {NOTHING: [], ON_TOP: [hpoint(mpq(K), mpq(1))], INSIDE: [hpoint(mpq(K), mpq(1, 2))]}
    triangles = {
        NOTHING: [(0, 1, 5), (1, 2, 5), (2, 3, 4), (2, 4, 5), (5, 4, 6)],
        ON_TOP: [(0, 1, 7), (1, 2, 7), (2, 3, 4), (2, 4, 7), (0, 7, 5), (5, 7, 6), (7, 4, 6)],
        INSIDE: [(0, 1, 7), (1, 2, 7), (2, 3, 4), (2, 4, 7), (0, 7, 5), (7, 4, 5), (5, 4, 6)],
    }
    return Mesh((*graph.points, *new[where]), tuple(triangles[where]))


def test_the_triangle_on_a_rectangle_forces_a_large_angle_or_a_small_height() -> None:
    graph = triangle_on_rectangle(K)
    found = {}
    for where in (NOTHING, ON_TOP, INSIDE):
        mesh = triangulated(graph, where)
        assert verify_mesh(mesh, None).valid
        found[where] = dilemma(graph, mesh)
    assert found[NOTHING].least_height_squared <= mpq(1, K * K)
    assert found[ON_TOP].on_top == 1
    assert found[ON_TOP].least_height_squared <= mpq(1, K * K)
    # A good height at the subdivision points, with an angle almost 180.
    assert found[INSIDE].on_top == 0
    assert found[INSIDE].least_height_squared > mpq(4, K * K)
    assert found[INSIDE].largest.signed_square < mpq(-99, 100)


def test_the_graphs_are_drawn() -> None:
    for graph in (accordion(5).graph, triangle_on_rectangle(5)):
        picture = draw_graph(graph, stretch=50)
        assert picture.startswith("<svg") and picture == draw_graph(graph, stretch=50)
        assert f"{len(graph.edges)} edges" in picture
