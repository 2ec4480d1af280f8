"""Pictures of meshes."""

from __future__ import annotations

from xml.etree import ElementTree

import pytest
from gmpy2 import mpq

from bern_exact.exact.points import hpoint
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.view.page import COLOURS, LABELS
from bern_exact.view.svg import CLASSES, MANY, Mark, draw

SQUARE = Polygon(tuple(hpoint(x, y) for x, y in ((0, 0), (4, 0), (4, 4), (0, 4))), ((0, 1, 2, 3),))
HALVES = Mesh(SQUARE.points, ((0, 1, 2), (0, 2, 3)))
SVG = "{http://www.w3.org/2000/svg}"


def paths(picture: str) -> dict[str | None, str | None]:
    root = ElementTree.fromstring(picture)
    return {path.get("class"): path.get("d") for path in root.iter(f"{SVG}path")}


def test_each_class_is_one_path() -> None:
    picture = draw(SQUARE, HALVES, ["interior", "block"])
    assert set(paths(picture)) == {"interior", "block", "outline"}


def test_every_class_has_a_colour_and_a_label() -> None:
    assert set(CLASSES) == set(COLOURS) == set(LABELS)


def test_the_same_mesh_gives_the_same_bytes() -> None:
    assert draw(SQUARE, HALVES, title="x") == draw(SQUARE, HALVES, title="x")


def test_marked_triangles_are_enlarged_and_explained() -> None:
    marks = [Mark(0, "least height", "1.5"), Mark(1, "largest angle", "90 degrees")]
    picture = draw(SQUARE, HALVES, marks=marks)
    assert {"markA", "markB"} <= set(paths(picture))
    assert "least height" in picture
    assert "90 degrees" in picture


def test_a_needle_is_still_a_triangle_in_its_enlargement() -> None:
    thin = hpoint(2, mpq(1, 10**40))
    mesh = Mesh((*SQUARE.points, thin), ((0, 1, 4), (0, 2, 3)))
    picture = draw(SQUARE, mesh, marks=[Mark(0, "least height", "tiny")])
    assert paths(picture)["markA"]


def test_nothing_has_a_picture_too() -> None:
    ElementTree.fromstring(draw(None, Mesh((), ())))


def test_a_title_cannot_break_the_file() -> None:
    picture = draw(SQUARE, HALVES, title="</text><script>&\x00\ud800")
    assert not list(ElementTree.fromstring(picture).iter(f"{SVG}script"))


@pytest.mark.slow
def test_large_meshes_make_no_large_files() -> None:
    side = 230
    grid = tuple(hpoint(x, y) for y in range(side) for x in range(side))
    corners = [y * side + x for y in range(side - 1) for x in range(side - 1)]
    mesh = Mesh(grid, tuple((i, i + 1, i + side) for i in corners for _ in (0, 1)))
    assert len(mesh.triangles) > MANY
    assert len(draw(None, mesh)) < 30 * len(mesh.triangles)
