"""Points whose coordinates are still the text of a file: parsed where they are looked at."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from bern_exact.exact.numbers import parse_rational
from bern_exact.exact.points import HPoint, hpoint
from bern_exact.plane.array_mesh import Doubles, are_tame


@dataclass(frozen=True)
class TextPoints:
    """Points by their numbers as a file has them.

    Parameters
    ----------
    numbers : sequence of str
        x0, y0, x1, y1, ...; each text one that `parse_rational` reads.
    doubles : array of float64, (V, 2)
        The doubles nearest to them.
    """

    numbers: Sequence[str]
    doubles: Doubles

    @property
    def exact(self) -> bool:
        """It is not known whether the doubles are the coordinates."""
        return False

    @cached_property
    def tame(self) -> bool:
        """Is every coordinate 0, or between `SMALL` and `LARGE` in size?"""
        return are_tame(self.doubles) and not any(
            parse_rational(self.numbers[i]) for i in (self.doubles.ravel() == 0).nonzero()[0]
        )

    def __len__(self) -> int:
        return len(self.doubles)

    def point(self, v: int) -> HPoint:
        """The point of a vertex, exactly."""
        return hpoint(parse_rational(self.numbers[2 * v]), parse_rational(self.numbers[2 * v + 1]))
