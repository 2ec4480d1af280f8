"""Section 2: the angle of almost-axis-parallel edges, general tau, the unit b, blocks, faces."""

from __future__ import annotations

import sympy
from gmpy2 import mpq

from bern_exact.checkers import bounds, bounds_blocks, bounds_grid
from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.exact.enclosures import arctan_bounds, decimal_enclosure, pi_bounds
from bern_exact.theorems.threshold import threshold_for
from proofs.algebra import demand_equal, demand_nonnegative, demand_positive, symbols
from proofs.statement import CERTIFICATE, IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements

PRECISION = 64
"""Bits of enclosures."""


def degrees_of_arctan(tangent: mpq) -> tuple[mpq, mpq]:
    """Bounds of arctan in degrees, for a tangent of at least 0."""
    low, high = arctan_bounds(tangent, PRECISION)
    pi = pi_bounds(PRECISION)
    return 180 * low / pi[1], 180 * high / pi[0]


@CHAPTER.proved(
    "Definition 1",
    "No triangulation of P, with any Steiner points, has all heights above s.",
    "written proof",
)
def no_better_height() -> str:
    """Let e be a shortest segment from a vertex v to an edge f not at v, or an edge of length s.

    A triangle with a side of length at most s has height at most s: that covers an edge of P
    of length s, and e beginning along an edge vx of the mesh with |vx| <= s.  If |vx| > s, e ends
    inside vx at a point y of f.  Then vx runs along f, for else it would leave P or y would be a
    vertex; so all of vx is on f, and v too: no.  Else e begins inside a triangle at v.  It does not
    end there, since y is on the boundary of P; so it meets the opposite side, at most s away: the
    altitude from v is at most s.  The height is the least altitude.
    """
    return "an altitude or a side of at most s"


@CHAPTER.proved(
    "Definition 1",
    "s is the least of all edge lengths and all distances of a vertex from an edge not at it whose "
    "shortest segment leaves the vertex within its wedge: visibility need not be tested.",
    "written proof",
)
def no_visibility_test() -> str:
    """Distances are within P.  Candidates are not below s, and s is one of them.

    An edge uv: u is at most |uv| from the other edge at v.  A segment from v to y on f that
    begins in the wedge either stays in P, or runs along an edge at v and beyond its end, which is
    longer than that edge, or leaves P first at a point z of an edge not at v: then it is longer
    than a way within P from v to that edge.  So no candidate is below s.

    A shortest way from a vertex v to an edge f not at v is a segment, or bends at vertices.  If it
    is a segment it begins in the wedge: a candidate.  If it bends, let u be the last one: it is not
    on f, where the way would end, and what follows is a shorter way, of u.  So the least of all
    ways is a candidate.
    """
    return "a blocked pair implies a smaller candidate"


@CHAPTER.proved("Section 2, warping", "arctan((b/4)/b) < 14.04 degrees.", CERTIFICATE)
def arctan_of_a_quarter() -> str:
    """Rational bounds of arctan(1/4) and of pi."""
    demand(bounds.slope() == mpq(1, 4), "slope() is 1/4")
    low, high = degrees_of_arctan(bounds.slope())
    demand(bool(high < mpq(1404, 100)), "arctan(1/4) < 14.04 degrees")
    demand(bool(low > mpq(1403, 100)), "arctan(1/4) > 14.03 degrees")
    return "arctan(1/4) in {} .. {} degrees".format(*decimal_enclosure(low, high, 9))


@CHAPTER.proved(
    "Section 2, warping",
    "An edge between two grid vertices of which neither is in a block has slope at most 2 tau to "
    "its axis after warping, for tau <= 1/2.",
    IDENTITY,
)
def slope_of_almost_axis_parallel_edges() -> str:
    """Each end moves to a q-vertex on one of its own grid lines: along the edge or across it.

    Both across: 2 tau over a length of at least 1.  One along, the other across: tau over at
    least 1 - tau.  Both along: 0.  2 tau (1 - tau) - tau = tau (1 - 2 tau).  An edge cut off
    where it meets the boundary has the slope of the whole one, as q-vertices slide.
    """
    tau, rest = symbols("tau rest")
    demand_equal(bounds.slope(tau), 2 * tau, "slope() is 2 tau")
    slack = bounds.slope(tau) * (1 - tau) - tau
    demand_equal(slack, tau * (1 - 2 * tau), "the case of one end along the edge")
    half_minus = sympy.Rational(1, 2) / (1 + rest)  # any tau with 0 < tau <= 1/2
    demand_nonnegative(
        sympy.cancel(slack.subs(tau, half_minus) * (1 + rest) ** 2), "tau (1 - 2 tau) >= 0"
    )
    return "tau/(1 - tau) <= 2 tau"


