"""Polygons for tests and measurements: stars, spirals, combs, plates of holes, random ones."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random

from gmpy2 import mpq
from hypothesis import assume
from hypothesis import strategies as st

from bern_exact.corpus import random_polygons
from bern_exact.corpus.slits import needles
from bern_exact.exact.points import HPoint, grid_point, hpoint
from bern_exact.plane.polygon import Polygon

from .by_definition import is_polygon, twice_area

Ring = list[HPoint]


def star(n: int, seed: int = 1, size: int = 10**9) -> Ring:
    """A star-shaped ring round the origin with radii between size/5 and size."""
    random = Random(seed)
    ring = []
    for i in range(n):
        # The square's boundary, walked round by arc length: distinct rational directions.
        quarter, along = divmod(4 * i * size + 2 * size, n * size)
        x, y = size, (2 * size * along) // (n * size) - size
        for _ in range(quarter):
            x, y = -y, x
        radius = random.randrange(200, 1001)
        ring.append(grid_point(x * radius // 1000, y * radius // 1000))
    return ring


def spiral(n: int) -> Ring:
    """A square spiral corridor of about n vertices, all its edges axis-parallel."""
    turns = max(n // 2 - 1, 2)
    steps = [(4, 0), (0, 4), (-4, 0), (0, -4)]
    x, y = 0, 0
    middle = [(0, 0)]
    for i in range(turns):
        dx, dy = steps[i % 4]
        length = i // 2 + 1
        x, y = x + dx * length, y + dy * length
        middle.append((x, y))
    left, right = [], []
    for i, (px, py) in enumerate(middle):
        ix, iy = steps[max(i - 1, 0) % 4]
        ox, oy = steps[min(i, turns - 1) % 4]
        # The corner's bisector, half the corridor's width to either side.
        ix, iy, ox, oy = ix // 4, iy // 4, ox // 4, oy // 4
        nx, ny = -iy - (oy if (ix, iy) != (ox, oy) else 0), ix + (ox if (ix, iy) != (ox, oy) else 0)
        left.append(grid_point(px + nx, py + ny))
        right.append(grid_point(px - nx, py - ny))
    return right + left[::-1]


def comb(n: int, length: int = 10**9) -> Ring:
    """A comb of about n/2 needles side by side, each two units wide and `length` long."""
    return [grid_point(x, y) for x, y in needles(n, length)]


def plate(holes: int) -> list[Ring]:
    """A square plate with about that many small triangular holes in rows."""
    side = 1
    while side * side < holes:
        side += 1
    rings = [
        [grid_point(x * 10 * side, y * 10 * side) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    ]
    for i in range(holes):
        x, y = 10 * (i % side) + 2, 10 * (i // side) + 2 + i % 3
        rings.append([grid_point(x, y), grid_point(x + 5, y + 1), grid_point(x + 1, y + 4)])
    return rings


def untangled(seed: int, n: int, size: int) -> Ring:
    """A random simple ring: random distinct points, crossings undone by reversals.

    Points may be collinear; the ring may then touch itself (the caller validates it).
    """
    return [grid_point(x, y) for x, y in random_polygons.untangled(Random(seed), n, size)]


def oriented(rings: Sequence[Sequence[HPoint]]) -> Polygon:
    """The polygon of valid rings, not validated: outer ring turned left, holes right."""
    points = tuple(p for ring in rings for p in ring)
    indices, start = [], 0
    for r, ring in enumerate(rings):
        ids = list(range(start, start + len(ring)))
        if (twice_area(ring) > 0) != (r == 0):
            ids = [ids[0], *ids[:0:-1]]
        indices.append(tuple(ids))
        start += len(ring)
    return Polygon(points, tuple(indices))


@st.composite
def polygons(draw: st.DrawFn) -> Polygon:
    """Polygons on a small grid, with holes, collinear runs and vertical edges."""
    size = draw(st.integers(3, 9))
    n = draw(st.integers(3, min(12, size * size)))
    outer = untangled(draw(st.integers(0, 10**6)), n, size)
    rings = [outer]
    assume(is_polygon(rings))
    places = st.tuples(st.integers(0, 4 * size), st.integers(0, 4 * size))
    for corners in draw(
        st.lists(st.lists(places, min_size=3, max_size=4, unique=True), max_size=4)
    ):
        # On a finer grid, so that there is room; what does not fit is left out.
        hole = [hpoint(mpq(x, 4), mpq(y, 4)) for x, y in corners]
        if is_polygon([*rings, hole]):
            rings.append(hole)
    return oriented(rings)
