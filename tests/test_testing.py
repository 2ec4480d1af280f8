"""Assertions for other people's test suites, and the pytest plugin."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from gmpy2 import mpq

from bern_exact import InputError, Polygon, triangulate
from bern_exact.__main__ import main
from bern_exact.formats import read_mesh_file
from bern_exact.testing import ExactJudge, assert_nonobtuse, assert_triangulation

pytest_plugins = ["pytester"]

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
TWO = [(0, 1, 2), (0, 2, 3)]
FAN = [*SQUARE, (2, "7/3")], [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]


def refused(*arguments: Any, **options: Any) -> str:
    with pytest.raises(AssertionError) as caught:
        assert_triangulation(*arguments, **options)
    return str(caught.value)


def test_a_good_mesh_passes_and_the_verdict_comes_back() -> None:
    verdict = assert_triangulation(SQUARE, TWO, SQUARE, max_angle=90, max_triangles=2)
    assert verdict.valid and verdict.min_height_squared == 8


def test_whatever_verify_takes_is_taken() -> None:
    result = triangulate(SQUARE, theorem=1)
    assert assert_triangulation(result, None, {"outer": SQUARE})
    numpy = pytest.importorskip("numpy")
    assert assert_triangulation(numpy.array(SQUARE, dtype=float), numpy.array(TWO), [SQUARE])
    assert assert_triangulation(iter(SQUARE), iter(TWO))


def test_the_first_line_says_what_is_wrong() -> None:
    first = refused(SQUARE, [TWO[0], (0, 3, 2)], SQUARE).splitlines()[0]
    assert first == ("not valid: clockwise-triangle: triangle 1 (the triangle runs clockwise)")


def test_the_others_are_counted_and_listed_with_place_and_witness() -> None:
    message = refused(SQUARE, TWO[:1], SQUARE)
    assert "and 3 more defects listed" in message.splitlines()[0]
    assert "unused-vertex: vertex 3" in message
    assert "at (0, 4)" in message
    assert "point: [2, 2]" in message
    assert "largest angle 90 degrees" in message


def test_no_more_than_the_limit_is_listed() -> None:
    message = refused([*SQUARE, *((9, y) for y in range(30))], TWO, SQUARE, limit=3)
    assert "(no more than 3 defects are listed)" in message
    assert message.count("unused-vertex: vertex") == 4  # once in the first line
    assert refused(SQUARE, TWO[:1], SQUARE, limit=0).startswith("not valid: defects")


@pytest.mark.parametrize(
    "options, kind",
    [
        ({"max_angle": "89.9"}, "angle-above-bound"),
        ({"max_angle": "cos:1:1/100"}, "angle-above-bound"),
        ({"min_height_squared": "8.001"}, "height-below-bound"),
        ({"max_triangles": 1}, "too-many-triangles"),
    ],
)
def test_bounds(options: dict[str, Any], kind: str) -> None:
    assert refused(SQUARE, TWO, SQUARE, **options).startswith(f"not valid: {kind}")


def test_a_tolerance() -> None:
    vertices = [*SQUARE, (2, mpq(1, 10**16))]
    triangles = [(0, 4, 3), (4, 1, 2), (4, 2, 3)]
    assert_triangulation(vertices, triangles, SQUARE, tolerance="1e-16")
    message = refused(vertices, triangles, SQUARE, tolerance="1e-17")
    assert message.startswith("not valid, not even within 1e-17: boundary-vertex-off-edge")
    assert "ulps" in message


def test_a_consequence_is_not_the_headline() -> None:
    """A gap makes boundary vertices that lie on no edge; it is the gap that is wrong."""
    vertices, triangles = FAN
    message = refused(vertices, triangles[:3], SQUARE)
    assert message.startswith("not valid: region-not-covered: edge [4, 0]")
    assert "\n  boundary-vertex-off-edge: vertex 4" in message


def test_huge_coordinates_do_not_flood_the_terminal() -> None:
    far = 10**5000
    message = refused([(far, 0), (far + 1, 0), (far, 1)], [(0, 2, 1)])
    assert max(map(len, message.splitlines())) < 500


def test_bad_arguments_are_no_failed_assertion() -> None:
    with pytest.raises(InputError):
        assert_triangulation(SQUARE, TWO, SQUARE[:2])
    with pytest.raises(InputError):
        assert_triangulation(SQUARE, TWO, max_angle="181")


def test_obtuse_angles() -> None:
    assert assert_nonobtuse(SQUARE, TWO, SQUARE).valid
    with pytest.raises(AssertionError, match="angle-above-bound"):
        assert_nonobtuse([(0, 0), (4, 0), (2, mpq(2) - mpq(1, 10**40))], [(0, 1, 2)])
    with pytest.raises(AssertionError, match="too-many-triangles"):
        assert_nonobtuse(SQUARE, TWO, SQUARE, max_triangles=1)


def test_what_is_refused_is_saved_and_can_be_judged_again(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    judge = ExactJudge(tmp_path)
    assert judge(SQUARE, TWO, SQUARE)
    assert not list(tmp_path.iterdir())
    with pytest.raises(AssertionError) as caught:
        judge(SQUARE, [*TWO, (0, 1, 9)], SQUARE, max_angle=120, min_height_squared="1/3")
    message = str(caught.value)
    stem = tmp_path / "exact_judge_1"
    for suffix in (".mesh.json", ".polygon.json", ".svg"):
        assert f"saved {stem}{suffix}" in message
    mesh, polygon = read_mesh_file(f"{stem}.mesh.json")
    assert polygon == Polygon.load(f"{stem}.polygon.json")
    assert mesh.triangles[2] == (0, 1, 9)
    ElementTree.parse(f"{stem}.svg")
    (again,) = [line for line in message.splitlines() if line.startswith("again: bern-exact ")]
    arguments = again.removeprefix("again: bern-exact ").split()
    assert arguments[-4:] == ["--max-angle", "120", "--min-height-squared", "1/3"]
    assert main([*arguments, "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["defects"][0]["kind"] == "index-out-of-range"
    with pytest.raises(AssertionError, match="exact_judge_2"):
        judge(SQUARE, TWO[:1], SQUARE)


SUITE = """
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]

