"""One command makes the whole report."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from benchmarks.peers import __main__ as command
from benchmarks.peers import cases
from benchmarks.peers.cases import FAMILIES, STAR_400, every_case, quick_cases
from benchmarks.peers.meshers import Mesher
from bern_exact.oracle.arguments import polygon_of
from bern_exact.plane.polygon import Polygon
from tests.benchmarks.fakes import SQUARE

FAKES = (
    Mesher("good", "A good one", "tests.benchmarks.fakes:good", "pytest:pytest"),
    Mesher("looping", "A slow one", "tests.benchmarks.fakes:looping", "pytest:pytest"),
    Mesher("absent", "No such", "tests.benchmarks.fakes:good", "no-such-package-anywhere:x"),
)


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """A comparison on one square, with fake peers."""
    case = cases.Case("unit square", "bar", 1, lambda: polygon_of(SQUARE))
    monkeypatch.setattr(command, "PEERS", FAKES)
    monkeypatch.setattr(cases, "every_case", lambda: [case])


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> None:
    monkeypatch.setattr("sys.argv", ["peers", "--cap", "0.2", *arguments])
    command.main()


@pytest.mark.usefixtures("small")
def test_measured_once_and_told_again(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    saved = str(tmp_path / "records.jsonl")
    run(monkeypatch, "--records", saved)
    told = capsys.readouterr()
    assert re.search(r"\| unit square \| 4 \| \d+ \| 2 \| 2 \| time-out \|", told.out)
    assert "No such: skipped, the package no-such-package-anywhere is not installed" in told.err
    assert "unit square: looping, time-out" in told.err
    run(monkeypatch, "--records", saved)
    again = capsys.readouterr()
    assert again.out == told.out
    assert "unit square" not in again.err


def test_every_family_has_its_polygons() -> None:
    found = every_case()
    assert {case.family for case in found} == set(FAMILIES)
    assert len({case.name for case in found}) == len(found)
    assert {case.name for case in quick_cases()} <= {case.name for case in found}


def test_the_fixed_star_is_there() -> None:
    assert Polygon.load(STAR_400).n == 400


@pytest.mark.parametrize("part", [("--quick",), ("--only", "star")])
def test_a_part_is_not_written(monkeypatch: pytest.MonkeyPatch, part: tuple[str, ...]) -> None:
    with pytest.raises(SystemExit, match="--write is for the whole comparison"):
        run(monkeypatch, "--write", *part)
