"""The errata: each printed sentence, what is wrong, and the repair."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from proofs.printed import written


@dataclass(frozen=True)
class Erratum:
    """One sentence that does not hold as printed.

    Parameters
    ----------
    where : str
        Its place in the paper.
    printed : str
        The sentence.
    refuted : str
        `module.function` of the refuted statement: its work checks the counterexample.
    counterexample : str
        In words.
    wrong : str
        What goes wrong in the proof.
    repair : str
        What the code does instead.
    repaired : sequence of str
        `module.function` of the statements about the repaired form.
    drawing : str
        A name in `drawings.DRAWINGS`, or nothing.
    """

    where: str
    printed: str
    refuted: str
    counterexample: str
    wrong: str
    repair: str
    repaired: Sequence[str] = ()
    drawing: str = ""


ERRATA: Sequence[Erratum] = (
    Erratum(
        "Section 2, Lemma 1",
        "The cutting line l for acute vertex v crosses the segment joining v to the closest "
        "distinct vertex w one-third of the way from v to w. [...] The feature size of P' is at "
        "least s/3.",
        "printed.cutting_line",
        f"{written('cutting-line')}: (s'/s)^2 < 0.0368, s'/s < 1/5.",
        '"A line segment connecting v to a non-incident edge in P loses at most one-third of its '
        'length from each end": the line crosses vw at a third, but its legs are up to '
        "sqrt(2)/3 |vw| long.",
        "Both edges at v are cut at |vw|/3 from v, rounded down to rationals.",
        ("lemma_1.feature_size", "lemma_1.triangle_height"),
        "cutting-line",
    ),
    Erratum(
        "Section 2, dicing",
        "Let b = s/8. Each vertex of P' falls into a different square in this grid.",
        "printed.different_squares",
        f"{written('slit')}: two tips across a slit.",
        "The feature size is measured within P'; vertices on different sheets may be as near in "
        "the plane as one likes.",
        "The sentence is meant for each sheet, and exterior grid vertices are kept apart for every "
        "edge.",
        ("section_2.sheets_are_wedges",),
        "slit",
    ),
    Erratum(
        "Section 2, dicing",
        "Let b = s/8. [...] (Our choice of b = s/8 guarantees that at most one vertex of each "
        "face warps in this step.)",
        "printed.unit",
        f"The triangle {written('right-triangle')}: s' < 2 sqrt 2 b, blocks of P' overlap.",
        "s is the feature size of P; that of P' may be s/3, and 8/3 < 2 sqrt 2.",
        "b is a rational just below s'/8, from the exact s'.",
        ("section_2.sheets_are_wedges", "section_2.blocks_are_disjoint"),
        "unit",
    ),
    Erratum(
        "Section 2, warping; Lemma 2",
        "Each vertex v of P' chooses the closest vertex c of the square it occupies. [...] "
        "Neighbor and occupied squares can be triangulated with maximum angle at most 135.",
        "printed.closest_corner",
        f"{written('closest-corner')}: with the closest corner one block face has no "
        "triangulation within 138.5 degrees.",
        "The case analysis is by sections of length b/8. An edge that crosses just beyond a grid "
        "vertex, by delta < b/8, leaves a warped triangle with 135 degrees + arctan(delta), up to "
        "142.125.",
        "Corners are tried in order of distance; the first is taken with which every face of the "
        "block keeps 135 degrees and its heights.",
        (),
        "closest-corner",
    ),
    Erratum(
        "Section 2, Lemma 2",
        "A detailed case analysis shows that all faces can actually be triangulated with height "
        "almost b/8.",
        "printed.almost_an_eighth",
        f"The triangle {written('thin-face')}: a face outside blocks with no triangulation of "
        "a height above 0.091 b, next to b/(8 sqrt 2) = 0.088 b.",
        "An edge of length b/8 at 45 degrees to the longest edge of its triangle gives "
        "b/(8 sqrt 2).",
        "The bound is tau/sqrt 2, for blocks of 2 x 2 squares tau/2.",
        ("theorem_1.height", "section_2.corner_block_height"),
        "thin-face",
    ),
    Erratum(
        "Section 2, proof of Lemma 2",
        "When the face warps, at most two of its vertices move, moving at most b/8.",
        "printed.two_vertices_move",
        f"The octagon {written('three-corners')}: in a slanted corridor 45 b wide a face 1 b "
        "high has one corner near the wall on its right and two near the steep one on its left.",
        "At most two edges cross the rectangle, but others may pass within b/8 of its corners.",
        "The proof needs this nowhere: faces stay convex, with at most six sides, and sides on at "
        "most two edges of P', whose slopes have the same sign.",
        (
            "outside_blocks.faces_before_warping",
            "outside_blocks.faces_after_warping",
            "outside_blocks.sides_by_moving",
        ),
        "three-corners",
    ),
    Erratum(
        "Section 2, proof of Lemma 2",
        "We may assume that [...] the angle counterclockwise between this edge and the other "
        "measures between 90 and 180.",
        "printed.reflex_vertices",
        "Any L.",
        "Lopping leaves reflex vertices, with angles up to 360 degrees.",
        "All interior angles from 90 to 360 degrees are cases.",
        (),
        "reflex",
    ),
    Erratum(
        "Section 2, Lemma 3",
        "Q can be triangulated with O(n) triangles of height at least b.",
        "printed.height_b",
        "The unit square, b = 1: every triangulation without new boundary vertices has a smaller "
        "height.",
        "A face has feature size b, a triangle of it less: a square's half has b/sqrt 2.",
        "The bound is b/sqrt 2, and it is tight.",
        ("lemma_3.height", "lemma_3.triangles"),
        "unit-square",
    ),
    Erratum(
        "Section 2, proof of Lemma 3",
        "Such a face can be triangulated with triangles of height at least b by adding diagonals "
        "in a zig-zag fashion from top to bottom.",
        "printed.zig_zag",
        "Columns 1 x H with a subdivision on one side at H - 1: height^2 = 1/(H^2 + 1), for H = 2 "
        "already less than 1/2.",
        "A zig-zag takes no notice of where the subdivision is.",
        "The side with the lower next point goes on, so that every apex is level with its base.",
        ("lemma_3.height", "lemma_3.one_subdivision"),
        "zig-zag",
    ),
    Erratum(
        "Section 3, proof of Lemma 5",
        "Height Omega(s) comes for free. [...] All slopes are bounded away from -1, so this "
        "property is preserved by the projection.",
        "printed.end_face_height",
        f"The triangle {written('right-triangle')}: an end face of height 0.016 b. "
        f"{written('thin-end-face')}, turned by the angle in `corpus/errata.py`: 0.00015 b.",
        "A projection can land next to the end of e; nothing keeps them apart.",
        "The first and the last diagonal may be left out; the fewest diagonals are drawn that "
        "keep both bounds.",
        ("merged_faces.every_merged_face", "merged_faces.height_of_merged_faces"),
        "end-face",
    ),
    Erratum(
        "Section 3, proof of Lemma 5",
        "End faces must be convex quadrilaterals or triangles with maximum angle 150. Hence either "
        "diagonal triangulates a quadrilateral end face with maximum angle at most 150.",
        "printed.end_face_angle",
        f"The triangle {written('obtuse-end-face')}: a convex end face with 150.9 degrees where a "
        "row ends on e.",
        "e leaves the block through its upper side with any slope above 1/2: there the end face "
        "has up to 180 degrees - arctan(1/2) = 153.43. The diagonal to the other side leaves "
        "this angle whole.",
        "The diagonal from that corner, which splits the angle; it always does.",
        ("lemma_4.end_faces_have_four_sides", "merged_faces.every_merged_face"),
        "obtuse-end-face",
    ),
    Erratum(
        "Section 3, Lemma 5",
        "(Not printed: tau/sqrt 2 = b/(8 sqrt 2) would be the height that Lemma 2's faces have.)",
        "printed.end_face_bound",
        f"{written('low-corner')}, turned by the angle in `corpus/errata.py`: 0.626 tau, "
        "with every choice of diagonals.",
        "Where a row ends on e beyond a crossing with a line that hits e, both distances may be "
        "tau.",
        "The bound is tau/2, for Theorems 2 and 3.",
        ("lemma_5.end_face_height",),
        "low-corner",
    ),
    Erratum(
        "Section 3.1, proof of Lemma 6",
        "By removing O(n) unit squares, we can ensure that all corners have even coordinates. "
        "[...] At each stage, the squares removed have total perimeter length O(n).",
        "printed.growing_boundary",
        "Seven unit squares: the boundary grows from 16 to 18; no region of at most six squares "
        "does that. [0, 6] x [0, 4] minus [2, 3] x [3, 4] grows from 22 to 24.",
        "The bound on each stage needs a boundary that stays O(n), which fixed parity does not "
        "give.",
        "The parity is chosen at each half-step; the boundary never exceeds N.",
        ("lemma_6.boundary", "lemma_6.vertices", "lemma_6.steps_on_small_regions"),
        "growing-boundary",
    ),
    Erratum(
        "Section 3.1, proof of Lemma 7",
        "Distances d, d' > 0 are chosen so that v/2 - b <= d, d' <= v/2 + b.",
        "printed.placement",
        "v = 3 b, d = b/2: 143.13 degrees. v = 2 b admits d next to 0. [0, 20] x [0, 2], "
        "subdivisions at x = 10 and y = 1, d = 2: 146.31 or 153.43 degrees.",
        "At d = v/2 - b an undivided side is seen under more than 135 degrees; at d = v/2 + b a "
        "long base of the top is.",
        "d = v/2, unless a projection is within b of there: then the nearest one.",
        ("lemma_7.angles", "lemma_7.heights", "lemma_7.counts"),
        "placement",
    ),
    Erratum(
        "Section 3.2, lower bound",
        "The total perimeter length of the rectangles is at least the length of the minimum "
        "spanning tree.",
        "theorems_2_3.mst_step",
        "Four points and a cross between them.",
        "A network may branch where there is no vertex: it is a Steiner tree.",
        "2/3 of the spanning tree (Hwang 1976); the order n^1.5 stays.",
        ("theorems_2_3.steiner_ratio",),
        "steiner",
    ),
    Erratum(
        "Section 3.2, proof of Lemma 8",
        "The initial partition is a set of infinitely-tall rectangles, formed by choosing vertical "
        "grid lines.",
        "printed.guide_line",
        "A C of seven cells: the line x = 2 meets the boundary at two points that are no vertices.",
        "New vertices on the boundary of Q are vertices of no triangle outside.",
        "Each guide line is snapped to the chords at the left sides of the columns it passes.",
        ("lemma_8.vertices",),
        "guide-line",
    ),
    Erratum(
        "Section 5",
        "Once we have bounced these subdivision points, all subdivision points are the sort that "
        "return to their own sides.",
        "printed.returning",
        f"The pentagon {written('returning')}.",
        "A path of the other sense can wind inward, meet the middle and turn there.",
        "What is pending in the middle is bounced at once, whenever it comes; paths of the sense "
        "that may turn go first.",
        ("bouncing.verticals", "bouncing.all_polygons_on_a_small_grid"),
        "returning",
    ),
    Erratum(
        "Section 5",
        "Each extension creates a new lone subdivision point; therefore, after O(n) extensions all "
        "subdivision points are alone in their triangles.",
        "printed.order_of_bounces",
        f"{written('bounces')}: 12 half-steps with the farthest triangle first, 10 "
        "by the repaired order; quadratic on families of spirals.",
        "A lone subdivision does not stay alone: a path bounced later may arrive beside it.",
        "The conflict that comes first in the direction of motion is settled first.",
        ("bouncing.verticals", "bouncing.all_polygons_on_a_small_grid"),
        "bounces",
    ),
    Erratum(
        "Section 5.1, Lemmas 10 and 11",
        "Its width is greater than either of the distances [...] with min{a, b} at least as large "
        "as (1/2 + eps) m of the row heights.",
        "printed.strictness",
        "Equal cells, 2 x 2.",
        "Lemma 11 counts rows that are not higher than the column is wide, Lemma 10 wants them "
        "lower: on a uniform grid it allows nothing.",
        "a^2 >= c d, which is necessary and sufficient.",
        ("section_5.lemma_10", "section_5.lemma_11"),
        "uniform",
    ),
    Erratum(
        "Section 5.1",
        "By Lemma 11 we can eliminate m/6 rows between the two columns.",
        "printed.sixth",
        "Seven rows of heights 1, 1, 1, 2, 1, 2, 1 and two columns: one line, less than 7/6.",
        "m rows have m - 1 lines.",
        "(m - 1)/6, exactly.",
        ("section_5.lemma_11", "section_5.lemma_11_patterns"),
        "sixth",
    ),
    Erratum(
        "Section 5.1",
        "Columns l and r are separated by at least n/3 columns.",
        "printed.separation",
        "Two equal columns.",
        "The third includes l and r themselves (and n is meant to be k).",
        "l, r and what is between are at least k/3.",
        ("section_5.separation",),
    ),
    Erratum(
        "Section 5.1",
        "We also triangulate columns l and r, using m triangles.",
        "printed.strips",
        "2 x 2 equal cells: six triangles.",
        "Both columns have m rectangles.",
        "2 m - e triangles each, e lines being removed.",
        ("lemma_12_rounding.recurrence",),
    ),
    Erratum(
        "Section 5.2",
        "c (1.1824 m^0.8475)(0.85192 k) - c (0.39414 m^0.8475)(0.01858 k)",
        "lemma_12.lower_bound_0_39414",
        "m_2 = m/3: 3^-0.8475 = 0.394130...",
        "A lower bound is rounded up. With 0.39413 the end is 0.9999873, and holds.",
        "Every number is enclosed by rationals.",
        ("lemma_12.printed_numbers", "lemma_12.exponent"),
    ),
    Erratum(
        "Section 5.2",
        "Note that m' < k' for all subproblems involved, so the inductive hypothesis can be used "
        "directly.",
        "printed.aspect",
        "Six equal columns, five rows of heights 1, 1, 1, 2, 2.",
        "An outer part may have few columns.",
        "The potential m^x k + m k^x, which is symmetric.",
        ("lemma_12.contraction", "lemma_12_rounding.constant"),
        "aspect",
    ),
    Erratum(
        "Section 5.2",
        "0.99999 c m^0.8475 k + O(k). So if c is large enough the result is O(m^0.8475 k).",
        "lemma_12.potential_of_the_paper",
        "m = k, k_1 = 0.113 k, k_2 = k/3: with min^x max for parts of either shape the sum is "
        "1.0159 times what it was.",
        "As before; besides, the rounding terms are left out.",
        "The same potential, with every rounding term, to the explicit constant 5/2.",
        ("lemma_12.contraction", "lemma_12_rounding.constant"),
    ),
)
"""In the paper's order."""