def test_good(exact_judge):
    assert exact_judge(SQUARE, [(0, 1, 2), (0, 2, 3)], SQUARE, max_angle=90).triangles == 2

def test_bad(exact_judge):
    exact_judge(SQUARE, [(0, 1, 2)], SQUARE)
"""


@pytest.mark.parametrize("ci", ["", "true"])  # under CI pytest prints the message twice
def test_the_plugin_is_there_in_any_suite(
    ci: str, pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CI", ci)
    pytester.makepyfile(SUITE)
    result = pytester.runpytest("-p", "no:randomly")
    result.assert_outcomes(passed=1, failed=1)
    result.stdout.fnmatch_lines(
        [
            "E*AssertionError: not valid: *and 3 more defects listed",
            "E*saved *exact_judge_1.mesh.json",
            "E*saved *exact_judge_1.svg",
            "FAILED *::test_bad - AssertionError: *",
        ]
    )
    result.stdout.no_fnmatch_line("*testing.py*")  # the traceback ends in the user's test
    saved = {line.split("saved ", 1)[1] for line in result.outlines if "saved " in line}
    assert len(saved) == 3 and all(Path(path).exists() for path in saved)


def test_the_plugin_works_with_xdist(pytester: pytest.Pytester) -> None:
    pytest.importorskip("xdist")
    pytester.makepyfile(SUITE)
    pytester.runpytest("-n", "1").assert_outcomes(passed=1, failed=1)


def test_the_fixture_is_documented(pytester: pytest.Pytester) -> None:
    result = pytester.runpytest("--fixtures")
    result.stdout.fnmatch_lines(["exact_judge*", "*Assert exactly that a mesh*"])


def test_a_suite_that_does_not_use_the_plugin_pays_nothing() -> None:
    code = "import sys, bern_exact.pytest_plugin; print(sorted(sys.modules))"
    loaded = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    ).stdout
    assert "'bern_exact.pytest_plugin'" in loaded
    for heavy in ("gmpy2", "numpy", "rich", "click", "hypothesis", "bern_exact.testing"):
        assert f"'{heavy}'" not in loaded
