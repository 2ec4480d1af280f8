"""The block program of the proof is the package's: same faces, for every corner."""

from __future__ import annotations

from random import Random

import pytest
from gmpy2 import mpq

from bern_exact.boundary.blocks import square_of
from bern_exact.boundary.corners import TAU, CornerRule
from bern_exact.boundary.faces import trace
from bern_exact.corpus.over_the_grid import around, moved_back
from bern_exact.exact.points import HPoint, direction
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings
from proofs.lemma_2.block import DOWN, LEFT, RIGHT, UP, block
from proofs.lemma_2.exact import (
    Configuration,
    Vector,
    configuration,
    place,
    type_of,
    unturned,
)
from proofs.lemma_2.rays import E, F, ray_types
from proofs.lemma_2.warping import outcomes
from tests.boundary.samples import diced, drawn
from tests.proofs.lemma_2.configurations import directions, some_configuration

CLASSES = (UP, LEFT, DOWN, RIGHT)

Faces = frozenset[tuple[Vector, ...]]


def from_least(points: list[Vector]) -> tuple[Vector, ...]:
    i = points.index(min(points))
    return (*points[i:], *points[:i])


def is_whole_square(face: tuple[Vector, ...]) -> bool:
    return all(c.denominator == 1 for p in face for c in p)


def rays_of(polygon: Polygon, v: int) -> tuple[Vector, Vector, Vector]:
    """v, relative to its square, and the directions of its edges."""
    p = polygon.points[v]
    square = square_of(p)
    x, y = (mpq(part, p[2]) - low for part, low in zip(p[:2], square, strict=True))
    out, into = (direction(p, polygon.points[w]) for w in (polygon.after[v], polygon.before[v]))
    return (x, y), (mpq(out[0]), mpq(out[1])), (mpq(into[0]), mpq(into[1]))


def moved_to(c: Configuration, low: tuple[int, int], p: HPoint) -> Vector:
    """A point in the frame in which e goes up."""
    return unturned(c.quarters, (mpq(p[0], p[2]) - low[0], mpq(p[1], p[2]) - low[1]))


def by_the_proof(c: Configuration, corner: Vector, tau: mpq = TAU) -> list[Faces]:
    """The faces that the block program leaves: one set for each outcome."""
    made = block(c.cls, type_of(c, E, tau), type_of(c, F, tau))
    assert made is not None
    k, level = unturned(c.quarters, corner)
    return [
        frozenset(from_least([place(c, point) for point in ring]) for ring in found.rings)
        for found in outcomes(made, (int(k), int(level)))
    ]


def agreements(polygon: Polygon, tau: mpq = TAU) -> int:
    """How many corners of vertices agree; fails at the first that does not."""
    traced, tracer = trace(diced(polygon))
    rule = CornerRule(traced, tracer, tau)
    framed = traced.diced.framed.polygon
    count = 0
    for v in range(framed.n):
        low = square_of(framed.points[v])
        c = configuration(*rays_of(framed, v))
        for candidate in rule._candidates(v):
            k, level = candidate.corner
            faces = frozenset(
                face
                for points in rule._block_faces_with(v, candidate)
                for face in [from_least([moved_to(c, low, p) for p in points])]
                if not is_whole_square(face)
            )
            assert faces in by_the_proof(c, (mpq(k - low[0]), mpq(level - low[1])), tau)
            count += 1
    return count


@pytest.mark.parametrize("cls", CLASSES)
def test_it_is_the_packages_on_random_and_threshold_inputs(cls: int) -> None:
    random = Random(f"blocks {cls}")
    for _ in range(12):
        c = some_configuration(random, cls)
        polygon = polygon_from_rings([moved_back(around(c.v, *directions(c)))])
        assert agreements(polygon) == 4 * len(diced(polygon).framed.polygon.points)


@pytest.mark.parametrize(("kind", "seed"), [("threshold", 20), ("threshold", 555), ("plate", 0)])
def test_it_is_the_packages_on_whole_polygons(kind: str, seed: int) -> None:
    assert agreements(drawn(kind, seed).polygon) > 0


@pytest.mark.parametrize("tau", [mpq(1, 10), mpq(1, 16)])
def test_it_is_the_packages_for_other_thresholds(tau: mpq) -> None:
    assert agreements(drawn("threshold", 20).polygon, tau) > 0
    random = Random(f"blocks {tau}")
    for _ in range(3):
        c = some_configuration(random, random.choice(CLASSES))
        polygon = polygon_from_rings([moved_back(around(c.v, *directions(c)))])
        assert agreements(polygon, tau) > 0


@pytest.mark.parametrize("cls", CLASSES)
def test_no_two_rays_are_forgotten(cls: int) -> None:
    random = Random(f"types {cls}")
    kinds = set(ray_types())
    for _ in range(1000):
        c = some_configuration(random, cls)
        kind_e, kind_f = (type_of(c, ray, TAU) for ray in (E, F))
        assert {kind_e, kind_f} <= kinds
        assert block(cls, kind_e, kind_f) is not None


@pytest.mark.parametrize("cls", CLASSES)
def test_a_mirror_image_has_the_mirrored_faces(cls: int) -> None:
    random = Random(f"mirror {cls}")
    for _ in range(40):
        c = some_configuration(random, cls)
        image = Configuration(mirrored(cls, c.v), (-c.slopes[1], -c.slopes[0]), cls, 0)
        for corner in ((0, 0), (0, 1), (1, 0), (1, 1)):
            here = by_the_proof(c, (mpq(corner[0]), mpq(corner[1])))
            there = by_the_proof(image, mirrored(cls, (mpq(corner[0]), mpq(corner[1]))))
            assert {
                frozenset(from_least([mirrored(cls, p) for p in face[::-1]]) for face in faces)
                for faces in here
            } == set(there)


def mirrored(cls: int, p: Vector) -> Vector:
    """The reflection that exchanges the directions of e and f."""
    x, y = p
    return {UP: (1 - x, y), LEFT: (1 - y, 1 - x), DOWN: (x, 1 - y), RIGHT: (y, x)}[cls]


@pytest.mark.parametrize(("kind", "seed"), [("threshold", 24), ("maze", 0), ("star", 1)])
def test_blocks_do_not_interact(kind: str, seed: int) -> None:
    stages = drawn(kind, seed)
    framed = stages.framed.polygon
    by_vertex: dict[int, set[tuple[Vector, ...]]] = {v: set() for v in range(framed.n)}
    for face in stages.boundary.faces:
        if face.block >= 0:
            c = configuration(*rays_of(framed, face.block))
            low = square_of(framed.points[face.block])
            points = [stages.warped.point_of(node) for node in face.ring]
            ring = from_least([moved_to(c, low, p) for p in points])
            if not is_whole_square(ring):
                by_vertex[face.block].add(ring)
    for v, faces in by_vertex.items():
        c, low = configuration(*rays_of(framed, v)), square_of(framed.points[v])
        k, level = stages.warped.corners[v]
        assert faces in by_the_proof(c, (mpq(k - low[0]), mpq(level - low[1])))
