"""Every mesh format: what is written is read back, what other programs print as it stands."""

from __future__ import annotations

from pathlib import Path

import pytest
from gmpy2 import mpq, mpz
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import nearest_binary64
from bern_exact.exact.points import hpoint
from bern_exact.formats import MESH_WRITERS, format_of_mesh, read_array_mesh_file, read_mesh_file
from bern_exact.plane.mesh import Mesh

DOUBLES = [name for name in MESH_WRITERS if name != "json"]
SQUARE = [[0, 1, 2], [0, 2, 3]]

rationals = st.builds(lambda p, q: mpq(p, q), st.integers(-(10**20), 10**20), st.integers(1, 10**6))
doubles = st.floats(allow_nan=False, allow_infinity=False).map(
    lambda x: mpq(*map(mpz, x.as_integer_ratio()))
)


@st.composite
def meshes(draw: st.DrawFn, numbers: st.SearchStrategy[mpq]) -> Mesh:
    """Any vertices and any triangles, indices out of range as well."""
    pairs = draw(st.lists(st.tuples(numbers, numbers), min_size=1, max_size=6))
    index = st.integers(-2, len(pairs) + 1)
    triangles = draw(st.lists(st.tuples(index, index, index), max_size=5))
    return Mesh(tuple(hpoint(x, y) for x, y in pairs), tuple(triangles))


def save(mesh: Mesh, folder: Path, name: str) -> tuple[Path, int]:
    """Write a mesh; the first of its files, and what was rounded."""
    written = MESH_WRITERS[name](mesh)
    paths = [folder / f"m{suffix or '.' + name}" for suffix in written.texts]
    for path, text in zip(paths, written.texts.values(), strict=True):
        path.write_text(text, newline="\n")
    return paths[0], written.rounded


same_folder = settings(max_examples=25, suppress_health_check=[HealthCheck.function_scoped_fixture])


@pytest.mark.parametrize("name", DOUBLES)
@same_folder
@given(mesh=meshes(doubles))
def test_meshes_of_doubles_come_back(name: str, tmp_path: Path, mesh: Mesh) -> None:
    path, rounded = save(mesh, tmp_path, name)
    assert rounded == 0
    found, polygon = read_mesh_file(path, binary64=True)
    assert polygon is None
    assert found.vertices == mesh.vertices
    if name != "obj":
        assert found.triangles == mesh.triangles


@pytest.mark.parametrize("name", DOUBLES)
@same_folder
@given(mesh=meshes(rationals))
def test_other_coordinates_are_rounded_to_the_nearest_doubles(
    name: str, tmp_path: Path, mesh: Mesh
) -> None:
    path, rounded = save(mesh, tmp_path, name)
    nearest = [(nearest_binary64(x), nearest_binary64(y)) for x, y in mesh.coordinates]
    found, _ = read_mesh_file(path, binary64=True)
    assert found.coordinates == nearest
    flat = [c for pair in zip(mesh.coordinates, nearest, strict=True) for c in zip(*pair)]  # noqa: B905
    assert rounded == sum(exact != double for exact, double in flat)


@same_folder
@given(mesh=meshes(rationals))
def test_json_rounds_nothing(tmp_path: Path, mesh: Mesh) -> None:
    path, rounded = save(mesh, tmp_path, "json")
    assert rounded == 0
    assert read_mesh_file(path) == (mesh, None)


@pytest.mark.parametrize("name", DOUBLES)
def test_coordinates_beyond_all_doubles_are_refused(name: str, tmp_path: Path) -> None:
    with pytest.raises(InputError) as refusal:
        MESH_WRITERS[name](Mesh((hpoint(mpz(10) ** 400, 0),), ()))
    assert refusal.value.kind == "number"


