"""Sentences that are false as printed: the smallest exact counterexamples found, checked anew.

Each is run through the product's own construction and measured by the checkers that evaluate
printed sentences (`bern_exact/checkers/as_printed.py`, `printed_*.py` and others).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from typing import Any

from gmpy2 import mpq

from bern_exact.api import Result, triangulate
from bern_exact.checkers import bounds
from bern_exact.checkers.as_printed import check_swept_as_printed
from bern_exact.checkers.chords import Turns
from bern_exact.checkers.definition_2 import check_definition_2
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.lemma_5 import check_lemma_5
from bern_exact.checkers.lemma_6 import check_lemma_6_as_printed
from bern_exact.checkers.lemma_10 import check_lemma_10_as_printed
from bern_exact.checkers.lemma_11 import check_lemma_11_as_printed
from bern_exact.checkers.printed_ends import best_height
from bern_exact.checkers.printed_recursion import check_lemma_12_as_printed
from bern_exact.checkers.rings import places_of
from bern_exact.convex.block_records import Block, Blocks, Reduced
from bern_exact.convex.bounce import bounce
from bern_exact.convex.cells import Cells
from bern_exact.convex.frame import convex_frame
from bern_exact.convex.reduction import Lines, reduce_block
from bern_exact.corpus.convex import occupied_spiral
from bern_exact.corpus.draws import hpoints
from bern_exact.corpus.errata import BY_NAME
from bern_exact.exact.enclosures import decimal_enclosure
from bern_exact.exact.points import hpoint
from bern_exact.figures import digits_of
from bern_exact.interior.records import Rectilinear
from bern_exact.interior.subdivided.halving import halving
from bern_exact.interior.sweep import sweep
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings
from proofs.polyominoes import outline, polyominoes
from proofs.statement import Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements

Place = tuple[int | str | mpq, int | str | mpq]

POLYGONS: Mapping[str, Sequence[Place]] = {
    "closest-corner": [
        ("0.22", "-0.09"),
        ("-2.3", "-7.68"),
        ("14.14", "-21.6"),
        ("39.22", "-46.09"),
        ("41.22", "2.9"),
        ("25.56", "8.98"),
        ("3.63", "8.23"),
    ],
    "thin-face": [(1, 1), (2, 0), (4, 3)],
    "right-triangle": [(0, 0), (2, 0), (2, 1)],
    "reflex": [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)],
    "returning": [(0, 0), (1, 0), (3, 1), (1, 3), (0, 1)],
    "bounces": [(1, 1), (4, 0), (6, 0), (6, 8), (5, 8), (3, 6), (2, 4)],
}
"""Polygons beside those of the corpus (`bern_exact.corpus.errata`): smaller, or further off."""

GROWING = frozenset({(0, 0), (0, 2), (1, 0), (1, 1), (1, 2), (2, 1), (3, 1)})
"""Seven unit squares whose boundary grows if corners go to even coordinates."""

C_SHAPE = (
    ((0, 0), (1, 0), (3, 0), (3, 1), (1, 1), (1, 2), (2, 2), (2, 3), (1, 3))
    + ((0, 3), (0, 2), (0, 1))
)  # fmt: skip
"""A rectilinear polygon with the matching condition: the ends of its chords are vertices."""

SPIRAL = 160
"""Vertices of the spiral of the corpus on which many paths turn."""

TALL = 2
"""The height of a face 1 wide that the zig-zag makes thin."""


def polygon_of(name: str) -> Polygon:
    """A polygon, of those above or of the corpus."""
    if name in BY_NAME:
        return polygon_from_rings(hpoints(BY_NAME[name].rings))
    return polygon_from_rings([[hpoint(mpq(x), mpq(y)) for x, y in POLYGONS[name]]])


def written(name: str) -> str:
    """The vertices of a polygon, before it is turned."""
    ring = BY_NAME[name].given[0] if name in BY_NAME else POLYGONS[name]
    return ", ".join(f"({digits_of(mpq(x))}, {digits_of(mpq(y))})" for x, y in ring)


@cache
def run(name: str, theorem: int) -> Result:
    """A polygon's construction, printed sentences evaluated beside the guarantees."""
    return triangulate(polygon_of(name), theorem=theorem, as_printed=True)


def dot_and_cross(before: Place, apex: Place, after: Place) -> tuple[mpq, mpq]:
    """Of the vectors from a point to the next and to the one before it."""
    (bx, by), (x, y), (ax, ay) = ((mpq(u), mpq(v)) for u, v in (before, apex, after))
    ux, uy, vx, vy = ax - x, ay - y, bx - x, by - y
    return ux * vx + uy * vy, ux * vy - uy * vx


