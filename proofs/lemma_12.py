"""Lemma 12 and Section 5.2: the exponent, every number, and the induction with rounding.

**Setting.**  x = 0.8475, phi(m, k) = m^x k + m k^x, R(m, k) the number of triangles that the
recursion makes of a rectangle with m rows and k columns, at worst.  R(m, k) <= 2 m k always: lines
are only removed.

**A split by columns**, M_r <= M_c, m, k > 3.  l and r are different; with k_2 what is between
and these two, k_1 + k_2 + k_3 = k and k_2 >= k/3.  At least (m - 1)/6 lines go: what is between has
at most (5 m + 1)/6 rows.  l and r make at most 4 m triangles.  An outer part of k_i >= 2 columns,
all narrower than M_r, is cut along the first and last row at least M_r high: m_1 + m_2 + m_3 = m,
m_2 >= m/3 with both, at most (k_i + 1)/2 columns between, 4 k_i triangles at most.  One of a single
column makes 2 m.  So besides the parts there are at most 4 m + 4 k + 4 m triangles.

**Without rounding** (main terms; ' for parts):
(A) sum m'^x k' <= k_2 (5/6)^x m^x + (k_1 + k_3) max(m_1^x + m_3^x + m_2^x/2).  The derivative
by m_2, with m_1 = m_3, is x (m_2^(x-1)/2 - m_1^(x-1)) < 0 for m_2 >= m_1: the maximum is at
m_2 = m/3, 2.5 * 3^-x m^x, more than (5/6)^x: in all g_1 = (2/3) 2.5 * 3^-x + (1/3)(5/6)^x < 0.9425.
(B) sum m' k'^x <= (5/6) m k_2^x + h m (k_1^x + k_3^x), h = 2/3 + 2^-x/3 > 5/6, as an outer part
has k_i^x (m - m_2 (1 - 2^-x)).  Again k_2 = k/3 is the worst: the derivative by k_2, with
k_1 = k_3, is x (5/6 k_2^(x-1) - h k_1^(x-1)) < 0.  In all g_2 = 3^-x (5/6 + 2 h) < 0.999974.

**Rounding**, by (y + z)^x <= y^x + z^x:
(A) ((5 m + 1)/6)^x <= (5 m/6)^x + 6^-x, and (k_i + 1)/2 = k_i/2 + 1/2:
    at most 6^-x k + 2 m^x/2 more.
(B) (5 m + 1)/6 adds k_2^x/6; ((k_i + 1)/2)^x <= 2^-x (k_i^x + 1) adds 2^-x m_2, twice:
    at most k^x/6 + 2^(1-x) m more.

**Induction**, R <= C phi with C = 16.  (i) If 2 m k <= C phi, that is, if
m^(x-1) + k^(x-1) >= 2/C, nothing is to be shown: so if min(m, k) <= K = 830000, as K^(1-x) <= 8.
(ii) Else, by the hypothesis for the parts,
C phi - R >= C ((1 - g_1) m^x k + (1 - g_2) m k^x - m^x - 6^-x k - k^x/6 - 2^(1-x) m) - 8 m - 4 k,
and it suffices that
  C (1 - g_2) K^x >= C (1 + 2^(1-x)) + 8     (terms with m, as m^x <= m), and
  C (1 - g_1) K^x >= C (6^-x + 1/6) + 4      (terms with k, as k^x <= k).
A split by rows is the same with m and k exchanged, phi being symmetric.
"""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.checkers import bounds_convex
from bern_exact.exact.enclosures import power_bounds
from proofs.powers import Bounds, power_between, shown
from proofs.statement import CERTIFICATE, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements

X = bounds_convex.EXPONENT
CONSTANT = mpq(16)
"""C, proved for all m and k with every rounding term."""

TRIVIAL = 830_000
"""Up to so many rows or columns 2 m k <= C phi(m, k)."""


def minus_power(base: int, exponent: mpq = X) -> Bounds:
    """base^-exponent."""
    return power_between(mpq(base), -exponent)


