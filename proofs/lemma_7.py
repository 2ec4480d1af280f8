"""Lemma 7 with its placement repaired: 135 degrees and beta/sqrt 5 for all real spacings.

**Setting.**  A matching rectangle h long and v high, h >= v; k subdivisions on the longer sides, l
on the shorter; beta = 1 is the least spacing of neighbours on a side.  If k = 0 or l = 0, or if
the lines between partners are drawn, all triangles are right with legs of at least 1: heights of
at least 1/sqrt 2.  Else k, l >= 1, so that r = v/2 >= 1.

A triangle has a base g >= 1 on a side (or on the axis) and its apex at a distance D from
the base's line.  With offsets o of the apex from the base's ends along it:
- the angle at an end beyond which the apex lies by o is 90 degrees + arctan(o/D): at most 135 if
  o <= D; at other ends it is at most 90;
- the angle at the apex is below 90 if it is beyond an end or level with it; between the ends, with
  p and q to them, it is at most 135 if p <= D, as the other part is below 90;
- the altitudes are D, and g D/sqrt(D^2 + o^2) on the side to an end at offset o.

**One point in the centre** (h <= v + 2), D = h/2 >= r for the shorter sides, D = r for the longer.
Shorter: o <= r <= D, all angles at most 135, at the apex at most 90.  Longer: bases have an end
at most h/2 - 1 <= r from the middle: that is the o of the obtuse end, or the lesser of p and q.
Ends are at most h/2 <= r + 1 <= 2 r away: altitudes of at least 1/sqrt 5.

**Else** the left point is at d, |d - r| < 1, d >= 1, and d = r if d is no projection of a
subdivision; in that case no projection is within 1 of r.  The right point likewise, d' from the
right side.  As h - v > 2, the left one is left of the right one; neighbours on the axis are
at least 1 apart: both are projections, or one is r = v/2 with none within 1, or both and h - v > 2.
- *Shorter sides*, D = d: the obtuse end is at most r - 1 < d away, and so is the lesser of p and q,
  since l >= 1.  Ends are at most r < d + 1 <= 2 d away.
- *Bases on a longer side beyond the first or last point*, D = r: the obtuse end is at most
  d - 1 < r away, ends at most d < r + 1 <= 2 r.
- *Between neighbours* s and s + w on the axis, w >= 1, with t <= s < t' next on the side: no
  projection is strictly between, so t' >= s + w.  Let p = s - t, q = t' - s - w.  p > 0 only if s
  is no projection: then s is the first point, d = r and p <= d = r.  Likewise q <= r.
  The product takes the diagonal from s to t' if both angles are within 135, which they always
  are: at s because p <= r, at s + w because q <= r.
  Altitudes: in (t, s, t'), base g = p + w + q, and in (s, s + w, t'), base w; all as below.
"""

from __future__ import annotations

import sympy
from gmpy2 import mpq

from bern_exact.checkers import bounds
from bern_exact.checkers.lemma_7 import check_lemma_7
from bern_exact.interior.records import Rectilinear
from bern_exact.interior.subdivided.records import Partition, SubdividedRectangle
from bern_exact.interior.subdivided.rectangle import _side_goes_on, tile
from proofs.algebra import Expression, demand_nonnegative, demand_positive, symbols
from proofs.statement import IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements


def altitude_squared_excess(base: Expression, distance: Expression, offset: Expression) -> object:
    """5 g^2 D^2 - (D^2 + o^2): at least 0 if the altitude on that side is at least 1/sqrt 5."""
    return 5 * base**2 * distance**2 - (distance**2 + offset**2)


@CHAPTER.proved(
    "Lemma 7 (repaired)",
    "All angles are at most 135 degrees, for all real spacings.",
    IDENTITY,
)
def angles() -> str:
    """The module's docstring, with beta = 1 and nonnegative slacks."""
    demand(bounds.TILING_COTANGENT == -1, "135 degrees")
    a, e, f = symbols("a e f")
    r = 1 + a
    # The centre: r <= h/2 <= r + 1.
    half = r + 1 / (1 + e)
    demand_nonnegative(sympy.cancel((half - r) * (1 + e)), "shorter sides: o <= r <= h/2")
    demand_nonnegative(sympy.cancel((r - (half - 1)) * (1 + e)), "longer sides: h/2 - 1 <= r")
    # d = r + x with |x| < 1: x = (e - f)/(1 + e + f).
    d = r + (e - f) / (1 + e + f)
    scale = 1 + e + f
    demand_positive(sympy.cancel((d - (r - 1)) * scale), "shorter sides: r - 1 < d")
    demand_positive(sympy.cancel((r - (d - 1)) * scale), "longer sides: d - 1 < r")
    # Between neighbours: p, q <= r; dot + cross at s of t and t', as in `_side_goes_on`.
    p, q, w = symbols("p q w")
    rise = p + a  # p <= r
    dot_and_cross = -p * (w + q) + rise**2 + (p + w + q) * rise
    demand_nonnegative(dot_and_cross, "the angle at s")
    demand_nonnegative((q + a) - q, "the angle at s + w: q <= r")
    demand(_side_goes_on([5, 9], [1, 13], 0, 0, 4), "the product's own test, p = q = r")
    return "dot + cross at s is r^2 + p r + (w + q)(r - p) >= 0"


