"""Which partition to make: Lemma 8's, the bridges, or for each component the smaller."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal, NamedTuple

from gmpy2 import mpq

from bern_exact.interior.records import Rectilinear
from bern_exact.interior.subdivided.bridges import bridged, count_bridged
from bern_exact.interior.subdivided.lattice import components
from bern_exact.interior.subdivided.records import Edge, Partition, SubdividedRectangle
from bern_exact.interior.subdivided.strips import count_strips, default_spacing, strips

Method = Literal["strips", "bridges", "best"]

SPACING_FACTORS = (mpq(1), mpq(1, 2), mpq(7, 10), mpq(7, 5), mpq(2))
"""Multiples of Lemma 8's default spacing that are tried; the default first, as ties go to it."""


class Plan(NamedTuple):
    """How to partition one component.

    Parameters
    ----------
    component : Rectilinear
        The component.
    spacing : int or None
        t of Lemma 8, or None for Lemma 6, after bridges if there are holes.
    vertices : int
        How many vertices that gives.
    """

    component: Rectilinear
    spacing: int | None
    vertices: int

    def make(self) -> Partition:
        """The partition."""
        if self.spacing is None:
            return bridged(self.component)
        return strips(self.component, self.spacing)


def partition(region: Rectilinear, method: Method = "best") -> Partition:
    """Partition a region into matching subdivided rectangles.

    Parameters
    ----------
    region : Rectilinear
        Satisfying the matching condition.
    method : {"strips", "bridges", "best"}
        Lemma 8; Lemma 6, after bridges if there are holes; for each component whatever is
        counted to give the fewest vertices.

    Returns
    -------
    Partition
        With "best" it keeps Lemma 8's bound: no component has more vertices than Lemma 8's
        default gives it.
    """
    if method == "strips":
        return strips(region)
    if method == "bridges":
        return bridged(region)
    return _together(region, [plan.make() for plan in plans(region)])


def plans(region: Rectilinear) -> tuple[Plan, ...]:
    """For each component the plan with the fewest vertices; counts, builds nothing."""
    return tuple(
        min(_candidates(component), key=lambda plan: plan.vertices)
        for component in components(region)
    )


def _candidates(component: Rectilinear) -> Iterator[Plan]:
    """Lemma 6 first: ties go to it."""
    yield Plan(component, None, count_bridged(component))
    default = default_spacing(component)
    for spacing in dict.fromkeys(max(1, int(default * factor)) for factor in SPACING_FACTORS):
        yield Plan(component, spacing, count_strips(component, spacing))


def _together(region: Rectilinear, parts: list[Partition]) -> Partition:
    """The partition of the whole."""
    found: list[tuple[SubdividedRectangle, int]] = []
    edges: list[Edge] = []
    for part in parts:
        found += zip(part.rectangles, part.steps, strict=True)
        edges += part.bridges
    found.sort()
    return Partition(
        region,
        tuple(rectangle for rectangle, _ in found),
        tuple(step for _, step in found),
        tuple(sorted(edges)),
    )
