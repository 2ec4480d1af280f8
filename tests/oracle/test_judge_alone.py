"""judge.py as a file of its own: exit codes, and a refusal of whatever is no mesh."""

from __future__ import annotations

import ast
import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from bern_exact.oracle import judge as lone
from tests.oracle.meshes import grid, texts


@pytest.fixture
def script(tmp_path: Path) -> Path:
    """A copy of judge.py far from the package."""
    return Path(shutil.copy(lone.__file__, tmp_path / "judge.py"))


def run(script: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-I", str(script), *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=60, cwd=script.parent)


def write(script: Path, content: object, name: str = "mesh.json") -> str:
    path = script.parent / name
    path.write_bytes(content if isinstance(content, bytes) else json.dumps(content).encode())
    return str(path)


def test_it_imports_the_standard_library_alone() -> None:
    roots = set()
    for node in ast.walk(ast.parse(Path(lone.__file__).read_text())):
        if isinstance(node, ast.ImportFrom):
            roots.add((node.module or "").split(".")[0])
        elif isinstance(node, ast.Import):
            roots.update(alias.name.split(".")[0] for alias in node.names)
    assert roots <= sys.stdlib_module_names


def test_a_good_mesh_is_valid(script: Path) -> None:
    result = run(script, write(script, grid(2, 2).document()), "--max-angle", "90", "--json")
    assert result.returncode == 0 and json.loads(result.stdout)["valid"]
    assert result.stderr == ""


def test_a_bad_mesh_is_not(script: Path) -> None:
    case = grid(2, 2)
    del case.triangles[0]
    result = run(script, write(script, case.document()))
    assert result.returncode == 1 and not json.loads(result.stdout)["valid"]


def test_the_polygon_of_the_second_file_counts(script: Path) -> None:
    case = grid(2, 2)
    mesh = write(script, case.document())
    outer = texts(grid(3, 3).rings[0])
    polygon = write(script, {"outer": outer}, "polygon.json")
    assert run(script, mesh).returncode == 0
    assert run(script, mesh, polygon).returncode == 1


@pytest.mark.parametrize(
    "option",
    [
        ("--max-angle", "89.9"),
        ("--max-angle", "cos:1:1/100"),
        ("--min-height-squared", "0.6"),
        ("--max-triangles", "7"),
    ],
)
def test_bounds(script: Path, option: tuple[str, str]) -> None:
    mesh = write(script, grid(2, 2).document())
    assert run(script, mesh, *option).returncode == 1


def with_number(text: bytes) -> bytes:
    return b'{"vertices": [[0, 0], [1, 0], [0, %s]], "triangles": [[0, 1, 2]]}' % text


GOOD_NUMBERS = [
    b"1", b"0.1", b"1e-3", b"1E+2", b'"1/3"', b'"-6/4"', b'"+.5"', b'"2."', b'"1e10000"',
    b'"%s"' % (b"7" * 6_000), b"9" * 6_000,
]  # fmt: skip
BAD_NUMBERS = [
    b"NaN", b"Infinity", b"true", b"null", b"[]", b'"1/0"', b'"1/-2"', b'"nan"', b'""', b'"."',
    b'" 1"', b'"1_0"', b'"0x10"', b"1e10001", b"1e999999999", b'"1e-999999999999999"',
    b"1" * 100_001, b'"1/%s"' % (b"1" * 100_001), '"\u0663"'.encode(),
]  # fmt: skip


@pytest.mark.parametrize("text", GOOD_NUMBERS, ids=lambda t: t[:12].decode())
def test_numbers_that_are_read(script: Path, text: bytes) -> None:
    assert run(script, write(script, with_number(text))).returncode in (0, 1)


@pytest.mark.parametrize("text", BAD_NUMBERS, ids=lambda t: t[:12].decode())
def test_numbers_that_are_refused(script: Path, text: bytes) -> None:
    refused(script, with_number(text))


def refused(script: Path, content: object) -> None:
    result = run(script, write(script, content))
    assert result.returncode == 3
    assert "Traceback" not in result.stderr and result.stderr.startswith("unreadable: ")


SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]
NOT_MESHES = {
    "empty": b"",
    "binary": bytes(range(256)),
    "latin 1": b'{"vertices": "\xe9"}',
    "cut off": b'{"vertices": [[0, 0]',
    "deep list": b"[" * 100_000,
    "deep object": b'{"a":' * 100_000,
    "a list": [],
    "a number": 7,
    "nothing in it": {},
    "no triangles": {"vertices": SQUARE},
    "no vertices": {"triangles": []},
    "a flat list of vertices": {"vertices": [0, 0, 1, 0], "triangles": []},
    "three coordinates": {"vertices": [[0, 0, 0]], "triangles": []},
    "four corners": {"vertices": SQUARE, "triangles": [[0, 1, 2, 3]]},
    "corners of text": {"vertices": SQUARE, "triangles": [["0", "1", "2"]]},
    "corners with decimals": {"vertices": SQUARE, "triangles": [[0, 1, 2.0]]},
    "corners that are true": {"vertices": SQUARE, "triangles": [[0, True, 2]]},
    "another format": {"format": "bern-exact/polygon", "vertices": [], "triangles": []},
    "another version": {"version": 2, "vertices": [], "triangles": []},
    "a polygon of text": {"vertices": [], "triangles": [], "polygon": "square"},
    "a polygon without points": {"vertices": [], "triangles": [], "polygon": {"outer": []}},
    "a ring of two": {"vertices": [], "triangles": [], "polygon": {"outer": SQUARE[:2]}},
    "a ring without area": {
        "vertices": [], "triangles": [], "polygon": {"outer": [[0, 0], [1, 0], [2, 0]]},
    },
    "a bow-tie": {
        "vertices": [], "triangles": [], "polygon": {"outer": [[0, 0], [1, 1], [1, 0], [0, 3]]},
    },
    "a hole outside": {
        "vertices": [], "triangles": [],
        "polygon": {"outer": SQUARE, "holes": [[[5, 5], [6, 5], [5, 6]]]},
    },
    "a hole that touches": {
        "vertices": [], "triangles": [],
        "polygon": {"outer": SQUARE, "holes": [[[0, 0], ["1/2", "1/4"], ["1/4", "1/2"]]]},
    },
    "an empty hole": {
        "vertices": [], "triangles": [], "polygon": {"outer": SQUARE, "holes": [[]]},
    },
}  # fmt: skip


@pytest.mark.parametrize("content", NOT_MESHES.values(), ids=NOT_MESHES.keys())
def test_what_is_no_mesh_is_refused(script: Path, content: object) -> None:
    refused(script, content)


def test_a_file_that_is_not_there(script: Path) -> None:
    assert run(script, "nowhere.json").returncode == 3


@pytest.mark.parametrize("angle", ["", "x", "-1", "180.1", "nan", "cos:2:1/4", "cos:0:1/4", "cos"])
def test_bounds_that_are_refused(script: Path, angle: str) -> None:
    mesh = write(script, grid(1, 1).document())
    assert run(script, mesh, f"--max-angle={angle}").returncode == 3
