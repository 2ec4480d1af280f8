"""Definition 1: certifies a feature size by another algorithm than the one that found it.

What has to be shown is that s is attained by the named pair, and that no
vertex and non-incident edge are closer than s within P.  The first is one
exact distance.  For the second it is enough to look at few pairs:

**Claim.** Let d be the feature size, attained by vertex v and edge e, their
shortest segment vf inside P.  Take any two perpendicular lines through v, and of
their four rays one within 45 degrees of vf, meeting the line of e in h.  Either
an end w of e lies on the closed segment fh, and |vw| <= sqrt 2 d; or e is the first
edge that the ray meets.

*Proof.* In the right triangle v f h the angle at v is at most 45 degrees, so
|fh| <= d and |vh| <= sqrt 2 d.  If no end of e lies on fh, then h is on e.  Suppose that
another edge meets vh before h.  Seen from fh perpendicularly, the first thing met
above f is v, hence the hypotenuse vh; walking from f to h, look at the first
place where something else comes first.  Either that is an end of an edge, below
the hypotenuse; or an edge comes in through the hypotenuse, and since it cannot
meet e it ends below the hypotenuse, and walking on along what comes first we get to its
end or to the end of a lower edge.  In each case some vertex has an
unobstructed perpendicular onto e that is shorter than d, on the interior side of e,
against the minimality of d.  (A vertex on vh itself is one too.)  QED.

So the candidates are: for each vertex the first edges met by four rays, which
two sweeps give, and the edges at each two vertices within sqrt 2 s, which a hash
grid gives.  The rays are turned by an infinitesimal angle (coordinates are
compared lexicographically), so that none meets a vertex.

Conversely a candidate closer than s whose shortest segment leaves v into the
wedge of v shows that the feature size is below s: what obstructs the segment has
a vertex that is closer still.  Time O(n log n + k) for k pairs of vertices within
1.5 s (also across the exterior), but for the list operations of the sweeps,
which move memory.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence

from gmpy2 import isqrt, mpq, mpz

from bern_exact.checkers.extremes import plain
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.sweep import first_edges
from bern_exact.exact.points import HPoint
from bern_exact.exact.predicates import (
    is_in_wedge,
    squared_distance,
    squared_distance_to_segment,
)
from bern_exact.plane.feature_size import FeatureSize
from bern_exact.plane.polygon import Polygon

STATEMENT = (
    "the feature size squared is attained by the named vertex and edge, "
    "and no vertex is closer to a non-incident edge within the polygon"
)


def check_definition_1(
    polygon: Polygon,
    feature: FeatureSize,
    *,
    claim: str = "definition-1.feature-size",
    stage: str = "feature-size",
) -> list[Finding]:
    """Certify the feature size of a polygon (Definition 1).

    Parameters
    ----------
    polygon : Polygon
        A valid polygon.
    feature : FeatureSize
        Its alleged feature size, squared, and where it is attained.
    claim, stage : str
        The finding's id and stage: the check serves P and P'.

    Returns
    -------
    list of Finding
        One.  `bound` is the alleged s^2, `measured` the least squared distance among
        the candidates; `cases` counts the edges and pairs that were measured.
    """
    search = _Search(polygon, feature.squared)
    measured = search.least()
    attained = _attains(polygon, feature)
    holds = attained and measured == feature.squared
    witness = search.witness if measured is not None and measured < feature.squared else None
    if not attained:
        witness = {"not attained by": {"vertex": feature.vertex, "edge": feature.edge}}
    return [
        Finding(
            claim,
            stage,
            STATEMENT,
            "guarantee",
            str(feature.squared),
            None if measured is None else str(measured),
            search.cases,
            holds,
            plain(witness),
        )
    ]


def _attains(polygon: Polygon, feature: FeatureSize) -> bool:
    """Does the named pair (or edge) have exactly this squared distance, inside the wedge?"""
    if not 0 <= feature.edge < polygon.n:
        return False
    if feature.vertex is None:
        tail, head = feature.edge, polygon.after[feature.edge]
        return squared_distance(polygon.points[tail], polygon.points[head]) == feature.squared
    if not 0 <= feature.vertex < polygon.n:
        return False
    if feature.vertex in (feature.edge, polygon.after[feature.edge]):
        return False
    return admissible_distance(polygon, feature.vertex, feature.edge) == feature.squared


def admissible_distance(polygon: Polygon, vertex: int, edge: int) -> mpq | None:
    """dist(v, e)^2 if the shortest segment leaves v into its wedge, else None."""
    points = polygon.points
    p, a, b = points[vertex], points[edge], points[polygon.after[edge]]
    nearest = _nearest_point(p, a, b)
    before, after = points[polygon.before[vertex]], points[polygon.after[vertex]]
    if not is_in_wedge(nearest, before, p, after):
        return None
    return squared_distance_to_segment(p, a, b)


def _nearest_point(p: HPoint, a: HPoint, b: HPoint) -> HPoint:
    """The point of the segment ab nearest to p, up to reduction."""
    px, py, pw = p
    ax, ay, aw = a
    bx, by, bw = b
    ux, uy = bx * aw - ax * bw, by * aw - ay * bw  # aw bw (b - a)
    vx, vy = px * aw - ax * pw, py * aw - ay * pw  # aw pw (p - a)
    forward = ux * vx + uy * vy  # aw^2 bw pw (b - a).(p - a)
    if forward <= 0:
        return a
    length = (ux * ux + uy * uy) * pw  # aw^2 bw^2 pw |b - a|^2
    if forward * bw >= length:
        return b
    # a + (forward bw / length) (b - a), and b - a = u/(aw bw).
    return ax * length + forward * ux, ay * length + forward * uy, aw * length


class _Search:
    """The least squared distance among the candidates of the claim above."""

    def __init__(self, polygon: Polygon, squared: mpq) -> None:
        self.polygon = polygon
        self.reach = squared
        self.best: mpq | None = None
        self.witness: object = None
        self.cases = 0

    def least(self) -> mpq | None:
        """The least over all edges and all candidate pairs within s."""
        polygon = self.polygon
        for tail, head in polygon.edges():
            length = squared_distance(polygon.points[tail], polygon.points[head])
            self._offer(length, {"edge": tail})
        for vertex, edge in self._pairs():
            self._measure(vertex, edge)
        return self.best

    def _pairs(self) -> Iterator[tuple[int, int]]:
        """Each candidate vertex and edge, some of them twice."""
        polygon = self.polygon
        turned = [(-y, x, w) for x, y, w in polygon.points]
        for points in (polygon.points, turned):
            for vertex, pair in enumerate(first_edges(points, polygon.after)):
                for edge in pair:
                    if edge >= 0:
                        yield vertex, edge
        for v, w in close_pairs(polygon.points, 2 * self.reach):
            yield v, w
            yield v, polygon.before[w]
            yield w, v
            yield w, polygon.before[v]

    def _measure(self, vertex: int, edge: int) -> None:
        """Offer one pair, if it is one."""
        head = self.polygon.after[edge]
        if vertex in (edge, head):
            return
        self.cases += 1
        points = self.polygon.points
        if not _is_within(points[vertex], points[edge], points[head], self.reach):
            return
        distance = admissible_distance(self.polygon, vertex, edge)
        if distance is not None:
            self._offer(distance, {"vertex": vertex, "edge": edge}, new=False)

    def _offer(self, distance: mpq, witness: object, *, new: bool = True) -> None:
        self.cases += new
        if self.best is None or distance < self.best:
            self.best, self.witness = distance, witness


def _is_within(p: HPoint, a: HPoint, b: HPoint, squared: mpq) -> bool:
    """Is p within this squared distance of the line ab?  (Necessary for the segment.)"""
    px, py, pw = p
    ax, ay, aw = a
    bx, by, bw = b
    ux, uy = bx * aw - ax * bw, by * aw - ay * bw
    vx, vy = px * aw - ax * pw, py * aw - ay * pw
    area = ux * vy - uy * vx  # aw^2 bw pw |b - a| dist
    scale = aw * pw
    return bool(
        area * area * squared.denominator <= squared.numerator * (ux * ux + uy * uy) * scale * scale
    )


def close_pairs(points: Sequence[HPoint], squared: mpq) -> Iterator[tuple[int, int]]:
    """All pairs of points at squared distance at most `squared` > 0, by a hash grid.

    Parameters
    ----------
    points : sequence of HPoint
        Distinct points.
    squared : mpq
        The squared reach.

    Yields
    ------
    (int, int)
        Each unordered pair once.
    """
    # A cell's side is the reach rounded up to about eight bits: cells three by three see all.
    scale = mpz(1)
    while squared * scale * scale < 2**16:
        scale *= 16
    side = isqrt(mpz(squared * scale * scale)) + 1  # side/scale >= the reach
    cells: dict[tuple[int, int], list[int]] = defaultdict(list)
    for i, (x, y, w) in enumerate(points):
        divisor = w * side
        column, row = int(x * scale // divisor), int(y * scale // divisor)
        for dx in (-1, 0, 1):
            for dy in (-1, 0, 1):
                for j in cells.get((column + dx, row + dy), ()):
                    if _is_close(points[i], points[j], squared):
                        yield j, i
        cells[column, row].append(i)


def _is_close(p: HPoint, q: HPoint, squared: mpq) -> bool:
    """Is |pq|^2 at most this?"""
    px, py, pw = p
    qx, qy, qw = q
    dx, dy, w = qx * pw - px * qw, qy * pw - py * qw, pw * qw
    return bool((dx * dx + dy * dy) * squared.denominator <= squared.numerator * w * w)
