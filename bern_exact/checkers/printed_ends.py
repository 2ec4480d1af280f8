"""Lemma 5's end faces as printed: all staircase vertices but the first and last projected."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from gmpy2 import mpq

from bern_exact.boundary.records import MergedFace, MergedMesh
from bern_exact.checkers import bounds
from bern_exact.checkers.as_printed import triangulations
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.lemma_4 import has_positive_slope, level
from bern_exact.checkers.places import Places, cotangent, point_text, squared_height
from bern_exact.checkers.rings import places_of
from bern_exact.exact.points import HPoint, Line, meet
from bern_exact.exact.predicates import orientation

STAGE = "merged"

END_FACE_SIDES = 4
"""Lemma 5: "end faces must be convex quadrilaterals or triangles"."""

BELOW_COT_150 = mpq(-1733, 1000)
"""cot 150 degrees is -1.73205...: "with maximum angle 150"."""


def check_merged_as_printed(mesh: MergedMesh, *, tau: mpq = bounds.TAU) -> list[Finding]:
    """Lemma 5's sentences on end faces, with every diagonal drawn.

    The construction leaves out a diagonal that would make an end face too thin; here none is.
    An end face counts with the best of all its triangulations.

    Parameters
    ----------
    mesh : MergedMesh
        Only its merged faces are read.
    tau : mpq
        The snapping threshold in grid units.
    """
    lines = mesh.warped.traced.diced.framed.polygon.lines
    places = places_of(mesh)
    shapes, heights, angles = Violations(), Extreme(), Extreme()
    for item in mesh.projected:
        edge = item.merged.edge
        for ring in end_faces(item.merged, lines[edge], places):
            shapes.case(len(ring) <= END_FACE_SIDES and _is_convex(ring), (edge, ring))
            height = best_height(ring)
            heights.offer(height.numerator, height.denominator, (edge, ring))
            for i, corner in enumerate(ring):
                angles.offer(*cotangent(ring[i - 1], corner, ring[i + 1 - len(ring)]), (edge, ring))
    return [
        shapes.finding(
            "lemma-5.printed-end-faces",
            STAGE,
            "end faces must be convex quadrilaterals or triangles, all inner staircase vertices "
            "being projected",
            role="as-printed",
            describe=_describe,
        ),
        angles.finding(
            "lemma-5.printed-end-angle",
            STAGE,
            "end faces have maximum angle 150, so that either diagonal triangulates them (least "
            "cotangent of a corner, that of 150 degrees rounded down)",
            BELOW_COT_150,
            role="as-printed",
            describe=_describe,
        ),
        heights.finding(
            "lemma-5.printed-end-height",
            STAGE,
            "height comes for free: with all inner staircase vertices projected the end faces can "
            "be triangulated with height at least tau/2 (squared, in b^2)",
            bounds.merged_height_squared(tau),
            role="as-printed",
            describe=_describe,
        ),
    ]


def _describe(witness: Any) -> Any:
    """An edge and an end face along it, JSON-ready."""
    edge, ring = witness
    return {"edge": edge, "end face": [point_text(p) for p in ring]}


def end_faces(face: MergedFace, line: Line, places: Places) -> Iterator[list[HPoint]]:
    """The two end faces of a merged face, counter-clockwise; the whole face if none is cut off.

    Staircase vertices that no diagonal joins to the inside of the base belong to an end face.
    """
    points = [places[node] for node in face.staircase]
    levels = [level(line, p) for p in points]
    low, high = sorted((levels[0], levels[-1]))
    inner = [i for i in range(1, len(points) - 1) if low < levels[i] < high]
    if not inner:
        yield [points[0], points[-1], *points[-2:0:-1]]
        return
    first, last = inner[0], inner[-1]
    yield [points[0], diagonal_foot(line, points[first]), *points[first:0:-1]]
    yield [diagonal_foot(line, points[last]), *points[: last - 1 : -1]]


def diagonal_foot(line: Line, p: HPoint) -> HPoint:
    """Where the diagonal through p, along which `level` is constant, meets the line."""
    x, y, w = p
    sign = 1 if has_positive_slope(line) else -1
    return meet((w, sign * w, -(x + sign * y)), line)


def _is_convex(ring: Sequence[HPoint]) -> bool:
    """Does a ring turn left or go straight everywhere?"""
    size = len(ring)
    return all(orientation(ring[i - 2], ring[i - 1], ring[i]) >= 0 for i in range(size))


def best_height(ring: Sequence[HPoint]) -> mpq:
    """The greatest least squared height of a triangulation of a ring; 0 if it has none.

    Exhaustive: end faces have few sides.
    """
    return max(
        (
            min(mpq(*squared_height(*triangle)) for triangle in triangles)
            for triangles in triangulations(tuple(ring))
        ),
        default=mpq(0),
    )
