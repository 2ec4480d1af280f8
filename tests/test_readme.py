"""What the README says is so."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")


def test_the_python_example_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (code,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    shutil.copytree(ROOT / "examples", tmp_path / "examples")
    monkeypatch.chdir(tmp_path)
    exec(compile(code, "README.md", "exec"), {})
    assert (tmp_path / "south_africa.mesh.json").exists()


def test_every_module_named_is_there() -> None:
    named = re.findall(r"`((?:\w+/)+\w+\.\w+)`", README)
    assert len(named) > 20
    for path in named:
        assert (ROOT / path).exists() or (ROOT / "bern_exact" / path).exists(), path


def test_every_picture_is_there() -> None:
    for path in re.findall(r"!\[[^]]*\]\(([^)]*)\)", README):
        assert (ROOT / path).exists()
