"""Running meshers on polygons: a record of each, whatever becomes of it."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, replace
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from benchmarks.peers.cases import Case
from benchmarks.peers.doubles import rounded
from benchmarks.peers.judging import Judged
from benchmarks.peers.meshers import CHECKED, Mesher
from bern_exact.exact.errors import InputError
from bern_exact.formats import safe_json
from bern_exact.formats.polygon_json import dump_polygon

ROOT = Path(__file__).resolve().parent.parent.parent

GRACE = 300
"""Seconds that a process may take besides what is capped: for reading, writing and judging."""

GIB = 1 << 30


@dataclass(frozen=True)
class Limits:
    """What a mesher may use: processor seconds (ours may have its own), bytes."""

    cap: float = 60
    our_cap: float = 600
    most: int = 4 * GIB


@dataclass(frozen=True)
class Record:
    """What became of one mesher on one polygon.

    Parameters
    ----------
    case, family, size : str, str, int
        The polygon, see `Case`.
    n, holes : int
        Its vertices and holes.
    mesher : str
        The mesher's name.
    outcome : str
        "ended", "time-out", "out of memory", "crash" or "error".
    detail : str
        Of a crash the signal, of an error its message.
    seconds : float or None
        Processor time of the meshing alone.
    triangles : int or None
        How many there are, also if there are too many for the judge.
    judged : Judged or None
        The exact figures.
    checked_seconds : float or None
        Of our meshes: the time with every check.
    """

    case: str
    family: str
    size: int
    n: int
    holes: int
    mesher: str
    outcome: str
    detail: str = ""
    seconds: float | None = None
    triangles: int | None = None
    judged: Judged | None = None
    checked_seconds: float | None = None

    def to_json(self) -> dict[str, Any]:
        """As JSON."""
        return {**vars(self), "judged": self.judged and self.judged.to_json()}

    @staticmethod
    def of_json(record: Mapping[str, Any]) -> Record:
        """The inverse of `to_json`."""
        found = record["judged"]
        return Record(**{**record, "judged": Judged.of_json(found) if found else None})


@dataclass(frozen=True)
class Ended:
    """How a process ended: its outcome as in `Record`, and what it printed last, if it ended."""

    outcome: str
    detail: str = ""
    result: Mapping[str, Any] | None = None


def run_child(arguments: Sequence[str], seconds: float) -> Ended:
    """Run a process of `benchmarks.peers.child` to its end, whatever that is.

    Parameters
    ----------
    arguments : sequence of str
        Of the child.
    seconds : float
        After so many seconds of wall-clock time it is killed.
    """
    command = [sys.executable, "-m", "benchmarks.peers.child", *arguments]
    environment = {**os.environ, "OMP_NUM_THREADS": "1"}
    with subprocess.Popen(
        command,
        cwd=ROOT,
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        errors="replace",
        start_new_session=True,
    ) as process:
        try:
            out, err = process.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
            return Ended("time-out", "stopped from outside")
    return ending(process.returncode, out, err)


def ending(code: int, out: str, err: str) -> Ended:
    """What a process's exit code and last words say."""
    if code == 0:
        return Ended("ended", "", json.loads(out.rsplit("\n", 2)[-2]))
    if code == -signal.SIGPROF:
        return Ended("time-out")
    lines = (err.strip() or out.strip()).splitlines()
    last = lines[-1] if lines else ""
    if any(word in (out + err).lower() for word in ("memoryerror", "bad_alloc", "out of memory")):
        return Ended("out of memory", last)
    if code < 0:
        return Ended("crash", signal.Signals(-code).name)
    return Ended("error", last)


def available(peers: Iterable[Mesher], tell: Callable[[str], None]) -> tuple[list[Mesher], str]:
    """The peers that can be imported, and the versions of their packages; tells of the others."""
    there, versions = [], {}
    for mesher in peers:
        package = mesher.package.partition(":")[0]
        try:
            installed = version(package)
        except PackageNotFoundError:
            tell(f"{mesher.title}: skipped, the package {package} is not installed")
            continue
        probed = run_child(["probe", mesher.entry], GRACE)
        if probed.outcome == "ended":
            there.append(mesher)
            versions[package] = f"{package} {installed}"
        else:
            tell(f"{mesher.title}: skipped, {probed.outcome}: {probed.detail}")
    return there, ", ".join(versions.values())


