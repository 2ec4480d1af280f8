"""The command line: `python -m benchmarks.peers`."""

from __future__ import annotations

import argparse
import importlib.util
import json
import sys
import time
from collections.abc import Iterable
from pathlib import Path

from benchmarks.peers import cases as shapes
from benchmarks.peers.cases import Case
from benchmarks.peers.meshers import OURS, PEERS, Mesher
from benchmarks.peers.picture import picture
from benchmarks.peers.plots import growth_plot
from benchmarks.peers.runs import GIB, ROOT, Limits, Record, available, measure
from benchmarks.peers.tables import ordered, report
from benchmarks.results import machine, write_section

TITLE = "Peers, side by side"
RESULTS = ROOT / "benchmarks" / "RESULTS.md"
PLOT = ROOT / "docs" / "peers_growth.png"
SHOWN = ("us_county_51015_augusta", "mdi_puzzle")


def parser() -> argparse.ArgumentParser:
    """The options."""
    made = argparse.ArgumentParser(prog="python -m benchmarks.peers", description=__doc__)
    made.add_argument("--quick", action="store_true", help="a few small polygons")
    made.add_argument("--write", action="store_true", help="into benchmarks/RESULTS.md and docs/")
    made.add_argument("--picture", metavar="NAME", help="draw this polygon alone")
    made.add_argument("--cap", type=float, default=60, help="processor seconds for a peer")
    made.add_argument("--our-cap", type=float, default=600, help="and for each run of ours")
    made.add_argument("--memory", type=float, default=4, help="GiB for each")
    made.add_argument("--jobs", type=int, default=2, help="processes at a time")
    made.add_argument("--only", action="append", metavar="TEXT", help="cases whose name has it")
    made.add_argument("--keep", type=Path, metavar="DIR", help="keep polygons and meshes there")
    made.add_argument(
        "--records", type=Path, metavar="FILE", help="a line of JSON each; what is there stays"
    )
    return made


def tell(text: str) -> None:
    """A line of progress."""
    print(text, file=sys.stderr, flush=True)


class Records:
    """The records of a run: those that a file holds already, and new ones as they come."""

    def __init__(self, file: Path | None) -> None:
        self.file = file
        self.found: list[Record] = []
        if file and file.exists():
            self.found = [Record.of_json(json.loads(line)) for line in file.open()]
        self._old = len(self.found)
        self._wanted = 0
        self._started = time.monotonic()

    def missing(self, tasks: Iterable[tuple[Case, Mesher]]) -> list[tuple[Case, Mesher]]:
        """Those of the tasks that have no record."""
        known = {(record.case, record.mesher) for record in self.found}
        left = [(case, mesher) for case, mesher in tasks if (case.name, mesher.name) not in known]
        self._wanted = len(left)
        return left

    def add(self, record: Record) -> None:
        """Take a record, and tell how far the run is."""
        self.found.append(record)
        if self.file:
            with self.file.open("a") as stream:
                stream.write(json.dumps(record.to_json()) + "\n")
        shown = f"{record.triangles:,} triangles" if record.triangles else record.outcome
        seconds = time.monotonic() - self._started
        tell(
            f"[{len(self.found) - self._old}/{self._wanted}, {seconds:.0f} s] "
            f"{record.case}: {record.mesher}, {shown} {record.detail}"
        )


def compared(options: argparse.Namespace, limits: Limits) -> str:
    """Measure all that `--records` has not yet; the report.  `--write`: plot and pictures too."""
    cases = shapes.quick_cases() if options.quick else shapes.every_case()
    if options.only:
        cases = [case for case in cases if any(text in case.name for text in options.only)]
    peers, versions = available(PEERS, tell)
    meshers = [*OURS, *peers]
    records = Records(options.records)
    tasks = records.missing((case, mesher) for case in cases for mesher in meshers)
    measure(tasks, limits, options.jobs, records.add, options.keep)
    names = [mesher.name for mesher in meshers]
    found = ordered(records.found, [case.name for case in cases], names)
    text = f"{machine()} {versions}.\n\n"
    if options.write:
        growth_plot(found, meshers, PLOT)
        text += f"![Triangles against A and n](../docs/{PLOT.name})\n\n"
        drawn = [name for name in SHOWN if draw(name, limits)]
        text += "".join(f"![{name}](../docs/{picture_of(name).name})\n\n" for name in drawn)
    return text + report(found, meshers, limits)


def picture_of(name: str) -> Path:
    """Where a polygon's picture is."""
    return ROOT / "docs" / f"peers_{name.replace(' ', '_')}.png"


def draw(name: str, limits: Limits) -> bool:
    """Draw one polygon's meshes, if all of them can be made."""
    case = next((case for case in shapes.every_case() if case.name == name), None)
    if case is None:
        raise SystemExit(f"no polygon {name!r}")
    target = picture_of(name)
    try:
        picture(case, target, limits)
    except RuntimeError as error:
        tell(f"no picture of {name}: {error}")
        return False
    tell(f"drew {target.relative_to(ROOT)}")
    return True


def main() -> None:
    """Measure and print."""
    options = parser().parse_args()
    limits = Limits(options.cap, options.our_cap, int(options.memory * GIB))
    if options.write and (options.quick or options.only):
        raise SystemExit("--write is for the whole comparison: not with --quick or --only")
    drawable = importlib.util.find_spec("matplotlib") is not None
    if (options.write or options.picture) and not drawable:
        raise SystemExit("--write and --picture need matplotlib: pip install '.[peers]'")
    if options.picture:
        draw(options.picture, limits)
        return
    text = compared(options, limits)
    print(text)
    if options.write:
        write_section(RESULTS, TITLE, text)


if __name__ == "__main__":
    main()
