"""The quick run: every statement's work is done, one test a statement."""

from __future__ import annotations

from importlib import import_module

import pytest

from proofs.registry import modules
from proofs.statement import Chapter, Entry, NotShown, demand

ENTRIES: dict[str, Entry] = {
    f"{name.removeprefix('proofs.')}.{entry.name}": entry
    for name in modules()
    for entry in getattr(getattr(import_module(name), "CHAPTER", None), "entries", ())
    if not entry.full
}


@pytest.mark.parametrize("entry", ENTRIES.values(), ids=ENTRIES.keys())
def test_the_work_of_a_statement_is_done(entry: Entry) -> None:
    found = entry.statement()
    assert found.place and found.text and found.method and found.evidence
    assert found.to_json()["status"] in ("proved", "refuted", "open")


@pytest.mark.parametrize("name", modules())
def test_no_two_statements_of_a_module_have_one_name(name: str) -> None:
    chapter = getattr(import_module(name), "CHAPTER", Chapter())
    names = [entry.name for entry in chapter.entries]
    assert len(set(names)) == len(names)


@pytest.mark.parametrize("holds", [False, 1, None])
def test_a_step_that_is_not_plainly_true_is_not_shown(holds: object) -> None:
    with pytest.raises(NotShown):
        demand(holds, "a step")


def test_a_chapter_raises_where_the_work_fails() -> None:
    chapter = Chapter()

    @chapter.proved("nowhere", "1 = 2", "none")
    def wrong() -> str:
        demand(1 + 1 == 1, "1 = 2")
        return "never"

    with pytest.raises(NotShown):
        list(chapter.statements())
