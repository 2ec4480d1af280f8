"""The traced faces, against all faces of the whole arrangement."""

from __future__ import annotations

from bern_exact.exact.points import HPoint
from tests.boundary.naive import NaiveArrangement, area, rotated, square
from tests.boundary.samples import drawn, every_family


@every_family
def test_traced_faces_are_those_with_a_piece_of_the_boundary(kind: str, seed: int) -> None:
    traced = drawn(kind, seed).traced
    naive = NaiveArrangement(traced.diced)
    expected = {ring for ring in naive.faces() if naive.is_on_boundary(ring)}
    found = [rotated(face.ring) for face in traced.faces]
    assert set(found) == expected and len(found) == len(expected)


@every_family
def test_all_faces_together_are_the_polygon(kind: str, seed: int) -> None:
    diced = drawn(kind, seed).diced
    naive = NaiveArrangement(diced)
    areas = [area([naive.point(node) for node in ring]) for ring in naive.faces()]
    assert min(areas) > 0 and sum(areas) == diced.framed.polygon.area


@every_family
def test_touched_faces_are_those_with_a_moved_node(kind: str, seed: int) -> None:
    boundary = drawn(kind, seed).boundary
    moved = boundary.warped.moved
    naive = NaiveArrangement(boundary.warped.traced.diced)
    expected = {
        ring
        for ring in naive.faces()
        if naive.is_on_boundary(ring) or any(node in moved for node in ring)
    }
    found = [rotated(face.ring) for face in boundary.touched]
    assert set(found) == expected and len(found) == len(expected)


@every_family
def test_the_interior_is_all_other_faces(kind: str, seed: int) -> None:
    stages = drawn(kind, seed)
    naive = NaiveArrangement(stages.diced)
    touched = {rotated(face.ring) for face in stages.boundary.touched}
    rest = [ring for ring in naive.faces() if ring not in touched]
    assert all(len(ring) == 4 and not any(isinstance(v, int) for v in ring) for ring in rest)
    loops = [[naive.point(node) for node in loop] for loop in stages.interior.loops]
    assert sum(map(area, loops)) == sum(area([naive.point(v) for v in ring]) for ring in rest)


@every_family
def test_block_faces_are_those_within_a_block_beside_its_vertex(kind: str, seed: int) -> None:
    traced = drawn(kind, seed).traced
    naive = NaiveArrangement(traced.diced)
    for face in traced.faces:
        points = [naive.point(node) for node in face.ring]
        edges = {traced.diced.crossings[v - naive.n].edge for v in face.ring if _is_q(v, naive.n)}
        edges |= {v for v in face.ring if isinstance(v, int) and v < naive.n}
        homes = [
            v
            for v in range(naive.n)
            if edges & {v, naive.polygon.before[v]}
            and _is_in_block(points, naive.polygon.points[v])
        ]
        assert [face.block] == (homes or [-1])


def _is_q(node: object, n: int) -> bool:
    return isinstance(node, int) and node >= n


def _is_in_block(points: list[HPoint], v: HPoint) -> bool:
    x, y = square(v)
    return all(
        (x - 1) * w <= u <= (x + 2) * w and (y - 1) * w <= t <= (y + 2) * w for u, t, w in points
    )
