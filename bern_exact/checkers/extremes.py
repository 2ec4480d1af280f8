"""Exact extreme values over many cases, without a rational number in the inner loop."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from gmpy2 import mpq, mpz

from bern_exact.checkers.findings import Exact, Finding, Role

Integer = int | mpz
Describe = Callable[[Any], Any]


def plain(value: Any) -> Any:
    """A witness as JSON has it: tuples as lists, gmpy2's numbers as text.

    >>> plain(((1, 2), mpq(1, 3)))
    [[1, 2], '1/3']
    """
    if isinstance(value, (tuple, list)):
        return [plain(part) for part in value]
    if isinstance(value, dict):
        return {key: plain(part) for key, part in value.items()}
    if value is None or isinstance(value, (bool, int, str)):
        return value
    return str(value)


class Extreme:
    """The least (or greatest) of many fractions, and where it is; of equal ones the first.

    A denominator that is not positive makes a value of what has none, a degenerate triangle say.
    It is worse than any other: the extreme is undefined then, and no claim about it holds.

    Parameters
    ----------
    greatest : bool
        Look for the greatest instead.

    Examples
    --------
    >>> least = Extreme()
    >>> least.offer(2, 3, "a")
    >>> least.offer(1, 2, "b")
    >>> least.value, least.witness, least.cases
    (mpq(1,2), 'b', 2)
    >>> least.offer(5, 0, "c")
    >>> least.value, least.witness, least.cases
    (None, 'c', 3)
    """

    __slots__ = ("cases", "den", "num", "sign", "undefined", "witness")

    def __init__(self, *, greatest: bool = False) -> None:
        self.sign = -1 if greatest else 1
        self.num: Integer = 0
        self.den: Integer = 0
        self.cases = 0
        self.undefined = False
        self.witness: Any = None

    def offer(self, num: Integer, den: Integer, witness: Any) -> None:
        """One more case, num/den; if den <= 0 worst of all."""
        self.cases += 1
        if self.undefined:
            return
        if den <= 0:
            self.num, self.den, self.witness, self.undefined = num, 0, witness, True
        elif self.den == 0 or self.sign * (num * self.den - self.num * den) < 0:
            self.num, self.den, self.witness = num, den, witness

    @property
    def value(self) -> mpq | None:
        """The extreme, None if there was no case or one without a value."""
        return None if self.den == 0 else mpq(self.num, self.den)

    def finding(
        self,
        claim: str,
        stage: str,
        statement: str,
        bound: mpq | int,
        *,
        strict: bool = False,
        role: Role = "guarantee",
        describe: Describe = plain,
    ) -> Finding:
        """The claim that the extreme keeps the bound (from below, or from above if greatest).

        Of no cases it holds; of cases without an extreme it does not.

        Parameters
        ----------
        strict : bool
            Whether equality breaks the claim.
        describe : function
            Makes the JSON-ready witness from the one that was offered.
        """
        value = self.value
        margin = None if value is None else self.sign * (value - bound)
        if margin is None:
            holds = self.cases == 0 and not self.undefined
        else:
            holds = margin > 0 or (margin == 0 and not strict)
        return Finding(
            claim,
            stage,
            statement,
            role,
            exact(bound),
            None if value is None else exact(value if isinstance(bound, mpq) else _whole(value)),
            self.cases,
            bool(holds),
            describe(self.witness) if self.undefined or value is not None else None,
        )


class Violations:
    """How many cases break a claim, and the first that does."""

    __slots__ = ("cases", "count", "witness")

    def __init__(self) -> None:
        self.cases = 0
        self.count = 0
        self.witness: Any = None

    def case(self, holds: bool, witness: Any) -> None:
        """One more case."""
        self.cases += 1
        if not holds:
            self.broken(witness)

    def broken(self, witness: Any) -> None:
        """One more violation, in a case already counted."""
        if self.count == 0:
            self.witness = witness
        self.count += 1

    def finding(
        self,
        claim: str,
        stage: str,
        statement: str,
        *,
        role: Role = "guarantee",
        describe: Describe = plain,
    ) -> Finding:
        """The claim that there is no violation; measured is their number."""
        witness = describe(self.witness) if self.count else None
        return Finding(
            claim, stage, statement, role, 0, self.count, self.cases, self.count == 0, witness
        )


def _whole(value: mpq) -> mpq | int:
    """A count as an int."""
    return int(value) if value.denominator == 1 else value


def exact(value: Integer | mpq) -> Exact:
    """A count as a JSON integer, a rational as text.

    >>> exact(3), exact(mpq(6, 4)), exact(mpq(2))
    (3, '3/2', '2')
    """
    return value if isinstance(value, int) else str(value)
