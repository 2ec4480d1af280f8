"""What Hypothesis runs when it is imported where this package is installed."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hypothesis.strategies import SearchStrategy

    from bern_exact.plane.mesh import Mesh
    from bern_exact.plane.polygon import Polygon


def _hypothesis_setup_hook() -> None:
    """Let `st.from_type(Polygon)` and `st.from_type(Mesh)` draw valid ones.

    The strategies are imported when they are first asked for.
    """
    from hypothesis import strategies as st

    from bern_exact.plane.mesh import Mesh
    from bern_exact.plane.polygon import Polygon

    st.register_type_strategy(Polygon, lambda _: _polygons())
    st.register_type_strategy(Mesh, lambda _: _meshes())


def _polygons() -> SearchStrategy[Polygon]:
    from bern_exact import strategies

    return (
        strategies.simple_polygons()
        | strategies.polygons_with_holes()
        | strategies.convex_polygons()
        | strategies.rectilinear_polygons()
    )


def _meshes() -> SearchStrategy[Mesh]:
    from bern_exact.strategies import triangulations

    return triangulations().map(lambda pair: pair[1])
