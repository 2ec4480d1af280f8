"""The mesh that most users want: a theorem's mesh with every vertex removed that can be spared."""

from __future__ import annotations

from dataclasses import replace

from bern_exact.checkers.findings import demand
from bern_exact.checkers.thinning import check_thinning
from bern_exact.exact.angle_bound import AngleBound
from bern_exact.oracle.fast import verify_mesh
from bern_exact.theorems.assemble import Assembled
from bern_exact.theorems.stages import Check, Construction, Observer, Silent
from bern_exact.thinning.thin import thin


def thinned(
    made: Construction,
    *,
    max_angle: AngleBound | None,
    thin_angle: AngleBound | None = None,
    check: Check = "every-stage",
    observer: Observer | None = None,
) -> Construction:
    """The same construction, its mesh thinned; the raw mesh stays among the records.

    Parameters
    ----------
    made : Construction
        By any theorem.
    max_angle : AngleBound or None
        The bound that the raw mesh keeps; None for Theorem 1.
    thin_angle : AngleBound, optional
        A smaller bound for new triangles, as far as it goes.
    check, observer
        As for the construction.

    Raises
    ------
    LemmaViolation
        If a guarantee was lost: validity, height, angle or count.
    """
    found = thin(made.assembled.mesh, made.polygon, max_angle=max_angle, thin_angle=thin_angle)
    (observer or Silent()).stage("thinned", found)
    findings = list(made.findings)
    if check != "none":
        verdict = verify_mesh(found.mesh, made.polygon)
        findings += demand(
            check_thinning(found, made.polygon, verdict, max_angle=max_angle, thin_angle=thin_angle)
        )
    return replace(
        made,
        assembled=Assembled(found.mesh, ()),
        records={**made.records, "thinned": found},
        findings=findings,
    )