def named(findings: Iterable[Finding], claim: str) -> Finding:
    """One claim."""
    (found,) = (f for f in findings if f.claim == claim)
    return found


def failing(found: Finding) -> str:
    """Demand that a printed sentence fails; what was measured and what is printed."""
    demand(found.role == "as-printed" and found.cases > 0, f"{found.claim} is evaluated")
    demand(not found.holds, f"{found.claim} fails")
    return f"{found.claim}: {_brief(found.measured)}, printed {_brief(found.bound)}"


def _brief(value: Any) -> str:
    """An exact value in a few characters."""
    if isinstance(value, dict):
        return f"{_brief(value['lower'])} to {_brief(value['upper'])}"
    text = str(value)
    return text if len(text) < 12 else decimal_enclosure(mpq(text), mpq(text), 6)[0] + "..."


def on(name: str, theorem: int, claim: str) -> str:
    """A printed sentence that fails on a polygon."""
    return failing(named(run(name, theorem).certificate.claims, claim))


@CHAPTER.refuted("Lemma 1", "With the paper's cutting line the feature size of P' is at least s/3.")
def cutting_line() -> str:
    """The line crosses vw at a third, but its legs reach up to sqrt(2)/3 |vw|."""
    return on("cutting-line", 1, "lemma-1.printed-feature-size")


@CHAPTER.refuted("Section 2, dicing", "Each vertex of P' falls into a different square.")
def different_squares() -> str:
    """True on each sheet: two tips across a slit outside are near in the plane alone."""
    return on("slit", 1, "dicing.printed-different-squares")


@CHAPTER.refuted(
    "Section 2, dicing", "With b = s/8 and s' >= s/3 blocks do not overlap: s' > 2 sqrt 2 b."
)
def unit() -> str:
    """s' can be as small as s/3: 8/3 < 2 sqrt 2.  Here b is taken from s'."""
    demand(bool(mpq(8, 3) ** 2 < 8), "(8/3)^2 < 8")
    return on("right-triangle", 1, "dicing.printed-unit")


@CHAPTER.refuted(
    "Lemma 2",
    "If each vertex chooses the closest corner of its square, every block face can be triangulated "
    "with angles of at most 135 degrees.",
)
def closest_corner() -> str:
    """A vertex near the middle of its square; an edge just beyond a grid vertex of its block."""
    on("closest-corner", 1, "lemma-2.printed-closest-corner")
    return on("closest-corner", 1, "lemma-2.printed-block-angle")


@CHAPTER.refuted("Lemma 2", "All faces can actually be triangulated with height almost b/8.")
def almost_an_eighth() -> str:
    """An edge of length tau at 45 degrees to the longest edge of its triangle: tau/sqrt 2.

    A face outside blocks, by the best of all its triangulations.
    """
    on("thin-face", 1, "lemma-2.printed-height")
    mesh: Any = run("thin-face", 1).stages["boundary"]
    places = places_of(mesh)
    faces = [[places[node] for node in face.ring] for face in mesh.faces if face.block < 0]
    best = min(best_height(ring) for ring in faces)
    demand(bool(0 < best < mpq(91, 1000) ** 2 < bounds.TAU**2), "every triangulation of a face")
    return f"(best height of a face/b)^2 = {_brief(best)}, less than 0.091^2; printed 1/64"


@CHAPTER.refuted("Lemma 2", "When a face outside blocks warps, at most two of its vertices move.")
def two_vertices_move() -> str:
    """Two corners of a rectangle move onto a steep edge on its left, one onto that on its right."""
    return on("three-corners", 1, "lemma-2.printed-moved")


@CHAPTER.refuted(
    "Lemma 2, Figure 2", "The angle between the two edges at v measures between 90 and 180 degrees."
)
def reflex_vertices() -> str:
    """Lopping leaves reflex vertices as they are."""
    _, turn = dot_and_cross(*POLYGONS["reflex"][2:5])
    demand(bool(turn < 0), "more than 180 degrees at (1, 1)")
    return "an L of three squares has 270 degrees at (1, 1)"


@CHAPTER.refuted("Lemma 3", "Q can be triangulated with triangles of height at least b.")
def height_b() -> str:
    """The unit square: the triangle at its lower side, whose ends are the only vertices there,

    has its apex either inside, less than 1 above, or at an upper corner, with sqrt 2 as its longest
    side; the height is at most the altitude on any side.
    """
    (ring,) = BY_NAME["unit-square"].rings
    square = Rectilinear((tuple((int(x), int(y)) for x, y in ring),))
    return failing(named(check_swept_as_printed(sweep(square)), "lemma-3.printed-height"))


