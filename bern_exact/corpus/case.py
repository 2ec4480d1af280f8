"""One case of a corpus as the files that it consists of: a function of seed and id alone."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from hashlib import sha256
from typing import Any

from bern_exact.api import Result, triangulate
from bern_exact.corpus.damaged import damaged_meshes
from bern_exact.corpus.families import Drawn, Family, drawn
from bern_exact.corpus.files import File
from bern_exact.corpus.foreign import foreign_mesh, foreign_polygons
from bern_exact.corpus.plan import GENERATOR, choice_of
from bern_exact.exact.errors import InputError
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.facts import Facts, facts_of
from bern_exact.formats import safe_json
from bern_exact.formats.polygon_json import FORMAT as POLYGON
from bern_exact.formats.polygon_json import dump_polygon, point_texts
from bern_exact.plane.validation import polygon_from_rings

Files = Mapping[str, str]
"""Path within the case's folder -> text."""


@dataclass(frozen=True)
class Identity:
    """What every file of a case repeats.

    Parameters
    ----------
    seed : int
        The corpus's.
    case : str
        The case's id.
    """

    seed: int
    case: str

    @property
    def chance(self) -> str:
        """What all chance in the case begins from."""
        return f"bern-exact {GENERATOR} {self.seed} {self.case}"

    def header(self, kind: str) -> dict[str, Any]:
        """The first members of a document of this kind."""
        return {
            "format": f"bern-exact/{kind}",
            "version": 1,
            "generator": GENERATOR,
            "seed": self.seed,
            "case": self.case,
        }


def case_files(seed: int, case: str) -> Files:
    """All files of a case.

    Parameters
    ----------
    seed : int
        The corpus's.
    case : str
        An id, see `Choice.case`.

    Returns
    -------
    mapping of str to str
        `case.json` first: identity, family, parameters, flags, comment, and each other file's
        SHA-256.

    Raises
    ------
    InputError
        No such family or parameter.
    LemmaViolation
        A guarantee of a theorem failed on the way.

    Notes
    -----
    Takes what the theorems take, every stage checked.
    """
    choice, _ = choice_of(case)
    identity = Identity(seed, case)
    family = choice.definition
    made = drawn(family, identity.chance, choice.given)
    made_files = _bad_files(identity, made) if family.errors else _files(identity, family, made)
    files = {file.path: file for file in made_files}
    document = safe_json.dumps(_case_document(identity, family, made, files))
    return {"case.json": document, **{path: file.text for path, file in files.items()}}


def _case_document(
    identity: Identity, family: Family, made: Drawn, files: Mapping[str, File]
) -> dict[str, Any]:
    """Who the case is, and what it consists of."""
    return {
        **identity.header("case"),
        "family": family.name,
        "parameters": dict(made.parameters),
        "result": "invalid" if family.errors else "valid",
        "flags": list(made.flags),
        "comment": made.comment,
        "breaks": family.breaks,
        "rounded": {path: file.rounded for path, file in files.items() if file.rounded},
        "files": {path: digest(file.text) for path, file in files.items()},
    }


def digest(text: str) -> str:
    """The SHA-256 of a file with this text."""
    return sha256(text.encode("utf-8")).hexdigest()


def _bad_files(identity: Identity, made: Drawn) -> Iterator[File]:
    """A polygon that is none, and how that is to be said."""
    rings = _points(made)
    try:
        polygon_from_rings(rings)
    except InputError as error:
        texts = [point_texts(ring) for ring in rings]
        document: dict[str, Any] = {"format": POLYGON, "version": 1, "name": identity.case}
        document |= {"outer": texts[0], "holes": texts[1:]}
        yield File("polygon.json", safe_json.dumps(document))
        said = {"kind": error.kind, "message": error.message, "where": error.where}
        expected = {**identity.header("expected-error"), "error": said}
        yield File("expected-error.json", safe_json.dumps(expected))


def _points(made: Drawn) -> list[list[HPoint]]:
    """The rings as exact points."""
    return [[hpoint(x, y) for x, y in ring] for ring in made.rings]


def _files(identity: Identity, family: Family, made: Drawn) -> Iterator[File]:
    """A polygon, its facts, each theorem's mesh, and meshes that are damaged."""
    polygon = polygon_from_rings(_points(made), identity.case)
    yield File("polygon.json", safe_json.dumps(dump_polygon(polygon)))
    yield from foreign_polygons(polygon)
    facts = facts_of(polygon)
    meshes = {
        f"theorem-{theorem}": triangulate(polygon, theorem=theorem, thin=not family.raw)
        for theorem in theorems_for(facts)
    }
    yield File("facts.json", safe_json.dumps(_facts_document(identity, facts, meshes)))
    for name, result in meshes.items():
        yield File(f"{name}.mesh.json", result.document)
        yield from foreign_mesh(name, result.mesh)
    yield from damaged_meshes(identity.header("defects"), polygon, meshes)


def theorems_for(facts: Facts) -> list[int]:
    """The theorems that apply: 1; 2 to a simple polygon, 3 to one with holes; 4 to a convex one."""
    return [1, 3 if facts.polygon.holes else 2, *([4] if facts.convex else [])]


def _facts_document(
    identity: Identity, facts: Facts, meshes: Mapping[str, Result]
) -> dict[str, Any]:
    """The facts of the polygon, and the figures of the meshes."""
    figures = {name: result.certificate.figures() for name, result in meshes.items()}
    return {**identity.header("facts"), **facts.to_json(), "meshes": figures}
