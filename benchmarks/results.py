"""The file of results: one section a benchmark, rewritten by the benchmark itself."""

from __future__ import annotations

import os
import platform
from pathlib import Path

import gmpy2


def machine() -> str:
    """What the figures were measured on."""
    return (
        f"Measured with Python {platform.python_version()}, gmpy2 {gmpy2.version()}, "
        f"{platform.system()} {platform.machine()}, {os.cpu_count()} cores."
    )


def write_section(path: Path, title: str, text: str) -> None:
    """Replace or append one section of a Markdown file."""
    head = f"## {title}\n"
    old = path.read_text() if path.exists() else "# Results\n"
    before, found, rest = old.partition(head)
    after = ""
    if found:
        _, mark, tail = rest.partition("\n## ")
        after = mark.lstrip("\n") + tail if mark else ""
    path.write_text(
        f"{before.rstrip()}\n\n{head}\n{text.strip()}\n" + (f"\n{after}" if after else "")
    )
