"""A long hunt for meshes that the three judges disagree on.

    python -m tests.oracle.campaign --seconds 600 --seed 7

Draws good, damaged and nearly degenerate meshes and garbage, of rationals, decimals and doubles,
with bounds that are often hit exactly; the filtered judge gets each in every form, with and without
telling triangles of the same shape.  Prints each disagreement as one line of JSON that reproduces
it, and at the end what was seen.  Exit code 0 if there was none.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections import Counter
from itertools import count
from random import Random
from typing import Any

from bern_exact.oracle import estimates
from bern_exact.oracle.filtered import Effort
from tests.oracle.agreement import all_forms
from tests.oracle.meshes import Case
from tests.oracle.test_judges_agree import random_bounds
from tests.oracle.variants import some_case


def bounds_that_are_hit(verdict: dict[str, Any], rng: Random) -> dict[str, Any]:
    """The mesh's own largest angle and least height as bounds."""
    bounds: dict[str, Any] = {}
    angle, height = verdict["max_angle"], verdict["min_height_squared"]
    if angle is not None and len(angle["cos_squared"]) < 900 and rng.random() < 0.8:
        bounds["max_angle"] = f"cos:{angle['cos_sign']}:{angle['cos_squared']}"
    if height is not None and rng.random() < 0.8:
        bounds["min_height_squared"] = height
    return bounds


def attempt(seed: int, seen: Counter[str], effort: Effort) -> None:
    """Judge one mesh, with chance bounds and with its own extremes for bounds."""
    rng = Random(f"judges {seed}")
    case = some_case(rng)
    estimates.FEW = rng.choice((1, 256))
    bounds = random_bounds(rng)
    verdict = told(seed, case, bounds, effort)
    if verdict is None:
        seen["no polygon"] += 1
        return
    seen["valid" if verdict["valid"] else "not valid"] += 1
    seen.update({defect["kind"] for defect in verdict["defects"]})
    told(seed, case, bounds_that_are_hit(verdict, rng), effort)


def told(seed: int, case: Case, bounds: dict[str, Any], effort: Effort) -> dict[str, Any] | None:
    """What all judges say; `Disagreement` if they do not say the same."""
    try:
        return all_forms(case, effort, **bounds)
    except Exception as error:  # whatever goes wrong is what is looked for
        raise Disagreement(
            json.dumps(
                {
                    "seed": seed,
                    "error": f"{type(error).__name__}: {error}"[:200],
                    "bounds": bounds,
                    "mesh": case.document(),
                }
            )
        ) from error


class Disagreement(Exception):
    """Judges say different things of a mesh, which is the message, as JSON."""


def run(seconds: float, seed: int, most: int | None = None) -> tuple[int, Counter[str], Effort]:
    """Draw and judge meshes until the time, or their number, is over: the disagreements."""
    seen, effort, failures = Counter[str](), Effort(), 0
    end, few = time.monotonic() + seconds, estimates.FEW
    try:
        for number in count(seed * 10**6):
            if time.monotonic() > end or seen["meshes"] == most:
                return failures, seen, effort
            seen["meshes"] += 1
            try:
                attempt(number, seen, effort)
            except Disagreement as found:
                failures += 1
                print(found, flush=True)
        return failures, seen, effort
    finally:
        estimates.FEW = few


def main() -> int:
    """Run a campaign from the command line."""
    parser = argparse.ArgumentParser(description="Hunt for meshes that judges disagree on.")
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--seed", type=int, default=7)
    options = parser.parse_args()
    failures, seen, effort = run(options.seconds, options.seed)
    print(f"meshes {seen.pop('meshes')}, disagreements {failures}")
    for name, times in sorted(seen.items()):
        print(f"{name:28} {times}")
    print(effort)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
