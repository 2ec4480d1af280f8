"""Faces outside blocks, before and after warping: the half of Lemma 2 that the paper argues.

Blocks are the paper's 3 x 3 squares, b = 1, s' >= 8, tau <= 1/8; all distances are within P'.  A
face outside blocks is one that is in the block of no vertex, and closed.  For an edge e with
such a face the plane is turned so that e rises to the right with P' on its upper left: e cuts off
the lower right corner of a rectangle.  A row is a horizontal interval, a column a vertical one.

**Blocks.**  All that is within a block and within the wedge of its vertex v is in faces of the
block, since all eight lines are kept there.  So a face outside has no vertex of P' (a), and a piece
of the boundary within the open block is on no such face (b).
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

WRITTEN = "written proof; exact comparisons"


@CHAPTER.proved(
    "Section 2, dicing",
    "An interval has a grid vertex within block and wedge of the vertex v for which it is kept, or "
    "runs from one edge at v to the other within an open block: no side of a face outside blocks "
    "runs from edge to edge.",
    IDENTITY,
)
def intervals_have_grid_vertices() -> str:
    """The interval is kept for a piece J of its line within block and wedge of some v.

    If a line of the block crosses J, it is kept as well, through that point: a grid vertex.  Else J
    is strictly between two neighbouring lines of the block, and ends at the edges of v: it
    is the whole interval.  It is on no outer line of the block: that line is h > 1 from v, and
    two edges at an angle of at least 90 degrees which both rise above v, with slopes m and m' to
    either side, have m m' <= 1; they are h/m + h/m' >= 2 h > 2 apart at height h.  So both ends are
    in the open block, and all faces at them are in the block, by (b).
    A side of a face has no grid vertex between its ends, as intervals end on the boundary alone.
    """
    p, more = symbols("p more")
    q = (1 + more) / p  # p = 1/m, q = 1/m'
    demand_equal((p + q) ** 2 - 4, (p - q) ** 2 + 4 * more, "1/m + 1/m' >= 2")
    return "(p + q)^2 - 4 = (p - q)^2 + 4 (p q - 1)"


@CHAPTER.proved(
    "Lemma 2, faces",
    "Before warping a face outside blocks with a piece of the boundary is convex: a rectangle "
    "without one corner, or without two opposite ones, cut off by edges whose slopes have the same "
    "sign and which have no common end; it has at most six sides.",
    "written proof",
)
def faces_before_warping() -> str:
    """Round it the boundary turns left everywhere: by 90 degrees at a grid vertex, where two whole

    intervals cross, and by less than 180 at a q-vertex; by (a) there are no other corners.  So it
    is convex, without holes, and has at most one side in each direction: east, north, west, south.
    A piece of P' runs in one of the quadrants between, interior on the left.  Two pieces in one
    quadrant would be neighbours and meet at a vertex of P': at most one in each.  If two
    neighbouring quadrants have one, the side between runs from edge to edge, which is excluded, or
    is missing, and they meet at a vertex.  So there is one piece, or two in opposite
    quadrants: slopes of the same sign, 4 + 2 sides.  With two, no other side is missing: its
    neighbour would run from edge to edge.  Two edges that run in opposite quadrants, the interior
    between them, make an angle of less than 90 degrees at a common end: P' has none.
    """
    demand(bounds.FACE_SIDES == 4 + 2, "six sides")
    return "a side from edge to edge is excluded, so no two neighbouring corners are cut off"


@CHAPTER.proved(
    "Lemma 2, faces",
    "Every point of a face outside blocks is at least 1 from every vertex of P' and less than "
    "1/sqrt 2 from at most one edge.  A point of an edge f that is less than tau from one of the "
    "face is at least 1 - tau > 1/sqrt 2 from all other edges.",
    WRITTEN,
)
def near_a_face() -> str:
    """v is in the middle square: what is less than 1 from v is in the open block, on v's sheet.

    Edges without a common end are at least s' apart.  If e and f meet at v, let a point p be x and
    y from them, and phi and psi the angles from vp to them, phi + psi >= 90: the greater of x
    and y is at least |vp| sin 45, so that |vp| <= sqrt 2 max(x, y).  (Within P' no vertex is in
    the way: one between, in the triangle of v and the feet, would be less than s' from v.)
    If p is on f itself, it is |vp| from e, which is at least 1 - tau.
    """
    demand(bool(2 * mpq(1, 2) <= 1 and FACTOR**2 > 2), "sqrt 2 / sqrt 2 = 1; 8 > 2/sqrt 2")
    demand(bool(2 * (1 - bounds.TAU) ** 2 > 1), "1 - tau > 1/sqrt 2")
    return "|vp| <= sqrt 2 max(x, y)"


@CHAPTER.proved(
    "Section 2, warping",
    "On a face outside blocks a grid vertex moves, if at all, in substep 2, by less than tau along "
    "a line of its own, onto the only edge near it. A q-vertex on e stays, or merges with its "
    "inner neighbour's image on e, or with the q-vertex of the other line through its anchor, less "
    "than tau from that, or slides along e, if its inner neighbour has moved onto another edge.",
    WRITTEN,
)
def what_moves() -> str:
    """Substep 1: a corner c of v's square is within the open block, and so are its four faces.

    If an instance (e, c) moves to v, a q-vertex with this anchor is less than 1 from c along a line
    of the block (all eight are in use), so within the open block, and by (b) on no face outside.

    Substep 2: a grid vertex moves to a q-vertex q on its line, less than tau away, whose inner
    neighbour it is; q stays.  By `near_a_face` no other edge is as near.  The rest is the
    rule for q-vertices, where each q has an inner neighbour (`intervals_have_grid_vertices`).
    The q-vertex q' that (e, c) moves to has not merged itself: its inner neighbour g' would have
    moved onto e.  Let q' be on the column through c, q on the row.  |q'c| < |qc|, so that e
    has a slope below 1.  g' is at least 1 - tau above q', at least 1 - tau to the left of e:
    more than tau.  There is a g': otherwise the interval of q' would run within the open block of
    an end v of e, on an inner line, from e to the other edge at v, past the height of v, as they
    make at least 90 degrees; so c would be a corner of v's square, as in substep 1.  (The same
    with row and column exchanged.)
    """
    demand(bool(1 - bounds.TAU > bounds.TAU and 2 * bounds.TAU**2 < 1), "tau <= 1/8")
    return "all of substep 1 is within open blocks"


@CHAPTER.proved(
    "Lemma 2, faces",
    "After warping a face outside blocks is convex or has vanished. Its sides are those it had, in "
    "the same order: rows and columns at most arctan(2 tau) from their axes, pieces of the same "
    "edges, and possibly sides of a rectangle whose two ends moved onto one edge.",
    IDENTITY,
)
def faces_after_warping() -> str:
    """Lengths along a side's own axis stay positive: 1 - 2 tau, or from a grid vertex g to q on e.

    There: g unmoved, q stays or is at the other line through its anchor, further away; or g
    on another edge, at least 1/sqrt 2 from e; or g on e, and the side has vanished.  Slopes:
    `slope_of_almost_axis_parallel_edges`.  So the directions are in the order east, e, north, west,
    f, south as before, each in its own range, as 2 arctan(2 tau) < 90; it remains to see that
    pieces of e keep their direction, and that the turns at q-vertices are to the left.

    At q on e, e crosses the segment from g's image to the anchor, or to where that moved on e,
    with the image inside: it is in P', and if it were beyond the line of e, this line would
    pass between g and its image, less than tau from g, as e itself, against `near_a_face`,
    or beyond an end of e, which would be a vertex less than 1 from the face.  Where a piece of e
    vanishes, row and column meet, 90 degrees +- 2 arctan(2 tau).

    A piece of e from p up to q.  Both on columns, or on rows: each stays within tau of its line.
    On a column and a row that meet in a corner of the face: below its image and to the right of it.
    Else p is on a row y and q on a column k; their anchors are (k', y), k' <= k, and (k, y'), y' >=
    y, as both lines are in use. If p merges with a q-vertex on column k', or q with one on row y',
    this is the other of the two, and the piece vanishes.  Else p goes up only if it slides, and is
    to the left of column k' then; and q down only if it slides, and is above row y'. If both do:
    either k' < k, and q is less than tau from column k; or y' > y, likewise; or their anchors are
    one point, from which p is seen to the west and q to the north.

    A rectangle of which two corners have moved onto e has a side there.  In a face with a piece of
    e a corner that moves onto e is the end of a side that ends there, and vanishes: to the right of
    all others, and below them, there are corners of the face.
    """
    tau, rest = symbols("tau rest")
    eighth = sympy.Rational(1, 8) / (1 + rest)
    slope = 2 * eighth
    demand(bounds.slope(tau) == 2 * tau, "slope() is 2 tau")
    demand_nonnegative(sympy.cancel((1 - slope) * (1 + rest) * 8), "arctan(2 tau) < 45 degrees")
    demand_nonnegative(sympy.cancel((1 - 2 * eighth) * (1 + rest) * 8), "1 - 2 tau > 0")
    return "each turn is to the left, and the directions are in order"


@CHAPTER.proved(
    "Lemma 2, faces",
    "A face outside blocks of which two corners move onto one edge e, and that had no piece of e, "
    "is a rectangle with no other side on P'; the corners are neighbours, and e has a slope below "
    "tau to the axis of the side between.",
    WRITTEN,
)
def sides_by_moving() -> str:
    """Two opposite corners A and B: e runs from one to the other, outside the face, so on one side

    of AB this is less than tau wide.  But its sides from A and from B are there at least 1/sqrt 2
    long (`near_a_face`), and one of them ends at least 1/2 from AB.

    So let it be the right side, x = k, from row y to row y' >= y + 1, e less than tau to the right
    of both ends (an end of which e is above or below is nearer to it along its row): e has a slope
    below tau to the vertical.  Suppose that the face has another side on an edge f.  Then f cuts
    off a corner on the left, or both corners on the left move onto f (the two upper ones cannot,
    (k, y') moving onto e).  By a reflection it is the upper left corner that is cut off, or moves.
    So row y', from f to e, has only (k, y') as a grid vertex, or this and the upper left corner.
    By `intervals_have_grid_vertices` one of them is in the block of the vertex w for which the row
    is kept; let it be (k, y'), which is no restriction: if both are there, e and f have the same
    part. w is at most 2 sqrt 2 from (k, y'), less than s' from e: it is an end of e.  It is at most
    2 above or below row y', so less than 3 tau < 1 beside k; k - 1 is a line of the block.  Where
    (k - 1, y') is on the row it is a grid vertex: it is the upper left corner, or it is beyond f.
    So f meets the row less than 1 + tau to the left of k.  Then e and f have a common end, which is
    less than sqrt 2 (1 + tau) from (k, y'), so that it is w.  The angle at w is at least 90
    degrees, and e is steep: from w to row y' f rises or falls by at most tau a unit, less than 1 in
    all.  So f is not steep, as it is where two corners on the left move onto it; and it meets row
    y' in the open block, less than 1 to the left of k, against (b).
    """
    tau = bounds.TAU
    demand(bool(tau < mpq(1, 2)), "1/sqrt 2 times sin 45")
    demand(bool(8 < (FACTOR - tau) ** 2), "2 sqrt 2 + tau < 8")
    demand(bool(3 * tau < 1 and 1 + 2 * tau < FACTOR), "3 tau < 1, 1 + 2 tau < 8")
    common = 2 * (1 + tau) ** 2  # squared; the two ends of e are at least 8 apart
    demand(bool(common < 4 and 2 * (8 + common) < FACTOR**2), "sqrt 2 (1 + tau) + 2 sqrt 2 < 8")
    demand(bool(tau * (1 + 4 * tau) < 1), "f rises by less than 1")
    return "row y' would have one more grid vertex, in the block of an end of e"


@CHAPTER.proved(
    "Lemma 2, faces",
    "A face outside blocks that has no side on P' after warping has vanished or has four sides of "
    "at least 1 - 2 tau and angles of 90 degrees +- 2 arctan(2 tau): its triangles have angles "
    "below 135 degrees, and heights of at least (1 - 2 tau)/2 > tau/sqrt 2.",
    "exact comparisons",
)
def faces_without_boundary() -> str:
    """A piece of e that vanished, and not the face, was between a row below and a column on the

    right (`faces_after_warping`), which now meet at a q-vertex, less than tau from their crossing.
    The other corners are or were grid vertices: four sides, between ends that are less than tau
    from grid vertices 1 or more apart.  Of two sides p <= q at an angle A the triangle has twice
    the area p q sin A, and the third side is at most q sqrt(2 + 2 |cos A|).
    """
    tangent = 2 * bounds.slope() / (1 - bounds.slope() ** 2)  # of 2 arctan(2 tau)
    demand(bool(0 < tangent < 1), "below 135 degrees")
    cosine = tangent**2 / (1 + tangent**2)  # squared, and so is the sine below
    third = mpq(7, 4)
    demand(bool(4 * cosine <= (third**2 - 2) ** 2), "the third side is at most 7/4 q")
    demand(bool(1 - cosine >= mpq(7, 8) ** 2), "the sine is at least 7/8")
    half = (1 - 2 * bounds.TAU) * mpq(7, 8) / third
    demand(bool(half**2 >= bounds.boundary_height_squared()), "tau/sqrt 2")
    return "7/8 over 7/4"
