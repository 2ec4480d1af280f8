"""`bern-exact corpus` and `bern-exact families`: results, exit codes, errors."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from bern_exact.__main__ import main
from bern_exact.corpus.families import FAMILIES
from tests.corpus import small
from tests.corpus.small import CHOICES, COUNT, SEED, contents


@pytest.fixture(scope="module")
def corpus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return small.made(tmp_path_factory.mktemp("corpus") / "small")


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str]:
    capsys.readouterr()
    return main(list(arguments)), capsys.readouterr().out


def run_json(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, dict[str, Any]]:
    code, out = run(capsys, *arguments, "--json")
    return code, json.loads(out)


def generate(out: Path) -> list[str]:
    words = ["corpus", "generate", "--out", str(out), "--seed", str(SEED), "--count", str(COUNT)]
    for choice in CHOICES:
        given = ",".join(f"{name}={value}" for name, value in choice.given.items())
        words += ["--family", f"{choice.family}:{given}" if given else choice.family]
    return words


def test_generate(corpus: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, record = run_json(capsys, *generate(tmp_path / "c"))
    assert code == 0 and record["count"] == COUNT
    assert contents(tmp_path / "c") == contents(corpus)


@pytest.mark.parametrize(
    "words, code",
    [
        (["--seed", "1", "--count", "1"], 2),
        (["--out", "{}/c", "--count", "1"], 2),
        (["--out", "{}/c", "--seed", "-1", "--count", "1"], 2),
        (["--out", "{}/c", "--seed", "1", "--count", "0"], 2),
        (["--out", "{}/c", "--seed", "1", "--count", "1", "--family", "no-such"], 2),
        (["--out", "{}/c", "--seed", "1", "--count", "1", "--workers", "0"], 2),
        (["--out", "{}", "--seed", "1", "--count", "1"], 3),
        (["--out", "/proc/c", "--seed", "1", "--count", "1"], 2),
    ],
)
def test_what_is_refused(words: list[str], code: int, tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_text("x")
    assert main(["corpus", "generate", *(word.format(tmp_path) for word in words)]) == code


def test_check(corpus: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(capsys, "corpus", "check", str(corpus)) == (0, "no differences\n")
    shutil.copytree(corpus, tmp_path / "copy")
    case = CHOICES[0].case(0)
    (tmp_path / "copy" / case / "polygon.wkt").unlink()
    code, record = run_json(capsys, "corpus", "check", str(tmp_path / "copy"))
    assert code == 1
    assert record["differences"] == [{"path": f"{case}/polygon.wkt", "what": "missing"}]
    assert main(["corpus", "check", str(tmp_path)]) in (2, 3)


def test_judge(corpus: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    case = CHOICES[0].case(0)
    defects = json.loads((corpus / case / "defects/defects.json").read_text())["defects"]
    accepted = {f"{case}/{defect['name']}": "valid" for defect in defects}
    (tmp_path / "verdicts.json").write_text(json.dumps(accepted))
    code, out = run(capsys, "corpus", "judge", str(corpus), str(tmp_path))
    assert code == 1 and "wrongly accepted" in out
    right = {f"{case}/{defect['name']}": defect["result"] for defect in defects}
    (tmp_path / "verdicts.json").write_text(json.dumps(right))
    code, record = run_json(capsys, "corpus", "judge", str(corpus), str(tmp_path))
    assert code == 0 and record["counts"]["passed"] == len(defects)
    assert main(["corpus", "judge", str(corpus), str(corpus)]) == 3


def test_families(capsys: pytest.CaptureFixture[str]) -> None:
    code, out = run(capsys, "families")
    assert code == 0
    assert all(name in out and family.breaks in out for name, family in FAMILIES.items())
    _, record = run_json(capsys, "families")
    assert [family["name"] for family in record["families"]] == list(FAMILIES)
