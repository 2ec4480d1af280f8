"""Lemma 1: what lopping leaves has feature size s/3, and what it cuts off is not thin."""

from __future__ import annotations

from collections.abc import Sequence

from gmpy2 import mpq

from bern_exact.boundary.records import Cut, Lopped
from bern_exact.checkers import bounds
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.places import cotangent, squared_height
from bern_exact.exact.points import HPoint, direction
from bern_exact.exact.predicates import (
    cross,
    dot,
    is_in_wedge,
    orientation,
    squared_distance,
)
from bern_exact.plane.feature_size import FeatureSize
from bern_exact.plane.polygon import Polygon

STAGE = "lopped"


def check_lemma_1(
    lopped: Lopped, feature: FeatureSize, lopped_feature: FeatureSize
) -> list[Finding]:
    """Check Lemma 1 (Section 2, cutting line repaired) and that the record is what it says.

    Parameters
    ----------
    lopped : Lopped
        P and P'.
    feature, lopped_feature : FeatureSize
        The feature sizes s of P and s' of P', each certified by `definition_1`.

    Notes
    -----
    The rounding slack is explicit: rho, the least ratio of a cut's distance from
    its corner to |vw|/3, is measured on the cuts themselves, and the bounds on s' and on
    the cut triangles carry rho^2.  That w is the *nearest* visible vertex is checked as
    far as the bounds need it: it is a vertex, in the wedge, no further than either
    neighbour.  Linear time.
    """
    ratio = _cut_ratio(lopped)
    rounding = mpq(1) if ratio.value is None else min(mpq(1), ratio.value)
    return [
        _check_structure(lopped),
        _check_cut_points(lopped),
        ratio.finding(
            "lemma-1.cut-distance",
            STAGE,
            "each corner is cut at |vw|/3 on both edges, rounded down by less than 1 part in 2^9 "
            "(squared ratio)",
            bounds.CUT_ROUNDING**2,
            strict=True,
        ),
        _check_acute(lopped.lopped),
        _check_base_angles(lopped),
        _check_heights(lopped, feature, rounding),
        _check_feature(feature, lopped_feature, rounding),
    ]


def is_acute(polygon: Polygon, vertex: int) -> bool:
    """Is the interior angle at this vertex strictly below 90 degrees?"""
    points = polygon.points
    out = direction(points[vertex], points[polygon.after[vertex]])
    back = direction(points[vertex], points[polygon.before[vertex]])
    return bool(cross(out, back) > 0 and dot(out, back) > 0)


def _check_structure(lopped: Lopped) -> Finding:
    """P' must be P with each acute vertex, and no other, replaced by the ends of its cut."""
    polygon, shorter = lopped.polygon, lopped.lopped
    cuts = {cut.corner: cut for cut in lopped.cuts}
    broken = Violations()
    for vertex in range(polygon.n):
        broken.case((vertex in cuts) == is_acute(polygon, vertex), {"vertex": vertex})
    if len(cuts) != len(lopped.cuts) or len(lopped.origin) != shorter.n:
        broken.broken("repeated cuts or origins that do not fit")
    rings_fit = len(polygon.rings) == len(shorter.rings)
    if not rings_fit:
        broken.broken("number of rings")
    for ring, short_ring in zip(polygon.rings, shorter.rings, strict=rings_fit):
        if not _same_cycle(_expected_ring(lopped, cuts, ring), short_ring):
            broken.broken({"ring of vertex": ring[0]})
    return broken.finding(
        "lemma-1.structure",
        STAGE,
        "P' is P with every vertex of less than 90 degrees, and no other, replaced by a cut",
    )


def _expected_ring(lopped: Lopped, cuts: dict[int, Cut], ring: Sequence[int]) -> list[int]:
    """The ring of P' that a ring of P becomes, -1 where the record does not fit."""
    number = {v: i for i, v in enumerate(lopped.origin) if v >= 0}
    expected: list[int] = []
    for v in ring:
        if v in cuts:
            expected += [cuts[v].before, cuts[v].after]
        elif v in number and lopped.lopped.points[number[v]] == lopped.polygon.points[v]:
            expected.append(number[v])
        else:
            expected.append(-1)
    return expected


def _same_cycle(expected: Sequence[int], ring: Sequence[int]) -> bool:
    """Are these the same but for where they begin?"""
    if len(expected) != len(ring) or expected[0] not in ring:
        return False
    start = ring.index(expected[0])
    return [*ring[start:], *ring[:start]] == list(expected)