@pytest.mark.parametrize("name", DOUBLES)
def test_decimals_are_decimals_unless_doubles_are_asked_for(name: str, tmp_path: Path) -> None:
    tenth = mpq(*map(mpz, (0.1).as_integer_ratio()))
    path, _ = save(
        Mesh((hpoint(tenth, 0), hpoint(1, 0), hpoint(0, 1)), ((0, 1, 2),)), tmp_path, name
    )
    assert read_mesh_file(path)[0].coordinates[0] == (mpq(1, 10), 0)
    assert read_mesh_file(path, binary64=True)[0].coordinates[0] == (tenth, 0)
    if name != "node":  # of two files, by their suffixes
        named = path.rename(tmp_path / "any")
        assert read_mesh_file(named, format=name)[0].triangles == ((0, 1, 2),)


OFF = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"
OBJ = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"
VTK = (
    "# vtk DataFile Version 3.0\na title\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
    "0 0 0 1 0 0\n1 1 0 0 1 0\nCELLS 2 8\n3 0 1 2\n3 0 2 3\nCELL_TYPES 2\n5\n5\n"
)
POLYDATA = VTK.partition("CELLS")[0].replace("UNSTRUCTURED_GRID", "POLYDATA") + (
    "POLYGONS 2 8\n3 0 1 2\n3 0 2 3\n"
)
MSH2 = (
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
    "$EndNodes\n$Elements\n2\n1 2 2 0 1 1 2 3\n2 2 2 0 1 1 3 4\n$EndElements\n"
)
MSH4 = (
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n2 4 1 4\n0 1 0 1\n4\n0 1 0\n2 1 0 3\n1\n2\n3\n"
    "0 0 0\n1 0 0\n1 1 0\n$EndNodes\n$Elements\n2 3 1 3\n1 1 1 1\n1 1 2\n2 1 2 2\n2 1 2 3\n"
    "3 1 3 4\n$EndElements\n"
)
VTU = """<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid"><UnstructuredGrid>
<Piece NumberOfPoints="4" NumberOfCells="2"><Points>
<DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0
1 1 0 0 1 0</DataArray></Points><Cells>
<DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 0 2 3</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">3 6</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">5 5</DataArray></Cells></Piece>
</UnstructuredGrid></VTKFile>
"""
TEXTS = {"a.off": OFF, "a.obj": OBJ, "a.vtk": VTK, "p.vtk": POLYDATA, "2.msh": MSH2, "4.msh": MSH4}
TEXTS["a.vtu"] = VTU


def read(folder: Path, name: str, text: str | bytes) -> list[list[int]]:
    """The triangles of a text of the square with corners (0, 0) and (1, 1)."""
    path = folder / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    found, _ = read_array_mesh_file(path)
    square = sorted(map(tuple, found.points.doubles.tolist()))
    assert square == [(0, 0), (0, 1), (1, 0), (1, 1)]
    triangles: list[list[int]] = found.triangles.tolist()
    return triangles


