"""Hypothesis strategies for matching subdivided rectangles."""

from __future__ import annotations

from itertools import accumulate

from hypothesis import strategies as st

from bern_exact.interior.subdivided.records import SubdividedRectangle

SPACINGS = st.lists(
    st.one_of(st.integers(1, 3), st.integers(1, 40), st.integers(1, 10**6)), min_size=1, max_size=6
)


@st.composite
def subdivided_rectangles(draw: st.DrawFn) -> SubdividedRectangle:
    """Opposite sides equally subdivided, at any place and with any spacing."""
    x = draw(st.integers(-1000, 1000))
    y = draw(st.integers(-1000, 1000))
    xs = list(accumulate(draw(SPACINGS), initial=x))
    ys = list(accumulate(draw(SPACINGS), initial=y))
    across, up = tuple(xs[1:-1]), tuple(ys[1:-1])
    return SubdividedRectangle(x, xs[-1], y, ys[-1], up, up, across, across)
