"""Which reader a file gets: by the format that is named, or else by its suffix."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import TypeVar

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import shown

_R = TypeVar("_R")


def reader_for(
    path: str | os.PathLike[str],
    format: str | None,
    by_suffix: Mapping[str, _R],
    by_name: Mapping[str, _R],
    what: str,
) -> _R:
    """The reader for a file.

    Parameters
    ----------
    path : path
        Its suffix counts if no format is named, in any case of letters.
    format : str or None
        A key of `by_name`.
    by_suffix, by_name : mapping
        The readers.
    what : {"mesh", "polygon"}
        What is read, for messages.

    Raises
    ------
    InputError
        Kind `unsupported`: no such format, or none of that suffix.
    """
    if format is None:
        suffix = Path(path).suffix.lower()
        if suffix not in by_suffix:
            known = ", ".join(sorted(by_suffix))
            message = f"no {what} format has the suffix {suffix!r}; there are: {known}"
            raise InputError("unsupported", message, {"suffix": suffix})
        return by_suffix[suffix]
    if format not in by_name:
        known = ", ".join(by_name)
        raise InputError("unsupported", f"no {what} format {shown(format)}; there are: {known}")
    return by_name[format]
