"""Files that triangle, meshio and gmsh wrote are read: exactly, whatever the format."""

from __future__ import annotations

from pathlib import Path

import pytest

from bern_exact.exact.points import coordinates
from bern_exact.formats import read_array_mesh_file, read_polygon_file
from bern_exact.formats.triangle_mesh import load_mesh
from bern_exact.oracle.api import polygon_of
from bern_exact.oracle.fast import verify_mesh
from bern_exact.plane.array_mesh import DoublePoints

FILES = Path(__file__).parent / "files"
ASCII = [
    path
    for path in sorted(FILES.iterdir())
    if path.suffix in (".node", ".ele", ".msh", ".vtk", ".vtu", ".off", ".obj")
    and ".binary." not in path.name
]
BINARY = sorted(FILES.glob("*.binary.*"))


@pytest.mark.parametrize("numbers", ["decimal", "binary64"])
@pytest.mark.parametrize("path", ASCII, ids=lambda p: p.name)
def test_meshes_are_read_and_valid(path: Path, numbers: str) -> None:
    found, polygon = read_array_mesh_file(path, binary64=numbers == "binary64")
    assert polygon is None
    assert verify_mesh(found.mesh, None).valid
    assert (len(found.points), len(found.triangles)) == (
        (44, 62) if path.name.startswith("gmsh") else (34, 48)
    )


FAITHFUL = [p for p in ASCII if p.name.startswith("meshio") and p.suffix != ".vtu"]
"""Not so meshio's ASCII .vtu, which has 11 digits; gmsh prints 16."""


@pytest.mark.parametrize("path", FAITHFUL, ids=lambda p: p.name)
def test_the_same_doubles_in_every_format_of_meshio(path: Path) -> None:
    found, _ = read_array_mesh_file(path, binary64=True)
    first = load_mesh(FILES / "triangle.1.node", binary64=True)
    assert found.points.doubles.tolist() == first.points.doubles.tolist()
    assert found.triangles.tolist() == first.triangles.tolist()


@pytest.mark.parametrize("path", BINARY, ids=lambda p: p.name)
def test_binary_files_hold_the_doubles_of_the_ascii_ones(path: Path) -> None:
    pytest.importorskip("meshio")
    found, _ = read_array_mesh_file(path)
    twin = path.with_name(path.name.replace(".binary", ""))
    if path.suffix == ".vtk":
        twin = path.with_name("meshio.51.vtk")
    same, _ = read_array_mesh_file(twin, binary64=True)
    assert isinstance(found.points, DoublePoints)
    assert verify_mesh(found.mesh, None).valid
    assert found.triangles.tolist() == same.triangles.tolist()
    difference = abs(found.points.doubles - same.points.doubles).max()
    assert difference == 0 if twin in FAITHFUL else difference < 1e-10


def test_a_poly_of_triangle_s_is_its_mesh_s_polygon() -> None:
    polygon = read_polygon_file(FILES / "triangle.1.poly", binary64=True)
    (low, _), (high, _) = coordinates(polygon.points[-4]), coordinates(polygon.points[-2])
    assert (polygon.holes, polygon.area) == (1, 12 - (high - low) ** 2)
    found, own = read_array_mesh_file(FILES / "triangle.1.poly", binary64=True)
    assert own == polygon
    assert verify_mesh(found.mesh, own).valid


def test_a_mesh_and_a_boundary_by_the_real_packages(tmp_path: Path) -> None:
    triangle = pytest.importorskip("triangle")
    meshio = pytest.importorskip("meshio")
    made = triangle.triangulate({"vertices": [(0, 0), (3, 0), (3, 1), (0.1, 0.9)]}, "qa0.05")
    cells = [("triangle", made["triangles"])]
    points = [(x, y, 0) for x, y in made["vertices"].tolist()]
    for name in ("a.vtk", "a.vtu"):  # binary unless told otherwise
        meshio.Mesh(points, cells).write(tmp_path / name)
        found, _ = read_array_mesh_file(tmp_path / name, binary64=True)
        assert found.points.doubles.tolist() == made["vertices"].tolist()
        assert found.triangles.tolist() == made["triangles"].tolist()


@pytest.mark.parametrize("version", [2.2, 4.1])
@pytest.mark.parametrize("binary", [0, 1])
def test_a_mesh_by_the_real_gmsh(tmp_path: Path, version: float, binary: int) -> None:
    gmsh = pytest.importorskip("gmsh")
    pytest.importorskip("meshio")
    path = tmp_path / "a.msh"
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setNumber("Mesh.MshFileVersion", version)
        gmsh.option.setNumber("Mesh.Binary", binary)
        gmsh.model.occ.addRectangle(0, 0, 0, 3, 1)
        gmsh.model.occ.synchronize()
        gmsh.model.mesh.generate(2)
        gmsh.write(str(path))
        tags, _, _ = gmsh.model.mesh.getNodes()
    finally:
        gmsh.finalize()
    found, _ = read_array_mesh_file(path, binary64=True)
    assert len(found.points) == len(tags)
    assert verify_mesh(found.mesh, polygon_of([(0, 0), (3, 0), (3, 1), (0, 1)])).valid