REMARKS: Sequence[tuple[str, str]] = (
    (
        "Edges of slope 1 or -1",
        "Section 2 excludes axis-parallel edges only. Of an exactly diagonal edge, q-vertices on a "
        "row and on a column can be equally near to a grid vertex: the code turns P once more.",
    ),
    (
        "Letters in Section 5.1",
        "In the first recurrence the arguments of R are exchanged (R(l - 1, m) has l - 1 columns); "
        "n/3 and m/3, of columns, mean k/3.",
    ),
    (
        "End faces of at most four sides",
        "True with all diagonals drawn (`lemma_4.end_faces_have_four_sides`).",
    ),
    (
        "Blocks of 2 x 2 squares",
        "They are no part of the paper. tau/sqrt 2 does not hold there: 0.624 tau is possible "
        "(`section_2.corner_block_height`); tau/2 is asserted.",
    ),
    (
        "Where Theorem 4 pays",
        "The explicit bound of O(n^1.8475) is below that of O(n^2) from n = 5.9 10^9 on "
        "(`theorem_4.where_the_exponent_pays`). On meshes it pays at once.",
    ),
    (
        "A better exponent in Section 5",
        "The same construction has O(n^1.792) triangles. Rows outside t and b are all lower than l "
        "and r are wide, so that half of the lines among them go between l and r as well: where "
        "the outer parts are long, the part between shrinks by more than a sixth. "
        "3 (m^0.8 k + m k^0.8) triangles for a block are enough "
        "(`lemma_12_rounding.better_exponent`), also 13 times the same with 0.792 "
        "(`lemma_12_rounding.least_exponent`).",
    ),
    (
        "Sharper than asked",
        "Lemma 6: 1.5 N log2 N - N; Lemma 8: N + N^1.5; the long sides of Section 5.1's blocks: N.",
    ),
)
"""What is no erratum but worth knowing."""
