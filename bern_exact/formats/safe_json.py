"""JSON in and out: exact numbers, nothing but `InputError` for bad text, and the same bytes always.

Reading differs from the standard library in that a bare number keeps its text (`JsonNumber`, or
`int` if it is a short integer), duplicate keys, `NaN` and `Infinity` are refused, and so is text
that is too deep, too long, binary or not UTF-8.
"""

from __future__ import annotations

import codecs
import gc
import json
import os
import re
from collections import Counter
from collections.abc import Callable, Iterator
from typing import IO, Any, NoReturn

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import JSON_INT_DIGITS, JsonNumber, shown

Source = str | os.PathLike[str] | IO[bytes] | IO[str]
"""A file to read: its path, or an open stream."""

MAX_BYTES = 1 << 30
"""The longest file that is read."""

_FIRST_CHUNK = 1 << 16
_SHOWN_KEY = 100
_STRING_OR_CONSTANT = re.compile(r'"(?:[^"\\]++|\\.)*+"|(?P<constant>NaN|-?Infinity)', re.DOTALL)


def load(source: Source) -> Any:
    """The JSON value in a file or stream.

    Parameters
    ----------
    source : path or stream
        UTF-8, with or without a byte order mark.

    Raises
    ------
    InputError
        Kind `syntax`: not UTF-8, not JSON, longer than `MAX_BYTES`, or refused by `loads`.
    OSError
        The file cannot be read.
    """
    if isinstance(source, str | os.PathLike):
        with open(source, "rb") as stream:
            return loads(_read(stream))
    return loads(_read(source))


def loads(data: str | bytes) -> Any:
    """The JSON value in a text.

    Parameters
    ----------
    data : str or bytes
        Bytes are UTF-8, with or without a byte order mark.

    Raises
    ------
    InputError
        Kind `syntax`, with the line and column, or the byte, or the key at fault: no JSON,
        nested too deeply, or an object with the same key twice.  Kind `number`, with the line
        and column: `NaN` or an infinity.

    >>> loads('{"x": 0.10, "y": 3}')
    {'x': '0.10', 'y': 3}
    """
    text = data if isinstance(data, str) else _decoded(data)
    if not text.strip(" \t\r\n"):
        raise InputError("syntax", "the file is empty")
    try:
        return _decode(text)
    except json.JSONDecodeError as error:
        where = {"line": error.lineno, "column": error.colno}
        message = f"not JSON: {error.msg} at line {error.lineno}, column {error.colno}"
        raise InputError("syntax", message, where) from None
    except RecursionError:
        raise InputError("syntax", "the JSON is nested too deeply") from None
    except _NotFinite:
        raise _not_finite(text) from None


def _decode(text: str) -> Any:
    """The JSON value of a text, as fast as the standard library's reader goes.

    Nothing that a reader makes becomes garbage before it ends, so that collecting would be in
    vain; for a million triangles it takes as long as the reading.
    """
    block = JSON_INT_DIGITS // 2  # whoever is longer than JSON_INT_DIGITS fills one such block
    long = any(text[i : i + block].isdigit() for i in range(0, len(text), block))
    was_collecting = gc.isenabled()
    gc.disable()
    try:
        return (_DECODER if long else _SHORT_DECODER).decode(text)
    finally:
        if was_collecting:
            gc.enable()


def _read(stream: IO[bytes] | IO[str]) -> str | bytes:
    """All of a stream, unless its beginning is binary or it does not end."""
    data: Any  # str and bytes alike, as the stream has it
    try:
        data = stream.read(_FIRST_CHUNK)
        if ("\0" if isinstance(data, str) else b"\0") in data:
            raise InputError("syntax", "not JSON: the file is binary")
        data += stream.read(MAX_BYTES)
    except UnicodeDecodeError as error:  # a text stream of the caller's
        raise _not_utf8(error) from None
    if len(data) > MAX_BYTES:
        raise InputError("syntax", f"the file is longer than {MAX_BYTES:,} bytes")
    whole: str | bytes = data
    return whole


def _decoded(data: bytes) -> str:
    """Bytes as text."""
    try:
        return data.removeprefix(codecs.BOM_UTF8).decode("utf-8")
    except UnicodeDecodeError as error:
        raise _not_utf8(error) from None


