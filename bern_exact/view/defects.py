"""The picture of a mesh with what a judge found wrong marked in it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from gmpy2 import isqrt, mpq

from bern_exact.exact.numbers import parse_rational
from bern_exact.exact.points import HPoint
from bern_exact.exact.predicates import squared_distance
from bern_exact.oracle.places import points_of
from bern_exact.oracle.verdict import Defect, Verdict
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.view.canvas import DETAIL, PLANE_BITS, XY, Plane, Window, path_data
from bern_exact.view.page import INSET, Page, Path
from bern_exact.view.svg import MAIN, MANY

DOT = 5
"""Half the size of the square round a vertex, in pixels."""

NEAR = 8
"""A vertex off its edge is shown with so many times its distance from it around."""

SIZE_BITS = 12
"""What is enlarged is at least 2^SIZE_BITS units of the rounded plane."""

MOST_MARKS = 1_000
"""Further defects are not marked."""


def draw_verdict(mesh: Mesh, polygon: Polygon | None, verdict: Verdict) -> str:
    """An SVG of a judged mesh: its defects in red, the first of two kinds enlarged.

    Parameters
    ----------
    mesh : Mesh
        Anybody's.  Of triangles with indices out of range, what can be is drawn: nothing, or
        the edge between the two vertices that there are.
    polygon : Polygon or None
        What it was judged against.
    verdict : Verdict
        What the judge said of them.

    Returns
    -------
    str
        The file's text.  The same for the same arguments, on any machine.

    Notes
    -----
    Linear in the mesh; no more than `MOST_MARKS` defects are marked.

    Examples
    --------
    >>> from bern_exact.exact.points import hpoint
    >>> from bern_exact.oracle.fast import verify_mesh
    >>> mesh = Mesh((hpoint(0, 0), hpoint(1, 0), hpoint(0, 1)), ((0, 2, 1),))
    >>> 'class="markA"' in draw_verdict(mesh, None, verify_mesh(mesh, None))
    True
    """
    marked = [
        _Marked(defect, points_of(defect.where, mesh, polygon))
        for defect in verdict.defects[:MOST_MARKS]
    ]
    scene = _Scene(mesh, polygon, [mark for mark in marked if mark.points])
    detail = DETAIL if len(mesh.triangles) <= MANY else 20
    whole = Window.fitting(scene.plane, *MAIN, detail)
    shown = scene.enlarged
    page = Page(whole, ["mesh"], len(shown))
    title = (polygon.name if polygon is not None else "") or "Mesh"
    page.heading(f"{title}: {verdict.state}", _subtitle(verdict))
    page.whole([*scene.paths(whole), *scene.marks(whole)])
    for letter, mark in zip("AB", shown, strict=False):
        window = scene.view_of(mark)
        zoom = window.pixels * whole.width // (whole.pixels * window.width)
        place = f"{mark.defect.message.partition(': ')[2]:.30}{_zoom_text(zoom)}"
        paths = [*scene.paths(window), *scene.marks(window)]
        page.inset(letter, window, paths, (mark.defect.kind, place))
        page.ring(letter, whole.at(scene.centre_of(mark)))
    return page.text()


@dataclass(frozen=True)
class _Marked:
    """A defect and the points of its place."""

    defect: Defect
    points: Sequence[HPoint]


def _subtitle(verdict: Verdict) -> str:
    """The counts, and how many defects are in red."""
    counts = f"{verdict.triangles:,} triangles, {verdict.vertices:,} vertices"
    found = len(verdict.defects)
    return f"{counts}; {found:,} defect{'' if found == 1 else 's'} listed, their places in red"


def _zoom_text(zoom: int) -> str:
    """How much larger something is drawn; a power of ten where the number would be long."""
    if zoom <= 1:
        return ""
    return f", enlarged {zoom:,}:1" if zoom < 10**6 else f", enlarged 10^{len(str(zoom)) - 1}:1"


class _Scene:
    """Mesh, outline and marks in the rounded coordinates of one plane."""

    def __init__(self, mesh: Mesh, polygon: Polygon | None, marked: Sequence[_Marked]) -> None:
        self._marked = marked
        self.enlarged = list(_first_of_two_kinds(marked))
        outline = [] if polygon is None else list(polygon.points)
        points = [*mesh.vertices, *outline]
        self.plane = Plane.around(points)
        bits = max((_bits_for(mark, self.plane) for mark in self.enlarged), default=0)
        if bits > PLANE_BITS:
            self.plane = Plane.around(points, bits)
        at, count = self.plane.all(mesh.vertices), len(mesh.vertices)
        self._triangles = [[at[v] for v in corners if 0 <= v < count] for corners in mesh.triangles]
        corners = self.plane.all(outline)
        self._outline = [] if polygon is None else [[corners[v] for v in r] for r in polygon.rings]

    def paths(self, window: Window) -> list[Path]:
        """The triangles and the outline, as far as a window shows them."""
        near = [window.clipped(ring) for ring in self._triangles if ring and window.sees(ring)]
        outline = [window.clipped(ring) for ring in self._outline]
        drawn = [("mesh", path_data(window, near)), ("outline", path_data(window, outline))]
        return [(name, data) for name, data in drawn if data]

    def marks(self, window: Window) -> list[Path]:
        """The places of defects: triangles, edges, and squares round vertices."""
        rings = []
        for mark in self._marked:
            ring = self.plane.all(mark.points)
            if not window.sees(ring):
                continue
            ring = window.clipped(ring)
            rings.append(_square(window, ring[0]) if len(ring) == 1 else ring)
        data = path_data(window, rings)
        return [("markA", data)] if data else []

    def centre_of(self, mark: _Marked) -> XY:
        """The middle of a place."""
        low, high = _box(self.plane.all(mark.points))
        return (low[0] + high[0]) // 2, (low[1] + high[1]) // 2

    def view_of(self, mark: _Marked) -> Window:
        """A square round a place; round a vertex, wide enough to show how far off it is."""
        size = int(isqrt(int(_size_squared(mark) * self.plane.scale**2)))
        widths = NEAR if len(mark.points) == 1 else 2
        side = widths * size or max(self.plane.width, self.plane.height) // 20
        return Window.centred(self.centre_of(mark), side, INSET)


def _first_of_two_kinds(marked: Sequence[_Marked]) -> Iterator[_Marked]:
    """The first defect, and the first of another kind."""
    if marked:
        first = marked[0]
        yield first
        yield from [m for m in marked if m.defect.kind != first.defect.kind][:1]


def _size_squared(mark: _Marked) -> mpq:
    """What an enlargement must show: a place's extent, a vertex's distance from its edge, or 0."""
    points = mark.points
    if len(points) > 1:
        return max(squared_distance(p, q) for p in points for q in points)
    text = mark.defect.witness.get("distance_squared")
    return parse_rational(text) if isinstance(text, str) else mpq(0)


def _bits_for(mark: _Marked, plane: Plane) -> int:
    """The resolution in which a place is not a mere point."""
    size = _size_squared(mark) * plane.scale**2
    if size == 0:
        return PLANE_BITS
    bits = (size.numerator.bit_length() - size.denominator.bit_length()) // 2
    return PLANE_BITS + max(0, SIZE_BITS - bits)


def _square(window: Window, at: XY) -> list[XY]:
    """A square round a point, of a fixed size on the page."""
    half = max(1, DOT * window.width // window.pixels)
    x, y = at
    return [(x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half)]


def _box(points: Sequence[XY]) -> tuple[XY, XY]:
    """The lower left and the upper right corner round points."""
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return (min(xs), min(ys)), (max(xs), max(ys))
