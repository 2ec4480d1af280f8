"""Projecting staircase vertices onto an edge (Section 3, Lemma 5).

"Project all vertices of the staircase, except the first and last, diagonally
onto e": a diagonal leaves an almost axis-parallel edge at 45 degrees or nearly so, and
hits e at 45 degrees or more, so the trapezoids between have no large angle.  The height
at the two end faces does not "come for free": a projection can land next to the
end of e.  So the first and the last diagonal may be left out, and the end
pieces are triangulated by the best of all ways.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from gmpy2 import mpq

from bern_exact.boundary.optimal import Demand, Triangulated, best_triangulation
from bern_exact.boundary.records import MergedFace, Node, Projected
from bern_exact.exact.points import HPoint, Line, meet


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
        last = len(self.cuts)
        low = 1 if i < 0 else self.cuts[i]
        high = len(self.staircase) - 1 if j == last else self.cuts[j] + 1
        start = self.staircase[0] if i < 0 else self.projections[i]
        end = self.staircase[-1] if j == last else self.projections[j]
        return [start, end, *reversed(self.staircase[low:high])]

    def nodes(self, i: int, j: int, number: Callable[[int], Node]) -> tuple[Node, ...]:
        """The same piece as nodes; `number` gives the node of a cut's projection."""
        stairs, last = self.merged.staircase, len(self.cuts)
        low = 1 if i < 0 else self.cuts[i]
        high = len(stairs) - 1 if j == last else self.cuts[j] + 1
        start = stairs[0] if i < 0 else number(i)
        end = stairs[-1] if j == last else number(j)
        return (start, end, *reversed(stairs[low:high]))


def cuttable(merged: MergedFace, line: Line, points: Sequence[HPoint]) -> Cuttable:
    """Find the diagonals of a merged face.

    Parameters
    ----------
    merged : MergedFace
        M, along the edge with this line.
    line : Line
        The edge's line, in grid coordinates; neither axis-parallel nor diagonal.
    points : sequence of HPoint
        The staircase's points.
    """
    # Along diagonals t is constant: t = x + y if e has positive slope, else x - y.
    slope = -1 if line[0] * line[1] > 0 else 1
    levels = [(x + slope * y, w) for x, y, w in points]
    t = [mpq(level, w) for level, w in levels]
    low, high = min(t[0], t[-1]), max(t[0], t[-1])
    cuts = [i for i in range(1, len(points) - 1) if low < t[i] < high]
    projections = [meet((levels[i][1], slope * levels[i][1], -levels[i][0]), line) for i in cuts]
    return Cuttable(merged, points, cuts, projections)


@dataclass(frozen=True)
class _Path:
    """The best way to cut a face from its first end to a cut."""

    value: mpq
    pieces: tuple[tuple[int, int, Triangulated], ...]

    @property
    def rank(self) -> tuple[mpq, int]:
        """What is compared: the worst piece, then few pieces."""
        return self.value, -len(self.pieces)


def best_cuts(face: Cuttable, demand: Demand) -> _Path | None:
    """Choose diagonals: all of them but perhaps the first and the last; the best of these.

    Returns
    -------
    _Path or None
        None if no choice keeps the demand.
    """
    best: dict[int, _Path] = {}
    for i, j in _spans(len(face.cuts)):
        before = best.get(i)
        if i >= 0 and before is None:
            continue
        found = best_triangulation(face.ring(i, j), demand)
        if found is None:
            continue
        value = found.value if before is None else min(before.value, found.value)
        pieces = (*(before.pieces if before else ()), (i, j, found))
        path = _Path(value, pieces)
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


def project(
    face: Cuttable, demands: Sequence[Demand], first_number: int
) -> tuple[Projected, list[HPoint]]:
    """Cut a merged face up and triangulate it, by the first demand that can be kept.

    Parameters
    ----------
    face : Cuttable
        M with its diagonals.
    demands : sequence of Demand
        In order of preference.
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
    for demand in demands:
        path = best_cuts(face, demand)
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
