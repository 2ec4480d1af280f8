"""Polygons with holes, the input of every theorem."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from os import PathLike
from typing import Any

from gmpy2 import mpq

from bern_exact.exact.errors import InputError
from bern_exact.exact.points import HPoint, Line, coordinates, line_through, literal


@dataclass(frozen=True)
class Polygon:
    """A polygon with holes: vertices in input order, rings with the interior on the left.

    Vertex i is `points[i]`; edge i is the directed edge from vertex i to vertex
    `after[i]`, so vertices and edges have the same indices.  The rings are
    normalised (outer counter-clockwise, holes clockwise); the points keep the
    order of the input, in which a ring may have run the other way.

    Parameters
    ----------
    points : tuple of HPoint
        All vertices, outer ring first, then the holes, each in input order.
    rings : tuple of tuple of int
        Each ring as indices into `points`, interior on the left, outer ring first,
        each beginning at the ring's first input vertex.
    name : str
        For people.

    Notes
    -----
    Nothing is checked here: `bern_exact.plane.validation.polygon_from_rings` is the way to make
    one from raw rings, and refuses all that is not a polygon.  180-degree
    vertices are allowed.
    """

    points: tuple[HPoint, ...]
    rings: tuple[tuple[int, ...], ...]
    name: str = field(default="", compare=False)

    @staticmethod
    def load(
        path: str | PathLike[str], *, numbers: str = "decimal", format: str | None = None
    ) -> Polygon:
        """The polygon in a file, read and validated exactly.

        Parameters
        ----------
        path : path
            The format follows its suffix: .json, .poly, .wkt or .geojson.
        numbers : {"decimal", "binary64"}
            Read a decimal as exactly that, or as the double nearest to it.
        format : {"json", "cgshop", "poly", "wkt", "geojson"}, optional
            Whatever the suffix and the file say.

        Raises
        ------
        InputError
            If the file is not what it must be, or `numbers` is neither.
        OSError
            If it cannot be read.
        """
        # The one import upwards: users look for this name here, and formats need this class.
        from bern_exact.formats import read_polygon_file

        if numbers not in ("decimal", "binary64"):
            raise InputError("unsupported", f"numbers {numbers!r}: decimal or binary64")
        return read_polygon_file(path, binary64=numbers == "binary64", format=format)

    def _repr_pretty_(self, printer: Any, cycle: bool) -> None:
        """How IPython and Hypothesis show it: rings as `verify` and `triangulate` take them."""
        rings = [[literal(p) for p in self.input_ring(r)] for r in range(len(self.rings))]
        printer.text(f"polygon_of({rings})")

    @property
    def n(self) -> int:
        """The number of vertices on all rings."""
        return len(self.points)

    @property
    def holes(self) -> int:
        """The number of holes."""
        return len(self.rings) - 1

    @cached_property
    def after(self) -> tuple[int, ...]:
        """For each vertex the next one along its ring, interior on the left."""
        following = [0] * len(self.points)
        for ring in self.rings:
            for i, v in enumerate(ring):
                following[v] = ring[(i + 1) % len(ring)]
        return tuple(following)

    @cached_property
    def before(self) -> tuple[int, ...]:
        """For each vertex the previous one along its ring."""
        previous = [0] * len(self.points)
        for v, w in enumerate(self.after):
            previous[w] = v
        return tuple(previous)

    @cached_property
    def ring_of(self) -> tuple[int, ...]:
        """For each vertex the number of its ring."""
        number = [0] * len(self.points)
        for r, ring in enumerate(self.rings):
            for v in ring:
                number[v] = r
        return tuple(number)

    @cached_property
    def lines(self) -> tuple[Line, ...]:
        """For each edge its directed line: positive on the interior side."""
        return tuple(
            line_through(p, self.points[w]) for p, w in zip(self.points, self.after, strict=True)
        )

    def place(self, vertex: int) -> tuple[int, int]:
        """[ring, index] of a vertex in the input, as users see it."""
        ring = self.ring_of[vertex]
        return ring, vertex - self.rings[ring][0]

    def edge_place(self, edge: int) -> tuple[int, int]:
        """[ring, index] of an edge in the input: it joins vertices index and index + 1.

        In a ring that was turned round that is not where the edge begins here, but where it ends.
        """
        ring, tail = self.place(edge)
        _, head = self.place(self.after[edge])
        return ring, tail if head == (tail + 1) % len(self.rings[ring]) else head

    def input_ring(self, ring: int) -> Sequence[HPoint]:
        """The points of a ring in input order."""
        indices = self.rings[ring]
        return self.points[indices[0] : indices[0] + len(indices)]

    @property
    def coordinates(self) -> list[list[tuple[mpq, mpq]]]:
        """Each ring's vertices as rational (x, y), in input order, the outer ring first."""
        return [[coordinates(p) for p in self.input_ring(ring)] for ring in range(len(self.rings))]

    def edges(self) -> Iterator[tuple[int, int]]:
        """Every edge as (tail, head), by index."""
        return enumerate(self.after)

    @cached_property
    def area(self) -> mpq:
        """The exact area, holes left out."""
        terms = []
        for v, w in enumerate(self.after):
            px, py, pw = self.points[v]
            qx, qy, qw = self.points[w]
            terms.append(mpq(px * qy - qx * py, pw * qw))
        return _sum(terms) / 2

    def with_points(self, points: Sequence[HPoint]) -> Polygon:
        """The same rings on other points (an orientation-preserving image)."""
        return Polygon(tuple(points), self.rings, self.name)


def _sum(terms: list[mpq]) -> mpq:
    """The sum by halves: a running total would bring its long denominator to every addition."""
    if len(terms) < 3:
        return sum(terms, mpq(0))
    middle = len(terms) // 2
    return _sum(terms[:middle]) + _sum(terms[middle:])
