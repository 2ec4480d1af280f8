"""Identities and inequalities between polynomials, by SymPy, exactly."""

from __future__ import annotations

from typing import Any

import sympy
from gmpy2 import mpq

from proofs.statement import demand

Expression = Any
"""A SymPy expression; SymPy has no types of its own."""

ROOT_2 = mpq(99, 70)
"""More than sqrt 2."""


def symbols(names: str) -> Any:
    """Nonnegative symbols: what is strictly positive is a sum of such and a positive number."""
    return sympy.symbols(names, nonnegative=True)


def demand_equal(left: Expression, right: Expression, step: str) -> None:
    """An identity of rational functions or of square roots of such."""
    demand(sympy.simplify(left - right) == 0, step)


def demand_nonnegative(value: Expression, step: str) -> None:
    """value >= 0 for all nonnegative symbols: every coefficient of its polynomial is."""
    _, coefficients = _coefficients(value)
    demand(all(bool(c >= 0) for c in coefficients), step)


def demand_positive(value: Expression, step: str) -> None:
    """value > 0 for all nonnegative symbols: besides, the constant term is positive."""
    polynomial, coefficients = _coefficients(value)
    constant = polynomial.coeff_monomial(1) if polynomial is not None else coefficients[0]
    demand(all(bool(c >= 0) for c in coefficients) and bool(constant > 0), step)


def _coefficients(value: Expression) -> tuple[Any, list[Any]]:
    expanded = sympy.expand(value)
    free = sorted(expanded.free_symbols, key=str)
    if not free:
        return None, [expanded]
    demand(all(symbol.is_nonnegative for symbol in free), "the symbols are nonnegative")
    polynomial = sympy.Poly(expanded, *free)
    return polynomial, polynomial.coeffs()
