"""Polygons, and the records of Section 3 near the boundary, for the checkers' tests."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from types import SimpleNamespace
from typing import Any

from gmpy2 import mpq

from bern_exact.boundary.merge import merge_boundary
from bern_exact.boundary.records import Framed, MergedMesh
from bern_exact.checkers import bounds
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.lemma_4 import check_lemma_4
from bern_exact.checkers.lemma_5 import check_lemma_5
from bern_exact.checkers.theorem_2 import check_theorem_2
from bern_exact.checkers.theorem_3 import check_theorem_3
from bern_exact.checkers.warping import check_faces
from bern_exact.corpus.draws import hpoints
from bern_exact.corpus.errata import BY_NAME
from bern_exact.exact.angle_bound import AngleBound, parse_angle_bound
from bern_exact.interior.records import Rectilinear
from bern_exact.interior.rectilinear import interior
from bern_exact.oracle.fast import verify_mesh
from bern_exact.plane.feature_size import FeatureSize
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems.prepare import prepare
from bern_exact.theorems.stages import Log, Silent
from bern_exact.theorems.theorem_2 import theorem_2
from bern_exact.theorems.threshold import threshold_for
from tests.checkers.samples import THINGS


def refuting(name: str) -> Polygon:
    """A polygon that refutes a sentence of the paper."""
    return polygon_from_rings(hpoints(BY_NAME[name].rings))


SLENDER = refuting("slender")
"""It puts every claim to the test: an edge clips the staircase of another, corners are lopped."""

END_FACE = refuting("thin-end-face")
"""Every diagonal drawn, an end face has height 0.00016 b: a projection next to the end of e."""

LOW_CORNER = refuting("low-corner")
"""A long row ends above an edge of almost 31 degrees: a height of 0.6263 tau, not tau/sqrt 2."""

SIMPLE = {
    **{name: thing for name, thing in THINGS.items() if not thing.holes},
    "slender": SLENDER,
    "end-face": END_FACE,
    "low-corner": LOW_CORNER,
}


class Merged(SimpleNamespace):
    """The records of one construction; any of them can be replaced."""

    polygon: Polygon
    tau: mpq
    angle_bound: AngleBound
    feature: FeatureSize
    framed: Framed
    merged: MergedMesh
    interior: Rectilinear
    mesh: Mesh
    verdict: Any

    def but(self, **others: Any) -> Merged:
        """The same records, some replaced."""
        return Merged(**{**vars(self), **others})


@cache
def boundary_of(name: str) -> MergedMesh:
    """The merged boundary of any polygon of the samples, with holes or without."""
    thing = {**THINGS, **SIMPLE}[name]
    prepared = prepare(thing, Log("none", Silent()), bounds.TAU)
    return merge_boundary(prepared.warped, prepared.warping, prepared.tracer)


@cache
def merged_of(name: str, degrees: str = "150") -> Merged:
    """All records of Theorem 2 for one of the simple polygons, with all diagonals but end ones."""
    bound = parse_angle_bound(degrees)
    made = theorem_2(SIMPLE[name], max_angle=bound, objective="height", check="none")
    records: Any = made.records
    return Merged(
        polygon=made.polygon,
        tau=threshold_for(bound),
        angle_bound=bound,
        feature=made.feature,
        framed=made.framed,
        merged=records["merged"],
        interior=records["interior"],
        mesh=made.assembled.mesh,
        verdict=verify_mesh(made.assembled.mesh, made.polygon),
    )


def region_of(mesh: MergedMesh) -> Rectilinear:
    """Q of a merged boundary."""
    return interior(face.ring for face in mesh.touched)


def _theorem(check: Callable[..., list[Finding]]) -> Callable[[Merged], list[Finding]]:
    """A theorem's check on all that it reads."""
    return lambda s: check(
        s.polygon,
        s.mesh,
        s.framed,
        s.feature,
        s.verdict,
        s.merged,
        tau=s.tau,
        angle_bound=s.angle_bound,
    )


CHECKS: dict[str, Callable[[Merged], list[Finding]]] = {
    "faces": lambda s: check_faces(s.merged, s.interior, tau=s.tau),
    "lemma-4": lambda s: check_lemma_4(s.merged, tau=s.tau),
    "lemma-5": lambda s: check_lemma_5(s.merged, tau=s.tau),
    "theorem-2": _theorem(check_theorem_2),
    "theorem-3": _theorem(check_theorem_3),
}


def finding(records: Merged, check: str, claim: str) -> Finding:
    """One claim of one check."""
    (found,) = (f for f in CHECKS[check](records) if f.claim == claim)
    return found
