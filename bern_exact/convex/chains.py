"""Heights of a chain, and the partner of a point: the other end of its chord."""

from __future__ import annotations

from bisect import bisect_left

from gmpy2 import mpq

from bern_exact.convex.records import Chain


class Sigma:
    """The height of a chain as a function, and the map sigma to the other point at that height.

    Section 5's particle "travels along horizontal and vertical lines": a horizontal one takes
    it from x to sigma(x).

    Parameters
    ----------
    chain : Chain
        Concave, from A to B.

    Notes
    -----
    Bisection: O(log n) comparisons and a constant number of operations a call.

    Examples
    --------
    >>> tent = Sigma(Chain((mpq(0), mpq(1, 4), mpq(1)), (mpq(0), mpq(1), mpq(0))))
    >>> tent.height(mpq(1, 8)), tent.partner(mpq(1, 8))
    (mpq(1,2), mpq(5,8))
    """

    __slots__ = ("_falling", "_is_edge", "_rising", "_slopes", "chain", "first", "last")

    def __init__(self, chain: Chain) -> None:
        self.chain = chain
        self.first, self.last = chain.flat
        self._is_edge = chain.is_edge
        xs, hs = chain.xs, chain.hs
        self._slopes = [(hs[i + 1] - hs[i]) / (xs[i + 1] - xs[i]) for i in range(len(xs) - 1)]
        self._rising = hs[: xs.index(self.first) + 1]
        # Heights along the falling part are bisected in reverse.
        self._falling = hs[: xs.index(self.last) - 1 : -1]

    def height(self, x: mpq) -> mpq:
        """The distance from AB at x in [0, 1]."""
        chain = self.chain
        i = bisect_left(chain.xs, x)
        if chain.xs[i] == x:
            return chain.hs[i]
        return chain.hs[i] - self._slopes[i - 1] * (chain.xs[i] - x)

    def partner(self, x: mpq) -> mpq | None:
        """sigma(x): the other point of the same height, or None where there is not just one.

        That is inside a flat top, and anywhere on a chain that is AB itself.
        """
        if self._is_edge or self.first < x < self.last:
            return None
        return self.across(x)

    def across(self, x: mpq) -> mpq:
        """sigma(x) for x not inside a flat.

        The ends of a flat top are each other's partners, the limits of sigma from outside; a
        peak is its own.
        """
        height = self.height(x)
        return self._on_falling(height) if x <= self.first else self._on_rising(height)

    def _on_rising(self, height: mpq) -> mpq:
        chain, i = self.chain, bisect_left(self._rising, height)
        if chain.hs[i] == height:
            return chain.xs[i]
        return chain.xs[i] - (chain.hs[i] - height) / self._slopes[i - 1]

    def _on_falling(self, height: mpq) -> mpq:
        chain = self.chain
        i = len(chain.xs) - 1 - bisect_left(self._falling, height)
        if chain.hs[i] == height:
            return chain.xs[i]
        return chain.xs[i] - (chain.hs[i] - height) / self._slopes[i]