@CHAPTER.proved(
    "Section 3, Lemma 5", "135 degrees + arctan(1/4) is less than 150 degrees.", CERTIFICATE
)
def below_150() -> str:
    """cot(135 + a) = -(1 + tan a)/(1 - tan a); cotangents fall, and cot 150 = -sqrt 3."""
    worst = bounds.boundary_cotangent()
    demand(bool(worst < 0 and worst * worst < 3), "cot(135 + arctan(1/4)) > -sqrt 3")
    _, high = degrees_of_arctan(bounds.slope())
    demand(bool(135 + high < mpq(14904, 100)), "135 + arctan(1/4) < 149.04, as printed")
    return f"cotangent {worst}, its square {worst * worst} < 3; below 149.04"


@CHAPTER.proved(
    "Section 3, general tau",
    "cot(135 degrees + arctan(2 tau)) = -(1 + 2 tau)/(1 - 2 tau) falls in tau from -1 at tau = 0; "
    "it is above -sqrt 3 just for tau < 1 - sqrt(3)/2 = 0.1339...: each bound A above 135 degrees "
    "has its tau, and 150 degrees allows up to 0.1339.",
    IDENTITY,
)
def general_tau() -> str:
    """The function of `bounds` is evaluated on a symbol and compared with SymPy's cotangent."""
    tau = sympy.Symbol("tau", positive=True)
    ours = bounds.boundary_cotangent(tau)
    tangent = (-1 + 2 * tau) / (1 + 2 * tau)  # tan(135 + a), tan 135 = -1
    demand_equal(ours, 1 / tangent, "the addition formula")
    demand_equal(
        sympy.diff(ours, tau), -4 / (1 - 2 * tau) ** 2, "the derivative is negative for tau < 1/2"
    )
    demand(sympy.limit(ours, tau, 0) == -1, "-1 at 0")
    (root,) = sympy.solve(sympy.Eq(ours, -sympy.sqrt(3)), tau)
    demand_equal(root, 1 - sympy.sqrt(3) / 2, "equality at 1 - sqrt(3)/2")
    demand(bool(root > sympy.Rational(1339, 10000)), "0.1339 is below it")
    return "equality at 1 - sqrt(3)/2"


@CHAPTER.proved(
    "Lemma 1, lopping",
    "8 > 2 sqrt 2: with b = s'/8 the block of v meets no edge but the two at v, on v's sheet, so "
    "that the sheet of v in its block is the block intersected with the wedge of v.",
    "written proof; exact comparison",
)
def sheets_are_wedges() -> str:
    """A point of the block is at most 2 along either axis from v: at most 2 sqrt 2 b.

    Let x be in the block and in the wedge.  If the segment from v to x met the boundary
    before x, other than along an edge at v, it would meet first an edge not at v or a
    vertex, at a distance of at most 2 sqrt 2 b < s' from v within P': a contradiction with
    Definition 1, for such a shortest segment leaves v inside its wedge.  So x is on the sheet
    of v.  Conversely what is on the sheet and within the block is joined to v by a shortest
    path there; that bends at vertices only, none of which is so near; so it is a segment
    and leaves v in the wedge.  Edges at v are at least s' long and leave the block.
    """
    demand(bool(bounds_grid.FACTOR**2 > 2**2 + 2**2), "8 > 2 sqrt 2")
    return "8^2 = 64 > 8 = (2 sqrt 2)^2"


@CHAPTER.proved(
    "Section 2, dicing",
    "Blocks are disjoint on their sheets if s' > 4 sqrt 2 b; blocks of 2 x 2 squares round the "
    "nearest corner, if s' > 3 sqrt 2 b.",
    "written proof; exact comparison",
)
def blocks_are_disjoint() -> str:
    """v = (x, y) is within its square [0, 1]^2, its block is [-1, 2]^2: at most 2 an axis.

    The nearest corner is at most 1/2 away along either axis, its block reaches 1 beyond: at
    most 3/2.  A point on both sheets would join two vertices within twice that distance
    inside P'.  But two vertices are at least s' apart within P': along an edge, or
    one from the edges at the other.  The blocks are those that `bounds_grid` allows.
    """
    for shape, reach in (("square", mpq(2)), ("corner", mpq(3, 2))):
        twice = (2 * reach) ** 2 * 2  # (2 reach sqrt 2)^2
        for factor in (mpq(2), mpq(17, 4), mpq(11, 2), mpq(17, 3), mpq(8)):
            allowed = bounds_grid.blocks_are_disjoint(shape, factor)  # type: ignore[arg-type]
            demand(allowed == bool(factor**2 > twice), f"{shape} blocks with factor {factor}")
    demand(bounds_grid.blocks_are_disjoint("square", bounds_grid.FACTOR), "8 b is enough")
    demand(bounds_grid.blocks_are_disjoint("corner", mpq(9, 2)), "9/2 b is enough")
    return "(4 sqrt 2)^2 = 32 < 64; (3 sqrt 2)^2 = 18 < 81/4"


