"""Running stages: the observer that is told of each, and the claims checked after it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal, Protocol

from bern_exact.boundary.records import Framed
from bern_exact.checkers.findings import Finding, demand
from bern_exact.convex.records import ConvexFrame
from bern_exact.plane.feature_size import FeatureSize
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems.assemble import Assembled

Check = Literal["every-stage", "final", "none"]


class RefusedOption(ValueError):
    """An option that does not go with the theorem or cannot be granted: a wrong call."""


class Observer(Protocol):
    """Whoever wants to know how far a construction is."""

    def stage(self, name: str, record: object) -> None:
        """A stage has ended with this record."""


class Silent:
    """The observer that does nothing."""

    def stage(self, name: str, record: object) -> None:
        """Ignore it."""


@dataclass(frozen=True)
class Construction:
    """What a theorem's construction made.

    Parameters
    ----------
    polygon : Polygon
        P.
    feature : FeatureSize
        Definition 1 for P.
    framed : Framed or ConvexFrame
        The grid: its unit and rotation; of Theorem 4 the frame of the diameter.
    assembled : Assembled
        The mesh, and where each triangle comes from.
    records : mapping
        Every stage's record by its name, in order.
    findings : sequence of Finding
        Every claim evaluated.
    """

    polygon: Polygon
    feature: FeatureSize
    framed: Framed | ConvexFrame
    assembled: Assembled
    records: Mapping[str, object]
    findings: Sequence[Finding]


@dataclass
class Log:
    """The records and findings of a run so far.

    Parameters
    ----------
    check : {"every-stage", "final", "none"}
        Which claims are evaluated.
    observer : Observer
        Told of each stage.
    as_printed : bool
        Whether the sentences that are false as printed are evaluated too.
    """

    check: Check
    observer: Observer
    as_printed: bool = False
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

    def construction(
        self,
        polygon: Polygon,
        feature: FeatureSize,
        framed: Framed | ConvexFrame,
        assembled: Assembled,
    ) -> Construction:
        """The run's result."""
        return Construction(polygon, feature, framed, assembled, self.records, self.findings)
