"""Warping (Section 2): who moves where, and what becomes of the faces."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from gmpy2 import mpq

from bern_exact.boundary.records import GridNode, Node, Warped
from bern_exact.checkers import bounds
from bern_exact.checkers.dicing import blocks, squares
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.places import Places
from bern_exact.checkers.rings import (
    NearBoundary,
    Ring,
    boundary_edge,
    cancelled,
    measured_rings,
    outline_rings,
    places_of,
)
from bern_exact.exact.points import HPoint, direction, grid_point
from bern_exact.exact.predicates import is_in_wedge, side
from bern_exact.interior.records import Rectilinear
from bern_exact.plane.polygon import Polygon

STAGE = "warped"
FACES = "boundary"

Instance = tuple[int, int, int]
Target = GridNode | Instance


def check_warping(warped: Warped, *, tau: mpq = bounds.TAU) -> list[Finding]:
    """Check where nodes go (Section 2, both substeps), from the record alone.

    Parameters
    ----------
    warped : Warped
        Where every node goes.
    tau : mpq
        The snapping threshold in grid units.

    Notes
    -----
    Linear time.
    """
    return [
        _check_corners(warped),
        *_check_choosers(warped, tau),
        _check_on_boundary(warped),
    ]


def _check_corners(warped: Warped) -> Finding:
    """Substep 1: each vertex takes a corner of its square and its instances on both edges.

    Of a block of four squares it is the corner in the middle.
    """
    framed = warped.traced.diced.framed
    polygon = framed.polygon
    points, broken = polygon.points, Violations()
    taken: dict[GridNode, int] = {}
    boxes = blocks(framed)
    for v, (column, row) in enumerate(squares(polygon)):
        corner = warped.corners[v]
        before, after = points[polygon.before[v]], points[polygon.after[v]]
        fits = corner[0] - column in (0, 1) and corner[1] - row in (0, 1)
        if framed.blocks == "corner":
            (x, y), _ = boxes[v]
            fits &= corner == (x + 1, y + 1)
        fits &= all(warped.instances.get((e, *corner)) == v for e in (v, polygon.before[v]))
        if is_in_wedge(grid_point(*corner), before, points[v], after):
            fits &= warped.moved.get(corner) == v
            taken[corner] = v
        broken.case(fits, {"vertex of P'": v, "corner": corner})
    for node, target in sorted(warped.moved.items()):
        if not isinstance(target, tuple) and target < polygon.n and taken.get(node) != target:
            broken.broken({"grid vertex": node, "vertex of P'": target})
    return broken.finding(
        "warping.corner",
        STAGE,
        "each vertex of P' takes a corner of its square, inside P' or as instances on both edges, "
        "and no other grid vertex moves to a vertex",
    )


def _check_choosers(warped: Warped, tau: mpq) -> list[Finding]:
    """Substep 2: few choosers, of which the nearest wins, from less than tau away."""
    n = warped.traced.diced.framed.polygon.n
    choosers: dict[Target, list[int]] = defaultdict(list)
    for j, target in warped.choices.items():
        choosers[target].append(j)
    most, furthest, broken = Extreme(greatest=True), Extreme(greatest=True), Violations()
    for target, chosen_by in choosers.items():
        most.offer(len(chosen_by), 1, {"chosen": target, "crossings": chosen_by})
        moved_to = _mover(warped, target)
        distances = {n + j: _squared_shift(warped, j, target) for j in chosen_by}
        nearest = moved_to in distances and distances[moved_to] == min(distances.values())
        broken.case(nearest, {"chosen": target, "moved to": moved_to})
    for target, moved_to in _moves(warped):
        if isinstance(moved_to, tuple) or moved_to < n:
            continue
        if target not in choosers:
            broken.broken({"moved but not chosen": target})
        shift = _squared_shift(warped, moved_to - n, target)
        furthest.offer(shift.numerator, shift.denominator, {"moved": target, "to": moved_to})
    return [
        most.finding(
            "warping.choosers",
            STAGE,
            "at most two q-vertices choose the same grid vertex or exterior instance",
            bounds.CHOOSERS,
        ),
        broken.finding(
            "warping.nearest-chooser",
            STAGE,
            "what was chosen, and nothing else, moves in substep 2, to its nearest chooser",
        ),
        furthest.finding(
            "warping.displacement",
            STAGE,
            "a grid vertex or instance moves by less than tau in substep 2 (squared, in b^2)",
            tau * tau,
            strict=True,
        ),
    ]


def _mover(warped: Warped, target: Target) -> Node | None:
    """What a chosen grid vertex or instance moved to."""
    return warped.moved.get(target) if len(target) == 2 else warped.instances.get(target)


def _moves(warped: Warped) -> Iterator[tuple[Target, Node]]:
    yield from warped.moved.items()
    yield from warped.instances.items()


def _squared_shift(warped: Warped, j: int, target: Target) -> mpq:
    """The squared distance of a crossing, before warping, from a grid vertex or instance."""
    q = warped.traced.diced.crossings[j]
    across, along = target[-2:] if q.axis == 0 else (target[-1], target[-2])
    return (q.line - across) ** 2 + (q.at - along) ** 2


def _check_on_boundary(warped: Warped) -> Finding:
    """Every crossing ends exactly on its own edge or at another final node of the boundary."""
    diced = warped.traced.diced
    polygon, n = diced.framed.polygon, diced.framed.polygon.n
    broken = Violations()
    for j, (q, image, point) in enumerate(
        zip(diced.crossings, warped.image, warped.points, strict=True)
    ):
        if isinstance(image, tuple) or not 0 <= image < n + len(diced.crossings):
            fits = False
        elif image == n + j:
            fits = is_inside_edge(polygon, q.edge, point)
        elif image < n:
            fits = point == polygon.points[image] and q.edge in (image, polygon.before[image])
        else:
            final = image - n
            fits = warped.image[final] == image and point == warped.points[final]
            fits &= diced.crossings[final].edge == q.edge
        broken.case(fits, {"crossing": j, "image": image})
    return broken.finding(
        "warping.on-boundary",
        STAGE,
        "every q-vertex ends inside its own edge, or merged with a q-vertex or an end of that edge",
    )


def is_inside_edge(polygon: Polygon, edge: int, p: HPoint) -> bool:
    """Does p lie on this edge, strictly between its ends?"""
    if side(polygon.lines[edge], p) != 0:
        return False
    a, b = polygon.points[edge], polygon.points[polygon.after[edge]]
    # No edge is vertical here, but this holds for those too.
    axis = 0 if a[0] * b[2] != b[0] * a[2] else 1
    from_a = p[axis] * a[2] - a[axis] * p[2]
    from_b = p[axis] * b[2] - b[axis] * p[2]
    return bool(from_a * from_b < 0)


def check_faces(mesh: NearBoundary, region: Rectilinear, *, tau: mpq = bounds.TAU) -> list[Finding]:
    """Check the faces near the boundary after warping (Section 2 and Lemma 2's first half).

    Parameters
    ----------
    mesh : BoundaryMesh or MergedMesh
        The touched faces, before and after warping; faces that were merged are found again.
    region : Rectilinear
        Q, which covers the rest of P'.
    tau : mpq
        The snapping threshold in grid units.

    Notes
    -----
    Linear time, but for hashing.
    """
    shapes = _Shapes(mesh)
    for number, (ring, block) in enumerate(measured_rings(mesh)):
        shapes.add(number, ring, block)
    return [*_check_moved(mesh), *shapes.findings(tau), _check_area(mesh, region, shapes)]


def _check_moved(mesh: NearBoundary) -> list[Finding]:
    """How many corners of each face move in substep 1, before faces split or vanish."""
    moved, n = mesh.warped.moved, mesh.warped.traced.diced.framed.polygon.n
    most = Extreme(greatest=True)
    for face in mesh.touched:
        targets = [moved[node] for node in face.ring if isinstance(node, tuple) and node in moved]
        first = sum(not isinstance(target, tuple) and target < n for target in targets)
        most.offer(first, 1, face.ring)
    return [
        most.finding(
            "warping.moved-a-face",
            FACES,
            "at most one grid vertex of each face moves in substep 1",
            bounds.MOVED_BY_VERTICES_A_FACE,
        )
    ]


class _Shapes:
    """Edge lengths, slopes, corners and sides of the warped faces, in one pass."""

    def __init__(self, mesh: NearBoundary) -> None:
        self.places = places_of(mesh)
        self.warped = mesh.warped
        self._lines = mesh.warped.traced.diced.framed.polygon.lines
        self.shortest = Extreme()
        self.steepest = Extreme(greatest=True)
        self.most_sides = Extreme(greatest=True)
        self.bent, self.shared = Violations(), Violations()

    def add(self, number: int, ring: Ring, block: int) -> None:
        """Measure one face."""
        outside = block < 0
        points = [self.places[node] for node in ring]
        runs, edges = [], set()
        for i, b in enumerate(ring):
            a, p, q = ring[i - 1], points[i - 1], points[i]
            dx, dy = run = direction(p, q)
            runs.append(run)
            w = p[2] * q[2]
            self.shortest.offer(dx * dx + dy * dy, w * w, (number, (a, b)))
            edge = boundary_edge(self.warped, a, b) if outside else -1
            if edge >= 0:
                edges.add(edge)
            elif outside:
                low, high = sorted((abs(dx), abs(dy)))
                self.steepest.offer(low, high or 1, (number, (a, b)))
        if outside:
            self.shared.case(self._may_share(edges), (number, ring))
            self.most_sides.offer(len(ring), 1, (number, ring))
            turns = zip(runs, [*runs[1:], *runs[:1]], strict=True)
            convex = all(u[0] * v[1] >= u[1] * v[0] for u, v in turns)
            self.bent.case(convex, (number, ring))

    def _may_share(self, edges: set[int]) -> bool:
        """May one face have sides on these edges: at most two, slopes of the same sign?"""
        rising = {line[0] * line[1] < 0 for line in map(self._lines.__getitem__, edges)}
        return len(edges) <= bounds.EDGES_A_FACE and len(rising) <= 1

    def findings(self, tau: mpq) -> list[Finding]:
        """What was measured, against the bounds."""
        describe = self.places.describe
        return [
            self.shortest.finding(
                "warping.edge-length",
                FACES,
                "every edge of a face near the boundary is at least tau long (squared, in b^2)",
                bounds.edge_squared(tau),
                describe=describe,
            ),
            self.steepest.finding(
                "warping.slope",
                FACES,
                "outside the blocks every piece of an interval has slope at most 2 tau to its axis",
                bounds.slope(tau),
                describe=describe,
            ),
            self.bent.finding(
                "warping.convex",
                FACES,
                "every face outside the blocks is convex (180 degrees allowed)",
                describe=describe,
            ),
            self.shared.finding(
                "warping.boundary-sides",
                FACES,
                "every face outside the blocks has sides on at most two edges of P', whose slopes "
                "have the same sign",
                describe=describe,
            ),
            self.most_sides.finding(
                "warping.sides",
                FACES,
                "every face outside the blocks has at most six sides",
                bounds.FACE_SIDES,
                describe=describe,
            ),
        ]


def _check_area(mesh: NearBoundary, region: Rectilinear, shapes: _Shapes) -> Finding:
    """Faces and Q together have exactly the area of P', by cancelling edges.

    Each directed edge must cancel against its reverse, but for those that make
    up, one after the other, an edge of P'.  Areas are sums of cross products over
    directed edges, and pieces of one line add up to the whole: so the areas are equal,
    with no sum of rationals.  It says more: face by face, sides fit exactly.
    """
    broken = Violations()
    open_edges = cancelled((*outline_rings(mesh), *region.loops), broken)
    polygon = mesh.warped.traced.diced.framed.polygon
    onward: dict[tuple[int, Node], int] = {}
    for a, b in open_edges:
        edge = boundary_edge(mesh.warped, a, b)
        if edge < 0 or isinstance(b, tuple):
            broken.broken((None, (a, b)))
        else:
            onward[edge, a] = b
    for edge, head in polygon.edges():
        broken.case(_runs_along(polygon, edge, head, onward, shapes.places), (edge, (edge, head)))
    if onward:
        edge, node = next(iter(onward))
        broken.broken((edge, (node,)))
    return broken.finding(
        "warping.area",
        FACES,
        "the faces near the boundary and Q fit together edge by edge and fill P': their total "
        "area is that of P' exactly",
        describe=shapes.places.describe,
    )


def _runs_along(
    polygon: Polygon,
    edge: int,
    head: int,
    onward: dict[tuple[int, Node], int],
    places: Places,
) -> bool:
    """Do pieces lead from the tail to the head of an edge, forwards, on it?  They are used up."""
    line = polygon.lines[edge]
    forward = direction(polygon.points[edge], polygon.points[head])
    node: int | None = edge
    while node != head:
        following = onward.pop((edge, node), None) if node is not None else None
        if following is None or node is None:
            return False
        step = direction(places[node], places[following])
        if forward[0] * step[0] + forward[1] * step[1] <= 0 or side(line, places[following]) != 0:
            return False
        node = following
    return True
