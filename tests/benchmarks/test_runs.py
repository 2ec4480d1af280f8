"""Whatever becomes of a mesher, it is a record."""

from __future__ import annotations

import json
import signal
from pathlib import Path

import pytest

from benchmarks.peers.cases import Case
from benchmarks.peers.meshers import Mesher
from benchmarks.peers.runs import GIB, Limits, Record, available, ending, measure
from bern_exact.oracle.arguments import polygon_of
from bern_exact.oracle.judge import judge, load
from tests.benchmarks.fakes import SQUARE
from tests.benchmarks.made import record

CASE = Case("unit square", "bar", 1, lambda: polygon_of(SQUARE))
LIMITS = Limits(cap=0.3, our_cap=60, most=GIB)
HERE = "pytest:pytest"
"""A package that is there, as a peer's would be."""


def fake(name: str, package: str = HERE) -> Mesher:
    return Mesher(name, f"a {name} mesher", f"tests.benchmarks.fakes:{name}", package)


def ran(*meshers: Mesher, case: Case = CASE, keep: Path | None = None) -> dict[str, Record]:
    found: list[Record] = []
    measure([(case, mesher) for mesher in meshers], LIMITS, 2, found.append, keep)
    return {record.mesher: record for record in found}


def test_good_and_bad_meshers_side_by_side() -> None:
    names = ("good", "chatty", "looping", "crashing", "greedy", "failing")
    found = ran(*map(fake, names))
    assert {name: found[name].outcome for name in names} == {
        "good": "ended",
        "chatty": "ended",
        "looping": "time-out",
        "crashing": "crash",
        "greedy": "out of memory",
        "failing": "error",
    }
    assert found["crashing"].detail == "SIGSEGV"
    assert found["failing"].detail == "ValueError: no mesh for this one"
    good = found["good"]
    assert good.judged is not None
    assert good.judged.valid
    assert (good.triangles, good.n, good.holes) == (2, 4, 0)
    assert good.seconds is not None


def test_a_polygon_that_doubles_cannot_hold_is_a_record_for_peers_alone() -> None:
    thin = Case("thin", "bar", 1, lambda: polygon_of([(1, 0), (2, 0), (1, "1e-400")]))
    found = ran(fake("good"), fake("chatty", package=""), case=thin)
    assert found["good"].outcome == "error"
    assert found["good"].detail.startswith("rounded to doubles: ")
    assert found["chatty"].outcome == "ended"


def test_kept_files_are_for_any_judge(tmp_path: Path) -> None:
    ran(fake("good"), keep=tmp_path)
    mesh, polygon = (tmp_path / f"unit_square.{k}.json" for k in ("good.mesh", "doubles"))
    assert judge(load(mesh), load(polygon))["valid"]


def test_what_is_not_installed_or_does_not_import_is_told() -> None:
    told: list[str] = []
    absent = fake("good", "no-such-package-anywhere:nothing")
    broken = Mesher("broken", "a broken one", "tests.benchmarks.no_such_module:mesh", HERE)
    there, versions = available([fake("good"), absent, broken], told.append)
    assert [mesher.entry for mesher in there] == ["tests.benchmarks.fakes:good"]
    assert versions == f"pytest {pytest.__version__}"
    assert told[0].endswith("skipped, the package no-such-package-anywhere is not installed")
    assert "ModuleNotFoundError" in told[1]


@pytest.mark.parametrize(
    ("code", "err", "outcome", "detail"),
    [
        (-signal.SIGPROF, "", "time-out", ""),
        (-signal.SIGABRT, "terminate called: std::bad_alloc", "out of memory", None),
        (-signal.SIGABRT, "corrupted size", "crash", "SIGABRT"),
        (1, "Error:  Out of memory.", "out of memory", None),
        (1, "", "error", ""),
    ],
)
def test_last_words(code: int, err: str, outcome: str, detail: str | None) -> None:
    ended = ending(code, "", err)
    assert ended.outcome == outcome
    assert detail is None or ended.detail == detail
    assert ended.result is None


@pytest.mark.parametrize("made", [record("star 100", "thin"), record("star 100", "raw", None)])
def test_records_survive_json(made: Record) -> None:
    assert Record.of_json(json.loads(json.dumps(made.to_json()))) == made
