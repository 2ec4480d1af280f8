"""The choice between Lemma 8 and bridges, component by component."""

from __future__ import annotations

import pytest
from gmpy2 import mpq
from hypothesis import given

from bern_exact.checkers.findings import demand
from bern_exact.checkers.lemma_7 import check_lemma_7
from bern_exact.checkers.lemma_8 import check_lemma_8
from bern_exact.interior.records import Rectilinear
from bern_exact.interior.subdivided.choice import Method, best_partition, partition, plans
from bern_exact.interior.subdivided.lattice import components
from bern_exact.interior.subdivided.records import Partition
from bern_exact.interior.subdivided.rectangle import tile
from bern_exact.interior.subdivided.strips import strips
from tests.interior.regions import regions, surface_vertices


@given(regions())
def test_the_best_keeps_lemma_8(region: Rectilinear) -> None:
    best = partition(region)
    demand(check_lemma_8(best))
    demand(check_lemma_7(tile(best)))


@given(regions())
def test_plans_tell_the_size(region: Rectilinear) -> None:
    for component in components(region):
        for plan in plans(component):
            assert plan.vertices == surface_vertices(plan.make())


@given(regions())
def test_no_plan_that_is_about_as_good_by_vertices_has_fewer_triangles(
    region: Rectilinear,
) -> None:
    for component in components(region):
        best = best_partition(component)
        fewest = min(plan.vertices for plan in plans(component) if plan.keeps_lemma_8)
        for plan in plans(component):
            if plan.keeps_lemma_8 and plan.vertices <= mpq(5, 4) * fewest:
                assert triangles(best) <= triangles(plan.make())


@given(regions())
def test_lemma_8_keeps_its_own_bound(region: Rectilinear) -> None:
    for component in components(region):
        assert plans(component)[0].keeps_lemma_8
        assert plans(component)[0].vertices == surface_vertices(strips(component))


def triangles(partition: Partition) -> int:
    return sum(len(tiling.triangles) for tiling in tile(partition).tilings)


@pytest.mark.parametrize("method", ["strips", "bridges", "best"])
def test_nothing_gives_nothing(method: Method) -> None:
    assert partition(Rectilinear(()), method).rectangles == ()
