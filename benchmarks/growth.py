"""How time, memory and triangles of Theorem 1 grow with n.

    python -m benchmarks.growth                 # the table on stdout, as Markdown
    python -m benchmarks.growth --to 3000       # the small sizes only
    python -m benchmarks.growth --write         # and put it into benchmarks/RESULTS.md

Each measurement is a process of its own: construction without checks, then with
every claim checked, then the peak memory of both.  Seconds are processor time.
Exponents are least-squares slopes in log-log scale over all sizes.
"""

from __future__ import annotations

import argparse
import json
import math
import resource
import subprocess
import sys
import time
from collections.abc import Iterable, Sequence
from pathlib import Path

from benchmarks.results import machine, write_section
from bern_exact.corpus import shapes
from bern_exact.exact.points import grid_point
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems.theorem_1 import theorem_1

FAMILIES = ("star", "maze", "spiral", "plate")
SIZES = (100, 300, 1000, 3000, 10000, 30000)
HEADER = """| family | n | bare s | with checks s | ratio | peak MiB | triangles | a vertex |
| --- | --: | --: | --: | --: | --: | --: | --: |"""


def measure(family: str, size: int) -> dict[str, float | str]:
    """One polygon through Theorem 1, without and with checks, in this process."""
    rings = getattr(shapes, family)(size, seed=1)
    polygon = polygon_from_rings([[grid_point(x, y) for x, y in ring] for ring in rings])
    started = time.process_time()
    plain = theorem_1(polygon, check="none")
    built = time.process_time()
    count = len(plain.assembled.mesh.triangles)
    del plain
    checking = time.process_time()
    theorem_1(polygon, check="every-stage")
    checked = time.process_time()
    return {
        "family": family,
        "n": polygon.n,
        "plain": built - started,
        "checked": checked - checking,
        "mib": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
        "triangles": count,
    }


def measure_apart(family: str, size: int) -> dict[str, float]:
    """The same in a process of its own, so that peak memory is its own."""
    command = [sys.executable, "-m", "benchmarks.growth", "--one", family, str(size)]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    record: dict[str, float] = json.loads(done.stdout)
    print(record, file=sys.stderr, flush=True)
    return record


def exponent(sizes: Sequence[float], values: Sequence[float]) -> float:
    """The least-squares slope of log value over log size; not a number for a single size."""
    xs, ys = [math.log(n) for n in sizes], [math.log(v) for v in values]
    mx, my = sum(xs) / len(xs), sum(ys) / len(ys)
    over = sum((x - mx) * (y - my) for x, y in zip(xs, ys, strict=True))
    spread = sum((x - mx) ** 2 for x in xs)
    return over / spread if spread else math.nan


def report(families: Iterable[str], sizes: Sequence[int]) -> str:
    """The table and the exponents, as Markdown."""
    lines, fits = [HEADER], []
    for family in families:
        records = [measure_apart(family, size) for size in sizes]
        for r in records:
            lines.append(
                f"| {family} | {r['n']} | {r['plain']:.1f} | {r['checked']:.1f} "
                f"| {r['checked'] / r['plain']:.2f} | {r['mib']:.0f} | {r['triangles']} "
                f"| {r['triangles'] / r['n']:.1f} |"
            )
        n = [r["n"] for r in records]
        slopes = {
            key: exponent(n, [r[key] for r in records])
            for key in ("plain", "checked", "mib", "triangles")
        }
        fits.append(
            f"| {family} | {slopes['plain']:.2f} | {slopes['checked']:.2f} "
            f"| {slopes['mib']:.2f} | {slopes['triangles']:.2f} |"
        )
    exponents = "| family | construction | with checks | memory | triangles |\n"
    exponents += "| --- | --: | --: | --: | --: |\n" + "\n".join(fits)
    return "\n".join(lines) + "\n\nFitted exponents:\n\n" + exponents


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--one", nargs=2, metavar=("FAMILY", "N"), help=argparse.SUPPRESS)
    parser.add_argument("--to", type=int, default=SIZES[-1], help="the largest n")
    parser.add_argument("--family", action="append", choices=FAMILIES)
    parser.add_argument("--write", action="store_true", help="into benchmarks/RESULTS.md")
    options = parser.parse_args()
    if options.one:
        print(json.dumps(measure(options.one[0], int(options.one[1]))))
        return
    table = report(options.family or FAMILIES, [n for n in SIZES if n <= options.to])
    text = f"{machine()}\n\n{table}\n"
    print(text)
    if options.write:
        write_section(Path(__file__).with_name("RESULTS.md"), "Theorem 1: growth", text)


if __name__ == "__main__":
    main()
