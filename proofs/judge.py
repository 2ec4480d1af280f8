"""The judge's argument: what `bern_exact/oracle/judge.py` looks at decides what it says.

**Definitions.**  A *triangulation* of a region is a finite set of triangles (closed, of positive
area) whose union is the region, of which any two have nothing, a common corner or a common side
in common.  A mesh, vertices and index triples, *triangulates* a polygon P if its triangles are a
triangulation of P, its vertices are at different points, each is used, and P's own vertices
are among them.  A *side* is a directed edge of a counter-clockwise triangle whose reverse is none.

**Theorem.**  Let all triangles run counter-clockwise with positive area, all vertices be at
different points and used, and every directed edge belong to one triangle.  Then the mesh
(a) triangulates P if and only if P's vertices are vertices of the mesh and on every line the sides,
    which do not overlap, run just where the edges of P do, in the same direction;
(b) is a triangulation of the region that its sides enclose if and only if there is a triangle and
    sides meet in common endpoints alone and have the triangles once on the left, not on the right.

**Proof.**  For a point x on no edge let c(x) be the number of triangles with x inside.

(1) *Winding.*  The winding number round x of a counter-clockwise triangle's boundary is 1 if x is
inside, else 0.  Winding numbers of closed chains add up, and an edge run through both ways
contributes nothing.  So c(x) is the winding number round x of the chain of all sides.

(2) *If, (a).*  The chain of sides is that of P's boundary, interior on the left, cut in pieces:
same winding numbers, 1 inside P and 0 outside.  So interiors of triangles are disjoint, the union
is P but for a set without interior, and as both are closed and P is the closure of its interior,
the union is P.  Sides meet in endpoints alone, as P's edges do and sides do not overlap.

(3) *If, (b).*  c is constant on each face of the drawing of the sides, which cut the plane up.  Far
away it is 0.  Every bounded face has a side next to it, so c is 0 or 1 on it.  So interiors of
triangles are disjoint, and the union is the closure of the faces with c = 1.

(4) *Corners.*  In both cases suppose a vertex v lies in the interior of triangle t or inside its
edge ab.  In the interior: v is used, and the triangle at v has points inside t.  So c would be 2.
Inside ab, t being on the left: the triangles at v do not overlap t, so that next to v they lie in
the half-plane on the right of ab.  Of their edges at v take the first, vx, counter-clockwise from
the direction of a.  The triangle on its left has the directed edge vx.  One with the edge xv would
have a corner at v on the right of vx: before the first, or overlapping t.  So vx is a side.  Then
ab is none, as sides meet in endpoints alone.  So ba is a directed edge of another triangle, on the
right of ab, which the triangles at v overlap: c would be 2.  A contradiction.

(5) *Meeting.*  Let triangles t and u have a point in common.  Interiors are disjoint, so a line
parts them, and what they have in common is a segment or point on it, an end of which is a corner
of t or of u: by (4) a corner of both.  So it is a common corner, or has two such ends and is
a common side.

(6) *Only if.*  In a triangulation of a region, every edge is on one or two triangles, on
different sides of it.  So a directed edge belongs to one triangle, and a side is just an
edge with the region on the left alone.  The sides fill the region's boundary, and meet as edges do.
For a polygon the boundary is its edges; a vertex of P inside none of them is where two sides meet.

The judge finds the sides by hashing directed edges, compares them with P's edges line by line by
adding up where they begin and end, and looks next to a side by counting what a ray from there
meets.  A directed edge belonging to two triangles is a defect by itself; a clockwise
triangle too, and is counted as turned over from there on, as only diagnosis follows.

**Enumeration.**  Every set of triangles on all choices of four points of a 3 x 3 grid is put to the
judge and to the definitions above, taken word for word; with `--full` on five points, too.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations, permutations, product
from typing import Any

from bern_exact.oracle.judge import Judge, Piece, winding
from proofs.statement import ENUMERATION, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements

Point = tuple[int, int]
Spot = tuple[Fraction, Fraction]
Triangle = tuple[int, int, int]

GRID: Sequence[Point] = tuple((x, y) for x in range(3) for y in range(3))

CLOSE = Fraction(1, 10**6)
"""So far from a point of the arrangement is a spot beside it."""


def turn(p: Sequence[Any], q: Sequence[Any], r: Sequence[Any]) -> Any:
    """Twice the signed area."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def covers(corners: Sequence[Sequence[Any]], x: Sequence[Any]) -> bool:
    """Is x in a closed triangle, of either orientation?"""
    turns = [turn(corners[i - 1], corners[i], x) for i in range(3)]
    return all(t >= 0 for t in turns) or all(t <= 0 for t in turns)