@pytest.mark.parametrize(
    ("name", "text"),
    [
        *TEXTS.items(),
        ("a.off", "# c\n\n" + OFF.replace("OFF\n4 2 0", "4 2") + "# end"),
        ("a.off", OFF.replace("OFF\n", "OFF ")),
        ("a.off", OFF.replace("OFF", "COFF").replace(" 0\n1 1", " 0 255 0 0 1\n1 1")),
        ("a.off", OFF.replace("3 0 1 2", "3 0 1 2 0.5 0.5 0.5")),
        ("a.off", OFF.replace("2 0\n", "3 0\n", 1).replace("3 0 1 2", "2 0 1\n3 0 1 2")),
        ("a.obj", OBJ.replace("f 1 2 3", "f 1/1 2/2 3/3").replace("1 3 4", "1//1 3//1 4//1")),
        ("a.obj", OBJ.replace("f 1 2 3", "f 1/1/1 2/2/1 3/3/1")),
        ("a.obj", OBJ.replace("f 1 2 3", "f -4 -3 -2").replace("v 0 1 0", "v 0 1 0 1.0")),
        ("a.obj", "mtllib a/b.mtl\no x\ng y\ns off\n" + OBJ + "l 1 2\nvn 0 0 1\nvt 0 1/2\n"),
        ("a.obj", OBJ.replace("f 1 2 3", "f 1 \\\n 2 3")),
        ("a.obj", OBJ.replace("1 0 0", "1 0")),
        ("a.vtk", VTK.replace("CELLS", "METADATA\nINFORMATION 0\n\nCELLS")),
        ("a.vtk", VTK.replace("POINTS", "FIELD FieldData 1\nTIME 1 1 double\n0.5\nPOINTS")),
        ("a.vtk", VTK.replace("CELLS 2 8\n", "CELLS 3 11\n2 0 1\n").replace("2\n5", "3\n3\n5")),
        (
            "a.vtk",
            VTK.replace("2\n5\n5", "2\n5\n7").lower().replace("# vtk datafile", "# vtk DataFile"),
        ),
        ("a.vtk", VTK + "CELL_DATA 2\nSCALARS a float 1\nLOOKUP_TABLE default\nx y\n"),
        ("p.vtk", POLYDATA.replace("POLYGONS", "LINES 1 3\n2 0 1\nVERTICES 1 2\n1 0\nPOLYGONS")),
        (
            "p.vtk",
            POLYDATA.partition("POLYGONS")[0]
            + "POLYGONS 3 6\nOFFSETS vtktypeint64\n0 3 6\nCONNECTIVITY vtktypeint64\n0 1 2 0 2 3\n",
        ),
        (
            "2.msh",
            '$PhysicalNames\n1\n2 1 "$a b"\n$EndPhysicalNames\n'.join(
                MSH2.split("$Nodes", 1)
            ).replace("$EndPhysicalNames\n", "$EndPhysicalNames\n$Nodes"),
        ),
        ("2.msh", MSH2.replace("$Elements\n2", "$Elements\n3\n9 15 2 0 1 1")),
        ("4.msh", MSH4.replace("0 1 0 1\n4\n0 1 0", "0 1 1 1\n4\n0 1 0")),
        (
            "a.vtu",
            VTU.replace(
                "<Points>", "<PointData><DataArray Name='x' format='binary'/></PointData><Points>"
            ),
        ),
        ("a.vtu", VTU.replace("0 1 2 0", "0 <!-- x -->1 2 0")),
    ],
)
@pytest.mark.parametrize("ends", ["\n", "\r\n"])
def test_what_other_programs_print(tmp_path: Path, name: str, text: str, ends: str) -> None:
    text = text.replace("\n", ends)
    wanted = [[1, 2, 3], [1, 3, 0]] if name == "4.msh" else SQUARE
    assert read(tmp_path, name, b"\xef\xbb\xbf" + text.encode()) == wanted
    assert read(tmp_path, name, text) == wanted
    if not name.endswith(("vtu", "vtk")):
        assert read(tmp_path, name, text.replace(" ", " \t ")) == wanted


@pytest.mark.parametrize(
    ("name", "old", "new", "wanted"),
    [
        ("a.off", "3 0 1 2", "3 0 1 9", [0, 1, 9]),
        ("a.off", "3 0 1 2", "3 -1 1 2", [-1, 1, 2]),
        ("a.obj", "f 1 2 3", "f 0 2 9", [-1, 1, 8]),
        ("a.obj", "f 1 2 3", "f -9 2 3", [-5, 1, 2]),
        ("2.msh", "1 2 3\n2 2", "1 2 77\n2 2", [0, 1, 76]),
        ("a.vtk", "3 0 1 2", f"3 0 1 {10**30}", [0, 1, 10**30]),
        ("a.vtu", "0 1 2 0", "0 1 -7 0", [0, 1, -7]),
    ],
)
def test_indices_out_of_range_are_for_the_judge(
    tmp_path: Path, name: str, old: str, new: str, wanted: list[int]
) -> None:
    assert read(tmp_path, name, TEXTS[name].replace(old, new, 1))[0] == wanted


def test_nodes_of_gmsh_may_have_any_numbers(tmp_path: Path) -> None:
    text = MSH2.replace("\n2 1 0 0", "\n70 1 0 0").replace("1 1 2 3", "1 1 70 3")
    assert read(tmp_path, "a.msh", text) == SQUARE
    assert read(tmp_path, "a.msh", text.replace("1 1 70 3", "1 1 2 3"))[0] == [0, -1, 2]


