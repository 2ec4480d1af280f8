"""Lemma 2, heights: faces outside blocks triangulated by their own vertices, as in Theorem 1.

Notation is that of `outside_blocks`; tau <= 1/8.  (The numbers are for 1/8; over tau, all of the
heights fall as tau grows.)  A face with one corner cut off has, after warping,
the side from q to q' on e; u and v are its extents along the axes.  Its other corners are A
(upper left), B (lower left, if q is on a row) and C (upper right, if q' is on a column).
"""

from __future__ import annotations

from typing import Any

from gmpy2 import mpq

from bern_exact.checkers import bounds
from proofs.algebra import ROOT_2, demand_equal, demand_nonnegative, symbols
from proofs.statement import IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements

TAU = bounds.TAU


def least_at_corner(p: mpq, q: mpq, tangent: mpq) -> mpq:
    """Less than the least altitude of a triangle with two sides of at least p <= q.

    Between them there are 90 degrees +- an angle d of at most this tangent, below 1.  The
    altitudes are at least p cos d, and p q cos d over the third side, sqrt(p^2 + q^2 + 2 p q sin
    d), which grows with p and with q. cos d >= 1 - tan(d)^2/2, sin d <= tan d.
    """
    cosine = 1 - tangent * tangent / 2
    squared = p * p + q * q + 2 * p * q * tangent
    third = (squared + q * q) / (2 * q)  # at least the root, by the two means
    return p * cosine * min(mpq(1), q / third)


@CHAPTER.proved(
    "Lemma 2, heights",
    "If q is on a row and q' on a column, not merged with their inner neighbours, u and v are at "
    "least tau, or one of them is more than 1.",
    "written proof",
)
def extents_of_a_cut() -> str:
    """Let c be the corner that is cut off.  If both q and q' have the anchor c, and one of them is

    less than tau from it, the instance (e, c) moves onto e and both merge: no side.  If q has
    another anchor, there is a line in use strictly between q and c: u > 1.  Likewise v > 1.
    Warping moves q along e at most away from q': its inner neighbour may move onto another edge,
    to the left, where q stays, or downwards, where q slides down.  (Upwards is along the left side,
    of which the other edge would cut off the end, and with it a second corner.)  Likewise q'.
    """
    return "an anchor of both, or a line in use between"


@CHAPTER.proved(
    "Lemma 2, heights",
    "Every face outside blocks with at most one corner cut off has a triangulation by its own "
    "vertices with heights of at least tau/sqrt 2.",
    IDENTITY,
)
def faces_with_one_cut() -> str:
    """Sides between grid vertices are at least 1 - 2 tau long.  Others are at least tau long; if

    shorter than 1/sqrt 2, the grid vertex has not moved, and the side is axis-parallel; if the
    grid vertex has moved, e is at least 1/sqrt 2 from it (as in `merged_faces.projected_vertices`).
    A corner triangle, of A, B or C and its two neighbours, has two sides from q-vertices that stay
    and a right angle; or a grid vertex that stays, a side of at least 1, and 90 degrees +-
    arctan(tau); or sides of at least 1/sqrt 2 and 90 degrees +- 2 arctan(2 tau).  So much for faces
    without a cut and for those without B and C.  The others:
    - C is missing, q' on the top (or B): the triangles A B q and A q q'.  Let q' be x to the right
      of A, and q y below, so that it is less than x to the right.  If the top is axis-parallel, x
      >= tau, twice the area of A q q' is x y; else the top is at least 1 - tau long, x >= 1/sqrt 2,
      and it is at least x (y - 2 tau): A may have moved up, and C, onto e, down.
    - u, v >= tau: the triangles A B q, A q q', A q' C.  Let W and H be the extents of A, q and q'
      together: twice the area of A q q' is u H + v W - u v, at least u H and v W, so that an
      altitude is at least min(u, v)/sqrt 2.
    - v < tau, so u > 1: the triangles A B q, A q C, q q' C.  A C is at least 1 - tau wide and q 1
      below it; q' C is at least 1 - 3 tau high and less than 2 tau wide.  (u < tau: likewise.)
    """
    narrow, wide = 1 / ROOT_2, 1 - 2 * TAU
    twice = 4 * TAU / (1 - 4 * TAU * TAU)  # tan(2 arctan(2 tau))
    least = 1 / (ROOT_2 - mpq(1, 100)) * TAU  # a little more than tau/sqrt 2
    for name, height in {
        "rectangle": least_at_corner(wide, wide, twice),
        "a side of 1": least_at_corner(TAU, mpq(1), TAU),
        "long sides": least_at_corner(narrow, narrow, twice),
        "C missing": least_in_box(TAU * wide, 2 * TAU, wide),
        "C missing, top sloped": least_in_box(
            narrow * (wide - 2 * TAU), narrow + 2 * TAU, wide + 2 * TAU
        ),
        "A q C": least_in_box(1 - TAU, 1 - TAU, 1 + TAU),
        "q q' C": least_in_box(1 - 3 * TAU - 2 * TAU * TAU, 1 + 2 * TAU, 1 - 2 * TAU),
    }.items():
        demand(bool(height >= least), name)
    demand(bool(2 * (1 - TAU) ** 2 >= 1 + 4 * TAU * TAU), "top sloped: x >= 1/sqrt 2")
    u, v, x, y = symbols("u v x y")  # W = u + x, H = v + y
    area = (u + x) * (v + y) - x * y
    demand_equal(area, u * (v + y) + v * (u + x) - u * v, "u H + v W - u v")
    demand_nonnegative(area - u * (v + y), "at least u H")
    demand_nonnegative(area - v * (u + x), "at least v W")
    return "tau/sqrt 2 at a right angle between two sides of tau, and at u = v = tau"


