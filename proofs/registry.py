"""The modules with statements, in the paper's order."""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module
from importlib.util import find_spec

from proofs.statement import Statement

MODULES = (
    "proofs.section_2",
    "proofs.lemma_1",
    "proofs.outside_blocks",
    "proofs.face_heights",
    "proofs.lemma_2",
    "proofs.lemma_3",
    "proofs.theorem_1",
    "proofs.lemma_4",
    "proofs.lemma_5",
    "proofs.merged_faces",
    "proofs.lemma_6",
    "proofs.lemma_7",
    "proofs.lemma_8",
    "proofs.theorems_2_3",
    "proofs.section_5",
    "proofs.bouncing",
    "proofs.lemma_12",
    "proofs.lemma_12_rounding",
    "proofs.theorem_4",
    "proofs.printed",
    "proofs.judge",
    "proofs.filters",
)
"""Each has `statements(full)`, which does the work of one statement after the other."""


def modules() -> tuple[str, ...]:
    """Those that are there."""
    return tuple(name for name in MODULES if find_spec(name) is not None)


def statements(full: bool = False) -> Iterator[Statement]:
    """Every statement, its work done.

    Raises
    ------
    NotShown
        At the first whose work fails.
    """
    for name in modules():
        yield from import_module(name).statements(full)
