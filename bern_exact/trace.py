"""Every stage's record on disk, as JSON and as a picture: what `--trace DIR` leaves behind."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from gmpy2 import mpq, mpz

from bern_exact.checkers.findings import Finding
from bern_exact.exact.numbers import format_rational
from bern_exact.exact.points import coordinates
from bern_exact.outputs import write_atomically
from bern_exact.view.stages import draw_stage, more_pictures


class Trace:
    """A directory that stage records are written to as they are made.

    Parameters
    ----------
    directory : Path
        Made if it is not there.
    """

    def __init__(self, directory: Path) -> None:
        directory.mkdir(parents=True, exist_ok=True)
        self._directory = directory
        self._names: dict[int, str] = {}
        self._kept: list[object] = []  # an id is unique only while its object lives

    def stage(self, name: str, record: object) -> None:
        """Write `NN-name.json` and, if there is something to see, `NN-name.svg`."""
        stem = f"{len(self._kept) + 1:02d}-{name}"
        self._write(f"{stem}.json", json.dumps(plain(record, self._names), indent=1) + "\n")
        picture = draw_stage(name, record)
        if picture is not None:
            self._write(f"{stem}.svg", picture)
        for suffix, further in more_pictures(name, record):
            self._write(f"{stem}-{suffix}.svg", further)
        self._names[id(record)] = name
        self._kept.append(record)

    def violation(self, finding: Finding) -> Path:
        """Write `violation.json`: the claim that failed, with its exact witness."""
        record = {**finding.to_json(), "witness": plain(finding.witness, {})}
        return self._write("violation.json", json.dumps(record, indent=1) + "\n")

    def _write(self, name: str, text: str) -> Path:
        path = self._directory / name
        write_atomically(path, text)
        return path


def plain(value: Any, known: Mapping[int, str]) -> Any:
    """A record as JSON values, nothing rounded.

    Rationals become text, points `["p/q", "p/q"]`, named tuples and records objects,
    mappings with keys other than text lists of pairs, sets sorted lists.

    Parameters
    ----------
    value : object
        A record, or anything within one.
    known : mapping
        From the ids of the records already written to their names; one found
        within another becomes `{"stage": name}`.

    >>> plain((mpz(1), mpz(-1), mpz(2)), {})
    ['1/2', '-1/2']
    >>> plain({(0, 1): mpq(1, 3)}, {})
    [[[0, 1], '1/3']]
    """
    if value is None or isinstance(value, bool | int | str):
        return value
    if isinstance(value, mpq | mpz):
        return format_rational(value)
    if id(value) in known:
        return {"stage": known[id(value)]}
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        fields = dataclasses.fields(value)
        return {f.name: plain(getattr(value, f.name), known) for f in fields}
    if isinstance(value, Mapping) and all(isinstance(key, str) for key in value):
        return {key: plain(v, known) for key, v in value.items()}
    if isinstance(value, Mapping):
        return [[plain(k, known), plain(v, known)] for k, v in value.items()]
    if isinstance(value, set | frozenset):
        return [plain(v, known) for v in sorted(value)]
    return _plain_sequence(value, lambda v: plain(v, known))


def _plain_sequence(value: Any, convert: Callable[[Any], Any]) -> Any:
    """A point, a named tuple or any other sequence."""
    if hasattr(value, "_fields"):
        return {name: convert(v) for name, v in zip(value._fields, value, strict=True)}
    if len(value) == 3 and all(isinstance(v, mpz) for v in value):
        return [format_rational(c) for c in coordinates(value)]
    return [convert(v) for v in value]
