"""The trusted judge: is this mesh a triangulation of this polygon, and how good is it?

Exact, standard library only, runs alone: ``python judge.py MESH.json [POLYGON.json]``; exit code
0 valid, 1 not, 3 unreadable.  Without POLYGON the mesh document's own "polygon" counts; without
that, the mesh must triangulate whatever its boundary encloses.

**Theorem.**  Let every triangle run counter-clockwise with positive area, no two vertices
coincide, every vertex be used, and every directed edge be used at most once.  Call a directed
edge whose reverse is unused a side.  (a) If along every line the sides do not overlap each other
and run just where the edges of a simple polygon run, the same way (interior on the left), then
the mesh is a triangulation of that polygon.  (b) If sides meet in common endpoints alone, and
next to each of them the triangles cover once on its left and not at all on its right, then the
mesh is a triangulation of the region that the sides enclose.

*Proof sketch.*  The number c(x) of triangles that cover x, a point off all edges, is the sum of
the winding numbers round x of their boundaries, each 0 or 1.  Winding numbers add up, and what
is run through both ways cancels: c(x) is the winding number of the sides.  (a) That is the one of
the polygon's boundary: 1 inside, 0 outside; and sides meet in endpoints alone, as the polygon's
edges do.  (b) c is constant on each face of the drawing of the sides, each bounded face lies next
to a side, and c = 0 far away: c is 0 or 1.  So interiors are disjoint and fill the region.
Suppose a vertex v lay inside an edge ab of a triangle t.  The triangles at v (it is used) do not
overlap t, so they fit in the half-plane beyond ab, and v is the end of a side.  So ab is no side,
and the triangle across ab overlaps those at v: a contradiction.  So triangles meet in common
vertices and common edges only.

What follows a first defect is diagnosis: it names and places the rest as well as it can and
decides nothing.  An angle is known by cos |cos|, a rational that falls as the angle grows.  Bounds
in degrees are decided by certified enclosures, refined until they decide: the squared cosine of a
rational number of degrees is irrational but for the multiples of 30 and 45 (Niven), taken exactly.
"""

from __future__ import annotations

import argparse
import functools
import json
import re
import sys
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

Point = tuple[Fraction, Fraction]
Edge = tuple[int, int]
Side = tuple[int, int, int]  # tail, head, how much more often used than its reverse
Piece = tuple[Point, Point, int, dict[str, Any]]  # from, to, how often, whose
Spot = tuple[Point, Point, Point]  # m, d, n: the point m + e n + e^2 d for all small e > 0

DIGITS, EXPONENT, ANGLE_TEXT = 100_000, 10_000, 1_000
NUMBER = re.compile(
    r"([+-]?)(?=\.?\d)(\d*)(?:/(\d+)|(?:\.(\d*))?(?:[eE]\+?(-?)0*(\d{1,9}))?)", re.ASCII
)
KNOWN = {n: Fraction(c, 4) for n, c in ((0, 4), (30, 3), (45, 2), (60, 1), (90, 0))}
CLASSES = {"le60": 1, "le90": 0, "le120": -1, "le135": -2, "le150": -3}  # 4 cos |cos|
DEFECTS = {
    "index-out-of-range": "triangle {triangle} names a vertex that is not there",
    "repeated-index": "triangle {triangle} names a vertex twice",
    "duplicate-vertex": "vertex {vertex} is at the same point as vertex {first}",
    "unused-vertex": "no triangle uses vertex {vertex}",
    "degenerate-triangle": "the corners of triangle {triangle} lie on one line",
    "clockwise-triangle": "triangle {triangle} runs clockwise",
    "edge-used-twice": "triangles {triangles} lie on the same side of edge {edge}",
    "polygon-vertex-missing": "the mesh has no vertex at polygon vertex {polygon_vertex}",
    "boundary-vertex-off-edge": "boundary vertex {vertex} lies on no edge of the polygon",
    "hanging-vertex": "vertex {vertex} lies inside edge {edge}",
    "crossing-edges": "the boundary edges {edge} and {other} cross",
    "boundary-not-simple": "the boundary edges {edge} and {other} cross",
    "overlap": "{covered} triangles cover the same place at {point}",
    "triangle-outside": "a triangle lies outside the polygon at {point}",
    "hole-filled": "a triangle lies in a hole of the polygon at {point}",
    "region-not-covered": "no triangle covers the polygon at {point}",
    "angle-above-bound": "triangle {triangle} has an angle above {bound}",
    "height-below-bound": "triangle {triangle} has a squared height below {bound}",
    "too-many-triangles": "there are {triangles} triangles, more than {bound}",
}


