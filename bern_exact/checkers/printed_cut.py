"""Lemma 1 as printed: the paper's cutting line, on certified enclosures.

The paper cuts an isosceles triangle off the acute vertex v so that its base
crosses vw a third of the way from v.  With w - v = a p + b q in the two edges p
and q at v, the legs are (a |p| + b |q|)/3 long, up to sqrt 2/3 |vw|: more than
the third that the proof of Lemma 1 allows from each end.  The legs being
irrational, all is computed on intervals with rational ends.
"""

from __future__ import annotations

from collections.abc import Sequence

from gmpy2 import mpq

from bern_exact.boundary.records import Cut, Lopped
from bern_exact.checkers import bounds
from bern_exact.checkers.extremes import plain
from bern_exact.checkers.findings import Exact, Finding
from bern_exact.exact.points import HPoint, coordinates, hpoint
from bern_exact.exact.predicates import squared_distance_to_segment
from bern_exact.exact.roots import sqrt_below
from bern_exact.plane.feature_size import FeatureSize
from bern_exact.plane.polygon import Polygon

LARGEST = 1000
"""Vertices of P' up to which all pairs are measured; beyond it the claim has no case."""

SPARE_BITS = 64
"""Bits of the cuts' enclosures beyond those that tell the longest edge from s."""

Interval = tuple[mpq, mpq]
Box = tuple[Interval, Interval]


def check_printed_cut(lopped: Lopped, feature: FeatureSize) -> list[Finding]:
    """Lemma 1's "feature size of P' is at least s/3" for the paper's own P'.

    Parameters
    ----------
    lopped : Lopped
        P, and which vertices are cut towards which.
    feature : FeatureSize
        s, of P.

    Returns
    -------
    list of Finding
        One, role "as-printed": an enclosure of (s'/s)^2.  The claim fails if all of
        the enclosure is below 1/9.  No case if P' is too large or nothing is cut.

    Notes
    -----
    Quadratic time.
    """
    small = lopped.lopped.n <= LARGEST and lopped.cuts
    search = _least_distance(lopped, feature) if small else None
    measured: Exact = None
    holds, witness = True, None
    if search is not None:
        low, high = (end / feature.squared for end in search.enclosure)
        measured = {"lower": str(_rounded(low, up=False)), "upper": str(_rounded(high, up=True))}
        holds = bool(high >= bounds.LOPPED_FEATURE_SQUARED)
        witness = plain(search.witness)
    return [
        Finding(
            "lemma-1.printed-feature-size",
            "lopped",
            "with the paper's cutting line, across vw at a third, the feature size s' of P' is at "
            "least s/3 ((s'/s)^2)",
            "as-printed",
            str(bounds.LOPPED_FEATURE_SQUARED),
            measured,
            search.cases if search is not None else 0,
            holds,
            witness,
        )
    ]


def _rounded(value: mpq, *, up: bool) -> mpq:
    """The next multiple of 2^-64 below or above."""
    scaled = value * 2**64
    floor = scaled.numerator // scaled.denominator
    return mpq(floor + (up and floor != scaled), 2**64)


def _least_distance(lopped: Lopped, feature: FeatureSize) -> _Search:
    """The enclosure of s'^2 for the paper's P'."""
    boxes = printed_boxes(lopped, feature)
    search = _Search(lopped.lopped, boxes)
    search.run()
    return search


def printed_boxes(lopped: Lopped, feature: FeatureSize) -> list[Box]:
    """A box around each vertex of the paper's P'; a point where it is a vertex of P."""
    polygon = lopped.polygon
    longest = max(_exact_squared(polygon, v) for v in range(polygon.n))
    bits = SPARE_BITS + int(longest / feature.squared).bit_length()
    boxes: list[Box] = []
    for p in lopped.lopped.points:
        x, y = coordinates(p)
        boxes.append(((x, x), (y, y)))
    for cut in lopped.cuts:
        for end, box in zip((cut.after, cut.before), _cut_boxes(polygon, cut, bits), strict=True):
            boxes[end] = box
    return boxes


def _exact_squared(polygon: Polygon, edge: int) -> mpq:
    (ax, ay), (bx, by) = (coordinates(polygon.points[v]) for v in (edge, polygon.after[edge]))
    return (bx - ax) ** 2 + (by - ay) ** 2


def _cut_boxes(polygon: Polygon, cut: Cut, bits: int) -> tuple[Box, Box]:
    """Boxes around the ends of the paper's cut, on the edges out of and into the corner."""
    points = polygon.points
    vx, vy = coordinates(points[cut.corner])
    ends = (polygon.after[cut.corner], polygon.before[cut.corner], cut.nearest)
    (px, py), (qx, qy), (wx, wy) = (
        (x - vx, y - vy) for x, y in (coordinates(points[v]) for v in ends)
    )
    area = px * qy - py * qx
    a, b = (wx * qy - wy * qx) / area, (px * wy - py * wx) / area
    ratio = (qx * qx + qy * qy) / (px * px + py * py)  # |q|^2/|p|^2
    along_p = _fraction(a, b, ratio, bits)
    along_q = _fraction(b, a, 1 / ratio, bits)
    corner: Box = ((vx, vx), (vy, vy))
    return _moved(corner, px, py, along_p), _moved(corner, qx, qy, along_q)


