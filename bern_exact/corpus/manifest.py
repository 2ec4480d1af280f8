"""`manifest.json` and the `README.md` of a corpus: what it holds, and how to use it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from bern_exact.corpus.case import digest
from bern_exact.corpus.flags import FLAGS
from bern_exact.corpus.plan import GENERATOR, Choice, Plan
from bern_exact.corpus.readme import README
from bern_exact.corpus.storage import document_of
from bern_exact.exact.errors import InputError
from bern_exact.formats import safe_json

MANIFEST = "manifest.json"


def manifest_text(directory: Path, plan: Plan) -> str:
    """The manifest of a corpus all of whose cases are in the directory.

    Raises
    ------
    OSError
        A case cannot be read.
    """
    cases, flags = [], set[str]()
    for case in plan.cases():
        path = directory / case / "case.json"
        document = document_of(path, "case")
        flags |= set(document["flags"])
        own = {"case.json": digest(path.read_text(encoding="utf-8"))}
        kept = ("family", "parameters", "result", "flags", "comment")
        cases.append(
            {
                "id": case,
                **{name: document[name] for name in kept},
                "files": {**own, **document["files"]},
            }
        )
    return safe_json.dumps(
        {
            "format": "bern-exact/corpus",
            "version": 1,
            "generator": GENERATOR,
            "seed": plan.seed,
            "count": plan.count,
            "families": [_family(choice) for choice in plan.choices],
            "flags": {flag: words for flag, words in FLAGS.items() if flag in flags},
            "readme": digest(README),
            "cases": cases,
        }
    )


def _family(choice: Choice) -> dict[str, Any]:
    """A family of the corpus: what it is meant to break, its parameters' ranges."""
    family = choice.definition
    ranges = {name: list(limits) for name, limits in family.parameters.items()}
    ranges |= {name: [value, value] for name, value in choice.given.items()}
    return {"name": family.name, "breaks": family.breaks, "parameters": ranges} | (
        {"given": dict(choice.given)} if choice.given else {}
    )


def plan_of(directory: Path) -> Plan:
    """The plan by which a corpus was made, from its manifest.

    Raises
    ------
    InputError
        Kind `unsupported`: made by another version of the generator; `schema`: no manifest.
    OSError
        It cannot be read.
    """
    document = document_of(directory / MANIFEST, "corpus")
    try:
        if document["generator"] != GENERATOR:
            message = f"made by generator {document['generator']}, this is {GENERATOR}"
            raise InputError("unsupported", f"{directory / MANIFEST}: {message}")
        choices = tuple(
            Choice(str(each["name"]), dict(each.get("given", {}))).checked()
            for each in document["families"]
        )
        return Plan(int(document["seed"]), int(document["count"]), choices)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        message = f"{directory / MANIFEST}: {type(error).__name__} {error}"
        raise InputError("schema", message) from error
