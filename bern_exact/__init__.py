"""Exact, verified triangulation of polygons without large angles.

The constructions of Bern, Dobkin and Eppstein, *Triangulating Polygons
without Large Angles* (1995), in exact arithmetic, every lemma checked on the
way, and an independent judge of finished meshes::

    from bern_exact import Polygon, triangulate, verify

    result = triangulate(Polygon.load("plate.json"), theorem=1)
    result.certificate.min_height_squared   # exact
    result.save("plate.mesh.json")
"""

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
