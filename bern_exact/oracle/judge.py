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
vertices and common edges only.  (In (a) the polygon's own vertices are asked for besides.)

What follows a first defect is diagnosis: it names and places the rest and decides nothing.  An
angle is known by cos |cos|, a rational that falls as the angle grows.  Bounds in degrees are
decided by certified enclosures, refined until they decide: the squared cosine of a rational number
of degrees is irrational but for the multiples of 30 and 45 (Niven), which are taken exactly.
"""

from __future__ import annotations

import argparse
import functools
import json
import re
import sys
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

Point = tuple[Fraction, Fraction]
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


def items(value: object, place: str, length: int | None = None) -> Sequence[Any]:
    """A list, of this length."""
    if not isinstance(value, (list, tuple)) or length not in (None, len(value)):
        raise Unreadable(f"{place}: not a list" + (f" of {length}" if length else ""))
    return value


def points(value: object, place: str) -> list[Point]:
    """A list of [x, y]."""
    pairs = [items(pair, f"{place}[{i}]", 2) for i, pair in enumerate(items(value, place))]
    return [
        (number(x, f"{place}[{i}]"), number(y, f"{place}[{i}]")) for i, (x, y) in enumerate(pairs)
    ]


def document(value: object, kind: str) -> dict[str, Any]:
    """A document of this kind, version 1; a bare object is read too."""
    known = {"format": f"bern-exact/{kind}", "version": 1}
    if not isinstance(value, dict) or any(value.get(k, v) != v for k, v in known.items()):
        raise Unreadable(f"not a {known['format']} document, version 1")
    return value


def read_polygon(value: object) -> tuple[list[Point], list[Piece], int]:
    """A simple polygon: its vertices, its edges with the interior left, how many are outer."""
    polygon, corners, edges, counts = document(value, "polygon"), list[Point](), list[Piece](), [0]
    for r, ring in enumerate([polygon.get("outer"), *items(polygon.get("holes", []), "holes")]):
        at = points(ring, f"ring {r}")
        around = list(pairwise([*at, *at[:1]]))
        forward = (sum(p[0] * q[1] - p[1] * q[0] for p, q in around) > 0) == (r == 0)
        for i, (p, q) in enumerate(around):
            edges.append((*((p, q) if forward else (q, p)), 1, {"polygon_edge": [r, i]}))
        corners += at
        counts.append(len(at))
    starts = [edges[sum(counts[: r + 1])] for r, n in enumerate(counts[1:]) if n > 2]
    covers = [winding(edges, spot) for p, q, *_ in starts for spot in beside(p, q)]
    proper = covers == [1, 0] * (len(counts) - 1) and len(set(corners)) == len(corners)
    if not proper or conflicts(edges):
        raise Unreadable("the polygon is not simple, or a hole is not inside")
    return corners, edges, counts[1]


def turn(p: Point, q: Point, r: Point) -> Fraction:
    """Twice the signed area of the triangle p, q, r."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def dot(p: Point, q: Point, r: Point) -> Fraction:
    """The dot product of q - p and r - p."""
    return (q[0] - p[0]) * (r[0] - p[0]) + (q[1] - p[1]) * (r[1] - p[1])


def line(p: Point, q: Point) -> tuple[Fraction, ...]:
    """The line through two points: the same for any two of its points."""
    if p[0] == q[0]:
        return (p[0],)
    slope = (q[1] - p[1]) / (q[0] - p[0])
    return slope, p[1] - slope * p[0]


def beside(p: Point, q: Point) -> Iterator[Spot]:
    """The spots just left and just right of the middle of pq."""
    (x, y), m = (q[0] - p[0], q[1] - p[1]), ((p[0] + q[0]) / 2, (p[1] + q[1]) / 2)
    yield m, (x, y), (-y, x)
    yield m, (x, y), (y, -x)


def winding(pieces: Sequence[Piece], spot: Spot) -> int:
    """How often the pieces wind round a spot: those that the ray from it in direction +x meets."""
    m, d, n = spot
    above, total = (n[1] or d[1]) > 0, 0
    for p, q, times, _ in pieces:
        if (p[1] <= m[1]) != (q[1] <= m[1]) if above else (p[1] < m[1]) != (q[1] < m[1]):
            x, y = q[0] - p[0], q[1] - p[1]
            left = turn(p, q, m) or x * n[1] - y * n[0] or x * d[1] - y * d[0]
            if (left > 0) == (y > 0):
                total += times if y > 0 else -times
    return total


def unmatched(sides: list[Piece], edges: list[Piece]) -> Iterator[Piece]:
    """The stretches of one line where sides overlap, or do not run where the edges do."""
    net, cover = Counter[Point](), Counter[Point]()
    for p, q, times, _ in sides:
        net.update({p: times, q: -times})
        cover.update({min(p, q): times, max(p, q): -times})
    for p, q, times, _ in edges:
        net.update({p: -times, q: times})
    for p, q in pairwise(sorted(net)):
        net[q] += net[p]
        cover[q] += cover[p]
        if net[p] or cover[p] > 1:
            there = (w for a, b, _, w in sides + edges if min(a, b) <= p and q <= max(a, b))
            yield p, q, net[p], next(there)


def conflicts(pieces: Sequence[Piece]) -> set[tuple[str, int, Any]]:
    """("crossing", i, j) for pieces i < j, ("hanging", i, p) for an end p inside piece i."""
    found, active = set[tuple[str, int, Any]](), list[int]()
    boxes = [[sorted(c) for c in zip(p, q, strict=True)] for p, q, *_ in pieces]
    for j in sorted(range(len(pieces)), key=lambda j: boxes[j][0][0]):
        (left, _), (low, high) = boxes[j]
        active = [i for i in active if boxes[i][0][1] >= left]
        for i in active:
            if boxes[i][1][0] <= high and low <= boxes[i][1][1]:
                turns = []
                for k, other in (i, pieces[j]), (j, pieces[i]):
                    p, q = pieces[k][:2]
                    turns.append([turn(p, q, u) for u in other[:2]])
                    for u, side in zip(other[:2], turns[-1], strict=True):
                        if side == 0 and dot(u, p, q) < 0:
                            found.add(("hanging", k, u))
                if all(a * b < 0 for a, b in turns):
                    found.add(("crossing", min(i, j), max(i, j)))
        active.append(j)
    return found


@functools.cache
def scaled_pi(bits: int) -> int:
    """pi 2^bits, less than 20 bits off: Machin's series, each of < bits terms less than 1 off."""
    pi, one = 0, 1 << bits
    for factor, n in (16, 5), (-4, 239):
        powers = ((k, one // n ** (2 * k + 1) // (2 * k + 1)) for k in range(bits))
        pi += factor * sum(-term if k % 2 else term for k, term in powers)
    return pi


def enclosure(degrees: Fraction, bits: int) -> tuple[Fraction, Fraction]:
    """Bounds of cos |cos| of so many degrees, 0 to 180: equal for multiples of 30 and 45."""
    if degrees > 90:
        low, high = enclosure(180 - degrees, bits)
        return -high, -low
    if degrees in KNOWN:
        return KNOWN[int(degrees)], KNOWN[int(degrees)]
    one, k = 1 << bits, 0
    x = scaled_pi(bits) * degrees.numerator // (180 * degrees.denominator)  # < 11 bits off
    term = total = one
    while term:  # < bits terms, each less than 8 off; what is left out is less than 8
        k, term = k + 1, term * x * x // (one * one * (2 * k + 1) * (2 * k + 2))
        total += -term if k % 2 else term
    low, high = (Fraction(total + error, one) for error in (-20 * bits, 20 * bits))
    return low * abs(low), high * abs(high)


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
        above = compare(square, Fraction(middle, 10**9)) >= 0
        low, high = (middle, high) if above else (low, middle - 1)
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

    def __init__(self, mesh: object, polygon: object, limit: int) -> None:
        content = document(mesh, "mesh")
        self.at = points(content.get("vertices"), "vertices")
        self.triangles = [
            items(t, "triangle", 3) for t in items(content.get("triangles"), "triangles")
        ]
        if not all(type(v) is int for corners in self.triangles for v in corners):
            raise Unreadable("triangles: not vertex numbers")
        polygon = content.get("polygon") if polygon is None else polygon
        self.given = polygon is not None
        self.corners, self.edges, self.outer = read_polygon(polygon) if self.given else ([], [], 0)
        self.limit, self.valid = limit, True
        self.defects: list[dict[str, Any]] = []
        self.sound: dict[int, Sequence[int]] = {}  # the triangles with three vertices
        self.first: dict[Point, int] = {}  # the first vertex at each point
        self.sides: list[Piece] = []

    def add(self, kind: str, where: dict[str, Any], **witness: Any) -> None:
        """Note a defect."""
        self.valid = False
        if len(self.defects) < self.limit:
            shown = {k: [*map(str, v)] if isinstance(v, tuple) else v for k, v in witness.items()}
            message = DEFECTS[kind].format(**where, **shown)
            entry = {"kind": kind, "where": where, "message": message, "witness": shown}
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
                self.add("duplicate-vertex", {"vertex": v}, first=self.first[p], point=p)
            if v not in used:
                self.add("unused-vertex", {"vertex": v}, point=p)

    def look_at_edges(self) -> None:
        """Triangles run counter-clockwise, directed edges are used once; which have no reverse?"""
        users: dict[tuple[int, int], list[int]] = defaultdict(list)
        for t, corners in self.sound.items():
            p, q, r = (self.at[v] for v in corners)
            area = turn(p, q, r)
            if area < 0:  # and is counted as turned over
                self.add("clockwise-triangle", {"triangle": t})
                q, r = r, q
            elif area == 0:
                self.add("degenerate-triangle", {"triangle": t})
            for u, v in (p, q), (q, r), (r, p):
                users[self.first[u], self.first[v]].append(t)
        for (a, b), ts in users.items():
            if len(ts) > 1:
                self.add("edge-used-twice", {"edge": [a, b]}, triangles=ts)
            times = len(ts) - len(users.get((b, a), ()))
            if times > 0 and a != b:
                self.sides.append((self.at[a], self.at[b], times, {"edge": [a, b]}))

    def look_at_sides(self) -> None:
        """The sides run just where the polygon does, or (without one) enclose a region once."""
        for p, edge in zip(self.corners, self.edges, strict=True):
            if p not in self.first:
                name = edge[3]["polygon_edge"]
                self.add("polygon-vertex-missing", {"polygon_vertex": name}, point=p)
        lines = defaultdict[object, tuple[list[Piece], list[Piece]]](lambda: ([], []))
        for kind, pieces in enumerate((self.sides, self.edges)):
            for piece in pieces:
                lines[line(*piece[:2])][kind].append(piece)
        wrong = [piece for both in lines.values() for piece in unmatched(*both)]
        if wrong:
            self._name_conflicts({u for p, q, net, _ in wrong if net for u in (p, q)})
        for p, q, _, where in wrong:
            if self.valid or len(self.defects) < self.limit:
                for spot in beside(p, q):
                    self._look_at_spot(where, spot)
        if not self.sides:
            self.add("region-not-covered", {}, point="any point")

    def _name_conflicts(self, ends: set[Point]) -> None:
        found = [
            (k, i, self.first[u] if k == "hanging" else u) for k, i, u in conflicts(self.sides)
        ]
        for kind, i, j in sorted(found):
            where = self.sides[i][3]
            if kind == "hanging":
                self.add("hanging-vertex", {"vertex": j}, **where, point=self.at[j])
            else:
                kind = "crossing-edges" if self.given else "boundary-not-simple"
                self.add(kind, where, other=self.sides[j][3]["edge"])
        for v in sorted(self.first[p] for p in ends & self.first.keys() if self.given):
            p = self.at[v]
            if len(self.defects) < self.limit and not any(
                min(a, b) <= p <= max(a, b) and turn(a, b, p) == 0 for a, b, *_ in self.edges
            ):
                self.add("boundary-vertex-off-edge", {"vertex": v}, point=p)

    def _look_at_spot(self, where: dict[str, Any], spot: Spot) -> None:
        covered, point = winding(self.sides, spot), spot[0]
        wanted = winding(self.edges, spot) if self.given else covered
        if covered > 1:
            self.add("overlap", where, point=point, covered=covered)
        elif covered < wanted:
            self.add("region-not-covered", where, point=point)
        elif covered > wanted:
            in_hole = winding(self.edges[: self.outer], spot)
            self.add("hole-filled" if in_hole else "triangle-outside", where, point=point)

    def measure(self, bound: str | None, least: Fraction | None) -> dict[str, Any]:
        """The largest angle, the least squared height, and the number of triangles by angle."""
        is_too_large = angle_bound(bound) if bound is not None else lambda square: False
        classes = dict.fromkeys([*CLASSES, "above"], 0)
        squares: dict[int, Fraction] = {}
        heights: list[Fraction] = []
        for t, corners in self.sound.items():
            a, b, c = at = [self.at[v] for v in corners]
            if not (area := turn(a, b, c)):
                continue
            lengths = [dot(b, c, c), dot(c, a, a), dot(a, b, b)]
            i = lengths.index(max(lengths))
            cosine = dot(at[i], at[i - 1], at[i - 2])
            square = squares[t] = cosine * abs(cosine) / (lengths[i - 1] * lengths[i - 2])
            height = area * area / lengths[i]
            heights.append(height)
            classes[next((name for name, n in CLASSES.items() if 4 * square >= n), "above")] += 1
            if is_too_large(square):
                shown = angle(square) if len(self.defects) < self.limit else {}
                self.add("angle-above-bound", {"triangle": t}, bound=bound, **shown)
            if least is not None and height < least:
                witness = {"bound": str(least), "height_squared": str(height)}
                self.add("height-below-bound", {"triangle": t}, **witness)
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
    """The verdict on a mesh document, its decimals kept as text; or `Unreadable`."""
    sys.set_int_max_str_digits(0)  # `number` has its own limit
    court = Judge(mesh, polygon, limit)
    court.look_at_indices()
    court.look_at_edges()
    court.look_at_sides()
    least = None if min_height_squared is None else number(min_height_squared, "height")
    measured = court.measure(None if max_angle is None else str(max_angle), least)
    count = len(court.triangles)
    if max_triangles is not None and count > max_triangles:
        court.add("too-many-triangles", {}, triangles=count, bound=max_triangles)
    verdict = {"valid": court.valid, "within_tolerance": None, "defects": court.defects}
    return {**verdict, "triangles": count, "vertices": len(court.at), **measured}


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
    parser.add_argument("--json", action="store_true", help="all on one line")
    options = vars(parser.parse_args())
    as_json = options.pop("json")
    sys.set_int_max_str_digits(0)  # `number` has its own limit
    try:
        mesh, polygon = load(options.pop("mesh")), options.pop("polygon")
        verdict = judge(mesh, polygon and load(polygon), **options)
    except (OSError, ValueError, RecursionError, MemoryError) as error:
        print(f"unreadable: {error}", file=sys.stderr)
        return 3
    print(json.dumps(verdict, indent=None if as_json else 1))
    return 0 if verdict["valid"] else 1


if __name__ == "__main__":
    sys.exit(main())
