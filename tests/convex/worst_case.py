"""The recursion of Lemma 12 evaluated for parts of the worst possible sizes."""

from __future__ import annotations

from functools import cache


def worst_cases(most: int) -> dict[tuple[int, int], int]:
    """The most triangles for each (columns, rows) up to `most`, by what the checkers claim.

    Between l and r at least (m - 1)/6 lines go, in outer parts half of them; l, r and what is
    between are at least a third.  More lines and smaller outer parts make no more triangles.
    """

    @cache
    def worst(k: int, m: int) -> int:
        if k > m:
            return worst(m, k)
        if k == 0:
            return 0
        if k == 1:
            return 2 * m
        return max(by_columns(k, m), by_columns(m, k))

    def by_columns(k: int, m: int) -> int:
        gone = -(-(m - 1) // 6)
        found = []
        if k <= 3:
            found += [2 * m + outer(before, m) + outer(k - 1 - before, m) for before in range(k)]
        for outside in range(k - max(2, -(-k // 3)) + 1):
            inside = worst(k - 2 - outside, m - gone)
            ends = max(outer(i, m) + outer(outside - i, m) for i in range(outside + 1))
            found.append(4 * m - 2 * gone + inside + ends)
        return max(found)

    @cache
    def outer(k: int, m: int) -> int:
        if k < 2 or m < 2:
            return 2 * k * m
        found = []
        if m <= 3:
            found += [2 * k + worst(k, before) + worst(k, m - 1 - before) for before in range(m)]
        for outside in range(m - max(2, -(-m // 3)) + 1):
            inside = worst(-(-k // 2), m - 2 - outside)
            ends = max(worst(k, i) + worst(k, outside - i) for i in range(outside + 1))
            found.append(4 * k - 2 * (k // 2) + inside + ends)
        return max(found)

    return {(k, m): worst(k, m) for k in range(1, most + 1) for m in range(1, most + 1)}
