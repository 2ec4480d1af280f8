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
angle is known by cos |cos|, a rational that falls as the angle grows.  In degrees it is enclosed as
tightly as it takes to decide, which ends: by Niven's theorem no angle with a rational squared
cosine is a rational number of degrees but the multiples of 30 and 45, which are known exactly.
`feature_size_squared` and `within_tolerance` are left null here.
"""

from __future__ import annotations

import argparse
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

DIGITS, EXPONENT, ANGLE_TEXT = 100_000, 10_000, 1_000
NUMBER = re.compile(r"[+-]?(?=\.?\d)(\d*)(?:/(\d+)|(?:\.(\d*))?(?:[eE]([+-]?\d+))?)", re.ASCII)
KNOWN = {Fraction(c, 4): a for a, c in ((0, 4), (30, 3), (45, 2), (60, 1), (90, 0))}
KNOWN |= {-square: 180 - degrees for square, degrees in KNOWN.items()}  # cos |cos| to degrees
CLASSES = {"le60": 1, "le90": 0, "le120": -1, "le135": -2, "le150": -3}  # 4 cos |cos|


class Unreadable(ValueError):
    """Not a mesh, not a polygon, not a number."""


def number(value: object, place: str) -> Fraction:
    """An exact rational: an integer, or the text "-12", "p/q" or "-1.5e-3"."""
    text = str(value) if type(value) in (int, str) else ""
    match = NUMBER.fullmatch(text)
    if match is None:
        raise Unreadable(f"{place}: not an exact number: {str(value)[:40]!r}")
    whole, below, decimals, power = match.groups(default="")
    if max(len(whole) + len(decimals), len(below), len(power)) > DIGITS:
        raise Unreadable(f"{place}: the number is too long")
    if abs(int(power or "0")) > EXPONENT or int(below or "1") == 0:
        raise Unreadable(f"{place}: too large an exponent, or division by zero")
    return Fraction(text)


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
    if isinstance(value, dict):
        told = value if "format" in value else {**known, **value}
        if all(repr(told.get(key)) == repr(known[key]) for key in known):  # true is not 1
            return value
    raise Unreadable(f"not a {known['format']} document, version 1")


def read_polygon(value: object) -> tuple[list[Point], list[Piece]]:
    """A simple polygon: its vertices, and its edges with the interior on the left."""
    polygon, corners, edges = document(value, "polygon"), list[Point](), list[Piece]()
    rings = [polygon.get("outer"), *items(polygon.get("holes", []), "holes")]
    for r, ring in enumerate(rings):
        at = points(ring, f"ring {r}")
        around = list(pairwise([*at, *at[:1]]))
        forward = (sum(p[0] * q[1] - p[1] * q[0] for p, q in around) > 0) == (r == 0)
        for i, (p, q) in enumerate(around):
            edges.append((*((p, q) if forward else (q, p)), 1, {"polygon_edge": [r, i]}))
        corners += at
    first = [(p, q) for p, q, _, where in edges if where["polygon_edge"][1] == 0]
    covers = [winding(edges, p, q, left) for p, q in first for left in (True, False)]
    proper = covers == [1, 0] * len(rings) and len(set(corners)) == len(corners)
    if not proper or conflicts(edges):
        raise Unreadable("the polygon is not simple, or a hole is not inside")
    return corners, edges


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


def winding(pieces: Sequence[Piece], p: Point, q: Point, left: bool) -> int:
    """How often the pieces wind round a spot just left, or just right, of the middle m of pq.

    They are met by the ray from there at right angles to pq; the spot and the ray are shifted by
    next to nothing towards q, so that ends on the ray count as behind and what passes m does not.
    """
    m, total = ((p[0] + q[0]) / 2, (p[1] + q[1]) / 2), 0
    for a, b, times, _ in pieces:
        leaves, enters = dot(m, a, q) > 0, dot(m, b, q) > 0
        side = turn(a, b, m) if leaves != enters else Fraction(0)
        if side != 0 and (leaves == (side > 0)) == left:
            total += times if side > 0 else -times
    return total


def unmatched(pieces: Sequence[Piece]) -> Iterator[Piece]:
    """The stretches of one line where sides overlap, or do not run where the polygon's edges do."""
    net, cover = Counter[Point](), Counter[Point]()
    for p, q, times, where in pieces:
        if "polygon_edge" in where:
            net.update({p: -times, q: times})
        else:
            net.update({p: times, q: -times})
            cover.update({min(p, q): times, max(p, q): -times})
    for p, q in pairwise(sorted(net)):
        net[q] += net[p]
        cover[q] += cover[p]
        if net[p] or cover[p] > 1:
            there = (where for a, b, _, where in pieces if min(a, b) <= p and q <= max(a, b))
            yield p, q, net[p], next(there)


