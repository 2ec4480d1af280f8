"""The long hunt: what it prints reproduces a failure."""

from __future__ import annotations

import json
from random import Random

import pytest

from bern_exact.checkers.findings import Finding
from bern_exact.formats.polygon_json import read_polygon
from tests import campaign
from tests.theorems.families import some_polygon


def test_a_failure_reproduces_its_polygon() -> None:
    polygon = some_polygon("high_bits", 1)
    line = json.dumps(campaign.failure("high_bits", 1, polygon, ValueError("why")))
    record = json.loads(line)
    assert record["message"] == "why" and some_polygon(record["family"], record["seed"]) == polygon
    assert read_polygon(record["polygon"]) == polygon


def test_what_goes_wrong_is_counted_and_printed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    ticks = iter([0, 1, 2, 99])
    monkeypatch.setattr(campaign.time, "monotonic", lambda: next(ticks))

    def broken(*_: object) -> None:
        raise campaign.WronglyJudged("refused")

    monkeypatch.setattr(campaign, "attempt", broken)
    summary = campaign.run(10, 1, ["triangle", "simple"])
    assert summary.failures == 2 and summary.polygons.total() == 2
    printed = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert [line["error"] for line in printed] == ["WronglyJudged"] * 2


@pytest.mark.parametrize(
    ("measured", "bound", "expected"),
    [("1/2", "1/2", 1), ("1/4", "1/2", "1/2"), ("1", "1/2", "1/2"), (3, 4, "3/4")],
)
def test_closeness(measured: str | int, bound: str | int, expected: object) -> None:
    found = Finding("a.b", "", "", "guarantee", bound, measured, 1, True)
    assert str(campaign.closeness(found)) == str(expected)


def test_closeness_to_a_negative_bound_counts_from_it() -> None:
    near, far = (
        campaign.closeness(Finding("a.b", "", "", "guarantee", "-1", value, 1, True))
        for value in ("-99/100", "-1/2")
    )
    assert near is not None and far is not None and near > far


@pytest.mark.parametrize("theorem", [2, 3])
def test_options_are_drawn_from_the_seed_alone(theorem: int) -> None:
    drawn = [campaign.some_options(theorem, Random(seed)) for seed in range(40)]
    assert drawn == [campaign.some_options(theorem, Random(seed)) for seed in range(40)]
    assert len({options["max_angle"] for options in drawn}) > 3


@pytest.mark.parametrize(("theorem", "seed"), [(1, 1), (2, 3), (3, 4), (4, 5), (4, 6)])
def test_an_attempt_at_each_theorem(theorem: int, seed: int) -> None:
    polygon = campaign.draw("plate", seed, theorem)
    options = campaign.some_options(theorem, Random(seed))
    assert campaign.attempt(theorem, polygon, options).polygon.holes == polygon.holes
