"""A mesh of doubles, read as exactly what it is."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from gmpy2 import mpq

from bern_exact.exact.points import hpoint
from bern_exact.plane.mesh import Mesh


def mesh_of_floats(vertices: Iterable[Sequence[float]], triangles: Iterable[Sequence[int]]) -> Mesh:
    """The mesh whose coordinates are these doubles; nothing is rounded, nothing is judged."""
    points = tuple(
        hpoint(mpq(*x.as_integer_ratio()), mpq(*y.as_integer_ratio())) for x, y in vertices
    )
    return Mesh(points, tuple((int(a), int(b), int(c)) for a, b, c in triangles))
