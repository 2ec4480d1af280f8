"""Real outlines, glyphs and icons through Theorem 1 with every check and the lone judge."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from bern_exact import Polygon
from tests.theorems.judged import proved

EXAMPLES = sorted((Path(__file__).resolve().parents[2] / "examples").glob("*.json"))

LARGE = 20_000
"""Bytes of a file that takes more than a few seconds."""


def cases() -> list[Any]:
    """Every example, the large ones marked."""
    return [
        pytest.param(
            path, id=path.stem, marks=[pytest.mark.slow] if path.stat().st_size > LARGE else []
        )
        for path in EXAMPLES
    ]


@pytest.mark.parametrize("path", cases())
def test_theorem_1(path: Path) -> None:
    polygon = Polygon.load(path)
    made = proved(polygon)
    assert made.assembled.mesh.vertices[: polygon.n] == polygon.points
