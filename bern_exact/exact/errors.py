"""The exceptions that reach users: bad input, and nothing else.

`LemmaViolation` lives with the checkers (`bern_exact.checkers.findings`).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

INPUT_ERROR_KINDS = (
    "syntax",
    "number",
    "schema",
    "unsupported",
    "too-few-vertices",
    "repeated-vertex",
    "zero-area",
    "edges-cross",
    "edges-touch",
    "edges-overlap",
    "spike",
    "hole-outside",
    "hole-in-hole",
    "not-convex",
    "has-holes",
)
"""The closed list of reasons for which an input is refused."""


class InputError(ValueError):
    """An input that is not what it must be.

    Parameters
    ----------
    kind : str
        One of `INPUT_ERROR_KINDS`.
    message : str
        One sentence for people: what is wrong, where, what to do.
    where : mapping, optional
        The place, JSON-ready: `{"ring": 0, "vertex": 3}`, `{"edges": [[0, 3], [1, 0]],
        "point": ["1/2", "3"]}`, `{"path": "$.outer[3][0]"}`, ...  Vertices and edges are
        `[ring, index]` in input order; edge `[r, i]` joins vertices i and i + 1 of ring r.
    """

    def __init__(self, kind: str, message: str, where: Mapping[str, Any] | None = None) -> None:
        super().__init__(message)
        self.kind = kind
        self.message = message
        self.where: dict[str, Any] = dict(where or {})

    def to_json(self) -> dict[str, Any]:
        """The error as the object that `--json` prints under `"error"`."""
        return {"kind": self.kind, "message": self.message, "where": self.where}
