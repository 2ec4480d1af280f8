"""Rings as they were read, before they are known to bound a polygon."""

from __future__ import annotations

from collections.abc import Sequence

from bern_exact.exact.points import HPoint, coordinates


class RawRings:
    """Vertices numbered through all rings in input order, and their neighbours.

    Edge v joins vertex v and the next one in input order, whatever the orientation.

    Parameters
    ----------
    rings : sequence of sequences of HPoint
        Anything at all.
    """

    def __init__(self, rings: Sequence[Sequence[HPoint]]) -> None:
        self.points: list[HPoint] = [p for ring in rings for p in ring]
        self.rings: list[tuple[int, ...]] = []
        self.ring_of: list[int] = []
        self.after: list[int] = []
        self.before: list[int] = []
        for r, ring in enumerate(rings):
            start, end = len(self.after), len(self.after) + len(ring)
            self.rings.append(tuple(range(start, end)))
            self.ring_of += [r] * len(ring)
            self.after += [v + 1 if v + 1 < end else start for v in range(start, end)]
            self.before += [v - 1 if v > start else end - 1 for v in range(start, end)]

    def place(self, vertex: int) -> list[int]:
        """[ring, index] of a vertex, or of the edge that begins there, as users see it."""
        ring = self.ring_of[vertex]
        return [ring, vertex - self.rings[ring][0]]

    @staticmethod
    def text(p: HPoint) -> list[str]:
        """The exact coordinates of a point, in lowest terms."""
        return [str(value) for value in coordinates(p)]
