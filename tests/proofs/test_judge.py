"""The definitions that the judge is compared with tell meshes from what is none."""

from __future__ import annotations

import pytest

from proofs.judge import Case, Point, Triangle, inside, meet_properly, simple_polygons, spots
from proofs.statement import NotShown

SQUARE: list[Point] = [(0, 0), (2, 0), (2, 2), (0, 2)]
HALVES: list[Triangle] = [(0, 1, 2), (0, 2, 3)]


def test_two_halves_are_a_triangulation_of_the_square() -> None:
    case = Case(SQUARE)
    (whole,) = [within for ring, within in case.polygons if sorted(ring) == sorted(SQUARE)]
    assert case.is_mesh(HALVES) == [int(w) for w in whole]


@pytest.mark.parametrize(
    "triangles",
    [
        [],
        HALVES[:1],  # a vertex is unused
        [(0, 2, 1), (0, 2, 3)],  # clockwise
        [*HALVES, (0, 1, 3)],  # overlapping
    ],
)
def test_what_is_no_mesh(triangles: list[Triangle]) -> None:
    assert Case(SQUARE).is_mesh(triangles) is None


def test_a_hanging_vertex_is_found() -> None:
    assert not meet_properly([(0, 0), (2, 0), (2, 2)], [(1, 0), (0, 0), (1, -1)])
    assert meet_properly([(0, 0), (2, 0), (2, 2)], [(2, 0), (0, 0), (1, -1)])


def test_a_square_has_the_polygons_that_it_should() -> None:
    assert len(list(simple_polygons(SQUARE))) == 4 + 1
    assert len(list(simple_polygons([*SQUARE, (1, 1)]))) == 4 + 4 + 1 + 4 + 4


def test_spots_lie_on_no_line_and_on_both_sides() -> None:
    found = list(spots(SQUARE))
    assert all(x not in (0, 2) and y not in (0, 2) and x != y and x + y != 2 for x, y in found)
    assert {inside(SQUARE, spot) for spot in found} == {True, False}


def test_a_wrong_verdict_would_be_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("proofs.judge.verdict", lambda mesh, polygon: True)
    with pytest.raises(NotShown):
        Case(SQUARE).compare(HALVES[:1])
