"""Damages inside: vertices moved, edges exchanged, triangles that overlap or leave gaps."""

from __future__ import annotations

from collections.abc import Iterator

from gmpy2 import mpq

from bern_exact.exact.points import HPoint, along
from bern_exact.oracle.defects.lists import BARED
from bern_exact.oracle.defects.records import Change, a_damage
from bern_exact.oracle.defects.sound import TINY, Edge, Sound, shifted
from bern_exact.plane.mesh import Mesh

HALF = mpq(1, 2)

PIECE = 8
"""How many triangles are moved together: few, so that all defects can be listed."""

# What may follow from triangles that lie the wrong way round: they are counted as turned over.
TANGLED = (
    "degenerate-triangle",
    "clockwise-triangle",
    "edge-used-twice",
    "hanging-vertex",
    "crossing-edges",
    "boundary-not-simple",
    "overlap",
    "triangle-outside",
    "hole-filled",
    "region-not-covered",
    BARED,
)


def _spokes(sound: Sound) -> list[tuple[int, Edge]]:
    """The vertices inside, each with every edge opposite to it, in some order."""
    inner = [v for v in range(len(sound.vertices)) if v not in sound.boundary]
    return sound.shuffled(
        (v, edge)
        for v in inner
        for t in sound.at[v]
        for edge in _edges(sound.triangles[t])
        if v not in edge
    )


def _edges(corners: tuple[int, int, int]) -> tuple[Edge, Edge, Edge]:
    a, b, c = corners
    return (a, b), (b, c), (c, a)


@a_damage("clockwise-triangle", besides=TANGLED, needs_polygon=False)
def vertex_across_edge(sound: Sound) -> Change | None:
    """A vertex inside is moved across the opposite edge of one of its triangles."""
    sound = sound.with_inner_vertex()
    v, (a, b) = _spokes(sound)[0]
    middle = along(sound.vertices[a], sound.vertices[b], HALF)
    beyond = along(sound.vertices[v], middle, mpq(1001, 1000))
    where = {"triangle": sound.owner[a, b]}
    return Change(sound.mesh(moved={v: beyond}), sound.polygon, where)


@a_damage("degenerate-triangle", needs_polygon=False)
def vertex_onto_edge(sound: Sound) -> Change | None:
    """A vertex inside is moved just onto the opposite edge of one of its triangles."""
    sound = sound.with_inner_vertex()
    for v, (a, b) in _spokes(sound):
        middle = along(sound.vertices[a], sound.vertices[b], HALF)
        # A little before the edge all triangles stay: then on it all others do.
        near = along(sound.vertices[v], middle, mpq(999_999, 1_000_000))
        if sound.stays(v, near):
            where = {"triangle": sound.owner[a, b]}
            others = [t for t in sound.at[v] if t != where["triangle"]]
            mesh = sound.mesh(moved={v: middle})
            if _are_upright(sound.other(mesh), others):
                return Change(mesh, sound.polygon, where)
    return None


def _are_upright(sound: Sound, triangles: list[int]) -> bool:
    """Do these triangles run counter-clockwise?"""
    return all(sound.turn(*sound.triangles[t]) > 0 for t in triangles)


@a_damage("degenerate-triangle", needs_polygon=False)
def sliver_inserted(sound: Sound) -> Change | None:
    """An edge is split for the triangle on one side alone, the gap closed by one without area."""
    a, b = sound.shuffled(sound.owner)[0]
    t, c, new = sound.owner[a, b], sound.apex(a, b), len(sound.vertices)
    mesh = sound.mesh(
        added=[along(sound.vertices[a], sound.vertices[b], HALF)],
        replaced={t: (a, new, c)},
        more=[(new, b, c), (a, b, new)],
    )
    return Change(mesh, sound.polygon, {"triangle": len(mesh.triangles) - 1})


