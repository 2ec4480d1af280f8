"""The tables say what the records say."""

from __future__ import annotations

import doctest
from types import ModuleType

import pytest
from gmpy2 import mpq

from benchmarks.peers import doubles, figures
from benchmarks.peers.judging import Judged
from benchmarks.peers.meshers import OURS, PEERS
from benchmarks.peers.runs import Limits, Record
from benchmarks.peers.tables import measure_table, ordered, peer_table, report
from benchmarks.peers.targets import by_case
from bern_exact.exact.angles import ANGLE_90
from tests.benchmarks.made import WIDE, record, verdict

THIN, RIVAL = OURS[1], PEERS[0]


def cells(row: str) -> list[str]:
    return [cell.strip() for cell in row.strip("|").split("|")]


@pytest.mark.parametrize("module", [figures, doubles], ids=lambda module: module.__name__)
def test_the_examples_in_the_docstrings(module: ModuleType) -> None:
    assert doctest.testmod(module).failed == 0


def test_a_row_has_every_mesher_and_a_gap_for_what_did_not_run() -> None:
    records = [record("bar", "thin", 1234), record("comb", RIVAL.name, None)]
    table = measure_table(records, [THIN, RIVAL], by_case(records), figures.triangles)
    assert list(map(cells, table.splitlines()[2:])) == [
        ["bar", "100", "1,234", "-"],
        ["comb", "100", "-", "time-out"],
    ]


@pytest.mark.parametrize(
    ("found", "text"),
    [
        (verdict(), "135.00"),
        (verdict(max_angle=WIDE), "**153.43**"),
        (verdict(max_angle=None), "-"),
        (None, "-"),
    ],
)
def test_angles_above_the_bound_are_bold(found: Judged | None, text: str) -> None:
    assert figures.angle(record("bar", "thin", judged=found)) == text


def test_ours_has_two_times() -> None:
    assert figures.seconds(record("bar", "thin", checked_seconds=2.5)) == "0.500 / 2.50"
    assert figures.seconds(record("bar", RIVAL.name)) == "0.500"
    assert figures.seconds(record("bar", RIVAL.name, None)) == "-"


@pytest.mark.parametrize(
    ("defects", "off", "text"),
    [
        ({}, 0, "exact"),
        ({"boundary-vertex-off-edge": 3}, 3, "3 off"),
        ({"boundary-vertex-off-edge": 3, "overlap": 2}, 3, "3 off, overlap"),
        ({"hole-filled": 1}, None, "hole-filled"),
    ],
)
def test_what_is_wrong_in_a_few_words(defects: dict[str, int], off: int | None, text: str) -> None:
    assert figures.standing(verdict(defects=defects, off=off)) == text


def peer_row(*records: Record) -> list[str]:
    return cells(peer_table(records, [THIN, RIVAL]).splitlines()[3])


def test_a_peer_that_wins_is_said_to_win() -> None:
    better = verdict(1, max_angle=ANGLE_90, min_height_squared=mpq(1, 2))
    ours = record("bar", "thin", 2, seconds=1.0)
    theirs = record("bar", RIVAL.name, 1, judged=better, seconds=0.01)
    row = peer_row(ours, theirs)
    assert row[:6] == [RIVAL.title, "1 of 1", "1", "1", "0", "1"]
    assert row[6:] == ["1", "1", "1", "1", "1, 100 times in the median"]


def test_a_peer_that_loses_is_said_to_lose() -> None:
    worse = verdict(9, max_angle=WIDE, min_height_squared=mpq(1, 9))
    row = peer_row(
        record("bar", "thin", 2), record("bar", RIVAL.name, 9, judged=worse, seconds=5.0)
    )
    assert row[5:] == ["0", "0", "0", "0", "0", "0, 0 times in the median"]


def test_equal_is_no_win() -> None:
    row = peer_row(record("bar", "thin"), record("bar", RIVAL.name))
    assert row[6:10] == ["0", "0", "0", "0"]


def test_fewer_triangles_with_large_angles_are_counted_apart() -> None:
    wide = record("bar", RIVAL.name, 1, judged=verdict(1, max_angle=WIDE))
    assert peer_row(record("bar", "thin"), wide)[6:8] == ["1", "0"]


def test_the_farthest_vertex_off_is_told_to_the_feature_size() -> None:
    off = verdict(
        defects={"boundary-vertex-off-edge": 1},
        off=1,
        off_squared=mpq(1, 10**20),
        feature_squared=mpq(1, 4),
    )
    assert peer_row(record("bar", "thin"), record("bar", RIVAL.name, judged=off))[4] == "2e-10"


def test_the_order_is_that_of_the_lists_whatever_ended_first() -> None:
    records = [record(case, mesher) for case in "ba" for mesher in ("y", "x", "z")]
    found = ordered(records, ["a", "b", "c"], ["x", "y"])
    assert [(r.case, r.mesher) for r in found] == [("a", "x"), ("a", "y"), ("b", "x"), ("b", "y")]


def test_what_went_wrong_is_told_once_more() -> None:
    broken = record("bar", RIVAL.name, None, outcome="crash", detail="SIGSEGV")
    text = report([record("bar", "thin"), broken], [THIN, RIVAL], Limits())
    assert f"- bar, {RIVAL.name}: crash, SIGSEGV" in text
    assert "| crash |" in text
