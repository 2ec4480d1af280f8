"""Text files of millions of numbers: their words found, and their numbers read, in bulk.

A word is what stands between white space.  numpy finds where words and lines begin, and reads the
words that a format says are numbers all at once; nothing is believed that it read of a text which
is more than digits, signs, points and exponents, or where it found another number of numbers than
there are words.  Then, and for exponents and integers that doubles do not hold, the words are
looked at one by one: exactly, slowly, and with the line at fault.
"""

from __future__ import annotations

import codecs
import os
import re
import warnings
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, overload

import numpy as np
from gmpy2 import mpq, mpz
from numpy.typing import NDArray

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import parse_rational, shown
from bern_exact.exact.points import hpoint
from bern_exact.formats.safe_json import MAX_BYTES
from bern_exact.plane.array_mesh import DoublePoints, Doubles, ExactPoints, Indices, Points
from bern_exact.plane.text_points import TextPoints

Chosen = NDArray[np.int64]
"""Numbers of words, ascending."""

_BLANKS = b" \t\r\n\v\f"
_DIGITS = b"0123456789+-"
_IS_BLANK = np.isin(np.arange(256), np.frombuffer(_BLANKS, dtype=np.uint8))

_ENDS_NUMBER = np.isin(np.arange(256), np.frombuffer(b"0123456789.", dtype=np.uint8))

_LONGEST_INT64 = 18
"""Integers of so many characters are below 2^63."""

_LONGEST_DOUBLE = 300
"""Words of so many characters, without an exponent, are 0 or neither huge nor tiny."""

_WHOLE = re.compile(r"[+-]?[0-9]{1,1000}")
_ZERO = re.compile(rb"[+-]?(?:0+\.?0*|\.0+)(?:[eE][+-]?0*[0-9]{1,4})?")
_LEAST_INEXACT = 2**53
_COMMENT = re.compile(rb"#[^\n]*")


def read_bytes(path: str | os.PathLike[str]) -> bytes:
    """All of a file, without a byte order mark of UTF-8; a CR ends a line where no LF does.

    Raises
    ------
    InputError
        Kind `syntax`: longer than `MAX_BYTES`.
    OSError
        The file cannot be read.
    """
    with open(path, "rb") as stream:
        data = stream.read(MAX_BYTES + 1)
    if len(data) > MAX_BYTES:
        raise InputError("syntax", f"the file is longer than {MAX_BYTES:,} bytes")
    data = data.removeprefix(codecs.BOM_UTF8)
    return data if b"\n" in data else data.replace(b"\r", b"\n")


def without_comments(data: bytes) -> bytes:
    """The text without what stands from a `#` to the end of its line.

    >>> without_comments(b"1 2 # three\\n4")
    b'1 2 \\n4'
    """
    return _COMMENT.sub(b"", data) if b"#" in data else data


def columns(first: Chosen, *offsets: int) -> Chosen:
    """The words so far after the first words of rows: an array (rows, offsets)."""
    return first[:, None] + np.array(offsets, dtype=np.int64)


