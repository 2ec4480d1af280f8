"""The judge for large meshes: doubles decide only where that is proved right."""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module
from importlib.util import find_spec

from proofs.statement import Statement, demand

MODULE = "proofs.float_filter"


def statements(full: bool = False) -> Iterator[Statement]:
    """The theorem of `proofs.float_filter`, its computable steps checked; nothing without it."""
    if find_spec(MODULE) is None:
        return
    claims = list(import_module(MODULE).claims())
    for step, holds in claims:
        demand(bool(holds), step)
    yield Statement(
        "The judge, large meshes",
        "Every decision that doubles make about the angle or the height of a triangle is right: "
        "their radii are large enough.",
        "proved",
        "written proof; its steps in exact rationals and SymPy identities",
        f"{len(claims)} steps",
    )
