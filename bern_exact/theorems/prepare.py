"""What all three theorems for polygons share: from P to the warped arrangement (Section 2)."""

from __future__ import annotations

from dataclasses import dataclass

from gmpy2 import mpq

from bern_exact.boundary.blocks import Grid
from bern_exact.boundary.corners import warp
from bern_exact.boundary.dice import dice
from bern_exact.boundary.faces import Tracer, trace
from bern_exact.boundary.frame import DEFAULT, Degenerate, frame
from bern_exact.boundary.lop import lop
from bern_exact.boundary.records import Diced, Framed, Lopped, Warped
from bern_exact.boundary.warp import Warping
from bern_exact.checkers.as_printed import (
    check_framed_as_printed,
    check_lopped_as_printed,
    check_warped_as_printed,
)
from bern_exact.checkers.definition_1 import check_definition_1
from bern_exact.checkers.dicing import check_dicing, check_frame
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.lemma_1 import check_lemma_1
from bern_exact.checkers.warping import check_warping
from bern_exact.plane.feature_size import FeatureSize, feature_size
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import triangulate_polygon
from bern_exact.theorems.stages import Log

ATTEMPTS = 100
"""Frames tried before giving up; each fails only on a coincidence of its own."""


@dataclass(frozen=True)
class Prepared:
    """The warped arrangement, and what made it.

    Parameters
    ----------
    feature : FeatureSize
        Definition 1 for P.
    warped : Warped
        Where every node of the arrangement goes; it holds the stages before.
    warping : Warping
        The same as a function, for mapping faces.
    tracer : Tracer
        For tracing the rectangles that warping touches.
    """

    feature: FeatureSize
    warped: Warped
    warping: Warping
    tracer: Tracer

    @property
    def framed(self) -> Framed:
        """P' over the grid."""
        return self.warped.traced.diced.framed


def prepare(polygon: Polygon, log: Log, tau: mpq, grid: Grid = DEFAULT) -> Prepared:
    """Lop, frame, dice and warp a polygon, each stage followed by its checks.

    Section 2: "The first step of our maxmin-height algorithm is to 'lop off' acute vertices of
    P"; "the second step is the dicing step"; "the third step is to warp some segments".

    Parameters
    ----------
    polygon : Polygon
        P, valid.
    log : Log
        Takes the records and the findings.
    tau : mpq
        The threshold of warping, in grid units.
    grid : Grid
        The shape of blocks, and s' in grid units.
    """
    triangulation = triangulate_polygon(polygon)
    feature = feature_size(polygon, triangulation)
    log.done("feature-size", feature)
    if log.every_stage:
        log.demand(check_definition_1(polygon, feature))

    lopped = lop(polygon, triangulation)
    log.done("lopped", lopped)

    diced = _dice_somewhere(lopped, grid)
    log.done("framed", diced.framed)
    if log.every_stage:
        log.demand(_check_lopped(diced.framed, feature))
        log.demand(check_frame(diced.framed))
    log.done("diced", diced)
    if log.every_stage:
        log.demand(check_dicing(diced))

    traced, tracer = trace(diced)
    log.done("traced", traced)

    warped, warping = warp(traced, tracer, tau)
    log.done("warped", warped)
    if log.every_stage:
        log.demand(check_warping(warped, tau=tau))
    if log.as_printed:
        log.demand(check_lopped_as_printed(lopped, feature))
        log.demand(check_framed_as_printed(diced.framed, feature))
        if grid.blocks == "square":  # the paper's sentence is about its own blocks
            log.demand(check_warped_as_printed(warped))
    return Prepared(feature, warped, warping, tracer)


def _check_lopped(framed: Framed, feature: FeatureSize) -> list[Finding]:
    """Lemma 1, and Definition 1 for P', on which the grid unit rests."""
    lopped = framed.lopped
    certified = check_definition_1(
        lopped.lopped, framed.feature, claim="definition-1.lopped", stage="framed"
    )
    return [*certified, *check_lemma_1(lopped, feature, framed.feature)]


def _dice_somewhere(lopped: Lopped, grid: Grid) -> Diced:
    """Dice P' in the first frame in which nothing is special."""
    feature = feature_size(lopped.lopped)
    for attempt in range(ATTEMPTS):
        try:
            return dice(frame(lopped, feature, attempt, grid))
        except Degenerate as coincidence:
            reason = coincidence
    raise reason
