"""Lemma 5: every merged face can be cut up, its angles and its heights.

Notation is that of `lemma_4`; tau <= 1/8, b = 1.  The projection of a staircase vertex c is the
point c + (x, -x) of e; write t(c) for the sum of c's coordinates.

**The cuts.** All staircase vertices between a and b in t are projected, but for c_2 if c_0 c_1 is
on a row, c_2 = (0, 1) in the place of `lemma_4.row_at_a_block`, and w > 1 - `left_out()`; and for
its mirror image at b.  (These are among the choices of `bern_exact.boundary.project.best_cuts`.) If
c_2 is left out and c_(m-1) b is on a column, c_2 is not the last vertex projected: else c_3 = (k,
1), b = (k, 1 - w'), w' >= tau, and e has a slope between 1/2 and 2: a and b would be less than sqrt
5 (1 - tau) apart.  But they are less than sqrt 8 from the ends of e, which are at least 8 apart.
"""

from __future__ import annotations

import sympy
from gmpy2 import mpq

from bern_exact.checkers import bounds
from bern_exact.checkers.bounds_grid import FACTOR
from proofs.algebra import demand_equal, demand_nonnegative, symbols
from proofs.statement import IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements

TAU = bounds.TAU
ROOT_2 = mpq(99, 70)
"""More than sqrt 2."""


def left_out(tau: mpq = TAU) -> mpq:
    """How near to 1 w is if c_2 is left out: 2 y/(1 + y), y = tan(arctan 2 tau - arctan tau)."""
    y = tau / (1 + 2 * tau * tau)
    return 2 * y / (1 + y)


def stretch(slope: mpq) -> mpq:
    """At least the length over the growth of t of an edge of this slope: sqrt(1 + s^2)/(1 - s)."""
    return (1 + slope * slope / 2) / (1 - slope)


@CHAPTER.proved(
    "Lemma 5 (repaired)",
    "The cuts of a merged face leave pieces with triangulations by their own vertices in which no "
    "angle is above 135 degrees + arctan(2 tau).",
    IDENTITY,
)
def every_merged_face() -> str:
    """Piece by piece, t being monotone (`lemma_4`):

    - Between neighbouring projections: a trapezoid, with the angles of
      `lemma_5.diagonals_meet_the_edge` and `.diagonals_leave_the_staircase`, split by either
      diagonal.
    - c_0 c_1 on a column: the triangle of a, c_1 and its projection.  At a less than 90 + arctan(2
      tau), at c_1 at most 45 + arctan(2 tau), at the projection less than 135.
    - c_0 c_1 on a row, c_2 projected to f: the triangles c_1 a c_2 and a f c_2.  As t(c_2) > t(a),
      the angle at a of the first is at least 45 degrees (and at most 90 + arctan(2 tau)); e has a
      slope above 1/2: the second has less than 180 - 45 - arctan(1/2) < 135 at a.  At c_1 there are
      at most 90 + arctan(2 tau), at c_2 45 + arctan(2 tau) in all, at f less than 135.
    - c_2 = (0, 1) not projected, f the next projection, of c_3, or b = c_3: the triangle c_1 a c_2,
      with a right angle, and the piece a f c_3 c_2.  Again less than 135 at a and f.  At c_3,
      between edge and diagonal, at most 135 + arctan(2 tau).  At c_2, which is unmoved, the edge
      c_2 c_3 is at most arctan(tau) from the direction right or up: at most 90 + arctan(tau) +
      arctan(1/w), and 1/w <= (1 + y)/(1 - y) = tan(45 + arctan(2 tau) - arctan(tau)).  So it is
      convex, and split by either diagonal.
    - If both c_2 and its mirror image c_3 are not projected, and are neighbours, likewise a b c_3
      c_2.
    - A rectangle with corners moved onto e: at most 90 + 2 arctan(2 tau).
    """
    tau = symbols("tau")
    y = tau / (1 + 2 * tau**2)
    demand_equal((2 * tau - tau) / (1 + 2 * tau * tau), y, "tan(arctan 2 tau - arctan tau)")
    demand_equal(left_out(tau), 1 - (1 - y) / (1 + y), "1 - left_out() = (1 - y)/(1 + y)")
    demand(bool(2 * bounds.slope() < 1 - bounds.slope() ** 2), "rectangles: below 135 degrees")
    common = 5 * (1 - TAU) ** 2  # squared; sqrt(common) + 2 sqrt 8 < 8
    demand(bool(common < 32), "")
    demand(bool(4 * 32 * common < (FACTOR**2 - 32 - common) ** 2), "a and b are further apart")
    return "at c_2 at most 90 + arctan tau + (45 + arctan 2 tau - arctan tau)"


