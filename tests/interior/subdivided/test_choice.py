"""The choice between Lemma 8 and bridges, component by component."""

from __future__ import annotations

import pytest
from hypothesis import given

from bern_exact.checkers.findings import demand
from bern_exact.checkers.lemma_7 import check_lemma_7
from bern_exact.checkers.lemma_8 import check_lemma_8
from bern_exact.interior.records import Rectilinear
from bern_exact.interior.subdivided.bridges import count_bridged
from bern_exact.interior.subdivided.choice import Method, partition, plans
from bern_exact.interior.subdivided.rectangle import tile
from bern_exact.interior.subdivided.strips import count_strips
from tests.interior.regions import regions, surface_vertices


@given(regions())
def test_the_best_keeps_lemma_8(region: Rectilinear) -> None:
    best = partition(region)
    demand(check_lemma_8(best))
    demand(check_lemma_7(tile(best)))


@given(regions())
def test_plans_tell_the_size(region: Rectilinear) -> None:
    assert sum(plan.vertices for plan in plans(region)) == surface_vertices(partition(region))


@given(regions())
def test_no_component_does_worse_than_either(region: Rectilinear) -> None:
    for plan in plans(region):
        assert plan.vertices <= min(count_bridged(plan.component), count_strips(plan.component))


@pytest.mark.parametrize("method", ["strips", "bridges", "best"])
def test_nothing_gives_nothing(method: Method) -> None:
    assert partition(Rectilinear(()), method).rectangles == ()
