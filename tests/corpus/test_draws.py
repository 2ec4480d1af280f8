"""Helpers that draw."""

from __future__ import annotations

from random import Random

import pytest

from bern_exact.corpus.draws import distinct, nth, pick, shuffle, sign, until
from bern_exact.theorems.stages import RefusedOption


def test_distinct_draws_are_distinct_and_in_range() -> None:
    for below, count in ((5, 5), (10**9, 30), (40, 4), (1, 0)):
        found = distinct(Random(1), below, count)
        assert len(set(found)) == count and all(0 <= i < below for i in found)


def test_there_are_no_more_distinct_integers_than_there_are() -> None:
    with pytest.raises(RefusedOption):
        distinct(Random(1), 3, 4)


def test_a_shuffled_list_has_the_same_items_in_any_order() -> None:
    found = set()
    for seed in range(60):
        items = [1, 2, 3]
        shuffle(Random(seed), items)
        assert sorted(items) == [1, 2, 3]
        found.add(tuple(items))
    assert len(found) == 6


def test_every_option_is_picked() -> None:
    random = Random(3)
    assert {pick(random, "abc") for _ in range(40)} == set("abc")
    assert {sign(random) for _ in range(40)} == {-1, 1}


def test_nothing_is_tried_for_ever() -> None:
    with pytest.raises(RefusedOption, match="attempts"):
        until(lambda: [[(0, 0), (1, 1), (2, 2)]])


@pytest.mark.parametrize("which", [-1, 3])
def test_an_option_that_is_not_there(which: int) -> None:
    with pytest.raises(RefusedOption, match="0 to 2"):
        nth("abc", which)
