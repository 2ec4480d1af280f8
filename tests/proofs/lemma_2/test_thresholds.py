"""Slabs of thresholds: what their trees show, and nothing beyond it."""

from __future__ import annotations

import pytest

from proofs.lemma_2.block import LEFT, RIGHT
from proofs.lemma_2.points import Bounds
from proofs.lemma_2.replay import replay, scaled
from proofs.lemma_2.statements import DEMANDED
from proofs.lemma_2.thresholds import SLABS, Slab, replayed, statement
from proofs.lemma_2.tree import Leaves, sampled, stored
from proofs.statement import NotShown

SLAB = SLABS[-1]


def some_leaves(cls: int, count: int) -> Leaves:
    word = stored(SLAB.name, cls)
    return sampled(word, cls, range(0, word.count(b"0"), word.count(b"0") // count))


def test_a_sample_is_not_called_a_proof() -> None:
    found = statement(SLAB, full=False)
    assert found.status == "open" and "--full" in found.evidence


def test_a_slab_that_is_wider_than_its_trees_fails() -> None:
    # Upwards it hardly does: what holds at low tau in so small boxes holds up to 1/4 as well.
    found = some_leaves(RIGHT, 50)
    assert replayed(found, RIGHT, SLAB.claim) == found.low.shape[1]
    with pytest.raises(NotShown):
        replayed(found, RIGHT, Slab(SLAB.low * 7 // 8, SLAB.high).claim)


@pytest.mark.parametrize(
    "claim",
    [Bounds((1, 1), scaled(1, 16), (91, 10), slab=1), DEMANDED._replace(height=(0, 0), slab=1)],
    ids=["heights", "sides"],
)
def test_of_a_slab_only_angles_are_claimed(claim: Bounds) -> None:
    found = some_leaves(LEFT, 1)
    with pytest.raises(ValueError, match="one threshold"):
        replay(found.low, found.high, LEFT, claim)
