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
from proofs.algebra import (
    ROOT_2,
    Expression,
    demand_equal,
    demand_nonnegative,
    demand_positive,
    symbols,
)
from proofs.statement import IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements

TAU = bounds.TAU


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
    common = 5  # squared, for every tau; sqrt(common) + 2 sqrt 8 < 8
    apart = FACTOR**2 - 32 - common
    demand(bool(apart > 0 and 4 * 32 * common < apart**2), "a and b are further apart")
    return "at c_2 at most 90 + arctan tau + (45 + arctan 2 tau - arctan tau)"


@CHAPTER.proved(
    "Lemma 5 (repaired)",
    "A projected vertex is at least tau/2 beside its projection, and at least 1/2 unless it is an "
    "unmoved grid vertex; along c_0 c_1 on a column, and along every edge from c_1 to c_(m-1), t "
    "grows by at least tau, and by 1/2 if the edge is at least 1/sqrt 2 long or not axis-parallel, "
    "and within P'.",
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
    demand(bool(1 / ROOT_2 / stretch(2 * TAU) >= mpq(1, 2)), "(1 - 2 tau)/sqrt(2 (1 + 4 tau^2))")
    demand(bool(1 - 2 * TAU >= mpq(1, 2)), "1 - 2 tau")
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
    "Let c be a projected vertex, x beside its projection p.  The triangle of c, p and a point of "
    "e has a height of at least tau/2 if c is an unmoved grid vertex and T >= 1/2, or if x >= 1/2 "
    "and T >= tau.  That of c, p and a neighbour of c on the staircase has, if x >= 1/2, or if "
    "both are unmoved and x >= tau.",
    IDENTITY,
)
def triangles_at_a_projection() -> str:
    """Twice the area is x T (`area_of_a_piece`).  No side is longer than the other two together.

    At e: the side l on e is at most T, and at least T/sqrt 2.  So the height is at least x T/(sqrt
    2 x + T), which grows with x and T.  If c is unmoved, it is at least tau/sqrt 2 from the line of
    e (`lemma_5.end_face_height`), so the height is at least tau/sqrt 2 times l/(l + sqrt 2 x) >=
    T/(T + 2 x).  That will do if x <= 3 tau/4, and the other bound if x >= 3 tau/4.

    At the staircase: the side there is at most `stretch` T long, the height at least x T/(sqrt 2 x
    + stretch T).  If T < 1/2, or both are unmoved, T is at least the side's length
    (`projected_vertices`).
    """
    tau, half = _any_tau(), sympy.Rational(1, 2)
    x = 3 * tau / 4
    _demand_half("unmoved, near e", half / (root_2() * (half + 2 * x)))
    _demand_half("unmoved, further from e", _least(half, 1, x) / tau)
    _demand_half("x >= 1/2, T >= tau", _least(tau, 1, half) / tau)
    _demand_half("x >= 1/2, T >= 1/2", _least(half, stretch(2 * tau), half) / tau)
    _demand_half("x >= tau, T >= 1", _least(sympy.Integer(1), 1, tau) / tau)
    return "T/(T + 2 x) tau/sqrt 2 for x <= 3 tau/4, x T/(sqrt 2 x + T) for x >= 3 tau/4"


def root_2() -> Expression:
    """More than sqrt 2, for SymPy."""
    return sympy.Rational(int(ROOT_2.numerator), int(ROOT_2.denominator))


def _any_tau() -> Expression:
    """Any tau with 0 < tau <= 1/8."""
    return sympy.Rational(1, 8) / (1 + symbols("rest"))


def _least(growth: Expression, stretched: Expression, beside: Expression) -> Expression:
    """x T/(sqrt 2 x + stretch T)."""
    return 1 / (root_2() / growth + stretched / beside)


def _demand_half(name: str, height: Expression) -> None:
    """A height over tau must be at least 1/2, for every tau."""
    numerator, denominator = sympy.fraction(sympy.cancel(height - sympy.Rational(1, 2)))
    if bool(denominator.subs("rest", 0) < 0):
        numerator, denominator = -numerator, -denominator
    demand_positive(denominator, f"{name}: denominator")
    demand_nonnegative(numerator, f"{name}: tau/2")


