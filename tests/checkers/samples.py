"""Polygons, and all records of one construction, for the checkers' tests."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache
from types import SimpleNamespace
from typing import Any

from gmpy2 import mpq

from bern_exact.boundary.records import BoundaryMesh, Diced, Framed, Lopped, Warped
from bern_exact.checkers.definition_1 import check_definition_1
from bern_exact.checkers.definition_2 import check_definition_2
from bern_exact.checkers.dicing import check_dicing, check_frame
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.lemma_1 import check_lemma_1
from bern_exact.checkers.lemma_2 import check_lemma_2
from bern_exact.checkers.lemma_3 import check_lemma_3
from bern_exact.checkers.theorem_1 import check_theorem_1
from bern_exact.checkers.warping import check_faces, check_warping
from bern_exact.exact.points import hpoint
from bern_exact.interior.records import Rectilinear, Swept
from bern_exact.plane.feature_size import FeatureSize
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems.theorem_1 import theorem_1

Coordinates = Sequence[tuple[int | mpq, int | mpq]]


def polygon(outer: Coordinates, *holes: Coordinates) -> Polygon:
    """A polygon from rings that already run the right way."""
    rings, points = [], []
    for ring in (outer, *holes):
        rings.append(tuple(range(len(points), len(points) + len(ring))))
        points += [hpoint(mpq(x), mpq(y)) for x, y in ring]
    return Polygon(tuple(points), tuple(rings))


PLATE = polygon(
    [(0, 0), (40, 0), (41, 7), (40, 30), (30, 31), (29, 14), (22, 31), (0, 30)],
    [(8, 8), (7, 14), (16, 15), (15, 7)],
)
"""Acute and reflex vertices, axis-parallel edges, and a hole."""

THINGS: dict[str, Polygon] = {
    "triangle": polygon([(0, 0), (10, 0), (3, 7)]),
    "square": polygon([(0, 0), (1, 0), (1, 1), (0, 1)]),
    "subdivided": polygon([(0, 0), (2, 0), (5, 0), (5, 5), (0, 5)]),
    "needle": polygon([(0, 0), (10**6, 0), (10**6, 1)]),
    "slit": polygon([(0, 0), (9, 0), (9, 9), (5, 9), (5, 4), (mpq(499, 100), 9), (0, 9)]),
    "large": polygon([(10**30 + 1, 10**30), (10**30 + 9, 10**30 + 2), (10**30, 10**30 + 5)]),
    "guide": polygon(
        [(0, 0), (1, 0), (mpq(99, 100), 3), (mpq(1, 2), mpq(86, 100)), (mpq(1, 100), 3)]
    ),
    "plate": PLATE,
}


class Stages(SimpleNamespace):
    """The records of Theorem 1's construction; any of them can be replaced."""

    polygon: Polygon
    feature: FeatureSize
    lopped: Lopped
    framed: Framed
    diced: Diced
    warped: Warped
    boundary: BoundaryMesh
    interior: Rectilinear
    swept: Swept
    mesh: Mesh
    verdict: Any

    def but(self, **others: Any) -> Stages:
        """The same stages, some records replaced."""
        return Stages(**{**vars(self), **others})


@cache
def stages_of(name: str) -> Stages:
    """All records for one of the polygons above."""
    made = theorem_1(THINGS[name], check="none")
    records: Any = made.records
    names = ("lopped", "framed", "diced", "warped", "boundary", "interior", "swept")
    return Stages(
        polygon=made.polygon,
        feature=made.feature,
        mesh=made.assembled.mesh,
        verdict=SimpleNamespace(valid=True, defects=()),
        **{name: records[name] for name in names},
    )


CHECKS: dict[str, Callable[[Stages], list[Finding]]] = {
    "definition-1": lambda s: check_definition_1(s.polygon, s.feature),
    "lemma-1": lambda s: check_lemma_1(s.lopped, s.feature, s.framed.feature),
    "framed": lambda s: check_frame(s.framed),
    "diced": lambda s: check_dicing(s.diced),
    "warped": lambda s: check_warping(s.warped),
    "faces": lambda s: check_faces(s.boundary, s.interior),
    "lemma-2": lambda s: check_lemma_2(s.boundary),
    "definition-2": lambda s: check_definition_2(s.interior),
    "lemma-3": lambda s: check_lemma_3(s.swept),
    "theorem-1": lambda s: check_theorem_1(s.polygon, s.mesh, s.framed, s.feature, s.verdict),
}


def finding(stages: Stages, check: str, claim: str) -> Finding:
    """One claim of one check."""
    (found,) = (f for f in CHECKS[check](stages) if f.claim == claim)
    return found


__all__ = ["CHECKS", "PLATE", "THINGS", "Stages", "finding", "polygon", "replace", "stages_of"]
