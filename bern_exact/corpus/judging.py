"""Other people's meshes and verdicts against a corpus."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from gmpy2 import mpq

from bern_exact.corpus.manifest import MANIFEST
from bern_exact.corpus.storage import document_of
from bern_exact.exact.angle_bound import AngleBound
from bern_exact.exact.errors import InputError
from bern_exact.formats import MESH_READERS, read_array_mesh_file, safe_json
from bern_exact.formats.polygon_json import load_polygon
from bern_exact.oracle.api import verdict_on

VERDICTS = "verdicts.json"

OUTCOMES = ("passed", "wrongly accepted", "wrongly refused", "invalid", "unreadable", "missing")
"""What can come of a mesh or a verdict."""


@dataclass(frozen=True)
class Outcome:
    """What came of one mesh or verdict.

    Parameters
    ----------
    name : str
        `ID` for a mesh, `ID/NAME` for a verdict.
    result : str
        One of `OUTCOMES`.
    kinds : tuple of str
        Kinds of the defects: of a mesh that is invalid, or the one that a verifier overlooked.
    message : str
        The first defect, or what is wrong with the file.
    """

    name: str
    result: str
    kinds: tuple[str, ...] = ()
    message: str = ""

    def to_json(self) -> dict[str, Any]:
        """The outcome as an object of `corpus judge --json`."""
        return {
            "name": self.name,
            "result": self.result,
            "kinds": list(self.kinds),
            "message": self.message,
        }


@dataclass(frozen=True)
class Expected:
    """What a correct verifier says of something in a corpus.

    Parameters
    ----------
    name : str
        `ID/NAME`.
    result : {"valid", "invalid"}
        What it says.
    kind : str
        The defect's kind, or "".
    asked : bool
        Is no answer a missing one?  Of damaged meshes it is.
    """

    name: str
    result: str
    kind: str = ""
    asked: bool = False


@dataclass(frozen=True)
class Criterion:
    """What somebody's meshes are asked for, besides being triangulations."""

    max_angle: AngleBound | None = None
    tolerance: mpq | None = None
    binary64: bool = False


NOTHING = Criterion()
"""Nothing besides."""


def judge_results(corpus: Path, results: Path, criterion: Criterion = NOTHING) -> list[Outcome]:
    """What came of every mesh and every verdict in a directory.

    Parameters
    ----------
    corpus : Path
        A corpus, complete.
    results : Path
        With `ID.mesh.json` (or `.ele`, `.off`, ...) for cases of the corpus, or `verdicts.json`.
    criterion : Criterion
        For the meshes.

    Returns
    -------
    list of Outcome
        In the order of the manifest: of meshes, if there is any; of verdicts, if there is that
        file.  A case without a mesh, or a damaged mesh without a verdict, is "missing".

    Raises
    ------
    InputError
        The corpus or `verdicts.json` is not what it must be, or there is nothing to be judged.
    OSError
        A file cannot be read.
    """
    manifest = document_of(corpus / MANIFEST, "corpus")
    cases = [(case["id"], case["result"] == "valid") for case in manifest["cases"]]
    found: list[Outcome] = []
    files = {case: _mesh_file(results, case) for case, _ in cases}
    if any(files.values()):
        for case, valid in cases:
            if valid:
                found.append(_mesh_outcome(corpus, case, files[case], criterion))
    if (results / VERDICTS).exists():
        verdicts = _verdicts(results / VERDICTS)
        expected = {known.name: known for known in _expected(corpus, cases)}
        unknown = sorted(set(verdicts) - set(expected))
        if unknown:
            message = f"{results / VERDICTS}: the corpus has no {unknown[0]!r}"
            raise InputError("schema", message, {"name": unknown[0]})
        for name, known in expected.items():
            if name in verdicts or known.asked:
                found.append(_verdict_outcome(name, verdicts.get(name), known))
    if not found:
        message = f"'{results}' holds no {VERDICTS} and no mesh of a case, such as"
        raise InputError("schema", f"{message} {cases[0][0] if cases else 'ID'}.mesh.json")
    return found


def _mesh_file(results: Path, case: str) -> Path | None:
    """The mesh of a case, in whatever format."""
    for suffix in (".mesh.json", ".json", *sorted(MESH_READERS)):
        path = results / f"{case}{suffix}"
        if path.is_file():
            return path
    return None


def _mesh_outcome(corpus: Path, case: str, path: Path | None, criterion: Criterion) -> Outcome:
    """What came of a mesher's mesh."""
    if path is None:
        return Outcome(case, "missing")
    polygon = load_polygon(corpus / case / "polygon.json")
    try:
        mesh, _ = read_array_mesh_file(
            path, binary64=criterion.binary64, polygon_path=corpus / case / "polygon.json"
        )
    except InputError as error:
        return Outcome(case, "unreadable", (error.kind,), error.message)
    verdict = verdict_on(
        mesh, polygon, max_angle=criterion.max_angle, tolerance=criterion.tolerance
    )
    if verdict:
        return Outcome(case, "passed")
    kinds = tuple(dict.fromkeys(defect.kind for defect in verdict.defects))
    return Outcome(case, "invalid", kinds, verdict.defects[0].sentence)


def _verdicts(path: Path) -> Mapping[str, str]:
    """Somebody's verdicts: {"ID/NAME": "valid" or "invalid"}."""
    document = safe_json.load(path)
    if not isinstance(document, dict):
        raise InputError("schema", f"{path}: an object is expected")
    for name, verdict in document.items():
        if verdict not in ("valid", "invalid"):
            message = f'{path}: of {name!r} "valid" or "invalid" is expected'
            raise InputError("schema", message, {"name": name})
    return document


def _expected(corpus: Path, cases: list[tuple[str, bool]]) -> Iterator[Expected]:
    """What a correct verifier says of everything in a corpus."""
    for case, valid in cases:
        if not valid:
            error = document_of(corpus / case / "expected-error.json", "expected-error")["error"]
            yield Expected(f"{case}/polygon", "invalid", error["kind"])
            continue
        yield Expected(f"{case}/polygon", "valid")
        for name in document_of(corpus / case / "facts.json", "facts")["meshes"]:
            yield Expected(f"{case}/{name}", "valid")
        for defect in document_of(corpus / case / "defects/defects.json", "defects")["defects"]:
            name, kind = f"{case}/{defect['name']}", defect["kind"] or ""
            yield Expected(name, defect["result"], kind, asked=True)


def _verdict_outcome(name: str, given: str | None, known: Expected) -> Outcome:
    """What came of a verifier's verdict."""
    kinds = (known.kind,) if known.kind else ()
    if given is None:
        return Outcome(name, "missing", kinds)
    if given == known.result:
        return Outcome(name, "passed", kinds)
    return Outcome(name, "wrongly accepted" if given == "valid" else "wrongly refused", kinds)
