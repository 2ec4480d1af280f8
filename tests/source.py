"""The package's own source, parsed: what the tests of the house rules look at."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

PACKAGE = Path(__file__).resolve().parent.parent / "bern_exact"


@dataclass(frozen=True)
class Module:
    """One source file: its dotted name, its path below the package and its syntax tree."""

    name: str
    path: str
    text: str
    tree: ast.Module

    @property
    def is_package(self) -> bool:
        return self.path.endswith("__init__.py")


@cache
def modules() -> list[Module]:
    """Every module of the package, by path."""
    return [_parsed(path) for path in sorted(PACKAGE.rglob("*.py"))]


def _parsed(path: Path) -> Module:
    relative = path.relative_to(PACKAGE)
    parts = ["bern_exact", *relative.with_suffix("").parts]
    if parts[-1] == "__init__":
        parts.pop()
    text = path.read_text(encoding="utf-8")
    return Module(".".join(parts), relative.as_posix(), text, ast.parse(text))


def found(
    look: Callable[[Module], Iterable[str]], among: Iterable[Module] | None = None
) -> dict[str, list[str]]:
    """What a look at each module finds, by path, where it finds anything."""
    seen = ((m.path, list(look(m))) for m in (modules() if among is None else among))
    return {path: things for path, things in seen if things}


def imports(tree: ast.AST) -> Iterator[tuple[str, str | None]]:
    """Every import, wherever it stands, as (module, name or None for the module itself)."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from ((alias.name, None) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from ((node.module or "", alias.name) for alias in node.names)


def relative_imports(tree: ast.AST) -> Iterator[ast.ImportFrom]:
    """Every `from . import x`."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.level:
            yield node
