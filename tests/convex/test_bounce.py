"""Bouncing ends, soon enough, with every subdivision alone."""

from __future__ import annotations

import pytest
from hypothesis import given, settings

from bern_exact.checkers.bouncing import check_bouncing
from bern_exact.convex.bounce import bounce
from bern_exact.convex.frame import convex_frame
from bern_exact.convex.records import Bounced
from bern_exact.corpus.convex import FAMILIES
from bern_exact.plane.polygon import Polygon
from tests.convex.polygons import SHAPES, convex_polygons, family, polygon, shape


def bounced(polygon: Polygon) -> Bounced:
    return bounce(convex_frame(polygon))


def assert_right(record: Bounced) -> None:
    broken = [found for found in check_bouncing(record) if not found.holds]
    assert not broken, broken[0]


@settings(max_examples=150)
@given(convex_polygons())
def test_every_claim_holds(shape: Polygon) -> None:
    assert_right(bounced(shape))


@pytest.mark.parametrize("name", SHAPES)
def test_every_claim_holds_for_single_shapes(name: str) -> None:
    assert_right(bounced(shape(name)))


@pytest.mark.parametrize("name", FAMILIES)
@pytest.mark.parametrize("n", [5, 40])
def test_every_claim_holds_for_families(name: str, n: int) -> None:
    assert_right(bounced(family(name, n, 1)))


@pytest.mark.parametrize("name", ["random-hull", "regular", "clustered-spiral"])
def test_every_claim_holds_for_many_vertices(name: str) -> None:
    assert_right(bounced(family(name, 1000)))


def test_a_triangle_needs_nothing_but_its_vertices() -> None:
    record = bounced(shape("triangle"))
    assert len(record.verticals) == 3 and not record.events and not record.first


def test_symmetric_chains_close_every_path_at_once() -> None:
    # The same above as below: f(y) = y everywhere.
    record = bounced(
        polygon([[(0, 0), (2, -3), (5, -4), (9, -3), (14, 0), (9, 3), (5, 4), (2, 3)]])
    )
    assert not record.steps


def test_the_clustered_spiral_needs_nearly_all_that_is_allowed() -> None:
    record = bounced(family("clustered-spiral", 40))
    turned = sum(step.stays is None for step in record.steps)
    assert len(record.steps) >= len(record.first) + turned - 2


def test_paths_turn_in_the_middle() -> None:
    record = bounced(family("clustered-spiral", 20))
    assert any(step.stays is None for step in record.steps)


def test_closed_paths_are_few() -> None:
    record = bounced(family("random-hull", 160))
    assert 0 < len(record.closed) < len(record.steps)


def test_each_second_subdivision_is_bounced_on_one_side() -> None:
    record = bounced(family("arc", 40))
    assert record.frame.one_sided
    assert record.steps and all(step.left is None for step in record.steps)
