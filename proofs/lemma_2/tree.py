"""The stored certificate: a tree of boxes for each class of f.

A tree is a word in preorder over 0 (a leaf) and 1 to 4 (x, y, m_e or m_f is halved, the lower half
first), compressed with xz.  The leaves of any well-formed tree tile the root box exactly: each
inner node is halved without a remainder, so nothing else about it has to be trusted.
"""

from __future__ import annotations

import lzma
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from proofs.lemma_2.block import DOWN, UP
from proofs.lemma_2.forms import BITS, ONE

Array = Any

DIRECTORY = Path(__file__).parent / "trees"

DEEPEST = BITS - 2
"""A side may be halved so often that the half of a half is still whole."""


class MalformedTree(Exception):
    """A certificate that is no tree of boxes."""


class Leaves(NamedTuple):
    """The boxes at the leaves.

    Parameters
    ----------
    low, high : int64 arrays, 4 x n
        Their bounds at the scale 2^BITS.
    deepest : int
        The greatest depth of a leaf.
    """

    low: Array
    high: Array
    deepest: int


def stored(name: str, cls: int) -> bytes:
    """The tree of a certificate for a class, uncompressed."""
    return lzma.decompress((DIRECTORY / f"{name}_{cls}.xz").read_bytes()).strip()


def root(cls: int) -> tuple[list[int], list[int]]:
    """The box of all parameters of a class, but for what a mirror image covers."""
    high = [ONE, ONE, ONE, ONE]
    if cls == UP:
        high[0] = ONE // 2
    if cls == DOWN:
        high[1] = ONE // 2
    return [0, 0, -ONE, -ONE], high


def leaves(word: bytes, cls: int) -> Leaves:
    """The leaves of a tree.

    Raises
    ------
    MalformedTree
        If the word is no tree, is too deep, or its leaves do not fill the root box.
    """
    pending = [(*root(cls), 0)]
    lows, highs = [], []
    deepest, filled = 0, 0
    for symbol in word:
        if not pending:
            raise MalformedTree("the word goes on after the last leaf")
        low, high, depth = pending.pop()
        d = symbol - ord("1")
        if d == -1:
            lows.append(low)
            highs.append(high)
            deepest = max(deepest, depth)
            filled += 1 << (4 * BITS - depth)
        elif 0 <= d < 4:
            if high[d] - low[d] <= ONE >> DEEPEST:
                raise MalformedTree("a box is too small")
            middle = (low[d] + high[d]) // 2
            upper, lower = low.copy(), high.copy()
            upper[d] = lower[d] = middle
            pending += [(upper, high, depth + 1), (low, lower, depth + 1)]
        else:
            raise MalformedTree(f"the word has the byte {symbol}")
    if pending:
        raise MalformedTree("the word ends before the last leaf")
    if filled != 1 << (4 * BITS):
        raise MalformedTree("the leaves do not fill the box of all parameters")
    return Leaves(
        np.array(lows, dtype=np.int64).T.copy(), np.array(highs, dtype=np.int64).T.copy(), deepest
    )
