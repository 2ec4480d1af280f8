"""Families of polygons with integer coordinates, made by integer arithmetic alone.

Each function is determined by its arguments, on any machine.
"""

from __future__ import annotations

from collections.abc import Iterator
from random import Random

from gmpy2 import isqrt

Point = tuple[int, int]
Ring = list[Point]

SIZE = 10**9
"""The radius of round shapes, in units of the last digit."""

STEPS = ((1, 0), (0, 1), (-1, 0), (0, -1))
"""East, north, west, south."""


def on_circle(i: int, n: int, radius: int) -> Point:
    """The i-th of n points about evenly spread round a circle, rounded to integers.

    Each quarter is parametrised by ((1 - t^2)/(1 + t^2), 2 t/(1 + t^2)), t = 0 ... 1.

    >>> on_circle(0, 4, 10), on_circle(1, 4, 10), on_circle(1, 8, 10)
    ((10, 0), (0, 10), (6, 8))
    """
    quarter, along = divmod(4 * i, n)
    x = radius * (n * n - along * along) // (n * n + along * along)
    y = radius * 2 * n * along // (n * n + along * along)
    for _ in range(quarter):
        x, y = -y, x
    return x, y


def star(n: int, seed: int = 0) -> list[Ring]:
    """A star-shaped polygon: n random radii between 0.2 and 1.

    Meant to break meshers whose size grows with the aspect ratio: long thin spikes side by side.
    """
    random = Random(seed)
    ring = []
    for i in range(n):
        x, y = on_circle(i, n, SIZE)
        radius = random.randrange(200, 1001)
        ring.append((x * radius // 1000, y * radius // 1000))
    return [ring]


def maze(n: int, seed: int = 0) -> list[Ring]:
    """A random simple polygon of about n vertices: the walls of a random tree of corridors.

    Its vertices are shaken, so that no two edges are parallel by construction.
    Meant to break whatever expects a polygon to be round: the inside winds everywhere.
    """
    side = max(2, int(isqrt(2 * n // 3)))  # about 1.5 corners a room
    cells = _random_tree(side, Random(seed))
    random = Random(seed + 1)
    corners = _outline(cells)
    return [
        [(16 * x + random.randrange(-4, 5), 16 * y + random.randrange(-4, 5)) for x, y in corners]
    ]


def _random_tree(side: int, random: Random) -> set[Point]:
    """The cells of a random spanning tree of side x side rooms; rooms have even coordinates."""
    cells = {(0, 0)}
    stack = [(0, 0)]
    while stack:
        # Depth first with random restarts: both long corridors and many dead ends.
        at = len(stack) - 1 if random.randrange(8) else random.randrange(len(stack))
        x, y = stack[at]
        ways = [
            (dx, dy)
            for dx, dy in STEPS
            if 0 <= x + 2 * dx < 2 * side
            and 0 <= y + 2 * dy < 2 * side
            and (x + 2 * dx, y + 2 * dy) not in cells
        ]
        if not ways:
            stack[at] = stack[-1]
            stack.pop()
            continue
        dx, dy = ways[random.randrange(len(ways))]
        cells |= {(x + dx, y + dy), (x + 2 * dx, y + 2 * dy)}
        stack.append((x + 2 * dx, y + 2 * dy))
    return cells


def _outline(cells: set[Point]) -> Ring:
    """The corners of the outline of a simply connected set of unit cells, counter-clockwise."""
    x, y = min(cells)
    start = (x, y)
    corners: Ring = []
    heading = 0
    while not corners or (x, y) != start:
        dx, dy = STEPS[heading]
        x, y = x + dx, y + dy
        # The cells ahead on the left and on the right of the wall just walked along.
        left, right = (
            _cell_ahead(x, y, heading, 0) in cells,
            _cell_ahead(x, y, heading, 1) in cells,
        )
        if right:
            heading = (heading + 3) % 4
        elif not left:
            heading = (heading + 1) % 4
        else:
            continue
        corners.append((x, y))
    return corners


def _cell_ahead(x: int, y: int, heading: int, right: int) -> Point:
    """The lower left corner of the cell ahead of a grid point, left or right of the heading."""
    offsets = (((0, 0), (0, -1)), ((-1, 0), (0, 0)), ((-1, -1), (-1, 0)), ((0, -1), (-1, -1)))
    i, j = offsets[heading][right]
    return x + i, y + j


def spiral(n: int, seed: int = 0) -> list[Ring]:
    """A corridor of about n vertices wound up in a square spiral, its vertices shaken.

    Meant to break whatever takes the plane's nearness for nearness inside the polygon.
    """
    random = Random(seed)
    middle = list(spiral_path(max(2, n // 2 - 1)))
    outer, inner = [], []
    for i, (x, y) in enumerate(middle):
        ax, ay = STEPS[(i - 1) % 4] if i else STEPS[0]
        bx, by = STEPS[i % 4] if i + 1 < len(middle) else (ax, ay)
        # The normals of the two sides that meet here, added where they differ.
        nx, ny = (-ay, ax) if (ax, ay) == (bx, by) else (-ay - by, ax + bx)
        outer.append((16 * x - 4 * nx + random.randrange(3), 16 * y - 4 * ny + random.randrange(3)))
        inner.append((16 * x + 4 * nx + random.randrange(3), 16 * y + 4 * ny + random.randrange(3)))
    return [outer + inner[::-1]]


def spiral_path(turns: int) -> Iterator[Point]:
    """The middle line of a square spiral."""
    x = y = 0
    yield x, y
    for i in range(turns):
        dx, dy = STEPS[i % 4]
        length = i // 2 + 1
        x, y = x + dx * length, y + dy * length
        yield x, y


def plate(n: int, seed: int = 0) -> list[Ring]:
    """A square with about n/4 square holes, each turned and shifted at random.

    Meant to break whatever is quadratic in the number of holes.
    """
    random = Random(seed)
    side = max(1, int(isqrt(n // 4)))
    pitch = 100
    rings = [[(0, 0), (side * pitch, 0), (side * pitch, side * pitch), (0, side * pitch)]]
    for i in range(side):
        for j in range(side):
            cx = i * pitch + 50 + random.randrange(-10, 11)
            cy = j * pitch + 50 + random.randrange(-10, 11)
            u, v = random.randrange(8, 25), random.randrange(-12, 13)
            rings.append([(cx + u, cy + v), (cx - v, cy + u), (cx - u, cy - v), (cx + v, cy - u)])
    return rings
