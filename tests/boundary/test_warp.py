"""Warping: every move by the rules, written down once more from the records alone."""

from __future__ import annotations

from collections import Counter, defaultdict

from gmpy2 import mpq

from bern_exact.boundary.records import HORIZONTAL, VERTICAL, Crossing, Node, Warped
from bern_exact.exact.points import grid_point
from bern_exact.exact.predicates import is_in_wedge, orientation
from bern_exact.plane.validation import polygon_from_rings
from tests.boundary.naive import at, square
from tests.boundary.samples import Stages, drawn, every_family, stages_of
from tests.plane.by_definition import inside
from tests.theorems.families import ring

TAU = mpq(1, 8)

Moved = dict[tuple[int, int], int]
Instances = dict[tuple[int, int, int], int]


def distance(q: Crossing, node: tuple[int, int]) -> mpq:
    """From a q-vertex to a grid vertex on its line."""
    return abs(q.at - (node[1] if q.axis == VERTICAL else node[0]))


def anchor_of(warped: Warped, j: int) -> tuple[int, int, int]:
    """The exterior instance that a q-vertex may choose."""
    return (warped.traced.diced.crossings[j].edge, *warped.traced.anchors[j])


def first_moves(warped: Warped) -> tuple[Moved, Instances]:
    """What moves in substep 1, interior grid vertices and instances, from the corners alone."""
    polygon = warped.traced.diced.framed.polygon
    moved, instances = {}, {}
    for v, corner in enumerate(warped.corners):
        before, after = polygon.before[v], polygon.after[v]
        points = polygon.points
        if is_in_wedge(grid_point(*corner), points[before], points[v], points[after]):
            moved[corner] = v
        instances[(before, *corner)] = instances[(v, *corner)] = v
    return moved, instances


def choices(warped: Warped) -> dict[int, tuple[int, ...]]:
    """Who chooses what in substep 2."""
    moved, instances = first_moves(warped)
    found = {}
    for j, q in enumerate(warped.traced.diced.crossings):
        g, anchor = warped.traced.inner[j], anchor_of(warped, j)
        if g in moved or anchor in instances:
            continue
        if g is not None and distance(q, g) < TAU:
            found[j] = g
        elif distance(q, anchor[1:]) < TAU:
            found[j] = anchor
    return found


@every_family
def test_a_corner_of_its_own_square_for_each_vertex(kind: str, seed: int) -> None:
    warped = drawn(kind, seed).warped
    for p, corner in zip(warped.traced.diced.framed.polygon.points, warped.corners, strict=True):
        x, y = square(p)
        assert corner[0] - x in (0, 1) and corner[1] - y in (0, 1)


@every_family
def test_q_vertices_choose_by_distance(kind: str, seed: int) -> None:
    warped = drawn(kind, seed).warped
    assert warped.choices == choices(warped)


@every_family
def test_everything_moves_to_its_vertex_or_nearest_chooser(kind: str, seed: int) -> None:
    warped = drawn(kind, seed).warped
    crossings = warped.traced.diced.crossings
    n = warped.traced.diced.framed.polygon.n
    moved, instances = first_moves(warped)
    wanted = defaultdict(list)
    for j, place in choices(warped).items():
        q = crossings[j]
        wanted[place].append((distance(q, place[-2:]), q.axis != HORIZONTAL, j))
    for place, choosers in wanted.items():
        (moved if len(place) == 2 else instances)[place] = n + min(choosers)[2]
    assert warped.moved == moved
    assert warped.instances == instances


class Fates:
    """Step by step: where each q-vertex ends, by the first rule that matches."""

    def __init__(self, warped: Warped) -> None:
        self.warped = warped
        self.diced = warped.traced.diced
        self.polygon = self.diced.framed.polygon
        self.n = self.polygon.n

    def image(self, node: Node) -> Node:
        """The final node of a vertex, a grid vertex that moves, or a q-vertex."""
        if isinstance(node, tuple):
            return self.image(self.warped.moved[node]) if node in self.warped.moved else node
        return node if node < self.n else self.fate(node - self.n)

    def instance(self, place: tuple[int, int, int]) -> Node:
        """Where an instance moves; its own grid vertex if it does not."""
        return self.warped.instances.get(place, place[1:])

    def is_on(self, node: Node, edge: int) -> bool:
        """Is a node an end of this edge or a q-vertex on it?"""
        if isinstance(node, tuple):
            return False
        if node < self.n:
            return node in (edge, self.polygon.after[edge])
        return self.diced.crossings[node - self.n].edge == edge

    def inner(self, j: int) -> Node:
        """What the segment through q starts from: g, or the far q-vertex's anchor, moved."""
        g = self.warped.traced.inner[j]
        if g is not None:
            return self.warped.moved.get(g, g)
        q = self.diced.crossings[j]
        far = self.diced.crossing_at[q.axis, q.line, q.far]
        return self.instance(anchor_of(self.warped, far))

    def fate(self, j: int) -> Node:
        q, inner = self.diced.crossings[j], self.inner(j)
        has_grid = self.warped.traced.inner[j] is not None
        if self.is_on(inner, q.edge) and (has_grid or inner < self.n):
            return self.n + j if inner == self.n + j else self.image(inner)
        outer = self.instance(anchor_of(self.warped, j))
        if isinstance(outer, tuple) or outer == self.n + j:
            return self.n + j
        return self.image(outer)


