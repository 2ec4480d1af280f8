"""Damages at the boundary: vertices off it, corners missing, triangles outside, holes filled."""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.exact.points import HPoint, along, coordinates, hpoint
from bern_exact.oracle.defects.lists import BARED
from bern_exact.oracle.defects.records import Change, a_damage
from bern_exact.oracle.defects.sound import TINY, Edge, Sound, shifted
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import triangulate_polygon
from bern_exact.plane.validation import polygon_from_rings

MOVED = (BARED, "region-not-covered", "triangle-outside", "hole-filled")


@a_damage("boundary-vertex-off-edge", besides=["triangle-outside", "hole-filled"])
def boundary_vertex_outwards(sound: Sound) -> Change | None:
    """A vertex on an edge of the polygon is moved by next to nothing out of it."""
    return _off_edge(sound, -1)


@a_damage("boundary-vertex-off-edge", besides=["region-not-covered"])
def boundary_vertex_inwards(sound: Sound) -> Change | None:
    """A vertex on an edge of the polygon is moved by next to nothing into it."""
    return _off_edge(sound, 1)


def _off_edge(sound: Sound, sign: int) -> Change:
    sound, v = sound.with_vertex_on_edge()
    x, y = sound.normal(v, sound.ahead[v])
    point = sound.nudged(v, (sign * x, sign * y))
    return Change(sound.mesh(moved={v: point}), sound.polygon, {"vertex": v})


@a_damage("polygon-vertex-missing", besides=MOVED)
def polygon_vertex_moved(sound: Sound) -> Change | None:
    """A vertex of the polygon is moved by next to nothing."""
    v, i = sound.shuffled(sound.corners.items())[0]
    x, y = sound.normal(v, sound.ahead[v])
    point = sound.nudged(v, sound.shuffled([(x, y), (-y, x), (-x, -y), (y, -x)])[0])
    return Change(sound.mesh(moved={v: point}), sound.polygon, _vertex_place(sound, i))


@a_damage("polygon-vertex-missing", besides=MOVED)
def mesh_moved(sound: Sound) -> Change | None:
    """The whole mesh is moved by next to nothing."""
    a, b = sound.sides[0]
    step = sound.normal(a, b)
    points = tuple(shifted(p, step, TINY) for p in sound.vertices)
    mesh = Mesh(points, sound.triangles)
    missing = next(i for v, i in sound.corners.items() if sound.vertices[v] not in points)
    return Change(mesh, sound.polygon, _vertex_place(sound, missing))


@a_damage("polygon-vertex-missing", besides=["region-not-covered"])
def corner_cut_off(sound: Sound) -> Change | None:
    """The one triangle at a vertex of the polygon is left out, the vertex too."""
    for v in sound.shuffled(sound.corners):
        if len(sound.at[v]) > 1:
            continue
        t = sound.at[v][0]
        if all(len(sound.at[u]) > 1 for u in sound.triangles[t] if u != v):
            kept = sound.triangles[:t] + sound.triangles[t + 1 :]
            lower = [tuple(u - (u > v) for u in corners) for corners in kept]
            mesh = Mesh(
                sound.vertices[:v] + sound.vertices[v + 1 :],
                tuple((a, b, c) for a, b, c in lower),
            )
            return Change(mesh, sound.polygon, _vertex_place(sound, sound.corners[v]))
    return None


@a_damage("triangle-outside", besides=[BARED])
def triangle_outside(sound: Sound) -> Change | None:
    """A triangle is added outside an edge of the outer boundary."""
    a, b = sound.shuffled(sound.sides_of(outer=True))[0]
    p, q, new = sound.vertices[a], sound.vertices[b], len(sound.vertices)
    middle, normal, far = along(p, q, mpq(1, 2)), sound.normal(b, a), mpq(1, 2)
    while not sound.is_free((q, p, shifted(middle, normal, far))):
        far /= 2
    mesh = sound.mesh(added=[shifted(middle, normal, far)], more=[(b, a, new)])
    return Change(mesh, sound.polygon, {"edge": [a, new]})


@a_damage("triangle-outside", besides=[BARED])
def triangle_far_outside(sound: Sound) -> Change | None:
    """A triangle is added that touches nothing."""
    points = [coordinates(p) for p in sound.vertices]
    x, y = max(x for x, _ in points), max(y for _, y in points)
    width, n = x - min(x for x, _ in points), len(sound.vertices)
    corners = [(x + width, y), (x + 2 * width, y), (x + width, y + width)]
    mesh = sound.mesh(added=[hpoint(*c) for c in corners], more=[(n, n + 1, n + 2)])
    return Change(mesh, sound.polygon, {"edge": [n, n + 1]})


