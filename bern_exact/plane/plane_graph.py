"""Planar straight-line graphs: what the paper's Section 4 is about."""

from __future__ import annotations

from dataclasses import dataclass

from bern_exact.exact.points import HPoint


@dataclass(frozen=True)
class PlaneGraph:
    """A planar straight-line graph: "a planar embedding, each edge a line segment" (Section 4).

    Parameters
    ----------
    name : str
        Which one.
    points : tuple of HPoint
        Its vertices.
    edges : tuple of (int, int)
        Its edges, which meet at vertices only.
    """

    name: str
    points: tuple[HPoint, ...]
    edges: tuple[tuple[int, int], ...]
