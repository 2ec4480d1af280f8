"""The stages in order, what is checked, and how the mesh is put together."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import Any

import pytest
from gmpy2 import mpq

from bern_exact.checkers.findings import LemmaViolation
from bern_exact.corpus.over_the_grid import moved_back
from bern_exact.exact.predicates import orientation
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems import prepare as module
from bern_exact.theorems.assemble import CLASSES, nodes_on_edge
from bern_exact.theorems.stages import Check
from bern_exact.theorems.theorem_1 import theorem_1
from tests.boundary.samples import every_family
from tests.plane.by_definition import on_segment
from tests.theorems.families import FAMILIES, some_polygon

STAGES = [
    "feature-size",
    "lopped",
    "framed",
    "diced",
    "traced",
    "warped",
    "boundary",
    "interior",
    "swept",
    "mesh",
]


class Listener:
    """Remembers the stages that it is told of."""

    def __init__(self) -> None:
        self.heard: list[tuple[str, object]] = []

    def stage(self, name: str, record: object) -> None:
        self.heard.append((name, record))


def test_the_observer_hears_every_stage_in_order() -> None:
    listener = Listener()
    made = theorem_1(some_polygon("simple", 0), observer=listener)
    assert [name for name, _ in listener.heard] == STAGES == list(made.records)
    assert all(made.records[name] is record for name, record in listener.heard)


@pytest.mark.parametrize("check", ["every-stage", "final", "none"])
def test_what_is_checked_does_not_change_the_mesh(check: Check) -> None:
    polygon = some_polygon("maze", 0)
    made = theorem_1(polygon, check=check)
    assert made.assembled == theorem_1(polygon).assembled
    places = {found.claim.split(".")[0] for found in made.findings}
    if check == "none":
        assert not places
    elif check == "final":
        assert places == {"theorem-1"}
    else:
        assert places >= {"definition-1", "lemma-1", "dicing", "warping", "lemma-2", "lemma-3"}


@pytest.mark.parametrize("kind", FAMILIES)
def test_claims_are_evaluated_once_each(kind: str) -> None:
    claims = Counter(found.claim for found in theorem_1(some_polygon(kind, 0)).findings)
    assert set(claims.values()) == {1}


def test_a_stage_that_breaks_a_lemma_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    original = module.dice

    def forgetful(framed: Any) -> Any:
        diced = original(framed)
        return replace(diced, vertical=diced.vertical[1:])

    monkeypatch.setattr(module, "dice", forgetful)
    with pytest.raises(LemmaViolation) as caught:
        theorem_1(some_polygon("simple", 0))
    assert caught.value.finding.claim.startswith("dicing.")


def test_another_frame_is_tried_where_the_first_is_special() -> None:
    corners = [(mpq(1, 2), mpq(1, 3)), (mpq(17, 2), mpq(1, 3)), (mpq(17, 2), 12), (mpq(1, 2), 12)]
    polygon = polygon_from_rings([moved_back([(mpq(x), mpq(y)) for x, y in corners])])
    made = theorem_1(polygon)
    assert made.framed.unit == 1
    assert all(x % w and y % w for x, y, w in made.framed.polygon.points)


@every_family
def test_the_input_comes_first_in_the_mesh(kind: str, seed: int) -> None:
    polygon = some_polygon(kind, seed)
    mesh = theorem_1(polygon, check="none").assembled.mesh
    assert mesh.vertices[: polygon.n] == polygon.points
    assert len(set(mesh.vertices)) == len(mesh.vertices)


@every_family
def test_triangles_are_counter_clockwise_and_classed(kind: str, seed: int) -> None:
    assembled = theorem_1(some_polygon(kind, seed), check="none").assembled
    mesh, classes = assembled.mesh, assembled.classes
    assert len(classes) == len(mesh.triangles) and set(classes) <= set(range(len(CLASSES)))
    assert (
        list(classes) != []
        and min(orientation(*(mesh.vertices[v] for v in triangle)) for triangle in mesh.triangles)
        == 1
    )


@every_family
def test_fans_fill_the_lopped_corners(kind: str, seed: int) -> None:
    made = theorem_1(some_polygon(kind, seed), check="none")
    records: Any = made.records
    lopped, warped = records["lopped"], records["warped"]
    fans = [
        triangle
        for triangle, tag in zip(made.assembled.mesh.triangles, made.assembled.classes, strict=True)
        if CLASSES[tag] == "fan"
    ]
    sizes = Counter(triangle[0] for triangle in fans)
    for cut in lopped.cuts:
        base = nodes_on_edge(warped, cut.before)
        assert base[0] == cut.before and base[-1] == cut.after
        assert sizes[cut.corner] == len(base) - 1
        ends = (lopped.lopped.points[cut.before], lopped.lopped.points[cut.after])
        vertices = made.assembled.mesh.vertices
        for triangle in fans:
            if triangle[0] == cut.corner:
                # Undone exactly: what lies on the base in the grid lies on it in the input.
                assert all(on_segment(vertices[v], *ends) for v in triangle[1:])
    assert set(sizes) == {cut.corner for cut in lopped.cuts}