def _fraction(own: mpq, other: mpq, ratio: mpq, bits: int) -> Interval:
    """(own + other sqrt(ratio))/3, both coefficients at least 0."""
    root = sqrt_below(ratio, bits)
    above = root if root * root == ratio else root * (1 + mpq(1, 2 ** (bits - 1)))
    return (own + other * root) / 3, (own + other * above) / 3


def _moved(corner: Box, dx: mpq, dy: mpq, t: Interval) -> Box:
    return _plus(corner[0], _times((dx, dx), t)), _plus(corner[1], _times((dy, dy), t))


class _Search:
    """Definition 1 on boxes: an enclosure of the least squared distance over all pairs."""

    def __init__(self, polygon: Polygon, boxes: Sequence[Box]) -> None:
        self.polygon = polygon
        self.boxes = boxes
        self.middles = [hpoint((x[0] + x[1]) / 2, (y[0] + y[1]) / 2) for x, y in boxes]
        self.low: mpq | None = None
        self.high: mpq | None = None
        self.witness: object = None
        self.cases = 0

    @property
    def enclosure(self) -> Interval:
        """The ends of the enclosure."""
        zero = mpq(0)
        return self.low if self.low is not None else zero, self.high or zero

    def run(self) -> None:
        """All edges, then all pairs that the middles do not rule out by far."""
        for tail, head in self.polygon.edges():
            run = _minus(self.boxes[head], self.boxes[tail])
            self._offer(_dot(run, run), 1, {"edge of P'": tail})
        for vertex in range(self.polygon.n):
            for edge, head in self.polygon.edges():
                if vertex not in (edge, head):
                    self._measure(vertex, edge, head)

    def _measure(self, vertex: int, edge: int, head: int) -> None:
        self.cases += 1
        middle: list[HPoint] = [self.middles[v] for v in (vertex, edge, head)]
        if self.high is not None and squared_distance_to_segment(*middle) > 4 * self.high:
            return
        p, a, b = (self.boxes[v] for v in (vertex, edge, head))
        along, from_a, from_b = _minus(b, a), _minus(p, a), _minus(p, b)
        before_a, beyond_b = _dot(along, from_a), _dot(along, from_b)
        witness = {"vertex of P'": vertex, "edge of P'": edge}
        if before_a[0] <= 0:
            end = self._in_wedge(vertex, _minus(a, p))
            self._offer(_dot(from_a, from_a), end if before_a[1] <= 0 else min(end, 0), witness)
        if beyond_b[1] >= 0:
            end = self._in_wedge(vertex, _minus(b, p))
            self._offer(_dot(from_b, from_b), end if beyond_b[0] >= 0 else min(end, 0), witness)
        if before_a[1] > 0 and beyond_b[0] < 0:
            area = _cross(along, from_a)
            inward = along[1], (-along[0][1], -along[0][0])  # turned right: from v to the edge
            foot = self._in_wedge(vertex, inward) if area[1] > 0 else -1  # v on the outer side
            sure = before_a[0] > 0 and beyond_b[1] < 0 and area[0] > 0
            squared = _quotient(_square(area), _dot(along, along))
            self._offer(squared, foot if sure else min(foot, 0), witness)

    def _in_wedge(self, vertex: int, run: Box) -> int:
        """Is the direction in the vertex's wedge?  1 certainly, -1 certainly not, 0 unknown."""
        polygon, box = self.polygon, self.boxes[vertex]
        out = _minus(self.boxes[polygon.after[vertex]], box)
        back = _minus(self.boxes[polygon.before[vertex]], box)
        sides = _cross(out, run), _cross(run, back)
        turn = _cross(out, back)
        certain = [low >= 0 for low, _ in sides]
        possible = [high >= 0 for _, high in sides]
        if all(certain) or (any(certain) and turn[1] < 0):
            return 1
        if not any(possible) or (not all(possible) and turn[0] >= 0):
            return -1
        return 0

    def _offer(self, squared: Interval, certainty: int, witness: object) -> None:
        """One candidate: it bounds s'^2 from above only if it certainly is one."""
        if certainty < 0:
            return
        if self.low is None or squared[0] < self.low:
            self.low = squared[0]
        if certainty > 0 and (self.high is None or squared[1] < self.high):
            self.high, self.witness = squared[1], witness


def _plus(u: Interval, v: Interval) -> Interval:
    return u[0] + v[0], u[1] + v[1]


def _times(u: Interval, v: Interval) -> Interval:
    products = [x * y for x in u for y in v]
    return min(products), max(products)


def _square(u: Interval) -> Interval:
    low, high = sorted((u[0] * u[0], u[1] * u[1]))
    return (mpq(0) if u[0] <= 0 <= u[1] else low), high


def _quotient(u: Interval, v: Interval) -> Interval:
    """u/v for u >= 0 and v > 0."""
    return u[0] / v[1], u[1] / v[0]


def _minus(p: Box, q: Box) -> Box:
    (px, py), (qx, qy) = p, q
    return (px[0] - qx[1], px[1] - qx[0]), (py[0] - qy[1], py[1] - qy[0])


def _dot(u: Box, v: Box) -> Interval:
    if u is v:
        return _plus(_square(u[0]), _square(u[1]))
    return _plus(_times(u[0], v[0]), _times(u[1], v[1]))


def _cross(u: Box, v: Box) -> Interval:
    low, high = _times(u[1], v[0])
    return _plus(_times(u[0], v[1]), (-high, -low))
