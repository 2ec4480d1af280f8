"""Lemma 6: few vertices, and a boundary that never grows."""

from __future__ import annotations

from bern_exact.checkers.bounds import halving_vertices
from bern_exact.checkers.extremes import Extreme
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.matching import check_matching, check_vertices, edges_of
from bern_exact.interior.subdivided.records import Edge, Partition

STAGE = "partition"


def check_lemma_6(partition: Partition) -> tuple[Finding, ...]:
    """The claims of Lemma 6 (parity of the cuts repaired).

    Parameters
    ----------
    partition : Partition
        Of a region without holes, or one that bridges have made so; then N counts both sides
        of the slits.

    Returns
    -------
    tuple of Finding
        `lemma-6.matching`, `.shared`, `.vertices`, `.boundary`.
    """
    # A slit has two sides.
    edges = partition.region.edges + 2 * len(partition.bridges)
    return (
        *check_matching(partition, "lemma-6", STAGE),
        check_vertices(
            partition,
            "lemma-6.vertices",
            STAGE,
            "The partition has at most 1.5 N log2 N - 0.5 N vertices.",
            halving_vertices(edges),
        ),
        _boundaries(partition).finding(
            "lemma-6.boundary",
            STAGE,
            "What is left after each half-step has a boundary of at most N lattice edges.",
            edges,
        ),
    )


def check_lemma_6_as_printed(partition: Partition) -> tuple[Finding, ...]:
    """The printed claim that the boundary does not grow when corners go to even lines.

    "Notice that at each stage, the squares removed have total perimeter length O(n)": which
    follows if what is left has a boundary no longer than before.  [0, 6] x [0, 4] minus
    [2, 3] x [3, 4] refutes it.

    Parameters
    ----------
    partition : Partition
        By the paper's own halving.

    Returns
    -------
    tuple of Finding
        `lemma-6.boundary-printed`.
    """
    return (
        _boundaries(partition).finding(
            "lemma-6.boundary-printed",
            STAGE,
            "Cutting off squares so that corners become even leaves a boundary of at most N.",
            partition.region.edges,
            role="as-printed",
        ),
    )


def _boundaries(partition: Partition) -> Extreme:
    """The longest boundary of what was left, over all half-steps, the last first.

    What is left after step k is the union of the rectangles cut off later: its
    boundary is the edges of theirs that no other of them has reversed.
    """
    longest = Extreme(greatest=True)
    free: set[Edge] = set()
    order = sorted(zip(partition.steps, partition.rectangles, strict=True), reverse=True)
    for i, (step, rectangle) in enumerate(order):
        for edge in edges_of(rectangle):
            if edge[::-1] in free:
                free.remove(edge[::-1])
            else:
                free.add(edge)
        if i + 1 == len(order) or order[i + 1][0] < step:
            longest.offer(len(free), 1, step - 1)
    return longest
