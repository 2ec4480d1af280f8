"""Records and verdicts as a comparison would make them."""

from __future__ import annotations

from typing import Any

from gmpy2 import mpq

from benchmarks.peers.judging import Judged
from benchmarks.peers.runs import Record
from bern_exact.exact.angles import ANGLE_135, Angle


def verdict(triangles: int = 2, **changes: Any) -> Judged:
    """A verdict on a valid mesh."""
    figures: dict[str, Any] = {
        "triangles": triangles,
        "vertices": 4,
        "defects": {},
        "max_angle": ANGLE_135,
        "min_height_squared": mpq(1, 4),
        "feature_squared": mpq(1),
        "off": 0,
        "off_squared": mpq(0),
    }
    return Judged(**{**figures, **changes})


def record(case: str, mesher: str, triangles: int | None = 2, **changes: Any) -> Record:
    """A record of a mesh of so many triangles, or of none."""
    family = "star" if case.startswith("star") else "outline"
    figures: dict[str, Any] = {
        "case": case,
        "family": family,
        "size": 100,
        "n": 100,
        "holes": 0,
        "mesher": mesher,
        "outcome": "time-out" if triangles is None else "ended",
        "seconds": None if triangles is None else 0.5,
        "triangles": triangles,
        "judged": None if triangles is None else verdict(triangles),
    }
    return Record(**{**figures, **changes})


WIDE = Angle(-1, mpq(4, 5))
"""An angle above 150 degrees."""
