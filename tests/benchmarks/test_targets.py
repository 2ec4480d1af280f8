"""Each target is met, not met or not measured as the exact figures say."""

from __future__ import annotations

from collections.abc import Sequence

import pytest
from gmpy2 import mpq

from benchmarks.peers.runs import Record
from benchmarks.peers.targets import Target, targets
from bern_exact.exact.angles import ANGLE_150
from tests.benchmarks.made import WIDE, record, verdict

FEWER, FEWER_STARS, AVERAGE, LARGEST, HIGHER, HIGHER_REAL, WITHIN = range(7)


def answer(records: Sequence[Record], target: int) -> Target:
    return targets(records)[target]


def test_nothing_measured_is_neither_met_nor_not() -> None:
    assert {target.met for target in targets([])} == {None}


@pytest.mark.parametrize(("ours", "theirs", "met"), [(9, 10, True), (10, 10, False)])
def test_fewer_means_fewer(ours: int, theirs: int, met: bool) -> None:
    records = [record("ne_x", "thin", ours), record("ne_x", "triangle-15", theirs)]
    assert answer(records, FEWER).met is met


def test_where_the_rival_does_not_end_nothing_is_compared() -> None:
    records = [record("star 300", "thin", 500), record("star 300", "triangle-15", None)]
    assert answer(records, FEWER_STARS).met is None
    more = [record("star 100", "thin", 90), record("star 100", "triangle-15", 100)]
    found = answer([*records, *more], FEWER_STARS)
    assert (found.met, found.measured) == (True, "1 of 1; nearest on star 100: 90 against 100")


def test_where_ours_does_not_end_the_rival_wins() -> None:
    records = [record("ne_x", "thin", None), record("ne_x", "triangle-15", 100)]
    assert answer(records, FEWER).met is False


def test_glyphs_are_real_but_not_among_the_outlines_of_the_first_target() -> None:
    records = [record("glyph_a", "thin", 100), record("glyph_a", "triangle-15", 10)]
    assert answer(records, FEWER).met is None
    assert answer(records, AVERAGE).met is True


@pytest.mark.parametrize(("counts", "met"), [((100, 130), True), ((101, 130), False)])
def test_the_average_is_exact(counts: tuple[int, int], met: bool) -> None:
    records = [record(f"ne_{i}", "thin", count) for i, count in enumerate(counts)]
    assert answer(records, AVERAGE).met is met


@pytest.mark.parametrize(
    ("triangles", "holes", "met"),
    [(130, 0, True), (131, 0, False), (140, 21, True), (141, 21, False)],
)
def test_holes_may_ask_for_more_than_the_most(triangles: int, holes: int, met: bool) -> None:
    assert answer([record("ne_x", "thin", triangles, holes=holes)], LARGEST).met is met


@pytest.mark.parametrize(("height", "met"), [(mpq(25), True), (mpq(25) - mpq(1, 10**9), False)])
def test_ten_times_higher_is_exact(height: mpq, met: bool) -> None:
    thin = record("ne_x", "thin", judged=verdict(min_height_squared=height))
    records = [thin, record("ne_x", "raw")]
    assert answer(records, HIGHER).met is met
    assert answer(records, HIGHER_REAL).met is met


def test_without_the_raw_mesh_no_height_is_compared() -> None:
    found = answer([record("ne_x", "thin"), record("ne_x", "raw", None)], HIGHER)
    assert (found.met, found.measured) == (False, "no figures of ne_x")


@pytest.mark.parametrize(
    ("changes", "met"),
    [
        ({"max_angle": ANGLE_150}, True),
        ({"max_angle": WIDE}, False),
        ({"defects": {"overlap": 1}}, False),
    ],
)
def test_ours_must_keep_the_bound_and_be_valid(changes: dict[str, object], met: bool) -> None:
    records = [record("bar", "raw"), record("bar", "thin", judged=verdict(**changes))]
    assert answer(records, WITHIN).met is met


def test_a_peer_may_do_as_it_likes() -> None:
    wide = record("bar", "triangle-15", judged=verdict(max_angle=WIDE))
    assert answer([record("bar", "thin"), wide], WITHIN).met is True


def test_one_of_ours_that_did_not_end_is_no_success() -> None:
    assert answer([record("bar", "raw"), record("bar", "thin", None)], WITHIN).met is False