@every_family
def test_q_vertices_end_by_the_first_rule_that_matches(kind: str, seed: int) -> None:
    warped = drawn(kind, seed).warped
    fates = Fates(warped)
    assert warped.image == tuple(fates.fate(j) for j in range(len(warped.image)))


@every_family
def test_q_vertices_slide_towards_fixed_anchors(kind: str, seed: int) -> None:
    warped = drawn(kind, seed).warped
    fates = Fates(warped)
    for j, (image, point) in enumerate(zip(warped.image, warped.points, strict=True)):
        q = fates.diced.crossings[j]
        if image != fates.n + j:
            assert point == warped.point_of(image)
            continue
        tail, head = q.edge, fates.polygon.after[q.edge]
        assert inside(point, fates.polygon.points[tail], fates.polygon.points[head])
        anchor, inner = anchor_of(warped, j), fates.inner(j)
        if anchor in warped.instances or inner == fates.n + j:
            assert point == at(q.axis, q.line, q.at)
        else:
            start = warped.point_of(inner)
            assert orientation(start, point, grid_point(*anchor[1:])) == 0


@every_family
def test_images_are_final(kind: str, seed: int) -> None:
    warped = drawn(kind, seed).warped
    assert all(warped.image_of(image) == image for image in warped.image)


@every_family
def test_nodes_stay_in_order_along_each_edge(kind: str, seed: int) -> None:
    warped = drawn(kind, seed).warped
    polygon = warped.traced.diced.framed.polygon
    for edge, found in enumerate(warped.traced.diced.on_edge):
        ends = [warped.point_of(edge), *(warped.points[j] for j in found)]
        ends.append(polygon.points[polygon.after[edge]])
        different = [p for i, p in enumerate(ends) if i == 0 or p != ends[i - 1]]
        assert all(
            inside(q, p, r)
            for p, q, r in zip(different, different[1:], different[2:], strict=False)
        )


def tips_in_one_square() -> Stages:
    """Two tips a hair apart across an exterior slit, in the middle of a grid square."""
    gap = mpq(1, 10**6)
    outer = [(0, 0), (12, 0), (8, 5 - gap), (3, 3), (3, 7), (8, 5 + gap), (12, 10), (0, 10)]
    found = (
        stages_of(polygon_from_rings([ring([(x + mpq(k, 20), y) for x, y in outer])]))
        for k in range(20)
    )
    return next(each for each in found if shared_squares(each))


def shared_squares(stages: Stages) -> list[tuple[int, int]]:
    """The grid squares that hold more than one vertex of P'."""
    counts = Counter(square(p) for p in stages.framed.polygon.points)
    return [place for place, times in counts.items() if times > 1]


def test_two_tips_may_share_a_square_and_take_corners_of_their_own() -> None:
    stages = tips_in_one_square()
    polygon, warped = stages.framed.polygon, stages.warped
    (place,) = shared_squares(stages)
    tips = [v for v, p in enumerate(polygon.points) if square(p) == place]
    for v in tips:
        for edge in (v, polygon.before[v]):
            assert warped.instances[(edge, *warped.corners[v])] == v
        for other in tips:
            if other != v:  # the other sheet does not see this one's instances
                assert not {v, polygon.before[v]} & {other, polygon.before[other]}


def test_one_grid_vertex_has_an_instance_for_each_edge() -> None:
    # Across a thin slit both walls see the same grid vertices from outside.
    targets = defaultdict(set)
    stages = drawn("folded_slit", 3)
    for (_, k, line), target in stages.warped.instances.items():
        targets[k, line].add(target)
    assert any(len(found) > 1 for found in targets.values())
