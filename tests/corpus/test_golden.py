"""The corpus in the repository: made again, byte for byte, and all that a corpus should hold.

Where a change of bytes is meant, `GENERATOR` goes up and the corpus is made anew:
`bern-exact corpus generate --out corpus --seed 2 --count 60`.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from bern_exact import Polygon, verify
from bern_exact.corpus.case import case_files
from bern_exact.corpus.flags import FLAGS
from bern_exact.corpus.manifest import manifest_text, plan_of
from bern_exact.corpus.readme import README
from bern_exact.corpus.storage import files_below
from bern_exact.exact.errors import InputError
from bern_exact.formats import read_mesh_file
from bern_exact.oracle.defects import DAMAGES
from bern_exact.oracle.verdict import DEFECTS

CORPUS = Path(__file__).resolve().parents[2] / "corpus"
PLAN = plan_of(CORPUS)
CASES = list(PLAN.cases())
GOOD = [case for case in CASES if (CORPUS / case / "facts.json").exists()]
MOST_BYTES = 5_000_000


@cache
def validator(kind: str) -> Draft202012Validator:
    path = resources.files("bern_exact").joinpath("schemas", f"{kind}.schema.json")
    return Draft202012Validator(json.loads(path.read_text()))


def document(*parts: str) -> dict[str, Any]:
    record = json.loads(CORPUS.joinpath(*parts).read_text())
    assert isinstance(record, dict)
    return record


def defects() -> Iterator[tuple[str, dict[str, Any]]]:
    for case in GOOD:
        for defect in document(case, "defects", "defects.json")["defects"]:
            yield case, defect


@pytest.mark.parametrize("case", CASES)
def test_a_case_is_made_again(case: str) -> None:
    made = case_files(PLAN.seed, case)
    assert sorted(made) == list(files_below(CORPUS / case))
    for path, text in made.items():
        assert (CORPUS / case / path).read_bytes() == text.encode(), path


def test_the_manifest_is_made_again() -> None:
    assert (CORPUS / "manifest.json").read_text() == manifest_text(CORPUS, PLAN)
    assert (CORPUS / "README.md").read_text() == README
    assert {path.name for path in CORPUS.iterdir()} == {*CASES, "manifest.json", "README.md"}


def test_it_is_small() -> None:
    assert sum(path.stat().st_size for path in CORPUS.rglob("*") if path.is_file()) < MOST_BYTES


def test_every_way_of_damaging_is_in_it() -> None:
    assert {defect["damage"] for _, defect in defects()} == set(DAMAGES)
    assert {defect["kind"] for _, defect in defects()} == {*DEFECTS, None}


@pytest.mark.parametrize("case", CASES)
def test_documents_follow_their_schemas(case: str) -> None:
    for path in files_below(CORPUS / case):
        if path.endswith(".json") and path not in ("polygon.json",):
            kind = path.removesuffix(".json").rpartition("/")[2].rpartition(".")[2]
            record = document(case, path)
            validator(kind).validate(record)
            assert "case" not in record or record["case"] == case
    if case in GOOD:
        validator("polygon").validate(document(case, "polygon.json"))
    assert set(document(case, "case.json")["flags"]) <= set(FLAGS)


def test_the_manifest_follows_its_schema() -> None:
    validator("corpus").validate(document("manifest.json"))


@pytest.mark.parametrize("case", sorted(set(CASES) - set(GOOD)))
def test_bad_polygons_are_refused_as_expected(case: str) -> None:
    expected = document(case, "expected-error.json")["error"]
    with pytest.raises(InputError) as caught:
        Polygon.load(CORPUS / case / "polygon.json")
    assert caught.value.kind == expected["kind"]


@pytest.mark.parametrize("case", GOOD)
def test_damaged_meshes_are_judged_as_expected(case: str) -> None:
    for defect in document(case, "defects", "defects.json")["defects"]:
        mesh, polygon = read_mesh_file(CORPUS / case / defect["file"])
        verdict = verify(mesh, None, polygon, **defect["criterion"])
        assert verdict.valid is (defect["result"] == "valid"), defect["name"]
        assert defect["kind"] is None or defect["kind"] in {d.kind for d in verdict.defects}


@pytest.mark.parametrize("case", GOOD)
def test_exact_polygons_are_the_same_in_every_format(case: str) -> None:
    polygon = Polygon.load(CORPUS / case / "polygon.json")
    rounded = document(case, "case.json")["rounded"]
    for suffix in ("poly", "wkt", "geojson"):
        path = CORPUS / case / f"polygon.{suffix}"
        if path.exists() and path.name not in rounded:
            other = Polygon.load(path, numbers="binary64")
            assert sorted(other.points) == sorted(polygon.points)
