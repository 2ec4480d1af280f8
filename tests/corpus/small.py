"""A small corpus for tests: quick to make, with a polygon that is none and one with a hole."""

from __future__ import annotations

from pathlib import Path

from bern_exact.corpus.generate import generate
from bern_exact.corpus.plan import Choice

SEED = 5
CHOICES = (Choice("star", {"n": 4}), Choice("bad-edges-cross"), Choice("paper-holes", {"side": 1}))
COUNT = 4


def made(directory: Path, *, count: int = COUNT, workers: int = 1) -> Path:
    """The corpus in a directory."""
    generate(directory, seed=SEED, count=count, families=CHOICES, workers=workers)
    return directory


def contents(directory: Path) -> dict[str, bytes]:
    """Every file of a directory by its path."""
    return {
        path.relative_to(directory).as_posix(): path.read_bytes()
        for path in sorted(directory.rglob("*"))
        if path.is_file()
    }
