"""Exact, verified triangulation of polygons without large angles.

The constructions of Bern, Dobkin and Eppstein, *Triangulating Polygons
without Large Angles* (1995), in exact arithmetic, every lemma checked on the
way, and an independent judge of finished meshes::

    from bern_exact import Polygon, triangulate, verify

    result = triangulate(Polygon.load("plate.json"), theorem=1)
    result.certificate.min_height_squared   # exact
    result.save("plate.mesh.json")
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from bern_exact.api import Result, triangulate
    from bern_exact.certificate import Certificate
    from bern_exact.checkers.findings import Finding, LemmaViolation
    from bern_exact.exact.errors import InputError
    from bern_exact.facts import Facts, facts_of
    from bern_exact.oracle.api import verify
    from bern_exact.oracle.verdict import Defect, Verdict
    from bern_exact.plane.mesh import Mesh
    from bern_exact.plane.polygon import Polygon

__version__ = "0.1.0"

__all__ = [
    "Certificate",
    "Defect",
    "Facts",
    "Finding",
    "InputError",
    "LemmaViolation",
    "Mesh",
    "Polygon",
    "Result",
    "Verdict",
    "__version__",
    "facts_of",
    "triangulate",
    "verify",
]

# Where the names are.  They are imported when they are asked for: the plugins for pytest and
# Hypothesis are loaded by every run of these, and must cost nothing.
_HOMES = {
    "Certificate": "certificate",
    "Defect": "oracle.verdict",
    "Facts": "facts",
    "Finding": "checkers.findings",
    "InputError": "exact.errors",
    "LemmaViolation": "checkers.findings",
    "Mesh": "plane.mesh",
    "Polygon": "plane.polygon",
    "Result": "api",
    "Verdict": "oracle.verdict",
    "facts_of": "facts",
    "triangulate": "api",
    "verify": "oracle.api",
}


if not TYPE_CHECKING:  # or else type checkers would take any name

    def __getattr__(name: str) -> Any:
        """A public name, imported on first use."""
        if name not in _HOMES:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        value = getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
        globals()[name] = value
        return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
