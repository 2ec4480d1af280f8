"""The command line: `python -m benchmarks.peers`."""

from __future__ import annotations

import argparse
import importlib.util
import json
import sys
import time
from pathlib import Path

from benchmarks.peers import cases as shapes
from benchmarks.peers.meshers import OURS, PEERS
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


def collected(options: argparse.Namespace, limits: Limits) -> str:
    """Measure everything that is not in `--records` already; the report.  `--write`: the plot."""
    chosen = shapes.quick_cases() if options.quick else shapes.every_case()
    if options.only:
        chosen = [case for case in chosen if any(text in case.name for text in options.only)]
    records: list[Record] = []
    if options.records and options.records.exists():
        records = [Record.of_json(json.loads(line)) for line in options.records.open()]
    known = {(record.case, record.mesher) for record in records}
    peers, versions = available(PEERS, tell)
    meshers = [*OURS, *peers]
    tasks = [
        (case, mesher)
        for case in chosen
        for mesher in meshers
        if (case.name, mesher.name) not in known
    ]
    started = time.monotonic()

    def done(record: Record) -> None:
        records.append(record)
        if options.records:
            with options.records.open("a") as stream:
                stream.write(json.dumps(record.to_json()) + "\n")
        shown = f"{record.triangles:,} triangles" if record.triangles else record.outcome
        tell(
            f"[{len(records) - len(known)}/{len(tasks)}, {time.monotonic() - started:.0f} s] "
            f"{record.case}: {record.mesher}, {shown} {record.detail}"
        )

    measure(tasks, limits, options.jobs, done, options.keep)
    names = [case.name for case in chosen]
    records = ordered(records, names, [mesher.name for mesher in meshers])
    text = report(records, meshers, limits)
    if options.write:
        growth_plot(records, meshers, PLOT)
        images = [f"![Triangles against A and n](../docs/{PLOT.name})"]
        images += [f"![{name}](../docs/{picture_of(name).name})" for name in SHOWN]
        text = "\n\n".join([*images, text])
    return f"{machine()} {versions}.\n\n{text}\n"


def main() -> None:
    """Measure and print."""
    options = parser().parse_args()
    limits = Limits(options.cap, options.our_cap, int(options.memory * GIB))
    drawable = importlib.util.find_spec("matplotlib") is not None
    if (options.write or options.picture) and not drawable:
        raise SystemExit("--write and --picture need matplotlib: pip install '.[peers]'")
    if options.picture:
        _draw(options.picture, limits)
        return
    text = collected(options, limits)
    print(text)
    if options.write:
        write_section(RESULTS, TITLE, text)
        for name in SHOWN:
            _draw(name, limits)


def picture_of(name: str) -> Path:
    """Where a polygon's picture is."""
    return ROOT / "docs" / f"peers_{name.replace(' ', '_')}.png"


def _draw(name: str, limits: Limits) -> None:
    """Draw one polygon's meshes."""
    case = next((case for case in shapes.every_case() if case.name == name), None)
    if case is None:
        raise SystemExit(f"no polygon {name!r}")
    target = picture_of(name)
    picture(case, target, limits)
    tell(f"drew {target.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
