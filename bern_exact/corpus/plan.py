"""Which cases a corpus has."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from bern_exact.corpus.families import FAMILIES, Family
from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import shown

GENERATOR = 2
"""The generator's version: higher whenever any byte of any case would be another one."""

_CASE = re.compile(r"(?P<family>[a-z0-9-]+?)(?P<given>(?:\.[a-z_]+=[0-9]+)*)-(?P<number>[0-9]{3,})")
_CHOICE = re.compile(r"(?P<family>[a-z0-9-]+)(?::(?P<given>[a-z_]+=[0-9]+(?:,[a-z_]+=[0-9]+)*))?")


@dataclass(frozen=True)
class Choice:
    """A family, some of its parameters given.

    Parameters
    ----------
    family : str
        A key of `FAMILIES`.
    given : mapping of str to int
        Parameters that are not left to chance.
    """

    family: str
    given: Mapping[str, int] = field(default_factory=dict)

    @staticmethod
    def parse(text: str) -> Choice:
        """A choice from `family` or `family:parameter=value,...`.

        Raises
        ------
        InputError
            Kind `unsupported`: no such family or parameter.

        >>> Choice.parse("star:n=40")
        Choice(family='star', given={'n': 40})
        """
        match = _CHOICE.fullmatch(text)
        if match is None:
            raise InputError("unsupported", f"{shown(text)}: family or family:parameter=value,...")
        pairs = [pair.split("=") for pair in (match["given"] or "").split(",") if pair]
        return Choice(match["family"], {name: int(value) for name, value in pairs}).checked()

    def checked(self) -> Choice:
        """The choice itself, if there are such a family and parameters."""
        if self.family not in FAMILIES:
            known = ", ".join(FAMILIES)
            raise InputError("unsupported", f"no family {shown(self.family)}; there are: {known}")
        for name in self.given:
            if name not in self.definition.parameters:
                known = ", ".join(self.definition.parameters) or "none"
                message = f"family {self.family} has no parameter {shown(name)}; it has: {known}"
                raise InputError("unsupported", message)
        return self

    @property
    def definition(self) -> Family:
        """The family itself."""
        return FAMILIES[self.family]

    def case(self, number: int) -> str:
        """The id of a case: it holds all that the case depends on, but for the seed.

        >>> Choice("star", {"n": 40}).case(7), Choice("star").case(0)
        ('star.n=40-007', 'star-000')
        """
        given = "".join(f".{name}={value}" for name, value in sorted(self.given.items()))
        return f"{self.family}{given}-{number:03}"


def choice_of(case: str) -> tuple[Choice, int]:
    """The choice and the number behind a case's id.

    Raises
    ------
    InputError
        Kind `unsupported`: no id of a case.

    >>> choice_of("star.n=40-007")
    (Choice(family='star', given={'n': 40}), 7)
    """
    match = _CASE.fullmatch(case)
    if match is None:
        raise InputError("unsupported", f"{shown(case)} is no id of a case")
    pairs = [pair.split("=") for pair in match["given"].split(".") if pair]
    choice = Choice(match["family"], {name: int(value) for name, value in pairs})
    return choice.checked(), int(match["number"])


@dataclass(frozen=True)
class Plan:
    """A corpus to be made.

    Parameters
    ----------
    seed : int
        Of all chance.
    count : int
        How many cases.
    choices : sequence of Choice
        The families, one after the other in turn.
    """

    seed: int
    count: int
    choices: Sequence[Choice]

    def cases(self) -> Iterator[str]:
        """The ids; those of a shorter corpus are the first of a longer one's.

        >>> list(Plan(1, 3, (Choice("star"), Choice("bar"))).cases())
        ['star-000', 'bar-000', 'star-001']
        """
        for i in range(self.count):
            number, which = divmod(i, len(self.choices))
            yield self.choices[which].case(number)


def every_family() -> tuple[Choice, ...]:
    """All families, nothing given; those of bad polygons evenly among the others.

    So a corpus of fewer cases than families has both kinds.
    """
    good = [name for name, family in FAMILIES.items() if not family.errors]
    bad = [name for name, family in FAMILIES.items() if family.errors]
    places = [(i * len(bad), 0, name) for i, name in enumerate(good)]
    places += [(i * len(good), 1, name) for i, name in enumerate(bad)]
    return tuple(Choice(name) for _, _, name in sorted(places))