@dataclass(frozen=True)
class TokenText:
    """A text and its words.

    Parameters
    ----------
    data : bytes
        Any bytes at all.
    name : str
        Put before the line's number in messages, where several files are read.
    first_line : int
        The number of the first line.
    """

    data: bytes
    name: str = ""
    first_line: int = 1

    @staticmethod
    def of_file(path: Path, *, comments: bool = False, name: str = "") -> TokenText:
        """The words of a file; with `comments`, what follows a `#` is left out."""
        data = read_bytes(path)
        return TokenText(without_comments(data) if comments else data, name)

    # ------------------------------------------------------------------ where words are

    @cached_property
    def _bytes(self) -> NDArray[np.uint8]:
        return np.frombuffer(self.data, dtype=np.uint8)

    @cached_property
    def _bounds(self) -> tuple[Chosen, Chosen]:
        """Where each word begins and ends."""
        solid = np.zeros(len(self.data) + 2, dtype=bool)
        np.logical_not(_IS_BLANK[self._bytes], out=solid[1:-1])
        changes = np.flatnonzero(solid[1:] != solid[:-1])
        return changes[0::2], changes[1::2]

    @property
    def starts(self) -> Chosen:
        """Where each word begins."""
        return self._bounds[0]

    @property
    def ends(self) -> Chosen:
        """Where each word ends."""
        return self._bounds[1]

    def __len__(self) -> int:
        return len(self.starts)

    @cached_property
    def _newlines(self) -> Chosen:
        return np.flatnonzero(self._bytes == ord("\n"))

    @cached_property
    def _rows(self) -> tuple[Chosen, Chosen]:
        """The first word of each line that has words, and how many it has."""
        before = np.searchsorted(self.starts, self._newlines)
        first = np.concatenate(([0], before, [len(self)]))
        size = np.diff(first)
        held = np.flatnonzero(size)
        return first[held], size[held]

    @property
    def row_first(self) -> Chosen:
        """The first word of each line that is not blank."""
        return self._rows[0]

    @property
    def row_size(self) -> Chosen:
        """The number of words of each line that is not blank."""
        return self._rows[1]

    # ------------------------------------------------------------------ a word

    def raw(self, word: int) -> bytes:
        """The bytes of a word."""
        return self.data[self.starts[word] : self.ends[word]]

    def text(self, word: int) -> str:
        """A word; what is not ASCII in it is escaped, and no number then."""
        return self.raw(word).decode("ascii", "backslashreplace")

    def line(self, word: int) -> int:
        """The number of the line in which a word stands; past the last word, the last line."""
        if word >= len(self):
            return len(self._newlines) + (not self.data.endswith(b"\n")) + self.first_line - 1
        return bisect_right(self._newlines, self.starts[word]) + self.first_line

    def refuse(self, kind: str, message: str, word: int) -> InputError:
        """The refusal of a word, or of the file's end if there is no such word."""
        line = self.line(word)
        where: dict[str, Any] = {"line": line}
        if self.name:
            where["file"] = self.name
        return InputError(kind, f"{self.name}{', ' * bool(self.name)}line {line}: {message}", where)

    def whole(self, word: int, what: str, *, least: int = 0) -> int:
        """A small integer, such as a count."""
        if word >= len(self):
            raise self.refuse("syntax", f"the file ends before {what}", word)
        text = self.text(word)
        if not _WHOLE.fullmatch(text) or int(text) < least:
            raise self.refuse("syntax", f"{what} is expected, not {shown(text)}", word)
        return int(text)

    # ------------------------------------------------------------------ numbers in bulk

    def _alone(self, chosen: Chosen, alphabet: bytes) -> bytes | None:
        """A text of the chosen words alone; None if some have characters of no number, or end so.

        (numpy reads a sign alone as the integer 0.)
        """
        if not _ENDS_NUMBER[self._bytes[self.ends[chosen] - 1]].all():
            return None
        begin, end = int(self.starts[chosen[0]]), int(self.ends[chosen[-1]])
        if chosen[-1] - chosen[0] + 1 == len(chosen):
            text = self.data[begin:end]
        else:
            change = np.zeros(end - begin + 1, dtype=np.int8)
            change[self.starts[chosen] - begin] = 1
            change[self.ends[chosen] - begin] = -1
            inside = np.cumsum(change[:-1], dtype=np.int8).view(bool)
            text = np.where(inside, self._bytes[begin:end], np.uint8(32)).tobytes()
        return None if text.translate(None, alphabet + _BLANKS) else text

    def integers(self, chosen: Chosen) -> Indices:
        """The integers that the chosen words are, in the same shape.

        Raises
        ------
        InputError
            Kind `syntax`: a word is no integer; `number`: one of more than 1,000 digits.
        """
        flat = chosen.reshape(-1)
        if len(flat) == 0:
            return np.empty(chosen.shape, dtype=np.int64)
        longest = int((self.ends[flat] - self.starts[flat]).max())
        text = self._alone(flat, _DIGITS) if longest <= _LONGEST_INT64 else None
        found = None if text is None else _scanned(text, np.int64, len(flat))
        if found is None:
            found = np.array([self._integer(w) for w in flat.tolist()], dtype=object)
            if all(-(2**63) <= v < 2**63 for v in found.tolist()):
                found = found.astype(np.int64)
        return found.reshape(chosen.shape)

    def _integer(self, word: int) -> int:
        """An integer of any size."""
        text = self.text(word)
        if not _WHOLE.fullmatch(text):
            kind, why = "syntax", "is not an integer"
            if re.fullmatch(r"[+-]?[0-9]+", text):
                kind, why = "number", "is too long for an index"
            raise self.refuse(kind, f"{shown(text)} {why}", word)
        return int(mpz(text.lstrip("+")))

    def _doubles(self, flat: Chosen) -> tuple[Doubles, bool] | None:
        """The doubles nearest to decimals, and whether all are integers that doubles hold.

        None if some are huge, tiny or no decimals.
        """
        if len(flat) == 0:
            return np.empty(0), True
        text = self._alone(flat, _DIGITS + b".eE")
        found = None if text is None else _scanned(text, np.float64, len(flat))
        if found is None or text is None or not np.isfinite(found).all():
            return None
        lengths = self.ends[flat] - self.starts[flat]
        if int(lengths.max()) > _LONGEST_DOUBLE:
            return None
        exponents = b"e" in text or b"E" in text
        if exponents:  # 1e-999 is not 0, and 1e-99999 is refused
            zeros = flat[(found == 0) & (lengths > 1)]
            if not all(_ZERO.fullmatch(self.raw(w)) for w in zeros.tolist()):
                return None
        found += 0  # -0 becomes 0
        whole = not exponents and b"." not in text
        return found, whole and bool(np.all(np.abs(found) < _LEAST_INEXACT))

    def points(self, chosen: Chosen, *, binary64: bool) -> Points:
        """The points whose coordinates the chosen words, (V, 2), are.

        Raises
        ------
        InputError
            Kind `number`, with the line: a word that `parse_rational` does not read.
        """
        flat = chosen.reshape(-1)
        found = self._doubles(flat)
        if found is None or (binary64 and self._has_long_integers(flat, found[0])):
            pairs = [[self._rational(w, binary64) for w in pair] for pair in chosen.tolist()]
            return ExactPoints([hpoint(x, y) for x, y in pairs])
        pairs_of_doubles, whole = found[0].reshape(-1, 2), found[1]
        if binary64 or whole:
            return DoublePoints(pairs_of_doubles)
        texts = _Texts(self.data, self.starts[flat], self.ends[flat])
        return TextPoints(texts, pairs_of_doubles)

    def _has_long_integers(self, flat: Chosen, doubles: Doubles) -> bool:
        """Are there integers, which stay what they are, that may not be doubles?"""
        large = flat[np.abs(doubles) >= _LEAST_INEXACT]
        return any(_WHOLE.fullmatch(self.text(w)) for w in large.tolist())

    def _rational(self, word: int, binary64: bool) -> mpq:
        """One number, exactly."""
        try:
            return parse_rational(self.text(word), binary64=binary64)
        except InputError as error:
            raise self.refuse(error.kind, error.message, word) from None

    def check_flat(self, chosen: Chosen) -> None:
        """Refuse third coordinates other than 0.

        Raises
        ------
        InputError
            Kind `unsupported`: a coordinate is not 0; `number`: one is no number.
        """
        found = self._doubles(chosen)
        bad = range(len(chosen)) if found is None else np.flatnonzero(found[0]).tolist()
        for i in bad:
            if self._rational(int(chosen[i]), False) != 0:
                message = "the mesh is not planar: a third coordinate is not 0"
                raise self.refuse("unsupported", message, int(chosen[i]))


class _Texts(Sequence[str]):
    """Words of a file, decoded when they are asked for."""

    def __init__(self, data: bytes, starts: Chosen, ends: Chosen) -> None:
        self.data, self.starts, self.ends = data, starts, ends

    def __len__(self) -> int:
        return len(self.starts)

    @overload
    def __getitem__(self, index: int) -> str: ...
    @overload
    def __getitem__(self, index: slice) -> _Texts: ...
    def __getitem__(self, index: int | slice) -> str | _Texts:
        if isinstance(index, slice):
            return _Texts(self.data, self.starts[index], self.ends[index])
        return self.data[self.starts[index] : self.ends[index]].decode("ascii")


def _scanned(text: bytes, kind: type[Any], count: int) -> NDArray[Any] | None:
    """The numbers in a text of words, by numpy's scanner; None if it finds more, less or stops."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of what it does not read
        try:
            found = np.fromstring(text, dtype=kind, sep=" ")
        except ValueError:
            return None
    return found if len(found) == count else None
