"""What is written is what the schemas say."""

from __future__ import annotations

import json
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from bern_exact import Polygon, triangulate
from bern_exact.facts import facts_of
from bern_exact.oracle.fast import verify_mesh

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
SMALL = ("glyph_dejavusans_A", "mdi_chip", "us_county_51015_augusta")


@cache
def validator(name: str) -> Draft202012Validator:
    text = resources.files("bern_exact").joinpath("schemas", f"{name}.schema.json").read_text()
    schema: dict[str, Any] = json.loads(text)
    Draft202012Validator.check_schema(schema)
    return Draft202012Validator(schema)


@cache
def example(name: str) -> Polygon:
    return Polygon.load(EXAMPLES / f"{name}.json")


@pytest.mark.parametrize("name", SMALL)
def test_certificates_follow_their_schema(name: str) -> None:
    certificate = triangulate(example(name), theorem=1).certificate.to_json()
    validator("certificate").validate(certificate)


@pytest.mark.parametrize("name", SMALL)
def test_meshes_and_verdicts_follow_their_schemas(name: str) -> None:
    result = triangulate(example(name), theorem=1, check="none")
    validator("mesh").validate(json.loads(result.document))
    validator("verdict").validate(verify_mesh(result.mesh, result.polygon).to_json())


@pytest.mark.parametrize("name", SMALL)
def test_facts_follow_their_schema(name: str) -> None:
    validator("facts").validate(facts_of(example(name)).to_json())


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.json")), ids=lambda p: p.stem)
def test_the_examples_follow_the_polygon_schema(path: Path) -> None:
    validator("polygon").validate(json.loads(path.read_text()))


def test_a_certificate_with_a_rounded_number_is_refused() -> None:
    certificate = triangulate(example(SMALL[0]), theorem=1).certificate.to_json()
    certificate["min_height_squared"] = 0.5
    assert not validator("certificate").is_valid(certificate)
