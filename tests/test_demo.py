"""`make demo`, but of a glyph and into another directory."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

ROOT = Path(__file__).resolve().parent.parent


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("make") is None, reason="no make")
def test_the_demo_triangulates_verifies_and_draws(tmp_path: Path) -> None:
    here = [f"OUT={tmp_path}", f"BIN={Path(sys.executable).parent}"]
    here += ["POLYGON=examples/glyph_dejavusans_A.json"]
    # -o: the environment that runs this test is set up already.
    words = ["make", "--no-print-directory", "-o", ".venv/.installed", "demo", *here]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "theorem-1" in done.stderr
    document = json.loads((tmp_path / "south_africa.mesh.json").read_text())
    assert document["certificate"]["holes"] == 1
    assert all(c["holds"] for c in document["certificate"]["claims"] if c["role"] == "guarantee")
    ElementTree.parse(tmp_path / "south_africa.svg")
    thin = json.loads((tmp_path / "thin.mesh.json").read_text())["certificate"]
    assert thin["triangles"] < thin["raw"]["triangles"]
