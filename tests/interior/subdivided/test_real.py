"""The interiors of real outlines, partitioned in every way, and triangulated."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import get_args

import pytest

from bern_exact import Polygon
from bern_exact.checkers.findings import demand
from bern_exact.checkers.lemma_6 import check_lemma_6
from bern_exact.checkers.lemma_7 import check_lemma_7
from bern_exact.checkers.lemma_8 import check_lemma_8
from bern_exact.interior.records import Rectilinear
from bern_exact.interior.subdivided.choice import Method, partition
from bern_exact.interior.subdivided.records import Partition
from bern_exact.interior.subdivided.rectangle import tile, triangles_of
from bern_exact.theorems.theorem_1 import theorem_1
from tests.interior.regions import surface_vertices

EXAMPLES = Path(__file__).parents[3] / "examples"
NAMES = ("glyph_dejavusans_A", "mdi_cog", "ne_united_arab_emirates_50m")
real = pytest.mark.parametrize("name", NAMES)


@cache
def interior_of(name: str) -> Rectilinear:
    construction = theorem_1(Polygon.load(EXAMPLES / f"{name}.json"), check="none")
    region = construction.records["interior"]
    if not isinstance(region, Rectilinear):
        raise TypeError(name)
    return region


@cache
def cut_by(name: str, method: Method) -> Partition:
    return partition(interior_of(name), method)


@real
def test_bridges_keep_lemma_6(name: str) -> None:
    halved = cut_by(name, "bridges")
    demand(check_lemma_6(halved))
    demand(check_lemma_7(tile(halved)))


@real
def test_strips_keep_lemma_8(name: str) -> None:
    cut = cut_by(name, "strips")
    demand(check_lemma_8(cut))
    demand(check_lemma_7(tile(cut)))


@real
def test_the_best_has_the_fewest_triangles(name: str) -> None:
    made = {method: cut_by(name, method) for method in get_args(Method)}
    triangles = {
        method: sum(triangles_of(rectangle) for rectangle in cut.rectangles)
        for method, cut in made.items()
    }
    assert triangles["best"] == min(triangles.values())
    demand(check_lemma_8(made["best"]))


@real
def test_at_most_four_triangles_a_vertex(name: str) -> None:
    for method in ("bridges", "strips", "best"):
        made = cut_by(name, method)
        triangles = sum(triangles_of(rectangle) for rectangle in made.rectangles)
        assert triangles <= 4 * surface_vertices(made)
