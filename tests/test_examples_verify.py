"""The programs of examples/verify, run where their compilers, interpreters and packages are."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent.parent / "examples" / "verify"
CHILE = HERE.parent / "ne_chile_50m.json"


def run(*words: str, cwd: Path, stdin: str | None = None) -> subprocess.CompletedProcess[str]:
    """A program with our command on its path."""
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    return subprocess.run(
        words,
        cwd=cwd,
        env={**os.environ, "PATH": path},
        input=stdin,
        capture_output=True,
        text=True,
    )


def needs(program: str) -> None:
    if shutil.which(program) is None:
        pytest.skip(f"{program} is not installed")


def test_cpp(tmp_path: Path) -> None:
    needs("g++")
    built = run("g++", "-std=c++17", str(HERE / "own_mesher.cpp"), "-o", "own", cwd=tmp_path)
    assert built.returncode == 0, built.stderr
    said = run("./own", cwd=tmp_path)
    assert said.returncode == 1
    assert "angle-above-bound: triangle 0" in said.stdout


@pytest.mark.parametrize(
    "interpreter, name", [("node", "own_mesher.mjs"), ("julia", "own_mesher.jl")]
)
def test_scripts(interpreter: str, name: str, tmp_path: Path) -> None:
    needs(interpreter)
    said = run(interpreter, str(HERE / name), cwd=tmp_path)
    assert "angle-above-bound: triangle 0" in said.stdout, said.stderr


def test_triangle(tmp_path: Path) -> None:
    pytest.importorskip("triangle")
    said = run(sys.executable, str(HERE / "triangle_and_verify.py"), str(CHILE), cwd=tmp_path)
    assert said.stdout.startswith("<Verdict: valid within 1e-9"), said.stderr


def test_gmsh(tmp_path: Path) -> None:
    pytest.importorskip("gmsh")
    run(sys.executable, str(HERE / "gmsh_and_verify.py"), str(CHILE), cwd=tmp_path)
    command = ("bern-exact", "verify", "chile.msh", "--polygon", str(CHILE))
    command += ("--numbers", "binary64", "--tolerance", "1e-14", "--limit", "0")
    said = run(*command, cwd=tmp_path)
    assert said.stdout.startswith("valid within 1e-14"), said.stderr


@pytest.mark.long
def test_cgal(tmp_path: Path) -> None:
    needs("g++")
    built = run("g++", str(HERE / "cgal_cdt.cpp"), "-o", "cdt", "-lgmp", "-lmpfr", cwd=tmp_path)
    if "CGAL" in built.stderr and "No such file" in built.stderr:
        pytest.skip("CGAL is not installed")
    assert built.returncode == 0, built.stderr
    assert run("bern-exact", "convert", str(CHILE), "-o", "c.wkt", cwd=tmp_path).returncode == 0
    text = (tmp_path / "c.wkt").read_text()
    ring = "".join(c for c in text.replace(",", "\n") if not c.isalpha() and c not in "()")
    (tmp_path / "c.off").write_text(run("./cdt", cwd=tmp_path, stdin=ring).stdout)
    command = ("bern-exact", "verify", "c.off", "--polygon", "c.wkt", "--numbers", "binary64")
    said = run(*command, cwd=tmp_path)
    assert said.returncode == 0 and said.stdout.startswith("valid: 1,142 triangles")
