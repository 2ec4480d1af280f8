"""Lemma 5: merged faces cut up by diagonals, without large angles."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from gmpy2 import mpq

from bern_exact.boundary.records import MergedMesh, Node, Projected
from bern_exact.checkers import bounds
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.lemma_2 import NodeTriangle, check_lemma_2, tiles
from bern_exact.checkers.lemma_4 import level
from bern_exact.checkers.places import cotangents, squared_height, squared_length
from bern_exact.checkers.rings import Ring, cancelled, places_of
from bern_exact.exact.predicates import side

STAGE = "merged"

TRAPEZOID = 4
"""Sides of a piece between two diagonals from neighbouring staircase vertices."""


def check_lemma_5(mesh: MergedMesh, *, tau: mpq = bounds.TAU) -> list[Finding]:
    """Check Lemma 5 (height at the end faces repaired), and Lemma 2 for the blocks.

    Parameters
    ----------
    mesh : MergedMesh
        The merged faces, cut up and triangulated.
    tau : mpq
        The snapping threshold in grid units.

    Returns
    -------
    list of Finding
        Those of `check_lemma_2` for the faces that are not merged, then Lemma 5's own.

    Notes
    -----
    An angle is compared by its cotangent, which is rational and falls as the angle grows.
    Linear time, but for hashing.
    """
    return [
        *check_lemma_2(mesh, tau=tau),
        _check_projections(mesh),
        *_check_pieces(mesh),
        _check_angle(mesh, tau),
        _check_height(mesh, tau),
        _check_base(mesh, tau),
    ]


def _check_projections(mesh: MergedMesh) -> Finding:
    """Each diagonal runs from a staircase vertex along a line of t to its own point of e."""
    polygon, places = mesh.warped.traced.diced.framed.polygon, places_of(mesh)
    fresh = polygon.n + len(mesh.warped.points)
    broken = Violations()
    used: list[Node] = []
    for item in mesh.projected:
        line, base = polygon.lines[item.merged.edge], item.merged.base
        ends = (base[0], *(foot for _, foot in item.cuts), base[-1])
        used += ends[1:-1]
        levels = [level(line, places[node]) for node in ends]
        sense = levels[-1] - levels[0]
        inside = all((after - before) * sense > 0 for before, after in pairwise(levels))
        inner = iter(item.merged.staircase[1:-1])
        fits = inside and all(
            apex in inner  # in this order: the iterator moves on
            and side(line, places[foot]) == 0
            and level(line, places[apex]) == level(line, places[foot])
            for apex, foot in item.cuts
        )
        broken.case(fits, (item.merged.edge, ends))
    expected = list(range(fresh, fresh + len(mesh.projections)))
    if sorted(used, key=str) != sorted(expected, key=str):
        broken.broken(("projections not used once each", ()))
    return broken.finding(
        "lemma-5.projections",
        STAGE,
        "Steiner points are added on edges alone: each is the projection, along a diagonal, of one "
        "inner staircase vertex strictly between the ends of the base, in order along e",
        describe=places.describe,
    )


def _check_pieces(mesh: MergedMesh) -> list[Finding]:
    """The diagonals cut M into end faces and trapezoids, each tiled by its triangles."""
    places = places_of(mesh)
    fitting, untiled, trapezoids = Violations(), Violations(), Violations()
    for item in mesh.projected:
        edge, rings = item.merged.edge, [ring for ring, _ in item.pieces]
        left = cancelled(rings, fitting)
        fits = left.keys() == _outline(item) and len(rings) == len(item.cuts) + 1
        fitting.case(fits, (edge, item.merged.staircase))
        for ring, triangles in item.pieces:
            untiled.case(tiles(ring, triangles), (edge, ring))
        position = {node: i for i, node in enumerate(item.merged.staircase)}
        for ring, first, second in zip(rings[1:-1], item.cuts, item.cuts[1:], strict=False):
            if position.get(second[0], -1) == position.get(first[0], -1) + 1:
                fits = len(ring) == TRAPEZOID and {*first, *second} == {*ring}
                trapezoids.case(fits, (edge, ring))
    return [
        fitting.finding(
            "lemma-5.pieces",
            STAGE,
            "the diagonals cut each merged face into pieces that fit together to it",
            describe=places.describe,
        ),
        untiled.finding(
            "lemma-5.tiles",
            STAGE,
            "the triangles of each piece of a merged face fit together to the piece",
            describe=places.describe,
        ),
        trapezoids.finding(
            "lemma-5.trapezoids",
            STAGE,
            "every piece between diagonals from neighbouring staircase vertices is a trapezoid of "
            "which they are two sides",
            describe=places.describe,
        ),
    ]


def _outline(item: Projected) -> set[tuple[Node, Node]]:
    """The directed edges round M, with the projections on its base instead of the base nodes."""
    base, stairs = item.merged.base, item.merged.staircase
    ring: Ring = (base[0], *(foot for _, foot in item.cuts), base[-1], *stairs[-2:0:-1])
    return {(ring[i - 1], node) for i, node in enumerate(ring)}


def _outside_blocks(mesh: MergedMesh) -> Iterator[tuple[int, NodeTriangle]]:
    """The triangles outside blocks, each with its edge of P' (-1: of a face that is not merged)."""
    for item in mesh.projected:
        for _, triangles in item.pieces:
            for triangle in triangles:
                yield item.merged.edge, triangle
    for face in mesh.faces:
        if face.block < 0:
            for triangle in face.triangles:
                yield -1, triangle


def _check_angle(mesh: MergedMesh, tau: mpq) -> Finding:
    """No angle outside the blocks above 135 degrees + arctan(2 tau)."""
    places, largest = places_of(mesh), Extreme()
    for edge, triangle in _outside_blocks(mesh):
        p, q, r = triangle
        for num, den in cotangents(places[p], places[q], places[r]):
            largest.offer(num, den, (edge, triangle))
    return largest.finding(
        "lemma-5.angle",
        STAGE,
        "no angle outside the blocks is above 135 degrees + arctan(2 tau), which is below 150 "
        "(least cotangent)",
        bounds.boundary_cotangent(tau),
        describe=places.describe,
    )


def _check_height(mesh: MergedMesh, tau: mpq) -> Finding:
    """Every triangle of a merged face."""
    places, least = places_of(mesh), Extreme()
    for edge, triangle in _outside_blocks(mesh):
        if edge >= 0:
            p, q, r = triangle
            least.offer(*squared_height(places[p], places[q], places[r]), (edge, triangle))
    return least.finding(
        "lemma-5.height",
        STAGE,
        "every triangle of a merged face has height at least tau/2 (squared, in b^2)",
        bounds.merged_height_squared(tau),
        describe=places.describe,
    )


def _check_base(mesh: MergedMesh, tau: mpq) -> Finding:
    """The pieces into which projections cut the bases; fans over a cut stand on them."""
    places, shortest = places_of(mesh), Extreme()
    for item in mesh.projected:
        base = item.merged.base
        for a, b in pairwise((base[0], *(foot for _, foot in item.cuts), base[-1])):
            shortest.offer(*squared_length(places[a], places[b]), (item.merged.edge, (a, b)))
    return shortest.finding(
        "lemma-5.base",
        STAGE,
        "projections cut the base of a merged face into pieces at least tau/sqrt(2) long "
        "(squared, in b^2)",
        bounds.base_piece_squared(tau),
        describe=places.describe,
    )
