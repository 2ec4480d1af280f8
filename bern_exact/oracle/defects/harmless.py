"""Changes after which a mesh is as valid as before."""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.exact.points import along
from bern_exact.oracle.defects.records import Change, a_damage
from bern_exact.oracle.defects.sound import Sound
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.validation import polygon_from_rings


@a_damage(None)
def vertex_moved_along_edge(sound: Sound) -> Change | None:
    """A vertex on an edge of the polygon is moved along it."""
    sound, v = sound.with_vertex_on_edge()
    part = mpq(1, 10)
    ahead = sound.vertices[sound.ahead[v]]
    while not sound.stays(v, point := along(sound.vertices[v], ahead, part)):
        part /= 10
    return Change(sound.mesh(moved={v: point}), sound.polygon)


@a_damage(None, needs_polygon=False)
def vertex_moved_inside(sound: Sound) -> Change | None:
    """A vertex inside is moved by next to nothing."""
    sound = sound.with_inner_vertex()
    v = sound.shuffled(v for v in range(len(sound.vertices)) if v not in sound.boundary)[0]
    point = sound.nudged(v, sound.normal(*sound.sides[0]))
    return Change(sound.mesh(moved={v: point}), sound.polygon)


@a_damage(None, needs_polygon=False)
def everything_renumbered(sound: Sound) -> Change | None:
    """Vertices and triangles are listed in another order, triangles from another corner on."""
    order = sound.shuffled(range(len(sound.vertices)))
    new = {v: i for i, v in enumerate(order)}
    triangles = []
    for a, b, c in sound.shuffled(sound.triangles):
        k = sound.random.randrange(3)
        corners = (new[a], new[b], new[c]) * 2
        triangles.append((corners[k], corners[k + 1], corners[k + 2]))
    mesh = Mesh(tuple(sound.vertices[v] for v in order), tuple(triangles))
    return Change(mesh, sound.polygon)


@a_damage(None, needs_polygon=False)
def boundary_edge_split(sound: Sound) -> Change | None:
    """An edge of the boundary gets a new vertex, its triangle is split."""
    a, b = sound.shuffled(sound.sides)[0]
    return _as_is(sound.with_edge_split(a, b, mpq(1, 3)))


@a_damage(None, needs_polygon=False)
def inner_edge_split(sound: Sound) -> Change | None:
    """An edge inside gets a new vertex, both triangles are split."""
    edge = sound.some(sound.inner_edges)
    return None if edge is None else _as_is(sound.with_edge_split(*edge, mpq(1, 3)))


@a_damage(None, needs_polygon=False)
def triangle_split(sound: Sound) -> Change | None:
    """A triangle is split in three at a new vertex inside."""
    return _as_is(sound.with_triangle_split(sound.random.randrange(len(sound.triangles))))


@a_damage(None, needs_polygon=False)
def edge_flipped(sound: Sound) -> Change | None:
    """An edge is exchanged for the other diagonal of a convex quadrilateral."""
    for a, b in sound.shuffled(sound.inner_edges):
        flipped = sound.with_edge_flipped(a, b)
        if flipped is not None:
            return Change(flipped, sound.polygon)
    return None


@a_damage(None)
def rings_reversed(sound: Sound) -> Change | None:
    """The polygon's rings are read the other way round, from another vertex on."""
    if sound.polygon is None:
        return None
    rings = []
    for r in range(len(sound.polygon.rings)):
        ring = sound.polygon.input_ring(r)
        k = sound.random.randrange(len(ring))
        rings.append([*ring[k::-1], *ring[:k:-1]])
    mesh = Mesh(sound.vertices, sound.triangles)
    return Change(mesh, polygon_from_rings(rings, sound.polygon.name))


def _as_is(sound: Sound) -> Change:
    return Change(Mesh(sound.vertices, sound.triangles), sound.polygon)


DAMAGES = (
    vertex_moved_along_edge,
    vertex_moved_inside,
    everything_renumbered,
    boundary_edge_split,
    inner_edge_split,
    triangle_split,
    edge_flipped,
    rings_reversed,
)
