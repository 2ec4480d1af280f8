"""JSON text: what is read and how, what is refused, and the bytes that are written."""

from __future__ import annotations

import contextlib
import gc
import io
import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import JsonNumber
from bern_exact.formats.safe_json import dumps, load, loads

scalars = st.none() | st.booleans() | st.integers() | st.text()
documents = st.recursive(
    scalars, lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner), max_leaves=20
)


@given(documents)
def test_what_is_written_is_read_back(document: Any) -> None:
    assert loads(dumps(document)) == document


@given(documents)
def test_what_is_written_is_standard_json_in_ascii(document: Any) -> None:
    text = dumps(document)
    assert text.isascii() and text.endswith("\n")
    assert json.loads(text) == document


@given(st.binary(max_size=200))
def test_any_bytes_are_read_or_refused(data: bytes) -> None:
    try:
        loads(data)
    except InputError as error:
        assert error.kind in ("syntax", "number")
        json.dumps(error.to_json())


@given(st.text(alphabet='[]{}",:0123456789.eE+-truefalsnNIi \\u\ud800', max_size=60))
def test_any_text_like_json_is_read_or_refused(text: str) -> None:
    try:
        loads(text)
    except InputError as error:
        assert error.kind in ("syntax", "number")


REFUSED = {
    "empty": (b"", "syntax"),
    "blank": (b" \n\t ", "syntax"),
    "binary": (b"\x00\x01\x02\xff", "syntax"),
    "picture": (b"\x89PNG\r\n\x1a\n", "syntax"),
    "utf-16": ('{"outer": []}'.encode("utf-16"), "syntax"),
    "latin-1": ('{"name": "Île"}'.encode("latin-1"), "syntax"),
    "cut off": (b'{"outer": [[0, 0], [1', "syntax"),
    "two values": (b"{} {}", "syntax"),
    "single quotes": (b"{'outer': []}", "syntax"),
    "trailing comma": (b"[1,]", "syntax"),
    "deep arrays": (b"[" * 1_000_000, "syntax"),
    "deep closed arrays": (b"[" * 200_000 + b"]" * 200_000, "syntax"),
    "deep objects": (b'{"a":' * 1_000_000, "syntax"),
    "same key twice": (b'{"outer": 1, "outer": 2}', "syntax"),
    "same key twice below": (b'[{"a": {"b": 1, "b": 1}}]', "syntax"),
    "NaN": (b'{"outer": [NaN]}', "number"),
    "infinity": (b"[Infinity]", "number"),
    "minus infinity": (b"[-Infinity]", "number"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_bad_text_is_refused(name: str) -> None:
    data, kind = REFUSED[name]
    with pytest.raises(InputError) as refusal:
        load(io.BytesIO(data))
    assert refusal.value.kind == kind
    assert len(refusal.value.message) < 200


def test_a_refusal_says_where() -> None:
    with pytest.raises(InputError) as refusal:
        loads('{"a": 1,\n "b": }')
    assert refusal.value.where == {"line": 2, "column": 7}
    with pytest.raises(InputError) as refusal:
        loads(b'{"a": "\xff"}')
    assert refusal.value.where == {"byte": 7}
    with pytest.raises(InputError) as refusal:
        loads('{"a": 1, "b": 2, "a": 3}')
    assert refusal.value.where == {"key": "a"}
    with pytest.raises(InputError) as refusal:
        loads('{"a": "NaN, \\"NaN",\n "b": [1, -Infinity, NaN]}')
    assert refusal.value.where == {"line": 2, "column": 11}
    assert refusal.value.message.startswith("-Infinity ")


def test_a_file_that_never_ends_is_refused() -> None:
    zeros = Path("/dev/zero")
    if not zeros.exists():
        pytest.skip("there is no endless file here")
    with pytest.raises(InputError, match="binary"):
        load(zeros)


def test_bare_numbers_keep_their_text() -> None:
    value = loads("[0.10, 1e999999999, -3, 1E2]")
    assert value == ["0.10", "1e999999999", -3, "1E2"]
    assert [type(item) for item in value] == [JsonNumber, JsonNumber, int, JsonNumber]


def test_integers_of_any_length_are_taken() -> None:
    assert loads("9" * 100_000) == "9" * 100_000
    assert type(loads("9" * 1_000_000)) is JsonNumber


def test_paths_bytes_and_text_are_read_alike(tmp_path: Path) -> None:
    text = '{"name": "Île", "outer": [0.5]}'
    path = tmp_path / "x.json"
    path.write_text(text, encoding="utf-8")
    marked = io.BytesIO(b"\xef\xbb\xbf" + text.encode())
    sources = (str(path), path, io.StringIO(text), io.BytesIO(text.encode()), marked)
    assert all(load(source) == loads(text) for source in sources)


def test_a_text_stream_with_wrong_bytes_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "x.json"
    path.write_bytes(b'"\xff"')
    with open(path, encoding="utf-8") as stream, pytest.raises(InputError, match="UTF-8"):
        load(stream)


def test_a_missing_file_is_an_error_of_the_system(tmp_path: Path) -> None:
    with pytest.raises(OSError):
        load(tmp_path / "nothing.json")


@pytest.mark.parametrize("value", [0.5, [0.5], {"a": [1, 2.0]}, {1: 2}, [[1], object()], {1, 2}])
def test_what_has_no_exact_text_is_not_written(value: Any) -> None:
    with pytest.raises(TypeError):
        dumps(value)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ({}, "{}\n"),
        ([], "[]\n"),
        ([[]], "[\n []\n]\n"),
        ({"b": 1, "a": [1, "2/3"]}, '{\n "b": 1,\n "a": [1, "2/3"]\n}\n'),
        ([{"x": 1}, {"y": None}], '[\n {"x": 1},\n {"y": null}\n]\n'),
        ((1, 2), "[1, 2]\n"),
    ],
)
def test_the_layout(value: Any, text: str) -> None:
    assert dumps(value) == text


@pytest.mark.parametrize("offset", [0, 1, 250, 498, 499, 500, 777])
def test_a_long_integer_keeps_its_text_wherever_it_stands(offset: int) -> None:
    for digits, kind in ((1000, int), (1001, JsonNumber), (5000, JsonNumber)):
        (value,) = loads(" " * offset + "[" + "7" * digits + "]")
        assert type(value) is kind and str(value) == "7" * digits


@pytest.mark.parametrize("text", ["[1]", "[1", "[NaN]"])
def test_reading_leaves_the_garbage_collector_as_it_was(text: str) -> None:
    for enabled in (False, True):
        (gc.enable if enabled else gc.disable)()
        with contextlib.suppress(InputError):
            loads(text)
        assert gc.isenabled() is enabled
