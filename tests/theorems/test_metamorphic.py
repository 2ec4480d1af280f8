"""What is done to the polygon and must not matter, or must show in a known way."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from gmpy2 import mpq

from bern_exact.plane.feature_size import feature_size
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems.theorem_1 import theorem_1
from tests.theorems.families import Rings, mapped, some_polygon
from tests.theorems.judged import proved

Move = Callable[[mpq, mpq], tuple[mpq, mpq]]

DRAWS = [("simple_with_holes", 3), ("nearly_right", 1), ("threshold", 20), ("star", 4)]

MOVES: dict[str, tuple[Move, mpq]] = {
    "translated": (lambda x, y: (x + mpq(10**30, 7), y - mpq(1, 3)), mpq(1)),
    "enlarged": (lambda x, y: (10**12 * x, 10**12 * y), mpq(10**24)),
    "shrunk": (lambda x, y: (x * mpq(3, 10**9), y * mpq(3, 10**9)), mpq(9, 10**18)),
    "reflected": (lambda x, y: (-x, y), mpq(1)),
    "reflected at the diagonal": (lambda x, y: (y, x), mpq(1)),
    "turned by 90 degrees": (lambda x, y: (-y, x), mpq(1)),
    "turned by 180 degrees": (lambda x, y: (-x, -y), mpq(1)),
    "turned by a 3-4-5 triangle": (
        lambda x, y: (3 * x / 5 - 4 * y / 5, 4 * x / 5 + 3 * y / 5),
        mpq(1),
    ),
}
"""What it does to a point, and to squared lengths."""

draws = pytest.mark.parametrize(("kind", "seed"), DRAWS)


def rings_of(polygon: Polygon) -> Rings:
    """The rings in input order."""
    return [list(polygon.input_ring(r)) for r in range(len(polygon.rings))]


@draws
@pytest.mark.parametrize("name", MOVES)
def test_moved_polygons(kind: str, seed: int, name: str) -> None:
    move, factor = MOVES[name]
    polygon = some_polygon(kind, seed)
    image = polygon_from_rings(mapped(rings_of(polygon), move))
    made = proved(image)
    assert made.feature.squared == factor * feature_size(polygon).squared


@draws
def test_translation_keeps_feature_size_and_unit(kind: str, seed: int) -> None:
    polygon = some_polygon(kind, seed)
    move, _ = MOVES["translated"]
    image = polygon_from_rings(mapped(rings_of(polygon), move))
    before, after = (theorem_1(each, check="none") for each in (polygon, image))
    assert before.framed.unit == after.framed.unit
    assert before.feature == after.feature
    assert before.framed.feature.squared == after.framed.feature.squared


@draws
def test_a_power_of_two_scales_the_mesh(kind: str, seed: int) -> None:
    polygon = some_polygon(kind, seed)
    image = polygon_from_rings(mapped(rings_of(polygon), lambda x, y: (x * 2**40, y * 2**40)))
    before, after = (theorem_1(each, check="none").assembled for each in (polygon, image))
    assert before.mesh.triangles == after.mesh.triangles and before.classes == after.classes
    scaled = mapped([list(before.mesh.vertices)], lambda x, y: (x * 2**40, y * 2**40))
    assert [*after.mesh.vertices] == scaled[0]


def relabelled(rings: Rings, way: str) -> Rings:
    """The same rings, written down another way."""
    if way == "other first vertices":
        return [ring[2:] + ring[:2] for ring in rings]
    if way == "other order of holes":
        return [rings[0], *rings[:0:-1]]
    if way == "other orientations":
        return [ring[::-1] for ring in rings]
    return [ring[::-1] if r % 2 else ring for r, ring in enumerate(rings)]


@pytest.mark.parametrize(
    "way",
    ["other first vertices", "other order of holes", "other orientations", "mixed orientations"],
)
@pytest.mark.parametrize(("kind", "seed"), [*DRAWS, ("inner_slit", 5), ("plate", 3)])
def test_relabelled_polygons_have_the_same_vertices(kind: str, seed: int, way: str) -> None:
    # Of equally good triangulations of a face the labels pick one; so triangles may differ.
    polygon = some_polygon(kind, seed)
    image = polygon_from_rings(relabelled(rings_of(polygon), way))
    before, after = theorem_1(polygon, check="none"), proved(image)
    assert {*after.assembled.mesh.vertices} == {*before.assembled.mesh.vertices}
    assert len(after.assembled.mesh.triangles) == len(before.assembled.mesh.triangles)
