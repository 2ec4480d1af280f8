"""The same bytes whenever, and whatever the hash seed."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from bern_exact.api import triangulate
from tests.theorems.families import FAMILIES, some_polygon

ROOT = Path(__file__).resolve().parents[2]

PRINTED = """
import hashlib
from bern_exact.api import triangulate
from tests.theorems.families import FAMILIES, some_polygon
for kind in sorted(FAMILIES)[::2]:
    document = triangulate(some_polygon(kind, 1), theorem=1).document
    print(kind, hashlib.sha256(document.encode()).hexdigest())
"""


def digests(hash_seed: str) -> str:
    """One line a family of every second one, printed by another process."""
    return subprocess.run(
        [sys.executable, "-c", PRINTED],
        env={**os.environ, "PYTHONHASHSEED": hash_seed},
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    ).stdout


def test_the_same_bytes_under_any_hash_seed() -> None:
    first = digests("0")
    assert first.count("\n") == len(sorted(FAMILIES)[::2])
    assert digests("4242") == first


@pytest.mark.parametrize("kind", ["simple_with_holes", "tiny_holes", "threshold"])
def test_the_same_bytes_twice(kind: str) -> None:
    polygon = some_polygon(kind, 6)
    first, second = (triangulate(polygon, theorem=1).document for _ in range(2))
    assert first == second
