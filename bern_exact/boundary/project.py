"""Projecting staircase vertices onto an edge (Section 3, Lemma 5).

"Project all vertices of the staircase, except the first and last, diagonally
onto e": a diagonal leaves an almost axis-parallel edge at 45 degrees or nearly so, and
hits e at 45 degrees or more, so the trapezoids between have no large angle.  The height
at the two end faces does not "come for free": a projection can land next to the
end of e.  So those that land too near are not drawn, the first and the last diagonal may be left
out, and the end pieces are triangulated by the best of all ways.

Most diagonals can be spared as well: between two of them any piece will do that has a
triangulation within both bounds.  Each diagonal left out is a vertex and a triangle fewer.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from gmpy2 import mpq

from bern_exact.boundary.optimal import (
    Demand,
    Rating,
    Triangulated,
    best_by_rating,
    best_triangulation,
    rate,
)
from bern_exact.boundary.records import MergedFace, Node, Projected
from bern_exact.exact.points import HPoint, Line, meet
from bern_exact.exact.predicates import squared_distance

MOST_SPARED = 5
"""The most neighbouring diagonals that are left out: time is cubic in it, and further ones are
seldom spared."""


NOWHERE = mpq(0)
"""No distance at all."""


@dataclass(frozen=True)
class Cuttable:
    """A merged face with its possible diagonals.

    Parameters
    ----------
    merged : MergedFace
        M.
    staircase : sequence of HPoint
        Where its staircase vertices are.
    cuts : sequence of int
        The staircase vertices that can be projected between the ends of the base, by position.
    projections : sequence of HPoint
        Their projections.
    """

    merged: MergedFace
    staircase: Sequence[HPoint]
    cuts: Sequence[int]
    projections: Sequence[HPoint]

    def ring(self, i: int, j: int) -> list[HPoint]:
        """The piece between cuts i and j; -1 and len(cuts) stand for the ends of the base."""
        return [
            self.projections[~name] if name < 0 else self.staircase[name]
            for name in self.names(i, j)
        ]

    def names(self, i: int, j: int) -> list[int]:
        """The same piece by numbers: staircase positions, and ~k for the projection of cut k."""
        last = len(self.cuts)
        low = 1 if i < 0 else self.cuts[i]
        high = len(self.staircase) - 1 if j == last else self.cuts[j] + 1
        start = 0 if i < 0 else ~i
        end = len(self.staircase) - 1 if j == last else ~j
        return [start, end, *reversed(range(low, high))]

    def nodes(self, i: int, j: int, number: Callable[[int], Node]) -> tuple[Node, ...]:
        """The same piece as nodes; `number` gives the node of a cut's projection."""
        stairs = self.merged.staircase
        return tuple(number(~name) if name < 0 else stairs[name] for name in self.names(i, j))


def cuttable(
    merged: MergedFace, line: Line, points: Sequence[HPoint], squared_apart: mpq = NOWHERE
) -> Cuttable:
    """Find the diagonals of a merged face.

    Parameters
    ----------
    merged : MergedFace
        M, along the edge with this line.
    line : Line
        The edge's line, in grid coordinates; neither axis-parallel nor diagonal.
    points : sequence of HPoint
        The staircase's points.
    squared_apart : mpq, optional
        No projection is nearer than this, squared, to an end of the base.
    """
    # Along diagonals t is constant: t = x + y if e has positive slope, else x - y.
    slope = -1 if line[0] * line[1] > 0 else 1
    levels = [(x + slope * y, w) for x, y, w in points]
    t = [mpq(level, w) for level, w in levels]
    low, high = min(t[0], t[-1]), max(t[0], t[-1])
    cuts = [i for i in range(1, len(points) - 1) if low < t[i] < high]
    projections = [meet((levels[i][1], slope * levels[i][1], -levels[i][0]), line) for i in cuts]
    # Projections are in order along e: only the first and the last ones can be too near.
    first, last = 0, len(cuts)
    while first < last and squared_distance(points[0], projections[first]) < squared_apart:
        first += 1
    while first < last and squared_distance(points[-1], projections[last - 1]) < squared_apart:
        last -= 1
    return Cuttable(merged, points, cuts[first:last], projections[first:last])


@dataclass(frozen=True)
class _Path:
    """A way to cut a face from its first end to a cut: its worst piece's value, if any, and all."""

    value: mpq | None
    pieces: tuple[tuple[int, int, Triangulated], ...]

    def then(self, i: int, j: int, piece: Triangulated) -> _Path:
        """This path and one more piece."""
        value = piece.value if self.value is None else min(self.value, piece.value)
        return _Path(value, (*self.pieces, (i, j, piece)))

    @property
    def rank(self) -> tuple[mpq, int]:
        """For the best path: the worst piece, then few pieces."""
        return self.value or mpq(0), -len(self.pieces)

    @property
    def shortness(self) -> tuple[int, mpq]:
        """For the shortest path: few pieces, then the worst piece."""
        return -len(self.pieces), self.value or mpq(0)


