"""Sentences of Section 2 that are false as printed, evaluated beside their repaired forms.

A finding of role "as-printed" that does not hold is no fault of the
construction: it shows an erratum on this input.  None of this is within the
running time that the paper bounds.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence

from gmpy2 import mpq, mpz

from bern_exact.boundary.records import BoundaryMesh, Framed, Lopped, Warped
from bern_exact.checkers import bounds, bounds_grid
from bern_exact.checkers.dicing import squares
from bern_exact.checkers.extremes import Extreme
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.lemma_3 import faces_between_matches, squared_grid_height
from bern_exact.checkers.places import Places, cotangent, squared_height
from bern_exact.checkers.printed_cut import check_printed_cut
from bern_exact.exact.points import HPoint
from bern_exact.exact.predicates import orientation
from bern_exact.interior.records import GridNode, Swept, SweptColumn
from bern_exact.plane.feature_size import FeatureSize

GridTriangle = tuple[GridNode, GridNode, GridNode]


def check_lopped_as_printed(lopped: Lopped, feature: FeatureSize) -> list[Finding]:
    """Lemma 1 with the paper's own cutting line."""
    return check_printed_cut(lopped, feature)


def check_framed_as_printed(framed: Framed, feature: FeatureSize) -> list[Finding]:
    """The paper's grid: b = s/8, and "each vertex of P' falls into a different square".

    Parameters
    ----------
    framed : Framed
        P' over the unit grid.
    feature : FeatureSize
        s, of P.
    """
    occupants: dict[tuple[int, int], list[int]] = defaultdict(list)
    for v, square in enumerate(squares(framed.polygon)):
        occupants[square].append(v)
    crowded, ratio = Extreme(greatest=True), Extreme()
    for square, vertices in occupants.items():
        crowded.offer(len(vertices), 1, {"square": square, "vertices of P'": vertices})
    in_units = bounds_grid.FACTOR**2 * framed.feature.squared / feature.squared
    ratio.offer(in_units.numerator, in_units.denominator, {"s' squared": framed.feature.squared})
    return [
        crowded.finding(
            "dicing.printed-different-squares",
            "framed",
            "each vertex of P' falls into a different square (of the plane; true on each sheet)",
            1,
            role="as-printed",
        ),
        ratio.finding(
            "dicing.printed-unit",
            "framed",
            "with b = s/8 blocks cannot overlap: s' > 2 sqrt(2) b (squared, in b^2)",
            mpq(8),
            strict=True,
            role="as-printed",
        ),
    ]


def check_warped_as_printed(warped: Warped) -> list[Finding]:
    """Lemma 2's 135 degrees if every vertex takes the closest corner of its square.

    Only blocks whose closest corner was refused are measured: the others took it and are
    measured by Lemma 2 itself.  A face counts with the best of all its triangulations.
    """
    refused, angle = Extreme(greatest=True), Extreme()
    for v, rank in enumerate(warped.rank):
        refused.offer(rank, 1, {"vertex of P'": v, "corner taken": warped.corners[v]})
    for v, rings in sorted(warped.refused.items()):
        for ring in rings:
            angle.offer(*best_cotangent(ring), {"vertex of P'": v, "face": ring})
    return [
        refused.finding(
            "lemma-2.printed-closest-corner",
            "warped",
            "with the closest corner of each square every block keeps its bounds, 135 degrees "
            "among them (closer corners refused)",
            0,
            role="as-printed",
        ),
        angle.finding(
            "lemma-2.printed-block-angle",
            "warped",
            "with the closest corner every face of a block can be triangulated with angles of at "
            "most 135 degrees (least cotangent of the best triangulation, over refused blocks)",
            mpq(-1),
            role="as-printed",
        ),
    ]


def best_cotangent(ring: Sequence[HPoint]) -> tuple[mpz, mpz]:
    """The least cotangent of an angle in the ring's triangulation with the least largest angle.

    Exhaustive: a ring has at most 7 sides here, so at most 42 triangulations.  A ring that
    has no triangulation counts as 180 degrees and more: (-10^9, 1).
    """
    worst = max(
        (
            min(
                mpq(*cotangent(t[i - 1], t[i], t[(i + 1) % 3])) for t in triangles for i in range(3)
            )
            for triangles in triangulations(tuple(ring))
        ),
        default=mpq(-(10**9)),
    )
    return worst.numerator, worst.denominator


