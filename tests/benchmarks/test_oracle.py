"""The benchmark of the oracle measures what it says, and the judges in it agree."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from benchmarks import oracle


def measured(seconds: float, **others: Any) -> dict[str, Any]:
    return {"read": 0.5, "judged": seconds, "mib": 100, "evaluated": 3, **others}


@pytest.mark.parametrize("name", oracle.FAMILIES)
def test_every_family_is_a_valid_mesh_and_judged_alike(name: str, tmp_path: Path) -> None:
    as_json, as_text, count = oracle.write_files(name, 200, tmp_path)
    assert count == 200
    filtered, plain = (
        oracle.judged(str(as_json), "doubles" in name, is_plain) for is_plain in (False, True)
    )
    assert filtered["valid"] and plain["valid"]
    assert [filtered[key] for key in ("worst", "flattest")] == [plain["worst"], plain["flattest"]]
    document = json.loads(as_json.read_text())
    head, *rows = as_text.read_text().splitlines()
    assert head == f"{len(document['vertices'])} 200"
    assert [row.split() for row in rows[: len(document["vertices"])]] == document["vertices"]


def test_the_table_has_a_gap_for_what_did_not_run() -> None:
    rows = [
        {"name": "a", "triangles": 1000, "filtered": measured(2), "plain": measured(9)},
        {"name": "a", "triangles": 2000, "filtered": measured(4), "cgal": measured(8)},
    ]
    table = list(oracle.lines(rows))
    assert table[1].split("|")[2:-1] == [
        *(" 1,000 ", " 0.50 ", " 2.00 ", " 100 ", " 3 ", " 9.00 ", " 4.5 "),
        *(" - ",) * 4,
    ]
    assert table[2].split("|")[-6:-1] == [" - ", " 0.50 ", " 8.00 ", " 100 ", " 0.5 "]


def test_exponents_are_over_all_sizes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(oracle, "FAMILIES", {"a": None})
    rows = [
        {"name": "a", "triangles": n, "filtered": measured(n / 100), "cgal": measured(n * n)}
        for n in (100, 200, 400)
    ]
    assert list(oracle.slopes(rows))[-1] == "| a | 0.00 | 1.00 | 2.00 |"


def test_without_a_compiler_cgal_is_skipped_with_a_message(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(shutil, "which", lambda name: None)
    assert oracle.compiled(tmp_path) is None
    assert "skipped" in capsys.readouterr().err


def test_what_does_not_compile_is_skipped_with_a_message(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    compiler = tmp_path / "g++"
    compiler.write_text("#!/bin/sh\necho 'fatal: CGAL is missing' >&2\nexit 1\n")
    compiler.chmod(0o755)
    monkeypatch.setattr(shutil, "which", lambda name: str(compiler))
    assert oracle.compiled(tmp_path) is None
    assert "CGAL is missing" in capsys.readouterr().err
