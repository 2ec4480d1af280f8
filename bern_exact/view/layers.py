"""What a stage's picture is made of."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from bern_exact.exact.points import HPoint

OPEN = ("line", "removed", "bounced", "closed")
"""Styles of lines that are not closed to rings."""


class Layer(NamedTuple):
    """Rings or open lines drawn alike.

    Parameters
    ----------
    style : str
        A class of triangles, "outline" or "line".
    rings : sequence of sequences of HPoint
        What is drawn.
    """

    style: str
    rings: Sequence[Sequence[HPoint]]
