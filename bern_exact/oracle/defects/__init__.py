"""Valid meshes damaged on purpose, each in one named way, to try out judges.

Damages are exact and a function of mesh, polygon, name and seed alone.  What a judge must say of
the result is known from how it was made, not from any judge::

    damaged = damage(mesh, polygon, "boundary-vertex-outwards", seed=7)
    damaged.result, damaged.kind, damaged.where   # "invalid", "boundary-vertex-off-edge", ...

A third of the damages leave the mesh valid, just inside a bound or differently made: a judge that
refuses those is wrong too.
"""

from __future__ import annotations

from collections.abc import Mapping
from random import Random

from bern_exact.oracle.defects import bounds, edges, harmless, lists, outline
from bern_exact.oracle.defects.records import Damage, Damaged
from bern_exact.oracle.defects.sound import Sound
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon

__all__ = ["DAMAGES", "Damage", "Damaged", "damage"]

DAMAGES: Mapping[str, Damage] = {
    each.name: each
    for each in (
        *lists.DAMAGES,
        *edges.DAMAGES,
        *outline.DAMAGES,
        *bounds.DAMAGES,
        *harmless.DAMAGES,
    )
}
"""Every damage, by name."""


def damage(mesh: Mesh, polygon: Polygon | None, name: str, seed: int) -> Damaged | None:
    """Damage a valid mesh in one way.

    Parameters
    ----------
    mesh : Mesh
        A triangulation of the polygon; without one, of what its boundary encloses.
    polygon : Polygon or None
        The polygon.
    name : str
        A key of `DAMAGES`.
    seed : int
        Decides between places that will do.

    Returns
    -------
    Damaged or None
        None if there is no place for this damage, such as a hole to be filled.

    Raises
    ------
    KeyError
        If there is no damage of this name.

    Notes
    -----
    Linear in the mesh, but for few places that are tried against the whole boundary each.
    On a mesh that is not valid, or not of this polygon, the result is undefined.

    Examples
    --------
    >>> from bern_exact.exact.points import hpoint
    >>> mesh = Mesh((hpoint(0, 0), hpoint(1, 0), hpoint(0, 1)), ((0, 1, 2),))
    >>> damaged = damage(mesh, None, "triangle-clockwise", 0)
    >>> damaged.result, damaged.kind, damaged.where
    ('invalid', 'clockwise-triangle', {'triangle': 0})
    """
    way = DAMAGES[name]
    if polygon is None and way.needs_polygon:
        return None
    change = way.make(Sound(mesh, polygon, Random(f"{name} {seed}")))
    if change is None:
        return None
    return Damaged(
        way,
        change.mesh,
        change.polygon,
        change.where,
        change.max_angle,
        change.min_height_squared,
        change.max_triangles,
    )