def measure(
    tasks: Sequence[tuple[Case, Mesher]],
    limits: Limits,
    jobs: int,
    done: Callable[[Record], None],
    keep: Path | None = None,
) -> None:
    """Run meshers on cases, `jobs` processes at a time.

    Parameters
    ----------
    tasks : sequence of (Case, Mesher)
        What is run on what; the largest polygons first, so that none is left alone at the end.
    limits : Limits
        For each run.
    jobs : int
        How many processes run at once.
    done : callable
        Told of each record when it is there.
    keep : Path, optional
        A directory in which polygons and meshes stay, for other judges.
    """
    with tempfile.TemporaryDirectory() as temporary, ThreadPoolExecutor(jobs) as pool:
        directory = keep or Path(temporary)
        directory.mkdir(parents=True, exist_ok=True)
        written = {case: _written(case, directory) for case in dict.fromkeys(c for c, _ in tasks)}
        runs = [
            pool.submit(_run, written[case], mesher, limits, directory, keep is not None)
            for case, mesher in sorted(tasks, key=lambda task: -written[task[0]].start.n)
        ]
        for run in as_completed(runs):
            done(run.result())


@dataclass(frozen=True)
class _Polygons:
    """A case's files: the exact polygon, and the one of doubles or why there is none."""

    start: Record
    exact: Path
    doubles: Path | None
    refusal: str


def _written(case: Case, directory: Path) -> _Polygons:
    """Write a case's polygons."""
    polygon = case.make()
    stem = case.name.replace(" ", "_").replace("^", "")
    exact, doubles = (directory / f"{stem}.{kind}.json" for kind in ("exact", "doubles"))
    exact.write_text(safe_json.dumps(dump_polygon(polygon)))
    start = Record(case.name, case.family, case.size, polygon.n, polygon.holes, "", "")
    try:
        doubles.write_text(safe_json.dumps(dump_polygon(rounded(polygon))))
    except InputError as error:
        return _Polygons(start, exact, None, f"rounded to doubles: {error}")
    return _Polygons(start, exact, doubles, "")


def _run(files: _Polygons, mesher: Mesher, limits: Limits, directory: Path, keep: bool) -> Record:
    """One mesher on one case: mesh, and judge what came out."""
    record = replace(files.start, mesher=mesher.name)
    polygon = files.exact if mesher.is_ours else files.doubles
    if polygon is None:
        return replace(record, outcome="error", detail=files.refusal)
    stem = files.exact.name.removesuffix(".exact.json")
    target = directory / f"{stem}.{mesher.name}.mesh.json"
    ended = _meshed(mesher, polygon, target, limits)
    record = replace(record, outcome=ended.outcome, detail=ended.detail)
    if ended.result is not None:
        verdict = run_child(["judge", str(polygon), str(target)], GRACE)
        record = replace(
            record,
            seconds=ended.result["seconds"],
            triangles=ended.result["triangles"],
            judged=None if verdict.result is None else Judged.of_json(verdict.result),
            detail="" if verdict.result else f"not judged: {verdict.outcome} {verdict.detail}",
        )
    if mesher.name in CHECKED:
        ended = _meshed(CHECKED[mesher.name], polygon, target, limits)
        if ended.result is not None:
            record = replace(record, checked_seconds=ended.result["seconds"])
        elif record.outcome == "ended":
            record = replace(record, detail=f"with checks: {ended.outcome} {ended.detail}")
    if not keep:
        target.unlink(missing_ok=True)
    return record


def _meshed(mesher: Mesher, polygon: Path, target: Path, limits: Limits) -> Ended:
    """Run a mesher on a file."""
    cap = limits.our_cap if mesher.is_ours else limits.cap
    arguments = ["mesh", mesher.entry, str(polygon), str(target), str(cap), str(limits.most)]
    return run_child(arguments, 2 * cap + GRACE)
