"""Which partition to make: Lemma 8's, the bridges, or for each component the smaller."""

from __future__ import annotations

from typing import Literal, NamedTuple

from gmpy2 import mpq

from bern_exact.interior.records import Rectilinear
from bern_exact.interior.subdivided.bridges import bridged, count_bridged
from bern_exact.interior.subdivided.lattice import components
from bern_exact.interior.subdivided.records import Edge, Partition, SubdividedRectangle
from bern_exact.interior.subdivided.rectangle import triangles_of
from bern_exact.interior.subdivided.strips import count_strips, default_spacing, strips

Method = Literal["strips", "bridges", "best"]

WORTH_BUILDING = mpq(5, 4)
"""A plan with more than this times the fewest vertices is not built."""

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

    @property
    def keeps_lemma_8(self) -> bool:
        """Are there at most 2 N + N^1.5 vertices, for N of the component's boundary?

        Lemma 8's default has no more; and what holds for components holds for all together.
        """
        n = sum(len(loop) for loop in self.component.loops)
        return self.vertices <= 2 * n or (self.vertices - 2 * n) ** 2 <= n**3

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
        Lemma 8; Lemma 6, after bridges if there are holes; for each component whatever of
        these, and of Lemma 8 with other spacings, gives the fewest triangles.

    Returns
    -------
    Partition
        With "best" it keeps Lemma 8's bound as well.
    """
    if method == "strips":
        return strips(region)
    if method == "bridges":
        return bridged(region)
    return _together(region, [best_partition(component) for component in components(region)])


def best_partition(component: Rectilinear) -> Partition:
    """Of a component's plans that are about as good by vertices the one with fewest triangles.

    Vertices are counted without building anything.  Triangles also depend on what Lemma 7 adds;
    for them a partition is built, but no triangle.
    """
    possible = [plan for plan in plans(component) if plan.keeps_lemma_8]
    most = min(plan.vertices for plan in possible) * WORTH_BUILDING
    return min((plan.make() for plan in possible if plan.vertices <= most), key=_triangles)


def plans(component: Rectilinear) -> tuple[Plan, ...]:
    """The ways to partition a component, Lemma 8's default first; counts, builds nothing."""
    default = default_spacing(component)
    spacings = dict.fromkeys(max(1, int(default * factor)) for factor in SPACING_FACTORS)
    lemma_8 = [Plan(component, t, count_strips(component, t)) for t in spacings]
    bridges = Plan(component, None, count_bridged(component))
    return (lemma_8[0], bridges, *lemma_8[1:])


def _triangles(partition: Partition) -> int:
    """How many triangles Lemma 7 will make."""
    return sum(triangles_of(rectangle) for rectangle in partition.rectangles)


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
