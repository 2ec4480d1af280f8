"""The block program at one exact configuration: for comparing it with the package's rules."""

from __future__ import annotations

from typing import NamedTuple

from gmpy2 import mpq

from bern_exact.boundary.optimal import Demand, best_triangulation
from bern_exact.exact.points import HPoint, hpoint
from proofs.lemma_2.block import CORNERS, block
from proofs.lemma_2.rays import HIGH, LOW, MIDDLE, E, F, RayType
from proofs.lemma_2.warping import Point, outcomes

Vector = tuple[mpq, mpq]

NO_TRIANGULATION = mpq(10**9)
"""Instead of a cotangent, where a face has no triangulation at all."""


class Configuration(NamedTuple):
    """v and its two rays, turned so that e goes up.

    Parameters
    ----------
    v : Vector
        In the unit square.
    slopes : (mpq, mpq)
        m_e and m_f, each in its own frame.
    cls : int
        Where f goes.
    quarters : int
        By how many quarter turns the original is this one turned about (1/2, 1/2).
    """

    v: Vector
    slopes: tuple[mpq, mpq]
    cls: int
    quarters: int


def unturned(quarters: int, p: Vector) -> Vector:
    """A point of the block's frame in that of a ray: `rays.turned` backwards."""
    x, y = p
    return ((x, y), (y, 1 - x), (1 - x, 1 - y), (1 - y, x))[quarters]


def turned_point(quarters: int, p: Vector) -> Vector:
    """A point of a ray's frame in that of the block: as `rays.turned`."""
    return unturned(-quarters % 4, p)


def quarters_of(d: Vector) -> int:
    """By how many quarters up is turned to get nearest to a direction that is not diagonal."""
    if abs(d[1]) > abs(d[0]):
        return 0 if d[1] > 0 else 2
    return 1 if d[0] < 0 else 3


def slope(d: Vector, quarters: int) -> mpq:
    """m of a direction in the frame turned by these quarters."""
    x, y = d
    x, y = ((x, y), (y, -x), (-x, -y), (-y, x))[quarters]
    return x / y


def configuration(v: Vector, out: Vector, into: Vector) -> Configuration:
    """What e (direction `out` from v) and f (direction `into` from v) are when e is turned up."""
    q_e, q_f = quarters_of(out), quarters_of(into)
    return Configuration(
        unturned(q_e, v), (slope(out, q_e), slope(into, q_f)), (q_f - q_e) % 4, q_e
    )


def at(c: Configuration, ray: int, height: mpq) -> mpq:
    """X of a ray at a height in its own frame."""
    x, y = unturned(0 if ray == E else c.cls, c.v)
    return x + (height - y) * c.slopes[ray]


def height_at(c: Configuration, ray: int, column: int) -> mpq:
    """Y of a ray at a column in its own frame."""
    x, y = unturned(0 if ray == E else c.cls, c.v)
    return y + (column - x) / c.slopes[ray]


def part_of(offset: mpq, tau: mpq) -> int:
    """The part of a unit segment."""
    return LOW if offset < tau else HIGH if offset > 1 - tau else MIDDLE


def type_of(c: Configuration, ray: int, tau: mpq) -> RayType:
    """The type of a ray."""
    cells, parts = [], []
    for row in (1, 2):
        x = at(c, ray, mpq(row))
        cell = int(x.numerator // x.denominator)
        part = part_of(x - cell, tau)
        if (cell, part) in ((2, HIGH), (-2, LOW)):
            part = MIDDLE
        cells.append(cell)
        parts.append(part)
    below = above = -1
    if cells[0]:
        below = part_of(height_at(c, ray, 1 if cells[0] == 1 else 0), tau)
    if cells[0] != cells[1]:
        above = part_of(height_at(c, ray, max(cells)) - 1, tau)
    return RayType(cells[0], parts[0], cells[1], parts[1], below, above)


def place(c: Configuration, point: Point) -> Vector:
    """Where a symbolic point is, in the block's frame."""
    name = point[0]
    if name == "v":
        return c.v
    if name == "g":
        return mpq(point[1]), mpq(point[2])
    ray = point[1][1] if name == "slid" else point[1]
    quarters = 0 if ray == E else c.cls
    if name == "row":
        return turned_point(quarters, (at(c, ray, mpq(point[2])), mpq(point[2])))
    if name == "column":
        return turned_point(quarters, (mpq(point[3]), height_at(c, ray, point[3])))
    p = unturned(quarters, place(c, point[2]))
    q = unturned(quarters, (mpq(point[3][0]), mpq(point[3][1])))
    off_p, off_q = (z[0] - at(c, ray, z[1]) for z in (p, q))
    s = off_p / (off_p - off_q)
    return turned_point(quarters, (p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])))


def kappas(c: Configuration, tau: mpq) -> dict[tuple[int, int], mpq]:
    """For each corner, minus the least cotangent in the best triangulation of its worst face."""
    made = block(c.cls, type_of(c, E, tau), type_of(c, F, tau))
    if made is None:
        raise ValueError(f"no rays are of these types: {c}")
    worst: dict[tuple[int, int], mpq] = {}
    for corner in CORNERS:
        worst[corner] = max(
            (
                _kappa([hpoint(*place(c, point)) for point in ring])
                for found in outcomes(made, corner)
                for ring in found.rings
            ),
            default=mpq(0),
        )
    return worst


def _kappa(ring: list[HPoint]) -> mpq:
    found = best_triangulation(ring, Demand(for_angle=True))
    return NO_TRIANGULATION if found is None else -found.value
