"""Imports go downwards only, and the judges and checkers stand apart from the builders."""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.source import Module, found, imports, modules, relative_imports

# From the ground up, as in DEVELOPERS.md: a layer may import itself and what stands before it.
LAYERS = (
    "exact",
    "plane",
    "boundary",
    "interior",
    "convex",
    "thinning",
    "checkers",
    "oracle",
    "theorems",
    "formats",
    "outputs",
    "certificate",
    "counts",
    "facts",
    "figures",
    "view",
    "api",
    "",  # bern_exact/__init__.py: the public names
    "comparison",
    "corpus",
    "trace",
    "progress",
    "report",
    "testing",
    "strategies",
    "pytest_plugin",
    "hypothesis_plugin",
    "commands",
    "cli",
    "__main__",
)

# (module, what it imports) -> why.
EXCEPTIONS = {("bern_exact.plane.polygon", "bern_exact.formats"): "Polygon.load, inside the method"}

# The modules of `convex` that hold records and build nothing.
CONVEX_RECORDS = {"records", "cells", "block_records"}

# Modules of records, which checkers may read.
RECORDS = ("records", "block_records", "cells")

# The parts of the house that build.
BUILDING = ("bern_exact.boundary", "bern_exact.interior", "bern_exact.convex")

MODULES = modules()
NAMES = {module.name for module in MODULES}


def layer_of(dotted: str) -> int:
    """The height of a module of ours in the house."""
    parts = dotted.split(".")
    return LAYERS.index(parts[1] if len(parts) > 1 else "")


def is_ours(dotted: str) -> bool:
    return dotted == "bern_exact" or dotted.startswith("bern_exact.")


def resolved(module: str, name: str | None) -> str:
    """`from bern_exact import cli` names the module bern_exact.cli."""
    dotted = f"{module}.{name}"
    return dotted if name is not None and dotted in NAMES else module


def test_the_list_in_developers_md_is_this_one() -> None:
    text = (Path(__file__).resolve().parent.parent / "DEVELOPERS.md").read_text(encoding="utf-8")
    listed = re.findall(r"^bern_exact/(\w+)(?:/|\.py) ", text, re.MULTILINE)
    names = tuple("" if name == "__init__" else name for name in listed)
    assert names == (*LAYERS, "schemas")


def upward_imports(module: Module) -> Iterator[str]:
    """What a module imports from above it, exceptions apart."""
    for pair in imports(module.tree):
        target = resolved(*pair)
        is_upward = is_ours(target) and layer_of(target) > layer_of(module.name)
        if is_upward and (module.name, target) not in EXCEPTIONS:
            yield target


def builders(module: Module) -> Iterator[str]:
    """What a checker or judge imports that is more than records."""
    for target, name in imports(module.tree):
        last = target.rpartition(".")[2]
        allowed = CONVEX_RECORDS if target.startswith("bern_exact.convex") else RECORDS
        if target.startswith(BUILDING) and last not in allowed:
            yield target
        # A checker computes feature sizes by itself.
        is_computed = target == "bern_exact.plane.feature_size" and name != "FeatureSize"
        if is_computed and module.path != "oracle/api.py":
            yield f"{target}.{name}"


def test_imports_go_downwards_only() -> None:
    assert found(upward_imports) == {}


def test_no_exception_is_out_of_date() -> None:
    present = {(m.name, resolved(*pair)) for m in MODULES for pair in imports(m.tree)}
    assert set(EXCEPTIONS) <= present


def test_imports_are_absolute() -> None:
    assert found(lambda module: map(ast.unparse, relative_imports(module.tree))) == {}


def test_the_lone_judge_imports_the_standard_library_only() -> None:
    (judge,) = [m for m in MODULES if m.path == "oracle/judge.py"]
    names = {target.split(".")[0] for target, _ in imports(judge.tree)}
    assert names <= set(sys.stdlib_module_names)


def test_checkers_and_judges_import_records_and_no_builder() -> None:
    assert (
        found(builders, [m for m in MODULES if m.path.startswith(("checkers/", "oracle/"))]) == {}
    )


@pytest.mark.parametrize(
    ("look", "path", "text"),
    [
        (upward_imports, "plane/m.py", "from bern_exact.api import triangulate"),
        (upward_imports, "plane/m.py", "def f():\n    from bern_exact import cli"),
        (builders, "checkers/m.py", "from bern_exact.boundary.lop import lop"),
        (builders, "checkers/m.py", "from bern_exact.convex.bounce import bounce"),
        (builders, "oracle/m.py", "from bern_exact.plane.feature_size import feature_size"),
    ],
)
def test_each_look_finds(look: Callable[[Module], Iterator[str]], path: str, text: str) -> None:
    name = f"bern_exact.{path.partition('/')[0]}.m"
    assert list(found(look, [Module(name, path, text, ast.parse(text))])) == [path]