def least_in_box(area: mpq, width: mpq, height: mpq) -> mpq:
    """Less than an altitude of a triangle with this twice the area, within such extents.

    Twice the area over the diagonal; it grows if a part of the area grows with its side.
    """
    larger, smaller = max(width, height), min(width, height)
    return area / (larger + smaller * smaller / (2 * larger))


@CHAPTER.proved(
    "Lemma 2, heights",
    "If two opposite corners are cut off and the side on e is left, u or v is at least "
    "tau (1 - r)/(1 + r), r = tau/7, and if one of them is below tau/sqrt 2, the other is at least "
    "1 - tau.",
    "written proof; exact comparisons",
)
def extents_of_two_cuts() -> str:
    """Let e cross the row u0 beside the corner and the column v0 above, its slope be m = v0/u0;

    m < 1, by a reflection.  Towards each other q and q' slide only: q, if B moves upwards onto f,
    q', if C moves to the left onto f.  (Perhaps both: one of the two q-vertices of f near B may not
    be free.)  f is 8 from e, so that the row's slope s and the column's s' are below r then. u and
    v become 1 - s/(m + s) - s' m/(1 + s' m) of u0 and v0 (`section_2.least_edge`), or more if an
    anchor is nearer than the corner: at least (1 - r^2)/((1 + r/m)(1 + r m)).

    v0 >= tau: u is at least tau (1 - r^2)/((m + r)(1 + r m)), which falls with m, and above v.  If
    v < tau/sqrt 2, so is the factor below 1/sqrt 2: 1 + r/m > sqrt 2 (1 - r), m < 3 r, u > 1.

    v0 < tau: q' has the corner as its anchor, which moves onto it.  q' stays, as C is too far
    away to merge.  If q has another anchor, u > 1.  Else it merges with q', and no side is left, or
    with B on e: B was at least 1 from the corner's column, and has moved down, or to the right by
    less than tau: u > 1 - tau.
    """
    r = TAU / 7
    demand(bool(8 - TAU > 7), "the row is more than 7 long")
    m, s, t = symbols("m s t")
    left = 1 - s / (m + s) - t * m / (1 + t * m)
    demand_equal(left, (1 - s * t) * m / ((m + s) * (1 + t * m)), "both slid")
    demand_equal((1 - r**2) / (1 + r) ** 2, (1 - r) / (1 + r), "m = 1")
    demand(bool(1 + mpq(1, 3) < (ROOT_2 - mpq(1, 100)) * (1 - r)), "m < 3 r")
    demand(bool(TAU * (1 - r) / (3 * r + r) > 1), "u > 1")
    return "(1 - r^2)/((1 + r/m)(1 + r m))"


