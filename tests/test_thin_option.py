"""`--thin` from outside: the mesh is the thinned one and the certificate says what it was."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from bern_exact.__main__ import main
from bern_exact.oracle.judge import judge

ROOT = Path(__file__).parents[1]
CHIP = str(ROOT / "examples" / "mdi_chip.json")


def thin_mesh(tmp_path: Path, *options: str) -> dict:
    target = tmp_path / "thin.mesh.json"
    svg = str(tmp_path / "thin.svg")
    assert main(["triangulate", CHIP, "--thin", *options, "-o", str(target), "--svg", svg]) == 0
    return json.loads(target.read_text())


@pytest.mark.parametrize("options", [("--theorem", "1"), (), ("--max-angle", "140")])
def test_the_thinned_mesh_is_valid_smaller_and_no_lower(
    options: tuple[str, ...], tmp_path: Path
) -> None:
    mesh = thin_mesh(tmp_path, *options)
    certificate = mesh["certificate"]
    bound = None if "1" in options else (options[1] if options else "150")
    verdict = judge(mesh, max_angle=bound)
    assert verdict["valid"], verdict["defects"]
    assert len(mesh["triangles"]) == certificate["triangles"] < 2 * certificate["n"]
    assert certificate["raw"]["triangles"] > 20 * certificate["n"]
    assert all(claim["holds"] for claim in certificate["claims"])
    assert {"thinning.valid", "thinning.height"} <= {c["id"] for c in certificate["claims"]}


def test_a_smaller_angle_is_asked_for_with_thin_only(tmp_path: Path) -> None:
    mesh = thin_mesh(tmp_path, "--thin-angle", "120")
    assert judge(mesh, max_angle="150")["valid"]
    assert main(["triangulate", CHIP, "--thin-angle", "120"]) == 2
