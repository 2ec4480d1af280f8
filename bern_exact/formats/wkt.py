"""Well-known text: `POLYGON ((x y, ...), (x y, ...))`, read and written.

Rings are closed by repeating their first point, which is left out of the polygon.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from gmpy2 import mpq

from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import parse_rational, shown
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.formats.doubles import Rounding
from bern_exact.formats.token_text import read_bytes
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings

_WORD = re.compile(r"[(),;=]|[^\s(),;=]+")


def load_polygon(source: Path, /, *, binary64: bool) -> Polygon:
    """The polygon in a file of well-known text.

    Raises
    ------
    InputError
        As `loads_polygon`; kind `syntax`: not UTF-8, or too long.
    OSError
        The file cannot be read.
    """
    data = read_bytes(source)
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        message = f"line {line}: the file is not UTF-8 (byte {error.start})"
        raise InputError("syntax", message, {"line": line, "byte": error.start}) from None
    return loads_polygon(text, binary64=binary64)


def loads_polygon(text: str, *, binary64: bool = False) -> Polygon:
    """The polygon of a well-known text.

    Raises
    ------
    InputError
        With the line.  Kind `unsupported`: another geometry, an SRID, a third coordinate, `EMPTY`;
        `schema`: a ring is not closed; `syntax`; `number`; or the kinds of `polygon_from_rings`.

    Examples
    --------
    >>> loads_polygon("POLYGON ((0 0, 4 0, 0 0.5, 0 0))").area
    mpq(1,1)
    """
    return _Reader(text, binary64).polygon()


class _Reader:
    """The words of a text, one after the other."""

    def __init__(self, text: str, binary64: bool) -> None:
        self.text, self.binary64 = text, binary64
        self.words = [(match.group(), match.start()) for match in _WORD.finditer(text)]
        self.at = 0

    def polygon(self) -> Polygon:
        """All of the text."""
        self._header()
        rings = [self._ring()]
        while self._is_next(","):
            rings.append(self._ring())
        self._expect(")")
        if self.at < len(self.words):
            raise self._refuse("syntax", f"the text goes on after its end: {self._shown()}")
        return polygon_from_rings(rings)

    def _header(self) -> None:
        """`POLYGON (`, and nothing else."""
        word = self._word().upper()
        if word == "SRID":
            raise self._refuse("unsupported", "an SRID is not read: coordinates are plain numbers")
        if word in ("POLYGONZ", "POLYGONM", "POLYGONZM"):
            raise self._refuse("unsupported", f"{word} is not read: two coordinates a point are")
        if word != "POLYGON":
            kind = "unsupported" if word.isalpha() else "syntax"
            raise self._refuse(kind, f"POLYGON is expected, not {self._shown()}")
        self.at += 1
        word = self._word().upper()
        if word == "EMPTY":
            raise self._refuse("unsupported", "an empty polygon has no triangulation")
        if word in ("Z", "M", "ZM"):
            raise self._refuse("unsupported", f"POLYGON {word} is not read: two coordinates are")
        self._expect("(")

    def _ring(self) -> list[HPoint]:
        """`(x y, ..., x y)`, the last point left out."""
        begun = self.at
        self._expect("(")
        ring = [self._point()]
        while self._is_next(","):
            ring.append(self._point())
        self._expect(")")
        if len(ring) < 2 or ring[0] != ring[-1]:
            self.at = begun
            raise self._refuse("schema", "the ring is not closed: its last point is not its first")
        return ring[:-1]

    def _point(self) -> HPoint:
        """`x y`."""
        x, y = self._number(), self._number()
        if self._word() not in (",", ")"):
            self._number()  # what is no number is refused as such
            self.at -= 1
            raise self._refuse("unsupported", "a point has more than two coordinates")
        return hpoint(x, y)

    def _number(self) -> mpq:
        try:
            number = parse_rational(self._word(), binary64=self.binary64)
        except InputError as error:
            raise self._refuse(error.kind, error.message) from None
        self.at += 1
        return number

    def _word(self) -> str:
        if self.at >= len(self.words):
            raise self._refuse("syntax", "the text ends too early")
        return self.words[self.at][0]

    def _is_next(self, word: str) -> bool:
        """Is this the next word?  Then it is passed."""
        found = self._word() == word
        self.at += found
        return found

    def _expect(self, word: str) -> None:
        if not self._is_next(word):
            raise self._refuse("syntax", f"{word!r} is expected, not {self._shown()}")

    def _shown(self) -> str:
        return shown(self._word())

    def _refuse(self, kind: str, message: str) -> InputError:
        """The refusal of the next word, with its line."""
        end = self.words[self.at][1] if self.at < len(self.words) else len(self.text.rstrip())
        line = self.text.count("\n", 0, end) + 1
        return InputError(kind, f"line {line}: {message}", {"line": line})


def dumps_polygon(polygon: Polygon) -> tuple[str, int]:
    """A polygon as well-known text, and the number of coordinates that were rounded to doubles.

    Raises
    ------
    InputError
        Kind `number`: a coordinate is beyond all doubles.

    >>> dumps_polygon(loads_polygon("POLYGON((0 0, 1 0, 0 1/3, 0 0))"))
    ('POLYGON ((0 0, 1 0, 0 0.3333333333333333, 0 0))\\n', 1)
    """
    rounding = Rounding()
    rings = [_ring_text(rounding.pairs(polygon.input_ring(r))) for r in range(len(polygon.rings))]
    return f"POLYGON ({', '.join(rings)})\n", rounding.rounded


def _ring_text(pairs: Sequence[tuple[str, str]]) -> str:
    return f"({', '.join(f'{x} {y}' for x, y in (*pairs, pairs[0]))})"
