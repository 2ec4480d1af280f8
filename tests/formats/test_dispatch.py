"""The format follows the file's suffix."""

from __future__ import annotations

from pathlib import Path

import pytest

from bern_exact.exact.errors import InputError
from bern_exact.formats import read_mesh_file, read_polygon_file
from bern_exact.formats.mesh_json import dumps_mesh, read_mesh
from tests.formats.test_mesh_json import SQUARE


@pytest.mark.parametrize("name", ["x.json", "X.JSON", "x.mesh.json"])
def test_json_files_are_read(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_text('{"outer": [[0, 0], [0.1, 0], [0, 1]]}')
    assert read_polygon_file(path).n == read_polygon_file(str(path), binary64=True).n == 3
    path.write_text(dumps_mesh(*read_mesh(SQUARE)))
    assert read_mesh_file(path) == read_mesh(SQUARE)


@pytest.mark.parametrize("name", ["x", "x.xyz", "json", "x.json.gz"])
def test_unknown_suffixes_are_refused_before_the_file_is_opened(tmp_path: Path, name: str) -> None:
    for read in (read_polygon_file, read_mesh_file):
        with pytest.raises(InputError) as refusal:
            read(tmp_path / name)
        assert refusal.value.kind == "unsupported"
