"""The stored certificate: a tree of boxes for each class of f.

A tree is a word in preorder over 0 (a leaf) and 1 to 4 (x, y, m_e or m_f is halved, the lower half
first), compressed with xz.  The leaves of any well-formed tree tile the root box exactly: each
inner node is halved without a remainder, so nothing else about it has to be trusted.
"""

from __future__ import annotations

import lzma
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from proofs.lemma_2.block import DOWN, UP
from proofs.lemma_2.forms import BITS, ONE

Array = Any

DIRECTORY = Path(__file__).parent / "trees"

LEAF = ord("0")

SMALLEST = 1
"""The length of a side is at least 2^1: its half is whole."""


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


def root(cls: int) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """The box of all parameters of a class, but for what a mirror image covers.

    Its lower bounds, and of each side the length, a power of two.
    """
    lengths = [BITS, BITS, BITS + 1, BITS + 1]
    if cls == UP:
        lengths[0] -= 1
    if cls == DOWN:
        lengths[1] -= 1
    return (0, 0, -ONE, -ONE), tuple(lengths)


def leaves(word: bytes, cls: int) -> Leaves:
    """The leaves of a tree.

    Raises
    ------
    MalformedTree
        If the word is no tree, is too deep, or its leaves do not fill the root box.
    """
    bottom, lengths = root(cls)
    found = np.array(list(_packed_leaves(word, lengths)), dtype=np.uint64).reshape(-1, 3).T
    offsets = [found[0] & LOW_HALF, found[0] >> 32, found[1] & LOW_HALF, found[1] >> 32]
    powers = np.array([found[2] >> (8 * d) & 255 for d in range(4)]).astype(np.int64)
    low = np.array(offsets).astype(np.int64) + np.array(bottom)[:, None]
    volumes = np.bincount(powers.sum(axis=0))
    filled = sum(int(count) << power for power, count in enumerate(volumes))
    if filled != 1 << sum(lengths):
        raise MalformedTree("the leaves do not fill the box of all parameters")
    deepest = int((np.array(lengths)[:, None] - powers).sum(axis=0).max())
    return Leaves(low, low + (1 << powers), deepest)


LOW_HALF = (1 << 32) - 1


def _packed_leaves(word: bytes, lengths: tuple[int, ...]) -> Iterator[tuple[int, int, int]]:
    """The leaves as integers: x and y, m_e and m_f from the bottom, 32 bits each, and 4 powers."""
    pending = [(0, 0, sum(length << (8 * d) for d, length in enumerate(lengths)))]
    for symbol in word:
        if not pending:
            raise MalformedTree("the word goes on after the last leaf")
        leaf = pending.pop()
        if symbol == LEAF:
            yield leaf
            continue
        d = symbol - LEAF - 1
        if not 0 <= d < 4:
            raise MalformedTree(f"the word has the byte {symbol}")
        first, second, powers = leaf
        half = ((powers >> (8 * d)) & 255) - 1
        if half < SMALLEST:
            raise MalformedTree("a box is too small")
        powers -= 1 << (8 * d)
        step = 1 << (half + 32 * (d & 1))
        upper = (first, second + step, powers) if d & 2 else (first + step, second, powers)
        pending += (upper, (first, second, powers))
    if pending:
        raise MalformedTree("the word ends before the last leaf")
