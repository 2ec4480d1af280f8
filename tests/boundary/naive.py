"""The grid and the arrangement of Section 2 by definition: everything is listed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from gmpy2 import mpq

from bern_exact.boundary.records import HORIZONTAL, VERTICAL, Diced, Interval, Node
from bern_exact.exact.points import HPoint, coordinates, direction, grid_point, hpoint
from bern_exact.exact.predicates import cross, is_in_wedge, squared_distance
from bern_exact.plane.polygon import Polygon

Dart = tuple[Node, Node]


def at(axis: int, line: int, along: mpq) -> HPoint:
    """The point on a grid line with this other coordinate."""
    return hpoint(line, along) if axis == VERTICAL else hpoint(along, line)


def hits(polygon: Polygon, axis: int, line: int) -> list[tuple[mpq, int]]:
    """Where all edges cross a grid line, in order: (other coordinate, edge)."""
    found = []
    for tail, head in polygon.edges():
        p, q = coordinates(polygon.points[tail]), coordinates(polygon.points[head])
        if (p[axis] < line) != (q[axis] < line):
            t = (line - p[axis]) / (q[axis] - p[axis])
            found.append((p[1 - axis] + t * (q[1 - axis] - p[1 - axis]), tail))
    return sorted(found)


def square(p: HPoint) -> tuple[int, int]:
    """The lower left corner of the square of a point."""
    return int(p[0] // p[2]), int(p[1] // p[2])


def box(p: HPoint, shape: str) -> tuple[tuple[int, int], tuple[int, int]]:
    """Lower left and upper right corner of the block of a vertex."""
    x, y = square(p)
    if shape == "square":
        return (x - 1, y - 1), (x + 2, y + 2)
    # Round each of the four corners in lexicographic order; the first nearest one counts.
    corners = [(x + i, y + j) for i in (0, 1) for j in (0, 1)]
    x, y = min(corners, key=lambda corner: squared_distance(p, grid_point(*corner)))
    return (x - 1, y - 1), (x + 1, y + 1)


def kept_intervals(polygon: Polygon, axis: int, shape: str = "square") -> set[Interval]:
    """The maximal intervals inside P' that have a piece in some block, within its wedge."""
    kept = set()
    for v, p in enumerate(polygon.points):
        low, high = box(p, shape)
        for line in range(low[axis], high[axis] + 1):
            crossed = hits(polygon, axis, line)
            for (y0, below), (y1, above) in zip(crossed[::2], crossed[1::2], strict=True):
                piece = (max(y0, mpq(low[1 - axis])), min(y1, mpq(high[1 - axis])))
                if piece[0] < piece[1] and _meets_wedge(polygon, v, axis, line, piece):
                    kept.add(Interval(line, below, above))
    return kept


def _meets_wedge(polygon: Polygon, v: int, axis: int, line: int, piece: tuple[mpq, mpq]) -> bool:
    """Has a piece of a line inner points in the wedge of v?"""
    cuts = {*piece}
    for edge in (v, polygon.before[v]):
        a, b, c = polygon.lines[edge]
        if axis == HORIZONTAL:
            a, b = b, a
        cuts.add(-(a * line + c) / mpq(b))
    points = polygon.points
    return any(
        is_in_wedge(
            at(axis, line, (y0 + y1) / 2),
            points[polygon.before[v]],
            points[v],
            points[polygon.after[v]],
        )
        for y0, y1 in pairwise(sorted(cuts))
        if piece[0] <= y0 and y1 <= piece[1]
    )


