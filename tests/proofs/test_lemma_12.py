"""Lemma 12's constants: one step of the recursion against its bound, and failures where due."""

from __future__ import annotations

from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from gmpy2 import mpq

from proofs.lemma_12_potential import Potential, most_kept, table_of
from proofs.lemma_12_rounding import BETTER, PRINTED, analytic, demand_table, proof
from proofs.statement import NotShown


def divided(lines: int) -> list[tuple[int, int, int]]:
    """All (first, middle, last) with a middle of at least (lines - 4)/3."""
    triples = product(range(1, lines), repeat=2)
    found = ((first, lines - first - last, last) for first, last in triples)
    return [parts for parts in found if parts[1] >= max(1, -(-(lines - 4) // 3))]


def kept(lines: int, first: int, last: int) -> int:
    """M - e."""
    rows = lines - 1
    lone = rows - 1 - 2 * (-(-rows // 3) - 1)
    return lines - max(-(-lone // 2), (first - 1) // 2 + (last - 1) // 2)


@pytest.mark.parametrize("rows", range(5, 12))
def test_the_parts_of_a_split_are_within_the_bound(rows: int) -> None:
    table = table_of(replace(PRINTED, size=60))
    a = [int(value) for value in table.a]

    def claim(m: int, k: int) -> int:
        return a[m] * k + m * a[k]

    for columns in range(5, 12):
        bound = table.alpha[rows] * columns + table.beta[rows]
        bound += rows * table.b[columns] + table.gamma[columns]
        for (first, middle, last), parts in product(divided(rows), divided(columns)):
            total = claim(kept(rows, first, last), parts[1])
            for k in (parts[0], parts[2]):
                total += claim(first, k) + claim(middle, (k + 2) // 2) + claim(last, k)
            assert 6 * total <= bound


def test_the_most_lines_kept_are_those_of_the_worst_ends() -> None:
    for lines in range(5, 40):
        for middle in {parts[1] for parts in divided(lines)}:
            every = [kept(lines, f, e) for f, m, e in divided(lines) if m == middle]
            assert int(most_kept(lines, np.array([middle]))[0]) == max(every)


@pytest.mark.parametrize(
    ("potential", "constant", "step"),
    [
        (PRINTED, mpq(225, 100), "m, k < N"),
        (PRINTED, mpq(245, 100), "m = 7"),
        (replace(PRINTED, slack=mpq(0)), mpq(5, 2), "K = 5, M large"),
        (replace(PRINTED, factor=mpq(1)), mpq(5, 2), "from N to N"),
    ],
    ids=["constant", "thin", "slack", "factor"],
)
def test_too_much_is_not_shown(potential: Potential, constant: mpq, step: str) -> None:
    with pytest.raises(NotShown, match=step):
        proof(potential, constant)


def test_a_table_that_is_too_low_is_not_shown() -> None:
    small = replace(BETTER, size=60)
    table = table_of(small)
    with pytest.raises(NotShown, match="A >= B"):
        demand_table(small, table._replace(a=table.a - table.a // 50))


def test_an_exponent_below_the_root_is_not_shown() -> None:
    with pytest.raises(NotShown, match="first form"):
        analytic(Potential(mpq(79, 100), mpq(13), 10**6, mpq(0)), mpq(0), mpq(0))
