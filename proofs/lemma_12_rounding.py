"""Lemma 12's constants for all m and k: 5/2 with x = 0.8475, and 3 with the better x = 0.8.

**What is used.**  R(m, k) is the most triangles of m rows and k columns; M = m + 1 and K = k + 1
count lines.  Of a split by columns with m, k >= 4 (`lemma-12.parts`, `.medians`, `.separation`,
`.count` and `lemma-11.most` are checked on every run), *wide* being at least the lesser median:

- l and r are different, as are t and b, the first and the last wide row: ceil(m/3) >= 2 rows and
  ceil(k/3) >= 2 columns are wide.  They leave k_1 + k_2 + k_3 = k - 2 columns, k_2 + 2 >= k/3, and
  m_1 + m_2 + m_3 = m - 2 rows, m_2 + 2 >= m/3.
- t and b are the same for both outer parts, which have all rows.
- In an outer part floor(k_i/2) of the k_i - 1 lines go, as all may (also if k_i < 2).
- Between l and r at least e = max(ceil(u/2), floor(m_1/2) + floor(m_3/2)) lines go.  The first:
  u = m - 1 - 2 (ceil(m/3) - 1) lines are next to no row higher than the median.  The second,
  **which the paper does not use**: the rows before t and after b are not wide, so that all lines
  among them may go.  So where the outer parts are long (m_2 small), what is between shrinks most.
  If more go, what is between is smaller, and A does not decrease.

**Lines instead of rows.**  T(M, K) = R(m, k) + 2 M + 2 K - 2, and T(M, 1) = 2 M for no column at
all.  l and r have 4 m - 2 e triangles, t and b 4 k_i - 2 floor(k_i/2); all these terms cancel:
  T(M, K) <= T(M', K_2) + sum over i = 1, 3 of T(M_1, K_i) + T(M_3, K_i) + T(M_2, K_i'')   (1)
with K_1 + K_2 + K_3 = K, M_1 + M_2 + M_3 = M, all at least 1, K_2 >= (K - 4)/3, M_2 >= (M - 4)/3,
K_i'' = floor((K_i + 2)/2), M' = M - e.  For K_i <= 2 both sides are 2 M K_i: outer parts of one
column or none need no case of their own.  T <= 2 M K always, and T = 2 M K if m or k < 2.

**Claim.**  T(M, K) <= A(M) K + M A(K), A being the non-decreasing function of
`lemma_12_potential`.  If A(M)/M + A(K)/K >= 2, so if M or K <= 4, nothing is to be shown.  Else by
induction each T in (1) is bounded so, and it remains to bound the sum S of these, in two halves.
(A) A(M') K_2 + (A(M_1) + A(M_3)) (K_1 + K_3) + A(M_2) (K_1'' + K_3''), with K_i'' <= K_i/2 + 1 and
P = A(M_1) + A(M_3) + A(M_2)/2, is A(M') K_2 + P (K - K_2) + 2 A(M_2) at most, so by
(K - 4)/3 <= K_2 <= K - 2 at most K alpha + beta, for the worst M_1, M_2, M_3:
  alpha = max(A(M')/3 + 2 P/3, A(M')),  beta = 2 A(M_2) + min(4/3 (P - A(M')), 2 (P - A(M'))).
(B) M' A(K_2) + sum of (M - M_2) A(K_i) + M_2 A(K_i'').  M' <= (5 M + 2)/6 and
M' <= (M + M_2)/2 + 2.  As a function of M_2 it is greatest at M_2 = (M - 4)/3, or where both
bounds of M' are equal, M_2 = (2 M - 10)/3.  So it is at most M B(K) + gamma(K),
  B = max of (2/3) A(K_2) + sum of (2/3) A(K_i) + (1/3) A(K_i''), and
      (5/6) A(K_2) + sum of (1/3) A(K_i) + (2/3) A(K_i''),
  gamma = max of (4/3) (A(K_2) + D_1 + D_3) and A(K_2)/3 + (10/3) (D_1 + D_3), where
  D_i = A(K_i) - A(K_i'').
The claim follows for (M, K) if
  K (A - alpha)(M) + M (A - B)(K) >= beta(M) + gamma(K).                                   (2)
A split by rows is the same with M and K exchanged.  Up to N lines all is a table.

**More lines.**  For K > N, A(K) = c K^x.  For all K, c K^x - F' <= A(K) <= c K^x + F, with F and F'
from the table.  With (y + z)^x <= y^x + z^x, and h = 2/3 + 2^-x/3:
- B, first form: f(K_2/K) c K^x, f(t) = (2/3) t^x + 2^(1-x) h (1 - t)^x; f is concave and
  f'(1/3) = -x 3^(1-x) 2^-x/3 < 0, so that f(t) <= v = 3^-x (2/3 + 2 h) + (4/3) |f'(1/3)|/K.
  To this add c 2/3 for K_i/2 + 1 and 8/3 F.
- B, second form: at most (5/6) 2^(1-x) c K^x, as 2^(1-x) (1/3 + (2/3) 2^-x) <= 5/6; and
  c 4/3 + (17/6) F.  So A - B >= 0 for K > N if it is by these bounds at K = N.
- gamma <= g A(K) by D_i <= c K_i^x (1 - 2^-x) + F + F'.
- For M > N and M_2/M between p and q, with v = min(5/6, (1 + q)/2)^x and
  w = 2^(1-x) (1 - p)^x + q^x/2, (A) is at most K a A(M) + b A(M), with a = max(v/3 + 2 w/3, v) and
  b = 2 q^x + min(4/3 (w - v), 2 (w - v)) and small terms, as A(M') <= c v M^x + 2^x c + F,
  P <= c w M^x + 5/2 F and A(M_2) <= c q^x M^x + F.
`demand_many_lines` checks (2) by these if M or K is more than N: see there.

**The end.**  R <= min(2 m k, A(M) K + M A(K) - 2 M - 2 K + 2) <= C (m^x k + m k^x):
`demand_constant`.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import sympy
from gmpy2 import mpq

from bern_exact.checkers import bounds_convex
from bern_exact.exact.enclosures import power_bounds
from proofs.algebra import demand_equal
from proofs.lemma_12_potential import BITS, LEAST, UNIT, Integers, Potential, Table, table_of
from proofs.powers import Bounds, power_between, shown
from proofs.statement import CERTIFICATE, IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements

PRINTED = Potential(bounds_convex.EXPONENT, mpq(226, 100), 1000, mpq(1, 10))
"""For the printed exponent."""

BETTER = Potential(mpq(4, 5), mpq(285, 100), 2000, mpq(1, 5))
"""For 0.8."""

BETTER_CONSTANT = mpq(3)
"""C for the exponent 0.8."""

LEAST_EXPONENT = mpq(792, 1000)
"""Just above the root 0.79126... of 3^-x (2 + (2/3) 2^-x) = 1."""

LEAST_EXPONENT_CONSTANT = mpq(13)
"""C for it."""

PIECES = 48
LEAST_PIECE = mpq(33, 100)
"""M_2/M is taken in so many pieces from this to 1."""


class Analytic(NamedTuple):
    """Bounds for more than N lines, as in the module's docstring.

    Parameters
    ----------
    unit : mpq
        c N^x, from below: A(K) is more.
    rho : mpq
        c N^(x-1), from above: A(K)/K is less.
    gamma : mpq
        g.
    pieces : tuple of pair of mpq
        a and b for each piece of M_2/M.
    """

    unit: mpq
    rho: mpq
    gamma: mpq
    pieces: tuple[tuple[mpq, mpq], ...]


def main_term(x: mpq) -> Bounds:
    """3^-x (2/3 + 2 h) = 3^-x (2 + (2/3) 2^-x), of the first form of B."""
    third, half = (power_between(mpq(base), -x) for base in (3, 2))
    return third[0] * (2 + mpq(2, 3) * half[0]), third[1] * (2 + mpq(2, 3) * half[1])


def demand_gain(p: Potential, unit: mpq, above: mpq) -> None:
    """A - B >= 0 for more than N lines, F being `above`."""
    x, c = p.exponent, p.factor
    two, half = power_between(mpq(2), 1 - x)[1], power_between(mpq(2), -x)[1]
    slope = x * power_between(mpq(3), 1 - x)[1] * half / 3
    loss = c * (mpq(2, 3) + mpq(4, 3) * slope) + mpq(8, 3) * above
    demand(bool(unit * (1 - main_term(x)[1]) >= loss), "B, first form")
    demand(bool(two * (mpq(1, 3) + mpq(2, 3) * half) <= mpq(5, 6)), "5/6 is the greater factor")
    loss = c * mpq(4, 3) + mpq(17, 6) * above
    demand(bool(unit * (1 - mpq(5, 6) * two) >= loss), "B, second form")


def pieces(p: Potential, unit: mpq, above: mpq) -> Iterator[tuple[mpq, mpq]]:
    """a and b for each piece; M_2/M >= (N - 4)/(3 N)."""
    x = p.exponent
    demand(bool(p.size - 4 >= 3 * p.size * LEAST_PIECE), "M_2 >= 33/100 M")
    two, halves = power_between(mpq(2), x)[1], power_between(mpq(2), 1 - x)[1]
    rest = max(two * p.factor + above, mpq(5, 2) * above) / unit
    for i in range(PIECES):
        low, high = (LEAST_PIECE + (1 - LEAST_PIECE) * mpq(j, PIECES) for j in (i, i + 1))
        v = power_between(min(mpq(5, 6), (1 + high) / 2), x)[1]
        q = power_between(high, x)[1]
        w = halves * power_between(1 - low, x)[1] + q / 2
        more = min(mpq(4, 3) * (w - v), 2 * (w - v))
        yield max(v / 3 + 2 * w / 3, v) + rest, 2 * q + more + 2 * above / unit


def analytic(p: Potential, above: mpq, below: mpq) -> Analytic:
    """The bounds for more than N lines, F and F' being given; A - B >= 0 among them."""
    x = p.exponent
    least, most = power_between(mpq(p.size), x)
    unit = p.factor * least
    demand_gain(p, unit, above)
    three, two = (power_between(mpq(base), 1 - x)[1] for base in (3, 2))
    half = power_between(mpq(2), -x)[0]
    first = mpq(4, 3) * three + 4 * above / unit
    second = mpq(1, 3) + mpq(10, 3) * (1 - half) * two + 7 * (above + below) / unit
    return Analytic(
        unit, p.factor * most / p.size, max(first, second), tuple(pieces(p, unit, above))
    )