@CHAPTER.proved(
    "Section 2, dicing", "At most 16 kept intervals a vertex; 12 for 2 x 2 blocks.", "written proof"
)
def intervals_a_vertex() -> str:
    """A line meets the block in a segment; the wedge, or its complement if v is reflex, is convex.

    So a line's piece within block and wedge is at most two segments.  4 + 4 or 3 + 3 lines.
    """
    demand(bounds_grid.intervals_a_vertex("square") == 2 * (4 + 4), "16")
    demand(bounds_grid.intervals_a_vertex("corner") == 2 * (3 + 3), "12")
    return "2 (4 + 4) and 2 (3 + 3)"


@CHAPTER.proved(
    "Section 2, dicing", "b is at least (1 - 2^-9) s'/8 and a cut is at least (1 - 2^-9) |vw|/3 "
    "from v: rounding down to 10 significant bits loses less than 1 part in 2^9.", IDENTITY,
)  # fmt: skip
def ten_bits() -> str:
    """A number from m to m + 1, m >= 2^9, becomes m: the ratio is above m/(m + 1) >= 512/513."""
    m = symbols("m")
    least = (m + 512) / (m + 513)
    for rounding in (bounds.CUT_ROUNDING, bounds_grid.UNIT_ROUNDING):
        kept = sympy.Rational(int(rounding.numerator), int(rounding.denominator))
        demand_positive(sympy.cancel((least - kept) * (m + 513)) * 512, "m/(m + 1) > 1 - 2^-9")
    return "512/513 > 511/512"


@CHAPTER.proved(
    "Lemma 2, faces",
    "A face has at most 4 grid vertices, or 5 if it has a vertex of P': the bound 6 of the counts "
    "is safe.",
    IDENTITY,
)
def corners_of_a_face() -> str:
    """A face turns by 360 degrees: 90 at a grid vertex, at least 0 at a q-vertex.

    At a grid vertex two whole intervals cross; at a q-vertex an interval ends on an edge, within
    180 degrees; at a vertex of P' it turns by more than -180.  There is at most one of
    those, as blocks are disjoint.  90 g < 360 + 180 gives g <= 5; 90 g <= 360 gives g <= 4.
    """
    demand(90 * bounds.CORNERS_A_FACE >= 360 + 180, "6 grid vertices turn too far")
    demand(90 * 5 < 360 + 180 and not 90 * 5 <= 360, "5 with a vertex of P', 4 without")
    return "90 * 6 >= 540"


@CHAPTER.proved(
    "Section 2, warping",
    "At most two q-vertices choose the same grid vertex outside blocks, or the same instance; they "
    " are of one edge.",
    IDENTITY,
)
def choosers() -> str:
    """Those of one edge are where it meets the two grid lines through that vertex: one a line.

    No edge is axis-parallel, and an instance is of one edge.  Suppose that q-vertices of two edges
    are less than tau from a grid vertex g, within P'.  Edges without a common end are at least
    s' > 2 tau apart.  If they meet at v, let phi and psi be the angles from vg to them through P',
    phi + psi >= 90 degrees.  A distance within P' is |vg| sin phi, or |vg| if phi >= 90.  So the
    greater of them is at least |vg| sin 45: |vg| < sqrt 2 tau < 1, and g is in the block of v.
    """
    demand(bounds.CHOOSERS == 2, "two grid lines")
    demand(bool(2 * bounds.TAU**2 < 1 and bounds_grid.FACTOR > 2 * bounds.TAU), "tau is small")
    return "one a grid line; 2 tau^2 < 1"


