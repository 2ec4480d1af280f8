"""The `README.md` of every corpus, the same in each."""

from __future__ import annotations

from importlib import resources

README = resources.files("bern_exact.corpus").joinpath("README.md").read_text(encoding="utf-8")
"""How a corpus is laid out and used."""