def _not_utf8(error: UnicodeDecodeError) -> InputError:
    """The refusal of bytes that are no text."""
    return InputError(
        "syntax", f"the file is not UTF-8 (byte {error.start})", {"byte": error.start}
    )


def _integer(text: str) -> int | JsonNumber:
    """A JSON integer: an `int`, unless it is so long that converting it could be slow."""
    return int(text) if len(text) <= JSON_INT_DIGITS else JsonNumber(text)


class _NotFinite(Exception):
    """The reader has come to a word that it would take for a number."""


def _refuse_constant(word: str) -> NoReturn:
    """Stop at `NaN` or an infinity; the reader does not tell where it is."""
    raise _NotFinite


def _not_finite(text: str) -> InputError:
    """The refusal of the first `NaN` or infinity outside strings: up to there the text is JSON."""
    found = next(token for token in _STRING_OR_CONSTANT.finditer(text) if token["constant"])
    line = text.count("\n", 0, found.start()) + 1
    column = found.start() - text.rfind("\n", 0, found.start())
    message = f"{found['constant']} is not a number of JSON, at line {line}, column {column}"
    return InputError("number", message, {"line": line, "column": column})


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """A JSON object, its keys all different."""
    result = dict(pairs)
    if len(result) < len(pairs):
        counts = Counter(key for key, _ in pairs)
        twice = next(key for key, count in counts.items() if count > 1)
        message = f"an object has the key {shown(twice)} twice"
        raise InputError("syntax", message, {"key": twice[:_SHOWN_KEY]})
    return result


def _decoder(parse_int: Callable[[str], Any] | None) -> json.JSONDecoder:
    """A reader that is told how to read integers; by itself as `int`, without a call for each."""
    return json.JSONDecoder(
        parse_float=JsonNumber,
        parse_int=parse_int,
        parse_constant=_refuse_constant,
        object_pairs_hook=_object,
    )


_DECODER, _SHORT_DECODER = _decoder(_integer), _decoder(None)


def dumps(document: Any) -> str:
    """A JSON document as text, the same bytes for the same document on any machine.

    A list or object that holds no other is one line; of others each item is: one vertex or
    triangle a line.  Keys keep their order; non-ASCII characters are escaped; the text ends with
    a newline.

    Parameters
    ----------
    document : JSON value
        Of dict (string keys), list, tuple, str, int, bool and None.

    Raises
    ------
    TypeError
        The document holds anything else, a float for one.

    Notes
    -----
    Linear; 250,000 vertices and 500,000 triangles take about 3 seconds.

    >>> print(dumps({"version": 1, "triangles": [[0, 1, 2], [2, 1, 3]]}), end="")
    {
     "version": 1,
     "triangles": [
      [0, 1, 2],
      [2, 1, 3]
     ]
    }
    """
    return "".join(_pieces(document, "\n")) + "\n"


_SCALARS = frozenset((str, int, bool, type(None), JsonNumber))
_encode = json.JSONEncoder(separators=(", ", ": ")).encode


def _pieces(value: Any, newline: str) -> Iterator[str]:
    """The text of a value in pieces; `newline` is a line break and the indent."""
    if type(value) in _SCALARS or _is_flat(value):
        yield _encode(value)
        return
    inner = newline + " "
    is_object = isinstance(value, dict)
    separator = "{" if is_object else "["
    for key, item in value.items() if is_object else enumerate(value):
        yield separator + inner + (f"{_encode(key)}: " if is_object else "")
        if type(item) is list and _SCALARS.issuperset(map(type, item)):
            yield _encode(item)  # what the next line does, only that millions of them are quicker
        else:
            yield from _pieces(item, inner)
        separator = ","
    yield newline + ("}" if is_object else "]")


def _is_flat(value: Any) -> bool:
    """Does a list or object hold scalars only?"""
    if isinstance(value, dict):
        if not all(type(key) is str for key in value):
            raise TypeError("the keys of a JSON object are strings")
        return _SCALARS.issuperset(map(type, value.values()))
    if isinstance(value, list | tuple):
        return _SCALARS.issuperset(map(type, value))
    raise TypeError(f"a {type(value).__name__} has no exact JSON text")
