"""Members of the families, drawn once for all tests."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from functools import cache

import pytest
from gmpy2 import mpq

from bern_exact.corpus.draws import hpoints
from bern_exact.corpus.families import FAMILIES, Drawn, drawn
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings

VALID = [name for name, family in FAMILIES.items() if not family.errors]
BAD = [name for name, family in FAMILIES.items() if family.errors]
SEEDS = range(4)

every_family = pytest.mark.parametrize("name", FAMILIES)
valid_families = pytest.mark.parametrize("name", VALID)
bad_families = pytest.mark.parametrize("name", BAD)


@cache
def member(name: str, seed: int) -> Drawn:
    """The member of a seed."""
    return drawn(FAMILIES[name], f"{name} {seed}")


@cache
def polygon(name: str, seed: int) -> Polygon:
    """The same as a polygon."""
    return polygon_from_rings(hpoints(member(name, seed).rings))


def as_text(made: Drawn) -> str:
    """All that a draw makes, exactly."""
    rings = [[(str(mpq(x)), str(mpq(y))) for x, y in ring] for ring in made.rings]
    return repr((rings, dict(made.parameters), made.flags, made.comment))


def digest(names: Iterable[str], seeds: Iterable[int]) -> str:
    """One digest of many draws."""
    whole = hashlib.sha256()
    for name in names:
        for seed in seeds:
            whole.update(as_text(drawn(FAMILIES[name], f"{name} {seed}")).encode())
    return whole.hexdigest()