def characteristic(exponent: mpq) -> Bounds:
    """(5/6 + 4/3) 3^-y + (2/3) 6^-y, from R(m/3, 5k/6) + 2 R(m/6, k/3) + 4 R(m/3, k/3)."""
    third, sixth = minus_power(3, exponent), minus_power(6, exponent)
    low, high = (mpq(13, 6) * third[i] + mpq(2, 3) * sixth[i] for i in range(2))
    return low, high


def row_part() -> Bounds:
    """h = 2/3 + 2^-x/3, the printed 0.85192."""
    low, high = minus_power(2)
    return mpq(2, 3) + low / 3, mpq(2, 3) + high / 3


def contraction_a() -> Bounds:
    """g_1 = (2/3) 2.5 * 3^-x + (1/3)(5/6)^x."""
    third, five = minus_power(3), power_between(mpq(5, 6), X)
    low, high = (mpq(5, 3) * third[i] + five[i] / 3 for i in range(2))
    return low, high


def contraction_b() -> Bounds:
    """g_2 = 3^-x (5/6 + 2 h)."""
    third, part = minus_power(3), row_part()
    low, high = (third[i] * (mpq(5, 6) + 2 * part[i]) for i in range(2))
    return low, high


@CHAPTER.proved(
    "Section 5.1",
    "The equation's root is between 0.84747770 and 0.84747771, so below 0.8475.",
    CERTIFICATE,
)
def exponent() -> str:
    """The left side falls in the exponent, all bases being above 1."""
    demand(X == mpq(8475, 10000), "0.8475")
    before, after = mpq(84747770, 10**8), mpq(84747771, 10**8)
    demand(bool(characteristic(before)[0] > 1), "above 1 at 0.84747770")
    demand(bool(characteristic(after)[1] < 1), "below 1 at 0.84747771")
    return f"at 0.8475: {shown(characteristic(X))}"


@CHAPTER.proved(
    "Section 5.2",
    "0.85192, 0.83334, 0.01858, 1.1824 and the final 0.99999 are on the right side.",
    CERTIFICATE,
)
def printed_numbers() -> str:
    """h <= 0.85192, 5/6 <= 0.83334, 3^(1-x) <= 1.1824; with 0.39413 for 0.39414 the end holds."""
    demand(bool(row_part()[1] <= mpq(85192, 10**5)), "0.85192")
    demand(bool(mpq(5, 6) <= mpq(83334, 10**5)), "0.83334")
    demand(mpq(85192 - 83334, 10**5) == mpq(1858, 10**5), "0.01858 is their difference")
    demand(bool(3 * minus_power(3)[1] <= mpq(11824, 10**4)), "1.1824")
    demand(bool(minus_power(3)[0] >= mpq(39413, 10**5)), "0.39413")
    end = mpq(11824, 10**4) * mpq(85192, 10**5) - mpq(39413, 10**5) * mpq(1858, 10**5)
    demand(bool(end < mpq(99999, 10**5)), "0.99999")
    return f"3^-x = {shown(minus_power(3), 7)}; with 0.39413 the end is {end}"


@CHAPTER.refuted(
    "Section 5.2", '"m_2^0.8475 >= 0.39414 m^0.8475" for m_2 >= m/3.', "certified enclosure"
)
def lower_bound_0_39414() -> str:
    """3^-0.8475 < 0.39414: it is rounded the wrong way."""
    demand(bool(minus_power(3)[1] < mpq(39414, 10**5)), "3^-x < 0.39414")
    return f"m_2 = m/3: 3^-x = {shown(minus_power(3), 7)}"


@CHAPTER.refuted(
    "Section 5.2",
    "The recurrence contracts min(m, k)^x max(m, k), if m' < k' is not assumed.",
    "certified enclosure",
)
def potential_of_the_paper() -> str:
    """m = k, a split by rows in three with m_i = m/3, k_1 = 0.113 k, k_2 = k/3, k_3 the rest.

    Parts as in Figure 11 turned: (m_1, k_i), with half the rows for k_2; (m_2, 5 k/6); as m_1.
    """
    parts = []
    for m_i in (mpq(1, 3), mpq(1, 3)):
        k_1, k_2 = mpq(113, 1000), mpq(1, 3)
        parts += [(m_i, k_1), (m_i / 2, k_2), (m_i, 1 - k_1 - k_2)]
    parts.append((mpq(1, 3), mpq(5, 6)))
    total = sum((power_between(min(p), X)[0] * max(p) for p in parts), mpq(0))
    demand(bool(total > mpq(10159, 10000)), "more than 1.0159 of what it was")
    return f"ratio at least {shown((total, total), 7).split('..')[0]}"


