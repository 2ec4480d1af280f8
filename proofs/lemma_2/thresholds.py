"""Thresholds below 1/8 (`--max-angle`): some corner still gives 135 degrees in every block.

A slab is a claim for all thresholds of an interval at once, with a tree for each class of f, as
for tau = 1/8 alone; see `replay` for what a leaf has to show then.  Of heights and sides nothing
is claimed: they are measured in tau, and no box could show them for a whole interval.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from gmpy2 import mpq

from bern_exact.boundary.corners import block_demands
from bern_exact.checkers import bounds
from proofs.lemma_2.forms import BITS
from proofs.lemma_2.points import Bounds
from proofs.lemma_2.replay import replay, samples, scaled
from proofs.lemma_2.statements import CHAPTER, CLASSES, METHOD
from proofs.lemma_2.tree import Leaves, leaves, sampled, stored
from proofs.statement import NotShown, Statement, Status, demand

SAMPLE = 4
"""Leaves of each tree that the quick run replays; it does not unfold the others."""

PLACE = "Lemma 2, blocks (repaired)"


class Slab(NamedTuple):
    """All thresholds from low/1024 to high/1024."""

    low: int
    high: int

    @property
    def name(self) -> str:
        """Of its trees."""
        return f"angle-135-{self.low}-{self.high}"

    @property
    def claim(self) -> Bounds:
        """Angles below 135 degrees."""
        low, high = scaled(self.low, 1024), scaled(self.high, 1024)
        return Bounds((1, 1), low, slab=high - low)

    @property
    def text(self) -> str:
        """The claim in words."""
        low, high = mpq(self.low, 1024), mpq(self.high, 1024)
        return (
            f"For every threshold tau from {low} to {high}, in every block some corner of the "
            "square of v can be taken so that every face has a triangulation with all angles "
            "below 135 degrees."
        )


SLABS = (Slab(56, 128),)

LEAST = mpq(min(slab.low for slab in SLABS), 1024)
"""The least threshold for which 135 degrees in blocks are proved."""


def statements(full: bool = False) -> Iterator[Statement]:
    """A line for each slab: proved if every leaf is replayed, open if a sample is."""
    return (statement(slab, full) for slab in SLABS)


def statement(slab: Slab, full: bool) -> Statement:
    """Replay the trees of a slab, or a few leaves of each.

    Raises
    ------
    NotShown
        If a leaf that is replayed fails.
    """
    counts, looked_at = {}, 0
    for cls, name in CLASSES.items():
        word = stored(slab.name, cls)
        counts[name] = total = word.count(b"0")
        found = leaves(word, cls) if full else sampled(word, cls, list(samples(SAMPLE, total)))
        looked_at += replayed(found, cls, slab.claim)
    each = ", ".join(f"{count} with f {name}" for name, count in counts.items())
    total = sum(counts.values())
    status: Status = "proved" if full and looked_at == total else "open"
    evidence = f"{total} leaves ({each}); "
    evidence += (
        "they tile all parameters, all replayed"
        if status == "proved"
        else f"{looked_at} replayed, --full does all"
    )
    return Statement(PLACE, slab.text, status, METHOD, evidence)


def replayed(found: Leaves, cls: int, claim: Bounds) -> int:
    """How many leaves there are; all of them are good.

    Raises
    ------
    NotShown
        If one is not.
    """
    done = replay(found.low, found.high, cls, claim)
    demand(done.leaves == found.low.shape[1], "every leaf is looked at")
    if done.failed:
        raise NotShown(f"tau from {claim.tau} / 2^{BITS}, f {CLASSES[cls]}: leaf {done.failed[0]}")
    return done.leaves


@CHAPTER.proved(
    PLACE,
    "The slabs join up from the least threshold to 1/8. Where no corner keeps angles, heights and "
    "sides, the shipped rule takes the closest that keeps 135 degrees alone, if there is one. So "
    "with the slabs' certificates (see there) no angle in a block is above 135 degrees for any of "
    "these thresholds.",
    "written proof",
)
def angles_below_an_eighth() -> str:
    """The demands of the package are compared with the claim of the slabs.

    The second demand asks for no height, and then for no side (`CornerRule`).  The certificate
    gives a corner with which each face has a triangulation within 135 degrees: one is taken that
    has, by the first demand or the second, and the mesh then takes one of those triangulations.
    """
    ends = sorted((slab.low, slab.high) for slab in SLABS)
    demand(ends[-1][1] == bounds.TAU * 1024, "1/8")
    demand(all(a[1] == b[0] for a, b in zip(ends, ends[1:], strict=False)), "no gaps")
    for slab in SLABS:
        first, second = block_demands("square", mpq(slab.low, 1024))
        demand(first.kappa == second.kappa == 1, "135 degrees")
        demand(second.squared_floor == 0, "and no height")
        demand(slab.claim.kappa == (1, 1), "135 degrees in the certificate")
        demand(bool(slab.claim.tau <= slab.claim.tau_high < 1 << (BITS - 1)), "tau < 1/2")
    return f"tau from {LEAST} to 1/8"


@CHAPTER.open(
    PLACE,
    f"For every threshold below {LEAST}, too, some corner gives 135 degrees in every block.",
)
def other_thresholds() -> str:
    """The trees grow as tau falls: the layers in which q-vertices choose become thin.

    With f left 88 thousand leaves do for tau from 51/512 on, 293 thousand from 1/16 on, 403
    thousand from 7/128 on.  At 1/64 a search stopped at 580 thousand with 1.4 % of the parameters
    done; it was stuck nowhere.
    """
    return "checked on every run (`lemma-2.block-angle`), never failed"


@CHAPTER.open(
    PLACE,
    "For thresholds below 1/8 some corner keeps heights of tau/sqrt 2 and sides of tau in every "
    "block, too.",
)
def other_heights() -> str:
    """The shipped rule prefers such a corner; if there were none, the checkers would say so.

    A search in doubles, with tau as a fifth side of the boxes, needed 1.5 times the leaves for tau
    in [0.12, 1/8], f left, and far more below.
    """
    return "checked on every run (`lemma-2.block-*`), never failed"