def tall_region(height: int = TALL) -> Rectilinear:
    """[0, 2] x [0, height] with the line x = 1 and a row at height - 1, both between vertices."""
    h = height
    return Rectilinear((((0, 0), (1, 0), (2, 0), (2, h - 1), (2, h), (1, h), (0, h), (0, h - 1)),))


@CHAPTER.refuted("Lemma 3", "A zig-zag of diagonals from top to bottom has height at least b.")
def zig_zag() -> str:
    """A subdivision next to the top: the last diagonal goes down nearly the whole face."""
    swept = sweep(tall_region())
    demand(all(f.holds for f in check_definition_2(swept.region)), "the matching condition")
    found = named(check_swept_as_printed(swept), "lemma-3.printed-zig-zag")
    demand(mpq(str(found.measured)) < bounds.INTERIOR_HEIGHT_SQUARED, "less than b/sqrt 2, even")
    return failing(found)


@CHAPTER.refuted(
    "Lemma 5", "In the end faces height comes for free, of order s (at least b/5000, say)."
)
def end_face_height() -> str:
    """A projection lands next to the end of e: as near as one likes, while s stays as it is."""
    claims = run("thin-end-face", 2).certificate.claims
    thinner = mpq(str(named(claims, "lemma-5.printed-end-height").measured))
    demand(bool(0 < thinner < mpq(1, 5000) ** 2), "less than b/5000")
    found = on("right-triangle", 2, "lemma-5.printed-end-height")
    return f"{found}; another triangle: {_brief(thinner)}"


@CHAPTER.refuted(
    "Lemma 5",
    "Even with the best choice of diagonals heights are at least tau b/sqrt 2, as in other faces.",
)
def end_face_bound() -> str:
    """Both distances from the last crossing to e can be tau; then the least height is tau/2."""
    made = run("low-corner", 2)
    merged: Any = made.stages["merged"]
    height = named(check_lemma_5(merged), "lemma-5.height")
    measured = mpq(str(height.measured))
    demand(height.holds, "tau/2 is kept")
    demand(bool(measured < bounds.boundary_height_squared()), "less than tau/sqrt 2")
    return f"(height/tau)^2 = {_brief(measured / bounds.TAU**2)}, not 1/2; tau/2 is kept"


@CHAPTER.refuted(
    "Lemma 5", "End faces have maximum angle 150, so that either diagonal triangulates them."
)
def end_face_angle() -> str:
    """A row ends on an edge of slope between 1/2 and tan 30; the limit is 180 - arctan(1/2)."""
    return on("obtuse-end-face", 2, "lemma-5.printed-end-angle")


@CHAPTER.refuted(
    "Lemma 6",
    "Cutting off squares until all corners have even coordinates never makes the boundary longer.",
)
def growing_boundary() -> str:
    """Seven unit squares, and none of all regions of up to six, origins at their first vertex."""
    for size in range(1, len(GROWING)):
        for cells in polyominoes(size):
            region = outline(cells)
            demand(region is None or _boundary_as_printed(region).holds, f"{size} squares")
    region = outline(GROWING)
    demand(region is not None, "no hole")
    return failing(_boundary_as_printed(region)) if region is not None else ""


def _boundary_as_printed(region: Rectilinear) -> Finding:
    (found,) = check_lemma_6_as_printed(halving(region, as_printed=True))
    return found


@CHAPTER.refuted(
    "Lemma 7",
    "With v/2 - b <= d <= v/2 + b every triangle at the first Steiner point has angles of at most "
    "135 degrees.",
)
def placement() -> str:
    """v = 3 b, d = b/2; v = 2 b allows d = 0; [0, 20] x [0, 2] with x = 10, d = 2."""
    half = mpq(1, 2)
    *_, top, corner, _ = BY_NAME["subdivided-rectangle"].rings[0]
    foot = (top[0], 1)
    demand(mpq(3, 2) - 1 <= half <= mpq(3, 2) + 1 and 1 - 1 <= 0 <= 1 + 1, "both are allowed")
    for before, apex, after in (
        ((0, 3), (half, mpq(3, 2)), (0, 0)),
        (corner, (2, 1), top),
        (corner, (2, 1), foot),
    ):
        dot, cross = dot_and_cross(before, apex, after)
        demand(bool(dot + abs(cross) < 0), f"more than 135 degrees at {apex}")
    return "143.13 degrees for v = 3, d = 1/2; d = 0 lies on the boundary; 146.31 or 153.43"


