"""Lemma 4: merged faces are monotone; and how they begin and end on their edge.

The notation is that of `outside_blocks`: e rises to the right, P' is on its upper left, t = x + y.
A merged face M has its base on e, from a to b, and its staircase a = c_0, c_1, ..., c_m = b, read
upwards.  Faces of M in the order of e are F_1, F_2, ...; what is said of a is true of b as
well, with up and right, row and column exchanged, by the reflection in a line of slope -1.
"""

from __future__ import annotations

import sympy

from bern_exact.checkers import bounds
from bern_exact.checkers.bounds_grid import FACTOR
from proofs.algebra import demand_nonnegative, demand_positive, symbols
from proofs.statement import IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements


@CHAPTER.proved(
    "Lemma 4",
    "A merged face is monotone: from c_1 to c_(m-1) t = x + y grows along every edge of the "
    "staircase. These run upwards or to the right at most arctan(2 tau) from their axes, or "
    "along edges of P' of positive slope.",
    IDENTITY,
)
def monotone_faces() -> str:
    """By `outside_blocks.faces_after_warping` and `.sides_by_moving` a face of M is convex and has,

    counter-clockwise, at most: a bottom, which ends on e; the side on e; a right side, which begins
    on e; a top; a side on another edge f, of positive slope; a left side.  Two faces are merged
    where a single interval meets e between them, in a node that no grid vertex moved to.
    It is a whole side of both, since sides have no grid vertices inside: the right side of one
    and the left side of the next, or the top of one and the bottom of the next.  So all
    bottoms and right sides are taken away, but for a bottom of the first face and a right side of
    the last, which are c_0 c_1 and c_(m-1) c_m.  What remains are tops, left sides and pieces of
    other edges; read upwards they go right, up, and up and right.
    On (1, k) or (k, 1) with |k| <= 2 tau, t grows by 1 + k > 0.
    A rectangle that touches e in a side because two corners moved is not merged with others: all
    its nodes on e are images of grid vertices.
    """
    tau, rest, above = symbols("tau rest above")
    eighth = sympy.Rational(1, 8) / (1 + rest)
    growth = 1 - 2 * eighth + above
    demand(bounds.slope(tau) == 2 * tau, "slope() is 2 tau")
    demand_positive(sympy.cancel(growth * (1 + rest) * 4), "1 + k > 0 for k >= -2 tau")
    return "t grows by at least 1 - 2 tau of an edge's extent along its axis"


@CHAPTER.proved(
    "Lemma 5, end faces",
    "c_0 c_1 is a piece of a column; or of the row along the upper side of the block of e's lower "
    "end, where e leaves it; or M is one rectangle, two of whose corners moved onto e.",
    "written proof",
)
def ends_of_merged_faces() -> str:
    """Suppose that c_0 c_1 is on a row: the bottom of F_1, no rectangle with corners moved onto e.

    Its unwarped corner on e is a q-vertex q, whose inner neighbour g has not moved onto e, as the
    bottom has not vanished.  The face F_0 below the row has this bottom as its top, and keeps its
    side on e: q-vertices that merge are on a row and on the column through its anchor, and that on
    the column is higher.  Why is F_0 not in M?
    - A grid vertex moved to the node.  Only g could have; or q merged with the q-vertex
      q' on the column through its anchor, and q' chose this anchor, no grid vertex.
    - Several intervals end in the node.  Then q has merged with the next q-vertex above, and the
      piece of e between, the only one of F_1, has vanished: F_1 has no side on e.
    - F_0 belongs to another merged face, along an edge f.  It has sides on e and f, so the corner
      at its lower right is cut off by e, and f cuts off the upper left one
      (`outside_blocks.sides_by_moving`).  So it has all four sides (`faces_before_warping`), and
      its upper end on e is that of its right side, not of its top.
    - F_0 is in a block of an end of e, which e, going up, leaves here: of the lower end, and q is
      on the upper line of the block.
    """
    return "a row at the lower end: only at the top of the block of e's lower end"


