"""The small corpus, made once a worker."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.corpus import small


@pytest.fixture(scope="session")
def corpus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A small corpus; whoever changes it takes a copy."""
    return small.made(tmp_path_factory.mktemp("corpus") / "small")
