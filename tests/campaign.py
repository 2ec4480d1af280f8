"""A long hunt beside the suite: `python -m tests.campaign --seconds 600 --seed 7`.

Draws random polygons of every family, runs a theorem (`--theorem 2`; 1 if not told) with every
check, with options drawn by chance, and the lone judge; prints each failure as one line of JSON
that reproduces it, and at the end what was measured.  Exit code 0 if nothing failed.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import count
from random import Random
from typing import Any

from gmpy2 import mpq

from bern_exact.checkers.findings import Finding
from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.formats.mesh_json import mesh_document
from bern_exact.formats.polygon_json import dump_polygon
from bern_exact.oracle.judge import judge
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems.stages import Construction
from bern_exact.theorems.theorem_1 import theorem_1
from bern_exact.theorems.theorem_2 import theorem_2
from bern_exact.theorems.theorem_3 import theorem_3
from bern_exact.theorems.theorem_4 import bouncing, theorem_4
from tests.convex.polygons import convex_hull_of, some_convex
from tests.theorems.families import FAMILIES, some_polygon


class WronglyJudged(Exception):
    """The lone judge refuses a mesh."""


@dataclass
class Claim:
    """A claim over many polygons: how often it was put to the test, and its closest call."""

    polygons: int = 0
    cases: int = 0
    closeness: mpq = field(default_factory=lambda: mpq(-1))
    worst: Finding | None = None
    where: str = ""

    def add(self, found: Finding, where: str) -> None:
        """Count one finding."""
        self.polygons += 1
        self.cases += found.cases
        close = closeness(found)
        if close is not None and close > self.closeness:
            self.closeness, self.worst, self.where = close, found, where


def closeness(found: Finding) -> mpq | None:
    """0 far from the bound, 1 at it; None where there is nothing to compare.

    A bound of 0 is that of a number of violations.

    The smaller of the two magnitudes over the larger: a bound from above and one from below
    read alike.  A cotangent above its negative bound counts from the bound down.
    """
    if not isinstance(found.measured, int | str) or not isinstance(found.bound, int | str):
        return None
    measured, bound = mpq(found.measured), mpq(found.bound)
    if bound == 0:
        return None
    if bound < 0:
        return 1 / (1 + abs(measured - bound))
    low, high = sorted((abs(measured), abs(bound)))
    return low / high


@dataclass
class Summary:
    """What a campaign has seen."""

    polygons: Counter[str] = field(default_factory=Counter)
    failures: int = 0
    vertices: int = 0
    triangles: int = 0
    ranks: Counter[int] = field(default_factory=Counter)
    claims: dict[str, Claim] = field(default_factory=dict)

    def add(self, kind: str, made: Construction) -> None:
        """Count one polygon that passed."""
        self.vertices += made.polygon.n
        self.triangles += len(made.assembled.mesh.triangles)
        warped: Any = made.records.get("warped")
        if warped is not None:
            self.ranks.update(warped.rank)
        for found in made.findings:
            self.claims.setdefault(found.claim, Claim()).add(found, made.polygon.name)

    def lines(self) -> Iterator[str]:
        """The summary, for people."""
        yield f"polygons {self.polygons.total()}, failures {self.failures}"
        yield "by family: " + ", ".join(f"{k} {v}" for k, v in sorted(self.polygons.items()))
        yield f"vertices {self.vertices}, triangles {self.triangles}"
        yield "corners refused a vertex: " + ", ".join(
            f"{rank}: {times}" for rank, times in sorted(self.ranks.items())
        )
        for name, claim in self.claims.items():
            worst = claim.worst
            seen = f"{number(worst.measured)} against {number(worst.bound)}" if worst else "-"
            yield f"{name:34} {claim.cases:9} cases  closest {seen}  {claim.where}"


def number(value: Any) -> str:
    """An exact value for people: whole, or its first digits, cut off."""
    exact = mpq(value)
    if exact.denominator == 1:
        return str(exact)
    places = 4
    while abs(exact) * 10**places < 1000:
        places += 1
    digits = str(abs(exact) * 10**places // 1).zfill(places + 1)
    return f"{'-' if exact < 0 else ''}{digits[:-places]}.{digits[-places:]}"


Options = dict[str, str]
"""Options of a theorem, as they are written."""


def some_options(theorem: int, random: Random) -> Options:
    """Options drawn by chance, the default ones most often."""
    if theorem == 1:
        return {}
    if theorem == 4:
        return {"max_angle": "90", **random.choice(({}, {}, {"baseline": "yes"}))}
    angles = ("150", "150", "150", "149.9", "145", "140", "136", "135.2", "cos:-1:25/34")
    options = {
        "max_angle": random.choice(angles),
        "objective": random.choice(("fewest", "fewest", "height", "angle")),
    }
    if theorem == 3:
        options["interior"] = random.choice(("best", "strips", "bridges"))
    elif random.randrange(3) == 0:
        options["squares"] = "yes"
    return options


def construct(theorem: int, polygon: Polygon, options: Options) -> Construction:
    """A theorem's construction with every check."""
    if theorem == 4:
        return (bouncing if "baseline" in options else theorem_4)(polygon)
    given: dict[str, Any] = dict(options)
    if "factor" in given:
        given["factor"] = mpq(given["factor"])
    if theorem == 1:
        return theorem_1(polygon, **given)
    given["max_angle"] = parse_angle_bound(options["max_angle"])
    return theorem_2(polygon, **given) if theorem == 2 else theorem_3(polygon, **given)


