"""Polygon files: read, refused with the place, written in input order."""

from __future__ import annotations

import io
import json
import re
from importlib import resources
from itertools import chain
from typing import Any

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st
from jsonschema import Draft202012Validator

from bern_exact.exact.errors import INPUT_ERROR_KINDS, InputError
from bern_exact.exact.points import coordinates
from bern_exact.formats.polygon_json import dump_polygon, load_polygon, read_polygon
from bern_exact.formats.safe_json import dumps, loads

PLATE: dict[str, Any] = {
    "format": "bern-exact/polygon",
    "version": 1,
    "name": "plate",
    "outer": [["0", "0"], ["4", "1/3"], ["3", "3"]],
    "holes": [[["2", "1"], ["5/2", "1"], ["2", "3/2"]]],
}
LOWEST_TERMS = re.compile(r"-?[0-9]+(/[1-9][0-9]*)?")

json_values = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-3, 3)
    | st.integers()
    | st.floats()
    | st.text(max_size=3)
    | st.sampled_from(["1/2", "0.5", "1/0", "NaN", "1e99999", "bern-exact/polygon"]),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=3), inner),
    max_leaves=10,
)


@pytest.fixture(scope="module")
def schema() -> Draft202012Validator:
    text = resources.files("bern_exact").joinpath("schemas/polygon.schema.json").read_text()
    loaded = json.loads(text)
    Draft202012Validator.check_schema(loaded)
    return Draft202012Validator(loaded)


def but(**changes: Any) -> dict[str, Any]:
    """The plate, changed."""
    return {**PLATE, **changes}


def test_the_plate_of_the_manual() -> None:
    plate = read_polygon(PLATE)
    assert (plate.name, plate.n, plate.holes) == ("plate", 6, 1)
    assert coordinates(plate.points[1]) == (4, mpq(1, 3))


def test_what_is_written_is_what_was_read() -> None:
    assert dump_polygon(read_polygon(PLATE)) == PLATE


@pytest.mark.parametrize("turn", [False, True])
def test_rings_keep_their_input_order(turn: bool) -> None:
    document = but(outer=PLATE["outer"][::-1], holes=[PLATE["holes"][0][::-1]]) if turn else PLATE
    written = dump_polygon(read_polygon(document))
    assert (written["outer"], written["holes"]) == (document["outer"], document["holes"])


def test_written_documents_follow_the_schema(schema: Draft202012Validator) -> None:
    written = json.loads(dumps(dump_polygon(read_polygon(PLATE))))
    schema.validate(written)
    points = chain(written["outer"], *written["holes"])
    assert all(LOWEST_TERMS.fullmatch(text) for text in chain(*points))


def test_a_bare_outer_ring_is_read(schema: Draft202012Validator) -> None:
    bare = {"outer": PLATE["outer"]}
    schema.validate(bare)
    assert read_polygon(bare).n == 3


def test_other_members_are_ignored() -> None:
    bare = {"outer": PLATE["outer"], "source": ["anything", {"at": None}], "holes": []}
    assert read_polygon(bare) == read_polygon({"outer": PLATE["outer"]})


def test_bare_decimals_are_exact_and_binary64_on_demand() -> None:
    text = '{"outer": [[0, 0], [0.1, 0], ["0.1", 1]]}'
    exact = load_polygon(io.StringIO(text))
    assert [coordinates(p)[0] for p in exact.points] == [0, mpq(1, 10), mpq(1, 10)]
    doubled = load_polygon(io.StringIO(text), binary64=True)
    assert coordinates(doubled.points[1])[0] == mpq(*(0.1).as_integer_ratio())