@CHAPTER.proved(
    "Lemma 2, heights",
    "Every face outside blocks with two opposite corners cut off has a triangulation by its own "
    "vertices with heights of at least tau/sqrt 2.",
    IDENTITY,
)
def faces_with_two_cuts() -> str:
    """The face is B, q, q', C, p', p: q q' is on e, u by v large, p p' on f, x by y large, above.

    p is above B, p' to the left of C. q is a to the right of p and b below; p' is c to the left of
    q' and d above. e and f are s' >= 8 apart.  Let t be the sum of the coordinates.  By a
    reflection t(p) <= t(q): b <= a, so a >= 4.  b >= 0, unless B has moved onto f: p is at least
    tau above a B that stays, q less.  If a side has vanished, q = q' or p = p', its triangles
    are left out.

    (a) The corner triangles p B q and q' C p' are as in `faces_with_one_cut`, or have vanished.
    (b) A triangle of an edge of growth T of t on one of e and f and a corner on the other with t in
    between: by `merged_faces.area_of_a_piece` at least z T over sqrt 2 z + T, and sqrt 2 z >= 8.
    (c) A triangle with twice the area r h + s g and a side g by h or h by g long, 0 <= h <= g: over
    it at least the lesser of s and (r + s)/sqrt 2, as it is r sin w + s cos w, w <= 45 degrees.
    1. t(q) <= t(p') <= t(q'): (a); p q p' and q q' p' are as in (b).
    2. t(q') <= t(p'): c <= d, so d >= 4.  If v >= u: (a), p q' p' as in (b), and p q q', u b + v a:
    over p q as in (c); over p q', a + u wide and at most max(v, b) high, at least 3/4 of that if v
    <= 1; else at least 3/5, as u b + v a is at least a + u and b if b >= v >= 1, and v a over a + v
    by v grows with v and a; over q q' at least a/sqrt 2.  If u > v: (a), p q p' as in (b), and q q'
    p', u d + v c, in the same way.  If B has moved onto f, p is B, b >= -2 tau and a > 7: at least
    v (1 - 2 tau/7) over 6/5 (C likewise).
    3. t(p') < t(q): a > b + x + y.  The face is cut along q p'; it is the same on both sides, by a
    half turn.  On the left, if y >= tau/sqrt 2: (a) and p q p', x b + y a = x (b + y) + y (a - x):
    over p q and over q p' as in (c); over p p' at least y.  Else x >= 1 - tau: B q p', higher than
    1 - 4 tau and wider than high, and B p' p, x Bp.  If B has moved onto an edge other than e and
    f, it is 1/sqrt 2 from both: Bp has a slope of up to 2 tau to its axis, and the area is at least
    1 - 2 tau of that.  If it has moved onto f, p is B, and B q p' is all.
    """
    extent = TAU * (1 - TAU / 7) / (1 + TAU / 7)
    small, least = TAU / ROOT_2, TAU / (ROOT_2 - mpq(1, 100))  # on both sides of tau/sqrt 2
    far = 1 - TAU
    as_in_c = min(extent, (small + extent) / ROOT_2, far / ROOT_2)
    for name, height in {
        "(b)": min(1 / (ROOT_2 / growth + ROOT_2 / 8) for growth in (small + extent, far)),
        "2.": mpq(3, 4) * as_in_c,
        "2., v > 1": min(1 / ROOT_2, least_in_box(mpq(4), mpq(5), mpq(1))),
        "2., B on f": extent * (1 - 2 * TAU / 7) / mpq(6, 5),
        "3., (x + y)/sqrt 2": 2 * small / ROOT_2,
        "3., B p' p": least_in_box(far * TAU, far, TAU + least),
        "3., B q p'": (1 - 4 * TAU) / ROOT_2,
        "3., B moved": least_in_box(
            (1 - 2 * TAU) * far * mpq(3, 5), far + 2 * TAU, mpq(3, 5) + least
        ),
    }.items():
        demand(bool(height >= least), name)
    wide, high = mpq(4 + 1, 4), mpq(1, 4)  # a + u by v over a, u <= v <= 1
    demand(bool(wide**2 + high**2 <= mpq(4, 3) ** 2), "2.: 3/4")
    wide, high = mpq(7 + 1, 7), (1 + 2 * TAU) / 7  # and grows with v
    demand(bool(wide**2 + high**2 <= mpq(6, 5) ** 2), "2., B on f: 6/5")
    u, v, a, b, c, d, x, y = symbols("u v a b c d x y")
    demand_equal(area((a, -b), (a + u, v - b)), u * b + v * a, "p q q'")
    demand_equal(area((u, v), (u - c, v + d)), u * d + v * c, "q q' p'")
    demand_equal(area((a, -b), (x, y)), x * b + y * a, "p q p'")
    demand_equal(x * b + y * a, x * (b + y) + y * (a - x), "over q p'")
    demand_equal(area((x, y + d), (0, d)), x * d, "B p' p")
    squares = (x * b + y * (b + x + y + a)) ** 2 - y**2 * (x**2 + y**2)
    demand_nonnegative(squares, "over p p': at least y")
    return "tau/sqrt 2 at a right angle between two sides of tau"


def area(p: tuple[Any, Any], q: tuple[Any, Any]) -> Any:
    """Twice the area of the origin, p and q."""
    return p[0] * q[1] - p[1] * q[0]
