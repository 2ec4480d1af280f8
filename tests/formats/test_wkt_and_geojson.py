"""WKT and GeoJSON polygons: read exactly, refused by name, written and read back."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from bern_exact.exact.errors import InputError
from bern_exact.formats import geojson, read_polygon_file, safe_json, wkt
from bern_exact.oracle.api import polygon_of

FRAME = polygon_of([[(0, 0), (9, 0), (9, 9), (0, 9)], [(1, 1), (2, 1), (2, 2), (1, 2)]])
TEXT = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))"


@pytest.mark.parametrize(
    "text",
    [
        TEXT,
        TEXT.lower() + "\n",
        TEXT.replace(" (", "(").replace(", ", ","),
        TEXT.replace(" ", "\r\n\t"),
        TEXT.replace("9 9", "+9.0 90e-1"),
        TEXT.replace("0 0)", "0.0 -0)"),
    ],
)
def test_forms_of_one_polygon(tmp_path: Path, text: str) -> None:
    path = tmp_path / "p.WKT"
    path.write_bytes(b"\xef\xbb\xbf" + text.encode())
    assert read_polygon_file(path) == FRAME


@pytest.mark.parametrize(
    ("text", "kind", "line"),
    [
        ("SRID=4326;" + TEXT, "unsupported", 1),
        (TEXT.replace("POLYGON", "POLYGON Z"), "unsupported", 1),
        (TEXT.replace("POLYGON", "PolygonZM"), "unsupported", 1),
        (TEXT.replace("POLYGON", "MULTIPOLYGON"), "unsupported", 1),
        ("\n\nPOLYGON EMPTY", "unsupported", 3),
        (TEXT.replace("9 9", "9 9 0"), "unsupported", 1),
        (TEXT.replace("0 9, 0 0", "\n0 9"), "schema", 1),
        (TEXT.replace("9 9", "\n9 x"), "number", 2),
        (TEXT.replace("9 9", "\n9 nan"), "number", 2),
        (TEXT.replace("9 9", "\n9"), "number", 2),
        (TEXT[:-1], "syntax", 1),
        (TEXT + ")", "syntax", 1),
        ("", "syntax", 1),
        ("\n{}", "syntax", 2),
        (TEXT.replace("2 2", "8 20"), "edges-cross", None),
        ("POLYGON ((0 0, 1 1, 0 0))", "too-few-vertices", None),
    ],
)
def test_other_texts_are_refused_by_name_and_line(text: str, kind: str, line: int | None) -> None:
    with pytest.raises(InputError) as refusal:
        wkt.loads_polygon(text)
    assert (refusal.value.kind, refusal.value.where.get("line")) == (kind, line)


def test_what_is_not_utf_8_is_refused_with_its_line(tmp_path: Path) -> None:
    path = tmp_path / "p.wkt"
    path.write_bytes(b"POLYGON\n((\xff")
    with pytest.raises(InputError, match="line 2: the file is not UTF-8"):
        read_polygon_file(path)


def test_decimals_are_exact_unless_doubles_are_asked_for() -> None:
    text = "POLYGON((0 0, 0.1 0, 0 1/3, 0 0))"
    assert wkt.loads_polygon(text).area == mpq(1, 60)
    assert wkt.loads_polygon(text, binary64=True).area != mpq(1, 60)


RING = [[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]
POLYGON: dict[str, Any] = {
    "type": "Polygon",
    "coordinates": [RING, [[1, 1], [2, 1], [2, 2], [1, 2], [1, 1]]],
}
FEATURE = {"type": "Feature", "properties": {"name": "frame"}, "geometry": POLYGON}
COLLECTION = {"type": "FeatureCollection", "features": [FEATURE]}


@pytest.mark.parametrize("suffix", [".geojson", ".json"])
@pytest.mark.parametrize("document", [POLYGON, FEATURE, COLLECTION])
def test_a_polygon_alone_in_a_feature_or_in_a_collection(
    tmp_path: Path, suffix: str, document: Any
) -> None:
    path = tmp_path / f"p{suffix}"
    path.write_text(json.dumps(document))
    assert read_polygon_file(path) == FRAME
    assert read_polygon_file(path).name == ("" if document is POLYGON else "frame")


def test_bare_numbers_are_exact_decimals() -> None:
    text = '{"type": "Polygon", "coordinates": [[[0, 0], [0.1, 0, 0], [0, 0.10], [0, 0]]]}'
    assert geojson.read_polygon(safe_json.loads(text)).area == mpq(1, 200)


def of(**changes: Any) -> dict[str, Any]:
    return {**POLYGON, **changes}


@pytest.mark.parametrize(
    ("document", "kind", "path"),
    [
        (of(type="MultiPolygon"), "unsupported", "$.type"),
        (of(type=3), "unsupported", "$.type"),
        ({**FEATURE, "geometry": of(type="Point")}, "unsupported", "$.geometry.type"),
        ({**FEATURE, "geometry": None}, "schema", "$.geometry"),
        ({"type": "FeatureCollection", "features": []}, "unsupported", "$.features"),
        ({"type": "FeatureCollection", "features": [FEATURE] * 2}, "unsupported", "$.features"),
        ({"type": "FeatureCollection", "features": [POLYGON]}, "schema", "$.features[0].type"),
        ({"type": "Polygon"}, "schema", "$"),
        (of(coordinates=[]), "unsupported", "$.coordinates"),
        (of(coordinates=[RING[:-1]]), "schema", "$.coordinates[0]"),
        (of(coordinates=[[]]), "schema", "$.coordinates[0]"),
        (of(coordinates=[[*RING[:2], [9], *RING[3:]]]), "schema", "$.coordinates[0][2]"),
        (
            of(coordinates=[[*RING[:2], [9, 9, 1], *RING[3:]]]),
            "unsupported",
            "$.coordinates[0][2][2]",
        ),
        (of(coordinates=[[*RING[:2], [9, True], *RING[3:]]]), "number", "$.coordinates[0][2][1]"),
        (of(coordinates={}), "schema", "$.coordinates"),
        ([], "schema", "$"),
    ],
)
def test_other_documents_are_refused_with_their_path(document: Any, kind: str, path: str) -> None:
    with pytest.raises(InputError) as refusal:
        geojson.read_polygon(document)
    assert (refusal.value.kind, refusal.value.where) == (kind, {"path": path})


coordinates = st.integers(-(2**60), 2**60).map(lambda k: mpq(k, 2**30))
triangles = st.lists(st.tuples(coordinates, coordinates), min_size=3, max_size=3)


@given(triangles)
def test_doubles_come_back_from_both(ring: list[tuple[mpq, mpq]]) -> None:
    try:
        polygon = polygon_of(ring)
    except InputError:
        return
    text, rounded = wkt.dumps_polygon(polygon)
    again = wkt.loads_polygon(text, binary64=True)
    assert again == polygon or rounded
    text, same = geojson.dumps_polygon(polygon)
    assert same == rounded
    found = geojson.read_polygon(safe_json.loads(text), binary64=True)
    assert found.area == again.area


def test_holes_and_names_come_back() -> None:
    named = geojson.read_polygon(FEATURE)
    text, rounded = geojson.dumps_polygon(named)
    found = geojson.read_polygon(safe_json.loads(text))
    assert (found.area, found.name, rounded) == (FRAME.area, "frame", 0)
    assert json.loads(text)["geometry"]["coordinates"][0] == RING
    assert wkt.loads_polygon(wkt.dumps_polygon(FRAME)[0]) == FRAME


@settings(max_examples=200)
@given(
    st.integers(0, len(TEXT)),
    st.integers(0, 4),
    st.text("POLYGNZ(),;= \n0123456789.-e/", max_size=4),
)
def test_no_text_raises_anything_but_refusals(at: int, cut: int, piece: str) -> None:
    try:
        wkt.loads_polygon(TEXT[:at] + piece + TEXT[at + cut :])
    except InputError as error:
        assert error.message
