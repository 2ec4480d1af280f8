"""Pictures of what a judge found wrong."""

from __future__ import annotations

from xml.etree import ElementTree

import pytest
from gmpy2 import mpq

from bern_exact.exact.points import hpoint
from bern_exact.oracle.api import verdict_on
from bern_exact.oracle.defects import DAMAGES, damage
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import triangulate_polygon
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.view.defects import draw_verdict
from tests.theorems.families import ring

SVG = "{http://www.w3.org/2000/svg}"
PLATE = polygon_from_rings(
    [ring([(0, 0), (9, 0), (9, 9), (5, 8), (0, 9)]), ring([(2, 2), (2, 4), (4, 4), (4, 2)])]
)
GOOD = Mesh(PLATE.points, tuple(triangulate_polygon(PLATE).triangles()))


def picture(mesh: Mesh, polygon: Polygon | None = PLATE, **options: str) -> ElementTree.Element:
    verdict = verdict_on(mesh, polygon, tolerance=mpq(options["tolerance"]) if options else None)
    text = draw_verdict(mesh, polygon, verdict)
    assert text == draw_verdict(mesh, polygon, verdict)
    return ElementTree.fromstring(text)


def marks(root: ElementTree.Element) -> list[str]:
    """What is drawn in red, in the whole and in each enlargement."""
    return [p.get("d", "") for p in root.iter(f"{SVG}path") if p.get("class") == "markA"]


def words(root: ElementTree.Element) -> str:
    return " ".join(text.text or "" for text in root.iter(f"{SVG}text"))


def test_nothing_is_red_in_a_good_mesh() -> None:
    root = picture(GOOD)
    assert not marks(root)
    assert "valid" in words(root) and "0 defects" in words(root)


@pytest.mark.parametrize("way", [way for way, each in DAMAGES.items() if each.kind is not None])
def test_every_damage_has_a_picture(way: str) -> None:
    made = damage(GOOD, PLATE, way, 1)
    if made is None or way == "mesh-emptied" or made.criterion:
        return
    root = picture(made.mesh, made.polygon)
    assert marks(root) and "not valid" in words(root)


def test_what_can_be_is_drawn_of_indices_out_of_range() -> None:
    root = picture(Mesh(PLATE.points, ((0, 1, 10**30), (-1, 99, 2), (7, 7, -5), (0, 1, 2))), None)
    assert "index-out-of-range" in words(root)
    assert marks(root)


def test_no_mesh_has_a_picture_too() -> None:
    root = picture(Mesh((), ()), None)
    assert not marks(root) and "not valid" in words(root)


def test_a_vertex_off_its_edge_by_next_to_nothing_is_seen_to_be() -> None:
    """The enlargement is so large that the vertex and the edge are far apart in it."""
    corners = [(0, 0), (4, 0), (4, 4), (0, 4)]
    polygon = polygon_from_rings([ring(corners)])
    off = hpoint(2, mpq(-1, 10**40))
    mesh = Mesh((*polygon.points, off), ((0, 4, 3), (4, 1, 2), (4, 2, 3)))
    root = picture(mesh, polygon)
    assert "10^" in words(root)
    assert len(marks(root)) == 3


def test_what_a_tolerance_accepts_is_said() -> None:
    polygon = polygon_from_rings([ring([(0, 0), (4, 0), (4, 4), (0, 4)])])
    mesh = Mesh((*polygon.points, hpoint(2, mpq(-1, 10**9))), ((0, 4, 3), (4, 1, 2), (4, 2, 3)))
    assert "valid within" in words(picture(mesh, polygon, tolerance="1/1000"))