def _check_cut_points(lopped: Lopped) -> Finding:
    """Both ends of a cut must lie inside P's edges, not beyond a third of a suitable |vw|."""
    broken = Violations()
    for cut in lopped.cuts:
        broken.case(_is_sound(lopped, cut), cut._asdict())
    return broken.finding(
        "lemma-1.cut-points",
        STAGE,
        "each cut joins its corner's two edges at no more than |vw|/3, w being a vertex in the "
        "corner's wedge, no further than either neighbour",
    )


def _is_sound(lopped: Lopped, cut: Cut) -> bool:
    polygon = lopped.polygon
    corner, nearest = polygon.points[cut.corner], polygon.points[cut.nearest]
    before, after = polygon.before[cut.corner], polygon.after[cut.corner]
    third = bounds.CUT_FRACTION**2 * squared_distance(corner, nearest)
    if cut.nearest == cut.corner or not is_in_wedge(
        nearest, polygon.points[before], corner, polygon.points[after]
    ):
        return False
    for neighbour, end in ((before, cut.before), (after, cut.after)):
        far, point = polygon.points[neighbour], lopped.lopped.points[end]
        if orientation(corner, far, point) != 0:
            return False
        if dot(direction(corner, far), direction(corner, point)) <= 0:
            return False
        if squared_distance(corner, point) > third or 9 * third > squared_distance(corner, far):
            return False
    return True


def _cut_ratio(lopped: Lopped) -> Extreme:
    """The least squared ratio of a cut's distance to |vw|/3, over both ends of all cuts."""
    least = Extreme()
    for cut in lopped.cuts:
        corner, nearest = (lopped.polygon.points[v] for v in (cut.corner, cut.nearest))
        third = bounds.CUT_FRACTION**2 * squared_distance(corner, nearest)
        for end in (cut.before, cut.after):
            leg = squared_distance(corner, lopped.lopped.points[end])
            if third > 0:
                ratio = leg / third
                least.offer(ratio.numerator, ratio.denominator, cut._asdict())
    return least


def _check_acute(shorter: Polygon) -> Finding:
    """P' has no acute vertex: the reason for lopping."""
    broken = Violations()
    for vertex in range(shorter.n):
        broken.case(not is_acute(shorter, vertex), {"vertex of P'": vertex})
    return broken.finding("lemma-1.acute", STAGE, "P' has no interior angle below 90 degrees")


def _triangle(lopped: Lopped, cut: Cut) -> tuple[HPoint, HPoint, HPoint]:
    """The triangle that is cut off, counter-clockwise from the corner."""
    ends = lopped.lopped.points
    return lopped.polygon.points[cut.corner], ends[cut.after], ends[cut.before]


def _check_base_angles(lopped: Lopped) -> Finding:
    """The base angles of a cut triangle are 45 to 90 degrees: cotangents from 0 to 1."""
    broken = Violations()
    for cut in lopped.cuts:
        corner, after, before = _triangle(lopped, cut)
        for at, ring in (
            (cut.after, (corner, after, before)),
            (cut.before, (after, before, corner)),
        ):
            inner, area = cotangent(*ring)
            broken.case(bool(0 <= inner <= area), {"cut": cut._asdict(), "vertex of P'": at})
    return broken.finding(
        "lemma-1.base-angles",
        STAGE,
        "the base angles of each triangle cut off are between 45 and 90 degrees",
    )


def _check_heights(lopped: Lopped, feature: FeatureSize, rounding: mpq) -> Finding:
    """(height/s)^2 of the cut triangles."""
    least = Extreme()
    s = feature.squared
    for cut in lopped.cuts:
        num, den = squared_height(*_triangle(lopped, cut))
        least.offer(num * s.denominator, den * s.numerator, cut._asdict())
    return least.finding(
        "lemma-1.triangle-height",
        STAGE,
        "each triangle cut off has height at least rho s sqrt(2)/6, rho being the rounding of the "
        "cuts ((height/s)^2)",
        bounds.CUT_HEIGHT_SQUARED * rounding,
    )


def _check_feature(feature: FeatureSize, shorter: FeatureSize, rounding: mpq) -> Finding:
    """(s'/s)^2."""
    ratio = shorter.squared / feature.squared
    least = Extreme()
    least.offer(
        ratio.numerator, ratio.denominator, {"vertex": shorter.vertex, "edge": shorter.edge}
    )
    return least.finding(
        "lemma-1.feature-size",
        STAGE,
        "the feature size s' of P' is at least rho s/3, rho being the rounding of the cuts "
        "((s'/s)^2)",
        bounds.LOPPED_FEATURE_SQUARED * rounding,
    )
