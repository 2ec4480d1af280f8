"""No float decides a proof, either."""

from __future__ import annotations

import ast
from pathlib import Path

from tests.source import Module, found
from tests.test_exactness import excess, imported_roots, inexact

PROOFS = Path(__file__).resolve().parent.parent.parent / "proofs"

INEXACT = {"math", "cmath", "decimal", "statistics", "random"}
EXEMPT = {"float_filter.py": "about floats"}

MODULES = [
    Module(path.stem, path.relative_to(PROOFS).as_posix(), text, ast.parse(text))
    for path in sorted(PROOFS.rglob("*.py"))
    for text in [path.read_text(encoding="utf-8")]
]


def test_no_float_is_made() -> None:
    exact = [module for module in MODULES if module.path not in EXEMPT]
    assert found(inexact, exact) == {}
    assert found(lambda module: set(imported_roots(module.tree)) & INEXACT, exact) == {}


def test_files_are_short() -> None:
    assert found(excess, MODULES) == {}
