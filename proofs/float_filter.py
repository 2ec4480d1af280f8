"""The filters of the judge for large meshes hold what they say: every radius is large enough.

**Setting.**  Let u = 2^-53 (`ROUNDING`) and G = 1 + 16 u (`GROWTH`).  Doubles are rounded to
nearest.  Where nothing over- or underflows, an operation on doubles has the value
fl(a op b) = (a op b)(1 + d) with |d| <= u, and also |fl(a op b) - a op b| <= u |fl(a op b)|;
multiplying by a power of two rounds nothing, and sums do not underflow.  A *ball* (v, r) holds the
real x if |x - v| <= r.  Let (v, r) hold x and (w, s) hold y.

**Lemma 1 (growth).**  A formula of sums, products and quotients of numbers >= 0 in which no value
passes through more than 12 roundings, times G, is computed at least as large as it is without
any rounding.  Each rounding loses a factor of 1 - u at most (a rounded divisor one of
1 / (1 + u) > 1 - u), and (1 - u)^12 (1 + 16 u) >= 1.  No formula below has more than 9.

**Lemma 2 (difference).**  For doubles a, b let d = fl(a - b).  Knuth's six operations give the
rounding error e = a - b - d exactly [Knuth, TAOCP 2, 4.2.2, Theorem B].  If the coordinates are a
and b themselves, (d, |e|) holds their difference.  If they are x and y with |x - a| <= 2^-52 |x|
(`INPUT`) and the same of y and b, then |x - a| <= 2^-52 |a| / (1 - 2^-52), and the factor
1 / (1 - 2^-52) <= (1 + u)^3 counts as three roundings more in Lemma 1.  So
(|e| + fl(2^-52 |a| + 2^-52 |b|)) G, as computed, is a radius.  If x = y is known, then a = b, since
equal coordinates have equal doubles, and (0, 0) holds x - y.

**Lemma 3 (sum).**  z = fl(v + w) is within r + s + u |z| of x + y.

**Lemma 4 (product).**  x y - v w = v (y - w) + (x - v) y, and |y| <= |w| + s.  So z = fl(v w) is
within |v| s + r (|w| + s) + u |z| of x y.

**Lemma 5 (quotient).**  If g = |w| - s > 0 then x/y - v/w = ((x - v) - (v/w) (y - w)) / y, and
|y| >= g.  With z = fl(v / w), |v/w| = |z| / (1 + d), so that the quotient is within
(r + |z| s) / g + u |z| of z, but for one rounding more.  A difference of two doubles, as g, is
rounded once like everything else.  If g <= 0 as computed (whose sign is right) the radius is
infinite.

**Lemma 6 (least).**  Say v <= w.  If fl(w - v) > fl(fl(r + s) G) then w - s >= v + r, so x <= y,
and (v, r) holds min(x, y).  If not, max(r, s) is a radius round v of the minimum: it is at most
x <= v + r, and at least min(v - r, w - s) >= v - max(r, s).  fl(r + s) >= max(r, s) is taken.
The absolute value of x is held by (|v|, r), its negative by (-v, r).

**Lemma 7 (ends).**  Let r >= fl(u |v| G), as in Lemma 5, or r = 0 = v.  Then fl(v - 2 r) <= v - r:
it is at most v - 2 r + u |v| + 2 u r, r >= u |v| (1 + 14 u), and (1 + 14 u)(1 - 2 u) >= 1.
Likewise fl(v + 2 r) >= v + r.  A sign is told from v > r or v < -r: comparisons round nothing.

**Lemma 8 (two products).**  With Dekker's product, a b = p + e exactly, p = fl(a b) [Dekker 1971].
Rounding is monotone, so p > -q implies a b > -c d, where c d = q + f; and if p = -q, the sign of
a b + c d is that of e + f, and fl(e + f) has the sign of e + f.  This is used where a, b, c, d are
differences without rounding errors, and says which sums of products are 0.

**Lemma 9 (sizes).**  Let every double be 0, or from 2^-100 to 2^100 in size (not `wild`).  They
are multiples of 2^-152.  So are differences and their errors; radii of differences are 0 or at
least that.  Products are multiples of 2^-304 (rounding keeps that), with errors that are as well,
and so are sums of products.  `sizes` follows every value and every radius to the cotangent and the
squared height: nothing that is not 0 is below 2^-1022 or, as a value, above 2^1023.  A radius
above that is infinite, and decides nothing, as does one that is not a number: every decision is
a comparison that must be true.  One entry needs more than the sizes of its factors: the radius s
of a sum or product w has s >= u |w|, so that in Lemma 5 |z| s is not far below u |v|, and
(|z| s) / g not below u |z|.  The radius of a wild vertex is infinite from the start.

**Theorem.**  `estimates.estimate` computes, by these operations alone, balls of the cross product,
of the dot products at the three corners, whose least is at the largest angle, of the squared
edges; and from these of the cotangent of the largest angle and of the squared least height,
cross^2 over the longest squared edge.  By Lemmas 2 to 9 they hold the exact values.  The bounds
that these are compared with are doubles on the outer sides of exact rationals
(`filters.doubles_around`, `cotangent_bounds`).  So a decision that doubles make is right; the
others are made in integers.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import sympy

from bern_exact.oracle.filters import GROWTH, INPUT, ROUNDING, SPLIT
from bern_exact.plane.array_mesh import LARGE, SMALL, UNIT

LEAST_NORMAL, MOST = -1022, 1023
"""Binary exponents of the doubles that are rounded relatively."""

Claim = tuple[str, bool]
"""A statement, and whether it holds."""


def claims() -> Iterator[Claim]:
    """Everything in the proof that can be computed, exactly."""
    yield from constants()
    yield from growth()
    yield from identities()
    yield from sizes()


def constants() -> Iterator[Claim]:
    """The constants are the ones of the proof."""
    u = Fraction(1, 2**53)
    yield "ROUNDING = u", Fraction(ROUNDING) == u
    yield "GROWTH = 1 + 16 u", Fraction(GROWTH) == 1 + 16 * u
    yield (
        "INPUT = 2 u",
        Fraction(INPUT) == 2 * u == Fraction(int(UNIT.numerator), int(UNIT.denominator)),
    )
    yield "SPLIT = 2^27 + 1", Fraction(SPLIT) == 2**27 + 1
    yield "tame sizes", Fraction(LARGE) == 2**100 and Fraction(SMALL) == Fraction(1, 2**100)


def growth() -> Iterator[Claim]:
    """Lemmas 1, 2 and 7: products of factors next to 1."""
    u, g = Fraction(ROUNDING), Fraction(GROWTH)
    yield "(1 - u)^12 G >= 1", (1 - u) ** 12 * g >= 1
    yield "1 / (1 + u) > 1 - u", 1 / (1 + u) > 1 - u
    yield "1 / (1 - 2 u) <= (1 + u)^3", 1 / (1 - 2 * u) <= (1 + u) ** 3
    yield "(1 + u)^3 (1 - u)^3 <= 1", (1 + u) ** 3 * (1 - u) ** 3 <= 1
    yield "G (1 - u) >= 1 + 14 u", g * (1 - u) >= 1 + 14 * u
    yield "(1 + 14 u)(1 - 2 u) >= 1", (1 + 14 * u) * (1 - 2 * u) >= 1
    yield "G (1 - u)^2 / (1 + u) >= 1", g * (1 - u) ** 2 / (1 + u) >= 1  # Lemma 6


def identities() -> Iterator[Claim]:
    """Lemmas 4 and 5: where the errors of products and quotients come from."""
    x, y, v, w = sympy.symbols("x y v w", nonzero=True)
    product = x * y - v * w - (v * (y - w) + (x - v) * y)
    yield "x y - v w = v (y - w) + (x - v) y", sympy.expand(product) == 0
    quotient = x / y - v / w - ((x - v) - v / w * (y - w)) / y
    yield "x/y - v/w = ((x - v) - v/w (y - w)) / y", sympy.simplify(quotient) == 0
    ux, uy, vx, vy = sympy.symbols("ux uy vx vy")
    wx, wy = vx - ux, vy - uy
    at_a, at_b, at_c = ux * vx + uy * vy, -ux * wx - uy * wy, vx * wx + vy * wy
    yield "u.v - u.w = |u|^2", sympy.expand(at_a + at_b - (ux**2 + uy**2)) == 0
    yield "dots at a and c add up to |v|^2", sympy.expand(at_a + at_c - (vx**2 + vy**2)) == 0
    yield "dots at b and c add up to |w|^2", sympy.expand(at_b + at_c - (wx**2 + wy**2)) == 0


Size = tuple[int, int, int]
"""2^a <= |value| <= 2^b unless it is 0; 2^c <= radius unless it is 0."""


def difference_size() -> Size:
    """A tame double has 53 bits from 2^-100 on: all are multiples of 2^-152."""
    unit = -100 - 52
    return unit, 101, unit


def sum_size(x: Size, y: Size) -> Size:
    """Of values that are multiples of the smaller least one; the radius is at least u times it."""
    least = min(x[0], y[0])
    return least, max(x[1], y[1]) + 2, min(x[2], y[2], least - 53)


def product_size(x: Size, y: Size) -> Size:
    """The radius is 0, or one of its terms is not: |v| s, r |w|, r s, u |z|."""
    terms = (x[0] + y[2], x[2] + y[0], x[2] + y[2], x[0] + y[0] - 53)
    return x[0] + y[0], x[1] + y[1] + 1, min(terms)


def quotient_size(x: Size, y: Size) -> tuple[Size, list[int]]:
    """The quotient, and the least sizes of the terms of its radius.

    r / g; |z| s >= u |v| up to rounding (-2); that over g, >= u |z|; u |z|.
    """
    least = x[0] - y[1] - 1
    terms = [x[2] - y[1] - 1, x[0] - 53 - 2, least - 53 - 2, least - 53]
    return (least, x[1] - y[0] + 1, min(terms)), terms


def sizes() -> Iterator[Claim]:
    """Lemma 9: no value or radius that is not 0 is too small, and no value too large."""
    edge = difference_size()
    product = product_size(edge, edge)
    cross = dot = sum_size(product, product)
    longest = sum_size(product, product)
    square = product_size(cross, cross)
    cot, cot_terms = quotient_size(dot, cross)
    height, height_terms = quotient_size(square, longest)
    table = {"difference": edge, "product": product, "sum": cross, "square": square}
    table |= {"cotangent": cot, "height": height}
    for name, (least, most, radius) in table.items():
        yield (
            f"{name}: 2^{least} to 2^{most}, radius from 2^{radius}",
            (least >= LEAST_NORMAL and most <= MOST and radius >= LEAST_NORMAL),
        )
    yield "terms of the cotangent's radius", min(cot_terms) >= LEAST_NORMAL
    yield "terms of the height's radius", min(height_terms) >= LEAST_NORMAL
    yield "errors of products are multiples of doubles", product[0] >= -1074
