"""The whole grid inside: as many triangles as two for every cell, and refused beyond a limit."""

from __future__ import annotations

from typing import Any

import pytest

from bern_exact import triangulate
from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.interior.records import Rectilinear
from bern_exact.interior.sweep import TooManyTriangles
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems import baseline as module
from bern_exact.theorems.assemble import CLASSES
from bern_exact.theorems.baseline import baseline
from bern_exact.theorems.stages import Construction
from bern_exact.theorems.theorem_1 import theorem_1
from bern_exact.theorems.theorem_2 import DEGREES_150
from bern_exact.theorems.theorem_3 import theorem_3
from tests.theorems.families import some_polygon
from tests.theorems.judged import verdict_on

DRAWS = [("simple", 3), ("plate", 3), ("inner_slit", 5), ("star", 4), ("triangle", 1)]

draws = pytest.mark.parametrize(("kind", "seed"), DRAWS)
bounds = pytest.mark.parametrize("max_angle", [None, "150", "140"])


def made_of(polygon: Polygon, max_angle: str | None, **options: Any) -> Construction:
    """The baseline of Theorem 1, or of Theorems 2 and 3 for a bound."""
    bound = None if max_angle is None else parse_angle_bound(max_angle)
    return baseline(polygon, max_angle=bound, **options)


class Squares:
    """The squares between the lines through all vertices of Q, and which of them are inside.

    A chord of Q runs along lines; a line alone, drawn for a vertex elsewhere, cuts no cell.

    Parameters
    ----------
    region : Rectilinear
        Q.
    """

    def __init__(self, region: Rectilinear) -> None:
        self.vertices = {vertex for loop in region.loops for vertex in loop}
        self.xs = sorted({x for x, _ in self.vertices})
        self.ys = sorted({y for _, y in self.vertices})
        sides = [
            (x, min(y, v), max(y, v), 1 if v < y else -1)
            for loop in region.loops
            for (u, y), (x, v) in zip(loop[-1:] + loop, loop, strict=False)
            if u == x
        ]
        self.inside = {
            (i, j)
            for i, x in enumerate(self.xs)
            for j, y in enumerate(self.ys)
            if sum(sign for at, low, high, sign in sides if at <= x and low <= y < high)
        }

    def on_chord(self, i: int, j: int, up: int) -> bool:
        """Does the line at the lower or left side of a square end at a vertex of Q?

        `up` is 1 for the left side, whose line runs downwards, 0 for the lower side.
        """
        while (i, j) in self.inside and (i - up, j - 1 + up) in self.inside:
            if (self.xs[i], self.ys[j]) in self.vertices:
                return True
            i, j = i - 1 + up, j - up
        return False

    def cells(self) -> int:
        """Squares that no chord parts make one cell."""
        parent = {square: square for square in self.inside}

        def root(square: tuple[int, int]) -> tuple[int, int]:
            while parent[square] != square:
                square = parent[square]
            return square

        for i, j in sorted(self.inside):
            for up in (0, 1):
                neighbour = (i - up, j - 1 + up)
                if neighbour in self.inside and not self.on_chord(i, j, up):
                    parent[root((i, j))] = root(neighbour)
        return len({root(square) for square in self.inside})


def classes(made: Construction) -> list[str]:
    """Where the triangles come from."""
    return [CLASSES[tag] for tag in made.assembled.classes]


@draws
@bounds
def test_two_triangles_for_every_cell(kind: str, seed: int, max_angle: str | None) -> None:
    made = made_of(some_polygon(kind, seed), max_angle, check="none")
    region: Any = made.records["interior"]
    assert classes(made).count("interior") == 2 * Squares(region).cells() > 0


@draws
@bounds
def test_the_lone_judge_agrees(kind: str, seed: int, max_angle: str | None) -> None:
    made = made_of(some_polygon(kind, seed), max_angle)
    assert verdict_on(made, max_angle)["valid"]
    assert all(found.holds for found in made.findings)


@draws
def test_the_boundary_is_that_of_the_theorems(kind: str, seed: int) -> None:
    polygon = some_polygon(kind, seed)

    def near(made: Construction, inside: str) -> list[str]:
        return sorted(name for name in classes(made) if name != inside)

    first = baseline(polygon, check="none")
    assert near(first, "interior") == near(theorem_1(polygon, check="none"), "interior")
    third = baseline(polygon, max_angle=DEGREES_150, check="none")
    assert near(third, "interior") == near(theorem_3(polygon, check="none"), "rectangle")


@draws
@pytest.mark.parametrize("theorem", [1, 3])
def test_the_theorems_are_no_larger(kind: str, seed: int, theorem: int) -> None:
    polygon = some_polygon(kind, seed)
    simpler, better = (
        triangulate(polygon, theorem=theorem, baseline=flag, check="none") for flag in (True, False)
    )
    assert better.certificate.triangles <= simpler.certificate.triangles


@bounds
def test_refused_beyond_its_limit(monkeypatch: pytest.MonkeyPatch, max_angle: str | None) -> None:
    polygon = some_polygon("simple", 3)
    size = classes(made_of(polygon, max_angle, check="none")).count("interior")
    monkeypatch.setattr(module, "MOST_TRIANGLES", size)
    assert made_of(polygon, max_angle, check="none")
    monkeypatch.setattr(module, "MOST_TRIANGLES", size - 1)
    with pytest.raises(TooManyTriangles, match=str(size)):
        made_of(polygon, max_angle, check="none")
