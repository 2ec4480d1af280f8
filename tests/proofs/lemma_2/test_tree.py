"""Certificates are trees whose leaves tile all parameters, or are refused."""

from __future__ import annotations

import pytest

from proofs.lemma_2.block import DOWN, LEFT, UP
from proofs.lemma_2.forms import ONE
from proofs.lemma_2.tree import MalformedTree, leaves, sampled, stored


def test_every_side_is_halved() -> None:
    for d in range(4):
        found = leaves(f"{d + 1}00".encode(), LEFT)
        sides = found.high - found.low
        assert (sides[d] * 2 == (ONE if d < 2 else 2 * ONE)).all()
        assert (found.low[d, 1] == found.high[d, 0]) and sides.prod(axis=0, dtype=object).sum() == (
            4 * ONE**4
        )


def test_halves() -> None:
    found = leaves(b"10200", LEFT)
    assert found.low.T.tolist() == [
        [0, 0, -ONE, -ONE],
        [ONE // 2, 0, -ONE, -ONE],
        [ONE // 2, ONE // 2, -ONE, -ONE],
    ]
    assert found.high[0].tolist() == [ONE // 2, ONE, ONE] and found.deepest == 2


def test_mirror_images_are_left_out_of_the_root() -> None:
    assert leaves(b"0", UP).high.T.tolist() == [[ONE // 2, ONE, ONE, ONE]]
    assert leaves(b"0", DOWN).high.T.tolist() == [[ONE, ONE // 2, ONE, ONE]]
    assert leaves(b"0", LEFT).high.T.tolist() == [[ONE] * 4]


@pytest.mark.parametrize(
    ("word", "why"),
    [
        (b"", "ends"),
        (b"0 ", "goes on"),
        (b"1", "ends"),
        (b"120", "ends"),
        (b"00", "goes on"),
        (b"1000", "goes on"),
        (b"1S0", "byte"),
        (b"50000", "byte"),
        (b"1" * 40 + b"0" * 41, "too small"),
    ],
)
def test_what_is_no_tree_is_refused(word: bytes, why: str) -> None:
    with pytest.raises(MalformedTree, match=why):
        leaves(word, LEFT)
    if why != "too small":  # which is seen only on the paths that are taken
        with pytest.raises(MalformedTree):
            sampled(word, LEFT, [])


def test_single_leaves_are_those_of_the_whole_tree() -> None:
    word = stored("crowded", DOWN)
    found = leaves(word, DOWN)
    numbers = [*range(0, found.low.shape[1], 7), found.low.shape[1] - 1]
    some = sampled(word, DOWN, numbers)
    assert (some.low == found.low[:, numbers]).all() and (some.high == found.high[:, numbers]).all()
    with pytest.raises(MalformedTree, match="too small"):
        sampled(b"1" * 40 + b"0" * 41, LEFT, [0])


@pytest.mark.parametrize("cut", [1, 1000])
def test_a_truncated_certificate_is_refused(cut: int) -> None:
    with pytest.raises(MalformedTree, match="ends"):
        leaves(stored("angle-132", UP)[:-cut], UP)
