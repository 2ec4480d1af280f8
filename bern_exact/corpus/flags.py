"""The vocabulary of flags: what a case has, and so the kind of bug that it hunts.

Most flags are measured on the polygon, exactly; a few say where a case comes from.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from gmpy2 import mpq

from bern_exact.corpus.draws import Rings, is_polygon, moved, places
from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import nearest_binary64
from bern_exact.exact.points import HPoint, direction
from bern_exact.exact.predicates import cross, dot, side, squared_distance
from bern_exact.facts import Facts, facts_of, is_acute, turn
from bern_exact.plane.polygon import Polygon

FLAGS: Mapping[str, str] = {
    "bad": "no polygon: must be refused",
    "near-miss": "good or bad by less than 10^-30 of its size: hunts tolerances",
    "listed": "one of a short list or without randomness: other seeds may give it again",
    "erratum": "refutes a sentence of the paper as printed: hunts constructions by the letter",
    "real": "a real outline: hunts what made-up polygons hide",
    "convex": "no hole and no reflex vertex: Theorem 4 applies",
    "reflex": "an interior angle above 180 degrees: hunts code for convex polygons",
    "holes": "at least one hole: hunts holes that are forgotten or filled",
    "many-holes": "at least six holes: hunts what grows with their number",
    "flat-vertices": "a vertex of 180 degrees: hunts dropped and merged vertices",
    "near-flat": "an angle within 1/1000 of 180 degrees, not equal: hunts tolerances for lines",
    "right-angles": "an angle of exactly 90 or 270 degrees: hunts signs of zero",
    "near-right": "an angle within 1/1000 of 90 or 270 degrees, not equal: hunts tolerances",
    "acute": "an interior angle below 90 degrees: hunts corners that must be cut off",
    "needle": "an interior angle below 1/50 (1.15 degrees): hunts promises of a least angle",
    "axis-parallel": "a horizontal or vertical edge: hunts sweeps and grids in general position",
    "rectilinear": "every edge is horizontal or vertical",
    "diagonal": "an edge at exactly 45 degrees: hunts ties between rows and columns",
    "collinear": "a vertex on the line of an edge that does not end there: hunts orientations of 0",
    "cocircular": "four consecutive vertices on one circle: hunts in-circle tests of 0",
    "ties": "two edges of the same length: hunts choices that depend on order or rounding",
    "uneven-edges": "edges of lengths 1 and more than 1000: hunts one size for all",
    "thin": "a feature size below a thousandth of the diameter: hunts absolute tolerances",
    "slender": "an area below a thousandth of the squared diameter: hunts bad aspect ratios",
    "needs-rationals": "a coordinate that no double holds: hunts rounding on the way in",
    "rounds-to-invalid": "no polygon once its coordinates are rounded to doubles",
    "huge": "a coordinate of 2^53 or more: hunts integers in doubles",
    "tiny": "within a square of side 10^-6: hunts absolute tolerances",
    "far-away": "farther from the origin than 10^9 times its size: hunts cancellation",
    "many-digits": "a numerator and denominator of 2^64 or more: hunts machine integers",
    "beyond-doubles": "a coordinate that is beyond all doubles or vanishes among them",
}
"""What each flag means, in the order in which they are given."""

DECLARED = ("bad", "near-miss", "listed", "erratum", "real")
"""The flags that a family gives its members; all others are measured."""

_ALMOST = 1000
_DOUBLE_BITS = 53


def in_order(flags: Sequence[str]) -> tuple[str, ...]:
    """The flags, each once, in the order of the vocabulary."""
    return tuple(flag for flag in FLAGS if flag in flags)


def polygon_flags(polygon: Polygon) -> Iterator[str]:
    """The measured flags of a polygon, not in order.

    Notes
    -----
    O(n^2), for `collinear`.
    """
    facts = facts_of(polygon)
    for flag, holds in _SHAPE.items():
        if holds(facts):
            yield flag
    yield from _angle_flags(polygon)
    yield from _edge_flags(polygon)
    rings = places([polygon.input_ring(r) for r in range(len(polygon.rings))])
    yield from number_flags(rings)
    if not is_polygon(moved(rings, lambda x, y: (_as_double(mpq(x)), _as_double(mpq(y))))):
        yield "rounds-to-invalid"


_SHAPE: Mapping[str, Callable[[Facts], bool]] = {
    "convex": lambda facts: facts.convex,
    "holes": lambda facts: facts.polygon.holes > 0,
    "many-holes": lambda facts: facts.polygon.holes >= 6,
    "acute": lambda facts: bool(facts.acute),
    "thin": lambda facts: _ALMOST**2 * facts.feature.squared < facts.diameter_squared,
    "slender": lambda facts: _ALMOST * facts.polygon.area < facts.diameter_squared,
    "collinear": lambda facts: _has_vertex_on_a_line(facts.polygon),
    "cocircular": lambda facts: _has_four_on_a_circle(facts.polygon),
}


def _angle_flags(polygon: Polygon) -> Iterator[str]:
    for v in range(polygon.n):
        apex, turned = polygon.points[v], turn(polygon, v)
        back = direction(apex, polygon.points[polygon.before[v]])
        ahead = direction(apex, polygon.points[polygon.after[v]])
        area, along = cross(ahead, back), dot(ahead, back)
        if turned <= 0:
            yield "reflex" if turned else "flat-vertices"
        if turned and along < 0 and _ALMOST * abs(area) < -along:
            yield "near-flat"
        if along == 0:
            yield "right-angles"
        elif _ALMOST * abs(along) < abs(area):
            yield "near-right"
        if is_acute(polygon, v) and 50 * area < along:
            yield "needle"


def _edge_flags(polygon: Polygon) -> Iterator[str]:
    edges = [direction(polygon.points[v], polygon.points[w]) for v, w in polygon.edges()]
    if any(x == 0 or y == 0 for x, y in edges):
        yield "axis-parallel"
    if all(x == 0 or y == 0 for x, y in edges):
        yield "rectilinear"
    if any(abs(x) == abs(y) for x, y in edges):
        yield "diagonal"
    lengths = [squared_distance(polygon.points[v], polygon.points[w]) for v, w in polygon.edges()]
    if len(set(lengths)) < len(lengths):
        yield "ties"
    if max(lengths) > _ALMOST**2 * min(lengths):
        yield "uneven-edges"


def _has_vertex_on_a_line(polygon: Polygon) -> bool:
    """Is a vertex on the line of an edge that does not end there?"""
    return any(
        side(polygon.lines[v], p) == 0
        for v, w in polygon.edges()
        for u, p in enumerate(polygon.points)
        if u not in (v, w)
    )


def _has_four_on_a_circle(polygon: Polygon) -> bool:
    """Are four consecutive vertices of a ring on one circle, no three of them on a line?"""
    for ring in polygon.rings:
        for i in range(len(ring) if len(ring) > 4 else len(ring) // 4):
            four = [polygon.points[ring[(i + k) % len(ring)]] for k in range(4)]
            if _on_one_circle(four):
                return True
    return False


def _on_one_circle(four: Sequence[HPoint]) -> bool:
    """Do four points see each other as on a circle: equal angles over the first edge?"""
    a, b, c, d = four
    at_c = direction(c, a), direction(c, b)
    at_d = direction(d, a), direction(d, b)
    areas = cross(*at_c), cross(*at_d)
    return (
        0 not in areas
        and cross(direction(a, c), direction(a, d)) != 0
        and areas[0] * dot(*at_d) == areas[1] * dot(*at_c)
    )


def number_flags(rings: Rings) -> Iterator[str]:
    """The flags that coordinates show, of a polygon or of what is none."""
    numbers = [mpq(number) for ring in rings for place in ring for number in place]
    if any(_as_double(value) != value for value in numbers):
        yield "needs-rationals"
    if any(abs(value) >= 2**_DOUBLE_BITS for value in numbers):
        yield "huge"
    if any(min(abs(v.numerator), v.denominator) >= 2**64 for v in numbers):
        yield "many-digits"
    if any(_is_beyond_doubles(value) for value in numbers):
        yield "beyond-doubles"
    if numbers:
        size = max(max(axis) - min(axis) for axis in (numbers[::2], numbers[1::2]))
        if 0 < size * 10**6 <= 1:
            yield "tiny"
        if 0 < size * 10**9 < max(_distance(axis) for axis in (numbers[::2], numbers[1::2])):
            yield "far-away"


def _distance(axis: Sequence[mpq]) -> mpq:
    """The distance of 0 from the range of some coordinates."""
    return max(min(axis), -max(axis), mpq(0))


def _is_beyond_doubles(value: mpq) -> bool:
    """Does a number overflow as a double, or vanish?"""
    try:
        return value != 0 and nearest_binary64(value) == 0
    except InputError:
        return True


def _as_double(value: mpq) -> mpq:
    """The nearest double; beyond all of them any that is wrong."""
    try:
        return nearest_binary64(value)
    except InputError:
        return mpq(0)
