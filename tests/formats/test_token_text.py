"""Numbers read in bulk are those that `parse_rational` reads one by one, or refused as it does."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import parse_rational
from bern_exact.exact.points import coordinates
from bern_exact.formats.token_text import TokenText, columns, without_comments
from bern_exact.plane.array_mesh import DoublePoints, ExactPoints, nearest_double
from bern_exact.plane.text_points import TextPoints

signs = st.sampled_from(["", "-", "+"])
digits = st.text("0123456789", min_size=1, max_size=22)
exponents = st.one_of(
    st.just(""), st.builds("e{}{}".format, signs, st.integers(0, 400)), st.just("E-9999")
)
numbers = st.one_of(
    st.builds("{}{}".format, signs, digits),
    st.builds("{}{}.{}{}".format, signs, digits, digits, exponents),
    st.builds("{}.{}{}".format, signs, digits, exponents),
    st.builds("{}{}.".format, signs, digits),
    st.floats(allow_nan=False, allow_infinity=False).map(repr),
    st.sampled_from(["0", "-0", "0.0e0", "1/3", "-4/6", "9007199254740993", "1e308", "1e-320"]),
)
junk = st.sampled_from(
    [
        "nan",
        "inf",
        "1e",
        "1.5d3",
        "1_0",
        "0x10",
        "1-2",
        "--1",
        ".",
        "1e10001",
        "1/0",
        "\u0663",
        "e5",
    ]
)


def both(text: TokenText, binary64: bool) -> list[mpq]:
    """The coordinates of the points whose words are all of a text."""
    points = text.points(np.arange(len(text)).reshape(-1, 2), binary64=binary64)
    return [c for v in range(len(points)) for c in coordinates(points.point(v))]


@settings(max_examples=300)
@given(st.lists(st.tuples(numbers, numbers), min_size=1, max_size=5), st.booleans())
def test_points_are_what_each_number_is(pairs: list[tuple[str, str]], binary64: bool) -> None:
    text = TokenText("\n".join(" ".join(pair) for pair in pairs).encode())
    try:
        wanted = [parse_rational(word, binary64=binary64) for pair in pairs for word in pair]
    except InputError:
        with pytest.raises(InputError):
            both(text, binary64)
        return
    assert both(text, binary64) == wanted


@settings(max_examples=200)
@given(st.lists(st.tuples(numbers, numbers), min_size=1, max_size=5))
def test_doubles_are_the_nearest_ones(pairs: list[tuple[str, str]]) -> None:
    text = TokenText("\n".join(" ".join(pair) for pair in pairs).encode())
    points = text.points(np.arange(len(text)).reshape(-1, 2), binary64=False)
    exact = [parse_rational(word) for pair in pairs for word in pair]
    nearest = [nearest_double(q.numerator, q.denominator) for q in exact]
    assert points.doubles.ravel().tolist() == nearest
    zeros = [q == 0 for q in exact]
    if isinstance(points, TextPoints):
        assert [x == 0 for x in nearest] == zeros


@given(st.lists(numbers, min_size=1, max_size=3), junk, st.booleans())
def test_what_is_no_number_is_refused_with_its_line(
    before: list[str], bad: str, binary64: bool
) -> None:
    lines = [f"{word} 1" for word in before if parse_or_none(word, binary64)]
    text = TokenText("\n".join([*lines, f"{bad} 2", "5 oops"]).encode("utf-8"))
    with pytest.raises(InputError) as refusal:
        both(text, binary64)
    assert (refusal.value.kind, refusal.value.where) == ("number", {"line": len(lines) + 1})


def parse_or_none(word: str, binary64: bool) -> bool:
    try:
        parse_rational(word, binary64=binary64)
    except InputError:
        return False
    return True


@given(st.lists(st.integers(-(2**70), 2**70), min_size=1, max_size=6))
def test_integers_of_any_size_are_read(values: list[int]) -> None:
    text = TokenText("\t".join(map(str, values)).encode())
    assert text.integers(np.arange(len(values))).tolist() == values


@pytest.mark.parametrize("bad", ["+ 1", "- -", "5 +", "1+ 2", "1. 2", ". 1"])
def test_what_numpy_would_read_as_integers_is_refused(bad: str) -> None:
    with pytest.raises(InputError):
        TokenText(bad.encode()).integers(np.arange(2))


@pytest.mark.parametrize("bad", ["1.0", "1e3", "1-2", "+", "--3", "x", "1/2", "é", "0x1"])
def test_what_is_no_integer_is_refused(bad: str) -> None:
    with pytest.raises(InputError) as refusal:
        TokenText(f"1\n2\n{bad}\n".encode()).integers(np.arange(3))
    assert (refusal.value.kind, refusal.value.where) == ("syntax", {"line": 3})


def test_rows_words_and_lines() -> None:
    text = TokenText(b"\xef a  b\r\n\n\t\n c\n")
    assert (text.row_first.tolist(), text.row_size.tolist()) == ([0, 3], [3, 1])
    assert [text.line(w) for w in range(5)] == [1, 1, 1, 4, 4]
    assert [text.text(w) for w in range(4)] == ["\\xef", "a", "b", "c"]
    assert TokenText(b"").row_first.tolist() == []


def test_chosen_words_alone_are_read() -> None:
    text = TokenText(b"v 1 2 x\nv 3 4 y\n")
    assert text.integers(columns(text.row_first, 1, 2)).tolist() == [[1, 2], [3, 4]]


def test_comments_keep_the_lines() -> None:
    assert without_comments(b"1 # a\n#\n2#") == b"1 \n\n2"


@pytest.mark.parametrize(
    ("text", "binary64", "kind"),
    [
        (b"1 0.1", True, DoublePoints),
        (b"1 0.1", False, TextPoints),
        (b"1 -9007199254740991", False, DoublePoints),
        (b"1 9007199254740992", False, TextPoints),
        (b"1 9007199254740993", True, ExactPoints),
        (b"1 9007199254740993.0", True, DoublePoints),
        (b"1 1e0", False, TextPoints),
        (b"1 1/3", False, ExactPoints),
        (b"1 1e999", False, ExactPoints),
    ],
)
def test_doubles_where_they_are_the_coordinates_texts_elsewhere(
    text: bytes, binary64: bool, kind: type[object]
) -> None:
    assert isinstance(TokenText(text).points(np.array([[0, 1]]), binary64=binary64), kind)


@pytest.mark.parametrize("ends", [b"\n", b"\r\n", b"\r"])
def test_lines_end_as_they_do_anywhere(tmp_path: Path, ends: bytes) -> None:
    path = tmp_path / "a"
    path.write_bytes(b"\xef\xbb\xbf1 # c" + ends + b"2")
    assert TokenText.of_file(path, comments=True).row_first.tolist() == [0, 1]


def test_a_third_coordinate_that_is_tiny_is_not_0() -> None:
    text = TokenText(b"0 -0.0e5\n1e-9000")
    text.check_flat(np.array([0, 1]))
    with pytest.raises(InputError) as refusal:
        text.check_flat(np.array([0, 1, 2]))
    assert (refusal.value.kind, refusal.value.where) == ("unsupported", {"line": 2})
