"""Cases on disk: each written whole or not at all, known again when a run goes on."""

from __future__ import annotations

import errno
import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from bern_exact.corpus.case import Files, digest
from bern_exact.corpus.plan import GENERATOR
from bern_exact.exact.errors import InputError
from bern_exact.formats import safe_json

PARTIAL = ".partial-"
"""Folders that are being written begin with this."""


def write_case(directory: Path, case: str, files: Files) -> None:
    """Write a case's folder, whole or not at all.

    Raises
    ------
    OSError
        It cannot be written; what there is of it is removed.
    """
    partial = directory / f"{PARTIAL}{case}"
    remove(partial)
    try:
        for path, text in files.items():
            target = partial / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8", newline="\n")
        remove(directory / case)
        os.replace(partial, directory / case)
    except OSError as error:
        shutil.rmtree(partial, ignore_errors=True)
        place = str(directory / case)
        raise OSError(error.errno or errno.EIO, error.strerror or str(error), place) from error


def remove(folder: Path) -> None:
    """Remove a folder, if it is there."""
    if folder.exists():
        shutil.rmtree(folder)


def begin(directory: Path) -> None:
    """Make the directory, and remove what an interrupted run left half written.

    Raises
    ------
    OSError
        It cannot be made or written to.
    """
    directory.mkdir(parents=True, exist_ok=True)
    for folder in sorted(directory.glob(f"{PARTIAL}*")):
        remove(folder)
    probe = directory / f"{PARTIAL}probe"
    probe.mkdir()
    probe.rmdir()


def document_of(path: Path, kind: str) -> dict[str, Any]:
    """A document of a corpus, its format and version checked.

    Raises
    ------
    InputError
        It is not JSON, or of another kind; the message names the file.
    OSError
        It cannot be read.
    """
    try:
        document = safe_json.load(path)
    except InputError as error:
        raise InputError(error.kind, f"{path}: {error.message}", error.where) from error
    known = {"format": f"bern-exact/{kind}", "version": 1}
    if not isinstance(document, dict) or any(document.get(k) != v for k, v in known.items()):
        raise InputError("schema", f"{path} is no {known['format']}, version 1")
    return document


def is_complete(directory: Path, seed: int, case: str) -> bool:
    """Is the case there, made by this generator from this seed, every file as it was written?"""
    folder = directory / case
    try:
        document = document_of(folder / "case.json", "case")
        identity = (document["generator"], document["seed"], document["case"])
        hashes = dict(document["files"])
        return identity == (GENERATOR, seed, case) and all(
            digest((folder / path).read_text(encoding="utf-8")) == known
            for path, known in hashes.items()
        )
    except (OSError, InputError, KeyError, ValueError):
        return False


def seed_of(folder: Path) -> int | None:
    """The seed of the corpus that a case is of; None if that cannot be told."""
    try:
        seed = document_of(folder / "case.json", "case").get("seed")
    except (OSError, InputError, ValueError):
        return None
    return seed if isinstance(seed, int) else None


def files_below(folder: Path) -> Iterator[str]:
    """Every file of a folder, as paths with strokes, sorted."""
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            yield path.relative_to(folder).as_posix()
