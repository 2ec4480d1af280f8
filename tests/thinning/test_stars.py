"""Stars: rings of vertices, and what is left when one goes."""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.exact.points import hpoint
from bern_exact.thinning.stars import Stars
from tests.thinning.samples import SQUARE, wheel

# A vertex in the middle of the lower edge, joined to all corners.
MIDDLE = (*SQUARE.points, hpoint(2, 0))
FAN = [(4, 1, 2), (4, 2, 3), (4, 3, 0)]


def test_the_ring_of_an_inner_vertex_begins_at_its_least() -> None:
    polygon, mesh = wheel(8)
    shuffled = mesh.triangles[5:] + mesh.triangles[:5]
    assert Stars(mesh.vertices, shuffled).ring(polygon.n) == list(range(8))


def test_the_ring_of_a_vertex_on_an_edge_is_closed_by_the_edge() -> None:
    assert Stars(MIDDLE, FAN).ring(4) == [0, 1, 2, 3]


def test_a_corner_of_the_boundary_has_no_ring() -> None:
    bent = (*SQUARE.points, hpoint(2, 1))
    assert Stars(bent, FAN).ring(4) is None
    assert Stars(MIDDLE, FAN).ring(0) is None


def test_a_vertex_without_triangles_has_no_ring() -> None:
    assert Stars(SQUARE.points, []).ring(0) is None


def test_a_star_in_two_pieces_has_no_ring() -> None:
    points = [hpoint(x, y) for x, y in ((0, 0), (2, 1), (2, -1), (-2, 1), (-2, -1))]
    assert Stars(points, [(0, 2, 1), (0, 3, 4)]).ring(0) is None
    assert Stars([*points, *points[1:]], [(0, 2, 1), (0, 3, 4), (0, 6, 5)]).ring(0) is None


def test_replacing_a_star_leaves_the_other_triangles() -> None:
    stars = Stars(MIDDLE, FAN)
    stars.replace([4], [(0, 1, 2), (0, 2, 3)])
    assert stars.triangles() == [(0, 1, 2), (0, 2, 3)]
    assert [stars.degree(v) for v in range(5)] == [2, 1, 2, 1, 0]


# Two inner vertices of a square, joined to each other and to the corners.
PAIR = (*SQUARE.points, hpoint(1, 2), hpoint(3, 2))
BOTH = [(0, 1, 4), (1, 5, 4), (1, 2, 5), (2, 4, 5), (2, 3, 4), (3, 0, 4)]


def test_neighbours_leave_one_hole() -> None:
    stars = Stars(PAIR, BOTH)
    assert stars.groups(5, 2, 4) == [(4, 5)] == stars.groups(4, 2, 4)
    assert stars.groups(4, 2, 5) == [(4, 5)] and stars.groups(4, 3, 4) == []
    assert stars.ring(4, 5) == [0, 1, 2, 3]
    assert stars.around((4, 5)) == set(Stars(PAIR, BOTH).triangles())
    stars.replace((4, 5), [(0, 1, 2), (0, 2, 3)])
    assert stars.triangles() == [(0, 1, 2), (0, 2, 3)]


def test_neighbours_on_an_edge_leave_a_hole_closed_by_it() -> None:
    points = (*SQUARE.points, hpoint(1, 0), hpoint(3, 0))
    fan = [(0, 4, 3), (4, 5, 3), (5, 2, 3), (5, 1, 2)]
    assert Stars(points, fan).ring(4, 5) == [0, 1, 2, 3]


def test_a_group_round_a_hole_of_the_mesh_has_no_ring() -> None:
    # A square ring of eight triangles; its four inner corners go round the hole.
    inner = [hpoint(x, y) for x, y in ((1, 1), (3, 1), (3, 3), (1, 3))]
    ring = [(i, (i + 1) % 4, 4 + i) for i in range(4)]
    ring += [((i + 1) % 4, 4 + (i + 1) % 4, 4 + i) for i in range(4)]
    stars = Stars((*SQUARE.points, *inner), ring)
    assert stars.ring(4, 5, 6, 7) is None and stars.ring(4, 5) is None


def test_a_group_that_is_all_of_the_mesh_has_no_ring() -> None:
    assert Stars(SQUARE.points, [(0, 1, 2), (0, 2, 3)]).ring(0, 1, 2, 3) is None


def test_the_largest_angle_by_its_cotangent() -> None:
    assert Stars(PAIR, BOTH).cotangent((2, 4, 5)) == mpq(-1, 2)
