"""Real outlines, glyphs and icons through Theorem 1 with every check and the lone judge."""

from __future__ import annotations

from pathlib import Path

import pytest

from bern_exact import Polygon
from tests.theorems.judged import proved
from tests.theorems.outlines import EXAMPLES, cases


@pytest.mark.parametrize("path", cases(EXAMPLES))
def test_theorem_1(path: Path) -> None:
    polygon = Polygon.load(path)
    made = proved(polygon)
    assert made.assembled.mesh.vertices[: polygon.n] == polygon.points