@CHAPTER.proved(
    "Section 2, warping",
    "All edges of faces outside blocks are at least b/8 = tau b long after warping, for tau <= "
    "1/6.",
    IDENTITY,
)
def least_edge() -> str:
    """Notation and facts are those of `outside_blocks`: the grid vertices of these faces move onto

    one edge each, by less than tau, and their q-vertices may choose.
    - Between grid vertices, moved or not: at least 1 - 2 tau >= tau.
    - From a grid vertex g to a q-vertex on e: if g moved onto e, q merges with it.  If it moved
      onto another edge, it is at least 1 - tau from e.  Else g stays and |qg| >= tau.  If q's
      anchor c moved, q is at a chooser q' of (e, c), less than tau from c, which is at least 1 from
      g: at least 1 - tau.  Else q stays.
    - Between q-vertices of two edges: there are no such sides.
    - Between nodes on e, at q-vertices or where these slid.  On parallel grid lines, less than tau
      from them: at least 1 - 2 tau.  On lines that cross at g, neither slid: if either is less than
      tau from g, then g or its instance on e moves onto e, and both merge with it.  Else they are
      at least sqrt 2 tau apart.
    - The same if one or both slid.  If g is their inner neighbour, they are at least 1/sqrt 2
      from its image, in directions 90 - 2 arctan(tau) > 60 degrees apart: so they are 1/sqrt 2
      apart.  If g is the anchor of both, let e be L >= tau to the left of it and D >= tau above.
      They slide on lines of slopes s, s' <= tau to the axes and end up r (1 - s s')/((1 + s r)
      (r + s')) sqrt(L^2 + D^2) apart, r = L/D; this is least for r = 1, as it grows with r for
      L > D = tau.  Else one is a line before the other: at least 1 - tau.
    """
    tau, rest = symbols("tau rest")
    demand_equal(bounds.edge_squared(tau), tau**2, "edge_squared()")
    sixth = sympy.Rational(1, 6) / (1 + rest)
    for least in (1 - 2 * tau - tau, 1 - tau - tau):
        demand_nonnegative(sympy.cancel(least.subs(tau, sixth) * (1 + rest)), "at least tau")
    demand(bool(3 * (2 * mpq(1, 6)) ** 2 < (1 - mpq(1, 6) ** 2) ** 2), "2 arctan(tau) < 30 degrees")
    s, t, ratio = symbols("s t r")
    # On e, from L to the left to D above: where s r/(1 + s r) and t/(r + t) are taken away.
    left = 1 - s * ratio / (1 + s * ratio) - t / (ratio + t)
    demand_equal(left, ratio * (1 - s * t) / ((1 + s * ratio) * (ratio + t)), "both slid")
    # sqrt(1 + r^2)/(1 + s r) and r/(r + t) grow for r >= s.
    slopes = sympy.diff((1 + ratio**2) / (1 + s * ratio) ** 2, ratio) * (1 + s * ratio) ** 3
    demand_equal(slopes, 2 * (ratio - s), "grows with r")
    slid = 2 * (1 - tau) ** 2 - (1 + tau) ** 2  # for r = 1, squared, over tau^2
    demand_nonnegative(sympy.cancel(slid.subs(tau, sixth) * (1 + rest) ** 2), "sqrt 2 tau ...")
    demand_nonnegative(2 * tau**2 - bounds.edge_squared(tau), "sqrt 2 tau")
    return "1 - 2 tau, 1 - tau and sqrt 2 tau (1 - tau)/(1 + tau) are at least tau"


@CHAPTER.proved(
    "Section 2, corner blocks",
    "In a 2 x 2 block no height above tau/sqrt(1 + (1 + 2 tau)^2), about 0.624 tau, can be "
    "promised; that is at least tau/2.",
    IDENTITY,
)
def corner_block_height() -> str:
    """v is 1/2 below a block line and 1/2 beside its grid vertex g; an edge is tau beyond g.

    With v = (0, 0), g = (1/2, 1/2) and q = (1/2 + tau, 1/2): twice the area of v, q, g is tau/2
    and the longest side vq.  4 ((1/2 + tau)^2 + 1/4) = 1 + (1 + 2 tau)^2 <= 4 for tau <= 0.366.
    """
    tau, rest = symbols("tau rest")
    squared = (tau / 2) ** 2 / ((sympy.Rational(1, 2) + tau) ** 2 + sympy.Rational(1, 4))
    demand_equal(squared, tau**2 / (1 + (1 + 2 * tau) ** 2), "the height")
    ours = bounds_blocks.block_height_squared("corner", tau)
    small = sympy.Rational(1, 3) / (1 + rest)  # tau <= 1/3
    ratio = sympy.cancel((squared / ours).subs(tau, small) - 1)
    numerator, denominator = sympy.fraction(ratio)
    demand_nonnegative(numerator, "at least tau/2 for tau <= 1/3")
    demand_positive(denominator, "the denominator")
    return "squared: tau^2/(1 + (1 + 2 tau)^2) >= tau^2/4 for tau <= 1/3"


@CHAPTER.proved(
    "Section 3, --max-angle",
    "The tau chosen for a bound A is certified: 135 degrees + arctan(2 tau) <= A, for A = 136, "
    "137, ... 150.",
    CERTIFICATE,
)
def chosen_thresholds() -> str:
    """Each tau of the product, compared with A by enclosures."""
    shown = []
    for degrees in range(136, 151):
        tau = threshold_for(parse_angle_bound(str(degrees)))
        _, high = degrees_of_arctan(bounds.slope(tau))
        demand(bool(0 < tau <= bounds.TAU and 135 + high <= degrees), f"A = {degrees}")
        shown.append(f"{degrees}: {tau}")
    return ", ".join(shown[::7])
