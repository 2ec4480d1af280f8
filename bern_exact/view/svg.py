"""One picture of a triangulation: triangles by class, and the two worst ones enlarged."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from bern_exact.exact.points import HPoint
from bern_exact.exact.predicates import squared_height
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.view.canvas import DETAIL, PLANE_BITS, XY, Plane, Window, path_data
from bern_exact.view.page import INSET, Page, Path

CLASSES = ("interior", "boundary", "block", "fan", "mesh")
"""The classes of triangles that have a colour, in the order of drawing."""

MAIN = (880, 820)
"""The largest width and height of the whole mesh on the page, in pixels."""

MANY = 50_000
"""With more triangles than this the whole is rounded to 1/20 pixel, without what is smaller."""

HEIGHT_BITS = 12
"""A marked triangle's least height is at least 2^HEIGHT_BITS units of the rounded plane."""


@dataclass(frozen=True)
class Mark:
    """A triangle that the picture points at and enlarges.

    Parameters
    ----------
    triangle : int
        Its index.
    title, detail : str
        What it is, and its figure.
    """

    triangle: int
    title: str
    detail: str


def draw(
    polygon: Polygon | None,
    mesh: Mesh,
    classes: Sequence[str] | None = None,
    *,
    title: str = "",
    subtitle: str = "",
    marks: Sequence[Mark] = (),
) -> str:
    """An SVG of a mesh: equal aspect, y upwards, one path for each class of triangles.

    Parameters
    ----------
    polygon : Polygon or None
        The boundary, drawn over the mesh.
    mesh : Mesh
        Any mesh of at least one vertex whose indices are in range.
    classes : sequence of str, optional
        For each triangle one of `CLASSES`; all are "mesh" if it is not given.
    title, subtitle : str
        The two lines at the top.
    marks : sequence of Mark
        At most two triangles, each ringed in the whole and enlarged at the right.

    Returns
    -------
    str
        The file's text, ASCII but for the titles.  The same for the same mesh, on any machine.

    Notes
    -----
    Linear in the mesh; about 25 bytes a triangle, less above `MANY` triangles.

    >>> from bern_exact.exact.points import hpoint
    >>> mesh = Mesh((hpoint(0, 0), hpoint(1, 0), hpoint(0, 1)), ((0, 1, 2),))
    >>> 'd="M0 820000l820000 0-820000-820000z"' in draw(None, mesh)
    True
    """
    scene = _Scene(polygon, mesh, classes, marks)
    detail = DETAIL if len(mesh.triangles) <= MANY else 20
    whole = Window.fitting(scene.plane, *MAIN, detail)
    page = Page(whole, scene.present, len(marks))
    page.heading(title, subtitle)
    page.whole(scene.paths(whole, range(len(mesh.triangles))))
    for letter, mark in zip("AB", marks, strict=False):
        ring = scene.triangles[mark.triangle]
        window = Window.centred(_middle(ring), _view_of(ring), INSET)
        paths = scene.paths(window, scene.near(window))
        paths.append((f"mark{letter}", path_data(window, [ring])))
        zoom = window.pixels * whole.width // (whole.pixels * window.width)
        heading = f"{mark.title}, enlarged {zoom:,}:1" if zoom > 1 else mark.title
        page.inset(letter, window, paths, (heading, mark.detail))
        page.ring(letter, whole.at(_middle(ring)))
    return page.text()


class _Scene:
    """Everything to be drawn, in the rounded coordinates of one plane."""

    def __init__(
        self,
        polygon: Polygon | None,
        mesh: Mesh,
        classes: Sequence[str] | None,
        marks: Sequence[Mark],
    ) -> None:
        points = [*mesh.vertices, *(polygon.points if polygon is not None else ())]
        self.plane = _plane_for(points, mesh, marks)
        at = self.plane.all(mesh.vertices)
        self.triangles = [(at[a], at[b], at[c]) for a, b, c in mesh.triangles]
        self._classes = ["mesh"] * len(self.triangles) if classes is None else classes
        found = set(self._classes)
        self.present = [name for name in CLASSES if name in found]
        self._outline: list[list[XY]] = []
        if polygon is not None:
            corners = self.plane.all(polygon.points)
            self._outline = [[corners[v] for v in ring] for ring in polygon.rings]

    def near(self, window: Window) -> list[int]:
        """The triangles that a window may show."""
        return [i for i, ring in enumerate(self.triangles) if window.sees(ring)]

    def paths(self, window: Window, indices: Iterable[int]) -> list[Path]:
        """Paths of these triangles, a class at a time, and of the outline over them."""
        rings: dict[str, list[Sequence[XY]]] = {name: [] for name in self.present}
        for i in indices:
            rings[self._classes[i]].append(self.triangles[i])
        drawn = [(name, path_data(window, rings[name])) for name in self.present]
        drawn.append(("outline", path_data(window, self._outline)))
        return [(name, data) for name, data in drawn if data]


def _plane_for(points: Sequence[HPoint], mesh: Mesh, marks: Sequence[Mark]) -> Plane:
    """A plane in which the marked triangles can be told from lines."""
    plane = Plane.around(points)
    bits = PLANE_BITS
    for mark in marks:
        a, b, c = mesh.triangles[mark.triangle]
        corners = (mesh.vertices[a], mesh.vertices[b], mesh.vertices[c])
        height = squared_height(*corners) * plane.scale**2
        if height > 0:
            short = HEIGHT_BITS - (int(height).bit_length() - height.denominator.bit_length()) // 2
            bits = max(bits, PLANE_BITS + short)
    return Plane.around(points, bits) if bits > PLANE_BITS else plane


def _middle(ring: Sequence[XY]) -> XY:
    """The middle of a bounding box."""
    xs, ys = [x for x, _ in ring], [y for _, y in ring]
    return (min(xs) + max(xs)) // 2, (min(ys) + max(ys)) // 2


def _view_of(ring: Sequence[XY]) -> int:
    """The side of a square that shows a triangle with some of what lies around it."""
    xs, ys = [x for x, _ in ring], [y for _, y in ring]
    return 2 * max(max(xs) - min(xs), max(ys) - min(ys))
