"""The picture of a whole triangulation with its figures, for `--svg`."""

from __future__ import annotations

from collections.abc import Sequence

from bern_exact.certificate import extremes
from bern_exact.exact.predicates import orientation
from bern_exact.figures import degrees, root
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.view.svg import Mark, draw


def draw_triangulation(
    mesh: Mesh, polygon: Polygon | None, classes: Sequence[str] | None = None
) -> str:
    """An SVG of a mesh with title, counts, and its worst triangles marked.

    Parameters
    ----------
    mesh : Mesh
        Anybody's, with indices in range; triangles without area are drawn but never marked.
    polygon : Polygon or None
        Its boundary; gives the title.
    classes : sequence of str, optional
        For each triangle a class of `bern_exact.view.svg.CLASSES`.
    """
    counts = [f"{len(mesh.triangles):,} triangles", f"{len(mesh.vertices):,} vertices"]
    if polygon is not None:
        holes = f"{polygon.holes:,} hole{'' if polygon.holes == 1 else 's'}"
        counts = [f"polygon of {polygon.n:,} vertices, {holes}", *counts]
    return draw(
        polygon,
        mesh,
        classes,
        title=(polygon.name if polygon is not None else "") or "Triangulation",
        subtitle="; ".join(counts),
        marks=_marks(mesh),
    )


def _marks(mesh: Mesh) -> list[Mark]:
    """The triangle of least height and that of the largest angle, among those with area."""
    at = mesh.vertices
    solid = [
        i for i, (a, b, c) in enumerate(mesh.triangles) if orientation(at[a], at[b], at[c]) != 0
    ]
    if not solid:
        return []
    worst = extremes(Mesh(at, tuple(mesh.triangles[i] for i in solid)))
    return [
        Mark(solid[worst.thinnest], "least height", root(worst.min_height_squared)),
        Mark(solid[worst.widest], "largest angle", f"{degrees(worst.max_angle)} degrees"),
    ]
