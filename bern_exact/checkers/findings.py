"""What a checker returns, and what is raised when a guarantee fails."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Literal

Role = Literal["guarantee", "as-printed"]
Exact = str | int | dict[str, str] | None
"""A JSON-ready exact value: a count, a rational as text, or `{"lower", "upper"}`."""


@dataclass(frozen=True)
class Finding:
    """The outcome of one claim over all its cases.

    Parameters
    ----------
    claim : str
        Its id, such as `lemma-3.height`.
    stage : str
        After which stage it was evaluated.
    statement : str
        The paper's claim in one sentence (as repaired, where the printed one is false).
    role : {"guarantee", "as-printed"}
        A guarantee must hold.  A sentence that is false as printed is evaluated and reported.
    bound : str, int or dict
        The exact bound.
    measured : str, int, dict or None
        The exact extreme value over all cases (the one nearest to the bound, or the worst
        beyond it); None if there was no case.
    cases : int
        How many cases were evaluated.
    holds : bool
        Whether every case keeps the bound.
    witness : JSON-ready value or None
        The exact place of the extreme value; always given if the claim fails.
    """

    claim: str
    stage: str
    statement: str
    role: Role
    bound: Exact
    measured: Exact
    cases: int
    holds: bool
    witness: Any = None

    def to_json(self) -> dict[str, Any]:
        """The finding as it stands in a certificate (the witness only if the claim fails)."""
        record: dict[str, Any] = {
            "id": self.claim,
            "stage": self.stage,
            "statement": self.statement,
            "role": self.role,
            "bound": self.bound,
            "measured": self.measured,
            "cases": self.cases,
            "holds": self.holds,
        }
        if not self.holds:
            record["witness"] = self.witness
        return record


class LemmaViolation(Exception):
    """A guarantee of the paper (as repaired) failed on this input: a bug here or an error there.

    Parameters
    ----------
    finding : Finding
        The claim that failed, with its witness.
    """

    def __init__(self, finding: Finding) -> None:
        super().__init__(
            f"{finding.claim} fails after {finding.stage}: {finding.statement} "
            f"measured {finding.measured}, bound {finding.bound}, witness {finding.witness}"
        )
        self.finding = finding


def demand(findings: Iterable[Finding]) -> Sequence[Finding]:
    """The findings, if every guarantee among them holds.

    Raises
    ------
    LemmaViolation
        For the first guarantee that does not.
    """
    findings = tuple(findings)
    for finding in findings:
        if finding.role == "guarantee" and not finding.holds:
            raise LemmaViolation(finding)
    return findings
