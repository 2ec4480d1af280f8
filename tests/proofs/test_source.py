"""No float decides a proof, either."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from tests.source import Module
from tests.test_exactness import imported_roots, inexact

PROOFS = Path(__file__).resolve().parent.parent.parent / "proofs"

INEXACT = {"math", "cmath", "decimal", "statistics", "random"}
EXEMPT = {"float_filter.py": "about floats"}

MODULES = [
    Module(path.stem, path.relative_to(PROOFS).as_posix(), text, ast.parse(text))
    for path in sorted(PROOFS.rglob("*.py"))
    for text in [path.read_text(encoding="utf-8")]
]


@pytest.mark.parametrize(
    "module", [m for m in MODULES if m.path not in EXEMPT], ids=lambda m: m.path
)
def test_no_float_is_made(module: Module) -> None:
    assert not list(inexact(module))
    assert not set(imported_roots(module.tree)) & INEXACT


@pytest.mark.parametrize("module", MODULES, ids=lambda m: m.path)
def test_files_are_short(module: Module) -> None:
    assert module.text.count("\n") <= 400
