"""Small drawings of the counterexamples."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from gmpy2 import mpq

from bern_exact.boundary.records import Framed, MergedMesh, Warped
from bern_exact.checkers.places import cotangent
from bern_exact.checkers.printed_cut import printed_boxes
from bern_exact.checkers.printed_ends import best_height, diagonal_foot, end_faces
from bern_exact.checkers.rings import places_of
from bern_exact.convex.records import Bounced
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.exact.roots import sqrt_below
from bern_exact.interior.subdivided.halving import halving
from bern_exact.plane.feature_size import feature_size
from bern_exact.view.bounced import bounced_layers
from bern_exact.view.canvas import Plane, Window, path_data
from bern_exact.view.page import Page
from proofs import printed
from proofs.polyominoes import outline

SIZE = (420, 300)
"""The largest width and height of a drawing, in pixels."""

DETAIL = 20
"""Units a pixel: files stay small."""

Layer = tuple[str, list[Sequence[HPoint]], bool]
"""A class of `view.page`, its rings or lines, and whether they are closed."""

Drawing = Callable[[], tuple[str, str, list[Layer]]]
"""Makes a title, a note and the layers."""


def ring(points: Iterable[Sequence[Any]]) -> list[HPoint]:
    """Points from pairs of exact numbers."""
    return [hpoint(mpq(x), mpq(y)) for x, y in points]


def svg(drawing: Drawing) -> str:
    """The drawing's file."""
    title, note, layers = drawing()
    plane = Plane.around([p for _, rings, _ in layers for line in rings for p in line])
    window = Window.fitting(plane, *SIZE, DETAIL)
    page = Page(window, (), 0)
    page.heading(title, note)
    paths = []
    for name, rings, closed in layers:
        data = path_data(window, [plane.all(line) for line in rings], closed=closed)
        paths.append((name, data))
        if closed and name not in ("outline", "bounced"):
            paths.append(("line", data))
    page.whole(paths)
    return page.text()


def cutting_line() -> tuple[str, str, list[Layer]]:
    """The paper's cuts in red, the repaired ones in green."""
    made = printed.run("cutting-line", 1)
    lopped: Any = made.stages["lopped"]
    boxes = printed_boxes(lopped, feature_size(made.polygon))
    middles = [ring([((a + b) / 2, (c + d) / 2)])[0] for (a, b), (c, d) in boxes]
    theirs = [[middles[cut.before], middles[cut.after]] for cut in lopped.cuts]
    ours = [
        [lopped.lopped.points[cut.before], lopped.lopped.points[cut.after]] for cut in lopped.cuts
    ]
    return (
        "Lemma 1: the cutting line",
        "red: as printed; green: |vw|/3 on both edges",
        [
            ("mesh", [made.polygon.points], True),
            ("bounced", [*theirs], False),
            ("closed", [*ours], False),
        ],
    )


def slit() -> tuple[str, str, list[Layer]]:
    """P' and the square that two of its vertices share."""
    framed: Any = printed.run("slit", 1).stages["framed"]
    square, _ = _crowded(framed)
    return (
        "Two vertices in one square of the plane",
        "P' over the grid; red: the square of two tips across a slit",
        [
            ("mesh", [framed.polygon.points], True),
            ("bounced", [_box(*square, square[0] + 1, square[1] + 1)], True),
        ],
    )