class Unreadable(ValueError):
    """Not a mesh, not a polygon, not a number."""


def number(value: object, place: str) -> Fraction:
    """An exact rational: an integer, or the text "-12", "p/q" or "-1.5e-3"."""
    if type(value) is int:
        return Fraction(value)
    match = NUMBER.fullmatch(value) if isinstance(value, str) else None
    if match is None:
        raise Unreadable(f"{place}: not an exact number: {str(value)[:40]!r}")
    sign, whole, below, decimals, down, power = match.groups(default="")
    if max(len(whole) + len(decimals), len(below)) > DIGITS or int(power or "0") > EXPONENT:
        raise Unreadable(f"{place}: the number is too long")
    top, bottom = int(sign + whole + decimals), int(below or "1") * 10 ** len(decimals)
    if bottom == 0:
        raise Unreadable(f"{place}: division by zero")
    scale = 10 ** int(power or "0")
    return Fraction(top, bottom * scale) if down else Fraction(top * scale, bottom)


def points(value: object, place: str) -> list[Point]:
    """A list of [x, y]."""
    result = []
    for i, pair in enumerate(items(value, place)):
        x, y = items(pair, f"{place}[{i}]", 2)
        result.append((number(x, f"{place}[{i}][0]"), number(y, f"{place}[{i}][1]")))
    return result


def items(value: object, place: str, length: int | None = None) -> Sequence[Any]:
    """A list, of this length."""
    if not isinstance(value, (list, tuple)) or length not in (None, len(value)):
        raise Unreadable(f"{place}: not a list" + (f" of {length}" if length else ""))
    return value


def document(value: object, kind: str) -> dict[str, Any]:
    """A document of this kind, version 1; a bare object is read too."""
    known = {"format": f"bern-exact/{kind}", "version": 1}
    if not isinstance(value, dict) or any(value.get(k, v) != v for k, v in known.items()):
        raise Unreadable(f"not a {known['format']} document, version 1")
    return value


class Outline:
    """A simple polygon: `sides` with the interior on the left, as many of them the `outer` ring's.

    `names` has each vertex as [ring, index]; side i is the edge of the same name.
    """

    def __init__(self, value: object) -> None:
        self.at: list[Point] = []
        self.names: list[list[int]] = []
        self.sides: list[Side] = []
        polygon = document(value, "polygon")
        for r, ring in enumerate([polygon.get("outer"), *items(polygon.get("holes", []), "holes")]):
            self._add(r, points(ring, f"ring {r}"))
        self.outer = sum(r == 0 for r, _ in self.names)
        distinct = len(set(self.at)) == len(self.at)
        if not distinct or conflicts(self.at, self.sides) or any(self._faults()):
            raise Unreadable("the polygon is not simple, or a hole is not inside")

    def _add(self, r: int, ring: list[Point]) -> None:
        zero, first, n = (Fraction(), Fraction()), len(self.at), len(ring)
        twice = sum(turn(zero, ring[i - 1], ring[i]) for i in range(n))
        if n < 3 or twice == 0:
            raise Unreadable(f"polygon: ring {r} has no area")
        for i in range(n):
            a, b = first + i, first + (i + 1) % n
            self.sides.append((a, b, 1) if (twice > 0) == (r == 0) else (b, a, 1))
        self.names += [[r, i] for i in range(n)]
        self.at += ring

    def _faults(self) -> Iterator[bool]:
        for (a, b, _), name in zip(self.sides, self.names, strict=True):
            if name[1] == 0:
                spots = beside(self.at[a], self.at[b])
                yield [winding(self.at, self.sides, spot) for spot in spots] != [1, 0]


def text(p: Point) -> list[str]:
    """A point for people and files."""
    return [str(p[0]), str(p[1])]


