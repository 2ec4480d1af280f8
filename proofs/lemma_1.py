"""Lemma 1 with its cutting line repaired: both edges at an acute corner are cut at |vw|/3.

**Statement.**  Let every acute vertex v of P be cut at distances a_v, c_v on its two edges, both
between rho |vw|/3 and |vw|/3, w being the vertex nearest to v by distance within P.  Then
(1) s' >= rho s/3; (2) the triangles cut off have height at least rho sqrt(2)/6 s, if their
base angles are within [45, 90] degrees.

**Proof of (1).**  Distances are lengths of shortest paths within P.  Two facts from Definition 1:
|vw| >= s, and points of edges without a common end are at least s apart.

(a) *Near v.*  Let r = |vw|.  Within the disc of radius r round v there is no vertex but v that
is joined to v inside it.  So what of P is joined to v within the disc of a radius below
r/sqrt 2 is just a sector between the two edges: an edge that comes in would pass
through as a chord of the arc of a sector of less than 90 degrees, whose middle is more than
r cos 45 away.  So points of edges not at v are at least r/sqrt 2 from v.

(b) *The base* is at least rho s/3.  With theta the angle at v the distance of points at a and c
on the edges is least for a = c = rho r/3, as theta < 90: 2 (rho r/3) sin(theta/2).  If w is
no neighbour of v, it lies within the wedge at angles alpha and theta - alpha from the edges,
which are at least r long, so its distances from them are r sin alpha, r sin(theta - alpha) and
the lesser is at most r sin(theta/2): s <= r sin(theta/2).  If w is a neighbour it is r sin theta
from the other edge: s <= 2 r sin(theta/2).  In both cases s <= 2 r sin(theta/2).

(c) *Edges* of P' within edges of P lose at most a third at each end, by |vw| <= |vu| for a
neighbour u: a third of at least s is left.

(d) *A vertex x of P' and an edge f of P' not at x*, y the nearest point of f.  All
vertices of P' are on the boundary of P.
- y on the boundary of P, x and y on edges of P without a common end: at least s.
- They are on two edges at an acute v: both are at least rho r/3 from it, and the base of (b)
  is the least distance of such points.
- They are on two edges at a v that is not acute, x on vu: x is u or a cut point near u, at least
  2/3 |vu| from v, and for 90 degrees or more y is at least as far from x as v is; |vu| >= s.
- y inside the base at v, x on an edge not at v: by (a) |xy| >= r/sqrt 2 - r/3 > r/3 >= s/3.
- y inside the base at v, x on an edge vu, beyond the cut: x is at least 2/3 |vu| >= 2 r/3 from v,
  y at most r/3: |xy| >= r/3 >= s/3.

**Proof of (2).**  All sides of the triangle are at least rho s/3 by (b), (c).  Of the two angles at
its longest side, which add up to 90 degrees or more, one is at least 45, and all are at most
90.  So the height is at least (rho s/3) sin 45.
"""

from __future__ import annotations

import sympy
from gmpy2 import mpq

from bern_exact.checkers import bounds
from proofs.algebra import demand_equal, demand_positive, symbols
from proofs.statement import IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements


@CHAPTER.proved(
    "Lemma 1 (repaired)",
    "If both edges at each acute corner v are cut at |vw|/3, up to rounding rho, the feature size "
    "of P' is at least rho s/3.",
    IDENTITY,
)
def feature_size() -> str:
    """The module's docstring; its inequalities."""
    demand(mpq(1, 3) == bounds.CUT_FRACTION, "cut at a third")
    demand(mpq(1, 9) == bounds.LOPPED_FEATURE_SQUARED, "(s'/s)^2 >= 1/9")
    demand(bool(mpq(1, 2) > mpq(2, 3) ** 2), "(d) 1/sqrt 2 - 1/3 > 1/3, as 1/2 > 4/9")
    half = sympy.Symbol("h", positive=True)  # theta/2 < 45 degrees
    demand_equal(sympy.sin(2 * half), 2 * sympy.sin(half) * sympy.cos(half), "(b) sin theta")
    a, extra, cosine = symbols("a extra p")
    cos = 1 / (1 + cosine)  # 0 < cos theta <= 1
    grows = (a + extra) ** 2 - 2 * a * (a + extra) * cos - (2 * a * a - 2 * a * a * cos) + a * a
    numerator = sympy.cancel(grows * (1 + cosine))
    demand(
        all(bool(c >= 0) for c in sympy.Poly(numerator, a, extra, cosine).coeffs()),
        "(b) the distance of points at a and a + extra is least for extra = 0",
    )
    demand_positive(2 * sympy.Integer(1) / 3 - sympy.Rational(1, 3), "(d) 2/3 - 1/3 = 1/3")
    return "1/2 > 4/9; chord 2a sin(theta/2)"


@CHAPTER.proved(
    "Lemma 1 (repaired)",
    "Each triangle cut off has height at least rho s sqrt(2)/6.",
    IDENTITY,
)
def triangle_height() -> str:
    """The module's docstring, (2)."""
    squared = bounds.CUT_FRACTION**2 * mpq(1, 2)  # (1/3)^2 sin^2 45
    demand(squared == bounds.CUT_HEIGHT_SQUARED, "(1/3)^2/2 = 1/18")
    demand(bool(squared == mpq(2, 36)), "(sqrt 2/6)^2")
    return "(s/3)^2 sin^2 45 = s^2/18 = (s sqrt(2)/6)^2"


@CHAPTER.proved(
    "Lemma 1, fans",
    "A fan over points of the base has angles of at most 135 degrees, and heights of at least "
    "min(h, g/sqrt 2), h being the triangle's height and g the least distance on the base.",
    IDENTITY,
)
def fans() -> str:
    """As p runs along the base from P to Q, the angle from pv to the base's direction grows.

    It does so from the base angle at P to 180 degrees minus that at Q: within [45, 135].
    In a triangle v, p, q the altitude from v is that of the whole, at least h; those from q and p
    are |pq| times the sine of an angle within [45, 135]: at least |pq|/sqrt 2.  The angle
    at v is at most that of the whole, below 90.
    """
    demand(180 - 45 == 135, "the other base angle")
    demand_equal(sympy.sin(sympy.pi / 4), 1 / sympy.sqrt(2), "sin 45")
    demand_equal(sympy.sin(3 * sympy.pi / 4), 1 / sympy.sqrt(2), "sin 135")
    return "sines of 45 to 135 degrees are at least 1/sqrt 2"
