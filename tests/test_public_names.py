"""The public names: there, importable one by one, and free until they are asked for."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import bern_exact


@pytest.mark.parametrize("name", bern_exact.__all__)
def test_every_public_name_is_there_and_documented(name: str) -> None:
    value = getattr(bern_exact, name)
    assert name in dir(bern_exact)
    assert isinstance(value, str) or value.__doc__


def test_type_checkers_see_the_same_names() -> None:
    tree = ast.parse(Path(bern_exact.__file__).read_text(encoding="utf-8"))
    block = next(node for node in tree.body if isinstance(node, ast.If))
    homes = {
        alias.name: statement.module.removeprefix("bern_exact.")
        for statement in block.body
        if isinstance(statement, ast.ImportFrom) and statement.module
        for alias in statement.names
    }
    assert homes == bern_exact._HOMES
    assert sorted([*homes, "__version__"]) == sorted(bern_exact.__all__)


def test_other_names_are_not_there() -> None:
    with pytest.raises(AttributeError, match="no attribute 'tetrahedralize'"):
        bern_exact.tetrahedralize  # noqa: B018


def test_importing_the_package_imports_nothing_else() -> None:
    code = "import sys, bern_exact; print(sorted(sys.modules))"
    loaded = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    ).stdout
    assert "'bern_exact'" in loaded
    assert "'gmpy2'" not in loaded and "'numpy'" not in loaded