def gaps(table: Table) -> tuple[mpq, mpq]:
    """F and F'."""
    above, below = (table.a - table.low)[1:].max(), (table.high - table.a)[1:].max()
    return mpq(max(int(above), 0), UNIT), mpq(max(int(below), 0), UNIT)


def demand_table(p: Potential, table: Table) -> int:
    """(2) for M, K <= N where 2 M K is more than the claim: for how many M, K."""
    lines = np.arange(LEAST, p.size + 1)
    rows, columns = lines[:, None], lines[None, :]
    a, b, alpha, beta, gamma = (
        values[LEAST:] for values in (table.a, table.b, table.alpha, table.beta, table.gamma)
    )
    trivial = a[:, None] * columns + rows * a[None, :] >= 2 * UNIT * rows * columns
    left = (6 * a - alpha)[:, None] * columns + rows * (6 * a - b)[None, :]
    holds = left >= beta[:, None] + gamma[None, :]
    demand(bool((trivial | holds).all()), "(2) in the table")
    demand(bool((6 * a >= b).all()), "A >= B in the table")
    demand(bool((np.diff(table.a) >= 0).all()), "A does not decrease")
    after = p.factor * power_between(mpq(p.size + 1), p.exponent)[0]
    demand(bool(mpq(int(table.a[-1]), UNIT) <= after), "nor from N to N + 1")
    return int((~trivial).sum())


