"""Strategies of fractions like those of Hypothesis, drawn in a third of the time."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import strategies as st

fractions = st.builds(Fraction, st.integers(), st.integers(min_value=1))
"""Any, like `st.fractions()`."""


def fractions_between(least: int, most: int) -> st.SearchStrategy[Fraction]:
    """Any from `least` to `most`, both included."""

    def divide(p: int, q: int) -> Fraction:
        return least + (most - least) * Fraction(p, p + q or 1)

    whole = st.integers(min_value=0)
    return st.builds(divide, whole, whole)


def few_fractions(least: int, most: int, denominators: int) -> st.SearchStrategy[Fraction]:
    """Those from `least` to `most` with denominators up to a small one."""
    numbers = {
        Fraction(p, q) for q in range(1, denominators + 1) for p in range(least * q, most * q + 1)
    }
    return st.sampled_from(sorted(numbers, key=lambda x: (x.denominator, abs(x), x < 0)))


def many_fractions(least: int, most: int, denominators: int) -> st.SearchStrategy[Fraction]:
    """The same for larger denominators."""

    def take(p: int, q: int) -> Fraction:
        return least + Fraction(p % ((most - least) * q + 1), q)

    most_steps = (most - least) * denominators
    return st.builds(take, st.integers(0, most_steps), st.integers(1, denominators))
