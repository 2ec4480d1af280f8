"""The stored certificate: a tree of boxes for each class of f.

A tree is a word in preorder over 0 (a leaf) and 1 to 4 (x, y, m_e or m_f is halved, the lower half
first), compressed with xz.  The leaves of any well-formed tree tile the root box exactly: each
inner node is halved without a remainder, so nothing else about it has to be trusted.
"""

from __future__ import annotations

import lzma
from collections.abc import Iterator, Sequence
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


def sampled(word: bytes, cls: int, numbers: Sequence[int]) -> Leaves:
    """Some leaves of a tree, by their numbers in preorder, without unfolding the others.

    The word is one tree if the number of subtrees that are still to come, which each inner node
    raises by 1 and each leaf lowers by 1, is 0 after it and never before.

    Raises
    ------
    MalformedTree
        If it is no tree of these symbols.  Too small boxes off the paths are not noticed.
    """
    symbols = np.frombuffer(word, dtype=np.uint8)
    pending = np.cumsum(np.where(symbols == LEAF, -1, 1), dtype=np.int32) + 1
    if not len(word) or pending[-1] != 0 or not pending[:-1].all():
        raise MalformedTree("the word is not one tree")
    if symbols.min() < LEAF or symbols.max() > LEAF + 4:
        raise MalformedTree("the word has another byte than 0 to 4")
    places = np.flatnonzero(symbols == LEAF)[list(numbers)]
    paths = [_path(symbols, pending, int(place)) for place in places]
    bottom, lengths = root(cls)
    low = np.array(bottom)[:, None] + np.zeros((4, len(paths)), dtype=np.int64)
    size = np.array([1 << length for length in lengths])[:, None] + np.zeros_like(low)
    for leaf, path in enumerate(paths):
        for axis, is_upper in path:
            size[axis, leaf] >>= 1
            low[axis, leaf] += size[axis, leaf] if is_upper else 0
    if paths and size.min() < 1 << SMALLEST:
        raise MalformedTree("a box is too small")
    return Leaves(low, low + size, max(map(len, paths), default=0))


def _path(symbols: Array, pending: Array, place: int) -> list[tuple[int, bool]]:
    """From the root to the leaf at a place of the word: each axis, and whether the upper half."""
    path: list[tuple[int, bool]] = []
    node, end = 0, len(symbols)
    while node != place:
        # The lower half ends where one subtree fewer is to come than before it.
        first = node + 1
        after = first + int(np.argmax(pending[first:end] == pending[node] - 1)) + 1
        is_upper = place >= after
        path.append((int(symbols[node]) - LEAF - 1, is_upper))
        node, end = (after, end) if is_upper else (first, after)
    return path


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
