"""Deriving a corpus again finds whatever was changed in it."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from bern_exact.corpus.recheck import Difference, recheck
from bern_exact.exact.errors import InputError
from tests.corpus.small import CHOICES

CASE = CHOICES[0].case(0)


@pytest.fixture
def copy(corpus: Path, tmp_path: Path) -> Path:
    shutil.copytree(corpus, tmp_path / "copy")
    return tmp_path / "copy"


def test_a_fresh_corpus_has_no_differences(corpus: Path) -> None:
    assert recheck(corpus, workers=2) == []


def edited(path: str, old: str, new: str) -> Callable[[Path], None]:
    def edit(directory: Path) -> None:
        text = (directory / path).read_text()
        assert old in text
        (directory / path).write_text(text.replace(old, new, 1))

    return edit


@pytest.mark.parametrize(
    "damage, difference",
    [
        (edited(f"{CASE}/facts.json", '"n": 4', '"n": 5'), (f"{CASE}/facts.json", "changed")),
        (
            lambda directory: (directory / CASE / "polygon.wkt").unlink(),
            (f"{CASE}/polygon.wkt", "missing"),
        ),
        (
            lambda directory: (directory / CASE / "notes.txt").write_text("x"),
            (f"{CASE}/notes.txt", "not of the corpus"),
        ),
        (
            lambda directory: (directory / "notes.txt").write_text("x"),
            ("notes.txt", "not of the corpus"),
        ),
        (edited("README.md", "exact", "rounded"), ("README.md", "changed")),
        (edited("manifest.json", '"comment": "', '"comment": "No, '), ("manifest.json", "changed")),
    ],
    ids=["changed", "missing", "added", "stranger", "readme", "manifest"],
)
def test_every_change_is_found(
    copy: Path, damage: Callable[[Path], None], difference: tuple[str, str]
) -> None:
    damage(copy)
    assert recheck(copy) == [Difference(*difference)]


@pytest.mark.parametrize(
    "text",
    ["", "[]", "{}", '{"format": "bern-exact/corpus", "version": 2}']
    + ['{"format": "bern-exact/corpus", "version": 1}'],
)
def test_what_is_no_manifest_is_refused(copy: Path, text: str) -> None:
    (copy / "manifest.json").write_text(text)
    with pytest.raises(InputError):
        recheck(copy)


def test_another_generator_is_refused(copy: Path) -> None:
    manifest = json.loads((copy / "manifest.json").read_text())
    manifest["generator"] += 1
    (copy / "manifest.json").write_text(json.dumps(manifest))
    with pytest.raises(InputError, match="generator"):
        recheck(copy)