def attempt(theorem: int, polygon: Polygon, options: Options) -> Construction:
    """A theorem with every check, and the lone judge's verdict on the result."""
    made = construct(theorem, polygon, options)
    mesh, outline = mesh_document(made.assembled.mesh), dump_polygon(polygon)
    verdict = judge(mesh, outline, max_angle=options.get("max_angle"))
    if not verdict["valid"]:
        raise WronglyJudged(json.dumps(verdict["defects"][:3]))
    return made


def without_holes(polygon: Polygon) -> Polygon:
    """The outer ring alone."""
    outer = polygon.rings[0]
    return Polygon(polygon.points[: len(outer)], (outer,), polygon.name)


def draw(kind: str, seed: int, theorem: int) -> Polygon:
    """A polygon of a family that the theorem is for."""
    if theorem == 4 and seed % 2:
        return some_convex(Random(f"{kind} {seed}"))
    polygon = some_polygon(kind, seed)
    if theorem == 4:
        return convex_hull_of(polygon)
    return without_holes(polygon) if theorem == 2 else polygon


def run(
    seconds: int, seed: int, kinds: list[str], theorem: int = 1, grid: Options | None = None
) -> Summary:
    """Draw and try polygons until the time is over; `grid` are options that all of them get."""
    summary = Summary()
    end = time.monotonic() + seconds
    for number_ in count(seed * 10**6):
        for kind in kinds:
            if time.monotonic() > end:
                return summary
            polygon = draw(kind, number_, theorem)
            options = {**some_options(theorem, Random(f"options {number_}")), **(grid or {})}
            summary.polygons[kind] += 1
            try:
                summary.add(kind, attempt(theorem, polygon, options))
            except Exception as error:  # whatever goes wrong is what is looked for
                summary.failures += 1
                found = failure(kind, number_, polygon, error)
                print(json.dumps({"theorem": theorem, **options, **found}), flush=True)
    return summary


def failure(kind: str, seed: int, polygon: Polygon, error: Exception) -> dict[str, Any]:
    """What went wrong, and with what."""
    return {
        "family": kind,
        "seed": seed,
        "error": type(error).__name__,
        "message": str(error),
        "polygon": dump_polygon(polygon),
    }


def main() -> int:
    """Run a campaign from the command line."""
    parser = argparse.ArgumentParser(description="Hunt for polygons that break a theorem.")
    parser.add_argument("--theorem", type=int, choices=(1, 2, 3, 4), default=1)
    parser.add_argument("--seconds", type=int, default=600)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--family", action="append", choices=FAMILIES, help="only this one")
    parser.add_argument("--blocks", choices=("square", "corner"), help="not for Theorem 4")
    parser.add_argument("--factor", help="s' in grid units, p/q; not for Theorem 4")
    options = parser.parse_args()
    kinds = options.family or list(FAMILIES)
    grid = {name: getattr(options, name) for name in ("blocks", "factor") if getattr(options, name)}
    summary = run(options.seconds, options.seed, kinds, options.theorem, grid)
    for line in summary.lines():
        print(line)
    return 1 if summary.failures else 0


if __name__ == "__main__":
    sys.exit(main())