@CHAPTER.proved(
    "Lemma 5 (repaired)",
    "A projected vertex is at least tau/2 beside its projection, and at least 1/2 unless it is an "
    "unmoved grid vertex; along c_0 c_1 on a column, and along every edge from c_1 to c_(m-1), t "
    "grows by at least tau.",
    IDENTITY,
)
def projected_vertices() -> str:
    """x: let e be L to the right of an unmoved grid vertex c, and D below: x = L D/(L + D).

    L, D >= tau, since nearer crossings would have moved c: what is between c and e is in P', as
    there is no end of an edge less than 1 from c, nor another edge so near.  Only a q-vertex whose
    anchor has moved in substep 1 does not choose c: let it be on the row.  Its anchor is a corner
    of the square of an end v of e, and c, on no open block, 1 to the left of it on the block's left
    side. v is above and to the right of the q-vertex, and less than 1 above the row: so e comes
    into the block, upwards, less than 1 below c. All of M is before that: t(b) < t(c), and c is not
    projected.  (Likewise on the column, and t(a) > t(c).)  A grid vertex that has moved onto
    another edge, or a q-vertex there, is at least 1/sqrt 2 from e (`near_a_face`).

    t: a piece of another edge is at least tau long, and rises.  A side between grid vertices grows
    by 1 less 2 tau.  One that ends in a q-vertex on an edge f begins in a grid vertex that has not
    moved onto f.  If it is shorter than 1/sqrt 2, this has not moved onto another edge either
    (`near_a_face`), and the q-vertex has not merged with that on another line, at least 1 from it:
    so the side is axis-parallel, and at least tau long (`section_2.least_edge`).  If it is
    longer, t grows by (1 - 2 tau)/sqrt(1 + 4 tau^2) of it.
    """
    a, c, tau = symbols("a c tau")
    length, depth = tau + a, tau + c
    demand_nonnegative(2 * length * depth - tau * (length + depth), "L D/(L + D) >= tau/2")
    demand(bool(1 / ROOT_2 / stretch(2 * TAU) >= TAU), "(1 - 2 tau)/sqrt(2 (1 + 4 tau^2)) >= tau")
    demand(bool(1 - 2 * TAU >= TAU), "1 - 2 tau")
    return "x = L D/(L + D); 1/sqrt 2 over sqrt 2"


@CHAPTER.proved(
    "Lemma 5 (repaired)",
    "A triangle of a staircase vertex c, its projection p and a point z with t(z) - t(c) = +-T has "
    "twice the area x T, x being the distance between c and p along an axis; pz along e is at "
    "most T and at least T/sqrt 2 long.",
    IDENTITY,
)
def area_of_a_piece() -> str:
    """c = (0, 0), p = (x, -x): the cross product of p and z is x (z_x + z_y).

    On e, of slope m > 0, a length with growth T is T sqrt(1 + m^2)/(1 + m).
    """
    x, m = symbols("x m")
    z, w = sympy.symbols("z w", real=True)
    demand_equal(x * w + x * z, x * (z + w), "x t(z)")
    demand_nonnegative((1 + m) ** 2 - (1 + m**2), "at most T")
    demand_equal(2 * (1 + m**2) - (1 + m) ** 2, (1 - m) ** 2, "at least T/sqrt 2")
    return "(x, -x) x (z, w) = x (z + w)"