def _crowded(framed: Framed) -> tuple[tuple[int, int], list[HPoint]]:
    """A square with several vertices of P'."""
    of: dict[tuple[int, int], list[HPoint]] = {}
    for x, y, w in framed.polygon.points:
        of.setdefault((int(x // w), int(y // w)), []).append((x, y, w))
    return max(of.items(), key=lambda item: len(item[1]))


def _box(x0: Any, y0: Any, x1: Any, y1: Any) -> list[HPoint]:
    return ring([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])


def unit() -> tuple[str, str, list[Layer]]:
    """The blocks of the two nearest vertices, for b = s/8."""
    made = printed.run("right-triangle", 1)
    framed: Any = made.stages["framed"]
    points = framed.polygon.points
    ratio = made.certificate.feature_size_squared / (framed.feature.squared * framed.unit**2)
    b = sqrt_below(ratio * framed.feature.squared, 40) / framed.factor
    boxes = []
    for x, y, w in points:
        i, j = mpq(x, w) / b // 1, mpq(y, w) / b // 1
        boxes.append(_box((i - 1) * b, (j - 1) * b, (i + 2) * b, (j + 2) * b))
    return (
        "With b = s/8 blocks overlap",
        "P' and all blocks of 3 x 3 squares, b = s/8",
        [("block", [*boxes], True), ("outline", [points], True), ("bounced", [*boxes], True)],
    )


def closest_corner() -> tuple[str, str, list[Layer]]:
    """The faces of the block with the closest corner, the worst one in red."""
    warped: Any = printed.run("closest-corner", 1).stages["warped"]
    worst, rings = _refused(warped)
    return (
        "Lemma 2: the closest corner",
        "faces of the block of v, warped; red: no triangulation within 135 degrees",
        [("block", [*rings], True), ("bounced", [worst], True)],
    )


def _refused(warped: Warped) -> tuple[Sequence[HPoint], Sequence[Sequence[HPoint]]]:
    from bern_exact.checkers.as_printed import best_cotangent

    rings = next(iter(warped.refused.values()))
    return min(rings, key=lambda r: mpq(*best_cotangent(r))), rings


def thin_face() -> tuple[str, str, list[Layer]]:
    """An edge of length tau at 45 degrees to the longest edge."""
    return (
        "Lemma 2: height tau/sqrt 2",
        "an edge of length tau at 45 degrees to the longest edge of its triangle",
        [("boundary", [ring([(0, 0), (10, 0), ("0.7", "0.7")])], True)],
    )


def unit_square() -> tuple[str, str, list[Layer]]:
    """The unit square and its diagonal."""
    return (
        "Lemma 3: the unit square",
        "height 1/sqrt 2",
        [
            ("mesh", [_box(0, 0, 1, 1)], True),
            ("bounced", [ring([(0, 0), (1, 1)])], False),
        ],
    )


def zig_zag() -> tuple[str, str, list[Layer]]:
    """Two columns 1 wide and 8 high; the zig-zag's thin triangle in red."""
    loop = printed.tall_region(8).loops[0]
    return (
        "Lemma 3: the zig-zag",
        "columns 1 wide and 8 high; in the right one, height 1/sqrt 65",
        [
            ("mesh", [ring(loop)], True),
            ("line", [ring([(1, 0), (1, 8)])], False),
            ("bounced", [ring([(1, 0), (2, 7), (2, 8)])], True),
        ],
    )


def _merged(
    name: str, title: str, note: str, badness: Callable[[Sequence[HPoint]], mpq] = best_height
) -> tuple[str, str, list[Layer]]:
    """The merged face with the worst end face: all diagonals, the end face in red."""
    mesh: Any = printed.run(name, 2).stages["merged"]
    return title, note, list(_end_face_layers(mesh, badness))


def _end_face_layers(
    mesh: MergedMesh, badness: Callable[[Sequence[HPoint]], mpq]
) -> Iterable[Layer]:
    lines, places = mesh.warped.traced.diced.framed.polygon.lines, places_of(mesh)
    faces = [
        (badness(end), end, item.merged)
        for item in mesh.projected
        for end in end_faces(item.merged, lines[item.merged.edge], places)
    ]
    _, thin, merged = min(faces, key=lambda face: face[0])
    stairs = [places[node] for node in merged.staircase]
    cuts = [[p, diagonal_foot(lines[merged.edge], p)] for p in stairs[1:-1]]
    yield "merged", [stairs], True
    yield "line", [*cuts], False
    yield "bounced", [thin], True


def end_face() -> tuple[str, str, list[Layer]]:
    """A projection next to the end of e."""
    return _merged(
        "right-triangle",
        "Lemma 5: an end face",
        "a merged face with every diagonal; red: its thinnest end face",
    )


def obtuse_end_face() -> tuple[str, str, list[Layer]]:
    """The row ends on e at the corner with more than 150 degrees."""
    return _merged(
        "obtuse-end-face",
        "Lemma 5: more than 150 degrees",
        "a merged face with every diagonal; red: an end face with a corner of 150.9 degrees",
        lambda end: min(
            mpq(*cotangent(end[i - 1], p, end[i + 1 - len(end)])) for i, p in enumerate(end)
        ),
    )


def three_corners() -> tuple[str, str, list[Layer]]:
    """The face, much shortened, and the two edges."""
    walls = [[("-0.35", "-3"), ("0.2", "3")], [("7", "-2.1"), ("12", "2.9")]]
    return (
        "Lemma 2: three corners move",
        "red: a face (45 b wide, here shortened) between two edges that pass near three corners",
        [
            ("bounced", [_box(0, 0, 9, 1)], True),
            ("line", [*(ring(wall) for wall in walls)], False),
        ],
    )


def low_corner() -> tuple[str, str, list[Layer]]:
    """The case that leaves tau/2."""
    return (
        "Lemma 5: tau/2",
        "row CE and line CD, both tau long; the diagonal cuts off a height of tau/2",
        [
            ("merged", [ring([(0, 0), (1, 0), (0, 1)])], True),
            ("bounced", [ring([(0, 0), ("1/2", "1/2"), (1, 0)])], True),
        ],
    )


def reflex() -> tuple[str, str, list[Layer]]:
    """An L."""
    return (
        "Figure 2: a reflex vertex",
        "nothing is lopped, and 270 degrees at (1, 1) stay",
        [("mesh", [ring(printed.POLYGONS["reflex"])], True)],
    )


def growing_boundary() -> tuple[str, str, list[Layer]]:
    """The region, and what is left after the first half-step."""
    region = outline(printed.GROWING)
    parts = halving(region, as_printed=True) if region else None
    left: list[Sequence[HPoint]] = []
    gone: list[Sequence[HPoint]] = []
    for step, r in zip(parts.steps, parts.rectangles, strict=True) if parts else ():
        (gone if step == 1 else left).append(_box(r.x0, r.y0, r.x1, r.y1))
    return (
        "Lemma 6: a boundary that grows",
        "cut off first (orange), and the squares cut off later",
        [("mesh", [*left], True), ("block", [*gone], True)],
    )


def placement() -> tuple[str, str, list[Layer]]:
    """v = 3 b and d = b/2."""
    return (
        "Lemma 7: placing the first Steiner point",
        "v = 3 b, d = b/2: 143.13 degrees",
        [
            ("mesh", [_box(0, 0, 6, 3)], True),
            ("bounced", [ring([(0, 0), ("1/2", "3/2"), (0, 3)])], True),
        ],
    )


def guide_line() -> tuple[str, str, list[Layer]]:
    """The C and the line x = 2."""
    return (
        "Lemma 8: a guide line on the boundary",
        "x = 2 meets two edges between vertices",
        [
            ("mesh", [ring(printed.C_SHAPE)], True),
            ("line", [ring([(0, 1), (1, 1)]), ring([(0, 2), (1, 2)])], False),
            ("line", [ring([(1, 0), (1, 1)]), ring([(1, 2), (1, 3)])], False),
            ("bounced", [ring([(2, 0), (2, 3)])], False),
        ],
    )


def _bounced(name: str, title: str, note: str) -> tuple[str, str, list[Layer]]:
    """Figure 9 for a polygon."""
    record: Any = printed.run(name, 4).stages["bounced"]
    return title, note, list(_bounced_layers(record))


def _bounced_layers(record: Bounced) -> Iterable[Layer]:
    for layer in bounced_layers(record):
        yield layer.style, [*layer.rings], layer.style == "outline"


def returning() -> tuple[str, str, list[Layer]]:
    """A path that turns."""
    return _bounced("returning", "Section 5: a path that turns", "red: bounced; green: closed")


def bounces() -> tuple[str, str, list[Layer]]:
    """The order of bounces."""
    return _bounced("bounces", "Section 5: the order of bounces", "by the repaired order")


def _block(title: str, note: str, widths: Sequence[int], heights: Sequence[int]) -> Any:
    """A block's triangles."""
    reduced = printed.recursion(widths, heights)
    xs, ys = reduced.merged.cells.xs, reduced.merged.cells.ys
    triangles = [ring([(xs[x], ys[y]) for x, y in t]) for t in reduced.blocks[0].triangles]
    return title, note, [("cell", triangles, True)]


def uniform() -> tuple[str, str, list[Layer]]:
    """2 x 2."""
    drawn: tuple[str, str, list[Layer]] = _block(
        "Lemmas 10 and 11: equality", "2 x 2 equal cells in 6 triangles", (1, 1), (1, 1)
    )
    return drawn


def sixth() -> tuple[str, str, list[Layer]]:
    """Seven rows."""
    drawn: tuple[str, str, list[Layer]] = _block(
        "Section 5.1: (m - 1)/6", "of 7 rows one line goes", (1, 1), (1, 1, 1, 2, 1, 2, 1)
    )
    return drawn


def aspect() -> tuple[str, str, list[Layer]]:
    """Six columns, five rows."""
    drawn: tuple[str, str, list[Layer]] = _block(
        "Section 5.2: m' < k' fails", "six columns, five rows", (1,) * 6, (1, 1, 1, 2, 2)
    )
    return drawn


def steiner() -> tuple[str, str, list[Layer]]:
    """The cross."""
    return (
        "Section 3.2: a network that branches",
        "four points: a cross of length 4, spanning trees of length 6",
        [
            ("bounced", [ring([(-1, 0), (1, 0)]), ring([(0, -1), (0, 1)])], False),
            ("line", [ring([(-1, 0), (-1, 1), (0, 1), (1, 1), (1, 0), (1, -1), (0, -1)])], False),
        ],
    )


DRAWINGS: Mapping[str, Drawing] = {
    "cutting-line": cutting_line,
    "slit": slit,
    "unit": unit,
    "closest-corner": closest_corner,
    "thin-face": thin_face,
    "reflex": reflex,
    "unit-square": unit_square,
    "zig-zag": zig_zag,
    "three-corners": three_corners,
    "end-face": end_face,
    "obtuse-end-face": obtuse_end_face,
    "low-corner": low_corner,
    "growing-boundary": growing_boundary,
    "placement": placement,
    "guide-line": guide_line,
    "returning": returning,
    "bounces": bounces,
    "uniform": uniform,
    "sixth": sixth,
    "aspect": aspect,
    "steiner": steiner,
}
"""By file name."""
