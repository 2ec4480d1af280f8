"""Lemma 12 and Section 5.2: the exponent, and every number, without rounding terms.

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

A split by rows is the same with m and k exchanged, phi being symmetric.

**With rounding** it is done in `lemma_12_rounding`, which gives the constant 5/2.  There the part
between l and r is smaller than the paper has it where the outer parts are long, so that the
worst case of (B) does not occur; that gives exponents below 0.8475 as well.
"""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.checkers import bounds_convex
from bern_exact.convex.block_records import Block
from bern_exact.convex.reduction import Lines, reduce_block
from proofs.powers import Bounds, power_between, shown
from proofs.statement import CERTIFICATE, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements

X = bounds_convex.EXPONENT


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
    "With the exponent 0.8475 no constant below 2 * 3^(1-x) = 2.364... is right for all m and k.",
    CERTIFICATE,
)
def least_constant() -> str:
    """Rows 1, 3, 1 high and k columns 2 wide: only the middle row is as high as the columns' 2.

    So l = r, no line is removed, the outer parts have a single row: 6 k triangles, and
    3^x k + 3 k^x is as near to 3^x k as one likes.
    """
    rows = Lines.between([mpq(y) for y in (0, 1, 4, 5)])
    for count in range(2, 13):
        columns = Lines.between([mpq(2 * i) for i in range(count + 1)])
        made = len(reduce_block(Block(0, count, 0, 3), columns, rows).triangles)
        demand(made == 6 * count, f"6 k triangles for k = {count}")
    three, many = power_between(mpq(3), X)[1], power_between(mpq(10**40), X)[1]
    demand(bool(6 * 10**40 > mpq(2364, 1000) * (three * 10**40 + 3 * many)), "at k = 10^40")
    limit = tuple(6 * bound for bound in minus_power(3))
    return f"6 k / (3^x k + 3 k^x) grows to {shown((limit[0], limit[1]), 6)}"