def _quadrilaterals(sound: Sound) -> Iterator[tuple[Edge, int, int, int, int]]:
    """(ab, c, d, at a, at b): edges, the apexes on their left and right, the turns d-a-c, c-b-d."""
    for a, b in sound.shuffled(sound.inner_edges):
        c, d = sound.apex(a, b), sound.apex(b, a)
        yield (a, b), c, d, sound.turn(a, d, c), sound.turn(b, c, d)


@a_damage("clockwise-triangle", besides=TANGLED, needs_polygon=False)
def edge_flipped_wrongly(sound: Sound) -> Change | None:
    """An edge is exchanged for the other diagonal of a quadrilateral that is not convex."""
    for (a, b), c, d, at_a, at_b in _quadrilaterals(sound):
        if at_a < 0 or at_b < 0:
            t, s = sound.owner[a, b], sound.owner[b, a]
            mesh = sound.mesh(replaced={t: (a, d, c), s: (d, b, c)})
            return Change(mesh, sound.polygon, {"triangle": t if at_a < 0 else s})
    return None


@a_damage("edge-used-twice", besides=TANGLED, needs_polygon=False)
def edge_swapped_to_cross(sound: Sound) -> Change | None:
    """Likewise, but both triangles are written counter-clockwise."""
    for (a, b), c, d, at_a, at_b in _quadrilaterals(sound):
        t, s = sound.owner[a, b], sound.owner[b, a]
        if at_a < 0:
            mesh = sound.mesh(replaced={t: (a, c, d), s: (d, b, c)})
            return Change(mesh, sound.polygon, {"edge": [c, d]})
        if at_b < 0:
            mesh = sound.mesh(replaced={t: (a, d, c), s: (d, c, b)})
            return Change(mesh, sound.polygon, {"edge": [d, c]})
    return None


CROSSED = ("edge-used-twice", "overlap", "region-not-covered", BARED)


@a_damage("crossing-edges", besides=CROSSED)
def diagonals_crossed(sound: Sound) -> Change | None:
    """Of a convex quadrilateral's two triangles one is cut off by the other diagonal."""
    return _crossed(sound)


@a_damage("boundary-not-simple", besides=CROSSED, needs_polygon=False)
def boundary_crossed(sound: Sound) -> Change | None:
    """The same, judged without a polygon."""
    change = _crossed(sound)
    return None if change is None else Change(change.mesh, None, change.where)


def _crossed(sound: Sound) -> Change | None:
    for (a, b), c, d, at_a, at_b in _quadrilaterals(sound):
        if at_a > 0 and at_b > 0:
            t, s = sound.owner[a, b], sound.owner[b, a]
            where = {"edge": [a, b] if t < s else [d, c]}  # the one that is met first
            return Change(sound.mesh(replaced={s: (a, d, c)}), sound.polygon, where)
    return None


def _split_on_one_side(sound: Sound, aside: mpq) -> tuple[Mesh, int] | None:
    """A triangle cut in two from a corner to (nearly) the middle of an inner edge, and where.

    The new vertex, the last one, lies that far to the left of the middle of the edge that begins
    at the vertex returned: inside the triangle, or beyond the edge if negative.
    """
    edge = sound.some(sound.inner_edges)
    if edge is None:
        return None
    a, b = edge
    t, c, new = sound.owner[a, b], sound.apex(a, b), len(sound.vertices)
    point = along(sound.vertices[a], sound.vertices[b], HALF)
    if aside:
        # Upright as long as the vertex is nearer than the apexes on both sides.
        split = sound.with_edge_split(a, b, HALF)
        normal = sound.normal(a, b)
        point = split.nudged(new, normal if aside > 0 else (-normal[0], -normal[1]))
    return sound.mesh(added=[point], replaced={t: (a, new, c)}, more=[(new, b, c)]), a


@a_damage("hanging-vertex", needs_polygon=False)
def vertex_hanging(sound: Sound) -> Change | None:
    """An edge is split for the triangle on one side alone."""
    made = _split_on_one_side(sound, mpq(0))
    return made and Change(made[0], sound.polygon, {"vertex": len(sound.vertices)})


