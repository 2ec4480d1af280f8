"""The command line of Theorems 2 and 3: their options, exit codes and errors."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from bern_exact.__main__ import main
from bern_exact.theorems import baseline
from tests.test_cli import FRAME, TRIANGLE, run_json, written

BOUNDS = ["150", "149.5", "140", "136", "135.2", "cos:-1:25/34"]


@pytest.fixture
def triangle(tmp_path: Path) -> str:
    return written(tmp_path / "triangle.json", TRIANGLE)


@pytest.fixture
def frame(tmp_path: Path) -> str:
    return written(tmp_path / "frame.json", FRAME)


def mesh_of(capsys: pytest.CaptureFixture[str], path: str, *words: str) -> dict[str, Any]:
    """The mesh document on stdout."""
    code, record = run_json(capsys, "triangulate", path, "--check", "final", *words)
    assert (code, record["format"]) == (0, "bern-exact/mesh")
    return record


@pytest.mark.parametrize(("shape", "theorem"), [("triangle", 2), ("frame", 3)])
def test_which_theorem_without_being_told(
    shape: str,
    theorem: int,
    request: pytest.FixtureRequest,
    capsys: pytest.CaptureFixture[str],
) -> None:
    record = mesh_of(capsys, request.getfixturevalue(shape))
    assert record["certificate"]["theorem"] == theorem


def test_holes_are_3_for_theorem_2(frame: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, record = run_json(capsys, "triangulate", frame, "--theorem", "2")
    assert (code, record["error"]["kind"]) == (3, "has-holes")
    assert record["error"]["where"] == {"ring": 1}
    assert "Theorem 3 is meant" in record["error"]["message"]


@pytest.mark.parametrize("bound", BOUNDS)
def test_every_bound_is_kept(
    bound: str, frame: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = tmp_path / "m.json"
    assert main(["triangulate", frame, "--max-angle", bound, "-o", str(target)]) == 0
    capsys.readouterr()
    code, verdict = run_json(capsys, "verify", str(target), "--max-angle", bound)
    assert (code, verdict["valid"]) == (0, True)


@pytest.mark.parametrize("bound", ["135", "135.05", "90", "150.1", "nonsense", "cos:-1:1/2"])
def test_bounds_out_of_reach_are_wrong_usage(
    bound: str, triangle: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["triangulate", triangle, "--max-angle", bound]) == 2
    captured = capsys.readouterr()
    assert not captured.out and "Traceback" not in captured.err


def test_the_refusal_of_135_gives_the_reason(
    triangle: str, capsys: pytest.CaptureFixture[str]
) -> None:
    code, record = run_json(capsys, "triangulate", triangle, "--max-angle", "135")
    assert code == 2
    assert "blocks alone need 135" in record["error"]["message"]


@pytest.mark.parametrize("interior", ["strips", "bridges", "best"])
def test_interiors(interior: str, frame: str, capsys: pytest.CaptureFixture[str]) -> None:
    record = mesh_of(capsys, frame, "--interior", interior)
    assert record["certificate"]["theorem"] == 3


@pytest.mark.parametrize("objective", ["fewest", "height", "angle"])
def test_objectives(objective: str, triangle: str, capsys: pytest.CaptureFixture[str]) -> None:
    mesh_of(capsys, triangle, "--objective", objective)


def test_squares(triangle: str, capsys: pytest.CaptureFixture[str]) -> None:
    strips, squares = (mesh_of(capsys, triangle, *words) for words in ([], ["--squares"]))
    assert len(strips["triangles"]) <= len(squares["triangles"])


@pytest.mark.parametrize("theorem", ["1", "2", "3"])
def test_baselines_are_larger(
    theorem: str, triangle: str, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["--theorem", theorem]
    better, simpler = (mesh_of(capsys, triangle, *words, *flag) for flag in ([], ["--baseline"]))
    assert len(better["triangles"]) <= len(simpler["triangles"])


def test_a_baseline_too_large_is_wrong_usage(
    frame: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(baseline, "MOST_TRIANGLES", 10)
    assert main(["triangulate", frame, "--baseline"]) == 2
    assert "10" in capsys.readouterr().err


@pytest.mark.parametrize(
    "words",
    [
        ["--theorem", "1", "--max-angle", "140"],
        ["--theorem", "1", "--objective", "angle"],
        ["--theorem", "2", "--interior", "best"],
        ["--theorem", "3", "--squares"],
        ["--theorem", "3", "--interior", "cellar"],
        ["--objective", "beauty"],
        ["--baseline", "--squares"],
        ["--theorem", "4", "--max-angle", "140"],
    ],
)
def test_options_that_do_not_go_together(
    words: list[str], triangle: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["triangulate", triangle, *words]) == 2
    captured = capsys.readouterr()
    assert captured.err and not captured.out


def test_the_trace_has_the_stages_of_theorem_3(frame: str, tmp_path: Path) -> None:
    trace, target = tmp_path / "trace", str(tmp_path / "m.json")
    assert main(["triangulate", frame, "-o", target, "--trace", str(trace)]) == 0
    names = sorted(path.name for path in trace.iterdir())
    for stage in ("merged", "interior", "partition", "tiled", "mesh"):
        (record,) = [name for name in names if name.endswith(f"-{stage}.json")]
        json.loads((trace / record).read_text())


def test_the_papers_false_sentences_are_reported(
    triangle: str, capsys: pytest.CaptureFixture[str]
) -> None:
    code, record = run_json(capsys, "triangulate", triangle, "--as-printed")
    roles = {claim["id"]: claim["role"] for claim in record["certificate"]["claims"]}
    assert code == 0
    assert roles["lemma-5.printed-end-height"] == "as-printed"
    assert roles["lemma-5.height"] == "guarantee"


@pytest.mark.parametrize("theorem", ["1", "3"])
def test_corner_blocks(theorem: str, frame: str, capsys: pytest.CaptureFixture[str]) -> None:
    record = mesh_of(capsys, frame, "--theorem", theorem, "--blocks", "corner")["certificate"]
    assert (record["blocks"], record["factor"]) == ("corner", "9/2")
    plain = mesh_of(capsys, frame, "--theorem", theorem, "--factor", "8")["certificate"]
    assert (plain["blocks"], plain["factor"]) == ("square", "8")
    assert record["triangles"] < plain["triangles"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--factor", "5.65"), "square blocks need more than sqrt(32)"),
        (("--blocks", "corner", "--factor", "4"), "corner blocks need more than sqrt(18)"),
        (("--factor", "100"), "at most 64"),
        (("--theorem", "4", "--blocks", "corner"), "blocks is not an option of Theorem 4"),
        (("--factor", "x"), "Invalid value for '--factor'"),
        (("--blocks", "round"), "Invalid value for '--blocks'"),
    ],
)
def test_grids_that_are_refused(
    words: tuple[str, ...], said: str, triangle: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["triangulate", triangle, *words]) == 2
    assert said in " ".join(capsys.readouterr().err.split())


def test_the_help_says_what_is_experimental(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["triangulate", "--help"]) == 0
    text = " ".join(capsys.readouterr().out.split())
    for option in ("--blocks", "--factor"):
        assert "experimental" in text.partition(option)[2].partition(" --")[0]
