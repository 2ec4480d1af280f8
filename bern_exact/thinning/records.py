"""What thinning hands on."""

from __future__ import annotations

from dataclasses import dataclass

from bern_exact.plane.mesh import Mesh


@dataclass(frozen=True)
class Thinned:
    """A mesh before and after thinning.

    Parameters
    ----------
    raw : Mesh
        As it was: the theorem's.
    mesh : Mesh
        Without the vertices that could be spared; the polygon's vertices first.  Its triangles
        have their least vertex first and are sorted.
    removed : int
        How many vertices went.
    """

    raw: Mesh
    mesh: Mesh
    removed: int