@CHAPTER.proved(
    "Lemma 5, end faces",
    "In the second case let (0, 0) be the grid vertex at the row's end and a = (w, 0). Then "
    "tau <= w < 1, e has a slope above 1/2, c_1 = (0, 0), and c_2 = (0, 1), or t(c_2) is at least "
    "t(a) + 1 - tau. So t(c_2) > t(a).",
    IDENTITY,
)
def row_at_a_block() -> str:
    """v = (x, -h), 1 < h < 2.  e rises by more than 1 and goes less than 2 to the right.

    At height 0 the other edge f at v, if it comes there to the left of a, is more than 2 to the
    left (`intervals_have_grid_vertices`), and all columns of the block are kept between: the inner
    neighbour of a is less than 1 from it.  Were it nearer than tau, it would have moved onto e.

    (1) A grid vertex p = (0, 0) or (0, 1) of the face is at most sqrt(w^2 + 1) < sqrt 2 from a.  If
    it had moved onto another edge f, less than tau away, e and f would have a common end, as no
    others are so near, and by `near_a_face` p would be less than 2 from it.  It is not the upper
    end, which is 8 from v, and |vp|^2 < 4 + 9.  So it is v, and not with (0, 1), as h + 1 > 2.
    With (0, 0): let r = |vp|.  The angles from vp to e and f are at least 90 degrees together, that
    to e less than 90, as |pa| = w < h; so p is at least sqrt(r^2 - tau^2) from the line of e.  It
    is w < 1 times the sine of e's angle from it: so r^2 < 1 + tau^2, |x| < tau, w > 1 - tau^2.
    Then e has a slope of h/(w - x) < r/(1 - tau^2 - tau): that sine is too small.  So (0, 0) does
    not move, and a is (w, 0).

    (2) c_1 c_2 is the left side of F_1.  If the upper left corner is cut off, by an edge 8 from e
    (`faces_before_warping`), c_2 is 8 from a, across the convex face, and not 1 beside it: it is
    more than 7 above a.  Else c_2 is or was a grid vertex (0, k).  If k = 1, it has not moved onto
    another edge, by (1), nor onto e, which is more than w >= tau away along its row, and does not
    meet its column below, the left side.  If k >= 2, moved or not, t(c_2) >= 2 - tau. t(a) = w < 1.
    """
    tau = bounds.TAU
    demand(bool((FACTOR - 2) ** 2 > 4 + 9), "8 - sqrt 13 > 2")
    steep = (1 + tau**2) / (1 - tau**2 - tau) ** 2  # more than the squared slope of e
    demand(bool(steep / (1 + steep) < 1 - tau**2), "(1): the sine is too small")
    demand(bool(FACTOR**2 - 1 > 7**2), "(2): more than 7 above a")
    slack, room = symbols("slack room")  # w = 1 - slack
    demand_nonnegative(2 - tau + room - (1 - slack) - (1 - tau), "2 - tau - w >= 1 - tau")
    return "t(c_2) - t(a) is 1 - w, or at least 1 - tau"


@CHAPTER.proved(
    "Lemma 5, end faces",
    "If every staircase vertex with t strictly between t(a) and t(b) is projected, end faces are "
    "triangles or quadrilaterals: these are all of c_1 ... c_(m-1), but for c_1 if c_0 c_1 is on a "
    "row, and c_(m-1) if c_(m-1) c_m is on a column. (A rectangle with corners moved onto e has "
    "four sides itself.)",
    "written proof",
)
def end_faces_have_four_sides() -> str:
    """On a column c_1 is above a, on a row to the left: t(c_1) > t(a), t(c_1) < t(a) < t(c_2).

    Likewise at b: t(c_(m-1)) < t(b), or t(c_(m-2)) < t(b) < t(c_(m-1)).  By `monotone_faces` t
    grows from c_1 to c_(m-1): so it is between for all the others.  (If c_0 c_1 is on a row and
    c_(m-1) b on a column, c_2 is not c_(m-1): c_1 c_2 is a left side, c_(m-1) the end of a top. c_1
    and c_(m-1) are the same only if c_0 c_1 is on a column and c_1 b on a row.)
    """
    return "a, c_1, its projection; or a, c_1, c_2 and its projection"
