"""Strategies for triangulations."""

from __future__ import annotations

from gmpy2 import mpq
from hypothesis import strategies as st
from hypothesis.errors import InvalidArgument

from bern_exact.api import THEOREMS, triangulate
from bern_exact.oracle.defects.sound import Sound
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import triangulate_polygon
from bern_exact.strategies.options import check_integer
from bern_exact.strategies.polygons import convex_polygons, polygons_with_holes, simple_polygons

Step = tuple[str, int, int]
"""What is done, where, and how far along."""

WAYS = ("flip an edge", "split a triangle", "split an edge")


def triangulations(
    *,
    polygons: st.SearchStrategy[Polygon] | None = None,
    max_steps: int = 6,
    theorem: int | None = None,
) -> st.SearchStrategy[tuple[Polygon, Mesh]]:
    """Polygons, each with a valid triangulation of it.

    Parameters
    ----------
    polygons : SearchStrategy of Polygon, optional
        What is triangulated; any polygon, with holes or without, if it is not given, and for
        Theorems 2 and 4 one that they take.
    max_steps : int
        The triangulation by the polygon's vertices is changed by at most so many flips of edges
        and new vertices, inside triangles and on edges, the boundary's too.
    theorem : {1, 2, 3, 4}, optional
        The mesh is this theorem's instead, and has hundreds of triangles; no steps are made.

    Returns
    -------
    SearchStrategy of (Polygon, Mesh)
        The mesh's vertices begin with the polygon's, in its order.  They shrink to one triangle.

    Raises
    ------
    InvalidArgument
        At once, if an option is not what it must be.
    """
    if polygons is not None and not isinstance(polygons, st.SearchStrategy):
        raise InvalidArgument(f"polygons={polygons!r} must be a strategy")
    check_integer("max_steps", max_steps, 0)
    if theorem is not None and theorem not in THEOREMS:
        raise InvalidArgument(f"theorem={theorem!r} must be one of {', '.join(map(str, THEOREMS))}")
    if polygons is None:
        polygons = _polygons_for(theorem)
    if theorem is not None:
        return polygons.map(lambda polygon: (polygon, _by_theorem(polygon, theorem)))
    return _triangulations(polygons, max_steps)


def _polygons_for(theorem: int | None) -> st.SearchStrategy[Polygon]:
    """Polygons that a theorem takes, small ones: its meshes are large."""
    if theorem is None:
        return simple_polygons() | polygons_with_holes()
    if theorem == 4:
        return convex_polygons(max_vertices=6, max_value=1_000)
    plain = simple_polygons(max_vertices=6, max_value=1_000)
    if theorem == 2:
        return plain
    return plain | polygons_with_holes(max_vertices=5, max_holes=1, max_value=1_000)


def _by_theorem(polygon: Polygon, theorem: int) -> Mesh:
    return triangulate(polygon, theorem=theorem, check="none").mesh


@st.composite
def _triangulations(
    draw: st.DrawFn, polygons: st.SearchStrategy[Polygon], max_steps: int
) -> tuple[Polygon, Mesh]:
    polygon = draw(polygons)
    mesh = Mesh(polygon.points, tuple(triangulate_polygon(polygon).triangles()))
    steps = st.tuples(st.sampled_from(WAYS), st.integers(0, 10**6), st.integers(2, 10))
    for step in draw(st.lists(steps, max_size=max_steps)):
        mesh = _changed(Sound(mesh, polygon), step)
    return polygon, mesh


def _changed(sound: Sound, step: Step) -> Mesh:
    """The mesh after a step; the same if there is no edge to be flipped at this place."""
    way, number, part = step
    if way == "split a triangle":
        t = number % len(sound.triangles)
        changed = sound.with_triangle_split(t, (1, 1, part - 1))
    else:
        a, b = list(sound.owner)[number % len(sound.owner)]
        if way == "flip an edge":
            return sound.with_edge_flipped(a, b) or Mesh(sound.vertices, sound.triangles)
        changed = sound.with_edge_split(a, b, mpq(1, part))
    return Mesh(changed.vertices, changed.triangles)