@CHAPTER.proved(
    "Lemma 5 (repaired)",
    "The triangulations of `every_merged_face` have heights of at least tau/2, if trapezoids are "
    "split by the better diagonal.",
    "written proof; exact comparisons",
)
def half_of_tau() -> str:
    """By `area_of_a_piece`: twice the area over the longest side.  (The numbers are for tau = 1/8;

    over tau, all of the heights fall as tau grows.)

    - Trapezoids.  By a reflection let c' be above c, c' = c + (g, h), T = g + h, and x and x' to
      their projections p and p'; x' = x + (h - m g)/(1 + m) for the slope m of e.  (i) x, x' >=
      1/3: a triangle has sides of at most sqrt 2 x, `stretch` T and their sum; T >= tau.  (ii) Else
      c and c' are unmoved, g = 0 and h >= 1; or c is unmoved, |g| <= tau h, and c', which is not,
      1/sqrt 2 from e: T >= 1/5.  (If it were c: x' >= x - tau >= 1/2 - tau > 1/3.) Cut along c p';
      p' is x' + g to the right of c and h - x' above it.  If x' <= h, c p' is
      at most T: at least T/sqrt 2, x, and x' over the stretch of c c'.  If x' = h + r: c p' is T +
      r wide and r high, r = x - T m/(1 + m) <= x - T (1 - x/tau), as x (1 + m) is the distance from
      c down to e.  Over c p' are x T (`beside_a_diagonal`) and x' T, at least T (T/(1 + tau) + r)
      over sqrt 2 (T + r).
    - a, c_1 and its projection: T/sqrt 2, x, and x over the stretch of c_0 c_1, which is vertical,
      or belongs to a moved c_1 (x >= 1/2), or a has merged, D' >= 1 below an unmoved c_1 and less
      than tau beside it, and x = L D/(L + D) >= 1/(1/tau + 2), as L >= tau, 1/D <= (1 + tau/L)/D'.
    - c_1 = (0, 0), a = (w, 0), c_2 = (0, 1), projected: w/sqrt 2 in the first triangle; in the
      second T = 1 - w, x >= w, and |a c_2| < sqrt 2: w (1 - w)/sqrt 2 at least, concave in w. c_2 =
      (-k, h), 0 <= k < tau, h >= 2: x >= w + k = z, T = h - z and |a c_2| is h by z: at h = 2 it is
      least, and z (2 - z) is concave. c_2 on another edge: x >= 1/2, h > 7.
    - c_2 = (0, 1) not projected.  It is more than 1 from all edges but e, by the argument (1) of
      `lemma_4.row_at_a_block`: t(c_3) >= t(c_2) + 1 - 2 tau, also if c_3 = b is on e, w or more to
      the right of c_2. c_2 is at least w from the line of e, and the part of e in the piece a f c_3
      c_2 at least (1 - 2 tau)/sqrt 2 long: a f c_2 is high enough.  If c_3 is above c_2, f c_3 c_2
      is c' p' c in a trapezoid.  If it is to the right, x >= 1/2 or c_3 is unmoved: take the
      diagonal a c_3, at most T = t(c_3) - t(a) long, or 2 T if c_3 has moved.  (a c_3 c_2: if c_3
      is K >= 1 - tau to the right, at least K - tau over K + tau + sqrt 2.)  If c_3 is not
      projected either: c_2 c_3 is axis-parallel, b at least w' or 1 from it.
    - Rectangles: sides of at least 1 - 2 tau at angles of at most 90 +- 2 arctan(2 tau).
    """
    third = mpq(1, 3)
    growth = (1 / ROOT_2 - ROOT_2 * third) / stretch(TAU)
    demand(bool(growth >= LEAST_GROWTH), "(ii): T >= 1/5")
    cases = {
        "(i)": 1 / (ROOT_2 / TAU + stretch(2 * TAU) / third),
        "(ii), x' <= h": min(LEAST_GROWTH / ROOT_2, TAU / 2, mpq(1, 2) / stretch(TAU)),
        "(ii), x' > h": LEAST_GROWTH / (1 + TAU) / ROOT_2,
        "column": min(TAU / ROOT_2, TAU / 2, mpq(1, 2) / stretch(2 * TAU)),
        "column, merged": 1 / (1 / TAU + 2) / stretch(TAU),
        **_heights_at_a_row(),
        **_heights_left_out(),
        "rectangle": (1 - 2 * TAU) * mpq(7, 8) / mpq(7, 4),
    }
    for name, height in cases.items():
        demand(bool(height >= TAU / 2), f"{name}: tau/2")
    demand(beside_a_diagonal() >= TAU / 2, "(ii), x' > h, over c p'")
    # cos and sin of 90 +- 2 arctan(2 tau), squared: the third side is below 7/4 of the longer one.
    tangent = (4 * TAU) / (1 - 4 * TAU * TAU)
    cosine = tangent**2 / (1 + tangent**2)
    demand(bool(1 - cosine >= mpq(7, 8) ** 2 and 4 * cosine <= (mpq(49, 16) - 2) ** 2), "rectangle")
    demand(bounds.merged_height_squared() == TAU**2 / 4, "merged_height_squared()")
    return "x = tau/2 at c, L and D being tau"


