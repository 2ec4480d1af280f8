"""`convert`, and the formats that `triangulate` and `facts` read and write."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from bern_exact.__main__ import main
from bern_exact.formats import MESH_WRITERS, read_mesh_file, read_polygon_file
from tests.test_cgshop_option import THIRDS

MESH = {
    "vertices": [["0", "0"], ["7/3", "0"], ["1/2", "1/4"]],
    "triangles": [[0, 1, 2]],
    "polygon": THIRDS,
}
FAST = ("--thin", "--check", "none")


def run(*arguments: str | Path) -> int:
    return main([*map(str, arguments)])


@pytest.fixture
def mesh(tmp_path: Path) -> Path:
    path = tmp_path / "mesh.json"
    path.write_text(json.dumps(MESH))
    return path


@pytest.fixture
def polygon(tmp_path: Path) -> Path:
    path = tmp_path / "thirds.json"
    path.write_text(json.dumps(THIRDS))
    return path


@pytest.mark.parametrize("name", [n for n in MESH_WRITERS if n != "json"])
def test_a_mesh_in_every_format_and_back(
    mesh: Path, tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run("convert", mesh, "-o", tmp_path / f"a.{name}") == 0
    assert f"{name} holds doubles: 1 of 6 coordinates were rounded" in capsys.readouterr().err
    back = tmp_path / "back.json"
    assert run("convert", tmp_path / f"a.{name}", "-o", back, "--numbers", "binary64") == 0
    found, _ = read_mesh_file(back)
    assert [str(c) for c in found.coordinates[1]] == ["5254199565265579/2251799813685248", "0"]
    assert run("verify", tmp_path / f"a.{name}", "--json") == 0


def test_json_keeps_everything_exact_and_the_polygon(mesh: Path, tmp_path: Path) -> None:
    assert run("convert", mesh, "-o", tmp_path / "b.json") == 0
    assert read_mesh_file(tmp_path / "b.json") == read_mesh_file(mesh)


@pytest.mark.parametrize("name", ["a.poly", "a.wkt", "a.geojson", "a.json", "a.instance.json"])
def test_a_polygon_in_every_format(
    polygon: Path, tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run("convert", polygon, "-o", tmp_path / name) == 0
    told = capsys.readouterr().err
    exact = {"a.json": "", "a.instance.json": "coordinates times 12"}
    assert exact.get(name, "1 of 6 coordinates were rounded") in told
    found = read_polygon_file(tmp_path / name)
    assert found.n == 3
    if name == "a.json":
        assert found == read_polygon_file(polygon)


def test_two_files_by_either_suffix(mesh: Path, tmp_path: Path) -> None:
    for name in ("x.node", "y.1.ele"):
        assert run("convert", mesh, "-o", tmp_path / name) == 0
    assert run("convert", mesh, "-o", tmp_path / "z.2", "--to", "node") == 0
    names = {p.name for p in tmp_path.iterdir()} - {"mesh.json"}
    assert names == {"x.node", "x.ele", "y.1.node", "y.1.ele", "z.2.node", "z.2.ele"}


def test_to_and_from_whatever_the_suffixes(mesh: Path, tmp_path: Path) -> None:
    assert run("convert", mesh, "-o", tmp_path / "a.dat", "--to", "off") == 0
    assert (tmp_path / "a.dat").read_text().startswith("OFF\n")
    assert run("convert", tmp_path / "a.dat", "--from", "off", "-o", tmp_path / "a.obj") == 0
    assert run("convert", tmp_path / "a.dat", "-o", tmp_path / "b.obj") == 3


def test_without_a_file_it_goes_to_stdout(mesh: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run("convert", mesh, "--to", "obj") == 0
    assert capsys.readouterr().out.startswith("v 0 0 0\nv 2.33")


def test_a_picture(mesh: Path, tmp_path: Path) -> None:
    assert run("convert", mesh, "-o", tmp_path / "a.svg") == 0
    assert (tmp_path / "a.svg").read_text().startswith("<svg")
    bad = {**MESH, "triangles": [[0, 1, 3]]}
    mesh.write_text(json.dumps(bad))
    assert run("convert", mesh, "-o", tmp_path / "b.svg") == 3


def test_a_solution_and_back(mesh: Path, tmp_path: Path) -> None:
    assert run("convert", mesh, "-o", tmp_path / "a.solution.json") == 0
    assert run("convert", tmp_path / "a.solution.json", "-o", tmp_path / "b.json") == 0
    found, polygon = read_mesh_file(tmp_path / "b.json")
    assert (len(found.triangles), polygon and polygon.n) == (1, 3)
    assert run("convert", tmp_path / "a.instance.json", "-o", tmp_path / "c.poly") == 0


def test_a_solution_needs_a_polygon(mesh: Path, polygon: Path, tmp_path: Path) -> None:
    mesh.write_text(json.dumps({k: v for k, v in MESH.items() if k != "polygon"}))
    target = tmp_path / "a.solution.json"
    assert run("convert", mesh, "-o", target) == 2
    assert run("convert", mesh, "-o", target, "--polygon", polygon) == 0


@pytest.mark.parametrize(
    "arguments",
    [
        ("mesh.json",),
        ("mesh.json", "--to", "node"),
        ("mesh.json", "--to", "wkt"),
        ("mesh.json", "-o", "a.poly"),
        ("mesh.json", "-o", "mesh.json"),
        ("mesh.json", "--to", "off", "--json"),
        ("thirds.json", "-o", "a.off"),
        ("thirds.json", "--to", "svg"),
        ("a.ele", "-o", "a.node"),
        ("missing.off", "-o", "a.obj"),
    ],
)
def test_wrong_usage(
    mesh: Path,
    polygon: Path,
    tmp_path: Path,
    arguments: tuple[str, ...],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run("convert", "mesh.json", "-o", "a.ele") == 0
    before = {p.name: p.read_bytes() for p in tmp_path.iterdir()}
    assert run("convert", *arguments) == 2
    assert {p.name: p.read_bytes() for p in tmp_path.iterdir()} == before


@pytest.mark.parametrize("name", ["t.node", "t.off", "t.msh", "t.vtu"])
def test_triangulate_writes_it(
    polygon: Path, tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run("triangulate", polygon, *FAST, "-o", tmp_path / name) == 0
    assert "coordinates were rounded" in capsys.readouterr().err
    assert run("verify", tmp_path / name) == 0


@pytest.mark.parametrize("name", ["a.poly", "a.wkt", "a.geojson"])
def test_triangulate_reads_it(polygon: Path, tmp_path: Path, name: str) -> None:
    assert run("convert", polygon, "-o", tmp_path / name) == 0
    target = tmp_path / "t.json"
    assert run("triangulate", tmp_path / name, *FAST, "-o", target, "--numbers", "binary64") == 0
    assert run("verify", target, "--polygon", tmp_path / name, "--numbers", "binary64") == 0


def test_the_node_file_of_a_poly_is_not_written_over(polygon: Path, tmp_path: Path) -> None:
    assert run("convert", polygon, "-o", tmp_path / "a.poly") == 0
    (tmp_path / "a.node").write_text("3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n")
    assert run("triangulate", tmp_path / "a.poly", *FAST, "-o", tmp_path / "a.ele") == 2


def test_bad_files_are_3_with_line_and_no_traceback(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "a.off"
    path.write_bytes(b"OFF\n1 0 0\n0 \xff 0\n")
    assert run("convert", path, "-o", tmp_path / "b.obj", "--json") == 3
    error = json.loads(capsys.readouterr().out)["error"]
    assert (error["kind"], error["where"]) == ("number", {"line": 3})


def test_the_same_bytes_every_time(mesh: Path, tmp_path: Path) -> None:
    for name in MESH_WRITERS:
        for folder in ("a", "b"):
            (tmp_path / folder).mkdir(exist_ok=True)
            assert run("convert", mesh, "-o", tmp_path / folder / f"m.{name}") == 0
    for path in (tmp_path / "a").iterdir():
        assert path.read_bytes() == (tmp_path / "b" / path.name).read_bytes()
