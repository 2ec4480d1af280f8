"""Extremes of fractions: the first of the worst, and what has no value is worst of all."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from bern_exact.checkers.extremes import Extreme
from bern_exact.checkers.findings import Finding


def found(extreme: Extreme, *, bound: int = 0) -> Finding:
    return extreme.finding("some.claim", "mesh", "a sentence", mpq(bound))


@pytest.mark.parametrize("greatest", [False, True])
@pytest.mark.parametrize("den", [0, -1])
@pytest.mark.parametrize("num", [-5, 0, 5])
@pytest.mark.parametrize("position", [0, 1, 2])
def test_a_case_without_a_value_breaks_the_claim(
    greatest: bool, den: int, num: int, position: int
) -> None:
    """Wherever it comes: nothing offered before or after hides it."""
    extreme = Extreme(greatest=greatest)
    offers = [(0, 1, "good"), (0, 1, "good")]
    offers.insert(position, (num, den, "bad"))
    for offer in offers:
        extreme.offer(*offer)
    finding = found(extreme)
    assert not finding.holds
    assert (finding.measured, finding.witness, finding.cases) == (None, "bad", 3)


def test_the_first_case_without_a_value_is_the_witness() -> None:
    extreme = Extreme()
    extreme.offer(1, 0, "first")
    extreme.offer(1, 0, "second")
    assert found(extreme).witness == "first"


def test_no_case_at_all_holds() -> None:
    finding = found(Extreme())
    assert finding.holds
    assert (finding.measured, finding.witness, finding.cases) == (None, None, 0)


def test_cases_that_were_not_offered_do_not_hold() -> None:
    extreme = Extreme()
    extreme.cases = 3
    assert not found(extreme).holds


@pytest.mark.parametrize(("bound", "holds"), [(0, True), (1, True), (2, False)])
def test_the_least_keeps_the_bound(bound: int, holds: bool) -> None:
    extreme = Extreme()
    for value in (3, 1, 2):
        extreme.offer(value, 1, value)
    assert found(extreme, bound=bound).holds == holds
