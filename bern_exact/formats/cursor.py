"""A text's words one after the other, for formats that are not made of lines."""

from __future__ import annotations

import numpy as np

from bern_exact.exact.numbers import shown
from bern_exact.formats.token_text import Chosen, TokenText


class Cursor:
    """A place among the words of a text.

    Parameters
    ----------
    text : TokenText
        The text.
    at : int
        The next word.
    """

    def __init__(self, text: TokenText, at: int = 0) -> None:
        self.text, self.at = text, at

    @property
    def at_end(self) -> bool:
        """Is no word left?"""
        return self.at >= len(self.text)

    def word(self, what: str) -> str:
        """The next word, passed.

        Raises
        ------
        InputError
            Kind `syntax`: no word is left.
        """
        if self.at_end:
            raise self.text.refuse("syntax", f"the file ends before {what}", self.at)
        self.at += 1
        return self.text.text(self.at - 1)

    def whole(self, what: str) -> int:
        """The next word, a count, passed.

        Raises
        ------
        InputError
            Kind `syntax`: it is none.
        """
        found = self.text.whole(self.at, what)
        self.at += 1
        return found

    def expect(self, word: str) -> None:
        """Pass this word, in any case of letters.

        Raises
        ------
        InputError
            Kind `syntax`: it is another.
        """
        found = self.word(word)
        if found.upper() != word.upper():
            message = f"{word} is expected, not {shown(found)}"
            raise self.text.refuse("syntax", message, self.at - 1)

    def take(self, rows: int, width: int, what: str) -> Chosen:
        """The next words as an array (rows, width), passed.

        Raises
        ------
        InputError
            Kind `syntax`: there are fewer.
        """
        if rows * width > len(self.text) - self.at:
            message = f"the file ends before all of {rows:,} {what} are there"
            raise self.text.refuse("syntax", message, len(self.text))
        taken = np.arange(self.at, self.at + rows * width, dtype=np.int64)
        self.at += rows * width
        return taken.reshape(rows, width)
