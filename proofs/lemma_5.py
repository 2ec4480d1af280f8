"""Lemma 5: angles of trapezoids, and the height that an end face can have."""

from __future__ import annotations

import sympy

from bern_exact.checkers import bounds
from proofs.algebra import demand_equal, demand_nonnegative, demand_positive, symbols
from proofs.statement import IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements


@CHAPTER.proved(
    "Lemma 5",
    "Diagonals of slope -1 meet an edge e of positive slope, and other edges of positive slope on "
    "the staircase, at angles below 135 degrees.",
    IDENTITY,
)
def diagonals_meet_the_edge() -> str:
    """e runs along (1, m), m > 0: the two angles with (-1, 1) have cotangents +-(1 - m)/(1 + m).

    Both are above -1, and 135 degrees has -1.
    """
    m = symbols("m")
    for way in (1, -1):
        dot, cross = way * (-1 + m), 1 + m  # of way (1, m) and (-1, 1), up to the sign
        demand_equal(
            (dot + cross) * (2 if way == 1 else 1), 4 * m if way == 1 else 2, "dot + cross > 0"
        )
    return "dot + cross is 2 m or 2"


@CHAPTER.proved(
    "Lemma 5",
    "Diagonals leave almost-axis-parallel edges at angles of at most 135 degrees + arctan(2 tau): "
    "trapezoids between them have no larger angle.",
    IDENTITY,
)
def diagonals_leave_the_staircase() -> str:
    """An edge along +-(1, k) or +-(k, 1) with |k| <= 2 tau makes with (-1, 1) a cotangent of

    +-(1 - k)/(1 + k), which is at least -(1 + 2 tau)/(1 - 2 tau): the worst is k = -2 tau.
    """
    tau, up, down = symbols("tau up down")
    room = 1 / (1 + down)  # 1 - 2 tau > 0
    worst = bounds.boundary_cotangent(tau)
    demand_equal(worst, -(1 + 2 * tau) / (1 - 2 * tau), "boundary_cotangent()")
    # k = -2 tau + up; -(1 - k)/(1 + k) >= worst, with both denominators positive.
    k = -2 * tau + up
    difference = sympy.cancel((-(1 - k) / (1 + k) - worst) * (1 + k) * (1 - 2 * tau))
    demand_equal(difference, 2 * up, "-(1 - k)/(1 + k) grows with k")
    demand_positive(sympy.cancel((1 - 2 * tau).subs(tau, (1 - room) / 2) * (1 + down)), "tau < 1/2")
    for axis in ((1, k), (k, 1)):
        for way in (1, -1):
            dot = way * (-axis[0] + axis[1])
            cross = axis[0] + axis[1]
            cotangents = {sympy.simplify(dot / cross - s * (1 - k) / (1 + k)) for s in (1, -1)}
            demand(0 in cotangents, f"{way} along {axis}")
    return "cot = +-(1 - k)/(1 + k), least at k = -2 tau"


@CHAPTER.proved(
    "Lemma 5 (repaired)",
    "Where a row ends on e beyond a last crossing with a line that hits e, the diagonal "
    "through that crossing cuts off a triangle of height at least tau/2, and a piece of e of at "
    "least tau/sqrt 2.",
    IDENTITY,
)
def end_face_height() -> str:
    """C = (0, 0) the crossing, E = (L, 0) and (0, D) on e, L, D >= tau; the diagonal's foot is

    F = (x, x), x = L D/(L + D).  The altitudes of C E F: x >= tau/2 from F, L/sqrt 2 from E, and
    L D/sqrt(L^2 + D^2) from C, at least tau/sqrt 2.  And EF^2 = x^2 (L^2 + D^2)/D^2 >= tau^2/2.
    """
    a, c, tau = symbols("a c tau")
    length, depth = tau + a, tau + c
    foot = length * depth / (length + depth)
    demand_equal(foot / length + foot / depth, 1, "F is on e")
    demand_nonnegative(2 * length * depth - tau * (length + depth), "x >= tau/2")
    demand_nonnegative(2 * length**2 - tau**2, "L/sqrt 2 >= tau/2")
    demand_nonnegative(
        2 * length**2 * depth**2 - tau**2 * (length**2 + depth**2), "from C: at least tau/sqrt 2"
    )
    piece = (length - foot) ** 2 + foot**2
    demand_equal(piece, foot**2 * (length**2 + depth**2) / depth**2, "|EF|")
    numerator = length**2 * (length**2 + depth**2) * 2 - tau**2 * (length + depth) ** 2
    demand_nonnegative(numerator, "|EF|^2 >= tau^2/2")
    demand_equal(bounds.merged_height_squared(tau), tau**2 / 4, "merged_height_squared()")
    demand_equal(bounds.base_piece_squared(tau), tau**2 / 2, "base_piece_squared()")
    return "L D/(L + D) >= tau/2, equality at L = D = tau"


@CHAPTER.proved(
    "Theorems 2 and 3",
    "Merging and projecting at most doubles the triangles along the boundary, and adds at most as "
    "many to the fans.",
    IDENTITY,
)
def merged_count() -> str:
    """Faces of m_1, m_2, ... nodes merge to one with at most sum (m_i - 2) + 2 staircase vertices.

    All but the two ends may be projected, each making one vertex more on the base: at
    most 2 sum (m_i - 2) + 2 vertices, and 2 sum (m_i - 2) triangles.
    """
    n = sympy.Symbol("n", integer=True, positive=True)
    lopped = bounds.lopped_vertices(n)
    touched = bounds.touched_triangles(lopped)
    demand_equal(bounds.merged_triangles(lopped), 2 * touched, "merged_triangles()")
    more = bounds.projected_fan_triangles(n, lopped) - bounds.fan_triangles(n, lopped)
    demand_equal(more, touched, "projected_fan_triangles()")
    return "2 * 924 n and 65 n + 924 n"