class NaiveArrangement:
    """All nodes, darts and faces of the boundary and the kept intervals."""

    def __init__(self, diced: Diced) -> None:
        self.diced = diced
        self.polygon = diced.framed.polygon
        self.n = self.polygon.n
        self.chains = [*self._intervals(), *self._edges()]
        """Nodes in order along every interval, then along every edge."""

    def along(self, axis: int, number: int) -> list[Node]:
        """All nodes on an interval, from its low end to its high end."""
        return self.chains[number + (len(self.diced.vertical) if axis == HORIZONTAL else 0)]

    def point(self, node: Node) -> HPoint:
        """Where a node is before warping."""
        if isinstance(node, tuple):
            return grid_point(*node)
        if node < self.n:
            return self.polygon.points[node]
        q = self.diced.crossings[node - self.n]
        return at(q.axis, q.line, q.at)

    def ends(self, axis: int, interval: Interval) -> tuple[int, int]:
        """The crossings at the low and the high end."""
        found = self.diced.crossing_at
        return found[axis, interval.line, interval.low], found[axis, interval.line, interval.high]

    def _intervals(self) -> Iterator[list[Node]]:
        q = self.diced.crossings
        sets = (self.diced.vertical, self.diced.horizontal)
        for axis, intervals in enumerate(sets):
            for interval in intervals:
                low, high = self.ends(axis, interval)
                met = set()
                for other in sets[1 - axis]:
                    left, right = self.ends(1 - axis, other)
                    if (
                        q[low].at < other.line < q[high].at
                        and q[left].at < interval.line < q[right].at
                    ):
                        met.add(other.line)
                nodes: list[Node] = [
                    (interval.line, y) if axis == VERTICAL else (y, interval.line)
                    for y in sorted(met)
                ]
                yield [self.n + low, *nodes, self.n + high]

    def _edges(self) -> Iterator[list[Node]]:
        for tail, head in self.polygon.edges():
            start, run = self.polygon.points[tail], self.polygon.points[head]
            ahead = direction(start, run)
            on_edge = [self.n + j for j, q in enumerate(self.diced.crossings) if q.edge == tail]
            on_edge.sort(
                key=lambda node, start=start, ahead=ahead: _progress(start, ahead, self.point(node))
            )
            yield [tail, *on_edge, head]

    def faces(self) -> list[tuple[Node, ...]]:
        """Every face of P', counter-clockwise, each beginning at its least node."""
        around: dict[Node, list[Node]] = {}
        outside: set[Dart] = set()
        for number, chain in enumerate(self.chains):
            for a, b in pairwise(chain):
                around.setdefault(a, []).append(b)
                around.setdefault(b, []).append(a)
                if number >= len(self.chains) - self.n:
                    outside.add((b, a))
        for node, others in around.items():
            others.sort(
                key=lambda other, node=node: Angle(direction(self.point(node), self.point(other)))
            )
        seen: set[Dart] = set(outside)
        found = []
        for tail, heads in around.items():
            for head in heads:
                ring = []
                dart = (tail, head)
                while dart not in seen:
                    seen.add(dart)
                    ring.append(dart[0])
                    ways = around[dart[1]]
                    dart = (dart[1], ways[ways.index(dart[0]) - 1])
                if ring:
                    found.append(rotated(ring))
        return found

    def is_on_boundary(self, ring: Sequence[Node]) -> bool:
        """Has a face a piece of the boundary as an edge?"""
        pieces = {pair for chain in self.chains[-self.n :] for pair in pairwise(chain)}
        return any((ring[i - 1], node) in pieces for i, node in enumerate(ring))


def _progress(start: HPoint, ahead: tuple[mpq, mpq], p: HPoint) -> mpq:
    """How far p lies from the start along a direction."""
    (x, y), (u, v) = coordinates(start), coordinates(p)
    return (u - x) * ahead[0] + (v - y) * ahead[1]


class Angle:
    """A direction, ordered counter-clockwise from east."""

    def __init__(self, vector: tuple[mpq, mpq]) -> None:
        self.vector = vector
        self.lower = vector[1] < 0 or (vector[1] == 0 and vector[0] < 0)

    def __lt__(self, other: Angle) -> bool:
        if self.lower != other.lower:
            return other.lower
        return bool(cross(self.vector, other.vector) > 0)


def rotated(ring: Sequence[Node]) -> tuple[Node, ...]:
    """The ring begun at its least node."""
    start = min(range(len(ring)), key=lambda i: repr(ring[i]))
    return (*ring[start:], *ring[:start])


def area(points: Sequence[HPoint]) -> mpq:
    """The signed area of a ring."""
    total = mpq(0)
    for i, p in enumerate(points):
        (x, y), (u, v) = coordinates(points[i - 1]), coordinates(p)
        total += x * v - y * u
    return total / 2
