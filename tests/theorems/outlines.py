"""The real polygons of examples/, marked by what they cost."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import pytest

EXAMPLES = sorted((Path(__file__).resolve().parents[2] / "examples").glob("*.json"))

SLOW = 20_000
"""Bytes of a file from which on a test takes more than a few seconds."""

LONG = 25_000
"""Bytes of a file from which on it takes a minute: `make test-long`."""

ANOTHER = {"glyph_dejavuserif_ampersand"}
"""Long as well: there are two smaller glyphs with holes."""


def cases(paths: Iterable[Path]) -> list[Any]:
    """Each as a parameter of a test, marked."""
    return [pytest.param(path, id=path.stem, marks=list(_marks(path))) for path in paths]


def _marks(path: Path) -> Iterable[pytest.MarkDecorator]:
    size = path.stat().st_size
    if size > LONG or path.stem in ANOTHER:
        yield pytest.mark.long
    elif size > SLOW:
        yield pytest.mark.slow
