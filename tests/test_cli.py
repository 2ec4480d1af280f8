"""The command line: results, exit codes, errors."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bern_exact import api
from bern_exact.__main__ import main
from bern_exact.checkers.findings import Finding, LemmaViolation
from bern_exact.theorems.stages import Observer

TRIANGLE: dict[str, Any] = {"outer": [["0", "0"], ["4", "0"], ["1", "3"]]}
FRAME: dict[str, Any] = {
    "format": "bern-exact/polygon",
    "version": 1,
    "name": "frame",
    "outer": [["0", "0"], ["9", "0"], ["9", "9"], ["0", "9"]],
    "holes": [[["3", "3"], ["6", "3"], ["6", "6"], ["3", "6"]]],
}


@pytest.fixture
def triangle(tmp_path: Path) -> str:
    return written(tmp_path / "triangle.json", TRIANGLE)


@pytest.fixture
def frame(tmp_path: Path) -> str:
    return written(tmp_path / "frame.json", FRAME)


def written(path: Path, document: object) -> str:
    path.write_text(json.dumps(document))
    return str(path)


def run_json(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, dict[str, Any]]:
    """Exit code and the one JSON object on stdout."""
    capsys.readouterr()
    code = main([*arguments, "--json"])
    record = json.loads(capsys.readouterr().out)
    assert isinstance(record, dict)
    return code, record


# ---------------------------------------------------------------- triangulate


def test_the_mesh_goes_to_stdout(frame: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["triangulate", frame, "--theorem", "1"]) == 0
    captured = capsys.readouterr()
    assert json.loads(captured.out)["format"] == "bern-exact/mesh"
    assert "theorem-1" in captured.err


def test_json_without_a_file_is_the_mesh_itself(
    frame: str, capsys: pytest.CaptureFixture[str]
) -> None:
    code, record = run_json(capsys, "triangulate", frame, "--theorem", "1")
    assert (code, record["format"]) == (0, "bern-exact/mesh")


def test_json_with_a_file_is_a_summary(
    frame: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = str(tmp_path / "m.json")
    code, record = run_json(capsys, "triangulate", frame, "--theorem", "1", "-o", target)
    assert (code, record["output"]) == (0, target)
    assert record["certificate"] == json.loads(Path(target).read_text())["certificate"]


def test_a_summary_for_people(
    triangle: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["triangulate", triangle, "--theorem", "1", "-o", str(tmp_path / "m.json")]) == 0
    assert "guarantees checked and kept" in capsys.readouterr().out


def test_every_claim_is_a_whole_line_where_there_is_no_terminal(
    triangle: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = tmp_path / "m.json"
    assert main(["triangulate", triangle, "--theorem", "1", "-o", str(target)]) == 0
    lines = capsys.readouterr().err.splitlines()
    for claim in json.loads(target.read_text())["certificate"]["claims"]:
        assert any(claim["id"] in line and claim["statement"] in line for line in lines)


def test_the_input_comes_first_in_the_mesh(frame: str, capsys: pytest.CaptureFixture[str]) -> None:
    _, record = run_json(capsys, "triangulate", frame, "--theorem", "1")
    assert record["vertices"][:8] == FRAME["outer"] + FRAME["holes"][0]


def test_checks_can_be_left_out(triangle: str, capsys: pytest.CaptureFixture[str]) -> None:
    _, record = run_json(capsys, "triangulate", triangle, "--theorem", "1", "--check", "none")
    assert record["certificate"]["claims"] == []


def test_the_trace_has_every_stage(triangle: str, tmp_path: Path) -> None:
    trace = tmp_path / "trace"
    target = str(tmp_path / "m.json")
    words = ["triangulate", triangle, "--theorem", "1", "-o", target, "--trace", str(trace)]
    assert main(words) == 0
    names = sorted(p.name for p in trace.iterdir())
    for stage in ("lopped", "framed", "diced", "traced", "warped", "boundary", "swept", "mesh"):
        (record,) = [name for name in names if name.endswith(f"-{stage}.json")]
        json.loads((trace / record).read_text())
    assert any(name.endswith("-diced.svg") for name in names)


def test_the_picture(triangle: str, tmp_path: Path) -> None:
    svg = tmp_path / "p.svg"
    target = str(tmp_path / "m.json")
    assert main(["triangulate", triangle, "--theorem", "1", "-o", target, "--svg", str(svg)]) == 0
    assert svg.read_text().startswith("<svg")


@pytest.mark.parametrize("suffix", [".poly", ".wkt", ".GEOJSON"])
def test_a_mesh_is_not_written_as_a_polygon(suffix: str, triangle: str, tmp_path: Path) -> None:
    target = tmp_path / f"mesh{suffix}"
    assert main(["triangulate", triangle, "--theorem", "1", "-o", str(target)]) == 2
    assert not target.exists()


def test_theorem_4_is_for_convex_polygons(triangle: str) -> None:
    assert main(["triangulate", triangle, "--theorem", "4"]) == 0


def test_without_a_theorem_it_is_2_and_with_holes_3(
    frame: str, triangle: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["triangulate", triangle]) == 0
    assert json.loads(capsys.readouterr().out)["certificate"]["theorem"] == 2
    assert main(["triangulate", frame]) == 0
    assert json.loads(capsys.readouterr().out)["certificate"]["theorem"] == 3


def broken_theorem(*_: object, observer: Observer, **__: object) -> api.Construction:
    """A construction that fails a guarantee after its first stage."""
    observer.stage("lopped", {})
    raise LemmaViolation(
        Finding("lemma-1.a", "lopped", "s' >= s/3", "guarantee", "1", "1/2", 1, False, ["1/2"])
    )


def test_a_violation_is_4_and_its_witness_is_saved(
    triangle: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(api, "THEOREMS", {1: broken_theorem})
    trace = tmp_path / "trace"
    code, record = run_json(
        capsys, "triangulate", triangle, "--theorem", "1", "--trace", str(trace)
    )
    assert (code, record["error"]["kind"]) == (4, "lemma-violation")
    for said in ("lemma-1.a", "s' >= s/3", "1/2", "bound 1"):
        assert said in record["error"]["message"]
    assert json.loads((trace / "violation.json").read_text())["witness"] == ["1/2"]


# ---------------------------------------------------------------- verify


@pytest.fixture
def mesh(frame: str, tmp_path: Path) -> str:
    target = str(tmp_path / "frame.mesh.json")
    assert main(["triangulate", frame, "--theorem", "1", "-o", target]) == 0
    return target


def test_a_mesh_of_ours_is_verified(
    mesh: str, frame: str, capsys: pytest.CaptureFixture[str]
) -> None:
    code, record = run_json(capsys, "verify", mesh, "--polygon", frame)
    assert (code, record["valid"], record["defects"]) == (0, True, [])


def test_the_verdict_has_the_feature_size_of_the_polygon_in_the_mesh(
    mesh: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run_json(capsys, "verify", mesh)[1]["feature_size_squared"] == "9"
    assert main(["verify", mesh]) == 0
    assert "feature size 3" in capsys.readouterr().out


def test_a_mesh_without_a_polygon_has_no_feature_size(
    mesh: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    document = json.loads(Path(mesh).read_text())
    bare = written(tmp_path / "bare.json", {k: document[k] for k in ("vertices", "triangles")})
    code, record = run_json(capsys, "verify", bare)
    assert (code, record["feature_size_squared"]) == (0, None)


@pytest.mark.parametrize(
    ("option", "value", "kind"),
    [
        ("--max-angle", "60", "angle-above-bound"),
        ("--max-angle", "cos:1:1/4", "angle-above-bound"),
        ("--min-height-squared", "81", "height-below-bound"),
        ("--max-triangles", "3", "too-many-triangles"),
    ],
)
def test_a_bound_not_kept_is_1(
    option: str, value: str, kind: str, mesh: str, capsys: pytest.CaptureFixture[str]
) -> None:
    code, record = run_json(capsys, "verify", mesh, option, value)
    assert (code, record["valid"]) == (1, False)
    assert kind in {defect["kind"] for defect in record["defects"]}


def test_a_damaged_mesh_is_1_in_words_too(
    mesh: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    document = json.loads(Path(mesh).read_text())
    del document["triangles"][0]
    assert main(["verify", written(tmp_path / "bad.json", document)]) == 1
    assert "not valid" in capsys.readouterr().out


def test_a_triangle_out_of_range_is_a_finding(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    document = {
        "format": "bern-exact/mesh",
        "version": 1,
        "vertices": [["0", "0"], ["1", "0"], ["0", "1"]],
        "triangles": [[0, 1, 7]],
    }
    path = written(tmp_path / "m.json", document)
    code, record = run_json(capsys, "verify", path, "--svg", str(tmp_path / "m.svg"))
    assert code == 1
    assert record["defects"][0]["kind"] == "index-out-of-range"


@pytest.mark.parametrize("bound", ["abc", "cos:2:1/4", "-1", "nan"])
def test_an_angle_that_is_none_is_wrong_usage(bound: str, mesh: str) -> None:
    assert main(["verify", mesh, "--max-angle", bound]) == 2


@pytest.mark.parametrize("option", ["-o", "--svg"])
def test_a_missing_directory_is_told_before_the_work(
    option: str, frame: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    trace, target = tmp_path / "trace", tmp_path / "no" / "x.mesh.json"
    assert main(["triangulate", frame, option, str(target), "--trace", str(trace)]) == 2
    assert f"Directory '{target.parent}' does not exist" in capsys.readouterr().err
    assert not trace.exists()


# ---------------------------------------------------------------- facts


def test_facts_of_a_square_frame(frame: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, record = run_json(capsys, "facts", frame)
    assert code == 0
    assert record == {
        "n": 8,
        "holes": 1,
        "area": "72",
        "feature_size_squared": "9",
        "feature_size_at": {"edge": [1, 3]},
        "diameter_squared": "162",
        "acute_vertices": [],
        "convex": False,
        "max_height_squared": "9",
    }


def test_facts_for_people(triangle: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["facts", triangle]) == 0
    assert "feature size" in capsys.readouterr().out


def test_facts_into_a_file(triangle: str, tmp_path: Path) -> None:
    target = tmp_path / "facts.json"
    assert main(["facts", triangle, "-o", str(target)]) == 0
    assert json.loads(target.read_text())["n"] == 3


def test_decimals_can_be_read_as_doubles(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = written(tmp_path / "p.json", {"outer": [["0", "0"], ["0.1", "0"], ["0", "1"]]})
    assert run_json(capsys, "facts", path)[1]["area"] == "1/20"
    doubles = run_json(capsys, "facts", path, "--numbers", "binary64")[1]
    assert doubles["area"] == "3602879701896397/72057594037927936"


# ---------------------------------------------------------------- errors


BAD_FILES: dict[str, tuple[bytes, str]] = {
    "empty": (b"", "syntax"),
    "binary": (bytes(range(256)), "syntax"),
    "deep": (b"[" * 100_000, "syntax"),
    "deep objects": (b'{"outer":' * 50_000, "syntax"),
    "a list": (b"[]", "schema"),
    "null": (b"null", "schema"),
    "no outer": (b"{}", "schema"),
    "wrong types": (b'{"outer": 3}', "schema"),
    "NaN": (b'{"outer": [[NaN, 0], [1, 0], [0, 1]]}', "number"),
    "a boolean": (b'{"outer": [[true, 0], [1, 0], [0, 1]]}', "number"),
    "a huge exponent": (b'{"outer": [[1e999999999, 0], [1, 0], [0, 1]]}', "number"),
    "a zero denominator": (b'{"outer": [["1/0", "0"], ["1", "0"], ["0", "1"]]}', "number"),
    "another format": (b'{"format": "png", "outer": []}', "unsupported"),
    "two vertices": (b'{"outer": [[0, 0], [1, 0]]}', "too-few-vertices"),
    "a bow": (b'{"outer": [[0, 0], [2, 2], [2, 0], [0, 2]]}', "edges-cross"),
}


@pytest.mark.parametrize("command", ["facts", "triangulate", "verify"])
@pytest.mark.parametrize("name", BAD_FILES)
def test_a_bad_file_is_3(
    name: str, command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    content, kind = BAD_FILES[name]
    path = tmp_path / "bad.json"
    path.write_bytes(content)
    code, record = run_json(capsys, command, str(path))
    assert code == 3
    assert set(record["error"]) == {"kind", "message", "where"}
    if command != "verify":
        assert record["error"]["kind"] == kind


atoms = st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=9)
numbers = st.integers(-3, 3) | st.sampled_from(["1/2", "-0.5", "1/0", "x", "1e3"])
rings = st.lists(st.lists(numbers, min_size=2, max_size=2), max_size=6)
junk = st.recursive(atoms, lambda j: st.lists(j) | st.dictionaries(st.text(), j), max_leaves=9)
near_polygons = st.fixed_dictionaries(
    {"outer": rings | junk}, optional={"holes": st.lists(rings | junk), "name": junk}
)
triples = st.lists(st.integers(-1, 6), min_size=3, max_size=3)
near_meshes = st.fixed_dictionaries(
    {
        "format": st.just("bern-exact/mesh"),
        "version": st.just(1) | junk,
        "vertices": rings | junk,
        "triangles": st.lists(triples | junk) | st.lists(triples) | junk,
    },
    optional={"polygon": near_polygons | junk},
)


@given(junk | near_polygons)
def test_no_polygon_file_gives_a_traceback(document: object) -> None:
    with TemporaryDirectory() as folder:
        path = written(Path(folder) / "p.json", document)
        assert main(["facts", path]) in (0, 3)


@given(junk | near_meshes)
def test_no_mesh_file_gives_a_traceback(document: object) -> None:
    with TemporaryDirectory() as folder:
        path = written(Path(folder) / "m.json", document)
        picture = str(Path(folder) / "m.svg")
        assert main(["verify", path, "--svg", picture]) in (0, 1, 3)


@pytest.mark.parametrize(
    "words",
    [
        ["facts"],
        ["facts", "no-such-file.json"],
        ["facts", "."],
        ["no-such-command"],
        ["facts", "--no-such-option"],
        ["verify", "no-such-file.json", "--json"],
    ],
)
def test_wrong_usage_is_2(words: list[str]) -> None:
    assert main(words) == 2


def test_a_directory_that_is_not_there_is_wrong_usage(triangle: str, tmp_path: Path) -> None:
    assert main(["facts", triangle, "-o", str(tmp_path / "no" / "f.json")]) == 2


def test_help_is_0(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--help"]) == 0
    assert "triangulate" in capsys.readouterr().out


# ---------------------------------------------------------------- as a process


def process(*words: str, **environment: str) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run(
        [sys.executable, "-m", "bern_exact", *words],
        capture_output=True,
        check=False,
        env={**os.environ, **environment},
    )


def test_the_bytes_do_not_depend_on_the_hash_seed(frame: str) -> None:
    first, second = (
        process("triangulate", frame, "--theorem", "1", PYTHONHASHSEED=seed) for seed in "12"
    )
    assert first.returncode == 0
    assert first.stdout == second.stdout


def test_a_reader_that_goes_away_is_no_error(frame: str) -> None:
    words = [sys.executable, "-m", "bern_exact", "triangulate", frame, "--theorem", "1"]
    writer = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if writer.stdout is not None:
        writer.stdout.close()
    _, errors = writer.communicate()
    assert writer.returncode == 0
    assert b"Traceback" not in errors
    assert b"Exception ignored" not in errors


def test_names_print_under_any_locale(tmp_path: Path) -> None:
    path = written(tmp_path / "p.json", {**TRIANGLE, "name": "Żółw"})
    done = process("triangulate", path, "--theorem", "1", PYTHONIOENCODING="ascii", LC_ALL="C")
    assert done.returncode == 0, done.stderr
