"""All families of polygons, in a fixed order, and how a member is drawn.

A member is a function of its family, the text that seeds its `Random` and the parameters that are
given, the same with every version of Python and on every machine: nothing but `randrange` and
`getrandbits` is drawn, and all arithmetic is exact.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from random import Random

from bern_exact.corpus import (
    bad,
    convex_families,
    errata,
    extreme,
    holes,
    near_misses,
    paper_families,
    random_polygons,
    real_outlines,
    slender,
    special,
)
from bern_exact.corpus.draws import Rings, between, hpoints, reason_against, until
from bern_exact.corpus.family import Family
from bern_exact.corpus.flags import DECLARED, in_order, number_flags, polygon_flags
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems.stages import RefusedOption

FAMILIES: Mapping[str, Family] = {
    family.name: family
    for family in (
        *random_polygons.FAMILIES,
        *special.FAMILIES,
        *slender.FAMILIES,
        *extreme.FAMILIES,
        *holes.FAMILIES,
        *near_misses.GOOD,
        *convex_families.FAMILIES,
        *paper_families.FAMILIES,
        *errata.FAMILIES,
        *real_outlines.FAMILIES,
        *bad.FAMILIES,
        *near_misses.BAD,
    )
}
"""Every family by its name; those of bad polygons last."""


@dataclass(frozen=True)
class Drawn:
    """A member of a family.

    Parameters
    ----------
    rings : Rings
        The outer ring, then the holes: of a polygon, or of what must be refused.
    parameters : mapping
        All parameters, given or drawn.
    flags : tuple of str
        Those of the family and those that the member was found to have, in the order of `FLAGS`.
    comment : str
        What it is meant to break; of a bad one for what it is refused, of a listed one more.
    """

    rings: Rings
    parameters: Mapping[str, int]
    flags: tuple[str, ...]
    comment: str


def drawn(family: Family, seed: str, given: Mapping[str, int] | None = None) -> Drawn:
    """The member of a family that a seed determines.

    Parameters
    ----------
    family : Family
        One of `FAMILIES`.
    seed : str
        Any text.
    given : mapping, optional
        Parameters that are not to be drawn; the draws of the others stay as they are.

    Raises
    ------
    RefusedOption
        If a parameter is not one of the family's or below its least value, or if hardly any rings
        with these parameters are what they must be.

    Notes
    -----
    Rings are drawn until the validation accepts them, or of a bad family until it refuses them for
    one of `family.errors`, and they have all of the family's flags.  The flags take O(n^2).

    Examples
    --------
    >>> made = drawn(FAMILIES["paper-holes"], "any seed", {"side": 1})
    >>> made.rings
    [[(-4, -4), (5, -4), (5, 5), (-4, 5)], [(0, 0), (0, 1), (1, 1), (1, 0)]]
    >>> made.flags[:4]
    ('listed', 'reflex', 'holes', 'right-angles')
    """
    given = {} if given is None else given
    _refuse_unknown(family, given)
    random = Random(seed)
    parameters = {
        name: given.get(name, between(random, least, most))
        for name, (least, most) in family.parameters.items()
    }
    rings = until(lambda: family.draw(random, parameters), lambda rings: _is_member(family, rings))
    comment = family.says(parameters) if family.says else f"Against {family.breaks}."
    if family.errors:
        comment += f" Must be refused: {reason_against(rings)}."
    flags = in_order([*family.flags, *_measured(family, rings)])
    return Drawn(rings, parameters, flags, comment)


def _is_member(family: Family, rings: Rings) -> bool:
    """Are these rings what the family says?"""
    if reason_against(rings) not in (family.errors or (None,)):
        return False
    return set(family.flags) <= {*DECLARED, *_measured(family, rings)}


def _measured(family: Family, rings: Rings) -> set[str]:
    """The flags that the rings are found to have."""
    if family.errors:
        return set(number_flags(rings))
    return set(polygon_flags(polygon_from_rings(hpoints(rings))))


def _refuse_unknown(family: Family, given: Mapping[str, int]) -> None:
    """Refuse parameters that the family does not have, or has no members for."""
    for name, value in given.items():
        if name not in family.parameters:
            known = ", ".join(family.parameters) or "none"
            raise RefusedOption(f"{family.name} has no parameter {name!r}; it has {known}")
        least = family.parameters[name][0]
        if value < least:
            raise RefusedOption(f"{name} of {family.name}: at least {least:,}, not {value:,}")


__all__ = ["FAMILIES", "Drawn", "Family", "drawn"]