@CHAPTER.proved(
    "Lemma 5 (repaired)",
    "Triangulations as in `every_merged_face` have heights of at least tau/2, if trapezoids and "
    "pieces of four sides are split by the right diagonal: `best_cuts` finds none lower.",
    IDENTITY,
)
def height_of_merged_faces() -> str:
    """Triangles at a projection are those of `triangles_at_a_projection`; u is an unmoved vertex.

    - Trapezoids.  Neither vertex unmoved: both have x >= 1/2, either diagonal will do.  One is u,
      the other o: if |u o| < 1/sqrt 2, u is 1/sqrt 2 from e (`near_a_face`, as o is on another
      edge), and x >= 1/2 again.  Else T >= 1/2: the diagonal from u to the projection of o.  Both
      unmoved: the side is axis-parallel, T >= 1.  Let it be on a row.  The left one is D >= tau + m
      T above e, and has x = D/(1 + m) >= tau: the diagonal from the right one to the projection of
      the left one.
    - a, c_1 and its projection.  If c_0 c_1 is axis-parallel and c_1 unmoved: `end_face_height`.
      Else T >= 1/2 or x >= 1/2.
    - c_1 = (0, 0), a = (w, 0), c_2 = (0, 1), projected: w/sqrt 2 in the first triangle.  The second
      has altitudes T/sqrt 2 = (1 - w)/sqrt 2, at least w to e, and x T/|a c_2| >= w (1 - w)/sqrt 2,
      concave in w.  c_2 = (-d, h), 0 <= d < tau, h >= 2; let u = w + d: w h/|a c_2| in the first;
      T/sqrt 2, at least u to e, and u (h - u)/sqrt(u^2 + h^2), least for h = 2.  c_2 on another
      edge: x >= 1/2, h > 7.
    - c_2 = (0, 1) not projected: c_1 a c_2 as before.  c_2 is more than 1 from all edges but e, by
      the argument (1) of `lemma_4.row_at_a_block`, so c_2 c_3 extends by k >= 1 - tau along its
      axis.  Diagonal a c_3: a, c_3 and its projection have T >= 1/2; a c_3 c_2 has twice the area
      k (1 - w tau) or k (w - tau), at least, and no side above sqrt 2 + (1 + tau) k.  If c_3 = b is
      on e, w or more to the right of c_2, |a b| is at least (1 - 2 tau)/sqrt 2, c_2 at least w
      from e.
      If neither c_2 nor c_3 is projected: a b c_2 likewise; c_2 c_3 is axis-parallel, b at least w'
      or 1 from it.
    - Rectangles: as `outside_blocks.faces_without_boundary`: (1 - 2 tau)/2.
    """
    tau = _any_tau()
    m = symbols("m")
    demand_nonnegative((TAU + m) - TAU * (1 + m), "D/(1 + m) >= tau")
    for name, height in {**_heights_at_a_row(tau), **_heights_left_out(tau)}.items():
        _demand_half(name, height / tau)
    demand_equal(bounds.merged_height_squared(tau), tau**2 / 4, "merged_height_squared()")
    demand(bool((1 - 2 * TAU) / 2 >= TAU / 2), "rectangle")
    return "the worst is a, c_1 and its projection: x >= tau/2"


@CHAPTER.proved(
    "Lemma 5 (repaired)",
    "Projections divide the base of a merged face into pieces of at least tau/sqrt 2, whichever "
    "are chosen.",
    IDENTITY,
)
def pieces_of_the_base() -> str:
    """None is drawn nearer than that to an end of the base (`boundary.project.cuttable`).

    Between neighbouring ones it is T/sqrt 2 at least (`area_of_a_piece`), and T >= tau
    (`projected_vertices`).  What is not drawn is left out in the cuts above, too: from a to the
    projection of c_1, c_0 c_1 being on a column, T >= tau; to that of c_2 T = 1 - w, less than
    tau only if c_2 is left out, or T >= 1 - tau.  A base without projections is longer than a
    side: at least 1 - 2 tau for a rectangle, else with both ends on different lines, or on a row
    and the column that meets it in c_1.
    """
    tau = _any_tau()
    _demand_half("half of left_out() >= tau", left_out(tau) / tau / 2)
    _demand_half("half of 1 - tau >= tau", (1 - tau) / tau / 2)
    demand_equal(bounds.base_piece_squared(tau), tau**2 / 2, "base_piece_squared()")
    return "T/sqrt 2, and T >= tau"


def _heights_at_a_row(tau: Expression) -> dict[str, Expression]:
    """c_0 c_1 on a row and c_2 projected; w is least, tau, or greatest."""
    out, two = left_out(tau), sympy.Integer(2)
    p = 1 + tau  # more than u; |a c_2|^2 = u^2 + h^2 < (h + u^2/(2 h))^2
    return {
        "first": tau / root_2(),
        "T/sqrt 2": out / root_2(),
        "second, w = tau": tau * (1 - tau) / root_2(),
        "second, w greatest": out * (1 - out) / root_2(),
        "first, c_2 higher": tau / (1 + p**2 / 8),
        "T/sqrt 2, c_2 higher": (1 - tau) / root_2(),
        "second, c_2 higher, u = tau": tau * (2 - tau) / (two + p**2 / 4),
        "second, c_2 higher, u = 1 + tau": p * (2 - p) / (two + p**2 / 4),
        "first, c_2 on an edge": tau * 7 / (two * 4),
        "second, c_2 on an edge": (7 - 1) / (two * (7 + 1)),
    }


def _heights_left_out(tau: Expression) -> dict[str, Expression]:
    """c_0 c_1 on a row and c_2 not projected."""
    w, k = 1 - left_out(tau), 1 - tau
    part = (1 - 2 * tau) / root_2()
    return {
        "w": w / root_2(),
        "a c_3 c_2": k * (w - tau) / (root_2() + (1 + tau) * k),
        "c_3 = b": part * w / (part + root_2()),
        "c_3 = b, |a c_2|": part * w / root_2(),
        "both left out": w / (1 + root_2()),
    }