def fewest_cuts(face: Cuttable, demand: Demand) -> _Path | None:
    """Choose as few diagonals as the demand allows; of equally few the best.

    A shortest path from one end of the base to the other over the possible cuts, each step a
    piece that has a triangulation within the demand.

    Returns
    -------
    _Path or None
        None if no choice keeps the demand with at most `MOST_SPARED` neighbours left out.
    """
    last = len(face.cuts)
    rating = _Remembered(face, demand)
    paths: dict[int, _Path] = {-1: _Path(None, ())}
    for i in range(-1, last):
        before = paths.get(i)
        if before is None:
            continue
        for j in range(i + 1, min(last, i + 1 + MOST_SPARED) + 1):
            known = paths.get(j)
            if known is not None and len(known.pieces) <= len(before.pieces):
                continue
            found = best_by_rating(*rating.of_piece(i, j))
            if found is None:
                continue
            path = before.then(i, j, found)
            if known is None or path.shortness > known.shortness:
                paths[j] = path
    return paths.get(last)


class _Remembered:
    """Ratings of a face's triangles: neighbouring pieces have many in common."""

    def __init__(self, face: Cuttable, demand: Demand) -> None:
        self._face, self._demand = face, demand
        self._known: dict[tuple[int, int, int], mpq | None] = {}

    def of_piece(self, i: int, j: int) -> tuple[int, Rating]:
        """The number of sides of the piece between two cuts, and the rating of its triangles."""
        points, known, demand = self._face.ring(i, j), self._known, self._demand
        names = self._face.names(i, j)

        def rating(a: int, b: int, c: int) -> mpq | None:
            key = names[a], names[b], names[c]
            if key not in known:
                known[key] = rate(points[a], points[b], points[c], demand)
            return known[key]

        return len(points), rating


def best_cuts(face: Cuttable, demand: Demand) -> _Path | None:
    """Choose diagonals: all of them but perhaps the first and the last; the best of these.

    Returns
    -------
    _Path or None
        None if no choice keeps the demand.
    """
    best: dict[int, _Path] = {-1: _Path(None, ())}
    for i, j in _spans(len(face.cuts)):
        before = best.get(i)
        found = best_triangulation(face.ring(i, j), demand) if before else None
        if before is None or found is None:
            continue
        path = before.then(i, j, found)
        if j not in best or path.rank > best[j].rank:
            best[j] = path
    return best.get(len(face.cuts))


def _spans(cuts: int) -> Iterator[tuple[int, int]]:
    """The pieces allowed, as pairs of cuts, each after all that end where it begins."""
    for i in range(-1, cuts):
        yield i, i + 1
        if i + 2 <= cuts and (i == -1 or i + 2 == cuts):
            yield i, i + 2
    if cuts == 2:
        yield -1, cuts  # both left out


Chooser = Callable[[Cuttable, Demand], _Path | None]
"""A way to choose diagonals."""


def project(
    face: Cuttable, demands: Sequence[tuple[Chooser, Demand]], first_number: int
) -> tuple[Projected, list[HPoint]]:
    """Cut a merged face up and triangulate it, by the first demand that can be kept.

    Parameters
    ----------
    face : Cuttable
        M with its diagonals.
    demands : sequence of (chooser, Demand)
        `fewest_cuts` or `best_cuts` and what for, in order of preference.
    first_number : int
        The node that the first new Steiner point becomes.

    Returns
    -------
    Projected
        With its triangles.
    points : list of HPoint
        The new Steiner points on the edge.
    """
    path = None
    for choose, demand in demands:
        path = choose(face, demand)
        if path:
            break
    if path is None:
        raise UncutFace(f"merged face {face.merged}")
    used = [j for _, j, _ in path.pieces[:-1]]
    number = {j: first_number + k for k, j in enumerate(used)}
    pieces = []
    for i, j, found in path.pieces:
        ring = face.nodes(i, j, number.__getitem__)
        pieces.append((ring, tuple((ring[a], ring[b], ring[c]) for a, b, c in found.triangles)))
    cuts = tuple((face.merged.staircase[face.cuts[j]], number[j]) for j in used)
    return Projected(face.merged, cuts, tuple(pieces)), [face.projections[j] for j in used]


class UncutFace(Exception):
    """A merged face that no choice of diagonals lets be triangulated."""
