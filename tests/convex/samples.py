"""Cells made directly, without a polygon: lines of all scales and random staircases."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate
from random import Random

from gmpy2 import mpq
from hypothesis import strategies as st

from bern_exact.convex.block_records import Block, Blocks
from bern_exact.convex.cells import Cells

SCALES = st.builds(
    lambda over, under, power: mpq(over, under) * mpq(2) ** power,
    st.integers(1, 9),
    st.integers(1, 9),
    st.integers(-90, 90),
)
"""Positive widths of wildly varying scales."""


@st.composite
def gap_lists(draw: st.DrawFn, most: int = 12) -> list[mpq]:
    """Widths of neighbouring strips: uniform, nearly so, geometric, or of any scales."""
    size = draw(st.integers(1, most))
    kind = draw(st.sampled_from(("uniform", "near", "geometric", "wild")))
    if kind == "uniform":
        return [draw(SCALES)] * size
    if kind == "near":
        thirds = draw(st.lists(st.integers(2, 5), min_size=size, max_size=size))
        return [mpq(part, 3) for part in thirds]
    if kind == "geometric":
        ratio = draw(st.sampled_from((mpq(2), mpq(1, 2), mpq(3, 2), mpq(1, 1000))))
        return [ratio**i for i in range(size)]
    return draw(st.lists(SCALES, min_size=size, max_size=size))


def lines(gaps: Sequence[mpq], below: int = 0) -> tuple[mpq, ...]:
    """The lines between strips of these widths, the one after the first `below` at 0."""
    found = list(accumulate(gaps, initial=mpq(0)))
    return tuple(y - found[below] for y in found)


def rectangle(columns: Sequence[mpq], rows: Sequence[mpq]) -> Blocks:
    """One block with columns and rows of these widths."""
    k, m = len(columns), len(rows)
    cells = Cells(lines(columns), lines(rows), (0,) * k, (m,) * k)
    return Blocks(cells, (Block(0, k, 0, m),))


@st.composite
def rectangles(draw: st.DrawFn, most: int = 12) -> Blocks:
    """One block with columns and rows of any widths."""
    return rectangle(draw(gap_lists(most)), draw(gap_lists(most)))


@st.composite
def staircases(draw: st.DrawFn, most: int = 10) -> Cells:
    """An orthoconvex region above and below a line: heights rise to a greatest and fall again."""
    columns = draw(gap_lists(most))
    high, low = (draw(unimodal(len(columns), 6)) for _ in range(2))
    below, above = max(low), max(high)
    rows = draw(st.lists(SCALES, min_size=below + above, max_size=below + above)) or [mpq(1)]
    below_line = tuple(below - h for h in low)
    return Cells(lines(columns), lines(rows, below), below_line, tuple(below + h for h in high))


@st.composite
def unimodal(draw: st.DrawFn, size: int, most: int) -> tuple[int, ...]:
    """Heights that rise and fall."""
    values = draw(st.lists(st.integers(0, most), min_size=size, max_size=size))
    top = draw(st.integers(0, size))
    return (*sorted(values[:top]), *sorted(values[top:], reverse=True))


def disc(n: int, seed: int = 1, bits: int = 100) -> Cells:
    """About n random verticals under and over parabolas, closed under bouncing."""
    random = Random(seed)
    half = sorted(
        mpq(random.getrandbits(bits) + 1, (1 << (bits + 1)) + random.getrandbits(bits))
        for _ in range(n // 2)
    )
    xs = [mpq(0), *half, *(1 - x for x in reversed(half)), mpq(1)]
    upper = [mpq(4, 3) * x * (1 - x) for x in xs]
    lower = [-x * (1 - x) for x in xs]
    ys = sorted({*upper, *lower})
    at = {y: i for i, y in enumerate(ys)}
    high = tuple(at[min(p, q)] for p, q in zip(upper, upper[1:], strict=False))
    low = tuple(at[max(p, q)] for p, q in zip(lower, lower[1:], strict=False))
    return Cells(tuple(xs), tuple(ys), low, high)
