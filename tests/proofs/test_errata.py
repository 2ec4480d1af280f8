"""The page of errata is what the proofs say."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache

import pytest

from proofs.drawings import DRAWINGS
from proofs.errata import DOCS, entry_of, files
from proofs.errata_list import ERRATA, Erratum
from proofs.table import NOTES


@cache
def made() -> Mapping[str, str]:
    return files()


def test_the_page_and_its_drawings_are_up_to_date() -> None:
    stale = [name for name, text in made().items() if (DOCS / name).read_text("utf-8") != text]
    assert not stale, "python -m proofs.errata --write"


def test_no_drawing_is_left_over() -> None:
    there = {f"errata/{path.name}" for path in (DOCS / "errata").iterdir()}
    assert there == {name for name in made() if name.startswith("errata/")}


def test_drawings_are_small() -> None:
    assert all(len(text) < 10_000 for name, text in made().items() if name.endswith(".svg"))


@pytest.mark.parametrize("erratum", ERRATA, ids=lambda erratum: erratum.refuted)
def test_each_rests_on_a_refuted_statement(erratum: Erratum) -> None:
    assert entry_of(erratum.refuted).status == "refuted"
    assert all(entry_of(name).status in ("proved", "open") for name in erratum.repaired)
    assert not erratum.drawing or erratum.drawing in DRAWINGS


def test_every_drawing_is_used() -> None:
    assert {erratum.drawing for erratum in ERRATA} - {""} == set(DRAWINGS)


def test_every_statement_that_the_table_names_is_there() -> None:
    named = re.findall(r"`(\w+\.\w+)`", " ".join(NOTES))
    assert len(named) >= 8
    for name in named:
        entry_of(name)
