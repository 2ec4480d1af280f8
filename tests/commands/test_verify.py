"""`bern-exact verify`: tolerance, comparison, and what it says."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from gmpy2 import mpq

from bern_exact.__main__ import main

SQUARE = [["0", "0"], ["4", "0"], ["4", "4"], ["0", "4"]]
TRIANGLES = [[4, 0, 5], [4, 5, 1], [4, 1, 2], [4, 2, 3], [4, 3, 0]]


@pytest.fixture
def files(tmp_path: Path) -> tuple[str, str]:
    """A mesh whose vertex 5 is 1e-16 above its edge, and the polygon."""
    mesh = {"vertices": [*SQUARE, ["2", "2"], ["2", "1e-16"]], "triangles": TRIANGLES}
    (tmp_path / "mesh.json").write_text(json.dumps(mesh))
    (tmp_path / "square.json").write_text(json.dumps({"outer": SQUARE}))
    return str(tmp_path / "mesh.json"), str(tmp_path / "square.json")


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str]:
    capsys.readouterr()
    return main(["verify", *arguments]), capsys.readouterr().out


def run_json(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, dict[str, Any]]:
    code, out = run(capsys, *arguments, "--json")
    return code, json.loads(out)


def test_off_its_edge_is_not_valid(
    files: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    code, out = run(capsys, files[0], "--polygon", files[1])
    assert code == 1
    assert out.startswith("not valid: 5 triangles, 6 vertices")
    assert "1 boundary vertex is off the polygon, by at most 1e-16 (at most" in out
    assert "ulps) from edge [0, 0]: vertex 5" in out


@pytest.mark.parametrize(
    "tolerance, code", [("1e-16", 0), ("1/10000000000000000", 0), ("9e-17", 1)]
)
def test_a_tolerance_decides_the_exit_code(
    files: tuple[str, str], capsys: pytest.CaptureFixture[str], tolerance: str, code: int
) -> None:
    arguments = (files[0], "--polygon", files[1], "--tolerance", tolerance)
    found, record = run_json(capsys, *arguments)
    assert found == code
    assert record["within_tolerance"] is (code == 0) and record["valid"] is False
    _, out = run(capsys, *arguments)
    assert out.startswith("valid within 1e-16" if code == 0 else "not valid, not even within 9e-17")


def test_without_one_within_tolerance_is_null(
    files: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    _, record = run_json(capsys, files[0], "--polygon", files[1])
    assert record["within_tolerance"] is None and "tolerance" not in record


def test_figures_against_the_polygon(
    files: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    _, record = run_json(capsys, files[0], "--polygon", files[1])
    assert record["triangles_per_vertex"] == "5/4"
    assert record["feature_size_squared"] == "16"
    assert mpq(record["height_ratio_squared"]) == mpq(record["min_height_squared"]) / 16


@pytest.mark.parametrize("option", [("--tolerance", "1"), ("--compare",)])
def test_what_needs_a_polygon_says_so(
    files: tuple[str, str], capsys: pytest.CaptureFixture[str], option: tuple[str, ...]
) -> None:
    assert main(["verify", files[0], *option]) == 2
    assert "--polygon" in capsys.readouterr().err


def test_a_negative_tolerance_is_refused(files: tuple[str, str]) -> None:
    assert main(["verify", files[0], "--polygon", files[1], "--tolerance=-1"]) == 3


def test_comparison_with_every_theorem_that_applies(
    files: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    code, record = run_json(capsys, files[0], "--polygon", files[1], "--compare")
    assert code == 1
    names = [row["mesh"] for row in record["compare"]]
    assert names[0] == "given"
    assert names[1:] == [f"theorem {k}{thin}" for k in (1, 2, 4) for thin in ("", ", thinned")]
    given, thinned = record["compare"][0], record["compare"][-1]
    assert given["triangles"] == 5 and given["max_angle"]["cos_sign"] == -1
    assert thinned["triangles"] == 2 and thinned["max_angle"]["degrees"] == ["90", "90"]
    _, out = run(capsys, files[0], "--polygon", files[1], "--compare")
    assert "theorem 4, thinned          2" in out


def test_a_full_list_of_defects_says_that_it_is_full(
    files: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    main(["verify", files[0], "--polygon", files[1], "--limit", "1"])
    assert "no more than 1 defects are listed" in capsys.readouterr().err
    main(["verify", files[0], "--polygon", files[1]])
    assert "listed" not in capsys.readouterr().err
