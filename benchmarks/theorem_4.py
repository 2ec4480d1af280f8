"""Theorem 4 against the O(n^2) algorithm that it improves on: triangles and time.

    python -m benchmarks.theorem_4                  # the tables on stdout, as Markdown
    python -m benchmarks.theorem_4 --to 160         # the small sizes only
    python -m benchmarks.theorem_4 --write          # and put them into benchmarks/RESULTS.md
    python -m benchmarks.theorem_4 --plot t4.png    # and draw them, if matplotlib is there

Each measurement is a process of its own; seconds are processor time.  The baseline splits every
cell of the same grid: its triangles are always counted from the grid (two a cell, and those of
Lemma 9 along the boundary), and up to `BUILT` triangles it is built as well, to be timed.  Checks
are every claim after its stage and the judge; beyond `CHECKED` vertices the recursion runs alone.
It ends with exit code 1 if the recursion ever uses more triangles than the baseline, or more than
`WANTED` of it for random hulls of `AT` vertices.
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
from bern_exact import triangulate
from bern_exact.convex.records import Bounced, Gridded
from bern_exact.corpus.convex import FAMILIES
from bern_exact.exact.points import hpoint
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings

SIZES = (5, 10, 20, 40, 80, 160, 320, 640, 1280)
MEASURED = ("random-hull", "regular", "parabola", "ellipse", "tiny-edges", "clustered-spiral")
BUILT = 4_000_000
CHECKED = 640
WANTED, AT = 0.12, 640

MODES = ("recursion", "checked", "baseline")
HEADER = """| family | n | verticals | bits | O(n^2) | Theorem 4 | ratio | s | checks s | O(n^2) s |
| --- | --: | --: | --: | --: | --: | --: | --: | --: | --: |"""

Record = dict[str, float]


def polygon_of(family: str, size: int) -> Polygon:
    """A member of a family, of about `size` vertices."""
    rings = FAMILIES[family](size, 1)
    return polygon_from_rings([[hpoint(x, y) for x, y in ring] for ring in rings])


def measure(family: str, size: int, mode: str) -> Record:
    """One polygon through Theorem 4, or the baseline, in this process."""
    polygon = polygon_of(family, size)
    started = time.process_time()
    made = triangulate(
        polygon,
        theorem=4,
        baseline=mode == "baseline",
        check="every-stage" if mode == "checked" else "none",
    )
    ended = time.process_time()
    bounced, gridded = made.stages["bounced"], made.stages["gridded"]
    if not isinstance(bounced, Bounced) or not isinstance(gridded, Gridded):
        raise TypeError("these stages are not those of Theorem 4")
    return {
        "n": polygon.n,
        "verticals": len(bounced.verticals),
        "bits": bounced.bits,
        "baseline": counted(gridded),
        "triangles": len(made.mesh.triangles),
        "seconds": ended - started,
        "mib": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
    }


def counted(gridded: Gridded) -> int:
    """The triangles of the O(n^2) algorithm: two a cell, and those along the boundary."""
    return 2 * gridded.cells.number + sum(len(leg.triangles) for leg in gridded.legs)


def measure_apart(family: str, size: int, mode: str) -> Record:
    """The same in a process of its own."""
    command = [sys.executable, "-m", "benchmarks.theorem_4", "--one", family, str(size), mode]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    record: Record = json.loads(done.stdout)
    print(family, mode, record, file=sys.stderr, flush=True)
    return record


def measure_size(case: tuple[str, int]) -> dict[str, Record]:
    """One polygon, each way that is not too large for it."""
    family, size = case
    records = {"recursion": measure_apart(family, size, "recursion")}
    if size <= CHECKED:
        records["checked"] = measure_apart(family, size, "checked")
    if records["recursion"]["baseline"] <= BUILT:
        records["baseline"] = measure_apart(family, size, "baseline")
    return records


Found = dict[str, list[tuple[int, dict[str, Record]]]]
"""Family -> for each size its records by mode."""


def measured(families: Sequence[str], largest: int, jobs: int) -> Found:
    """All measurements."""
    cases = [(family, size) for family in families for size in SIZES if size <= largest]
    with ThreadPoolExecutor(jobs) as pool:
        records = dict(zip(cases, pool.map(measure_size, cases), strict=True))
    found: Found = {family: [] for family in families}
    for (family, size), modes in records.items():
        found[family].append((size, modes))
    return found


def table(found: Found) -> str:
    """Triangles and time, and the fitted exponents."""
    lines, fits = [HEADER], []
    for family, rows in found.items():
        for _, modes in rows:
            r = modes["recursion"]
            times = (f"{modes[m]['seconds']:.1f}" if m in modes else "" for m in MODES)
            lines.append(
                f"| {family} | {r['n']} | {r['verticals']} | {r['bits']} | {r['baseline']} "
                f"| {r['triangles']} | {r['triangles'] / r['baseline']:.3f} "
                f"| {' | '.join(times)} |"
            )
        fits.append(f"| {family} | {' | '.join(slopes(rows))} |")
    exponents = "| family | O(n^2) | Theorem 4 | verticals | s |\n"
    exponents += "| --- | --: | --: | --: | --: |\n" + "\n".join(fits)
    return "\n".join(lines) + "\n\nFitted exponents, from n = 40 on:\n\n" + exponents


def slopes(rows: Sequence[tuple[int, dict[str, Record]]]) -> list[str]:
    """Exponents in n; small polygons are left out."""
    records = [modes["recursion"] for size, modes in rows if size >= 40]
    if len(records) < 2:
        return [""] * 4
    n = [r["n"] for r in records]
    keys = ("baseline", "triangles", "verticals", "seconds")
    return [f"{exponent(n, [r[key] for r in records]):.2f}" for key in keys]


def failures(found: Found) -> list[str]:
    """Where the recursion does not keep what it should."""
    broken = []
    for family, rows in found.items():
        for size, modes in rows:
            r = modes["recursion"]
            if r["triangles"] > r["baseline"]:
                broken.append(
                    f"{family} {size}: {r['triangles']} triangles, {r['baseline']} before"
                )
            if "baseline" in modes and modes["baseline"]["triangles"] != r["baseline"]:
                broken.append(f"{family} {size}: the baseline was counted wrongly")
            if family == "random-hull" and size == AT and r["triangles"] > WANTED * r["baseline"]:
                broken.append(f"{family} {size}: more than {WANTED} of the baseline")
    return broken


def plot(found: Found, path: Path) -> bool:
    """Triangles and seconds over n, both ways, in log-log scale; False without matplotlib."""
    try:
        from matplotlib import pyplot
    except ImportError:
        return False
    figure, (counts, times) = pyplot.subplots(1, 2, figsize=(12, 5))
    for number, (family, rows) in enumerate(found.items()):
        records = [modes["recursion"] for _, modes in rows]
        n = [r["n"] for r in records]
        colour = f"C{number}"
        counts.loglog(n, [r["baseline"] for r in records], "--", color=colour, alpha=0.5)
        counts.loglog(n, [r["triangles"] for r in records], "o-", color=colour, label=family)
        for mode, style in (("recursion", "o-"), ("baseline", "--")):
            timed = [modes[mode] for _, modes in rows if mode in modes]
            timed = [r for r in timed if r["seconds"] > 0]
            times.loglog(
                [r["n"] for r in timed], [r["seconds"] for r in timed], style, color=colour
            )
    counts.set(xlabel="vertices", ylabel="triangles", title="Triangles; dashed: O(n^2) algorithm")
    times.set(xlabel="vertices", ylabel="seconds", title="Seconds without checks")
    counts.legend()
    figure.tight_layout()
    figure.savefig(path)
    return True


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--one", nargs=3, metavar=("FAMILY", "N", "MODE"), help=argparse.SUPPRESS)
    parser.add_argument("--to", type=int, default=SIZES[-1], help="the largest n")
    parser.add_argument("--jobs", type=int, default=1, help="processes at a time")
    parser.add_argument("--family", action="append", choices=sorted(FAMILIES))
    parser.add_argument("--plot", type=Path, help="a picture, if matplotlib is there")
    parser.add_argument("--write", action="store_true", help="into benchmarks/RESULTS.md")
    options = parser.parse_args()
    if options.one:
        family, size, mode = options.one
        print(json.dumps(measure(family, int(size), mode)))
        return
    found = measured(options.family or MEASURED, options.to, options.jobs)
    text = f"{machine()}\n\n{table(found)}\n"
    print(text)
    if options.plot and not plot(found, options.plot):
        print("matplotlib is not installed: no picture", file=sys.stderr)
    if options.write:
        write_section(Path(__file__).with_name("RESULTS.md"), "Theorem 4: growth", text)
    broken = failures(found)
    if broken:
        sys.exit("\n".join(broken))


if __name__ == "__main__":
    main()