def conflicts(pieces: Sequence[Piece]) -> set[tuple[str, int, Any]]:
    """("crossing", i, j) for pieces i < j, ("hanging", i, p) for an end p inside piece i."""
    found, active = set[tuple[str, int, Any]](), list[int]()
    boxes = [[sorted(c) for c in zip(p, q, strict=True)] for p, q, *_ in pieces]
    for j in sorted(range(len(pieces)), key=boxes.__getitem__):  # a sweep over x
        (left, _), (low, high) = boxes[j]
        active = [i for i in active if boxes[i][0][1] >= left]
        for i in active:
            if boxes[i][1][0] <= high and low <= boxes[i][1][1]:
                (p, q), (u, v) = pieces[i][:2], pieces[j][:2]
                ends = [(i, u, p, q), (i, v, p, q), (j, p, u, v), (j, q, u, v)]
                turns = [turn(a, b, end) for _, end, a, b in ends]
                for (k, end, a, b), side in zip(ends, turns, strict=True):
                    if side == 0 and dot(end, a, b) < 0:
                        found.add(("hanging", k, end))
                if turns[0] * turns[1] < 0 and turns[2] * turns[3] < 0:
                    found.add(("crossing", min(i, j), max(i, j)))
        active.append(j)
    return found


def in_degrees(square: Fraction, bits: int) -> tuple[Fraction, Fraction]:
    """Bounds of the angle a with this cos |cos|, at best 90 / 2^bits apart.

    Replace b = a by 2b if b <= 90, by 360 - 2b if not: cos b becomes 2 cos^2 b - 1, of which its
    sign is wanted.  It lies between low / one and high / one; b = 0 at a = p, b = 180 at a = q.
    """
    if square in KNOWN:
        return Fraction(KNOWN[square]), Fraction(KNOWN[square])
    one = 1 << (2 * bits + 4)
    cosine = (2 * abs(square) - 1) * one
    low, high = cosine // 1, -(-cosine // 1)
    p, q = Fraction(180 if square < 0 else 0), Fraction(90)
    for _ in range(bits):
        if low <= 0 <= high:
            break
        p, q = (q if high < 0 else p), (p + q) / 2
        least, most = sorted((low * low, high * high))
        low, high = 2 * least // one - one, -(-2 * most // one) - one
    return min(p, q), max(p, q)


def is_above(square: Fraction, degrees: Fraction) -> bool:
    """Is the angle with this cos |cos| larger than so many degrees?"""
    bits = 16
    while True:
        low, high = in_degrees(square, bits)
        if high <= degrees or low > degrees:
            return low > degrees
        bits *= 2


def angle(square: Fraction) -> dict[str, Any]:
    """The angle with this cos |cos|, and the billionths of degrees next to it."""
    bits, low, high = 64, 0, 2
    while high - low > 1:
        ends = in_degrees(square, bits)
        bits, low, high = 2 * bits, ends[0] * 10**9 // 1, -(-ends[1] * 10**9 // 1)
    shown = [f"{k // 10**9}.{k % 10**9:09}".rstrip("0").rstrip(".") for k in (low, high)]
    sign = (square > 0) - (square < 0)
    return {"cos_sign": sign, "cos_squared": str(abs(square)), "degrees": shown}


def angle_bound(bound: str) -> Callable[[Fraction], bool]:
    """Decimal degrees, or cos:S:p/q: tells of a cos |cos| whether its angle is above that."""
    kind, sign, rest = (bound.split(":", 2) + ["", ""])[:3]
    if kind == "cos":
        square = number(rest, "angle")
        if sign not in ("-1", "0", "1") or (sign == "0") != (square == 0) or not 0 <= square <= 1:
            raise Unreadable("angle: cos:S:p/q has S in -1, 0, 1 and 0 <= p/q <= 1")
        return lambda value: value < int(sign) * square
    degrees = number(bound if len(bound) <= ANGLE_TEXT else None, "angle")
    if not 0 <= degrees <= 180:
        raise Unreadable("angle: not from 0 to 180 degrees")
    return lambda value: is_above(value, degrees)


