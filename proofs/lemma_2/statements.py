"""What the certificates show, as lines of `python -m proofs`."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from proofs.lemma_2.block import DOWN, LEFT, RIGHT, UP
from proofs.lemma_2.points import Bounds
from proofs.lemma_2.replay import replay, samples, scaled
from proofs.lemma_2.tree import leaves, stored
from proofs.statement import NotShown, Statement, Status, demand

METHOD = "exact certificate: a tree of boxes, replayed in integers"

SAMPLE = 120
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
    bounds : Bounds
        What is to hold for each triangle.
    nearest : bool
        Whether only the closest corner may be taken.
    """

    name: str
    text: str
    bounds: Bounds
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
)


def statements(full: bool = False) -> Iterator[Statement]:
    """Each certificate: proved if every leaf is replayed, open if only a sample is.

    Raises
    ------
    NotShown
        If a leaf that is replayed fails.
    """
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
            certificate.bounds,
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
