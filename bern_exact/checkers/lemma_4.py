"""Lemma 4: merged faces are monotone, between an edge and a staircase."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence
from itertools import pairwise

from gmpy2 import mpq

from bern_exact.boundary.records import MergedFace, MergedMesh, Node
from bern_exact.checkers import bounds
from bern_exact.checkers.extremes import Extreme, Violations
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.rings import (
    Ring,
    boundary_edge,
    cancelled,
    merged_ring,
    places_of,
    warped_rings,
)
from bern_exact.exact.points import HPoint, Line, direction
from bern_exact.exact.predicates import dot, side

STAGE = "merged"


def check_lemma_4(mesh: MergedMesh, *, tau: mpq = bounds.TAU) -> list[Finding]:
    """Check Lemma 4, and that faces are merged where its proof merges them.

    Parameters
    ----------
    mesh : MergedMesh
        The merged faces; their warped faces are found again from the arrangement.
    tau : mpq
        The snapping threshold in grid units.

    Notes
    -----
    Linear time, but for hashing.
    """
    faces = [item.merged for item in mesh.projected]
    merging = _Merging(mesh)
    return [
        _check_base(mesh, faces),
        _check_monotone(mesh, faces),
        *_check_staircase(mesh, faces, tau),
        merging.once(faces),
        merging.unions(faces),
        merging.where(faces),
    ]


def has_positive_slope(line: Line) -> bool:
    """Does the line a x + b y + c = 0 rise to the right?

    >>> has_positive_slope((-1, 1, 0))
    True
    """
    return bool(line[0] * line[1] < 0)


def level(line: Line, p: HPoint) -> mpq:
    """t = x + y for an edge of positive slope, x - y for one of negative slope.

    Constant along the diagonals that are projected along, one to one along the edge.
    """
    x, y, w = p
    return mpq(x + y if has_positive_slope(line) else x - y, w)


def _check_base(mesh: MergedMesh, faces: Sequence[MergedFace]) -> Finding:
    """The base: nodes on e, strictly from tail to head, between the ends of the staircase."""
    polygon, places = mesh.warped.traced.diced.framed.polygon, places_of(mesh)
    broken = Violations()
    for face in faces:
        line = polygon.lines[face.edge]
        forward = direction(polygon.points[face.edge], polygon.points[polygon.after[face.edge]])
        points = [places[node] for node in face.base]
        fits = len(points) > 1 and all(side(line, p) == 0 for p in points)
        fits &= all(dot(forward, direction(p, q)) > 0 for p, q in pairwise(points))
        fits &= (face.base[0], face.base[-1]) == (face.staircase[0], face.staircase[-1])
        broken.case(fits, (face.edge, face.base))
    return broken.finding(
        "lemma-4.base",
        STAGE,
        "each merged face has a base on its edge e, and a staircase from its one end to the other",
        describe=places.describe,
    )


def _check_monotone(mesh: MergedMesh, faces: Sequence[MergedFace]) -> Finding:
    """Round M, t rises once and falls once: each diagonal meets M in one interval.

    It changes in one sense along the base, and must along the staircase too, but for its first
    and last edge, which join it to e.
    """
    polygon, places = mesh.warped.traced.diced.framed.polygon, places_of(mesh)
    broken = Violations()
    for face in faces:
        line = polygon.lines[face.edge]
        levels = [level(line, places[node]) for node in face.staircase]
        sense = level(line, places[face.base[-1]]) - level(line, places[face.base[0]])
        steps = [(after - before) * sense for before, after in pairwise(levels)]
        fits = all(step > 0 for step in steps[1:-1]) and 0 not in steps
        broken.case(fits, (face.edge, face.staircase))
    return broken.finding(
        "lemma-4.monotone",
        STAGE,
        "each merged face is monotone: x + y (x - y for an edge of negative slope) changes "
        "along its staircase strictly as along e, but for the edges that join it to e",
        describe=places.describe,
    )


def _check_staircase(mesh: MergedMesh, faces: Sequence[MergedFace], tau: mpq) -> list[Finding]:
    """Staircase edges: almost axis-parallel, or on edges of P' whose slope has the sign of e's."""
    polygon, places = mesh.warped.traced.diced.framed.polygon, places_of(mesh)
    steepest, other_sign = Extreme(greatest=True), Violations()
    for face in faces:
        rises = has_positive_slope(polygon.lines[face.edge])
        for a, b in pairwise(face.staircase):
            edge = boundary_edge(mesh.warped, a, b)
            if edge >= 0:
                same = has_positive_slope(polygon.lines[edge]) == rises
                other_sign.case(same, (face.edge, (a, b)))
            else:
                dx, dy = direction(places[a], places[b])
                low, high = sorted((abs(dx), abs(dy)))
                steepest.offer(low, high or 1, (face.edge, (a, b)))
    return [
        steepest.finding(
            "lemma-4.slope",
            STAGE,
            "every staircase edge inside P' has slope at most 2 tau to an axis",
            bounds.slope(tau),
            describe=places.describe,
        ),
        other_sign.finding(
            "lemma-4.clipped",
            STAGE,
            "every other staircase edge lies along an edge of P' whose slope has the sign of e's",
            describe=places.describe,
        ),
    ]


class _Merging:
    """Which warped faces are merged, and where, from the arrangement alone."""

    def __init__(self, mesh: MergedMesh) -> None:
        self.mesh = mesh
        self.places = places_of(mesh)
        self.found = warped_rings(mesh)
        self.face_at: dict[tuple[Node, Node], int] = {
            (ring[i - 1], node): number
            for number, (ring, _) in enumerate(self.found)
            for i, node in enumerate(ring)
        }

    def _known(self, face: MergedFace) -> list[Ring]:
        """The rings of a merged face's faces; an index out of range is none's."""
        return [self.found[i][0] for i in face.faces if 0 <= i < len(self.found)]

    def once(self, faces: Sequence[MergedFace]) -> Finding:
        """Each face outside the blocks with a piece of the boundary is in one merged face."""
        uses = Counter(number for face in faces for number in face.faces)
        kept = Counter((face.ring, face.source) for face in self.mesh.faces)
        broken = Violations()
        for number, (ring, source) in enumerate(self.found):
            outside = self.mesh.touched[source].block < 0
            supported = outside and any(
                boundary_edge(self.mesh.warped, ring[i - 1], node) >= 0
                for i, node in enumerate(ring)
            )
            fits = (uses.pop(number, 0), kept.pop((ring, source), 0)) == (supported, not supported)
            broken.case(fits, (number, ring))
        for stranger in (*uses, *kept):
            broken.broken((stranger, ()))
        return broken.finding(
            "lemma-4.once",
            STAGE,
            "each face outside the blocks with a piece of the boundary is in exactly one merged "
            "face, and no other face is in any",
            describe=self.places.describe,
        )

    def unions(self, faces: Sequence[MergedFace]) -> Finding:
        """The boundary of M is what the edges of its faces leave when they cancel."""
        broken = Violations()
        for face in faces:
            left = cancelled(self._known(face), broken)
            ring = merged_ring(face)
            own = {(ring[i - 1], node) for i, node in enumerate(ring)}
            distinct = len(set(ring)) == len(ring)
            broken.case(distinct and own == left.keys(), (face.edge, ring))
        return broken.finding(
            "lemma-4.union",
            STAGE,
            "each merged face is the union of its faces, with a simple boundary",
            describe=self.places.describe,
        )

    def where(self, faces: Sequence[MergedFace]) -> Finding:
        """Two neighbours along e are merged exactly if a single grid edge hits e between them.

        Faces that an earlier edge has taken are no neighbours.
        """
        owner = {(face.edge, number): i for i, face in enumerate(faces) for number in face.faces}
        grid_images = {self.mesh.warped.image_of(node) for node in self.mesh.warped.moved}
        broken = Violations()
        for edge, pieces in self._pieces().items():
            for (a, b), (_, c) in pairwise(pieces):
                before, after = self.face_at[a, b], self.face_at[b, c]
                first, second = owner.get((edge, before)), owner.get((edge, after))
                if first is None or second is None:
                    continue
                may = before == after or (
                    b not in grid_images and self._is_single(b, before, after)
                )
                broken.case((first == second) == may, (edge, (a, b, c)))
        return broken.finding(
            "lemma-4.where",
            STAGE,
            "neighbouring faces along an edge are merged exactly where a single grid edge hits it, "
            "at no image of a grid vertex",
            describe=self.places.describe,
        )

    def _pieces(self) -> dict[int, list[tuple[Node, Node]]]:
        """The pieces of each edge of P' from its tail to its head, as the faces have them."""
        onward: dict[int, dict[Node, Node]] = defaultdict(dict)
        for a, b in self.face_at:
            edge = boundary_edge(self.mesh.warped, a, b)
            if edge >= 0:
                onward[edge][a] = b
        return {edge: _chain(edge, following) for edge, following in sorted(onward.items())}

    def _is_single(self, node: Node, before: int, after: int) -> bool:
        """Is the edge inwards from a node the same on both sides?"""
        ring, following = self.found[before][0], self.found[after][0]
        inwards = ring[(ring.index(node) + 1) % len(ring)]
        return inwards == following[following.index(node) - 1]


def _chain(start: Node, onward: dict[Node, Node]) -> list[tuple[Node, Node]]:
    """The pairs that lead on from a node; each is used once."""
    pieces = []
    node = start
    while node in onward:
        following = onward.pop(node)
        pieces.append((node, following))
        node = following
    return pieces