def demand_many_lines(p: Potential, table: Table, found: Analytic) -> None:
    """(2) if M or K is more than N, and A(M)/M + A(K)/K < 2.

    A/lines of the greater of M and K is at most r, the lesser of rho and 2 - A/lines of the other.

    - M <= N < K: divided by K, it suffices that (A - alpha)(M) >= beta(M)/N + g r.
    - K <= N < M: A(M) is multiplied by q = (1 - a) K - b, for each piece.  If q >= 0, both q A(M)
      and M (A - B)(K) are least at M = N.  Otherwise q A(M) >= q r M, and it suffices that
      N ((A - B)(K) + q r) >= gamma(K).
    - N < M, K: half of K (1 - a) A(M) is at least b A(M), the other half at least g A(K).
    """
    for lines in range(LEAST, p.size + 1):
        a = mpq(int(table.a[lines]), UNIT)
        b, alpha, beta, gamma = (
            mpq(int(values[lines]), 6 * UNIT)
            for values in (table.b, table.alpha, table.beta, table.gamma)
        )
        r = min(found.rho, max(mpq(0), 2 - a / lines))
        enough = found.gamma * r + max(beta, mpq(0)) / p.size
        demand(bool(a - alpha >= enough), f"M = {lines}, K large")
        for of_k, of_one in found.pieces:
            q = (1 - of_k) * lines - of_one
            gain = p.size * (a - b) + q * (found.unit if q >= 0 else p.size * r)
            demand(bool(gain >= gamma), f"K = {lines}, M large")
    demand_both_large(p, found)