def inside(ring: Sequence[Point], x: Spot) -> bool:
    """Is x inside a polygon?  It is level with no vertex: a ray to the right crosses edges."""
    crossed = False
    for p, q in zip(ring, [*ring[1:], ring[0]], strict=True):
        if (p[1] > x[1]) != (q[1] > x[1]):
            crossed ^= (turn(p, q, x) > 0) == (q[1] > p[1])
    return crossed


def spots(points: Sequence[Point]) -> Iterator[Spot]:
    """At least one point in every cell of the lines through all pairs of points.

    Each cell has a corner where two lines meet, and lies there between two lines next to each
    other in angle.
    """
    runs = {(p, (q[0] - p[0], q[1] - p[1])) for p, q in permutations(points, 2)}
    meets: set[Spot] = set()
    for (p, u), (q, v) in combinations(sorted(runs), 2):
        across = u[0] * v[1] - u[1] * v[0]
        if across:
            t = Fraction((q[0] - p[0]) * v[1] - (q[1] - p[1]) * v[0], across)
            meets.add((p[0] + t * u[0], p[1] + t * u[1]))
    for x, y in sorted(meets):
        ways = {u for p, u in runs if (x - p[0]) * u[1] == (y - p[1]) * u[0]}
        ways |= {(-u[0], -u[1]) for u in ways}
        for u in ways:
            following = [v for v in ways if u[0] * v[1] - u[1] * v[0] > 0]
            v = next(v for v in following if all(turn((0, 0), v, w) >= 0 for w in following))
            yield x + CLOSE * (3 * u[0] + 2 * v[0]), y + CLOSE * (3 * u[1] + 2 * v[1])


def simple_polygons(points: Sequence[Point]) -> Iterator[Sequence[Point]]:
    """Every counter-clockwise simple polygon on some of the points, 180-degree vertices too."""
    for size in range(3, len(points) + 1):
        for first, *rest in combinations(points, size):
            for order in permutations(rest):
                ring = [first, *order]
                if _is_simple(ring):
                    yield ring


def _is_simple(ring: Sequence[Point]) -> bool:
    """Counter-clockwise, edges meeting in common endpoints alone."""
    if sum(turn((0, 0), ring[i - 1], p) for i, p in enumerate(ring)) <= 0:
        return False
    edges = [(ring[i - 1], p) for i, p in enumerate(ring)]
    return not any(_meet_badly(*e, *f) for e, f in combinations(edges, 2))


def _meet_badly(a: Point, b: Point, p: Point, q: Point) -> bool:
    """Do two segments have a point in common that is no endpoint of both?"""
    ends = [(x, e) for e, other in (((a, b), (p, q)), ((p, q), (a, b))) for x in other]
    if any(x not in e and turn(*e, x) == 0 and _between(*e, x) for x, e in ends):
        return True
    return bool(turn(a, b, p) * turn(a, b, q) < 0 and turn(p, q, a) * turn(p, q, b) < 0)


def _between(a: Point, b: Point, x: Point) -> bool:
    return min(a, b) < x < max(a, b)


def meet_properly(one: Sequence[Point], other: Sequence[Point]) -> bool:
    """Two triangles with disjoint interiors: are corners of one in the other corners of both?"""
    return all(x in other for x in one if covers(other, x)) and all(
        x in one for x in other if covers(one, x)
    )


def verdict(mesh: object, polygon: object) -> bool:
    """What the judge says, without measuring angles."""
    court = Judge(mesh, polygon, 0)
    court.look_at_indices()
    court.look_at_edges()
    court.look_at_sides()
    return court.valid


def up_to_symmetry(size: int) -> list[tuple[Point, ...]]:
    """All choices of so many points of the grid, one for each class of congruent ones."""
    found: dict[tuple[Point, ...], None] = {}
    for points in combinations(GRID, size):
        images = []
        for swap, left, down in product((False, True), repeat=3):
            moved = [(y, x) if swap else (x, y) for x, y in points]
            moved = [(-x if left else x, -y if down else y) for x, y in moved]
            x0, y0 = min(x for x, _ in moved), min(y for _, y in moved)
            images.append(tuple(sorted((x - x0, y - y0) for x, y in moved)))
        found[min(images)] = None
    return list(found)


