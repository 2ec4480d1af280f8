"""What is proved, refuted or open: records that are made by doing the work."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from typing import Literal

Status = Literal["proved", "refuted", "open"]
Work = Callable[[], str]
"""Does the work and tells the evidence in a line; raises `NotShown` if it fails."""

IDENTITY = "written proof, its steps as SymPy identities"
CERTIFICATE = "exact certificate"
ENUMERATION = "exhaustive exact enumeration"
COUNTEREXAMPLE = "exact counterexample, checked anew"
NONE = "none"


class NotShown(Exception):
    """A step of a proof does not hold, or a counterexample is none."""


@dataclass(frozen=True)
class Statement:
    """One line of `python -m proofs`.

    Parameters
    ----------
    place : str
        Where it is in the paper.
    text : str
        The statement; of a refuted one, the sentence as printed.
    status : {"proved", "refuted", "open"}
        "proved" never rests on samples or on rounded numbers alone.
    method : str
        How.
    evidence : str
        What was computed on the way, exactly; of an open statement, what speaks for it.
    """

    place: str
    text: str
    status: Status
    method: str
    evidence: str

    def to_json(self) -> dict[str, str]:
        """As a JSON object."""
        return asdict(self)


@dataclass(frozen=True)
class Entry:
    """A statement before its work is done.

    Parameters
    ----------
    name : str
        The function that does the work.
    place, text, status, method
        As in `Statement`.
    work : callable
        Does the work.
    full : bool
        Whether it is left to `--full`.
    """

    name: str
    place: str
    text: str
    status: Status
    method: str
    work: Work
    full: bool = False

    def statement(self) -> Statement:
        """Do the work.

        Raises
        ------
        NotShown
            If it fails.
        """
        return Statement(self.place, self.text, self.status, self.method, self.work())


class Chapter:
    """The statements of one module, in the order in which they are written."""

    def __init__(self) -> None:
        self.entries: list[Entry] = []

    def proved(self, place: str, text: str, method: str, *, full: bool = False) -> Decorator:
        """A statement whose proof is the function's docstring and what it computes."""
        return self._entry(place, text, "proved", method, full)

    def refuted(self, place: str, text: str, method: str = COUNTEREXAMPLE) -> Decorator:
        """A printed sentence with a counterexample that the function checks."""
        return self._entry(place, text, "refuted", method, False)

    def open(self, place: str, text: str, method: str = NONE) -> Decorator:
        """A statement without a proof; the function tells what speaks for it."""
        return self._entry(place, text, "open", method, False)

    def statements(self, full: bool = False) -> Iterator[Statement]:
        """Every statement, its work done."""
        return (entry.statement() for entry in self.entries if full or not entry.full)

    def _entry(self, place: str, text: str, status: Status, method: str, full: bool) -> Decorator:
        def decorate(work: Work) -> Work:
            name = getattr(work, "__name__", "statement")
            self.entries.append(Entry(name, place, text, status, method, work, full))
            return work

        return decorate


Decorator = Callable[[Work], Work]


def demand(holds: object, step: str) -> None:
    """A step of a proof.

    Raises
    ------
    NotShown
        If it does not hold.

    >>> demand(2 + 2 == 4, "2 + 2 = 4")
    """
    if holds is not True:
        raise NotShown(f"not shown: {step}")
