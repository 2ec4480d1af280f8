"""Meshes that are hard on filters: of doubles, huge, tiny, far away, nearly degenerate."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from fractions import Fraction

from tests.oracle.meshes import Case, Point, damage, garbage, good, grid, point


def as_doubles(case: Case) -> Case:
    """Every coordinate rounded to a double: what is collinear no longer is."""
    return case.mapped(lambda p: (rounded(p[0]), rounded(p[1])))


def rounded(x: Fraction) -> Fraction:
    """The double nearest to a number of the size of doubles."""
    return Fraction(float(x))


def as_decimals(case: Case, places: int) -> Case:
    """Every coordinate rounded to so many decimal places."""
    unit = 10**places
    return case.mapped(
        lambda p: (Fraction(round(p[0] * unit), unit), Fraction(round(p[1] * unit), unit))
    )


def scaled(case: Case, factor: Fraction) -> Case:
    """Larger, or smaller."""
    return case.mapped(lambda p: (p[0] * factor, p[1] * factor))


def nudged(case: Case, rng: random.Random) -> Case:
    """Some coordinates moved by an ulp, or by far less: the polygon stays."""
    result = case.copy()
    for v in range(len(result.vertices)):
        if rng.random() < 0.4:
            step = rng.choice((1, -1)) * rng.choice((Fraction(1), Fraction(1, 10**40)))
            x, y = result.vertices[v]
            x += step * Fraction(math.ulp(float(x)))
            result.vertices[v] = (x, y)
    return result


def flattened(case: Case, rng: random.Random) -> Case:
    """A vertex of some triangles moved next to the opposite edge, by an ulp or so."""
    result = case.copy()
    for t in rng.sample(range(len(case.triangles)), min(3, len(case.triangles))):
        a, b, c = case.triangles[t]
        if not all(0 <= v < len(result.vertices) for v in (a, b, c)):
            continue
        p, q = result.vertices[a], result.vertices[b]
        k = Fraction(rng.randint(1, 8), 9)
        x, y = p[0] + k * (q[0] - p[0]), p[1] + k * (q[1] - p[1])
        result.vertices[c] = (rounded(x), rounded(y)) if rng.random() < 0.7 else (x, y)
    return result


def rotated_grid(rng: random.Random) -> Case:
    """A grid of right angles, none of them parallel to an axis; its steps may be alike."""
    m, n = rng.choice([(3, 4), (1, 1), (5, 12), (1, 3)])
    alike = rng.random() < 0.5
    xs, ys = ([0] for _ in range(2))
    for steps in (xs, ys):
        for _ in range(rng.randint(1, 5)):
            steps.append(steps[-1] + (1 if alike else rng.randint(1, 10**6)))
    case = grid(len(xs) - 1, len(ys) - 1, rng)

    def turned(p: Point) -> Point:
        x, y = xs[int(p[0])], ys[int(p[1])]
        return point(m * x - n * y, n * x + m * y)

    return case.mapped(turned)


def equilateral_grid(rng: random.Random) -> Case:
    """Triangles of 60 degrees as nearly as doubles go."""
    case = grid(rng.randint(1, 5), rng.randint(1, 5))
    root = Fraction(math.sqrt(3)) / 2
    case = case.mapped(lambda p: (p[0] - p[1] / 2, p[1] * root))
    return as_doubles(case) if rng.random() < 0.5 else case


FACTORS = [Fraction(10) ** k for k in (-320, -200, -32, -9, 9, 29, 31, 200, 307, 400)]

SOURCES: list[Callable[[random.Random], Case]] = [good, good, garbage, rotated_grid]
SOURCES += [equilateral_grid]


def some_case(rng: random.Random) -> Case:
    """Any of them, perhaps damaged, perhaps without its polygon."""
    case = rng.choice(SOURCES)(rng)
    for _ in range(rng.choice((0, 0, 0, 1, 2)) if case.vertices else 0):
        damage(case, rng)
    if rng.random() < 0.15:
        case = case.mapped(lambda p: (p[0] + 10**9, p[1] - 10**7))
    choice = rng.randrange(8)
    if choice <= 1:
        case = as_doubles(case)
    elif choice == 2:
        case = as_decimals(case, rng.choice((1, 3, 20)))
    elif choice == 3:
        case = scaled(case, rng.choice(FACTORS))
    elif choice == 4:
        case = nudged(as_doubles(case), rng)
    elif choice == 5:
        case = flattened(case, rng)
    elif choice == 6:
        case = as_doubles(flattened(as_doubles(case), rng))
    if rng.random() < 0.3:
        case.rings = []
    return case