def demand_both_large(p: Potential, found: Analytic) -> None:
    """The last case of `demand_many_lines`."""
    for of_k, of_one in found.pieces:
        demand(bool(p.size * (1 - of_k) >= 2 * of_one), "both large, b")
        demand(bool((1 - of_k) * found.unit >= 2 * found.gamma * found.rho), "both large, g")


def demand_constant(p: Potential, table: Table, constant: mpq) -> None:
    """R <= C (m^x k + m k^x), by 2 m k or by the claim.  d(m) = C m^x - A(M) + 2.

    - m, k < N: in the table.
    - m < N <= k: A(K) <= c (k^x + 1), and k d + (C m - c M) k^x >= c M + A(M) - 2 M is wanted,
      where k^x <= r k, r being the lesser of N^(x-1) and 2/C - m^(x-1), if C m < c M.
    - N <= m, k: the claim is at most c (m^x k + m k^x) + c (m^x + k^x + m + k), the last at most
      2 c (m + k); and m^x k + m k^x >= N^x (m + k).
    """
    x, c, size = p.exponent, p.factor, p.size
    plain = [power_bounds(rows, x, BITS) for rows in range(size + 1)]
    least = np.array([int(low * UNIT) for low, _ in plain], np.int64)
    demand_constant_in_table(table, least, constant)
    of_size = power_between(mpq(size), x)
    for rows in range(LEAST - 1, size):
        lines, a = rows + 1, mpq(int(table.a[rows + 1]), UNIT)
        difference, of_power = constant * plain[rows][0] - a + 2, constant * rows - c * lines
        r = min(of_size[1] / size, max(mpq(0), 2 / constant - plain[rows][0] / rows))
        each = difference + min(of_power, mpq(0)) * r
        gain = size * each + max(of_power, mpq(0)) * of_size[0]
        demand(bool(each >= 0 and gain >= c * lines + a - 2 * lines), f"m = {rows}, k large")
    demand(bool((constant - c) * of_size[0] >= 2 * c), "m and k large")
    few = range(1, LEAST - 1)
    demand(all(2 * rows <= constant * plain[rows][0] for rows in few), "2 m k, m < 4")


def demand_constant_in_table(table: Table, least: Integers, constant: mpq) -> None:
    """m, k < N; the powers from below."""
    rows = np.arange(1, len(least) - 1)
    m, k, lines, a = rows[:, None], rows[None, :], rows + 1, table.a[2:]
    top, bottom = int(constant.numerator), int(constant.denominator)
    bound = top * (least[1:-1][:, None] * k + m * least[1:-1][None, :])
    claim = a[:, None] * lines[None, :] + lines[:, None] * a[None, :] - 2 * UNIT * (m + k + 1)
    demand(bool((bottom * np.minimum(2 * UNIT * m * k, claim) <= bound).all()), "m, k < N")


