"""One picture of a triangulation: triangles by class, and the two worst ones enlarged."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from bern_exact.exact.angles import largest_angle
from bern_exact.exact.points import HPoint
from bern_exact.exact.predicates import squared_height
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.view.canvas import DETAIL, PLANE_BITS, XY, Plane, Window, path_data
from bern_exact.view.page import INSET, Page, Path

CLASSES = (
    "interior",
    "rectangle",
    "cell",
    "boundary",
    "merged",
    "block",
    "fan",
    "rim",
    "mesh",
    "bounced",
    "closed",
    "halved",
    "removed",
    "strip",
    "outer",
    "halfway",
    "between",
)
"""The classes of triangles that have a colour, in the order of drawing."""

MAIN = (880, 820)
"""The largest width and height of the whole mesh on the page, in pixels."""

MANY = 50_000
"""With more triangles than this the whole is rounded to 1/20 pixel, without what is smaller."""

HEIGHT_BITS = 12
"""A marked triangle's least height is at least 2^HEIGHT_BITS units of the rounded plane."""

SLENDER = 20
"""A triangle more slender than this is enlarged in part."""


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
        Any mesh whose indices are in range.
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
    page.whole(scene.whole(whole))
    for letter, mark in zip("AB", marks, strict=False):
        ring = scene.triangles[mark.triangle]
        focus = ring[largest_angle(*scene.corners(mark.triangle))[1]]
        window = _view_of(ring, focus)
        paths = scene.enlarged(window)
        paths.append((f"mark{letter}", path_data(window, [window.clipped(ring)])))
        zoom = window.pixels * whole.width // (whole.pixels * window.width)
        heading = f"{mark.title}, enlarged {zoom:,}:1" if zoom > 1 else mark.title
        page.inset(letter, window, paths, (heading, mark.detail))
        page.ring(letter, whole.at(focus))
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
        self._mesh = mesh
        self.present = [name for name in CLASSES if name in found]
        self._outline: list[list[XY]] = []
        if polygon is not None:
            corners = self.plane.all(polygon.points)
            self._outline = [[corners[v] for v in ring] for ring in polygon.rings]

    def corners(self, triangle: int) -> tuple[HPoint, HPoint, HPoint]:
        """The exact corners of a triangle."""
        a, b, c = self._mesh.triangles[triangle]
        return self._mesh.vertices[a], self._mesh.vertices[b], self._mesh.vertices[c]

    def whole(self, window: Window) -> list[Path]:
        """Everything, a class at a time, and the outline over it."""
        return self._paths(window, range(len(self.triangles)), lambda ring: ring)

    def enlarged(self, window: Window) -> list[Path]:
        """What a window shows."""
        near = [i for i, ring in enumerate(self.triangles) if window.sees(ring)]
        return self._paths(window, near, window.clipped)

    def _paths(
        self,
        window: Window,
        indices: Iterable[int],
        cut: Callable[[Sequence[XY]], Sequence[XY]],
    ) -> list[Path]:
        rings: dict[str, list[Sequence[XY]]] = {name: [] for name in self.present}
        for i in indices:
            rings[self._classes[i]].append(cut(self.triangles[i]))
        drawn = [(name, path_data(window, rings[name])) for name in self.present]
        drawn.append(("outline", path_data(window, map(cut, self._outline))))
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


def _view_of(ring: Sequence[XY], focus: XY) -> Window:
    """A square that shows a triangle with some of what lies around it.

    Of a needle, which would be a line as a whole, it shows the part round its widest angle.
    """
    xs, ys = [x for x, _ in ring], [y for _, y in ring]
    low, high = (min(xs), min(ys)), (max(xs), max(ys))
    extent = max(high[0] - low[0], high[1] - low[1], 1)
    height = abs(_doubled_area(ring)) // extent
    if extent <= SLENDER * height:
        return Window.centred(((low[0] + high[0]) // 2, (low[1] + high[1]) // 2), 2 * extent, INSET)
    return Window.centred(focus, SLENDER * max(height, 1), INSET)


def _doubled_area(ring: Sequence[XY]) -> int:
    (ax, ay), (bx, by), (cx, cy) = ring
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
