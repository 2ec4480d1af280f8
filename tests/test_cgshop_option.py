"""CG:SHOP files on the command line: read by what they hold, written by suffix or `--to`."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from bern_exact.__main__ import main
from bern_exact.formats import read_polygon_file
from bern_exact.plane.polygon import Polygon
from tests.formats.test_cgshop import HOOK, points_of

THIRDS = {"name": "thirds", "outer": [["0", "0"], ["7/3", "0"], ["1/2", "1/4"]]}
FAST = ("--thin", "--check", "none")


@pytest.fixture
def hook(tmp_path: Path) -> Path:
    path = tmp_path / "hook.instance.json"
    path.write_text(json.dumps(HOOK))
    return path


@pytest.fixture
def thirds(tmp_path: Path) -> Path:
    path = tmp_path / "thirds.json"
    path.write_text(json.dumps(THIRDS))
    return path


def run(*arguments: str | Path) -> int:
    return main([*map(str, arguments)])


@pytest.mark.parametrize("more", [(), ("--to", "cgshop"), ("--from", "cgshop")])
def test_an_instance_is_solved(hook: Path, tmp_path: Path, more: tuple[str, ...]) -> None:
    before = hook.read_bytes()
    target = tmp_path / "hook.solution.json"
    assert run("triangulate", hook, *FAST, *more, "-o", target) == 0
    solution = json.loads(target.read_text())
    assert (solution["content_type"], solution["instance_uid"]) == (
        "CG_SHOP_2025_Solution",
        "hook",
    )
    assert len(points_of(solution, HOOK)) >= 6
    assert hook.read_bytes() == before
    assert sorted(p.name for p in tmp_path.iterdir()) == ["hook.instance.json", target.name]


def test_a_polygon_gets_its_instance_beside_the_solution(
    thirds: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = tmp_path / "x.solution.json"
    assert run("triangulate", thirds, *FAST, "-o", target) == 0
    told = capsys.readouterr().err
    assert f"coordinates times 12: {tmp_path / 'x.instance.json'}" in told
    instance = json.loads((tmp_path / "x.instance.json").read_text())
    assert instance["points_x"] == [0, 28, 6]
    assert instance["instance_uid"] == json.loads(target.read_text())["instance_uid"] == "thirds"
    assert run("triangulate", tmp_path / "x.instance.json", *FAST, "-o", tmp_path / "m.json") == 0


def test_the_file_names_a_polygon_without_a_name(tmp_path: Path) -> None:
    source = tmp_path / "a.json"
    source.write_text(json.dumps({"outer": THIRDS["outer"]}))
    assert run("triangulate", source, *FAST, "--to", "cgshop", "-o", tmp_path / "b.json") == 0
    assert json.loads((tmp_path / "b.json").read_text())["instance_uid"] == "b"
    assert json.loads((tmp_path / "b.instance.json").read_text())["instance_uid"] == "b"


def test_to_json_is_a_mesh_whatever_the_suffix(hook: Path, tmp_path: Path) -> None:
    target = tmp_path / "hook.solution.json"
    assert run("triangulate", hook, *FAST, "--to", "json", "-o", target) == 0
    assert json.loads(target.read_text())["format"] == "bern-exact/mesh"
    assert run("verify", target, "--polygon", hook) == 0


def test_without_a_file_there_is_no_solution(
    hook: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run("triangulate", hook, *FAST, "--to", "cgshop") == 2
    assert "--to cgshop needs -o" in capsys.readouterr().err


def test_no_input_is_written_over(thirds: Path, tmp_path: Path) -> None:
    source = thirds.rename(tmp_path / "thirds.instance.json")
    before = source.read_bytes()
    assert run("triangulate", source, *FAST, "-o", tmp_path / "thirds.solution.json") == 2
    assert source.read_bytes() == before


def test_holes_are_refused_before_the_work(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source = tmp_path / "frame.json"
    rings = {"outer": [[0, 0], [9, 0], [0, 9]], "holes": [[[1, 1], [2, 1], [1, 2]]]}
    source.write_text(json.dumps(rings))
    assert run("triangulate", source, "-o", tmp_path / "frame.solution.json", "--json") == 3
    assert json.loads(capsys.readouterr().out)["error"]["kind"] == "has-holes"
    assert list(tmp_path.iterdir()) == [source]


def test_long_coordinates_are_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source = tmp_path / "long.json"
    source.write_text(json.dumps({"outer": [["0", "0"], ["1", "0"], ["0", f"1/{2**70}"]]}))
    assert run("triangulate", source, *FAST, "-o", tmp_path / "long.solution.json") == 0
    assert "up to 71 bits" in capsys.readouterr().err


def test_constraints_are_refused_by_name(hook: Path, capsys: pytest.CaptureFixture[str]) -> None:
    constrained = {**HOOK, "num_constraints": 1, "additional_constraints": [[0, 1]]}
    hook.write_text(json.dumps(constrained))
    assert run("facts", hook, "--json") == 3
    error = json.loads(capsys.readouterr().out)["error"]
    assert (error["kind"], error["where"]) == ("unsupported", {"path": "$.additional_constraints"})


def test_the_format_may_be_named(hook: Path, thirds: Path) -> None:
    assert run("facts", hook, "--from", "cgshop") == 0
    assert run("facts", thirds, "--from", "cgshop") == 3
    assert run("facts", hook, "--from", "json") == 3
    assert Polygon.load(hook) == Polygon.load(hook, format="cgshop") == read_polygon_file(hook)
    with pytest.raises(ValueError, match="no polygon format 'dxf'"):
        read_polygon_file(hook, format="dxf")


def test_the_same_bytes_every_time(hook: Path, tmp_path: Path) -> None:
    targets = [tmp_path / f"{k}.solution.json" for k in "ab"]
    for target in targets:
        assert run("triangulate", hook, *FAST, "-o", target) == 0
    assert targets[0].read_bytes() == targets[1].read_bytes()
