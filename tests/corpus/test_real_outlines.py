"""The outlines that ship with the package are the examples."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

import pytest

from bern_exact.corpus.families import FAMILIES, drawn
from bern_exact.corpus.real_outlines import NAMES, outline
from bern_exact.plane.polygon import Polygon

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
OUTLINES = resources.files("bern_exact.corpus") / "outlines"

every = pytest.mark.parametrize("name", NAMES)


@every
def test_they_are_the_examples_byte_for_byte(name: str) -> None:
    shipped = (OUTLINES / f"{name}.json").read_bytes()
    assert shipped == (EXAMPLES / f"{name}.json").read_bytes()


def test_all_examples_of_at_most_160_vertices_are_there() -> None:
    small = {path.stem for path in EXAMPLES.glob("*.json") if Polygon.load(path).n <= 160}
    assert small == set(NAMES)
    assert {file.name for file in OUTLINES.iterdir()} == {f"{name}.json" for name in NAMES} | {
        "README.md"
    }


@every
def test_their_sources_and_licences_are_noted(name: str) -> None:
    (row,) = [
        line
        for line in (OUTLINES / "README.md").read_text(encoding="utf-8").splitlines()
        if f"`{name}.json`" in line
    ]
    assert row in (EXAMPLES / "README.md").read_text(encoding="utf-8")
    made = drawn(FAMILIES["outline"], "s", {"which": NAMES.index(name)})
    assert made.comment.startswith(f"{name}: ")


def test_they_are_in_the_order_of_their_sizes() -> None:
    sizes = [sum(map(len, outline(which))) for which in range(len(NAMES))]
    assert sizes == sorted(sizes)
