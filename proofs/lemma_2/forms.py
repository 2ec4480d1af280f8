"""Affine forms in integers: what a quantity can be over a box, to first order, rounded outwards.

A form stands for every value (c + sum a_i e_i + r e) / 2^BITS with all e_i and e in [-1, 1].
Its e_i are shared with other forms: e_0 to e_3 say where in the box the parameters x, y, m_e and
m_f are, e_4 to e_7 where in its gap a column's crossing is.  c, a_i and r >= 0 are int64 arrays,
an entry a box (or one integer for all).

Nothing overflows as long as no form at the scale 2^BITS leaves [-8, 8]: `bounded` says so.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

BITS = 24
ONE = 1 << BITS
LIMIT = 8 * ONE

Array = Any
"""An int64 array or an integer."""


@dataclass(slots=True)
class Form:
    """A form; see the module.

    Parameters
    ----------
    c : Array
        The centre.
    a : dict of int to Array
        The coefficients of shared symbols.
    r : Array
        The radius of what is not shared.
    """

    c: Array
    a: dict[int, Array] = field(default_factory=dict)
    r: Array = 0

    def linear(self) -> Array:
        """The sum of |a_i|."""
        return sum((abs(v) for v in self.a.values()), 0)

    def radius(self) -> Array:
        """The greatest distance from the centre."""
        return self.linear() + self.r

    def __add__(self, other: Form) -> Form:
        a = dict(self.a)
        for i, v in other.a.items():
            a[i] = a[i] + v if i in a else v
        return Form(self.c + other.c, a, self.r + other.r)

    def __sub__(self, other: Form) -> Form:
        return self + other.times(-1)

    def times(self, k: int) -> Form:
        """An integer multiple."""
        return Form(k * self.c, {i: k * v for i, v in self.a.items()}, abs(k) * self.r)

    def scaled(self, k: Array) -> Form:
        """A multiple that is another one for each box, k >= 0."""
        return Form(k * self.c, {i: k * v for i, v in self.a.items()}, k * self.r)

    def plus(self, k: Array) -> Form:
        """This and a constant."""
        return Form(self.c + k, self.a, self.r)


def integer(k: int) -> Form:
    """A constant."""
    return Form(k * ONE)


def product(p: Form, q: Form) -> Form:
    """The product, at the scale 2^(2 BITS): exact but for its terms of second order.

    a_i b_i e_i^2 is between 0 and a_i b_i; of the others only the size is kept.
    """
    c, rest = p.c * q.c, p.radius() * q.radius() + abs(p.c) * q.r + abs(q.c) * p.r
    a = {i: q.c * v for i, v in p.a.items()}
    for i, v in q.a.items():
        own = p.c * v
        if i in a:
            square = p.a[i] * v
            size = abs(square)
            c = c + (square >> 1)
            rest = rest - size + ((size + 1) >> 1)
            a[i] = a[i] + own
        else:
            a[i] = own
    return Form(c, a, rest)


def lowered(p: Form, shift: int = BITS) -> Form:
    """A form divided by 2^shift: every coefficient is rounded by less than 1."""
    a = {i: v >> shift for i, v in p.a.items()}
    return Form(p.c >> shift, a, (p.r >> shift) + (2 + len(a)))


def quotient(
    p: Form, q: Form, low: Array, high: Array, symbol: int | None, base: Form | None = None
) -> Form:
    """base + p/q, which is known to lie between low and high; that alone where it says as much.

    With c the centre of q, d = |c|, rho its radius, and k near the quotient of the centres: p/q =
    k + R/q, R = p - k q; and R/q differs from R/c by at most |R| rho / (d (d - rho)).

    Parameters
    ----------
    p, q : Form
        Within [-8, 8].
    low, high : Array
        Between which the result is, at the scale 2^BITS.
    symbol : int or None
        The shared symbol that says where between them, if it has one.
    base : Form, optional
        What is added.
    """
    d, rho = abs(q.c), q.radius()
    usable = (8 * rho < 7 * d) & (abs(p.c) <= 8 * d)
    c, d = np.where(usable, q.c, ONE), np.where(usable, d, ONE)
    k = np.where(usable, (p.c * ONE) // c, 0)
    rest = p.times(ONE) - Form(k * q.c, {i: k * v for i, v in q.a.items()}, abs(k) * q.r)
    size = np.where(usable, (abs(rest.c) + rest.radius()) // d + 1, 0)
    usable = usable & (size <= LIMIT)
    rho = np.where(usable, rho, 0)
    error = np.where(usable, size, 0) * rho // (d - rho) + 1
    a = {i: v // c for i, v in rest.a.items()}
    result = Form(k + rest.c // c, a, rest.r // d + error + (2 + len(a)))
    if base is not None:
        result = result + base
    return _chosen(result, usable, low, high, symbol)


def _chosen(form: Form, usable: Array, low: Array, high: Array, symbol: int | None) -> Form:
    """A form where it is usable and tells more than that the value is between low and high."""
    half = (high - low + 1) >> 1
    usable = usable & (form.radius() <= half)
    a = {i: np.where(usable, v, 0) for i, v in form.a.items()}
    own = np.where(usable, 0, half)
    r = np.where(usable, form.r, 0)
    if symbol is None:
        r = r + own
    else:
        a[symbol] = own
    return Form(np.where(usable, form.c, low + half), a, r)


def bounded(p: Form) -> Array:
    """Is a form within [-8, 8]?"""
    return abs(p.c) + p.radius() <= LIMIT


def is_positive(p: Form) -> Array:
    """Is every value of a form positive?"""
    return p.c > p.radius()


def is_not_negative(p: Form) -> Array:
    """Is no value of a form negative?"""
    return p.c >= p.radius()
