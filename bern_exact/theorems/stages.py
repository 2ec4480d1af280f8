"""Running stages: the observer that is told of each, and the claims checked after it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Literal, Protocol

from bern_exact.checkers.findings import Finding, demand

Check = Literal["every-stage", "final", "none"]


class Observer(Protocol):
    """Whoever wants to know how far a construction is."""

    def stage(self, name: str, record: object) -> None:
        """A stage has ended with this record."""


class Silent:
    """The observer that does nothing."""

    def stage(self, name: str, record: object) -> None:
        """Ignore it."""


@dataclass
class Log:
    """The records and findings of a run so far.

    Parameters
    ----------
    check : {"every-stage", "final", "none"}
        Which claims are evaluated.
    observer : Observer
        Told of each stage.
    """

    check: Check
    observer: Observer
    records: dict[str, object] = field(default_factory=dict)
    findings: list[Finding] = field(default_factory=list)

    def done(self, name: str, record: object) -> None:
        """A stage has made this record."""
        self.records[name] = record
        self.observer.stage(name, record)

    def demand(self, findings: Iterable[Finding]) -> None:
        """Take findings; raise LemmaViolation if a guarantee among them fails."""
        self.findings.extend(demand(findings))

    @property
    def every_stage(self) -> bool:
        """Are all claims to be checked?"""
        return self.check == "every-stage"
