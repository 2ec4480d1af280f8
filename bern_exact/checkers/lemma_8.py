"""Lemma 8: a region with holes in O(N^1.5) vertices."""

from __future__ import annotations

from bern_exact.checkers.bounds import strips_vertices
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.matching import check_matching, check_vertices
from bern_exact.interior.subdivided.records import Partition

STAGE = "partition"


def check_lemma_8(partition: Partition) -> tuple[Finding, ...]:
    """The claims of Lemma 8 (guide lines repaired).

    Parameters
    ----------
    partition : Partition
        Of any region with the matching condition.

    Returns
    -------
    tuple of Finding
        `lemma-8.matching`, `.shared`, `.vertices`.
    """
    return (
        *check_matching(partition, "lemma-8", STAGE),
        check_vertices(
            partition,
            "lemma-8.vertices",
            STAGE,
            "The partition has at most 2 N + N^1.5 vertices.",
            strips_vertices(partition.region.edges),
        ),
    )