def turn(p: Point, q: Point, r: Point) -> Fraction:
    """Twice the signed area of the triangle p, q, r."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def dot(p: Point, q: Point, r: Point) -> Fraction:
    """The dot product of q - p and r - p."""
    return (q[0] - p[0]) * (r[0] - p[0]) + (q[1] - p[1]) * (r[1] - p[1])


def line(p: Point, q: Point) -> tuple[Fraction, ...]:
    """The line through two points: the same for all pairs of its points."""
    if p[0] == q[0]:
        return (p[0],)
    slope = (q[1] - p[1]) / (q[0] - p[0])
    return slope, p[1] - slope * p[0]


def is_on(p: Point, a: Point, b: Point) -> bool:
    """Is p on the segment ab?"""
    return min(a, b) <= p <= max(a, b) and turn(a, b, p) == 0


def beside(p: Point, q: Point) -> Iterator[Spot]:
    """The spots just left and just right of the middle of pq."""
    (x, y), m = (q[0] - p[0], q[1] - p[1]), ((p[0] + q[0]) / 2, (p[1] + q[1]) / 2)
    yield m, (x, y), (-y, x)
    yield m, (x, y), (y, -x)


def winding(at: Sequence[Point], sides: Iterable[Side], spot: Spot) -> int:
    """How often the sides wind round a spot: those that the ray from it in direction +x meets."""
    m, d, n = spot
    above = (n[1] or d[1]) > 0
    total = 0
    for a, b, times in sides:
        p, q = at[a], at[b]
        if (p[1] <= m[1]) != (q[1] <= m[1]) if above else (p[1] < m[1]) != (q[1] < m[1]):
            x, y = q[0] - p[0], q[1] - p[1]
            left = turn(p, q, m) or x * n[1] - y * n[0] or x * d[1] - y * d[0]
            if (left > 0) == (y > 0):
                total += times if y > 0 else -times
    return total


def unmatched(pieces: list[Piece]) -> Iterator[tuple[dict[str, Any], Point, Point]]:
    """The stretches of one line where sides overlap, or do not match the polygon's edges."""
    net, sides = Counter[Point](), Counter[Point]()
    for p, q, times, _ in pieces:
        net[p] += times
        net[q] -= times
        if times > 0:
            sides[min(p, q)] += times
            sides[max(p, q)] -= times
    for p, q in pairwise(sorted(net)):
        net[q] += net[p]
        sides[q] += sides[p]
        if net[p] or sides[p] > 1:
            yield next(w for a, b, _, w in pieces if min(a, b) <= p and q <= max(a, b)), p, q


def conflicts(at: Sequence[Point], sides: Sequence[Side]) -> list[tuple[str, int, int]]:
    """("crossing", i, j) for sides i < j, ("hanging", i, v) for a vertex v inside side i."""
    found, active = set[tuple[str, int, int]](), list[int]()
    boxes = [[sorted(c) for c in zip(at[a], at[b], strict=True)] for a, b, _ in sides]
    for j in sorted(range(len(sides)), key=lambda j: boxes[j][0][0]):
        (left, _), (low, high) = boxes[j]
        active = [i for i in active if boxes[i][0][1] >= left]
        for i in active:
            if boxes[i][1][0] <= high and low <= boxes[i][1][1]:
                crossing = True
                for k, (v, w, _) in ((i, sides[j]), (j, sides[i])):
                    p, q = at[sides[k][0]], at[sides[k][1]]
                    turns = turn(p, q, at[v]), turn(p, q, at[w])
                    for u, side in zip((v, w), turns, strict=True):
                        if side == 0 and dot(at[u], p, q) < 0:
                            found.add(("hanging", k, u))
                    crossing &= turns[0] * turns[1] < 0
                if crossing:
                    found.add(("crossing", min(i, j), max(i, j)))
        active.append(j)
    return sorted(found)


