"""Which cases a corpus has."""

from __future__ import annotations

import pytest

from bern_exact.corpus.families import FAMILIES
from bern_exact.corpus.plan import Choice, Plan, choice_of, every_family
from bern_exact.exact.errors import InputError


@pytest.mark.parametrize("name", FAMILIES)
def test_an_id_says_family_parameters_and_number(name: str) -> None:
    given = dict.fromkeys(FAMILIES[name].parameters, 7)
    for choice in (Choice(name), Choice(name, given)):
        for number in (0, 12, 12345):
            assert choice_of(choice.case(number)) == (choice, number)


def test_families_take_turns() -> None:
    choices = every_family()
    cases = list(Plan(0, 2 * len(choices), choices).cases())
    assert len(set(cases)) == len(cases)
    assert {case.rpartition("-")[0] for case in cases[: len(choices)]} == set(FAMILIES)


def test_bad_polygons_come_early() -> None:
    first = [choice.definition for choice in every_family()[:15]]
    assert 2 <= sum(bool(family.errors) for family in first) <= 4


def test_a_longer_corpus_begins_with_the_shorter_one() -> None:
    choices = every_family()
    assert list(Plan(0, 99, choices).cases())[:40] == list(Plan(0, 40, choices).cases())


@pytest.mark.parametrize(
    "text", ["", "no-such-family", "star:", "star:k=3", "star:n=x", "star:n=3,", "STAR", "star n=3"]
)
def test_choices_that_are_refused(text: str) -> None:
    with pytest.raises(InputError):
        Choice.parse(text)


@pytest.mark.parametrize("case", ["", "star", "star-1", "star.n=3", "../star-000", "star.k=1-000"])
def test_ids_that_are_refused(case: str) -> None:
    with pytest.raises(InputError):
        choice_of(case)
