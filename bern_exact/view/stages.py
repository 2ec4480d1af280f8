"""A picture of each stage's record, for `--trace`."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from gmpy2 import mpq

from bern_exact.boundary.records import (
    HORIZONTAL,
    VERTICAL,
    BoundaryMesh,
    Crossing,
    Diced,
    Face,
    Framed,
    Interval,
    Lopped,
    MergedMesh,
    Node,
    Traced,
)
from bern_exact.convex.block_records import Blocks, Reduced
from bern_exact.convex.records import Bounced, ConvexFrame, Gridded
from bern_exact.exact.points import HPoint, grid_point, hpoint
from bern_exact.interior.records import Rectilinear, Swept
from bern_exact.interior.subdivided.records import Partition, Tiled
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems.assemble import CLASSES, Assembled
from bern_exact.view.blocks import merged_layers, part_layers, reduced_layers
from bern_exact.view.bounced import bounced_layers, frame_layers, grid_layers
from bern_exact.view.canvas import DETAIL, Plane, Window, path_data
from bern_exact.view.layers import OPEN, Layer
from bern_exact.view.page import COLOURS, Page
from bern_exact.view.svg import MAIN, MANY


def draw_stage(name: str, record: object) -> str | None:
    """A picture of a stage record, or None if there is nothing to see in a record of its type.

    Parameters
    ----------
    name : str
        The stage's name, for the title.
    record : object
        What the stage made.
    """
    layers_of = _PAINTERS.get(type(record))
    if layers_of is None:
        return None
    return draw_layers(name, [layer for layer in layers_of(record) if layer.rings])


def more_pictures(name: str, record: object) -> Iterator[tuple[str, str]]:
    """The further pictures of a stage record: what to add to the file's name, and the picture."""
    for suffix, layers_of in _MORE.get(type(record), {}).items():
        layers = [layer for layer in layers_of(record) if layer.rings]
        yield suffix, draw_layers(f"{name}, {suffix}", layers)


def draw_layers(title: str, layers: Sequence[Layer]) -> str:
    """An SVG of layers, the first at the bottom; they must hold at least one point."""
    points = [p for layer in layers for ring in layer.rings for p in ring]
    plane = Plane.around(points)
    many = sum(len(layer.rings) for layer in layers) > MANY
    window = Window.fitting(plane, *MAIN, 20 if many else DETAIL)
    page = Page(window, [layer.style for layer in layers if layer.style in COLOURS], 0)
    page.heading(title, "")
    drawn = [
        (style, path_data(window, map(plane.all, rings), closed=style not in OPEN))
        for style, rings in layers
    ]
    page.whole([(style, data) for style, data in drawn if data])
    return page.text()


def _rings(polygon: Polygon) -> list[list[HPoint]]:
    return [[polygon.points[v] for v in ring] for ring in polygon.rings]


def _lopped(record: Lopped) -> list[Layer]:
    ends = record.lopped.points
    cuts = [[record.polygon.points[c.corner], ends[c.after], ends[c.before]] for c in record.cuts]
    return [Layer("fan", cuts), Layer("outline", _rings(record.polygon))]


def _framed(record: Framed) -> list[Layer]:
    return [Layer("outline", _rings(record.polygon))]


def _diced(record: Diced) -> list[Layer]:
    def line(axis: int, interval: Interval) -> list[HPoint]:
        ends = (interval.low, interval.high)
        found = [record.crossing_at[axis, interval.line, edge] for edge in ends]
        return [_position(record.crossings[j]) for j in found]

    lines = [line(VERTICAL, interval) for interval in record.vertical]
    lines += [line(HORIZONTAL, interval) for interval in record.horizontal]
    return [Layer("line", lines), *_framed(record.framed)]


def _position(crossing: Crossing) -> HPoint:
    """Where a crossing lies before warping."""
    on_line = mpq(crossing.line)
    if crossing.axis == VERTICAL:
        return hpoint(on_line, crossing.at)
    return hpoint(crossing.at, on_line)


