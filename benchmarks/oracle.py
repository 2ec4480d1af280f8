"""The judge for large meshes beside the plain gmpy2 judge and CGAL's exact kernel, in one run.

    python -m benchmarks.oracle                # the table on stdout, as Markdown
    python -m benchmarks.oracle --to 100000    # meshes of so many triangles at most
    python -m benchmarks.oracle --write        # and put it into benchmarks/RESULTS.md

Each measurement is a process of its own that reads a file: ours a JSON mesh, the C++ program
(`cgal_judge.cpp`, compiled here; skipped with a message without a compiler or libcgal-dev) the same
numbers as plain text.  Seconds are processor time.  The judges must agree.
"""

from __future__ import annotations

import argparse
import json
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.growth import exponent
from benchmarks.results import machine, write_section
from bern_exact.formats.mesh_json import load_array_mesh
from bern_exact.oracle.fast import verify_mesh
from bern_exact.oracle.filtered import Effort, verify_arrays

SIZES = (10_000, 100_000, 1_000_000)
MOST_PLAIN = 100_000
"""The gmpy2 judge is measured up to so many triangles: it takes 10 to 20 s for a million."""

HEADER = """| mesh | triangles | read s | judge s | peak MiB | to integers | gmpy2 judge s | ratio \
| CGAL read s | CGAL judge s | CGAL MiB | judge : CGAL |
| --- | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: |"""

NOTE = """\
`judge s` is `oracle/filtered.py` with a polygon (a square), all figures and classes of angles;
`to integers` the shapes of triangles that doubles left to it.  `ratio` is the plain gmpy2 judge
(`oracle/fast.py`) to it on the same mesh; `judge : CGAL` it to the C++ program, which compares no
boundary and counts no classes.  Both read text: JSON here, plain columns there."""

Columns = tuple[NDArray[Any], NDArray[Any]]


def squares(n: int) -> Columns:
    """x and y of the vertices of n x n unit squares."""
    x, y = np.meshgrid(np.arange(n + 1.0), np.arange(n + 1.0))
    return x.ravel(), y.ravel()


def jittered(n: int) -> Columns:
    """The inner vertices moved by chance, up to a fifth of a side."""
    random = np.random.default_rng(1)
    x, y = squares(n)
    inside = (x > 0) & (x < n) & (y > 0) & (y < n)
    for c in (x, y):
        c += np.where(inside, random.uniform(-0.2, 0.2, len(c)), 0)
    return x, y


def doubles(columns: Columns) -> list[list[str]]:
    """The shortest decimals of doubles."""
    return [[repr(float(c)) for c in column] for column in columns]


def rationals(columns: Columns) -> list[list[str]]:
    """Fractions p/q of 32 bits, each with a denominator of its own, next to numbers below 1024."""
    random, texts = np.random.default_rng(2), []
    for column in columns:
        below = random.integers(2**21, 2**22, len(column))
        below[column == np.floor(column)] = 1
        above = np.rint(column * below).astype(np.int64)
        texts.append([f"{p}/{q}" for p, q in zip(above.tolist(), below.tolist(), strict=True)])
    return texts


def turned(n: int) -> Columns:
    """A grid of random steps of integers, turned: right angles, none parallel to an axis."""
    random, (x, y) = np.random.default_rng(3), squares(n)
    for c in (x, y):
        c[:] = np.cumsum(random.integers(1, 1000, n + 1))[c.astype(int)]
    return 3 * x - 4 * y, 4 * x + 3 * y


def shared(n: int) -> list[list[str]]:
    """A grid of multiples of two fractions of 31 bits: equal triangles that no double shows."""
    x, y = squares(n)
    return [[f"{3 * int(c)}/2147483647" for c in x], [f"{7 * int(c)}/2147483629" for c in y]]


FAMILIES: dict[str, Callable[[int], list[list[str]]]] = {
    "jittered, doubles": lambda n: doubles(jittered(n)),
    "grid of 0.1, doubles": lambda n: doubles((0.1 * squares(n)[0], 0.1 * squares(n)[1])),
    "turned grid, doubles": lambda n: doubles(turned(n)),
    "jittered, p/q of 32 bits": lambda n: rationals(jittered(n)),
    "grid, p/q of 32 bits": shared,
}


def write_files(name: str, triangles: int, folder: Path) -> tuple[Path, Path, int]:
    """A mesh as JSON and as plain text; and its number of triangles."""
    n = max(1, round((triangles / 2) ** 0.5))
    xs, ys = FAMILIES[name](n)
    a = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    corners = np.concatenate(
        [np.stack((a, a + 1, a + n + 2), axis=1), np.stack((a, a + n + 2, a + n + 1), axis=1)]
    ).tolist()
    pairs = list(zip(xs, ys, strict=True))
    ring = [pairs[v] for v in (0, n, -1, n * (n + 1))]
    as_json, as_text = folder / "mesh.json", folder / "mesh.txt"
    mesh = {"vertices": pairs, "triangles": corners, "polygon": {"outer": ring}}
    as_json.write_text(json.dumps(mesh, separators=(",", ":")))
    with as_text.open("w") as file:
        file.write(f"{len(pairs)} {len(corners)}\n")
        file.writelines(f"{x} {y}\n" for x, y in pairs)
        file.writelines(f"{p} {q} {r}\n" for p, q, r in corners)
    return as_json, as_text, len(corners)


