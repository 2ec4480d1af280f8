"""How time, memory and triangles of Theorems 2 and 3 grow with n, and that they do not with A.

    python -m benchmarks.no_large_angle                 # the tables on stdout, as Markdown
    python -m benchmarks.no_large_angle --to 1000       # the small sizes only
    python -m benchmarks.no_large_angle --write         # and put them into benchmarks/RESULTS.md

Each measurement is a process of its own, without checks or with every claim checked.  Seconds are
processor time.  Exponents are least-squares slopes in log-log scale over the sizes of a
family; n log n has slope 1 + 1/log n, about 1.15 over these sizes.  The family `holes` is the
paper's lower bound for Theorem 3, n^1.5.  `--jobs` measures several at once.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from benchmarks.growth import exponent
from benchmarks.results import machine, write_section
from bern_exact.corpus import shapes, slits
from bern_exact.corpus.paper import hole_grid
from bern_exact.corpus.shapes import Ring
from bern_exact.exact.points import grid_point
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems.stages import Check
from bern_exact.theorems.theorem_2 import theorem_2
from bern_exact.theorems.theorem_3 import theorem_3

SIZES = (100, 300, 1000, 3000, 10000)
LARGEST = {"star": 10000, "maze": 3000, "spiral": 3000, "plate": 3000, "holes": 1000}
"""The families, and up to which n they are measured: all in about ten minutes on two cores."""

CHECKS: tuple[Check, ...] = ("none", "every-stage")
ASPECTS = tuple(10**k for k in range(1, 10))
KEYS = ("seconds", "checked", "mib", "checked mib", "triangles")

HEADER = """| family | theorem | n | s | with checks | MiB | with checks | triangles | a vertex |
| --- | --: | --: | --: | --: | --: | --: | --: | --: |"""

Record = dict[str, float]


def polygon_of(family: str, size: int) -> Polygon:
    """A member of a family: of about `size` vertices, or of aspect ratio `size`."""
    rings: Sequence[Ring]
    if family in ("bar", "slit"):
        rings = getattr(slits, family)(size)
    elif family == "holes":
        rings = hole_grid(round((size / 4) ** 0.5))
    else:
        rings = getattr(shapes, family)(size, seed=1)
    return polygon_from_rings([[grid_point(x, y) for x, y in ring] for ring in rings])


def measure(family: str, size: int, check: Check) -> Record:
    """One polygon through Theorem 2, or 3 if it has holes, in this process."""
    polygon = polygon_of(family, size)
    construct = theorem_3 if polygon.holes else theorem_2
    started = time.process_time()
    made = construct(polygon, check=check)
    ended = time.process_time()
    return {
        "n": polygon.n,
        "theorem": 3 if polygon.holes else 2,
        "seconds": ended - started,
        "mib": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
        "triangles": len(made.assembled.mesh.triangles),
    }


def measure_apart(family: str, size: int, check: Check) -> Record:
    """The same in a process of its own, so that peak memory is its own."""
    command = [sys.executable, "-m", "benchmarks.no_large_angle", "--one", family, str(size), check]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    record: Record = json.loads(done.stdout)
    print(family, check, record, file=sys.stderr, flush=True)
    return record


def measure_both(family: str, size: int) -> Record:
    """Without checks and with all, as one record."""
    bare, checked = (measure_apart(family, size, check) for check in CHECKS)
    return {**bare, "checked": checked["seconds"], "checked mib": checked["mib"]}


def growth(families: Sequence[str], largest: int, jobs: int) -> str:
    """Growth over n, and the fitted exponents."""
    cases = [(f, n) for f in families for n in SIZES if n <= min(largest, LARGEST[f])]
    with ThreadPoolExecutor(jobs) as pool:
        found = dict(zip(cases, pool.map(lambda case: measure_both(*case), cases), strict=True))
    lines, fits = [HEADER], []
    for family in families:
        records = [record for (name, _), record in found.items() if name == family]
        for r in records:
            lines.append(
                f"| {family} | {r['theorem']} | {r['n']} | {r['seconds']:.1f} | {r['checked']:.1f} "
                f"| {r['mib']:.0f} | {r['checked mib']:.0f} | {r['triangles']} "
                f"| {r['triangles'] / r['n']:.1f} |"
            )
        n = [r["n"] for r in records]
        slopes = (f"{exponent(n, [r[key] for r in records]):.2f}" for key in KEYS)
        fits.append(f"| {family} | {' | '.join(slopes)} |")
    exponents = "| family | s | with checks | MiB | with checks | triangles |\n"
    exponents += "| --- | --: | --: | --: | --: | --: |\n" + "\n".join(fits)
    return "\n".join(lines) + "\n\nFitted exponents:\n\n" + exponents


def aspect_ratios() -> str:
    """Triangles for a bar of 1 x A and a slit of width 1/A between two holes."""
    lines = ["| A | bar (n = 4) | slit (n = 12) |", "| --: | --: | --: |"]
    for aspect in ASPECTS:
        counts = [measure(family, aspect, "none")["triangles"] for family in ("bar", "slit")]
        lines.append(f"| 10^{len(str(aspect)) - 1} | {counts[0]} | {counts[1]} |")
    return "\n".join(lines)


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--one", nargs=3, metavar=("FAMILY", "N", "CHECK"), help=argparse.SUPPRESS)
    parser.add_argument("--to", type=int, default=SIZES[-1], help="the largest n")
    parser.add_argument("--jobs", type=int, default=1, help="processes at a time")
    parser.add_argument("--family", action="append", choices=LARGEST)
    parser.add_argument("--write", action="store_true", help="into benchmarks/RESULTS.md")
    options = parser.parse_args()
    if options.one:
        family, size, check = options.one
        print(json.dumps(measure(family, int(size), check)))
        return
    table = growth(options.family or list(LARGEST), options.to, options.jobs)
    text = f"{machine()}\n\n{table}\n\nTriangles whatever the aspect ratio:\n\n{aspect_ratios()}\n"
    print(text)
    if options.write:
        write_section(Path(__file__).with_name("RESULTS.md"), "Theorems 2 and 3: growth", text)


if __name__ == "__main__":
    main()
