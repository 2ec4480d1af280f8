"""Damages of the lists: vertices and triangles missing, repeated, turned over, misnumbered."""

from __future__ import annotations

from bern_exact.exact.points import HPoint
from bern_exact.oracle.defects.records import Change, a_damage
from bern_exact.oracle.defects.sound import Sound
from bern_exact.oracle.verdict import DEFECTS
from bern_exact.plane.mesh import Mesh, Triangle

# A vertex inside becomes one of the boundary, and is no vertex of the polygon's edges.
BARED = "boundary-vertex-off-edge"


def _spared(sound: Sound) -> list[int]:
    """The triangles without which every vertex is still used."""
    return [
        t for t, corners in enumerate(sound.triangles) if all(len(sound.at[v]) > 1 for v in corners)
    ]


def _behind(sound: Sound, t: int) -> list[tuple[int, int]]:
    """The edges by which other triangles lie against a triangle."""
    a, b, c = sound.triangles[t]
    return [edge for edge in ((b, a), (c, b), (a, c)) if edge in sound.owner]


@a_damage("region-not-covered", besides=[BARED])
def triangle_dropped(sound: Sound) -> Change | None:
    """One triangle is left out."""
    t = sound.some([t for t in _spared(sound) if _behind(sound, t)])
    if t is None:
        return None
    edge = _behind(sound, t)[0]
    kept = sound.triangles[:t] + sound.triangles[t + 1 :]
    return Change(Mesh(sound.vertices, kept), sound.polygon, {"edge": list(edge)})


@a_damage("edge-used-twice", besides=["overlap", BARED], needs_polygon=False)
def triangle_doubled(sound: Sound) -> Change | None:
    """One triangle is there twice."""
    a, b, c = sound.triangles[sound.random.randrange(len(sound.triangles))]
    return Change(sound.mesh(more=[(b, c, a)]), sound.polygon, {"edge": [a, b]})


@a_damage("clockwise-triangle", needs_polygon=False)
def triangle_clockwise(sound: Sound) -> Change | None:
    """Two corners of a triangle are exchanged: it runs clockwise."""
    t = sound.random.randrange(len(sound.triangles))
    a, b, c = sound.triangles[t]
    return Change(sound.mesh(replaced={t: (b, a, c)}), sound.polygon, {"triangle": t})


@a_damage("clockwise-triangle", needs_polygon=False)
def mesh_clockwise(sound: Sound) -> Change | None:
    """All triangles run clockwise, as where y points down."""
    turned = tuple((a, c, b) for a, b, c in sound.triangles)
    return Change(Mesh(sound.vertices, turned), sound.polygon, {"triangle": 0})


@a_damage("edge-used-twice", besides=["overlap"], needs_polygon=False)
def mesh_doubled(sound: Sound) -> Change | None:
    """Every triangle is there twice."""
    a, b, _ = sound.triangles[0]
    return Change(sound.mesh(more=sound.triangles), sound.polygon, {"edge": [a, b]})


@a_damage("duplicate-vertex", besides=["edge-used-twice", "overlap"], needs_polygon=False)
def mesh_copied(sound: Sound) -> Change | None:
    """The whole mesh lies on a copy of itself, with vertices of its own."""
    n = len(sound.vertices)
    copies = [(a + n, b + n, c + n) for a, b, c in sound.triangles]
    mesh = sound.mesh(added=sound.vertices, more=copies)
    return Change(mesh, sound.polygon, {"vertex": n})


@a_damage("region-not-covered", needs_polygon=False)
def mesh_emptied(sound: Sound) -> Change | None:
    """Nothing is left of the mesh, judged without a polygon."""
    return Change(Mesh((), ()), None)


@a_damage("index-out-of-range", besides=["region-not-covered", BARED])
def index_too_large(sound: Sound) -> Change | None:
    """A corner is the vertex after the last."""
    return _misnumbered(sound, len(sound.vertices))


@a_damage("index-out-of-range", besides=["region-not-covered", BARED])
def index_negative(sound: Sound) -> Change | None:
    """A corner is counted from the end, as Python lets it be: -1 for the last vertex."""
    return _misnumbered(sound, None)


def _misnumbered(sound: Sound, index: int | None) -> Change | None:
    """One corner of a triangle replaced by an index, or counted from the end."""
    t = sound.some(_spared(sound))
    if t is None:
        return None
    a, b, c = sound.triangles[t]
    wrong = a - len(sound.vertices) if index is None else index
    return Change(sound.mesh(replaced={t: (wrong, b, c)}), sound.polygon, {"triangle": t})


@a_damage("index-out-of-range", besides=DEFECTS, needs_polygon=False)
def indices_from_one(sound: Sound) -> Change | None:
    """All vertices are counted from 1."""
    counted = tuple((a + 1, b + 1, c + 1) for a, b, c in sound.triangles)
    last = len(sound.vertices)
    t = next(t for t, corners in enumerate(counted) if last in corners)
    return Change(Mesh(sound.vertices, counted), sound.polygon, {"triangle": t})


@a_damage("repeated-index", needs_polygon=False)
def index_repeated(sound: Sound) -> Change | None:
    """A triangle is added that has a vertex twice."""
    a, b = sound.some(list(sound.owner)) or (0, 0)
    where = {"triangle": len(sound.triangles)}
    return Change(sound.mesh(more=[(a, b, b)]), sound.polygon, where)


@a_damage("duplicate-vertex", needs_polygon=False)
def vertex_duplicated(sound: Sound) -> Change | None:
    """A vertex is there twice, and one of its triangles has the copy."""
    v = sound.some([v for v, ts in enumerate(sound.at) if len(ts) > 1])
    if v is None:
        return None
    t, new = sound.shuffled(sound.at[v])[0], len(sound.vertices)
    a, b, c = (new if u == v else u for u in sound.triangles[t])
    mesh = sound.mesh(added=[sound.vertices[v]], replaced={t: (a, b, c)})
    return Change(mesh, sound.polygon, {"vertex": new})


@a_damage("duplicate-vertex", needs_polygon=False)
def vertices_not_shared(sound: Sound) -> Change | None:
    """Every triangle has three vertices of its own."""
    points: list[HPoint] = []
    triangles: list[Triangle] = []
    for corners in sound.triangles:
        n = len(points)
        triangles.append((n, n + 1, n + 2))
        points += [sound.vertices[v] for v in corners]
    first: dict[HPoint, int] = {}
    repeated = (v for v, p in enumerate(points) if first.setdefault(p, v) != v)
    v = next(repeated, None)
    if v is None:
        return None
    return Change(Mesh(tuple(points), tuple(triangles)), sound.polygon, {"vertex": v})


@a_damage("unused-vertex", needs_polygon=False)
def vertex_unused(sound: Sound) -> Change | None:
    """A vertex inside a triangle is added, and no triangle has it."""
    t = sound.random.randrange(len(sound.triangles))
    where = {"vertex": len(sound.vertices)}
    return Change(sound.mesh(added=[sound.inside(t)]), sound.polygon, where)


DAMAGES = (
    triangle_dropped,
    triangle_doubled,
    triangle_clockwise,
    mesh_clockwise,
    mesh_doubled,
    mesh_copied,
    mesh_emptied,
    index_too_large,
    index_negative,
    indices_from_one,
    index_repeated,
    vertex_duplicated,
    vertices_not_shared,
    vertex_unused,
)