@a_damage("triangle-outside")
def pocket_covered(sound: Sound) -> Change | None:
    """A triangle is added over a reflex corner of the outer boundary."""
    return _corner_covered(sound, sound.sides_of(outer=True))


@a_damage("hole-filled")
def hole_bridged(sound: Sound) -> Change | None:
    """A triangle is added over a corner of a hole, of which some is left."""
    sides = [(a, b) for a, b in sound.sides_of(outer=False) if len(_loop(sound, a)) > 3]
    return _corner_covered(sound, sides)


def _corner_covered(sound: Sound, sides: list[Edge]) -> Change | None:
    for u, v in sound.shuffled(sides):
        w = sound.ahead[v]
        if sound.turn(u, v, w) < 0 and sound.is_free([sound.vertices[i] for i in (u, w, v)]):
            return Change(sound.mesh(more=[(u, w, v)]), sound.polygon, {"edge": [u, w]})
    return None


@a_damage("hole-filled")
def hole_filled(sound: Sound) -> Change | None:
    """A hole is triangulated."""
    side = sound.some(sound.sides_of(outer=False))
    if side is None or sound.polygon is None:
        return None
    loop = _loop(sound, side[0])[::-1]
    ring = Polygon(tuple(sound.vertices[v] for v in loop), (tuple(range(len(loop))),))
    more = [(loop[a], loop[b], loop[c]) for a, b, c in triangulate_polygon(ring).triangles()]
    where = {"polygon_edge": list(sound.polygon.edge_place(sound.polygon_edge[side]))}
    return Change(sound.mesh(more=more), sound.polygon, where)


def _loop(sound: Sound, start: int) -> list[int]:
    """The boundary vertices from one round to it again, interior on the left."""
    loop = [start]
    while sound.ahead[loop[-1]] != start:
        loop.append(sound.ahead[loop[-1]])
    return loop


def _vertex_place(sound: Sound, i: int) -> dict[str, list[int]]:
    """The polygon's vertex i as a place."""
    place = sound.polygon.place(i) if sound.polygon is not None else ()
    return {"polygon_vertex": list(place)}


# The mesh is as it was, the polygon another ------------------------------------------


@a_damage("region-not-covered", besides=[BARED])
def hole_not_in_polygon(sound: Sound) -> Change | None:
    """The polygon is one without one of the mesh's holes."""
    side = sound.some(sound.sides_of(outer=False))
    if side is None or sound.polygon is None:
        return None
    rings = _rings(sound.polygon)
    del rings[sound.polygon.ring_of[sound.polygon_edge[side]]]
    mesh = Mesh(sound.vertices, sound.triangles)
    return Change(mesh, polygon_from_rings(rings, sound.polygon.name), {"edge": list(side)})


@a_damage("hole-filled", besides=["polygon-vertex-missing"])
def hole_in_polygon_alone(sound: Sound) -> Change | None:
    """The polygon is one with a hole inside one of the mesh's triangles."""
    if sound.polygon is None:
        return None
    t = sound.random.randrange(len(sound.triangles))
    weights = ((4, 1, 1), (1, 4, 1), (1, 1, 4))
    rings = [*_rings(sound.polygon), [sound.inside(t, each) for each in weights]]
    mesh = Mesh(sound.vertices, sound.triangles)
    where = {"polygon_edge": [len(rings) - 1, 0]}
    return Change(mesh, polygon_from_rings(rings, sound.polygon.name), where)


@a_damage("polygon-vertex-missing")
def vertex_in_polygon_alone(sound: Sound) -> Change | None:
    """The polygon is one with a 180-degree vertex where the mesh has none."""
    if sound.polygon is None:
        return None
    side = sound.shuffled(sound.sides)[0]
    r, i = sound.polygon.edge_place(sound.polygon_edge[side])
    rings = _rings(sound.polygon)
    rings[r].insert(i + 1, along(sound.vertices[side[0]], sound.vertices[side[1]], mpq(1, 3)))
    mesh = Mesh(sound.vertices, sound.triangles)
    where = {"polygon_vertex": [r, i + 1]}
    return Change(mesh, polygon_from_rings(rings, sound.polygon.name), where)


def _rings(polygon: Polygon) -> list[list[HPoint]]:
    """The rings as they were read."""
    return [list(polygon.input_ring(r)) for r in range(len(polygon.rings))]


DAMAGES = (
    boundary_vertex_outwards,
    boundary_vertex_inwards,
    polygon_vertex_moved,
    mesh_moved,
    corner_cut_off,
    triangle_outside,
    triangle_far_outside,
    pocket_covered,
    hole_bridged,
    hole_filled,
    hole_not_in_polygon,
    hole_in_polygon_alone,
    vertex_in_polygon_alone,
)
