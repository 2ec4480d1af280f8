"""Every claim holds on sound records, and is JSON-ready."""

import json

import pytest

from bern_exact.checkers.findings import demand
from tests.checkers.samples import CHECKS, THINGS, stages_of


@pytest.mark.parametrize("name", THINGS)
@pytest.mark.parametrize("check", CHECKS)
def test_every_guarantee_holds(name: str, check: str) -> None:
    demand(CHECKS[check](stages_of(name)))


def test_claims_are_unique_and_json_ready() -> None:
    findings = [f for check in CHECKS.values() for f in check(stages_of("plate"))]
    assert len({f.claim for f in findings}) == len(findings)
    for found in findings:
        json.dumps([found.to_json(), found.witness])
        assert found.statement and found.role == "guarantee"


def test_the_plate_puts_every_claim_to_the_test() -> None:
    findings = [f for check in CHECKS.values() for f in check(stages_of("plate"))]
    assert [f.claim for f in findings if f.cases == 0] == []