@pytest.mark.parametrize(
    ("name", "old", "new", "kind", "line"),
    [
        ("a.off", "OFF", "4OFF", "unsupported", 1),
        ("a.off", "OFF", "OFF BINARY", "unsupported", 1),
        ("a.off", "OFF", "PLY", "syntax", 1),
        ("a.off", "1 1 0", "1 1 0.5", "unsupported", 5),
        ("a.off", "1 1 0", "1 nan 0", "number", 5),
        ("a.off", "1 1 0", "1 1d0 0", "number", 5),
        ("a.off", "1 1 0", "1 1 zero", "number", 5),
        ("a.off", "1 1 0", "1 1", "syntax", 5),
        ("a.off", "3 0 2 3", "4 0 2 3 1", "unsupported", 8),
        ("a.off", "3 0 2 3", "3 0 2", "syntax", 8),
        ("a.off", "3 0 2 3", "3 0 2 x", "syntax", 8),
        ("a.off", "3 0 2 3\n", "", "syntax", 7),
        ("a.off", "3 0 2 3", "3 0 2 3\n3 0 1 3", "syntax", 9),
        ("a.off", "4 2 0", "-4 2 0", "syntax", 2),
        ("a.obj", "f 1 3 4", "f 1 2 3 4", "unsupported", 6),
        ("a.obj", "f 1 3 4", "f 1 2", "syntax", 6),
        ("a.obj", "f 1 3 4", "f 1 3 /4", "syntax", 6),
        ("a.obj", "f 1 3 4", "f 1/x 3 4", "syntax", 6),
        ("a.obj", "f 1 3 4", "curv 1 3 4", "unsupported", 6),
        ("a.obj", "f 1 3 4", "face 1 3 4", "syntax", 6),
        ("a.obj", "v 1 1 0", "v 1 1 2", "unsupported", 3),
        ("a.obj", "v 1 1 0", "v 1", "syntax", 3),
        ("2.msh", "2.2 0 8", "1.0 0 8", "unsupported", 2),
        ("2.msh", "2.2 0 8", "4.0 0 8", "unsupported", 2),
        ("2.msh", "$MeshFormat", "$NOD", "syntax", 1),
        ("2.msh", "3 1 1 0", "2 1 1 0", "schema", 8),
        ("2.msh", "3 1 1 0", "3 1 1 1", "unsupported", 8),
        ("2.msh", "$Nodes\n4", "$Nodes\n5", "syntax", 13),
        ("2.msh", "$Elements\n2", "$Elements\n1", "syntax", 14),
        ("2.msh", "1 2 2 0 1 1 2 3", "1 3 2 0 1 1 2 3 4", "unsupported", 13),
        ("2.msh", "1 2 2 0 1 1 2 3", "1 2 3 0 1 1 2 3", "syntax", 13),
        ("2.msh", "$EndElements", "", "syntax", 15),
        ("4.msh", "2 1 2 2", "2 1 9 2", "unsupported", 21),
        ("4.msh", "2 3 1 3", "2 4 1 3", "syntax", 24),
        ("4.msh", "2 1 0 3\n", "9 1 0 3\n", "syntax", 9),
        ("a.vtk", "UNSTRUCTURED_GRID", "STRUCTURED_POINTS", "unsupported", 4),
        ("a.vtk", "2\n5\n5", "2\n5\n9", "unsupported", 13),
        ("a.vtk", "2\n5\n5", "2\n5", "syntax", 12),
        ("a.vtk", "CELL_TYPES 2\n5\n5\n", "", "syntax", 10),
        ("a.vtk", "3 0 2 3", "9 0 2 3", "syntax", 10),
        ("a.vtk", "POINTS 4", "POINTS 400000000000", "syntax", 13),
        ("a.vtk", "CELLS", "CELS", "syntax", 8),
        ("p.vtk", "POLYGONS", "TRIANGLE_STRIPS", "unsupported", 8),
        ("p.vtk", "POLYGONS 2 8\n3 0 1 2\n3 0 2 3", "POLYGONS 1 5\n4 0 1 2 3", "unsupported", 9),
        ("a.vtu", "UnstructuredGrid", "PolyData", "unsupported", 2),
        ("a.vtu", "5 5<", "5 9<", "unsupported", 7),
        ("a.vtu", "3 6<", "3 5<", "syntax", 7),
        ("a.vtu", "1 1 0 0 1 0", "1 1 0 0 1", "syntax", 6),
        ("a.vtu", "1 1 0 0 1 0", "1 1 0 0 1 9", "unsupported", 6),
        ("a.vtu", "1 1 0 0 1 0", "1 1 0 0 1_0 0", "number", 6),
        ("a.vtu", 'NumberOfPoints="4"', 'NumberOfPoints="5"', "syntax", 4),
        ("a.vtu", "</Piece>", "</Piece", "syntax", 10),
        ("a.vtu", "<VTKFile", "<!DOCTYPE VTKFile [<!ENTITY a 'b'>]>\n<VTKFile", "unsupported", 2),
        ("a.vtu", 'Name="types"', 'Name="kinds"', "syntax", 11),
    ],
)
def test_malformed_files_are_refused_with_line_and_kind(
    tmp_path: Path, name: str, old: str, new: str, kind: str, line: int
) -> None:
    assert old in TEXTS[name]
    path = tmp_path / name
    path.write_text(TEXTS[name].replace(old, new, 1))
    with pytest.raises(InputError) as refusal:
        read_array_mesh_file(path)
    assert (refusal.value.kind, refusal.value.where.get("line")) == (kind, line)
    assert f"line {line}" in refusal.value.message


