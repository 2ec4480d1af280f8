"""Triangle meshes with exact vertices."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from gmpy2 import mpq

from bern_exact.exact.points import HPoint, coordinates, literal

Triangle = tuple[int, int, int]
"""Three vertex indices, counter-clockwise."""


@dataclass(frozen=True)
class Mesh:
    """A triangulation: exact vertices and counter-clockwise triangles of vertex indices.

    Parameters
    ----------
    vertices : tuple of HPoint
        In a mesh made here the input's vertices come first, in input order.
    triangles : tuple of (int, int, int)
        0-based, counter-clockwise.
    """

    vertices: tuple[HPoint, ...]
    triangles: tuple[Triangle, ...]

    @property
    def coordinates(self) -> list[tuple[mpq, mpq]]:
        """The vertices as rational (x, y), in order."""
        return [coordinates(p) for p in self.vertices]

    def _repr_pretty_(self, printer: Any, cycle: bool) -> None:
        """How IPython and Hypothesis show it: vertices and triangles as `verify` takes them."""
        vertices = [literal(p) for p in self.vertices]
        printer.text(f"mesh_of({vertices}, {list(self.triangles)})")