def proof(p: Potential, constant: mpq) -> str:
    """All of it."""
    table = table_of(p)
    pairs = demand_table(p, table)
    demand_many_lines(p, table, analytic(p, *gaps(table)))
    demand_constant(p, table, constant)
    return f"A = {p.factor} K^x from {p.size} lines on; (2) for {pairs} pairs of fewer lines"


@CHAPTER.proved(
    "Lemma 12 (sharper)",
    "With M = m + 1 and K = k + 1 lines, R + 2 M + 2 K - 2 of a split is at most the sum of the "
    "same over its seven parts, no term being left.",
    IDENTITY,
)
def recurrence() -> str:
    """(1) of the module's docstring; `section_5.lemma_11_patterns` has the lines that go."""
    m, k, gone = sympy.symbols("m k e")
    of_rows, of_columns = sympy.symbols("m_1:4"), sympy.symbols("k_1:4")
    merged = sympy.symbols("e_1 e_3")

    def triangles(rows: sympy.Expr, columns: sympy.Expr, lines: sympy.Expr) -> sympy.Expr:
        return lines - 2 * (rows + 1) - 2 * (columns + 1) + 2

    parts = [(m - gone, of_columns[1])]
    own = 4 * m - 2 * gone
    for columns, fewer in zip((of_columns[0], of_columns[2]), merged, strict=True):
        parts += [(of_rows[0], columns), (of_rows[1], columns - fewer), (of_rows[2], columns)]
        own += 4 * columns - 2 * fewer
    values = sympy.symbols("T_1:8")
    made = own + sum(triangles(*part, value) for part, value in zip(parts, values, strict=True))
    whole = made + 2 * (m + 1) + 2 * (k + 1) - 2
    whole = whole.subs({m: sum(of_rows) + 2, k: sum(of_columns) + 2})
    demand_equal(whole, sum(values), "T is the sum")
    demand_equal(triangles(m, k, 2 * (m + 1) * (k + 1)), 2 * m * k, "2 M K is 2 m k")
    return "4 m - 2 e and 4 k_i - 2 e_i cancel"


@CHAPTER.proved(
    "Lemma 12 (repaired)",
    "A rectangle of m rows and k columns makes at most 5/2 (m^x k + m k^x) triangles, x = 0.8475, "
    "rounding terms included, for all m and k.",
    CERTIFICATE,
)
def constant() -> str:
    """The module's docstring."""
    return proof(PRINTED, bounds_convex.POWER_CONSTANT)


@CHAPTER.proved(
    "Lemma 12 (sharper)",
    "It makes at most 3 (m^0.8 k + m k^0.8) triangles.",
    CERTIFICATE,
)
def better_exponent() -> str:
    """The module's docstring."""
    return proof(BETTER, BETTER_CONSTANT)


@CHAPTER.proved(
    "Lemma 12 (sharper)",
    "It makes at most 13 (m^0.792 k + m k^0.792) triangles.",
    CERTIFICATE,
)
def least_exponent() -> str:
    """Without a table: A(K) = c K^x for all K, c = 2 N^(1-x), so that A(K) >= 2 K up to N lines.

    With F = F' = 0 only the last case of `demand_many_lines` is left.  At the end, m or k < N - 1
    is trivial, and else M^x K + M K^x <= (N/(N - 1))^2 (m^x k + m k^x).
    """
    x, size = LEAST_EXPONENT, 7000
    p = Potential(x, 2 * power_between(mpq(size), 1 - x)[1], size, mpq(0))
    demand_both_large(p, analytic(p, mpq(0), mpq(0)))
    demand(bool(p.factor * mpq(size, size - 1) ** 2 <= LEAST_EXPONENT_CONSTANT), "13")
    before, after = mpq(79126, 10**5), mpq(79127, 10**5)
    demand(bool(main_term(before)[0] > 1 > main_term(after)[1]), "the root")
    return (
        f"N = {size}, c = {shown((p.factor, p.factor), 5)}; main terms {shown(main_term(x), 6)}, "
        "1 between 0.79126 and 0.79127"
    )
