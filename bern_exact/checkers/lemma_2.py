"""Lemma 2: triangles near the boundary, angles within the blocks."""

from __future__ import annotations

from collections.abc import Sequence

from gmpy2 import mpq

from bern_exact.boundary.records import BlockShape, Node, WarpedFace
from bern_exact.checkers import bounds, bounds_blocks
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.places import Places, cotangents, squared_height, squared_length
from bern_exact.checkers.rings import NearBoundary, places_of

STAGE = "boundary"

BLOCK_ANGLE: dict[BlockShape, str] = {
    "square": "no angle in a block is above 135 degrees, with the repaired choice of corner "
    "(least cotangent)",
    "corner": "no angle in a block is above 135 degrees + arctan(2 tau), the bound of Theorems 2 "
    "and 3: blocks of four squares are experimental (least cotangent)",
}

BLOCK_HEIGHT: dict[BlockShape, str] = {
    "square": "every triangle in a block has height at least tau/sqrt(2) (squared, in b^2)",
    "corner": "every triangle in a block has height at least tau/2, the bound of Theorems 2 and 3: "
    "blocks of four squares are experimental (squared, in b^2)",
}

NodeTriangle = tuple[Node, Node, Node]


def check_lemma_2(mesh: NearBoundary, *, tau: mpq = bounds.TAU) -> list[Finding]:
    """Check Lemma 2 (corner rule and height repaired) on every triangle near the boundary.

    Parameters
    ----------
    mesh : BoundaryMesh or MergedMesh
        The warped faces and their triangles; merged faces are Lemma 5's.
    tau : mpq
        The snapping threshold in grid units.

    Notes
    -----
    An angle is compared by its cotangent, which is rational and falls as
    the angle grows: 135 degrees is -1.  Linear time.
    """
    places = places_of(mesh)
    untiled, largest, shortest = Violations(), Extreme(), Extreme()
    block_height, height = Extreme(), Extreme()
    for number, face in enumerate(mesh.faces):
        untiled.case(tiles(face.ring, face.triangles), (number, face.ring))
        if face.block >= 0:
            _measure_block(number, face, places, largest, shortest)
        least = block_height if face.block >= 0 else height
        for p, q, r in face.triangles:
            least.offer(*squared_height(places[p], places[q], places[r]), (number, (p, q, r)))
    describe = places.describe
    shape = mesh.warped.traced.diced.framed.blocks
    return [
        untiled.finding(
            "lemma-2.tiles",
            STAGE,
            "the triangles of each face near the boundary fit together to the face",
            describe=describe,
        ),
        largest.finding(
            "lemma-2.block-angle",
            STAGE,
            BLOCK_ANGLE[shape],
            bounds_blocks.block_cotangent(shape, tau),
            describe=describe,
        ),
        shortest.finding(
            "lemma-2.block-edges",
            STAGE,
            "every edge of a triangle in a block is at least tau long (squared, in b^2)",
            bounds.edge_squared(tau),
            describe=describe,
        ),
        block_height.finding(
            "lemma-2.block-height",
            STAGE,
            BLOCK_HEIGHT[shape],
            bounds_blocks.block_height_squared(shape, tau),
            describe=describe,
        ),
        height.finding(
            "lemma-2.height",
            STAGE,
            "every other triangle near the boundary has height at least tau/sqrt(2) "
            "(squared, in b^2)",
            bounds.boundary_height_squared(tau),
            describe=describe,
        ),
    ]


def _measure_block(
    number: int, face: WarpedFace, places: Places, largest: Extreme, shortest: Extreme
) -> None:
    """Angles and edges of a block face's triangles."""
    for triangle in face.triangles:
        corners = [places[node] for node in triangle]
        for num, den in cotangents(*corners):
            largest.offer(num, den, (number, triangle))
        for i, corner in enumerate(corners):
            shortest.offer(*squared_length(corners[i - 1], corner), (number, triangle))


def tiles(ring: Sequence[Node], triangles: Sequence[NodeTriangle]) -> bool:
    """Do the triangles' directed edges cancel but for the ring, m - 2 triangles for m sides?

    With counter-clockwise triangles that means that they tile the face.

    >>> tiles((0, 1, 2, 3), [(0, 1, 2), (0, 2, 3)]), tiles((0, 1, 2, 3), [(0, 1, 2)])
    (True, False)
    """
    if len(triangles) != len(ring) - 2:
        return False
    left = {(ring[i], ring[i - 1]) for i in range(len(ring))}
    if len(left) != len(ring):
        return False
    for triangle in triangles:
        for i, b in enumerate(triangle):
            a = triangle[i - 1]
            if (b, a) in left:
                left.remove((b, a))
            elif (a, b) in left:
                return False
            else:
                left.add((a, b))
    return not left
