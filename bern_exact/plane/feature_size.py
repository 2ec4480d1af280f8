"""Definition 1: the feature size (placeholder of the interface, being written)."""

from __future__ import annotations

from dataclasses import dataclass

from gmpy2 import mpq


@dataclass(frozen=True)
class FeatureSize:
    """The feature size s of a polygon, squared, and the pair that attains it.

    Parameters
    ----------
    squared : mpq
        s^2.
    vertex : int or None
        The vertex, or None if s is the length of `edge`.
    edge : int
        The edge.
    """

    squared: mpq
    vertex: int | None
    edge: int
