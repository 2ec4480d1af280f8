"""This package: Theorem 2, or 3 if there are holes, raw and thinned, with and without checks."""

from __future__ import annotations

from benchmarks.peers.meshers import Clock
from bern_exact import triangulate
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems.stages import Check


def raw(polygon: Polygon, clock: Clock) -> Mesh:
    """The theorem's own mesh."""
    return _mesh(polygon, clock, "none", thin=False)


def thin(polygon: Polygon, clock: Clock) -> Mesh:
    """The thinned mesh; the time is that of the raw one and of thinning."""
    return _mesh(polygon, clock, "none", thin=True)


def raw_checked(polygon: Polygon, clock: Clock) -> Mesh:
    """As `raw`, every claim checked."""
    return _mesh(polygon, clock, "every-stage", thin=False)


def thin_checked(polygon: Polygon, clock: Clock) -> Mesh:
    """As `thin`, every claim checked."""
    return _mesh(polygon, clock, "every-stage", thin=True)


def _mesh(polygon: Polygon, clock: Clock, check: Check, *, thin: bool) -> Mesh:
    with clock:
        result = triangulate(polygon, thin=thin, check=check)
    return result.mesh
