"""The command line of Theorem 4."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from bern_exact.__main__ import main
from tests.test_cli import FRAME, TRIANGLE, run_json, written

HULL = {"outer": [["0", "0"], ["4", "-1"], ["9", "0"], ["11", "3"], ["7", "6"], ["2", "5"]]}
DENTED = {"outer": [["0", "0"], ["4", "0"], ["4", "4"], ["3", "1"], ["0", "4"]]}


@pytest.fixture
def hull(tmp_path: Path) -> str:
    return written(tmp_path / "hull.json", HULL)


@pytest.mark.parametrize("words", [[], ["--baseline"], ["--thin"], ["--check", "final"]])
def test_no_angle_above_90_degrees(
    words: list[str], hull: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target, svg = str(tmp_path / "m.json"), str(tmp_path / "m.svg")
    options = ["--theorem", "4", "-o", target, "--svg", svg, *words]
    assert main(["triangulate", hull, *options]) == 0
    capsys.readouterr()
    code, verdict = run_json(capsys, "verify", target, "--polygon", hull, "--max-angle", "90")
    assert (code, verdict["valid"]) == (0, True)
    assert verdict["angle_classes"]["le120"] == 0


def test_the_claims_of_every_stage(hull: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, record = run_json(capsys, "triangulate", hull, "--theorem", "4", "--as-printed")
    places = {claim["id"].partition(".")[0] for claim in record["certificate"]["claims"]}
    assert code == 0
    assert {"diameter", "bounce", "grid", "lemma-9", "theorem-4"} <= places
    assert {"lemma-6", "lemma-10", "lemma-11", "lemma-12"} <= places


def test_the_trace_has_a_picture_of_each_stage(hull: str, tmp_path: Path) -> None:
    trace = tmp_path / "trace"
    words = ["--theorem", "4", "-o", str(tmp_path / "m.json"), "--trace", str(trace)]
    assert main(["triangulate", hull, *words]) == 0
    for stage in ("framed", "bounced", "gridded", "merged", "reduced", "mesh"):
        (record,) = trace.glob(f"*-{stage}.json")
        json.loads(record.read_text())
        assert record.with_suffix(".svg").read_text().startswith("<svg")


def test_a_reflex_vertex_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = written(tmp_path / "dented.json", DENTED)
    code, record = run_json(capsys, "triangulate", path, "--theorem", "4")
    assert (code, record["error"]["kind"]) == (3, "not-convex")
    assert record["error"]["where"] == {"vertex": [0, 3]}


def test_holes_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = written(tmp_path / "frame.json", FRAME)
    code, record = run_json(capsys, "triangulate", path, "--theorem", "4")
    assert (code, record["error"]["kind"]) == (3, "has-holes")


def test_a_triangle_with_the_diameter_as_an_edge(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = written(tmp_path / "triangle.json", TRIANGLE)
    code, record = run_json(capsys, "triangulate", path, "--theorem", "4")
    assert (code, len(record["triangles"])) == (0, 2)
