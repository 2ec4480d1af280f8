"""Imports go downwards only, and the judges and checkers stand apart from the builders."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest

from tests.source import Module, imports, modules, relative_imports

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

MODULES = modules()
by_name = pytest.mark.parametrize("module", MODULES, ids=lambda m: m.path)


def layer_of(dotted: str) -> int:
    """The height of a module of ours in the house."""
    parts = dotted.split(".")
    return LAYERS.index(parts[1] if len(parts) > 1 else "")


def is_ours(dotted: str) -> bool:
    return dotted == "bern_exact" or dotted.startswith("bern_exact.")


def resolved(module: str, name: str | None) -> str:
    """`from bern_exact import cli` names the module bern_exact.cli."""
    dotted = f"{module}.{name}"
    return dotted if name is not None and dotted in {m.name for m in MODULES} else module


def test_the_list_in_developers_md_is_this_one() -> None:
    text = (Path(__file__).resolve().parent.parent / "DEVELOPERS.md").read_text(encoding="utf-8")
    listed = re.findall(r"^bern_exact/(\w+)(?:/|\.py) ", text, re.MULTILINE)
    names = tuple("" if name == "__init__" else name for name in listed)
    assert names == (*LAYERS, "schemas")


@by_name
def test_imports_go_downwards_only(module: Module) -> None:
    for target, name in imports(module.tree):
        target = resolved(target, name)
        if is_ours(target) and (module.name, target) not in EXCEPTIONS:
            assert layer_of(target) <= layer_of(module.name), f"imports {target}"


def test_no_exception_is_out_of_date() -> None:
    present = {(m.name, resolved(*pair)) for m in MODULES for pair in imports(m.tree)}
    assert set(EXCEPTIONS) <= present


@by_name
def test_imports_are_absolute(module: Module) -> None:
    assert not list(relative_imports(module.tree))


def test_the_lone_judge_imports_the_standard_library_only() -> None:
    (judge,) = [m for m in MODULES if m.path == "oracle/judge.py"]
    names = {target.split(".")[0] for target, _ in imports(judge.tree)}
    assert names <= set(sys.stdlib_module_names)


@pytest.mark.parametrize(
    "module",
    [m for m in MODULES if m.path.startswith(("checkers/", "oracle/"))],
    ids=lambda m: m.path,
)
def test_checkers_and_judges_import_records_and_no_builder(module: Module) -> None:
    for target, name in imports(module.tree):
        if target.startswith(("bern_exact.boundary", "bern_exact.interior", "bern_exact.convex")):
            assert target.rpartition(".")[2] in RECORDS, f"imports {target}"
        if target.startswith("bern_exact.convex"):
            assert target.rpartition(".")[2] in CONVEX_RECORDS, f"imports {target}"
        if target == "bern_exact.plane.feature_size" and module.path != "oracle/api.py":
            assert name == "FeatureSize", "a checker computes feature sizes by itself"
