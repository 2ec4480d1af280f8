"""Mesh files: read without judgement, refused with the place, written the same always."""

from __future__ import annotations

import io
import json
from importlib import resources
from typing import Any

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st
from jsonschema import Draft202012Validator

from bern_exact.exact.errors import INPUT_ERROR_KINDS, InputError
from bern_exact.exact.points import coordinates, hpoint
from bern_exact.formats.mesh_json import (
    dumps_mesh,
    load_array_mesh,
    load_mesh,
    mesh_document,
    read_array_mesh,
    read_mesh,
)
from bern_exact.formats.polygon_json import read_polygon
from bern_exact.oracle import judge
from bern_exact.oracle.fast import verify_mesh
from bern_exact.plane.mesh import Mesh
from tests.formats.test_polygon_json import json_values
from tests.rationals import fractions

OUTER = [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"]]
SQUARE: dict[str, Any] = {
    "format": "bern-exact/mesh",
    "version": 1,
    "vertices": [*OUTER, ["1/2", "7/3"]],
    "triangles": [[0, 1, 2], [0, 2, 3]],
    "polygon": {
        "format": "bern-exact/polygon",
        "version": 1,
        "name": "square",
        "outer": OUTER,
        "holes": [],
    },
}

rationals = fractions.map(lambda q: mpq(q.numerator, q.denominator))
meshes = st.builds(
    Mesh,
    st.lists(st.builds(hpoint, rationals, rationals), max_size=6).map(tuple),
    st.lists(st.tuples(*[st.integers()] * 3), max_size=6).map(tuple),
)


def schema_of(name: str) -> dict[str, Any]:
    text = resources.files("bern_exact").joinpath(f"schemas/{name}.schema.json").read_text()
    loaded: dict[str, Any] = json.loads(text)
    Draft202012Validator.check_schema(loaded)
    return loaded


@pytest.fixture(scope="module")
def schema() -> Draft202012Validator:
    return Draft202012Validator(schema_of("mesh"))


def but(**changes: Any) -> dict[str, Any]:
    """The square, changed."""
    return {**SQUARE, **changes}


def test_the_square_and_its_polygon() -> None:
    mesh, polygon = read_mesh(SQUARE)
    assert mesh.triangles == ((0, 1, 2), (0, 2, 3))
    assert coordinates(mesh.vertices[4]) == (mpq(1, 2), mpq(7, 3))
    assert polygon == read_polygon(SQUARE["polygon"])


def test_what_is_written_is_what_was_read() -> None:
    assert mesh_document(*read_mesh(SQUARE)) == SQUARE


@given(meshes)
def test_any_mesh_is_written_and_read_back(mesh: Mesh) -> None:
    text = dumps_mesh(mesh)
    assert load_mesh(io.StringIO(text)) == (mesh, None)
    assert load_array_mesh(io.StringIO(text))[0].mesh == mesh


def test_written_documents_follow_the_schema(schema: Draft202012Validator) -> None:
    written = dumps_mesh(*read_mesh(SQUARE), {"theorem": 1})
    schema.validate(json.loads(written))
    schema.validate(json.loads(dumps_mesh(Mesh((), ()))))


def test_the_schema_holds_that_of_polygons() -> None:
    polygon, definitions = schema_of("polygon"), schema_of("mesh")["$defs"]
    held = {**definitions.pop("polygon"), "$defs": definitions}
    assert held == {key: value for key, value in polygon.items() if key not in ("$schema", "$id")}


def test_the_layout_is_one_vertex_and_one_triangle_a_line() -> None:
    lines = dumps_mesh(read_mesh(SQUARE)[0]).splitlines()
    assert lines[:5] == [
        "{",
        ' "format": "bern-exact/mesh",',
        ' "version": 1,',
        ' "vertices": [',
        '  ["0", "0"],',
    ]
    assert lines[-4:] == ["  [0, 1, 2],", "  [0, 2, 3]", " ]", "}"]


@pytest.mark.parametrize(
    "triangles",
    [[[0, 1, 99]], [[-1, 0, 1]], [[0, 0, 0]], [[2, 1, 0]], [[10**500, 0, 1]], [[0, 1, 2]] * 2, []],
)
def test_what_a_judge_finds_is_read(triangles: list[list[int]], schema: Any) -> None:
    document = but(triangles=triangles)
    schema.validate(document)
    assert read_mesh(document)[0].triangles == tuple(map(tuple, triangles))


@pytest.mark.parametrize("digits", [900, 5_000, 50_000])
def test_an_index_of_any_length_is_read_and_judged(digits: int) -> None:
    text = '{"vertices": [[0, 0], [1, 0], [0, 1]], "triangles": [[0, 1, -%s]]}' % ("7" * digits)
    mesh, _ = load_mesh(io.StringIO(text))
    (defect,) = [d for d in verify_mesh(mesh, None).defects if d.kind == "index-out-of-range"]
    assert defect.witness == {"index": "-" + "7" * digits}


def test_duplicate_and_missing_vertices_are_read() -> None:
    assert len(read_mesh(but(vertices=[["0", "0"]] * 3))[0].vertices) == 3
    assert read_mesh(but(vertices=[]))[0].vertices == ()


def test_binary64_reads_vertices_and_polygon() -> None:
    text = '{"format": "bern-exact/mesh", "version": 1, "vertices": [[0.1, 0]], "triangles": [], '
    text += '"polygon": {"outer": [[0, 0], [0.1, 0], [0, 1]]}}'
    mesh, polygon = load_mesh(io.StringIO(text), binary64=True)
    assert polygon is not None
    tenth = mpq(*(0.1).as_integer_ratio())
    assert (coordinates(mesh.vertices[0])[0], coordinates(polygon.points[1])[0]) == (tenth, tenth)
    in_arrays, same = load_array_mesh(io.StringIO(text), binary64=True)
    assert (in_arrays.mesh, same, in_arrays.points.exact) == (mesh, polygon, True)


REFUSED: list[tuple[str, str, str]] = [
    ("3", "schema", "$"),
    ("{}", "schema", "$"),
    ('{"format": "bern-exact/polygon", "version": 1}', "unsupported", "$.format"),
    ('{"format": "bern-exact/mesh", "version": 7}', "unsupported", "$.version"),
    ('{"format": "bern-exact/mesh"}', "schema", "$"),
    ('{"format": "bern-exact/mesh", "version": 1}', "schema", "$"),
]
BAD_TRIANGLES = [
    ("null", "schema", ""),
    ("{}", "schema", ""),
    ("[3]", "schema", "[0]"),
    ("[[0, 1]]", "schema", "[0]"),
    ("[[0, 1, 2], [0, 1, 2, 3]]", "schema", "[1]"),
    ('[[0, 1, "2"]]', "schema", "[0][2]"),
    ('["012"]', "schema", "[0]"),
    ("[[0, true, 2]]", "schema", "[0][1]"),
    ("[[0, null, 2]]", "schema", "[0][1]"),
    ("[[0, 1.0, 2]]", "number", "[0][1]"),
    ("[[0, 1e999999999, 2]]", "number", "[0][1]"),
    (f"[[{'9' * 100_001}, 1, 2]]", "number", "[0][0]"),
]
START = '{"format": "bern-exact/mesh", "version": 1, "vertices": [], "triangles": '
REFUSED += [(f"{START}{text}}}", kind, f"$.triangles{path}") for text, kind, path in BAD_TRIANGLES]
REFUSED += [
    (f'{START}[], "polygon": {text}}}', kind, f"$.polygon{path}")
    for text, kind, path in [
        ("5", "schema", ""),
        ("{}", "schema", ""),
        ('{"outer": [[0, 0], [1, 0], [0, "a"]]}', "number", ".outer[2][1]"),
        ('{"outer": [], "version": 2}', "unsupported", ".version"),
    ]
]
START = START.replace('"vertices": [], "triangles"', '"triangles": [], "vertices"')
REFUSED += [
    (f"{START}null}}", "schema", "$.vertices"),
    (f"{START}[[0, 0], [1]]}}", "schema", "$.vertices[1]"),
    (f'{START}[[0, 0], [1, "1/0"]]}}', "number", "$.vertices[1][1]"),
]


@pytest.mark.parametrize(("text", "kind", "path"), REFUSED)
def test_what_is_no_mesh_document_is_refused_with_its_path(text: str, kind: str, path: str) -> None:
    with pytest.raises(InputError) as refusal:
        load_mesh(io.StringIO(text))
    assert (refusal.value.kind, refusal.value.where) == (kind, {"path": path})
    with pytest.raises(InputError) as again:
        load_array_mesh(io.StringIO(text))
    assert again.value.to_json() == refusal.value.to_json()


FORMS: list[tuple[dict[str, Any], bool]] = [
    ({}, True),
    ({"version": 1}, True),
    ({"format": "bern-exact/mesh", "version": 1}, True),
    ({"format": "bern-exact/mesh"}, False),
    ({"format": "bern-exact/mesh", "version": True}, False),
    ({"format": "bern-exact/mesh", "version": 2}, False),
    ({"format": "bern-exact/polygon", "version": 1}, False),
    ({"format": None, "version": 1}, False),
    ({"version": 2}, False),
    ({"version": "1"}, False),
]


@pytest.mark.parametrize(("head", "is_read"), FORMS)
def test_a_bare_mesh_is_read_and_another_format_refused_also_by_the_lone_judge(
    head: dict[str, Any], is_read: bool
) -> None:
    document = head | {"vertices": [[0, 0], [1, 0], [0, 1]], "triangles": [[0, 1, 2]]}
    if is_read:
        assert read_mesh(document)[0].triangles == ((0, 1, 2),)
        assert judge.judge(document)["valid"]
    else:
        with pytest.raises(InputError):
            read_mesh(document)
        with pytest.raises(judge.Unreadable):
            judge.judge(document)


@given(json_values)
def test_any_json_value_is_read_or_refused(value: Any) -> None:
    check_refusal(value)


@given(st.sampled_from(sorted(SQUARE)), json_values)
def test_the_square_with_any_member_replaced_is_read_or_refused(key: str, value: Any) -> None:
    check_refusal(but(**{key: value}))


@given(st.lists(st.lists(json_values, max_size=4), max_size=3))
def test_any_triangles_are_read_or_refused(triangles: Any) -> None:
    check_refusal(but(triangles=triangles))


def check_refusal(document: Any) -> None:
    """The document is read, or refused in a way that can be printed as JSON; in arrays alike."""
    for binary64 in (False, True):
        try:
            mesh, polygon = read_mesh(document, binary64=binary64)
        except InputError as error:
            assert error.kind in INPUT_ERROR_KINDS
            json.dumps(error.to_json(), allow_nan=False).encode()
            with pytest.raises(InputError) as refusal:
                read_array_mesh(document, binary64=binary64)
            assert refusal.value.to_json() == error.to_json()
        else:
            array_mesh, same = read_array_mesh(document, binary64=binary64)
            assert (array_mesh.mesh, same) == (mesh, polygon)
