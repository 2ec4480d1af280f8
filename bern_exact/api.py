"""What Python programs call: a polygon in, a certified mesh out."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, get_args

from gmpy2 import mpq

from bern_exact.boundary.merge import Objective
from bern_exact.boundary.records import BlockShape, Framed
from bern_exact.certificate import Certificate, Diameter, extremes
from bern_exact.convex.records import ConvexFrame
from bern_exact.counts import stage_counts
from bern_exact.exact.angle_bound import AngleBound, parse_angle_bound
from bern_exact.exact.numbers import parse_rational
from bern_exact.formats import safe_json
from bern_exact.formats.mesh_json import mesh_document
from bern_exact.interior.subdivided.choice import Method
from bern_exact.oracle.arguments import polygon_of
from bern_exact.outputs import write_atomically
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems.assemble import CLASSES
from bern_exact.theorems.baseline import baseline as construct_baseline
from bern_exact.theorems.stages import Check, Construction, Observer, RefusedOption
from bern_exact.theorems.theorem_1 import theorem_1
from bern_exact.theorems.theorem_2 import DEGREES_150, theorem_2
from bern_exact.theorems.theorem_3 import theorem_3
from bern_exact.theorems.theorem_4 import DEGREES_90, bouncing, theorem_4
from bern_exact.theorems.thinned import thinned

THEOREMS: Mapping[int, Callable[..., Construction]] = {
    1: theorem_1,
    2: theorem_2,
    3: theorem_3,
    4: theorem_4,
}
"""The constructions, by theorem."""

OPTIONS: Mapping[int, Sequence[str]] = {
    1: ("blocks", "factor"),
    2: ("max_angle", "objective", "squares", "blocks", "factor"),
    3: ("max_angle", "objective", "interior", "blocks", "factor"),
    4: (),
}
"""The options of each construction."""

THINNING_BOUNDS: Mapping[int, AngleBound | None] = {
    1: None,
    2: DEGREES_150,
    3: DEGREES_150,
    4: DEGREES_90,
}
"""The angle bound that thinning keeps if no other was asked for, by theorem."""


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
        For each triangle what it comes from, one of `bern_exact.theorems.assemble.CLASSES`, or
        "mesh" after thinning.
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
    polygon: Polygon | Mapping[str, Any] | Iterable[Any],
    *,
    theorem: int | None = None,
    max_angle: AngleBound | str | int | None = None,
    interior: Method | None = None,
    objective: Objective | None = None,
    squares: bool = False,
    blocks: BlockShape | None = None,
    factor: mpq | str | int | None = None,
    baseline: bool = False,
    thin: bool = False,
    thin_angle: AngleBound | str | int | None = None,
    check: Check = "every-stage",
    as_printed: bool = False,
    observer: Observer | None = None,
) -> Result:
    """Triangulate a polygon by a theorem's construction, every claim checked on the way.

    Parameters
    ----------
    polygon : Polygon, rings or mapping
        A `Polygon` (valid: `Polygon.load` makes no others), a ring, a list of rings with the outer
        one first, or `{"outer": ring, "holes": [ring, ...]}`; coordinates as in `verify`.
    theorem : {1, 2, 3, 4}, optional
        1: O(n) triangles of nearly the greatest least height; 2: a simple polygon, no angle
        above 150 degrees; 3: the same with holes; 4: convex, no obtuse angle.  Without it, 2
        for a simple polygon and 3 for one with holes.
    max_angle : AngleBound, str or int, optional
        Theorems 2 and 3: any bound above 135 up to 150 degrees, the default.  The heights fall
        as it nears 135.
    interior : {"strips", "bridges", "best"}, optional
        Theorem 3: Lemma 8, the holes joined to the boundary and Lemma 6, or whichever
        is smaller, the default.
    objective : {"fewest", "height", "angle"}, optional
        Theorems 2 and 3: what the pieces along the boundary are best at, within both bounds:
        their number (default), the least height or the largest angle.
    squares : bool
        Theorem 2: cut off the paper's unit squares in Lemma 6 instead of whole strips.
    blocks : {"square", "corner"}, optional
        Theorems 1 to 3: the paper's blocks of 3 x 3 squares round that of a vertex, the default;
        or, experimental, the four squares round the grid vertex nearest to it.
    factor : mpq, str or int, optional
        Theorems 1 to 3: s' in grid units, above 4 sqrt 2 for square and 3 sqrt 2 for corner
        blocks.  Anything but 8, the default of square blocks, is experimental; that of corner
        blocks is 9/2.
    baseline : bool
        The simpler construction that the theorem improves on: all interior rectangles, split
        by diagonals; for Theorem 4 the O(n^2) bouncing algorithm.
    thin : bool
        Afterwards remove every vertex that the guarantees can spare; the mesh is then the
        thinned one, and `certificate.raw` keeps the raw mesh's figures.
    thin_angle : AngleBound, str or int, optional
        With `thin`: a smaller angle bound for new triangles, as far as it goes.
    check : {"every-stage", "final", "none"}
        Which claims are checked: each after its stage, the theorem's own at the end, or none.
    as_printed : bool
        Also evaluate the paper's sentences that are false as printed; takes its own time.
    observer : Observer, optional
        Told of each stage's record as soon as it is there.

    Raises
    ------
    InputError
        Kind `has-holes`, for Theorems 2 and 4; `not-convex`, for Theorem 4.
    LemmaViolation
        If a guarantee fails: a bug here or an error in the paper, with its exact witness.
    RefusedOption
        If an argument is none of those listed or not for this theorem, or the angle bound is
        out of reach (a ValueError).
    TooManyTriangles
        If a baseline would be too large (a ValueError).

    Examples
    --------
    >>> result = triangulate([(0, 0), (4, "1/3"), (1, 3)], theorem=1)
    >>> result.certificate.holds, result.mesh.vertices[:3] == result.polygon.points
    (True, True)
    """
    if theorem not in (None, 1, 2, 3, 4):
        raise RefusedOption(f"no theorem {theorem}: 1, 2, 3 or 4")
    polygon = polygon_of(polygon)
    chosen = theorem or (3 if polygon.holes else 2)
    for name, value, known in (
        ("check", check, Check),
        ("interior", interior, Method),
        ("objective", objective, Objective),
        ("blocks", blocks, BlockShape),
    ):
        if value is not None and value not in get_args(known):
            raise RefusedOption(f"{name} {value!r}: one of {', '.join(get_args(known))}")
    bound = max_angle if isinstance(max_angle, AngleBound | None) else _angle_bound(max_angle)
    special = {
        "max_angle": bound,
        "interior": interior,
        "objective": objective,
        "squares": squares or None,
        "blocks": blocks,
        "factor": _factor(factor),
    }
    given = {name: value for name, value in special.items() if value is not None}
    for name in given:
        if name not in OPTIONS[chosen]:
            raise RefusedOption(_not_an_option(name, chosen))
    if thin_angle is not None and not thin:
        raise RefusedOption("thin angle needs thin")
    construct = _baseline_of(chosen, given) if baseline else THEOREMS[chosen]
    made = construct(polygon, **given, check=check, as_printed=as_printed, observer=observer)
    result = _result(made, chosen)
    if not thin:
        return result
    sparse = thinned(
        made,
        max_angle=bound or THINNING_BOUNDS[chosen],
        thin_angle=thin_angle
        if isinstance(thin_angle, AngleBound | None)
        else _angle_bound(thin_angle),
        check=check,
        observer=observer,
    )
    return _result(sparse, chosen, result.certificate)


def _factor(written: mpq | str | int | None) -> mpq | None:
    return written if written is None or isinstance(written, mpq) else parse_rational(str(written))


def _not_an_option(name: str, theorem: int) -> str:
    """What is said of an option that a theorem does not have."""
    said = f"{name.replace('_', ' ')} is not an option of Theorem {theorem}"
    return f"{said}: its bound is 90 degrees" if (name, theorem) == ("max_angle", 4) else said


def _angle_bound(written: str | int) -> AngleBound:
    return parse_angle_bound(str(written))


def _baseline_of(theorem: int, given: dict[str, Any]) -> Callable[..., Construction]:
    """The baseline of a theorem; it has no choice of interior."""
    for name in ("interior", "squares"):
        if name in given:
            raise RefusedOption(f"the baseline has no choice of {name}")
    if theorem == 4:
        return bouncing
    if theorem > 1:
        given.setdefault("max_angle", DEGREES_150)
    return construct_baseline


def _result(made: Construction, theorem: int, raw: Certificate | None = None) -> Result:
    """A construction with its certificate."""
    mesh, framed = made.assembled.mesh, made.framed
    certificate = Certificate(
        theorem=theorem,
        n=made.polygon.n,
        holes=made.polygon.holes,
        feature_size_squared=made.feature.squared,
        grid_unit=framed.unit if isinstance(framed, Framed) else None,
        blocks=framed.blocks if isinstance(framed, Framed) else None,
        factor=framed.factor if isinstance(framed, Framed) else None,
        rotation=framed.similarity.rotation_part,
        diameter=None if isinstance(framed, Framed) else _diameter(framed),
        counts=stage_counts(made.records),
        triangles=len(mesh.triangles),
        worst=extremes(mesh),
        claims=tuple(made.findings),
        raw=raw,
    )
    # A thinned triangle comes from nowhere in particular.
    classes = tuple(CLASSES[tag] for tag in made.assembled.classes) or ("mesh",) * len(
        mesh.triangles
    )
    return Result(made.polygon, mesh, classes, certificate, made.records)


def _diameter(framed: ConvexFrame) -> Diameter:
    """The longest diagonal, which Theorem 4's frame maps to (0, 0), (1, 0)."""
    return Diameter(
        (framed.polygon.place(framed.a), framed.polygon.place(framed.b)),
        framed.similarity,
    )
