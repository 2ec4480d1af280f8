"""Records as JSON, exactly."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from gmpy2 import mpq, mpz

from bern_exact.checkers.findings import Finding
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.trace import Trace, plain


class Pair(NamedTuple):
    line: int
    at: mpq


@dataclass(frozen=True)
class First:
    points: tuple[HPoint, ...]


@dataclass(frozen=True)
class Second:
    before: First
    pairs: tuple[Pair, ...]
    added: frozenset[tuple[int, int]]


FIRST = First((hpoint(mpq(1, 3), 2),))
SECOND = Second(FIRST, (Pair(3, mpq(-1, 2)),), frozenset({(2, 1), (0, 5)}))


def test_points_and_rationals_are_exact_text() -> None:
    assert plain(FIRST, {}) == {"points": [["1/3", "2"]]}


def test_named_tuples_are_objects_and_sets_are_sorted() -> None:
    record = plain(SECOND, {})
    assert record["pairs"] == [{"line": 3, "at": "-1/2"}]
    assert record["added"] == [[0, 5], [2, 1]]


def test_a_record_within_another_is_named(tmp_path: Path) -> None:
    trace = Trace(tmp_path / "deep" / "trace")
    trace.stage("first", FIRST)
    trace.stage("second", SECOND)
    written = json.loads((tmp_path / "deep" / "trace" / "02-second.json").read_text())
    assert written["before"] == {"stage": "first"}


def test_a_violation_keeps_its_exact_witness(tmp_path: Path) -> None:
    finding = Finding("a.b", "s", "c", "guarantee", 1, 2, 1, False, {"at": hpoint(mpz(1), 2)})
    path = Trace(tmp_path).violation(finding)
    assert json.loads(path.read_text())["witness"] == {"at": ["1", "2"]}
