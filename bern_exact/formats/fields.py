"""What the readers of JSON documents share: one field at a time, refused with its path."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import JsonNumber, json_kind, rational_from_json, shown
from bern_exact.exact.points import HPoint, hpoint

_MISSING = object()


def refuse(kind: str, message: str, path: str) -> InputError:
    """The refusal of what stands at a path."""
    return InputError(kind, f"{message} (at {path})", {"path": path})


def as_object(value: Any, path: str) -> dict[str, Any]:
    """The value, if it is an object."""
    if not isinstance(value, dict):
        raise refuse("schema", f"an object is expected, not {json_kind(value)}", path)
    return value


def as_list(value: Any, path: str) -> Sequence[Any]:
    """The value, if it is an array (a tuple counts)."""
    if not isinstance(value, list | tuple):
        raise refuse("schema", f"an array is expected, not {json_kind(value)}", path)
    return value


def member(document: dict[str, Any], key: str, path: str) -> Any:
    """A member that must be there."""
    value = document.get(key, _MISSING)
    if value is _MISSING:
        raise refuse("schema", f'"{key}" is missing', path)
    return value


def as_name(value: Any, path: str) -> str:
    """The value, if it is a string of real characters (no half of a surrogate pair)."""
    if not isinstance(value, str) or isinstance(value, JsonNumber):
        raise refuse("schema", f"a string is expected, not {json_kind(value)}", path)
    if any("\ud800" <= character <= "\udfff" for character in value):
        raise refuse("schema", "the string holds half a surrogate pair", path)
    return value


def check_format(document: dict[str, Any], name: str, path: str) -> None:
    """Refuse a document of another format, or of another version than 1; a bare one has neither."""
    if "format" not in document:
        if "version" in document:
            check_version(document["version"], f"{path}.version")
        return
    found = document["format"]
    if found != name:
        told = shown(found) if isinstance(found, str) else json_kind(found)
        raise refuse("unsupported", f'format "{name}" is expected, not {told}', f"{path}.format")
    check_version(member(document, "version", path), f"{path}.version")


def check_version(version: Any, path: str) -> None:
    """Refuse another version than 1."""
    if type(version) is not int:
        raise refuse("schema", f"an integer is expected, not {json_kind(version)}", path)
    if version != 1:
        raise refuse("unsupported", "version 1 alone is read", path)


def as_points(value: Any, path: str, *, binary64: bool) -> list[HPoint]:
    """The points of an array of `[x, y]`."""
    items = as_list(value, path)
    try:
        return [_point(item, path, binary64=binary64) for item in items]
    except InputError:  # the exact paths cost as much as the numbers: made for refusals alone
        for i, item in enumerate(items):
            _point(item, f"{path}[{i}]", binary64=binary64)
        raise


def _point(value: Any, path: str, *, binary64: bool) -> HPoint:
    """The point of a pair of numbers."""
    pair = as_list(value, path)
    if len(pair) != 2:
        raise refuse("schema", f"a point is [x, y], not {len(pair)} values", path)
    x = rational_from_json(pair[0], f"{path}[0]", binary64=binary64)
    y = rational_from_json(pair[1], f"{path}[1]", binary64=binary64)
    return hpoint(x, y)