@CHAPTER.proved(
    "Section 5.2 (repaired)",
    "Without rounding terms phi(m, k) = m^x k + m k^x contracts: a split by columns takes m^x k to "
    "at most 0.9425 and m k^x to at most 0.999974 of it; by rows the other way round.",
    CERTIFICATE,
)
def contraction() -> str:
    """(A) and (B) of the module's docstring."""
    third, five, half = minus_power(3), power_between(mpq(5, 6), X), minus_power(2)
    demand(bool(mpq(5, 2) * third[0] > five[1]), "(A) 2.5 * 3^-x > (5/6)^x")
    demand(bool(row_part()[0] > mpq(5, 6)), "(B) h > 5/6")
    demand(bool(0 < half[0] and half[1] < 1 and 0 < X < 1), "concave powers")
    demand(bool(contraction_a()[1] < mpq(9425, 10**4)), "g_1 < 0.9425")
    demand(bool(contraction_b()[1] < mpq(999974, 10**6)), "g_2 < 0.999974")
    return f"g_1 = {shown(contraction_a())}, g_2 = {shown(contraction_b())}"


@CHAPTER.proved(
    "Lemma 12 (repaired)",
    "A rectangle of m rows and k columns makes at most 16 (m^x k + m k^x) triangles, x = 0.8475, "
    "rounding terms included.",
    CERTIFICATE,
)
def induction() -> str:
    """The module's docstring."""
    least, _ = power_between(mpq(TRIVIAL), X)
    _, root = power_between(mpq(TRIVIAL), 1 - X)
    demand(bool(root <= CONSTANT / 2), "(i) K^(1-x) <= C/2")
    two, six = minus_power(2), minus_power(6)
    with_m = CONSTANT * (1 + 2 * two[1]) + 8
    with_k = CONSTANT * (six[1] + mpq(1, 6)) + 4
    demand(bool(CONSTANT * (1 - contraction_b()[1]) * least >= with_m), "(ii) m")
    demand(bool(CONSTANT * (1 - contraction_a()[1]) * least >= with_k), "(ii) k")
    gain = CONSTANT * (1 - contraction_b()[1]) * least
    return (
        f"gain {shown((gain, gain), 5)} m against {shown((with_m, with_m), 5)} m at K = {TRIVIAL}"
    )


@CHAPTER.proved(
    "Lemma 12 (repaired)",
    "For m, k <= 406, or one of them at most 4, the constant is 5/2, as checked on every run.",
    CERTIFICATE,
)
def small_rectangles() -> str:
    """2 m k <= c phi just if m^(x-1) + k^(x-1) >= 2/c."""
    c, y = bounds_convex.POWER_CONSTANT, 1 - X
    demand(bool(c * 2 * minus_power(406, y)[0] >= 2), "406")
    demand(bool(c * 2 * minus_power(407, y)[1] < 2), "not 407")
    demand(bool(c * minus_power(4, y)[0] >= 2), "4")
    low, high = power_bounds(406, X, bounds_convex.POWER_BITS)
    demand(bool(low <= high and 2 * 406**2 <= c * 2 * 406 * high), "power_sum()")
    return "2 * 406^-0.1525 >= 4/5"


@CHAPTER.open("Lemma 12 (repaired)", "The constant is 5/2 for all m and k.")
def constant() -> str:
    """It cannot be below 2 * 3^(1-x): three rows, the middle one tall, are not reduced."""
    least = 2 * 3 * minus_power(3)[0]
    demand(bool(least < bounds_convex.POWER_CONSTANT), "5/2 is above it")
    return (
        "the recursion's worst case is at most 1.66 for m, k <= 700 and 1.81 for m <= 24, "
        "k <= 4000; checked on every block of every run; not below 2.365"
    )