@CHAPTER.proved(
    "Lemma 5 (repaired)",
    "Projections cut the base of a merged face into pieces at least tau/sqrt 2 long, whichever are "
    "chosen.",
    "written proof",
)
def base_pieces() -> str:
    """None is drawn nearer than that to an end of the base (`boundary.project.cuttable`).

    Between neighbouring ones t grows by tau at least (`projected_vertices`): `area_of_a_piece`.
    Those that are not drawn are left out above, too: of the first projections c_1 on a column is
    tau/sqrt 2 away, and c_2 at least (t(c_2) - t(a))/sqrt 2, which is less only if c_2 = (0, 1) and
    w > 1 - tau.  A base without projections is a side of a face, or more.
    """
    demand(bool(TAU < left_out() and 1 - TAU > TAU), "left out if w > 1 - tau")
    demand(bounds.base_piece_squared() == TAU**2 / 2, "base_piece_squared()")
    return "T/sqrt 2, T >= tau"


LEAST_GROWTH = mpq(1, 5)


def beside_a_diagonal(tau: mpq = TAU) -> mpq:
    """At least x/sqrt((1 + k)^2 + k^2), k = r/T, for x from tau/2 to 1/3 and T >= 1/5.

    k <= 5 x, and k <= 5 x - (1 - x/tau).  x >= tau: with k = 5 x it grows with x.  x <= tau: 1 + k
    is at most (1 + 5 tau) x/tau, and k over it at most what it is for k = 5 tau. (Or k = 0.)
    """
    most = tau / LEAST_GROWTH
    root = 1 + most + most * most / (2 * (1 + most))  # at least
    return min(tau / 2, tau / root)


def _heights_at_a_row() -> dict[str, mpq]:
    """c_0 c_1 on a row and c_2 projected."""
    most = 1 - left_out()
    second = min(TAU * (1 - TAU), most * (1 - most)) / ROOT_2
    z = 1 + TAU  # |a c_2| <= 2 + z^2/4
    higher = min(TAU * (2 - TAU), z * (2 - z)) / (2 + z * z / 4)
    return {
        "row": min(TAU / ROOT_2, second, left_out() / ROOT_2),
        "row, c_2 higher": min(higher, TAU / (1 + z * z / 8), (1 - TAU) / ROOT_2),
        "row, c_2 on an edge": mpq(1, 2) * mpq(7 - 1, 7 + 1),
    }


def _heights_left_out() -> dict[str, mpq]:
    """c_0 c_1 on a row and c_2 not projected."""
    w, growth = 1 - left_out(), 1 - 2 * TAU
    demand(bool(w >= growth), "c_3 = b")
    part = growth / ROOT_2
    return {
        "left out": min(w, part * w / ROOT_2, part * w / (part + ROOT_2)),
        "left out, a c_3": min(TAU / 2, mpq(1, 2) / 2, growth / ROOT_2),
        "left out, a c_3 c_2": growth / (1 + ROOT_2),  # K = 1 - tau
        "both left out": w / (1 + ROOT_2),
    }