REFUSED: list[tuple[Any, str, str]] = [
    (None, "schema", "$"),
    ([], "schema", "$"),
    ("outer", "schema", "$"),
    ({}, "schema", "$"),
    (but(format="bern-exact/mesh"), "unsupported", "$.format"),
    (but(format=3), "unsupported", "$.format"),
    (but(version=2), "unsupported", "$.version"),
    (but(version="1"), "schema", "$.version"),
    (but(version=True), "schema", "$.version"),
    (but(version=1.0), "schema", "$.version"),
    ({"format": "bern-exact/polygon", "outer": []}, "schema", "$"),
    (but(name=None), "schema", "$.name"),
    (but(name="\ud800"), "schema", "$.name"),
    (but(outer=None), "schema", "$.outer"),
    (but(outer="0 0 1 1"), "schema", "$.outer"),
    (but(outer={"0": [0, 0]}), "schema", "$.outer"),
    (but(outer=[0, 1, 2]), "schema", "$.outer[0]"),
    (but(outer=[[0, 0], [1, 0, 0], [1, 1]]), "schema", "$.outer[1]"),
    (but(outer=["00", "10", "11"]), "schema", "$.outer[0]"),
    (but(outer=[[0, 0], [1, 0], [True, 1]]), "number", "$.outer[2][0]"),
    (but(outer=[[0, 0], [1, 0], [1, None]]), "number", "$.outer[2][1]"),
    (but(outer=[[0, 0], [1, 0], [1, "1/0"]]), "number", "$.outer[2][1]"),
    (but(outer=[[0, 0], [1, 0], [1, "1e10001"]]), "number", "$.outer[2][1]"),
    (but(outer=[[0, 0], [1, 0], [[1], 1]]), "number", "$.outer[2][0]"),
    (but(holes=None), "schema", "$.holes"),
    (but(holes=[[[0, 0]], 5]), "schema", "$.holes[1]"),
    (but(holes=[[[0, "x"]]]), "number", "$.holes[0][0][1]"),
]


@pytest.mark.parametrize(("document", "kind", "path"), REFUSED)
def test_what_is_no_polygon_document_is_refused_with_its_path(
    document: Any, kind: str, path: str
) -> None:
    with pytest.raises(InputError) as refusal:
        read_polygon(document)
    assert (refusal.value.kind, refusal.value.where) == (kind, {"path": path})


def test_what_is_refused_does_not_follow_the_schema(schema: Draft202012Validator) -> None:
    beyond = {"1e10001", "\ud800"}  # limits that a pattern does not know
    for document, _, path in REFUSED:
        if path != "$.version" and not any(ascii(text)[1:-1] in ascii(document) for text in beyond):
            assert not schema.is_valid(document), document


def test_rings_that_are_no_polygon_are_refused_by_the_validation() -> None:
    with pytest.raises(InputError) as refusal:
        read_polygon(but(outer=[[0, 0], [1, 1], [1, 0], [0, 1]], holes=[]))
    assert refusal.value.kind == "edges-cross"


@given(json_values)
def test_any_json_value_is_read_or_refused(value: Any) -> None:
    check_refusal(value)


@given(st.fixed_dictionaries({"outer": json_values}, optional={"holes": json_values}))
def test_any_rings_are_read_or_refused(document: Any) -> None:
    check_refusal(document)


numbers = st.integers(-3, 3) | st.sampled_from(["1/2", "-0.5", "1/0", "x", None])


@given(st.lists(st.lists(st.tuples(numbers, numbers), max_size=6), min_size=1, max_size=3))
def test_any_rings_of_points_are_read_or_refused(rings: Any) -> None:
    check_refusal({"outer": rings[0], "holes": rings[1:]})


@given(st.sampled_from(sorted(PLATE)), json_values)
def test_the_plate_with_any_member_replaced_is_read_or_refused(key: str, value: Any) -> None:
    check_refusal(but(**{key: value}))


@given(st.data())
def test_a_damaged_text_is_read_or_refused(data: st.DataObject) -> None:
    text = dumps(PLATE)
    start = data.draw(st.integers(0, len(text)))
    length = data.draw(st.integers(0, 12))
    put = data.draw(st.text(max_size=3) | st.sampled_from(['"', "[", "]", "}", "1e9", "null"]))
    try:
        read_polygon(loads(text[:start] + put + text[start + length :]))
    except InputError as error:
        assert error.kind in INPUT_ERROR_KINDS


def check_refusal(document: Any) -> None:
    """The document is read, or refused in a way that can be printed as JSON."""
    try:
        polygon = read_polygon(document)
    except InputError as error:
        assert error.kind in INPUT_ERROR_KINDS
        json.dumps(error.to_json(), allow_nan=False).encode()
    else:
        assert read_polygon(dump_polygon(polygon)) == polygon