@CHAPTER.refuted(
    "Lemma 8", "Vertical grid lines divide the plane into rectangles without new boundary vertices."
)
def guide_line() -> str:
    """The line x = 2 through two vertices meets other edges of the C between their vertices."""
    region = Rectilinear((C_SHAPE,))
    demand(all(f.holds for f in check_definition_2(region)), "the matching condition")
    demand(2 in {x for x, _ in C_SHAPE}, "x = 2 is a grid line")
    demand({(2, 0), (2, 1)}.isdisjoint(C_SHAPE), "(2, 0) and (2, 1) are no vertices")
    return "x = 2 meets the boundary at (2, 0) and (2, 1), between vertices"


def recursion(widths: Sequence[int], heights: Sequence[int]) -> Reduced:
    """The recursion of Lemma 12 on one rectangle."""
    lines = []
    for gaps in (widths, heights):
        at = [mpq(0)]
        for gap in gaps:
            at.append(at[-1] + gap)
        lines.append(tuple(at))
    xs, ys = lines
    block = Block(0, len(widths), 0, len(heights))
    cells = Cells(xs, ys, (0,) * len(widths), (len(heights),) * len(widths))
    made = reduce_block(block, Lines.between(xs), Lines.between(ys))
    return Reduced(Blocks(cells, (block,)), (made,))


@CHAPTER.refuted(
    "Section 5",
    "Once those in the middle have been bounced, all subdivision points return to their own sides.",
)
def returning() -> str:
    """A counter-clockwise path can meet the middle later, and turns there.

    Besides, on a spiral of the corpus with 160 vertices.
    """
    ring = [hpoint(x, y) for x, y in occupied_spiral(SPIRAL)[0]]
    frame = convex_frame(polygon_from_rings([ring]))
    turns = Turns(frame)
    outside = [(x, side) for x, side in bounce(frame).first if turns.zone(x)]
    lost = sum(turns.turn(x, side) is None for x, side in outside)
    demand(lost == 63, f"{lost} on the spiral")
    found = on("returning", 4, "bounce.printed-return")
    return f"{found}; {lost} of {len(outside)} on occupied-spiral {SPIRAL}"


@CHAPTER.refuted(
    "Section 5", "Each bounce leaves one more subdivision alone, whichever triangle is next."
)
def order_of_bounces() -> str:
    """With the farthest triangle first, a later path reaches what had been left alone."""
    return on("bounces", 4, "bounce.printed-order")


@CHAPTER.refuted(
    "Lemmas 10 and 11", 'Lemma 10\'s "greater than" allows what Lemma 11\'s "at least" removes.'
)
def strictness() -> str:
    """Two by two equal cells: the printed condition removes nothing, a^2 >= c d one line."""
    found = check_lemma_10_as_printed(recursion((1, 1), (1, 1)))
    return failing(named(found, "lemma-10.printed-width"))


@CHAPTER.refuted("Section 5.1", "We can eliminate m/6 rows between the two columns.")
def sixth() -> str:
    """Seven rows of heights 1, 1, 1, 2, 1, 2, 1: one line goes, (m - 1)/6."""
    reduced = recursion((1, 1), (1, 1, 1, 2, 1, 2, 1))
    return failing(named(check_lemma_11_as_printed(reduced), "lemma-11.printed-sixth"))


@CHAPTER.refuted("Section 5.1", "Columns l and r are separated by at least a third of the columns.")
def separation() -> str:
    """Two columns: nothing is between.  True if l and r themselves are counted."""
    reduced = recursion((1, 1), (1, 1))
    return failing(named(check_lemma_12_as_printed(reduced), "lemma-12.printed-separation"))


@CHAPTER.refuted("Section 5.1", "Columns l and r are triangulated using m triangles.")
def strips() -> str:
    """They have m rectangles each: 2 m - e triangles each, e lines being removed."""
    reduced = recursion((1, 1), (1, 1))
    return failing(named(check_lemma_12_as_printed(reduced), "lemma-12.printed-strips"))


@CHAPTER.refuted("Section 5.2", "m' < k' for all subproblems, if m < k and the split is by rows.")
def aspect() -> str:
    """Six equal columns, rows of heights 1, 1, 1, 2, 2."""
    reduced = recursion((1,) * 6, (1, 1, 1, 2, 2))
    return failing(named(check_lemma_12_as_printed(reduced), "lemma-12.printed-aspect"))
