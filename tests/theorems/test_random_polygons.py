"""Random polygons of every family through Theorem 1 with every check and the lone judge."""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from bern_exact.corpus.over_the_grid import frame_of
from bern_exact.plane.polygon import Polygon
from tests.plane.shapes import polygons
from tests.theorems.families import FAMILIES, some_polygon
from tests.theorems.judged import proved

few = settings(max_examples=12, suppress_health_check=[HealthCheck.too_slow])


@pytest.mark.parametrize("kind", FAMILIES)
def test_every_family(kind: str) -> None:
    proved(some_polygon(kind, 2))


@few
@given(polygons())
def test_small_polygons_that_shrink(polygon: Polygon) -> None:
    proved(polygon)


@few
@given(kind=st.sampled_from(sorted(FAMILIES)), seed=st.integers(100, 10**9))
def test_any_seed_of_any_family(kind: str, seed: int) -> None:
    proved(some_polygon(kind, seed))


@pytest.mark.parametrize("kind", FAMILIES)
def test_a_family_is_a_function_of_its_seed(kind: str) -> None:
    assert some_polygon(kind, 5) == some_polygon(kind, 5)


def test_frames_of_unit_one_only_turn_and_shift() -> None:
    assert all(frame_of(attempt).squared_scale == 1 for attempt in range(3))
    assert len({frame_of(attempt) for attempt in range(3)}) == 3
