"""The same polygon just good and just bad."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from bern_exact.corpus.draws import hpoints, reason_against
from bern_exact.corpus.families import FAMILIES, drawn
from bern_exact.corpus.near_misses import SHAPES, just_bad, just_good, near_miss
from bern_exact.plane.feature_size import feature_size
from bern_exact.plane.validation import polygon_from_rings

shapes = pytest.mark.parametrize("shape", range(len(SHAPES)))


@shapes
@pytest.mark.parametrize("digits", [4, 40, 400])
def test_twins_are_good_and_bad(shape: int, digits: int) -> None:
    for variant in range(12):
        assert reason_against(just_good(shape, variant, digits)) is None
        assert reason_against(just_bad(shape, variant, digits)) == "edges-cross"


@shapes
def test_between_them_they_touch(shape: int) -> None:
    for variant in range(12):
        kind = reason_against(near_miss(mpq(0), shape, variant))
        assert kind in {"edges-touch", "edges-overlap", "repeated-vertex"}


@shapes
def test_the_gap_is_what_is_asked_for(shape: int) -> None:
    """Or across the exterior, where no feature size sees it."""
    polygon = polygon_from_rings(hpoints(just_good(shape, 5, 40)))
    squared = feature_size(polygon).squared
    assert squared < mpq(1, 10**70) or SHAPES[shape].__name__ in {"tip_to_tip", "slit_walls"}


def test_twins_have_the_same_parameters() -> None:
    good = drawn(FAMILIES["just-good"], "any")
    bad = drawn(FAMILIES["just-bad"], "other", good.parameters)
    assert [len(ring) for ring in good.rings] == [len(ring) for ring in bad.rings]
    far = max(
        abs(mpq(c) - d)
        for one, other in zip(good.rings, bad.rings, strict=True)
        for p, q in zip(one, other, strict=True)
        for c, d in zip(p, q, strict=True)
    )
    assert 0 < far < mpq(1, 10**36)
