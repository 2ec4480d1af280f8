"""Draws from a `Random` by `randrange` alone, and rings of rational points to draw with.

`shuffle`, `sample`, `choice` and `random()` may draw otherwise in another version of Python;
`randrange` of a `Random` that was seeded with a text or an integer does not.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from random import Random
from typing import TypeVar

from gmpy2 import mpq

from bern_exact.exact.errors import InputError
from bern_exact.exact.points import HPoint, coordinates, hpoint
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems.stages import RefusedOption

Number = int | mpq
Place = tuple[Number, Number]
Ring = list[Place]
Rings = Sequence[Sequence[Place]]
"""Rings of points, the outer one first."""

MOST_ATTEMPTS = 2000
"""Draws after which a family has no polygon with these parameters."""

Item = TypeVar("Item")


def between(random: Random, least: int, most: int) -> int:
    """An integer from `least` to `most`, both included."""
    return random.randrange(least, most + 1)


def pick(random: Random, options: Sequence[Item]) -> Item:
    """One of the options."""
    return options[random.randrange(len(options))]


def distinct(random: Random, below: int, count: int) -> list[int]:
    """So many different integers from 0 to `below` - 1, in random order.

    Raises
    ------
    RefusedOption
        If there are not so many.

    Notes
    -----
    About count^2 / below draws are in vain.

    >>> sorted(distinct(Random("example"), 5, 5))
    [0, 1, 2, 3, 4]
    """
    if count > below:
        raise RefusedOption(f"there are no {count:,} different integers below {below:,}")
    found: dict[int, None] = {}
    while len(found) < count:
        found[random.randrange(below)] = None
    return list(found)


def shuffle(random: Random, items: list[Item]) -> None:
    """Put a list into a random order."""
    for i in reversed(range(1, len(items))):
        j = random.randrange(i + 1)
        items[i], items[j] = items[j], items[i]


def sign(random: Random) -> int:
    """-1 or 1."""
    return 2 * random.randrange(2) - 1


def about(random: Random, digits: int) -> int:
    """A number of so many digits."""
    return between(random, 10 ** (digits - 1), 10**digits - 1)


def hpoints(rings: Rings) -> list[list[HPoint]]:
    """The rings as homogeneous points."""
    return [[hpoint(mpq(x), mpq(y)) for x, y in ring] for ring in rings]


def places(rings: Sequence[Sequence[HPoint]]) -> list[Ring]:
    """The rings as pairs of rationals."""
    return [[coordinates(p) for p in ring] for ring in rings]


def moved(rings: Rings, move: Callable[[Number, Number], Place]) -> list[Ring]:
    """Every point moved."""
    return [[move(x, y) for x, y in ring] for ring in rings]


def beside(start: Place, end: Place, along: Number, aside: Number) -> Place:
    """The point at a part of the way, moved to the left by a part of the edge's length.

    >>> beside((0, 0), (4, 0), mpq(1, 4), mpq(1, 2))
    (mpq(1,1), mpq(2,1))
    """
    (px, py), (qx, qy) = start, end
    dx, dy = qx - px, qy - py
    return px + along * dx - aside * dy, py + along * dy + aside * dx


def reason_against(rings: Rings) -> str | None:
    """The kind of error for which the validation refuses the rings, None for a polygon."""
    try:
        polygon_from_rings(hpoints(rings))
    except InputError as error:
        return error.kind
    return None


def is_polygon(rings: Rings) -> bool:
    """Are these the rings of a polygon?"""
    return reason_against(rings) is None


def until(draw: Callable[[], Rings], accepted: Callable[[Rings], bool] = is_polygon) -> Rings:
    """Draw until the rings are accepted.

    Raises
    ------
    RefusedOption
        After `MOST_ATTEMPTS` in vain.
    """
    for _ in range(MOST_ATTEMPTS):
        rings = draw()
        if accepted(rings):
            return rings
    raise RefusedOption(f"none found in {MOST_ATTEMPTS:,} attempts: take other parameters")


def nth(options: Sequence[Item], which: int) -> Item:
    """The option of this number.

    Raises
    ------
    RefusedOption
        If there is none.
    """
    if not 0 <= which < len(options):
        raise RefusedOption(f"there is no number {which:,}: 0 to {len(options) - 1}")
    return options[which]
