"""Hypothesis strategies: polygons and triangulations with exact rational coordinates.

    from hypothesis import given
    from bern_exact.strategies import simple_polygons

    @given(simple_polygons(max_vertices=8))
    def test_my_mesher(polygon):
        ...

What is drawn is valid by construction: points in a random order are untangled, holes lie inside
triangles of a triangulation, convex polygons are made of their edges, rectilinear ones grow by
cells.  All shrink to few vertices with small integer coordinates.  Near misses are drawn on
purpose: vertices nearly on a line or on an edge, holes that nearly touch.

With the package installed, `st.from_type(Polygon)` and `st.from_type(Mesh)` know these strategies.
"""

from bern_exact.strategies.meshes import triangulations
from bern_exact.strategies.polygons import (
    convex_polygons,
    polygons_with_holes,
    rectilinear_polygons,
    simple_polygons,
)

__all__ = [
    "convex_polygons",
    "polygons_with_holes",
    "rectilinear_polygons",
    "simple_polygons",
    "triangulations",
]
