"""Random polygons of the kinds that break triangulations, each from a `Random` alone.

They are drawn by the functions of the corpora's families, some with wider ranges.
A family may return rings that are no polygon; `some_polygon` draws until they are.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from random import Random

from gmpy2 import mpq

from bern_exact.corpus import extreme, holes, over_the_grid, shapes, slender, slits, special
from bern_exact.corpus import random_polygons as plain
from bern_exact.corpus.draws import hpoints, pick, places
from bern_exact.exact.errors import InputError
from bern_exact.exact.points import HPoint, coordinates, hpoint
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings

Ring = list[HPoint]
Rings = list[Ring]
Family = Callable[[Random], Rings]
Pairs = Sequence[tuple[int | mpq, int | mpq]]
Places = Sequence[Pairs]


def ring(pairs: Pairs) -> Ring:
    """Points from rational pairs."""
    return [hpoint(mpq(x), mpq(y)) for x, y in pairs]


def mapped(rings: Rings, move: Callable[[mpq, mpq], tuple[mpq, mpq]]) -> Rings:
    """Every point moved."""
    return [[hpoint(*move(*coordinates(p))) for p in each] for each in rings]


def simple(random: Random) -> Places:
    """Random points on a small grid: collinear runs, axis-parallel and 45-degree edges."""
    return [plain.untangled(Random(random.randrange(10**9)), random.randrange(4, 15), 12)]


def simple_with_holes(random: Random) -> Places:
    """A random simple ring with triangular holes on a finer grid, wherever they fit."""
    outer = plain.untangled(Random(random.randrange(10**9)), random.randrange(4, 12), 9)
    return plain.add_holes(random, [list(outer)], 9, tries=8, most=8)


def subdivided(random: Random) -> Places:
    """Any other polygon with 180-degree vertices on its edges, some very near to an end."""
    kind = pick(random, ("simple_with_holes", "maze", "star"))
    return special.subdivide(random, some_places(random, kind))


def far_away(random: Random) -> Places:
    """Any other polygon moved by 10^30 + 1."""
    far = 10**30 + 1
    rings = some_places(random, "simple_with_holes")
    return [[(x + far, y - far) for x, y in each] for each in rings]


def anisotropic(random: Random) -> Places:
    """Any other polygon squeezed by up to 10^9 in one direction, or along a diagonal."""
    thin = mpq(1, 10 ** random.randrange(3, 10))
    rings = some_places(random, pick(random, ("simple", "simple_with_holes")))
    return slender.squeezed(rings, thin, along_diagonal=random.randrange(2) == 0)


DRAWS: dict[str, Callable[[Random], Places]] = {
    "triangle": lambda r: plain.triangle(r, r.randrange(1, 7)),
    "simple": simple,
    "simple_with_holes": simple_with_holes,
    "star": lambda r: shapes.star(r.randrange(4, 25), r.randrange(10**9)),
    "maze": lambda r: shapes.maze(r.randrange(10, 50), r.randrange(10**9)),
    "plate": lambda r: shapes.plate(r.randrange(8, 50), r.randrange(10**9)),
    "spiral": lambda r: shapes.spiral(r.randrange(8, 30), r.randrange(10**9)),
    "rectilinear": lambda r: special.walls(r, r.randrange(10, 40)),
    "octilinear": lambda r: special.cut_off(special.walls(r, r.randrange(10, 40))[0]),
    "subdivided": subdivided,
    "special_frame": lambda r: places(over_the_grid.special_in_first_frames(r)),
    "threshold": lambda r: places(over_the_grid.aimed_at_grid_points(r)),
    "high_bits": lambda r: extreme.shaken(r, some_places(r, "simple_with_holes"), 100),
    "far_away": far_away,
    "anisotropic": anisotropic,
    "outer_slit": lambda r: slender.outer_slit(r, r.randrange(1, 12)),
    "folded_slit": lambda r: slender.folded_slit(r, r.randrange(1, 9)),
    "inner_slit": lambda r: holes.inner_slit(r, r.randrange(1, 6)),
    "comb": lambda r: [slits.needles(r.randrange(4, 14), 10 ** r.randrange(1, 8))],
    "nearly_right": lambda r: special.near_right(r, 13),
    "tiny_holes": lambda r: holes.tiny_holes(r, r.randrange(1, 5), r.randrange(1, 12)),
}


def as_points(draw: Callable[[Random], Places]) -> Family:
    """The family of these draws."""
    return lambda random: hpoints(draw(random))


FAMILIES: dict[str, Family] = {kind: as_points(draw) for kind, draw in DRAWS.items()}


def is_valid(rings: Rings) -> bool:
    """Are these the rings of a polygon?"""
    try:
        polygon_from_rings(rings)
    except InputError:
        return False
    return True


def attempts(random: Random, family: Family) -> Iterator[Rings]:
    """Rings of the family, for ever."""
    while True:
        yield family(random)


def some_rings(random: Random, family: Family) -> Rings:
    """Rings of the family that are a polygon."""
    return next(rings for rings in attempts(random, family) if is_valid(rings))


def some_places(random: Random, kind: str) -> Places:
    """The same as rational pairs."""
    return places(some_rings(random, FAMILIES[kind]))


def some_polygon(kind: str, seed: int) -> Polygon:
    """The polygon of this family and seed."""
    random = Random(f"{kind} {seed}")
    return polygon_from_rings(some_rings(random, FAMILIES[kind]), f"{kind}-{seed}")
