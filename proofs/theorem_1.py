"""Theorem 1 with explicit constants."""

from __future__ import annotations

from typing import Any

import sympy
from gmpy2 import mpq

from bern_exact.checkers import bounds, bounds_blocks, bounds_grid
from bern_exact.exact.enclosures import sqrt_enclosure
from proofs.algebra import demand_equal
from proofs.statement import CERTIFICATE, IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements

TRIANGLES_A_VERTEX = {"square": 4850, "corner": 3674}
"""Theorem 1's constants, by shape of block."""


def without_floors(value: Any) -> Any:
    """At least the value: floor(x) <= x, where floors are added."""
    return value.replace(sympy.floor, lambda inner: inner)


@CHAPTER.proved(
    "Section 2, dicing", "Near the boundary there are at most 14 (n' + X) triangles, and Q has at "
    "most 13 (n' + X) = 858 n edges, for n' <= 2 n vertices and X <= 32 n' q-vertices of P'.",
    IDENTITY,
)  # fmt: skip
def near_the_boundary() -> str:
    """The counts of `touched_triangles` and `region_edges`, whose docstrings are the proof.

    Every piece of the boundary of P' between neighbouring nodes lies on one face.  A face with
    pieces has at most 6 grid vertices, which make chains with at most 5 edges between two grid
    vertices; its m nodes make at most m - 2 triangles.  A rectangle without a piece is touched
    because a corner of it moves: 4 a moved vertex, 8 edges round them; a rectangle has
    no node on a side, as intervals end on the boundary alone.
    """
    n = sympy.Symbol("n", integer=True, positive=True)
    lopped = bounds.lopped_vertices(n)
    pieces = lopped + bounds.crossings(lopped)
    demand_equal(lopped, 2 * n, "each acute vertex becomes two")
    demand_equal(pieces, 66 * n, "n' + X")
    demand_equal(bounds.touched_triangles(lopped), 14 * pieces, "(6 - 2) + 2 + 4 * 2")
    demand_equal(bounds.region_edges(lopped), 13 * pieces, "(6 - 1) + 8")
    return "14 * 66 n = 924 n, 13 * 66 n = 858 n"


@CHAPTER.proved(
    "Theorem 1",
    "At most 4850 n triangles (3674 n with 2 x 2 blocks), each face being triangulated by its own "
    "vertices.",
    IDENTITY,
)
def count() -> str:
    """The sum of the parts' counts, on a symbol n; holes are at most N/4, a loop having 4 edges."""
    n = sympy.Symbol("n", integer=True, positive=True)
    for shape, constant in TRIANGLES_A_VERTEX.items():
        total = without_floors(bounds.theorem_1_triangles(n, shape))  # type: ignore[arg-type]
        demand_equal(total, constant * n, f"{shape} blocks")
    return "924 + 4 * 858 + 2 * 858/4 + 65 = 4850"


@CHAPTER.proved(
    "Theorem 1",
    "All heights are at least s/272.7, with the paper's tau = 1/8 and b = s'/8 (in blocks by the "
    "certificate of the shipped rule, which `--full` replays).",
    CERTIFICATE,
)
def height() -> str:
    """The least of the parts: tau/sqrt 2 near the boundary, 1/sqrt 2 inside Q, and the fans.

    Near the boundary: `face_heights` outside blocks, `lemma_2.statements.shipped_rule` within,
    where sides are at least tau, as they are outside (`section_2.least_edge`).  A fan's base is at
    least tau, so that it has tau/sqrt 2, or the cut triangle's own height of s sqrt(2)/6 rho, which
    is more.  Multiplied by b >= (1 - 2^-9) s'/8 and s' >= (1 - 2^-9) s/3.
    """
    part = bounds.boundary_height_squared()
    demand(bool(part <= bounds.INTERIOR_HEIGHT_SQUARED), "Lemma 3")
    demand(bool(part <= bounds.edge_squared() / 2), "fans")
    rounding = bounds.CUT_ROUNDING**2 * bounds_grid.UNIT_ROUNDING**2
    total = part * bounds.LOPPED_FEATURE_SQUARED * rounding / bounds_grid.FACTOR**2
    demand(bounds.theorem_1_height_squared() == total, "theorem_1_height_squared()")
    demand(bool(total <= bounds.CUT_HEIGHT_SQUARED * bounds.CUT_ROUNDING**2), "cut triangles")
    demand(bool(total * mpq(2727, 10) ** 2 >= 1), "s/272.7")
    corner = bounds.theorem_1_height_squared(shape="corner", factor=mpq(9, 2))
    demand(
        bool(corner == bounds_blocks.block_height_squared("corner") * total / part * 256 / 81),
        "2 x 2 blocks with s' = 9/2 b",
    )
    return "s/height = {} .. {}".format(*sqrt_enclosure(1 / total, 6))