class Judge:
    """A mesh before the court."""

    def __init__(self, mesh: object, polygon: object, limit: int) -> None:
        content = document(mesh, "mesh")
        self.at = points(content.get("vertices"), "vertices")
        triangles = items(content.get("triangles"), "triangles")
        self.triangles = [items(corners, "triangle", 3) for corners in triangles]
        if not all(type(v) is int for corners in self.triangles for v in corners):
            raise Unreadable("triangles: not vertex numbers")
        polygon = content.get("polygon") if polygon is None else polygon
        self.given = polygon is not None
        self.corners, self.edges = read_polygon(polygon) if self.given else ([], [])
        self.limit, self.valid, self.defects = limit, True, list[dict[str, Any]]()
        self.sound: dict[int, Sequence[int]] = {}  # the triangles with three vertices
        self.first: dict[Point, int] = {}  # the first vertex at each point
        self.sides: list[Piece] = []

    def add(self, kind: str, where: dict[str, Any], **witness: Any) -> None:
        """Note a defect."""
        self.valid = False
        if len(self.defects) < self.limit:
            shown = {k: [*map(str, v)] if isinstance(v, tuple) else v for k, v in witness.items()}
            place = ", ".join(f"{name} {value}" for name, value in (where or shown).items())
            entry = {"kind": kind, "where": where, "message": f"{kind}: {place}", "witness": shown}
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
        for p, (*_, where) in zip(self.corners, self.edges, strict=True):
            if p not in self.first:
                name = where["polygon_edge"]
                self.add("polygon-vertex-missing", {"polygon_vertex": name}, point=p)
        lines: dict[object, list[Piece]] = defaultdict(list)
        for piece in [*self.sides, *self.edges]:
            lines[line(*piece[:2])].append(piece)
        wrong = [stretch for pieces in lines.values() for stretch in unmatched(pieces)]
        if wrong:
            self.name_conflicts({u for p, q, net, _ in wrong if net for u in (p, q)})
        for p, q, _, where in wrong:
            for left in (True, False):
                if self.valid or len(self.defects) < self.limit:
                    self.look_beside(p, q, left, where)
        if not self.sides:
            self.add("region-not-covered", {}, point="any point")

    def name_conflicts(self, ends: set[Point]) -> None:
        """Where sides meet other than in endpoints, and which of these ends lie on no edge."""
        met = conflicts(self.sides)
        for kind, i, j in sorted((k, i, self.first.get(j, j)) for k, i, j in met):
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

    def look_beside(self, p: Point, q: Point, left: bool, where: dict[str, Any]) -> None:
        """Is it covered beside the middle of pq as often as it should be?"""
        covered = winding(self.sides, p, q, left)
        wanted = winding(self.edges, p, q, left) if self.given else covered
        point = (p[0] + q[0]) / 2, (p[1] + q[1]) / 2
        if covered > 1:
            self.add("overlap", where, point=point, covered=covered)
        elif covered < wanted:
            self.add("region-not-covered", where, point=point)
        elif covered > wanted:
            outer = [edge for edge in self.edges if edge[3]["polygon_edge"][0] == 0]
            kind = "hole-filled" if winding(outer, p, q, left) else "triangle-outside"
            self.add(kind, where, point=point)

    def measure(self, bound: str | None, least: Fraction | None) -> dict[str, Any]:
        """The largest angle, the least squared height, and the number of triangles by angle."""
        is_too_large = angle_bound(bound) if bound is not None else lambda square: False
        classes = dict.fromkeys([*CLASSES, "above"], 0)
        squares, heights = dict[int, Fraction](), list[Fraction]()
        for t, corners in self.sound.items():
            a, b, c = (self.at[v] for v in corners)
            area, dots = turn(a, b, c), [dot(a, b, c), dot(b, c, a), dot(c, a, b)]
            if area == 0:
                continue
            low = min(dots)  # at the largest angle: its cot is low / area
            square = squares[t] = low * abs(low) / (low**2 + area**2)
            height = area**2 / (sum(dots) - low)  # the other two add up to the longest edge squared
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