def _traced(record: Traced) -> list[Layer]:
    polygon = record.diced.framed.polygon

    def at(node: Node) -> HPoint:
        if isinstance(node, tuple):
            return grid_point(*node)
        if node < polygon.n:
            return polygon.points[node]
        return _position(record.diced.crossings[node - polygon.n])

    def rings(faces: Sequence[Face]) -> list[list[HPoint]]:
        return [[at(node) for node in face.ring] for face in faces]

    return [
        Layer("boundary", rings([face for face in record.faces if face.block < 0])),
        Layer("block", rings([face for face in record.faces if face.block >= 0])),
        *_framed(record.diced.framed),
    ]


def _meshed(record: BoundaryMesh) -> list[Layer]:
    at = record.warped.point_of
    rings: dict[bool, list[list[HPoint]]] = {False: [], True: []}
    for face in record.faces:
        rings[face.block >= 0] += [[at(node) for node in corners] for corners in face.triangles]
    framed = record.warped.traced.diced.framed
    return [Layer("boundary", rings[False]), Layer("block", rings[True]), *_framed(framed)]


def _merged(record: MergedMesh) -> list[Layer]:
    """Merged faces whole, their diagonals on top, and what is not merged."""
    at = record.point_of
    rings: dict[bool, list[list[HPoint]]] = {False: [], True: []}
    for face in record.faces:
        rings[face.block >= 0].append([at(node) for node in face.ring])
    merged = [
        [at(node) for node in (face.merged.base[0], *reversed(face.merged.staircase[1:]))]
        for face in record.projected
    ]
    diagonals = [[at(a), at(b)] for face in record.projected for a, b in face.cuts]
    return [
        Layer("boundary", rings[False]),
        Layer("block", rings[True]),
        Layer("merged", merged),
        Layer("line", diagonals),
        *_framed(record.warped.traced.diced.framed),
    ]


def _partition(record: Partition) -> list[Layer]:
    rectangles = [[grid_point(*node) for node in r.ring()] for r in record.rectangles]
    return [Layer("rectangle", rectangles), *_region(record.region)]


def _tiled(record: Tiled) -> list[Layer]:
    triangles = [
        [hpoint(mpq(x, 2), mpq(y, 2)) for x, y in corners]
        for tiling in record.tilings
        for corners in tiling.triangles
    ]
    return [Layer("rectangle", triangles), *_region(record.partition.region)]


def _region(record: Rectilinear) -> list[Layer]:
    return [Layer("outline", [[grid_point(*node) for node in loop] for loop in record.loops])]


def _swept(record: Swept) -> list[Layer]:
    triangles = [
        [grid_point(*node) for node in corners]
        for column in record.columns
        for corners in column.triangles
    ]
    return [Layer("interior", triangles), *_region(record.region)]


def _assembled(record: Assembled) -> list[Layer]:
    at = record.mesh.vertices
    rings: dict[str, list[list[HPoint]]] = {name: [] for name in CLASSES}
    for tag, corners in zip(record.classes, record.mesh.triangles, strict=True):
        rings[CLASSES[tag]].append([at[i] for i in corners])
    return [Layer(name, found) for name, found in rings.items()]


_PAINTERS: dict[type, Callable[..., list[Layer]]] = {
    Lopped: _lopped,
    Framed: _framed,
    Diced: _diced,
    Traced: _traced,
    BoundaryMesh: _meshed,
    MergedMesh: _merged,
    Partition: _partition,
    Tiled: _tiled,
    Rectilinear: _region,
    Swept: _swept,
    Assembled: _assembled,
    ConvexFrame: frame_layers,
    Bounced: bounced_layers,
    Gridded: grid_layers,
    Blocks: merged_layers,
    Reduced: reduced_layers,
}

_MORE: dict[type, dict[str, Callable[..., list[Layer]]]] = {Reduced: {"parts": part_layers}}
"""Further pictures of a record, by what is added to the file's name."""