@functools.cache
def scaled_pi(bits: int) -> int:
    """pi 2^bits, with an error below 20 bits: Machin; each of < bits terms is < 1 too small."""
    pi, one = 0, 1 << bits
    for factor, base in ((16, 5), (-4, 239)):
        powers = ((k, one // base ** (2 * k + 1) // (2 * k + 1)) for k in range(bits))
        pi += factor * sum(-term if k % 2 else term for k, term in powers)
    return pi


@functools.lru_cache(4096)
def enclosure(degrees: Fraction, bits: int) -> tuple[Fraction, Fraction]:
    """Bounds of cos |cos| of so many degrees, 0 to 180: equal for multiples of 30 and 45."""
    if degrees > 90:
        low, high = enclosure(180 - degrees, bits)
        return -high, -low
    if degrees in KNOWN:
        return KNOWN[int(degrees)], KNOWN[int(degrees)]
    one, pi = 1 << bits, scaled_pi(bits)
    bounds = []
    for error, parity in ((20 * bits, 1), (-20 * bits, 0)):
        x = Fraction(int(degrees * (pi + error) / 180) + parity, one)  # rounded outwards
        k, term, total = 0, Fraction(1), Fraction(1)  # the terms alternate and fall from k = 1 on,
        while term * one > 1 or k % 2 != parity:  # so a sum that ends in a minus is too small
            k, term = k + 1, term * x * x / ((2 * k + 1) * (2 * k + 2))
            total += -term if k % 2 else term
        bounds.append(total * abs(total))
    return bounds[0], bounds[1]


def compare(square: Fraction, degrees: Fraction) -> int:
    """-1, 0, 1 as the angle with this cos |cos| is below, at or above so many degrees."""
    bits = 64
    while True:
        low, high = enclosure(degrees, bits)
        if not low <= square <= high or low == high:
            return (square < low) - (square > high)
        bits *= 2


def angle(square: Fraction) -> dict[str, Any]:
    """The angle with this cos |cos|, and the billionths of degrees next to it."""
    low, high = 0, 180 * 10**9
    while low < high:
        middle = (low + high + 1) // 2
        if compare(square, Fraction(middle, 10**9)) < 0:
            high = middle - 1
        else:
            low = middle
    high += compare(square, Fraction(low, 10**9))
    shown = [f"{k // 10**9}.{k % 10**9:09}".rstrip("0").rstrip(".") for k in (low, high)]
    sign = (square > 0) - (square < 0)
    return {"cos_sign": sign, "cos_squared": str(abs(square)), "degrees": shown}


def angle_bound(bound: str) -> Callable[[Fraction], bool]:
    """Decimal degrees, or cos:S:p/q: tells of a cos |cos| whether its angle is above that."""
    if bound.startswith("cos:"):
        sign, _, rest = bound[4:].partition(":")
        square = number(rest, "angle")
        if sign not in ("-1", "0", "1") or (sign == "0") != (square == 0) or not 0 <= square <= 1:
            raise Unreadable("angle: cos:S:p/q has S in -1, 0, 1 and 0 <= p/q <= 1")
        return lambda value: value < int(sign) * square
    degrees = number(bound if len(bound) <= ANGLE_TEXT else None, "angle")
    if not 0 <= degrees <= 180:
        raise Unreadable("angle: not from 0 to 180 degrees")
    return lambda value: compare(value, degrees) > 0


class Judge:
    """A mesh before the court."""

    def __init__(self, mesh: object, outline: Outline | None, limit: int) -> None:
        content = document(mesh, "mesh")
        self.at = points(content.get("vertices"), "vertices")
        self.triangles: list[tuple[int, int, int]] = []
        for t, triple in enumerate(items(content.get("triangles"), "triangles")):
            a, b, c = items(triple, f"triangles[{t}]", 3)
            if [type(v) for v in (a, b, c)] != [int] * 3:
                raise Unreadable(f"triangles[{t}]: not three vertex numbers")
            self.triangles.append((a, b, c))
        self.outline, self.limit = outline, limit
        self.valid = True
        self.defects: list[dict[str, Any]] = []
        self.sound: dict[int, tuple[int, int, int]] = {}  # the triangles with three vertices
        self.first: dict[Point, int] = {}  # the first vertex at each point
        self.sides: list[Side] = []  # the boundary

    def add(self, kind: str, where: dict[str, Any], **witness: Any) -> None:
        """Note a defect."""
        self.valid = False
        if len(self.defects) < self.limit:
            message = DEFECTS[kind].format(**where, **witness)
            entry = {"kind": kind, "where": where, "message": message, "witness": witness}
            self.defects.append(entry)

    def look_at_indices(self) -> None:
        """Every index names a vertex, every vertex has an index, no two are at one point."""
        for t, corners in enumerate(self.triangles):
            bad = [v for v in corners if not 0 <= v < len(self.at)]
            if bad:
                self.add("index-out-of-range", {"triangle": t}, index=str(bad[0]))
            elif len(set(corners)) < 3:
                self.add("repeated-index", {"triangle": t}, corners=list(corners))
            else:
                self.sound[t] = corners
        used = {v for corners in self.triangles for v in corners}
        for v, p in enumerate(self.at):
            if self.first.setdefault(p, v) != v:
                self.add("duplicate-vertex", {"vertex": v}, first=self.first[p], point=text(p))
            if v not in used:
                self.add("unused-vertex", {"vertex": v}, point=text(p))

    def look_at_edges(self) -> None:
        """Triangles run counter-clockwise, directed edges are used once; which have no reverse?"""
        users: dict[Edge, list[int]] = defaultdict(list)
        for t, corners in self.sound.items():
            area = turn(*(self.at[v] for v in corners))
            a, b, c = (self.first[self.at[v]] for v in corners)
            if area < 0:  # and is counted as turned over
                self.add("clockwise-triangle", {"triangle": t})
                b, c = c, b
            elif area == 0:
                self.add("degenerate-triangle", {"triangle": t})
            for edge in (a, b), (b, c), (c, a):
                users[edge].append(t)
        for (a, b), ts in users.items():
            if len(ts) > 1:
                self.add("edge-used-twice", {"edge": [a, b]}, triangles=ts)
            times = len(ts) - len(users.get((b, a), ()))
            if times > 0 and a != b:
                self.sides.append((a, b, times))

    def look_at_sides(self) -> None:
        """The sides run just where the polygon does, or (without one) enclose a region once."""
        lines: dict[object, list[Piece]] = defaultdict(list)
        for a, b, times in self.sides:
            p, q = self.at[a], self.at[b]
            lines[line(p, q)].append((p, q, times, {"edge": [a, b]}))
        if self.outline:
            at, names = self.outline.at, self.outline.names
            for (a, b, _), name, p in zip(self.outline.sides, names, at, strict=True):
                lines[line(at[a], at[b])].append((at[a], at[b], -1, {"polygon_edge": name}))
                if p not in self.first:
                    self.add("polygon-vertex-missing", {"polygon_vertex": name}, point=text(p))
        wrong = [stretch for pieces in lines.values() for stretch in unmatched(pieces)]
        if wrong:
            self._name_conflicts()
        for where, p, q in wrong:
            if self.valid or len(self.defects) < self.limit:
                for spot in beside(p, q):
                    self._look_at_spot(where, spot)
        if not self.sides:
            self.add("region-not-covered", {}, point="any point")

    def _name_conflicts(self) -> None:
        for kind, i, j in conflicts(self.at, self.sides):
            edge = list(self.sides[i][:2])
            if kind == "hanging":
                self.add("hanging-vertex", {"vertex": j}, edge=edge, point=text(self.at[j]))
            else:
                kind = "crossing-edges" if self.outline else "boundary-not-simple"
                self.add(kind, {"edge": edge}, other=list(self.sides[j][:2]))
        if self.outline:
            at, edges = self.outline.at, self.outline.sides
            for v in sorted({a for a, _, _ in self.sides}):
                p = self.at[v]
                if len(self.defects) >= self.limit:
                    break
                if not any(is_on(p, at[a], at[b]) for a, b, _ in edges):
                    self.add("boundary-vertex-off-edge", {"vertex": v}, point=text(p))

    def _look_at_spot(self, where: dict[str, Any], spot: Spot) -> None:
        covered = winding(self.at, self.sides, spot)
        point = text(spot[0])
        if covered > 1:
            self.add("overlap", where, point=point, covered=covered)
        elif self.outline:
            at, sides = self.outline.at, self.outline.sides
            wanted, outer = (
                winding(at, some, spot) for some in (sides, sides[: self.outline.outer])
            )
            if covered < wanted:
                self.add("region-not-covered", where, point=point)
            elif covered > wanted:
                self.add("hole-filled" if outer else "triangle-outside", where, point=point)

    def measure(self, angle_limit: str | None, least: Fraction | None) -> dict[str, Any]:
        """The largest angle, the least squared height, and the number of triangles by angle."""
        too_large = angle_bound(angle_limit) if angle_limit is not None else lambda square: False
        classes = dict.fromkeys([*CLASSES, "above"], 0)
        squares: dict[int, Fraction] = {}
        heights: list[Fraction] = []
        for t, corners in self.sound.items():
            a, b, c = three = [self.at[v] for v in corners]
            if area := turn(a, b, c):
                lengths = [dot(b, c, c), dot(c, a, a), dot(a, b, b)]
                i = lengths.index(max(lengths))
                cosine = dot(three[i], three[i - 1], three[i - 2])
                square = squares[t] = cosine * abs(cosine) / (lengths[i - 1] * lengths[i - 2])
                heights.append(area * area / lengths[i])
                classes[next((k for k, n in CLASSES.items() if 4 * square >= n), "above")] += 1
                if too_large(square):
                    shown = angle(square) if len(self.defects) < self.limit else {}
                    self.add("angle-above-bound", {"triangle": t}, bound=angle_limit, **shown)
                if least is not None and heights[-1] < least:
                    bound, height = str(least), str(heights[-1])
                    self.add(
                        "height-below-bound", {"triangle": t}, bound=bound, height_squared=height
                    )
        worst = min(squares, key=squares.__getitem__, default=None)
        return {
            "max_angle": None if worst is None else {**angle(squares[worst]), "triangle": worst},
            "min_height_squared": str(min(heights)) if heights else None,
            "feature_size_squared": None,
            "angle_classes": classes,
        }


def judge(
    mesh: object,
    polygon: object = None,
    *,
    max_angle: str | int | None = None,
    min_height_squared: str | int | None = None,
    max_triangles: int | None = None,
    limit: int = 100,
) -> dict[str, Any]:
    """The verdict on a mesh document (parsed JSON, its decimals kept as text).

    Raises `Unreadable` if the mesh, the polygon or a bound cannot be understood.
    """
    sys.set_int_max_str_digits(0)  # `number` has its own limit
    polygon = document(mesh, "mesh").get("polygon") if polygon is None else polygon
    court = Judge(mesh, None if polygon is None else Outline(polygon), limit)
    least = None if min_height_squared is None else number(min_height_squared, "height")
    court.look_at_indices()
    court.look_at_edges()
    court.look_at_sides()
    measured = court.measure(None if max_angle is None else str(max_angle), least)
    if max_triangles is not None and len(court.triangles) > max_triangles:
        court.add("too-many-triangles", {}, triangles=len(court.triangles), bound=max_triangles)
    return {
        "valid": court.valid,
        "within_tolerance": None,
        "defects": court.defects,
        "triangles": len(court.triangles),
        "vertices": len(court.at),
        **measured,
    }


def load(path: str) -> object:
    """A JSON file, its decimals as text."""
    with open(path, encoding="utf-8") as file:
        return json.load(file, parse_float=str, parse_int=lambda digits: int(number(digits, path)))


def main() -> int:
    """Judge a file: 0 valid, 1 not, 3 unreadable."""
    parser = argparse.ArgumentParser(description="Is this mesh a triangulation of this polygon?")
    parser.add_argument("mesh")
    parser.add_argument("polygon", nargs="?")
    parser.add_argument("--max-angle", metavar="A", help="degrees, or cos:S:p/q")
    parser.add_argument("--min-height-squared", metavar="H")
    parser.add_argument("--max-triangles", type=int, metavar="K")
    parser.add_argument("--limit", type=int, default=100, help="defects listed")
    parser.add_argument("--json", action="store_true", help="the verdict as one JSON object")
    options = vars(parser.parse_args())
    as_json = options.pop("json")
    sys.set_int_max_str_digits(0)  # `number` has its own limit
    try:
        mesh, polygon = load(options.pop("mesh")), options.pop("polygon")
        verdict = judge(mesh, polygon and load(polygon), **options)
    except (OSError, ValueError, RecursionError, MemoryError) as error:
        print(f"unreadable: {error}", file=sys.stderr)
        return 3
    if as_json:
        print(json.dumps(verdict))
    else:
        print("valid" if verdict["valid"] else "NOT valid")
        for name, value in verdict.items():
            for row in value if name == "defects" else [value]:
                print(f"  {name}: {row}")
    return 0 if verdict["valid"] else 1


if __name__ == "__main__":
    sys.exit(main())