class Case:
    """Points, and the definitions on them.

    Parameters
    ----------
    points : sequence of (int, int)
        The vertices.
    """

    def __init__(self, points: Sequence[Point]) -> None:
        self.points = points
        self.spots = tuple(dict.fromkeys(spots(points)))
        self.polygons = [
            (ring, [inside(ring, x) for x in self.spots]) for ring in simple_polygons(points)
        ]
        self.triangles = [
            t for t in combinations(range(len(points)), 3) if turn(*(points[v] for v in t)) != 0
        ]

    def corners(self, triangle: Triangle) -> list[Point]:
        """The corners of a triangle."""
        return [self.points[v] for v in triangle]

    def is_mesh(self, triangles: Sequence[Triangle]) -> list[int] | None:
        """How often each spot is covered, if this is a triangulation of what it covers."""
        if not triangles or {v for t in triangles for v in t} != set(range(len(self.points))):
            return None
        corners = [self.corners(t) for t in triangles]
        if any(turn(*c) <= 0 for c in corners):
            return None
        count = [sum(covers(c, x) for c in corners) for x in self.spots]
        if max(count) > 1 or not all(meet_properly(c, d) for c, d in combinations(corners, 2)):
            return None
        return count

    def compare(self, triangles: Sequence[Triangle], *, alone: bool = False) -> int:
        """Put a set of triangles to the judge, without and (unless alone) with every polygon."""
        mesh = {"vertices": [[*p] for p in self.points], "triangles": [[*t] for t in triangles]}
        count = self.is_mesh(triangles)
        told = verdict(mesh, None)
        demand(told == (count is not None), f"{self.points} {triangles}: judged {told}")
        for ring, within in () if alone else self.polygons:
            told = verdict(mesh, {"outer": [[*p] for p in ring]})
            holds = count is not None and count == [int(w) for w in within]
            demand(told == holds, f"{self.points} {triangles} {ring}: judged {told}")
        return 1 if alone else 1 + len(self.polygons)


def oriented(triangles: Sequence[Triangle], points: Sequence[Point]) -> list[Triangle]:
    """The same, counter-clockwise."""
    return [
        (a, b, c) if turn(points[a], points[b], points[c]) > 0 else (a, c, b)
        for a, b, c in triangles
    ]


@CHAPTER.proved(
    "The judge",
    "A mesh is a triangulation (of a polygon, or of what it encloses) if and only if the judge "
    "says so.",
    "written proof; its definitions in an " + ENUMERATION,
)
def every_set_on_four_points() -> str:
    """All sets, with every polygon; without one also with a triangle turned or twice."""
    cases = 0
    for points in up_to_symmetry(4):
        case = Case(points)
        there = oriented(case.triangles, points)
        for choice in product(range(4), repeat=len(there)):
            chosen = [
                copy
                for kind, (a, b, c) in zip(choice, there, strict=True)
                for copy in ([], [(a, b, c)], [(a, c, b)], [(a, b, c), (a, b, c)])[kind]
            ]
            if sum(kind > 1 for kind in choice) <= 1:
                cases += case.compare(chosen, alone=max(choice) > 1)
    return f"{cases} verdicts on all choices of 4 of 9 points up to symmetry"


FIVE_POINTS: Sequence[Point] = ((0, 0), (2, 0), (2, 2), (0, 2), (1, 1))
"""A square with its centre."""


@CHAPTER.proved(
    "The judge",
    "The same on sets of counter-clockwise triangles on five points: a square with its centre, and "
    "one with a 180-degree vertex.",
    ENUMERATION,
    full=True,
)
def every_set_on_five_points() -> str:
    """All sets of at most four triangles."""
    cases = 0
    for middle in ((1, 1), (1, 0)):
        points = (*FIVE_POINTS[:4], middle)
        case = Case(points)
        there = oriented(case.triangles, points)
        for size in range(5):
            for chosen in combinations(there, size):
                cases += case.compare(chosen)
    return f"{cases} verdicts"


@CHAPTER.proved(
    "The judge",
    "Step (1): the judge's winding numbers count the triangles beside an edge.",
    ENUMERATION,
)
def winding_numbers() -> str:
    """One to three triangles on five points, at all segments between two of these."""
    cases = 0
    points = FIVE_POINTS
    at = [(Fraction(x), Fraction(y)) for x, y in points]
    there = oriented(Case(points).triangles, points)
    for size in range(1, 4):
        for chosen in combinations(there, size):
            pieces: list[Piece] = [
                (at[t[i - 1]], at[t[i]], 1, {}) for t in chosen for i in range(3)
            ]
            for a, b in permutations(range(len(points)), 2):
                for left in (True, False):
                    spot = _beside(at[a], at[b], left)
                    count = sum(covers([points[v] for v in t], spot) for t in chosen)
                    found = winding(pieces, at[a], at[b], left)
                    demand(found == count, f"{points} {chosen} {a} {b} {left}")
                    cases += 1
    return f"{cases} places"


def _beside(p: Spot, q: Spot, left: bool) -> Spot:
    """Next to the middle of pq, shifted by less still towards q."""
    dx, dy = q[0] - p[0], q[1] - p[1]
    aside = CLOSE if left else -CLOSE
    return (
        (p[0] + q[0]) / 2 - aside * dy + CLOSE**2 * dx,
        (p[1] + q[1]) / 2 + aside * dx + CLOSE**2 * dy,
    )
