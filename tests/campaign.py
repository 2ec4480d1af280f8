"""A long hunt beside the suite: `python -m tests.campaign --seconds 600 --seed 7`.

Draws random polygons of every family, runs Theorem 1 with every check and the lone judge,
prints each failure as one line of JSON that reproduces it, and at the end what was measured.
Exit code 0 if nothing failed.
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
from typing import Any

from gmpy2 import mpq

from bern_exact.checkers.findings import Finding
from bern_exact.formats.mesh_json import mesh_document
from bern_exact.formats.polygon_json import dump_polygon
from bern_exact.oracle.judge import judge
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems.stages import Construction
from bern_exact.theorems.theorem_1 import theorem_1
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

    The smaller of the two magnitudes over the larger: a bound from above and one from below
    read alike.  A cotangent above its negative bound counts from the bound down.
    """
    if not isinstance(found.measured, int | str) or not isinstance(found.bound, int | str):
        return None
    measured, bound = mpq(found.measured), mpq(found.bound)
    if measured == bound:
        return mpq(1)
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
        warped: Any = made.records["warped"]
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


def attempt(polygon: Polygon) -> Construction:
    """Theorem 1 with every check, and the lone judge's verdict on the result."""
    made = theorem_1(polygon)
    verdict = judge(mesh_document(made.assembled.mesh), dump_polygon(polygon))
    if not verdict["valid"]:
        raise WronglyJudged(json.dumps(verdict["defects"][:3]))
    return made


def run(seconds: int, seed: int, kinds: list[str]) -> Summary:
    """Draw and try polygons until the time is over."""
    summary = Summary()
    end = time.monotonic() + seconds
    for number_ in count(seed * 10**6):
        for kind in kinds:
            if time.monotonic() > end:
                return summary
            polygon = some_polygon(kind, number_)
            summary.polygons[kind] += 1
            try:
                summary.add(kind, attempt(polygon))
            except Exception as error:  # whatever goes wrong is what is looked for
                summary.failures += 1
                print(json.dumps(failure(kind, number_, polygon, error)), flush=True)
    return summary


def failure(kind: str, seed: int, polygon: Polygon, error: Exception) -> dict[str, Any]:
    """All that is needed to see a failure again."""
    return {
        "family": kind,
        "seed": seed,
        "error": type(error).__name__,
        "message": str(error),
        "polygon": dump_polygon(polygon),
    }


def main() -> int:
    """Run a campaign from the command line."""
    parser = argparse.ArgumentParser(description="Hunt for polygons that break Theorem 1.")
    parser.add_argument("--seconds", type=int, default=600)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--family", action="append", choices=FAMILIES, help="only this one")
    options = parser.parse_args()
    summary = run(options.seconds, options.seed, options.family or list(FAMILIES))
    for line in summary.lines():
        print(line)
    return 1 if summary.failures else 0


if __name__ == "__main__":
    sys.exit(main())