@pytest.mark.parametrize("name", TEXTS)
@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_no_text_raises_anything_but_refusals(
    tmp_path: Path, name: str, data: st.DataObject
) -> None:
    text = TEXTS[name].encode()
    begin, end = sorted(data.draw(st.integers(0, len(text))) for _ in "ab")
    piece = data.draw(
        st.one_of(
            st.binary(max_size=6),
            st.sampled_from(
                [b"-1", b"99999999999999999999", b" 3 ", b"\n", b"\0", b"1e999", b"$End"]
            ),
        )
    )
    path = tmp_path / name
    cut = data.draw(st.sampled_from([begin, end, min(begin + 2, len(text))]))
    path.write_bytes(text[:begin] + piece + text[cut:])
    for binary64 in (False, True):
        try:
            _ = read_array_mesh_file(path, binary64=binary64)[0].mesh
        except InputError as error:
            assert str(error)


def test_a_million_entities_are_no_bomb(tmp_path: Path) -> None:
    path = tmp_path / "a.vtu"
    lines = [f'<!ENTITY e{i} "{f"&e{i - 1};" * 10}">' for i in range(1, 10)]
    path.write_text(f'<!DOCTYPE x [<!ENTITY e0 "ha">{"".join(lines)}]><x>&e9;</x>')
    with pytest.raises(InputError, match="type declaration"):
        read_array_mesh_file(path)


def test_meshio_s_failures_are_refusals(tmp_path: Path) -> None:
    pytest.importorskip("meshio")
    for name, text in (
        ("a.msh", b"$MeshFormat\n2.2 1 8\n\x01\0\0\0\n$EndMeshFormat\n$Nodes\n"),
        ("a.vtk", VTK.replace("ASCII", "BINARY").encode()),
        ("a.vtu", VTU.replace('"ascii"', '"binary"').encode()),
    ):
        (tmp_path / name).write_bytes(text)
        with pytest.raises(InputError) as refusal:
            read_array_mesh_file(tmp_path / name)
        assert refusal.value.kind == "syntax"


@pytest.mark.parametrize(
    ("name", "wanted"),
    [
        ("x.node", "node"),
        ("x.1.ELE", "node"),
        ("x.vtu", "vtu"),
        ("x.svg", "svg"),
        ("x.txt", "json"),
    ],
)
def test_the_suffix_tells_the_format(name: str, wanted: str) -> None:
    assert format_of_mesh(Path(name)) == wanted