def triangulations(ring: tuple[HPoint, ...]) -> Iterator[list[tuple[HPoint, HPoint, HPoint]]]:
    """Every triangulation of a ring by its own vertices, all triangles counter-clockwise."""
    if len(ring) < 3:
        yield []
        return
    first, last = ring[0], ring[-1]
    for k in range(1, len(ring) - 1):
        if orientation(first, ring[k], last) > 0:
            for before in triangulations(ring[: k + 1]):
                for after in triangulations(ring[k:]):
                    yield [*before, (first, ring[k], last), *after]


def check_boundary_as_printed(mesh: BoundaryMesh) -> list[Finding]:
    """Lemma 2: "height almost b/8", and "at most two of its vertices move"."""
    places, least, most = Places(mesh.warped), Extreme(), Extreme(greatest=True)
    for number, face in enumerate(mesh.faces):
        for p, q, r in face.triangles:
            least.offer(*squared_height(places[p], places[q], places[r]), (number, (p, q, r)))
    for before in mesh.touched:
        if before.block < 0:
            moved = sum(
                node in mesh.warped.moved for node in before.ring if isinstance(node, tuple)
            )
            most.offer(moved, 1, before.ring)
    return [
        least.finding(
            "lemma-2.printed-height",
            "boundary",
            "every triangle near the boundary has height almost b/8 (squared, in b^2)",
            bounds.TAU**2,
            role="as-printed",
            describe=places.describe,
        ),
        most.finding(
            "lemma-2.printed-moved",
            "boundary",
            "when a face outside the blocks warps, at most two of its vertices move",
            bounds.PRINTED_MOVED,
            role="as-printed",
        ),
    ]


def check_swept_as_printed(swept: Swept) -> list[Finding]:
    """Lemma 3: "height at least b", and "adding diagonals in a zig-zag fashion"."""
    least, zig_zag = Extreme(), Extreme()
    for item in swept.columns:
        for triangle in item.triangles:
            least.offer(*squared_grid_height(*triangle), triangle)
        for triangle in zig_zag_triangles(item):
            zig_zag.offer(*squared_grid_height(*triangle), triangle)
    return [
        least.finding(
            "lemma-3.printed-height",
            "swept",
            "every triangle in Q has height at least b (squared, in b^2)",
            mpq(1),
            role="as-printed",
        ),
        zig_zag.finding(
            "lemma-3.printed-zig-zag",
            "swept",
            "diagonals in a zig-zag fashion from top to bottom, left side first, give triangles of "
            "height at least b/sqrt(2) (squared, in b^2)",
            bounds.INTERIOR_HEIGHT_SQUARED,
            role="as-printed",
        ),
    ]


def zig_zag_triangles(item: SweptColumn) -> Iterator[GridTriangle]:
    """The faces of a column cut by diagonals that go down the two sides in turn.

    When one side has reached its bottom the other goes on alone.

    >>> from bern_exact.interior.records import Column
    >>> column = SweptColumn(Column(0, 1, 0, 9), (0, 9), (0, 8, 9), ())
    >>> list(zig_zag_triangles(column))[-1]
    ((1, 8), (0, 0), (1, 0))
    """
    x0, x1 = item.column.x0, item.column.x1
    for left, right in faces_between_matches(item):
        down_left = [(x0, y) for y in reversed(left)]
        down_right = [(x1, y) for y in reversed(right)]
        i = j = 0
        left_turn = True
        while i + j < len(left) + len(right) - 2:
            if j == len(right) - 1 or (left_turn and i < len(left) - 1):
                yield down_left[i], down_left[i + 1], down_right[j]
                i += 1
            else:
                yield down_right[j], down_left[i], down_right[j + 1]
                j += 1
            left_turn = not left_turn