@a_damage("region-not-covered", besides=[BARED])
def crack_opened(sound: Sound) -> Change | None:
    """Likewise, and the new vertex is moved by next to nothing off the edge: a gap is left."""
    made = _split_on_one_side(sound, TINY)
    return made and Change(made[0], sound.polygon, {"edge": [made[1], len(sound.vertices)]})


@a_damage("overlap", besides=[BARED], needs_polygon=False)
def crack_overlapping(sound: Sound) -> Change | None:
    """Likewise, but to the other side: the triangles overlap by next to nothing."""
    made = _split_on_one_side(sound, -TINY)
    return made and Change(made[0], sound.polygon, {"edge": [made[1], len(sound.vertices)]})


@a_damage("overlap", besides=[BARED], needs_polygon=False)
def triangle_laid_over(sound: Sound) -> Change | None:
    """A small triangle with vertices of its own lies inside another."""
    t, n = sound.random.randrange(len(sound.triangles)), len(sound.vertices)
    points = [sound.inside(t, weights) for weights in ((4, 1, 1), (1, 4, 1), (1, 1, 4))]
    mesh = sound.mesh(added=points, more=[(n, n + 1, n + 2)])
    return Change(mesh, sound.polygon, {"edge": [n, n + 1]})


SHIFTED = ("polygon-vertex-missing", "hanging-vertex", "crossing-edges", "overlap") + (
    ("region-not-covered", "triangle-outside", "hole-filled", BARED)
)


@a_damage("region-not-covered", besides=SHIFTED)
def piece_moved_away(sound: Sound) -> Change | None:
    """A few triangles side by side are moved by next to nothing away from the others."""
    return _piece_moved(sound, TINY)


@a_damage("overlap", besides=SHIFTED)
def piece_moved_over(sound: Sound) -> Change | None:
    """A few triangles side by side are moved by next to nothing over the others."""
    return _piece_moved(sound, -TINY)


def _piece_moved(sound: Sound, far: mpq) -> Change | None:
    """A connected piece moved at right angles to an edge that it has in common with the rest."""
    piece = _piece(sound)
    seams = [(a, b) for a, b in sound.inner_edges if sound.owner[a, b] in piece]
    seam = sound.some([(a, b) for a, b in seams if sound.owner[b, a] not in piece])
    if seam is None:
        return None
    step, size = sound.normal(*seam), len(sound.vertices)
    number: dict[int, int] = {}
    replaced, moved = {}, {}
    added: list[HPoint] = []
    for t in piece:
        for v in sound.triangles[t]:
            if v in number:
                continue
            point = shifted(sound.vertices[v], step, far)
            if all(s in piece for s in sound.at[v]):
                number[v], moved[v] = v, point
            else:
                number[v] = size + len(added)
                added.append(point)
        a, b, c = sound.triangles[t]
        replaced[t] = (number[a], number[b], number[c])
    mesh = sound.mesh(moved=moved, added=added, replaced=replaced)
    return Change(mesh, sound.polygon, {"edge": [seam[1], seam[0]]})


def _piece(sound: Sound) -> dict[int, None]:
    """A few triangles, at most half of all, connected by edges, in the order of a walk."""
    most = min(PIECE, len(sound.triangles) // 2)
    piece = {sound.random.randrange(len(sound.triangles)): None}
    for t in (waiting := list(piece)):
        for a, b in _edges(sound.triangles[t]):
            s = sound.owner.get((b, a), t)
            if s not in piece and len(piece) < most:
                piece[s] = None
                waiting.append(s)
    return piece


DAMAGES = (
    vertex_across_edge,
    vertex_onto_edge,
    sliver_inserted,
    edge_flipped_wrongly,
    edge_swapped_to_cross,
    diagonals_crossed,
    boundary_crossed,
    vertex_hanging,
    crack_opened,
    crack_overlapping,
    triangle_laid_over,
    piece_moved_away,
    piece_moved_over,
)
