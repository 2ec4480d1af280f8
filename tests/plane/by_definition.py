"""What the plane's algorithms compute, by the definitions and in quadratic time or worse."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, pairwise

from gmpy2 import mpq

from bern_exact.exact.points import HPoint, along, coordinates
from bern_exact.exact.predicates import orientation, squared_distance
from bern_exact.plane.polygon import Polygon

Rings = Sequence[Sequence[HPoint]]
Edge = tuple[int, int]
"""[ring, index] of its tail."""


def on_segment(p: HPoint, a: HPoint, b: HPoint) -> bool:
    """Is p on the closed segment ab?"""
    if orientation(a, b, p) != 0:
        return False
    (px, py), (ax, ay), (bx, by) = coordinates(p), coordinates(a), coordinates(b)
    return (px - ax) * (px - bx) + (py - ay) * (py - by) <= 0


def inside(p: HPoint, a: HPoint, b: HPoint) -> bool:
    """Is p strictly between a and b, on their segment?"""
    return p not in (a, b) and on_segment(p, a, b)


def meeting(a: HPoint, b: HPoint, c: HPoint, d: HPoint) -> str | None:
    """How two edges without a common end meet: cross, touch, overlap or not at all."""
    if orientation(a, b, c) == 0 == orientation(a, b, d):
        touching = inside(c, a, b) or inside(d, a, b) or inside(a, c, d)
        return "edges-overlap" if touching else None
    if any(inside(*triple) for triple in ((c, a, b), (d, a, b), (a, c, d), (b, c, d))):
        return "edges-touch"
    if (
        orientation(a, b, c) * orientation(a, b, d) < 0
        and orientation(c, d, a) * orientation(c, d, b) < 0
    ):
        return "edges-cross"
    return None


def encloses(ring: Sequence[HPoint], p: HPoint) -> bool:
    """Is p inside the simple ring (p not on it)?  By crossings of a ray to the right."""
    x, y = coordinates(p)
    result = False
    for i, q in enumerate(ring):
        (ax, ay), (bx, by) = coordinates(q), coordinates(ring[i - 1])
        if (ay <= y) != (by <= y) and ax + (bx - ax) * (y - ay) / (by - ay) > x:
            result = not result
    return result


def vertex_defects(rings: Rings) -> list[str]:
    """The kinds of defect that a look at the vertices shows, most basic first."""
    found = []
    if not rings or any(len(ring) < 3 for ring in rings):
        found.append("too-few-vertices")
    if any(len(set(ring)) < len(ring) for ring in rings):
        found.append("repeated-vertex")
    if any(set(first) & set(second) for first, second in combinations(rings, 2)):
        found.append("edges-touch")
    if any(all(orientation(r[0], r[1], p) == 0 for p in r) for r in rings if len(r) > 2):
        found.append("zero-area")
    if any(is_spike(r[i - 1], r[i], r[(i + 1) % len(r)]) for r in rings for i in range(len(r))):
        found.append("spike")
    return found


def is_spike(before: HPoint, apex: HPoint, after: HPoint) -> bool:
    """Do the two edges at the apex leave in the same direction?"""
    (bx, by), (vx, vy), (ax, ay) = coordinates(before), coordinates(apex), coordinates(after)
    product = (bx - vx) * (ax - vx) + (by - vy) * (ay - vy)
    return orientation(before, apex, after) == 0 and product > 0


def edge_defects(rings: Rings) -> dict[frozenset[Edge], str]:
    """How each pair of edges without a common vertex meets, if it does."""
    edges = [(r, i) for r, ring in enumerate(rings) for i in range(len(ring))]
    ends = {(r, i): (rings[r][i], rings[r][(i + 1) % len(rings[r])]) for r, i in edges}
    found = {}
    for e, f in combinations(edges, 2):
        if not set(ends[e]) & set(ends[f]):
            kind = meeting(*ends[e], *ends[f])
            if kind:
                found[frozenset((e, f))] = kind
    return found


def nesting_defects(rings: Rings) -> set[tuple[str, int]]:
    """(kind, hole) for each hole outside the outer ring or inside another hole."""
    found = set()
    for r, ring in enumerate(rings[1:], 1):
        if not encloses(rings[0], ring[0]):
            found.add(("hole-outside", r))
        if any(encloses(other, ring[0]) for k, other in enumerate(rings[1:], 1) if k != r):
            found.add(("hole-in-hole", r))
    return found


def is_polygon(rings: Rings) -> bool:
    """Are these the rings of a polygon with holes?"""
    return not (vertex_defects(rings) or edge_defects(rings) or nesting_defects(rings))


def twice_area(ring: Sequence[HPoint]) -> mpq:
    """Twice the signed area."""
    area = mpq(0)
    for i, q in enumerate(ring):
        (ax, ay), (bx, by) = coordinates(ring[i - 1]), coordinates(q)
        area += ax * by - bx * ay
    return area


def sees(polygon: Polygon, p: HPoint, q: HPoint) -> bool:
    """Does the closed segment from p to q, two boundary points, lie in the closed polygon?

    It is cut at every edge's line; each piece lies in the polygon or outside as its middle does.
    """
    (px, py), (qx, qy) = coordinates(p), coordinates(q)
    cuts = {mpq(0), mpq(1)}
    for a, b, c in polygon.lines:
        start, end = a * px + b * py + c, a * qx + b * qy + c
        if start != end:
            t = start / (start - end)
            if 0 < t < 1:
                cuts.add(t)
    ordered = sorted(cuts)
    return all(
        is_within(polygon, along(p, q, (first + second) / 2)) for first, second in pairwise(ordered)
    )


def is_within(polygon: Polygon, p: HPoint) -> bool:
    """Is p in the closed polygon?"""
    rings = [[polygon.points[v] for v in ring] for ring in polygon.rings]
    if any(on_segment(p, polygon.points[v], polygon.points[w]) for v, w in polygon.edges()):
        return True
    return encloses(rings[0], p) and not any(encloses(ring, p) for ring in rings[1:])


def nearest_on(p: HPoint, a: HPoint, b: HPoint) -> HPoint:
    """The point of the closed segment ab that is nearest to p."""
    (px, py), (ax, ay), (bx, by) = coordinates(p), coordinates(a), coordinates(b)
    t = ((px - ax) * (bx - ax) + (py - ay) * (by - ay)) / ((bx - ax) ** 2 + (by - ay) ** 2)
    return along(a, b, min(max(t, mpq(0)), mpq(1)))


def feature_size_by_definition(polygon: Polygon) -> tuple[mpq, int, int]:
    """(s^2, vertex or -1, edge), the first in this order: all edges, all pairs that are seen."""
    points = polygon.points
    found = [(squared_distance(points[v], points[w]), -1, v) for v, w in polygon.edges()]
    for v in range(polygon.n):
        for e, head in polygon.edges():
            if v not in (e, head):
                foot = nearest_on(points[v], points[e], points[head])
                pair = (squared_distance(points[v], foot), v, e)
                if pair < min(found) and sees(polygon, points[v], foot):
                    found.append(pair)
    return min(found)
