"""What the certificates show, as lines of `python -m proofs`."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from gmpy2 import mpq

from bern_exact.checkers import bounds
from bern_exact.checkers.bounds_grid import FACTOR
from proofs.lemma_2.block import DOWN, LEFT, RIGHT, UP
from proofs.lemma_2.exact import configuration, kappas
from proofs.lemma_2.points import Bounds
from proofs.lemma_2.replay import replay, samples, scaled
from proofs.lemma_2.tree import leaves, stored
from proofs.section_2 import degrees_of_arctan
from proofs.statement import CERTIFICATE, Chapter, NotShown, Statement, Status, demand

CHAPTER = Chapter()

METHOD = "exact certificate: a tree of boxes, replayed in integers"

SAMPLE = 60
"""Leaves of each class that the quick run replays."""

CLASSES = {UP: "up", LEFT: "left", DOWN: "down", RIGHT: "right"}


class Certificate(NamedTuple):
    """A claim and the trees that show it.

    Parameters
    ----------
    name : str
        Of the trees.
    text : str
        The claim.
    claim : Bounds
        What is to hold for each triangle.
    nearest : bool
        Whether only the closest corner may be taken.
    """

    name: str
    text: str
    claim: Bounds
    nearest: bool


TAU = scaled(1, 8)

CERTIFICATES = (
    Certificate(
        "angle-132",
        "In every block some corner of the square of v can be taken so that every face has a "
        "triangulation with all angles below 132 degrees, hence 135 (interior angle at v at least "
        "90 degrees, tau = 1/8).",
        Bounds((9, 10), TAU),
        False,
    ),
    Certificate(
        "height-half-tau",
        "In every block some corner can be taken so that every face has a triangulation with all "
        "angles below 135 degrees and all heights above tau/2 (the least of Theorems 2 and 3).",
        Bounds((1, 1), TAU, (1, 4)),
        False,
    ),
    Certificate(
        "closest-corner",
        "With the closest corner, as printed, every face of a block has a triangulation with all "
        "angles below 143.2 degrees (142.125 are reached in the limit).",
        Bounds((4, 3), TAU),
        True,
    ),
)


def statements(full: bool = False) -> Iterator[Statement]:
    """The chapter, and each certificate: proved if every leaf is replayed, open if a sample is.

    Raises
    ------
    NotShown
        If a leaf that is replayed fails.
    """
    yield from CHAPTER.statements(full)
    for certificate in CERTIFICATES:
        yield statement(certificate, full)


def statement(certificate: Certificate, full: bool) -> Statement:
    """Replay a certificate or a sample of it; that its leaves tile all boxes is checked anyway."""
    counts, looked_at, deepest = {}, 0, 0
    for cls, name in CLASSES.items():
        found = leaves(stored(certificate.name, cls), cls)
        total = found.low.shape[1]
        counts[name] = total
        deepest = max(deepest, found.deepest)
        chosen = np.arange(total) if full else np.array(list(samples(SAMPLE, total)))
        done = replay(
            found.low[:, chosen],
            found.high[:, chosen],
            cls,
            certificate.claim,
            certificate.nearest,
        )
        looked_at += done.leaves
        demand(done.leaves == len(chosen), "every leaf chosen is looked at")
        if done.failed:
            raise NotShown(f"{certificate.name}, f {name}: leaf {chosen[done.failed[0]]}")
    each = ", ".join(f"{count} with f {name}" for name, count in counts.items())
    total = sum(counts.values())
    status: Status = "proved" if full and looked_at == total else "open"
    evidence = f"{total} leaves ({each}) to depth {deepest} tile all parameters; "
    evidence += "all replayed" if status == "proved" else f"{looked_at} replayed, --full does all"
    return Statement("Lemma 2, blocks (repaired)", certificate.text, status, METHOD, evidence)


@CHAPTER.proved(
    "Lemma 2, blocks",
    "What becomes of a block depends on v in its square and on two rays alone, of which the first "
    "goes up, and on open questions that are answered both ways; mirror images halve each class.",
    "written proof (docstring of proofs.lemma_2, steps 1 to 7); exact comparisons",
)
def reduction() -> str:
    """The lengths that the steps compare, squared, in grid units: s' is at least 8."""
    reach = 2 * (2 + bounds.TAU) ** 2
    demand(bool(reach < FACTOR**2), "step 1, 2: (2 + tau) sqrt 2 < 8")
    demand(bool(mpq(18) < FACTOR**2), "step 5: 3 sqrt 2 < 8")
    demand(bool(2 * bounds.TAU < 1), "step 4: at most one end of a unit segment is near")
    demand(bool(90 + degrees_of_arctan(mpq(4, 3))[1] < mpq(1432, 10)), "kappa 4/3: 143.2 degrees")
    demand(bool(9 * 3 > 25), "3/5 > cot 60, of the bounds kappa")
    return f"squared reach {reach} and 18 < {FACTOR**2}"


@CHAPTER.proved(
    "Lemma 2, blocks",
    "No choice of corner does with less than 131.18 degrees: 132 is nearly best.",
    CERTIFICATE,
)
def no_better_corner() -> str:
    """v just beyond (9/16, 1/2), its rays just beside (-7/8, 1) and (-7/8, -1).

    For each corner the best triangulation of each face is found exactly.  The limit is
    180 degrees - arctan(8/7).
    """
    hair = mpq(1, 10**6)
    v = (mpq(9, 16) + hair, mpq(1, 2) + hair / 7)
    c = configuration(v, (hair - mpq(7, 8), mpq(1)), (hair - mpq(7, 8), mpq(-1)))
    least = min(kappa for kappa in kappas(c, bounds.TAU).values())
    demand(bool(least > mpq(7, 8) - 2 * hair), "cotangent -7/8 in the limit")
    demand(bool(90 + degrees_of_arctan(least)[0] > mpq(13118, 100)), "131.18 degrees")
    demand(bool(90 + degrees_of_arctan(mpq(9, 10))[1] < 132), "132 degrees")
    return f"the best corner has an angle of cotangent {-least}"


@CHAPTER.open(
    "Lemma 2, blocks (repaired)",
    "The shipped rule finds a corner with angles of at most 135 degrees, edges of at least tau and "
    "heights of at least tau/sqrt 2.",
)
def shipped_rule() -> str:
    """The last bound is attained in the limit: no tree of boxes that are closed can show it.

    Where no corner keeps all three the package takes the closest, and `lemma-2.block-angle` or
    `lemma-2.block-height` reports the block; no run has done so.
    """
    demand(bounds.boundary_height_squared() == bounds.TAU**2 / 2, "tau/sqrt 2")
    return "the certificates show 132 degrees, and 135 degrees with tau/2; checked on every run"
