"""Results on their way out: files written whole or not at all, and standard output."""

from __future__ import annotations

import json
import os
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any


def write_atomically(path: Path, text: str) -> None:
    """Write a text file so that no reader ever sees a part of it.

    Parameters
    ----------
    path : Path
        Its place; a link is followed.  What is no regular file (`/dev/null`, a
        pipe) is written to directly.
    text : str
        Written as UTF-8, line ends as they are.

    Raises
    ------
    OSError
        If it cannot be written; then the old file, if any, is still there.
    """
    try:
        _write(Path(os.path.realpath(path)), text)
    except OSError as error:  # its file is the temporary one or none: nobody would know it
        raise OSError(error.errno, error.strerror, str(path)) from error


def _write(path: Path, text: str) -> None:
    """Write to a path that is no link."""
    if path.exists() and not path.is_file():
        path.write_text(text, encoding="utf-8", newline="\n")
        return
    handle, temporary = tempfile.mkstemp(prefix=f".{path.name[:50]}.", dir=path.parent)
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as stream:
            stream.write(text)
        os.chmod(temporary, _mode(path))
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def _mode(path: Path) -> int:
    """The permissions that the file has, or that a new one would get."""
    if path.exists():
        return path.stat().st_mode & 0o777
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask


def emit(text: str) -> None:
    """Write to stdout, as UTF-8 whatever the locale; a reader that has gone away is no error.

    Raises
    ------
    OSError
        If it cannot be written, for want of room say.
    """
    if sys.stdout is None:  # closed from the start: nobody wants to know
        return
    try:
        sys.stdout.flush()
        sys.stdout.buffer.write(text.encode("utf-8", "backslashreplace"))
        sys.stdout.buffer.flush()
    except OSError as error:
        # What is still buffered must not fail again when Python shuts down.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if not isinstance(error, BrokenPipeError):
            raise OSError(error.errno, error.strerror, "standard output") from error


def emit_json(record: Mapping[str, Any], path: Path | None = None) -> None:
    """Write a JSON object to stdout or a file, ASCII only, so that any terminal can show it."""
    text = json.dumps(record, indent=2) + "\n"
    if path is None:
        emit(text)
    else:
        write_atomically(path, text)