@CHAPTER.proved(
    "Lemma 7 (repaired)",
    "All heights are at least beta/sqrt 5, for all real spacings.",
    IDENTITY,
)
def heights() -> str:
    """Every altitude of the module's docstring, with beta = 1."""
    a, e, f, g = symbols("a e f g")
    r, base = 1 + a, 1 + g
    half = r + 1 / (1 + e)
    clear = (1 + e) ** 2
    for name, distance, offset in (
        ("centre, shorter", half, r),
        ("centre, longer", r, half),
        ("right triangles", 1 + e, 1 + e),
    ):
        excess = altitude_squared_excess(base, distance, offset)
        demand_nonnegative(sympy.cancel(excess * clear), name)
    # Offsets up to d < r + 1 with D = r, and up to r < d + 1 with D = d >= 1.
    x = 1 / (1 + e)
    demand_nonnegative(
        sympy.cancel(altitude_squared_excess(base, r, r + x) * clear), "longer sides, |o| <= d"
    )
    d = 1 + f
    demand_nonnegative(
        sympy.cancel(altitude_squared_excess(base, d, d + x) * clear), "shorter sides, |o| <= r"
    )
    # Between: base w on the axis, apex t' at offsets w + q and q with 0 <= q <= r.
    w, q = symbols("w q")
    width = 1 + w
    for rise, offset in (  # r >= 1 and r >= q
        (1 + a + q, width + q),
        (1 + a, width + (1 + a) / (1 + e)),
        (1 + a + q, q),
        (1 + a, (1 + a) / (1 + e)),
    ):
        excess = altitude_squared_excess(width, rise, offset)
        demand_nonnegative(sympy.cancel(excess * clear), "(s, s + w, t')")
    # Base p + w + q on the side, apex s at offsets p <= r and w + q.
    p = r / (1 + e)
    for offset in (w + 1 + q, p):
        excess = altitude_squared_excess(p + 1 + w + q, r, offset)
        demand_nonnegative(sympy.cancel(excess * clear), "(t, s, t')")
    demand(bounds.TILING_HEIGHT_SQUARED == mpq(1, 5), "1/5")
    return "5 g^2 D^2 - (D^2 + o^2) has no negative coefficient"


@CHAPTER.proved(
    "Lemma 7 (repaired)",
    "beta/sqrt 5 is attained by the construction.",
    "exact example, measured by the checker",
)
def attained() -> str:
    """A rectangle of 4 x 2 with spacing 1."""
    rectangle = SubdividedRectangle(0, 4, 0, 2, (1,), (1,), (1, 3), (1, 3))
    found = check_lemma_7(tile(Partition(Rectilinear(()), (rectangle,), (0,))))
    (height,) = [finding for finding in found if finding.claim == "lemma-7.height"]
    demand(all(finding.holds for finding in found), "the checker")
    demand(height.measured == "1/5", f"measured {height.measured}")
    return "[0, 4] x [0, 2] with y = 1, x = 1, 3: (height/beta)^2 = 1/5"


@CHAPTER.proved(
    "Lemma 7 (repaired)",
    "At most k + 2 Steiner points and 2 triangles a vertex on the boundary.",
    IDENTITY,
)
def counts() -> str:
    """First and last, and the projections between.  T = B + 2 I - 2, B = 4 + 2 k + 2 l, l >= 1."""
    k, less = symbols("k l")
    on_boundary = 4 + 2 * k + 2 * (less + 1)
    made = on_boundary + 2 * bounds.tiling_steiner_points(k) - 2
    demand_nonnegative(bounds.tiling_triangles(on_boundary) - made, "T <= 2 B")
    return "B + 2 (k + 2) - 2 <= 2 B"
