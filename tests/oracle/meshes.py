"""Meshes for the judges' tests: good ones, damaged ones and garbage, all from a seed."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from gmpy2 import mpq

from bern_exact.exact.points import HPoint, hpoint
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon

Point = tuple[Fraction, Fraction]


@dataclass
class Case:
    """A mesh and the rings of the polygon that it should triangulate."""

    vertices: list[Point]
    triangles: list[tuple[int, int, int]]
    rings: list[list[Point]] = field(default_factory=list)

    def copy(self) -> Case:
        return Case(list(self.vertices), list(self.triangles), [list(r) for r in self.rings])

    def mapped(self, f: Callable[[Point], Point], *, mirror: bool = False) -> Case:
        """The image under a map; a mirror turns the triangles over."""
        triangles = [(a, c, b) if mirror else (a, b, c) for a, b, c in self.triangles]
        return Case(
            [f(p) for p in self.vertices], triangles, [[f(p) for p in r] for r in self.rings]
        )

    def document(self) -> dict[str, Any]:
        """The mesh, and the polygon if there is one, as JSON."""
        mesh: dict[str, Any] = {
            "format": "bern-exact/mesh",
            "version": 1,
            "vertices": texts(self.vertices),
            "triangles": [list(corners) for corners in self.triangles],
        }
        if self.rings:
            outer, *holes = map(texts, self.rings)
            mesh["polygon"] = {"outer": outer, "holes": holes}
        return mesh

    def mesh(self) -> Mesh:
        return Mesh(tuple(map(homogeneous, self.vertices)), tuple(self.triangles))

    def polygon(self) -> Polygon | None:
        """The polygon, its rings turned with the interior on the left."""
        if not self.rings:
            return None
        points: list[HPoint] = []
        rings = []
        for r, ring in enumerate(self.rings):
            ids = list(range(len(points), len(points) + len(ring)))
            if (twice_area(ring) > 0) != (r == 0):
                ids = [ids[0], *reversed(ids[1:])]
            rings.append(tuple(ids))
            points += map(homogeneous, ring)
        return Polygon(tuple(points), tuple(rings))


def texts(points: list[Point]) -> list[list[str]]:
    return [[str(x), str(y)] for x, y in points]


def homogeneous(p: Point) -> HPoint:
    return hpoint(*(mpq(c.numerator, c.denominator) for c in p))


def twice_area(ring: list[Point]) -> Fraction:
    return sum(
        (ring[i - 1][0] * q[1] - ring[i - 1][1] * q[0] for i, q in enumerate(ring)), Fraction(0)
    )


def point(x: Any, y: Any) -> Point:
    return Fraction(x), Fraction(y)


def grid(columns: int, rows: int, rng: random.Random | None = None, *, hole: bool = False) -> Case:
    """Unit squares, each cut by a diagonal; with a hole the square (1, 1) is left out."""
    vertices = [point(x, y) for y in range(rows + 1) for x in range(columns + 1)]
    triangles = []
    for y in range(rows):
        for x in range(columns):
            a = y * (columns + 1) + x
            b, c, d = a + 1, a + columns + 2, a + columns + 1
            if hole and (x, y) == (1, 1):
                continue
            if rng is not None and rng.random() < 0.5:
                triangles += [(a, b, d), (b, c, d)]
            else:
                triangles += [(a, b, c), (a, c, d)]
    rings = [[point(0, 0), point(columns, 0), point(columns, rows), point(0, rows)]]
    if hole:
        rings.append([point(1, 1), point(2, 1), point(2, 2), point(1, 2)])
    return Case(vertices, triangles, rings)


def fan(n: int, rng: random.Random) -> Case:
    """A star-shaped polygon, all triangles at its centre."""
    ring: list[Point] = []
    for k in range(n):
        t = Fraction(2 * k + 1, n) - 1  # (1 - t^2, 2 t) / (1 + t^2): half a circle, then doubled
        x, y = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
        radius = Fraction(rng.randint(5, 20), 10)
        ring.append(((x * x - y * y) * radius, 2 * x * y * radius))
    return Case([*ring, point(0, 0)], [(k, (k + 1) % n, n) for k in range(n)], [ring])


def annulus(n: int, rng: random.Random) -> Case:
    """Between a star-shaped polygon and a smaller copy of itself."""
    outer = fan(n, rng).rings[0]
    inner = [(x / 3, y / 3) for x, y in outer]
    triangles = []
    for k in range(n):
        j = (k + 1) % n
        triangles += [(k, j, n + k), (j, n + j, n + k)]
    return Case([*outer, *inner], triangles, [outer, inner])


def refine(case: Case, rng: random.Random) -> None:
    """Put a new vertex into a triangle or on an edge."""
    t = rng.randrange(len(case.triangles))
    a, b, c = case.triangles[t]
    new = len(case.vertices)
    p, q, r = (case.vertices[v] for v in (a, b, c))
    u, v = Fraction(rng.randint(1, 4), 9), Fraction(rng.randint(1, 4), 9)
    if rng.random() < 0.5:
        w = 1 - u - v
        case.vertices.append((u * p[0] + v * q[0] + w * r[0], u * p[1] + v * q[1] + w * r[1]))
        case.triangles[t : t + 1] = [(a, b, new), (b, c, new), (c, a, new)]
        return
    case.vertices.append((p[0] + u * (q[0] - p[0]), p[1] + u * (q[1] - p[1])))
    triangles = []
    for corners in case.triangles:
        for i in range(3):
            v0, v1, v2 = corners[i], corners[i - 2], corners[i - 1]
            if {v0, v1} == {a, b}:
                triangles += [(v0, new, v2), (new, v1, v2)]
                break
        else:
            triangles.append(corners)
    case.triangles = triangles


def good(rng: random.Random) -> Case:
    """A random triangulation of a random polygon, perhaps with a hole."""
    case = rng.choice(
        [
            lambda: grid(rng.randint(1, 4), rng.randint(1, 4), rng),
            lambda: grid(3, 3, rng, hole=True),
            lambda: fan(rng.randint(3, 8), rng),
            lambda: annulus(rng.randint(3, 7), rng),
        ]
    )()
    for _ in range(rng.randint(0, 6)):
        refine(case, rng)
    m = [Fraction(rng.randint(-4, 4), rng.randint(1, 3)) for _ in range(4)]
    determinant = m[0] * m[3] - m[1] * m[2]
    if determinant:
        case = case.mapped(
            lambda p: (m[0] * p[0] + m[1] * p[1] + 5, m[2] * p[0] + m[3] * p[1]),
            mirror=determinant < 0,
        )
    case.rings = [r[::-1] if rng.random() < 0.5 else r for r in case.rings]
    return case


def damage(case: Case, rng: random.Random) -> None:
    """Spoil the mesh in one of many ways; now and then it stays valid."""
    t = rng.randrange(len(case.triangles)) if case.triangles else -1
    v = rng.randrange(len(case.vertices))
    x, y = case.vertices[v]
    choice = rng.randrange(12)
    if choice == 0 and t >= 0:
        del case.triangles[t]
    elif choice == 1 and t >= 0:
        a, b, c = case.triangles[t]
        case.triangles[t] = (b, a, c)
    elif choice == 2 and t >= 0:
        case.triangles.append(case.triangles[t])
    elif choice == 3:
        step = rng.choice([Fraction(1, 10**9), Fraction(1, 5), Fraction(2), Fraction(-1, 3)])
        case.vertices[v] = (x + step, y + step / 7)
    elif choice == 4:
        case.vertices[v] = rng.choice(case.vertices)
    elif choice == 5:
        case.vertices.append(rng.choice([(x, y), (x + 1, y)]))
    elif choice == 6 and t >= 0:
        corners = list(case.triangles[t])
        corners[rng.randrange(3)] = rng.choice([-1, len(case.vertices), 10**30, v])
        case.triangles[t] = (corners[0], corners[1], corners[2])
    elif choice == 7:
        w, u = rng.randrange(len(case.vertices)), rng.randrange(len(case.vertices))
        case.triangles.append((v, w, u))
    elif choice == 8 and t >= 0:  # split a triangle at an edge, but not its neighbour
        a, b, c = case.triangles[t]
        if not all(-1 <= v < len(case.vertices) for v in (a, b, c)):
            return
        p, q = case.vertices[a], case.vertices[b]
        case.vertices.append(((p[0] + q[0]) / 2, (p[1] + q[1]) / 2))
        new = len(case.vertices) - 1
        case.triangles[t : t + 1] = [(a, new, c), (new, b, c)]
    elif choice == 9 and case.rings:
        ring = rng.choice(case.rings)
        i = rng.randrange(len(ring))
        (px, py), (qx, qy) = ring[i - 1], ring[i]
        ring.insert(i, ((px + qx) / 2, (py + qy) / 2))
    elif choice == 10 and len(case.rings) > 1:
        case.rings.pop()
    elif choice == 11:
        n = len(case.vertices)
        case.vertices += [(x + 9, y), (x + 10, y), (x + 9, y + 1)]
        case.triangles.append((n, n + 1, n + 2))


def garbage(rng: random.Random) -> Case:
    """Random triangles on a few lattice points, with a square for a polygon or without."""
    n, m = rng.randint(0, 9), rng.randint(0, 9)
    vertices = [point(rng.randint(0, 3), rng.randint(0, 3)) for _ in range(n)]
    triangles = [
        (rng.randint(-1, n), rng.randint(0, n), rng.randint(0, max(n - 1, 0))) for _ in range(m)
    ]
    square = [point(0, 0), point(3, 0), point(3, 3), point(0, 3)]
    return Case(vertices, triangles, [square] if rng.random() < 0.5 else [])
