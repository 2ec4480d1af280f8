"""Triangle's files: `.poly`, `.node`, `.ele`, as Triangle and people write them."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from bern_exact.corpus.shapes import star
from bern_exact.exact.errors import InputError
from bern_exact.exact.points import coordinates
from bern_exact.formats import read_array_mesh_file, read_polygon_file
from bern_exact.formats.triangle_poly import dumps_polygon
from bern_exact.oracle.api import polygon_of
from bern_exact.plane.polygon import Polygon

FRAME = """# A square with a square hole
8 2 1 1   # vertices, dimension, attributes, markers

1 0 0  7 1
2 9 0  7 1
\t3 9.0 9e0 7 1
4 +0 9 7 1
5 1 1 7 2
6 2 1 7 2
7 2 2 7 2
8 1 2 7 2
8 1
1 1 2 1
2 2 3 1
3 4 3 1
4 4 1 1
5 5 6 2
6 6 7 2
7 7 8 2
8 8 5 2
1
1 1.5 1.5
"""


def load(folder: Path, text: str, *, binary64: bool = False) -> Polygon:
    path = folder / "p.poly"
    path.write_bytes(text.encode("latin-1"))
    return read_polygon_file(path, binary64=binary64)


WANTED = polygon_of([[(0, 0), (9, 0), (9, 9), (0, 9)], [(1, 1), (2, 1), (2, 2), (1, 2)]])


def zero_based(text: str) -> str:
    """The same file, vertices numbered from 0."""
    lines = text.splitlines()
    for i, line in enumerate(lines):
        words = line.split()
        if 3 <= i < 11:
            lines[i] = " ".join([str(int(words[0]) - 1), *words[1:]])
        elif 12 <= i < 20:
            lines[i] = " ".join(str(int(w) - 1) for w in words)
    return "\n".join(lines)


@pytest.mark.parametrize(
    "text",
    [
        FRAME,
        FRAME.replace("\n", "\r\n"),
        FRAME.replace("# A", "# \xc4"),
        FRAME.rstrip("\n"),
        FRAME + "1\n1 5 5 3 0.1\n# regions are passed over\n",
        FRAME.replace("1\n1 1.5 1.5", "2\n1 1.5 1.5\n2 12 5"),  # a hole point outside
        zero_based(FRAME),
    ],
)
def test_forms_of_one_polygon(tmp_path: Path, text: str) -> None:
    assert load(tmp_path, text) == WANTED


def test_vertices_may_be_in_the_node_file(tmp_path: Path) -> None:
    lines = FRAME.splitlines(keepends=True)
    (tmp_path / "p.node").write_text("9 2 1 1\n" + "".join(lines[3:11]) + "9 5 5 0 0\n")
    assert load(tmp_path, "0 2 1 1\n" + "".join(lines[11:])) == WANTED


@pytest.mark.parametrize(
    ("old", "new", "kind", "match"),
    [
        ("1\n1 1.5 1.5", "0", "unsupported", "ring 1 lies inside and has no hole point"),
        ("1 1.5 1.5", "1 5 5", "schema", "inside no hole"),
        ("1 1.5 1.5", "1 1 1.5", "schema", "inside no hole"),
        ("1 1.5 1.5", "1 1.5 x", "number", "p.poly, line 22"),
        ("8 8 5 2", "8 8 1 2", "unsupported", "vertex 1 is on 3 segments"),
        ("8 8 5 2", "8 8 8 2", "unsupported", "vertex 5 is on 1 segments"),
        ("8 8 5 2", "8 8 9 2", "schema", "p.poly, line 20: there is no such vertex"),
        ("8 8 5 2", "8 8 -5 2", "schema", "line 20"),
        ("8 8 5 2\n", "", "syntax", "line 20"),
        ("8 2 1 1", "8 3 1 1", "unsupported", "the dimension is 2"),
        ("8 2 1 1", "9 2 1 1", "syntax", "line 12"),
        ("8 2 1 1", "-8 2 1 1", "syntax", "line 2"),
        ("1 0 0  7", "2 0 0  7", "syntax", "line 4: vertices are numbered"),
        ("7 2 2 7", "8 2 2 7", "syntax", "line 10: vertices are numbered"),
        ("7 2 2 7", "7 2 2.5.5 7", "number", "line 10"),
        ("7 2 2 7", "7 5 12 7", "edges-cross", "cross"),
        ("6 2 1 7 2\n7 2 2 7 2", "6 2 1 7 2\n7 1 1 7 2", "repeated-vertex", "same point"),
        ("1 1.5 1.5\n", "1 1.5 1.5\n0\n0\n", "syntax", "more lines"),
        (FRAME, "", "syntax", "ends before"),
        (FRAME, "0 2 0 0\n0 0\n0\n", "schema", "p.node"),
    ],
)
def test_what_is_no_polygon_is_refused(
    tmp_path: Path, old: str, new: str, kind: str, match: str
) -> None:
    assert old in FRAME
    with pytest.raises(InputError, match=match) as refusal:
        load(tmp_path, FRAME.replace(old, new, 1))
    assert refusal.value.kind == kind


@pytest.mark.parametrize("seed", range(3))
def test_polygons_come_back(tmp_path: Path, seed: int) -> None:
    ring = [coordinates(p) for p in polygon_of(star(15, seed)).points]
    big = 2 * max(abs(c) for pair in ring for c in pair)
    outer = [(-big, -big), (big, -big), (big, big), (-big, big)]
    small = [(big * 3 / 4, 0), (big * 7 / 8, 1), (big * 3 / 4, 3)]
    polygon = polygon_of([outer, ring, small])
    text, rounded = dumps_polygon(polygon)
    assert rounded == 0
    assert load(tmp_path, text, binary64=True) == polygon


def test_rounded_coordinates_are_counted(tmp_path: Path) -> None:
    text, rounded = dumps_polygon(polygon_of([(0, 0), ("1/3", 0), ("1/3", "0.1")]))
    assert rounded == 3
    assert load(tmp_path, text, binary64=True).points[1][2] == 2**54


@settings(max_examples=100, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.data())
def test_no_text_raises_anything_but_refusals(tmp_path: Path, data: st.DataObject) -> None:
    lines = FRAME.splitlines()
    for _ in range(data.draw(st.integers(1, 2))):
        at = data.draw(st.integers(0, len(lines) - 1))
        words = lines[at].split() or ["0"]
        word = st.sampled_from(["", "0", "-1", "1", "9", "2.5", "x", "99999999999999999999"])
        words[data.draw(st.integers(0, len(words) - 1))] = data.draw(word)
        lines[at] = " ".join(words)
    try:
        load(tmp_path, "\n".join(lines))
    except InputError as error:
        assert error.message


# ---------------------------------------------------------------- meshes

NODE = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n"
ELE = "2 3 1\n1 1 2 3 5.5\n2 1 3 4 6\n"
POLY = "0 2 0 0\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n"


def write(folder: Path, stem: str = "m", node: str = NODE, ele: str = ELE) -> None:
    (folder / f"{stem}.node").write_text(node)
    (folder / f"{stem}.ele").write_text(ele)


@pytest.mark.parametrize("stem", ["m", "m.1", "m.x.2"])
@pytest.mark.parametrize("suffix", [".node", ".ele", ".poly"])
def test_either_file_is_named(tmp_path: Path, stem: str, suffix: str) -> None:
    write(tmp_path, stem)
    (tmp_path / f"{stem}.poly").write_text(POLY)
    found, polygon = read_array_mesh_file(tmp_path / f"{stem}{suffix}")
    assert found.triangles.tolist() == [[0, 1, 2], [0, 2, 3]]
    assert found.points.doubles.tolist() == [[0, 0], [1, 0], [1, 1], [0, 1]]
    assert (polygon is not None) == (suffix == ".poly")


def test_the_user_s_polygon_makes_the_poly_s_needless(tmp_path: Path) -> None:
    write(tmp_path)
    (tmp_path / "m.poly").write_text("no polygon")
    found, polygon = read_array_mesh_file(tmp_path / "m.poly", polygon_path=tmp_path / "other.json")
    assert (len(found.triangles), polygon) == (2, None)


def test_vertices_are_numbered_from_0_or_1(tmp_path: Path) -> None:
    write(tmp_path, node="2 2 0 0\n0 0 0\n1 1 0\n", ele="1 3 0\n0 0 1 2\n")
    assert read_array_mesh_file(tmp_path / "m.ele")[0].triangles.tolist() == [[0, 1, 2]]
    write(tmp_path, node="2 2 0 0\n1 0 0\n2 1 0\n", ele="1 3 0\n0 0 1 2\n")
    assert read_array_mesh_file(tmp_path / "m.ele")[0].triangles.tolist() == [[-1, 0, 1]]


def test_upper_case_suffixes_stand_together(tmp_path: Path) -> None:
    (tmp_path / "M.NODE").write_text(NODE)
    (tmp_path / "M.ELE").write_text(ELE)
    assert len(read_array_mesh_file(tmp_path / "M.ELE")[0].triangles) == 2


@pytest.mark.parametrize(
    ("node", "ele", "kind", "match"),
    [
        (NODE, ELE.replace("2 3 1", "2 6 1"), "unsupported", "m.ele, line 1: triangles of 3 nodes"),
        (
            NODE,
            ELE.replace("2 3 1", "3 3 1"),
            "syntax",
            "m.ele, line 3: the file ends after 2 of 3",
        ),
        (NODE, ELE.replace("2 3 1", "1 3 1"), "syntax", "m.ele, line 3: there are more lines"),
        (NODE, ELE.replace("1 3 4 6", "1 3"), "syntax", "m.ele, line 3"),
        (NODE, ELE.replace("1 3 4 6", "1 3 4.0 6"), "syntax", "m.ele, line 3"),
        (NODE.replace("3 1 1", "3 1 inf"), ELE, "number", "m.node, line 4"),
        (NODE.replace("3 1 1", "3 1 1.5D+00"), ELE, "number", "m.node, line 4"),
        (NODE.replace("3 1 1", "3 1 1_0"), ELE, "number", "m.node, line 4"),
        ("", ELE, "syntax", "m.node, line 1"),
        (NODE, "\0", "syntax", "m.ele, line 1"),
    ],
)
def test_malformed_files_are_refused(
    tmp_path: Path, node: str, ele: str, kind: str, match: str
) -> None:
    write(tmp_path, node=node, ele=ele)
    with pytest.raises(InputError, match=match) as refusal:
        read_array_mesh_file(tmp_path / "m.node")
    assert refusal.value.kind == kind
    assert set(refusal.value.where) == {"file", "line"}


def test_the_other_file_must_be_there(tmp_path: Path) -> None:
    (tmp_path / "m.node").write_text(NODE)
    with pytest.raises(InputError, match="m.node needs m.ele beside it"):
        read_array_mesh_file(tmp_path / "m.node")
