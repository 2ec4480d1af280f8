"""What Python programs call: a polygon in, a certified mesh out."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import get_args

from gmpy2 import mpq

from bern_exact.certificate import Certificate, extremes
from bern_exact.counts import stage_counts
from bern_exact.formats import safe_json
from bern_exact.formats.mesh_json import mesh_document
from bern_exact.outputs import write_atomically
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems.assemble import CLASSES
from bern_exact.theorems.stages import Check, Construction, Observer
from bern_exact.theorems.theorem_1 import theorem_1

THEOREMS: Mapping[int, Callable[..., Construction]] = {1: theorem_1}
"""The constructions in this version, by theorem."""


class NotInThisVersion(NotImplementedError):
    """A theorem whose construction this version does not have."""


@dataclass(frozen=True)
class Result:
    """A certified triangulation.

    Parameters
    ----------
    polygon : Polygon
        The input.
    mesh : Mesh
        The input's vertices first, in input order; triangles counter-clockwise.
    classes : sequence of str
        For each triangle what it comes from: "block", "boundary", "interior" or "fan".
    certificate : Certificate
        What was measured, and every claim that was checked.
    stages : mapping
        Each stage's record by its name, in order.
    """

    polygon: Polygon
    mesh: Mesh
    classes: Sequence[str]
    certificate: Certificate
    stages: Mapping[str, object]

    @cached_property
    def document(self) -> str:
        """The mesh document (`bern-exact/mesh`): the same bytes for the same input and options."""
        return safe_json.dumps(mesh_document(self.mesh, self.polygon, self.certificate.to_json()))

    def save(self, path: str | Path) -> None:
        """Write the mesh document, whole or not at all."""
        write_atomically(Path(path), self.document)


def triangulate(
    polygon: Polygon,
    *,
    theorem: int | None = None,
    check: Check = "every-stage",
    as_printed: bool = False,
    observer: Observer | None = None,
) -> Result:
    """Triangulate a polygon by a theorem's construction, every claim checked on the way.

    Parameters
    ----------
    polygon : Polygon
        Valid: `Polygon.load` and `polygon_from_rings` make no others.
    theorem : {1, 2, 3, 4}, optional
        1: O(n) triangles of nearly the greatest least height; 2: a simple polygon, no angle
        above 150 degrees; 3: the same with holes; 4: convex, no obtuse angle.  Without it, 2
        for a simple polygon and 3 for one with holes.
    check : {"every-stage", "final", "none"}
        Which claims are checked: each after its stage, the theorem's own at the end, or none.
    as_printed : bool
        Also evaluate the paper's sentences that are false as printed; takes its own time.
    observer : Observer, optional
        Told of each stage's record as soon as it is there.

    Raises
    ------
    NotInThisVersion
        For Theorems 2, 3 and 4.
    LemmaViolation
        If a guarantee fails: a bug here or an error in the paper, with its exact witness.
    ValueError
        If an argument is none of those listed.

    Examples
    --------
    >>> from bern_exact.plane.validation import polygon_from_rings
    >>> from bern_exact.exact.points import hpoint
    >>> triangle = polygon_from_rings([[hpoint(0, 0), hpoint(4, 0), hpoint(1, 3)]])
    >>> result = triangulate(triangle, theorem=1)
    >>> result.certificate.holds, result.mesh.vertices[:3] == triangle.points
    (True, True)
    """
    if theorem not in (None, 1, 2, 3, 4):
        raise ValueError(f"no theorem {theorem}: 1, 2, 3 or 4")
    if check not in get_args(Check):
        raise ValueError(f"check {check!r}: one of {', '.join(get_args(Check))}")
    construct = THEOREMS.get(theorem or (3 if polygon.holes else 2))
    if construct is None:
        raise NotInThisVersion(_refusal(polygon, theorem))
    made = construct(polygon, check=check, as_printed=as_printed, observer=observer)
    return _result(made, theorem or (3 if polygon.holes else 2))


def _refusal(polygon: Polygon, theorem: int | None) -> str:
    """Why there is no such construction, and what to do."""
    if theorem is not None:
        return f"Theorem {theorem} is not in this version; Theorem 1 is (--theorem 1)"
    meant = "3 (polygons with holes)" if polygon.holes else "2 (simple polygons)"
    return (
        f"Theorem {meant} would be meant, and is not in this version;"
        " ask for Theorem 1 (--theorem 1)"
    )


def _result(made: Construction, theorem: int) -> Result:
    """A construction with its certificate."""
    mesh = made.assembled.mesh
    certificate = Certificate(
        theorem=theorem,
        n=made.polygon.n,
        holes=made.polygon.holes,
        feature_size_squared=made.feature.squared,
        grid_unit=made.framed.unit,
        rotation=_rotation(made),
        counts=stage_counts(made.records),
        triangles=len(mesh.triangles),
        worst=extremes(mesh),
        claims=tuple(made.findings),
    )
    classes = tuple(CLASSES[tag] for tag in made.assembled.classes)
    return Result(made.polygon, mesh, classes, certificate, made.records)


def _rotation(made: Construction) -> tuple[mpq, mpq]:
    """Cosine and sine of the turn into the grid's frame: the similarity without its scale 1/b."""
    to_grid, unit = made.framed.similarity, made.framed.unit
    return mpq(to_grid.a, to_grid.d) * unit, mpq(to_grid.b, to_grid.d) * unit
