"""What Lemmas 6 and 8 promise alike: a set of matching subdivided rectangles that fills Q."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.interior.subdivided.records import Edge, Partition, SubdividedRectangle


def check_matching(partition: Partition, lemma: str, stage: str) -> tuple[Finding, ...]:
    """The claims that a partition is a set of matching subdivided rectangles.

    Parameters
    ----------
    partition : Partition
        The record.
    lemma, stage : str
        For the findings.

    Returns
    -------
    tuple of Finding
        `.matching`: each vertex has a partner opposite; `.shared`: the rectangles fill Q, and
        abutting ones have the same vertices on what they share.

    Notes
    -----
    Rectangles are positive, so if every directed edge is used once and those whose reverse is
    unused are Q's boundary edges, then each point of Q is covered once: two sides that
    abut consist of the same edges.  Linear in the output.
    """
    matching, shared = Violations(), Violations()
    used: set[Edge] = set()
    for rectangle in partition.rectangles:
        matching.case(is_matching(rectangle), rectangle)
        for edge in edges_of(rectangle):
            shared.case(edge not in used, edge)
            used.add(edge)
    boundary = {
        (loop[i - 1], node) for loop in partition.region.loops for i, node in enumerate(loop)
    }
    free = {edge for edge in used if edge[::-1] not in used}
    for edge in sorted(boundary ^ free):
        shared.broken(edge)
    return (
        matching.finding(
            f"{lemma}.matching",
            stage,
            "Each vertex on a side of a rectangle has a partner on the opposite side.",
        ),
        shared.finding(
            f"{lemma}.shared",
            stage,
            "The rectangles fill Q, and each vertex is a vertex of each rectangle it touches.",
        ),
    )


def check_vertices(
    partition: Partition, claim: str, stage: str, statement: str, bound: int
) -> Finding:
    """The claim that there are at most so many vertices, each counted once."""
    vertices = {node for rectangle in partition.rectangles for node in rectangle.ring()}
    most = Extreme(greatest=True)
    most.offer(len(vertices), 1, None)
    return most.finding(claim, stage, statement, bound)


def is_matching(rectangle: SubdividedRectangle) -> bool:
    """Is it a rectangle, its opposite sides subdivided alike, by points in order within them?"""
    x0, x1, y0, y1, left, right, bottom, top = rectangle
    return (
        left == right
        and bottom == top
        and _is_increasing((x0, *bottom, x1))
        and _is_increasing((y0, *left, y1))
    )


def _is_increasing(values: Sequence[int]) -> bool:
    return all(a < b for a, b in pairwise(values))


def edges_of(rectangle: SubdividedRectangle) -> Iterator[Edge]:
    """Its directed edges, counter-clockwise."""
    ring = rectangle.ring()
    return pairwise([*ring, ring[0]])
