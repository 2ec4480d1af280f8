"""Deriving a corpus again, and comparing: has anything in it changed?"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from bern_exact.corpus.case import Files
from bern_exact.corpus.generate import AHEAD, Listener, made, processes
from bern_exact.corpus.manifest import MANIFEST, manifest_text, plan_of
from bern_exact.corpus.readme import README
from bern_exact.corpus.storage import files_below


@dataclass(frozen=True)
class Difference:
    """A file that is not what it must be.

    Parameters
    ----------
    path : str
        Below the corpus's directory.
    what : {"missing", "not of the corpus", "changed"}
        How it differs.
    """

    path: str
    what: str


def recheck(
    directory: Path, *, workers: int = 1, listener: Listener | None = None
) -> list[Difference]:
    """Every difference between a corpus and what its manifest says it must be.

    Parameters
    ----------
    directory : Path
        With a manifest.
    workers : int
        Processes on this machine.
    listener : callable, optional
        Told of every case that is compared, as in `generate`.

    Raises
    ------
    InputError
        The manifest is none, or of another generator.

    Notes
    -----
    Takes what making the corpus took.
    """
    plan = plan_of(directory)
    cases = list(plan.cases())
    differences = dict[str, list[Difference]]()
    with processes(None, workers) as pool:
        for case, files in made(pool, plan.seed, cases, AHEAD * workers):
            differences[case] = list(_differences(directory, case, files))
            if listener is not None:
                listener(case, len(differences), len(cases))
    found = [each for case in cases for each in differences[case]]
    known = {*cases, MANIFEST, "README.md"}
    strangers = sorted(path.name for path in directory.iterdir() if path.name not in known)
    found += [Difference(name, "not of the corpus") for name in strangers]
    found += _compared(directory, "README.md", README)
    if not any(difference.what != "not of the corpus" for difference in found):
        found += _compared(directory, MANIFEST, manifest_text(directory, plan))
    return found


def _differences(directory: Path, case: str, files: Files) -> Iterator[Difference]:
    """Those of one case."""
    for path, text in files.items():
        yield from _compared(directory, f"{case}/{path}", text)
    for path in files_below(directory / case):
        if path not in files:
            yield Difference(f"{case}/{path}", "not of the corpus")


def _compared(directory: Path, path: str, text: str) -> Iterator[Difference]:
    """A file against its text."""
    try:
        if (directory / path).read_bytes() != text.encode("utf-8"):
            yield Difference(path, "changed")
    except FileNotFoundError:
        yield Difference(path, "missing")