def judged(path: str, binary64: bool, plain: bool) -> dict[str, Any]:
    """One judge on one file, in this process."""
    started = time.process_time()
    mesh, polygon = load_array_mesh(path, binary64=binary64)
    read = time.process_time()
    effort = Effort()
    if plain:
        exact = mesh.mesh
        read = time.process_time()
        verdict = verify_mesh(exact, polygon)
    else:
        verdict = verify_arrays(mesh, polygon, effort=effort)
    return {
        "read": read - started,
        "judged": time.process_time() - read,
        "mib": peak_mib(),
        "worst": verdict.max_angle_triangle,
        "flattest": verdict.min_height_triangle,
        "valid": verdict.valid,
        "evaluated": effort.evaluated,
    }


def peak_mib() -> float:
    """The most memory that this process has had; Linux's `ru_maxrss` counts its parent's too."""
    status = Path("/proc/self/status")
    if status.exists():
        found = re.search(r"VmHWM:\s*(\d+) kB", status.read_text())
        if found is not None:
            return int(found[1]) / 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def apart(command: Sequence[str]) -> dict[str, Any]:
    """What a process of its own measures, a line of JSON."""
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    record: dict[str, Any] = json.loads(done.stdout)
    print(record, file=sys.stderr, flush=True)
    return record


def compiled(folder: Path) -> str | None:
    """The program on CGAL's kernel; None, with a message, if it cannot be compiled."""
    source, program = Path(__file__).with_name("cgal_judge.cpp"), str(folder / "cgal_judge")
    compiler = shutil.which("g++") or shutil.which("clang++")
    if compiler is None:
        print("CGAL is skipped: no C++ compiler", file=sys.stderr)
        return None
    flags = ["-O2", "-std=c++17", "-DNDEBUG", "-o", program, str(source), "-lmpfr", "-lgmp"]
    done = subprocess.run([compiler, *flags], capture_output=True, text=True)
    if done.returncode:
        first = next(iter(done.stderr.splitlines()), "")
        print(f"CGAL is skipped: {source.name} does not compile: {first}", file=sys.stderr)
        return None
    return program


def row(name: str, triangles: int, program: str | None, folder: Path) -> dict[str, Any]:
    """All judges on one mesh."""
    as_json, as_text, count = write_files(name, triangles, folder)
    one = [sys.executable, "-m", "benchmarks.oracle", "--one", str(as_json)]
    one += ["--binary64"] if "doubles" in name else []
    filtered = apart(one)
    found = {"name": name, "triangles": count, "filtered": filtered}
    others = {"plain": [*one, "--plain"]} if triangles <= MOST_PLAIN else {}
    if program is not None:
        others["cgal"] = [program, str(as_text)]
    for judge, command in others.items():
        found[judge] = apart(command)
        for key in ("worst", "flattest"):
            if found[judge][key] != filtered[key]:
                raise SystemExit(f"{judge} disagrees on {name}, {count} triangles: {found}")
    return found


def lines(rows: Sequence[dict[str, Any]]) -> Iterator[str]:
    """The table."""
    yield HEADER
    for found in rows:
        ours, plain, cgal = (found.get(judge) for judge in ("filtered", "plain", "cgal"))
        cells = [found["name"], f"{found['triangles']:,}", *seconds(ours), f"{ours['mib']:.0f}"]
        cells += [str(ours["evaluated"])]
        cells += [
            f"{plain['judged']:.2f}" if plain else "-",
            f"{plain['judged'] / ours['judged']:.1f}" if plain else "-",
        ]
        cells += [*seconds(cgal), f"{cgal['mib']:.0f}"] if cgal else ["-"] * 3
        cells += [f"{ours['judged'] / cgal['judged']:.1f}" if cgal else "-"]
        yield f"| {' | '.join(cells)} |"


def seconds(record: dict[str, Any]) -> list[str]:
    """Reading and judging."""
    return [f"{record[key]:.2f}" for key in ("read", "judged")]


def slopes(rows: Sequence[dict[str, Any]]) -> Iterator[str]:
    """How time grows with the number of triangles: the exponents over all sizes."""
    yield "| mesh | read | judge | CGAL judge |\n| --- | --: | --: | --: |"
    for name in FAMILIES:
        some = [found for found in rows if found["name"] == name]
        sizes = [found["triangles"] for found in some]
        if len(some) < 2:
            continue
        cells = [
            exponent(sizes, [found["filtered"][key] for found in some])
            for key in ("read", "judged")
        ]
        shown = [f"{value:.2f}" for value in cells]
        timed = all(found.get("cgal", {}).get("judged", 0) > 0 for found in some)
        shown += [f"{exponent(sizes, [f['cgal']['judged'] for f in some]):.2f}" if timed else "-"]
        yield f"| {name} | {' | '.join(shown)} |"


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--one", help=argparse.SUPPRESS)
    parser.add_argument("--binary64", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--plain", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--to", type=int, default=SIZES[-1], help="the most triangles")
    parser.add_argument("--write", action="store_true", help="into benchmarks/RESULTS.md")
    options = parser.parse_args()
    if options.one:
        print(json.dumps(judged(options.one, options.binary64, options.plain)))
        return
    sizes = [size for size in SIZES if size <= options.to] or [options.to]
    with tempfile.TemporaryDirectory() as folder:
        program = compiled(Path(folder))
        rows = [row(name, size, program, Path(folder)) for name in FAMILIES for size in sizes]
    table = "\n".join(lines(rows))
    text = f"{machine()}\n\n{table}\n\n{NOTE}\n\nFitted exponents:\n\n" + "\n".join(slopes(rows))
    print(text)
    if options.write:
        write_section(Path(__file__).with_name("RESULTS.md"), "The oracle on large meshes", text)


if __name__ == "__main__":
    main()
