"""Records of Section 2's stages for small polygons of every family."""

from __future__ import annotations

from functools import cache
from typing import Any, NamedTuple

import pytest

from bern_exact.boundary.dice import dice
from bern_exact.boundary.frame import Degenerate, frame
from bern_exact.boundary.lop import lop
from bern_exact.boundary.records import BoundaryMesh, Diced, Framed, Lopped, Traced, Warped
from bern_exact.interior.records import Rectilinear, Swept
from bern_exact.plane.feature_size import feature_size
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import triangulate_polygon
from bern_exact.theorems.theorem_1 import theorem_1
from tests.theorems.families import FAMILIES, some_polygon


class Stages(NamedTuple):
    """What the tests look at."""

    polygon: Polygon
    lopped: Lopped
    framed: Framed
    diced: Diced
    traced: Traced
    warped: Warped
    boundary: BoundaryMesh
    interior: Rectilinear
    swept: Swept


def stages_of(polygon: Polygon) -> Stages:
    """All records for a polygon, nothing checked."""
    records: Any = theorem_1(polygon, check="none").records
    return Stages(polygon, *(records[name] for name in Stages._fields[1:]))


@cache
def drawn(kind: str, seed: int) -> Stages:
    """All records for a polygon of a family."""
    return stages_of(some_polygon(kind, seed))


def lopped(polygon: Polygon) -> Lopped:
    """P and P'."""
    return lop(polygon, triangulate_polygon(polygon))


def diced(polygon: Polygon) -> Diced:
    """P' in the first frame that does."""
    cut = lopped(polygon)
    size = feature_size(cut.lopped)
    attempt = 0
    while True:
        try:
            return dice(frame(cut, size, attempt))
        except Degenerate:
            attempt += 1


DRAWS = [(kind, seed) for kind in FAMILIES for seed in (0, 1)]

every_family = pytest.mark.parametrize(("kind", "seed"), DRAWS, ids=lambda value: str(value))
"""Two polygons of every family."""
