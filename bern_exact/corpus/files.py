"""A file of a case."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class File:
    """A file of a case.

    Parameters
    ----------
    path : str
        Within the case's folder.
    text : str
        What it holds.
    rounded : int
        How many of its coordinates are not what they were: no double holds them.
    """

    path: str
    text: str
    rounded: int = 0
