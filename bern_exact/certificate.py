"""The certificate of a mesh: what was measured and which claims hold, all exactly."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gmpy2 import mpq

from bern_exact.boundary.records import BlockShape
from bern_exact.checkers.findings import Finding
from bern_exact.exact.angles import Angle, largest_angle
from bern_exact.exact.enclosures import degrees_enclosure, sqrt_enclosure
from bern_exact.exact.numbers import format_rational
from bern_exact.exact.predicates import squared_height
from bern_exact.exact.similarity import Similarity
from bern_exact.plane.mesh import Mesh


@dataclass(frozen=True)
class Extremes:
    """The two worst triangles of a mesh; of equal ones the first.

    Parameters
    ----------
    max_angle : Angle
        The largest angle.
    widest : int
        The triangle that has it.
    min_height_squared : mpq
        The least height, squared.
    thinnest : int
        The triangle that has it.
    """

    max_angle: Angle
    widest: int
    min_height_squared: mpq
    thinnest: int


def extremes(mesh: Mesh) -> Extremes:
    """The largest angle and the least height over all triangles, and where they are.

    Parameters
    ----------
    mesh : Mesh
        At least one triangle, none with coinciding corners.

    >>> from bern_exact.exact.points import hpoint
    >>> mesh = Mesh((hpoint(0, 0), hpoint(2, 0), hpoint(0, 1)), ((0, 1, 2),))
    >>> worst = extremes(mesh)
    >>> worst.max_angle, worst.min_height_squared
    (Angle(cos_sign=0, cos_squared=mpq(0,1)), mpq(4,5))
    """
    vertices = mesh.vertices
    corners = [(vertices[a], vertices[b], vertices[c]) for a, b, c in mesh.triangles]
    angles = [largest_angle(*three)[0] for three in corners]
    heights = [squared_height(*three) for three in corners]
    signed = [angle.signed_square for angle in angles]  # decreases as the angle grows
    widest = signed.index(min(signed))
    thinnest = heights.index(min(heights))
    return Extremes(angles[widest], widest, heights[thinnest], thinnest)


@dataclass(frozen=True)
class Diameter:
    """The longest diagonal AB of a convex polygon, and the frame in which Theorem 4 has it.

    Parameters
    ----------
    vertices : ((int, int), (int, int))
        A and B as [ring, index].
    frame : Similarity
        z -> alpha z + beta of complex numbers, with A at 0 and B at 1.
    """

    vertices: tuple[tuple[int, int], tuple[int, int]]
    frame: Similarity

    def to_json(self) -> dict[str, Any]:
        """The diameter as it stands in a certificate; rotation and scale are alpha together."""
        to = self.frame
        return {
            "vertices": [list(place) for place in self.vertices],
            "squared": format_rational(1 / to.squared_scale),
            "alpha": [format_rational(mpq(part, to.d)) for part in (to.a, to.b)],
            "beta": [format_rational(mpq(part, to.d)) for part in (to.u, to.v)],
        }


@dataclass(frozen=True)
class Certificate:
    """What is certified of a mesh that this program made.

    Parameters
    ----------
    theorem : int
        The theorem whose construction it is.
    n, holes : int
        The size of the polygon.
    feature_size_squared : mpq
        Definition 1 for the polygon, squared.
    grid_unit : mpq or None
        The grid unit b in the input's units, if the construction has a grid.
    blocks : {"square", "corner"} or None
        The shape of blocks, likewise; anything but square blocks and factor 8 is experimental.
    factor : mpq or None
        The feature size of P' in grid units, at least, likewise.
    rotation : (mpq, mpq) or None
        (cos, sin) of the rotation into the grid's frame, or into Theorem 4's; None if irrational.
    counts : mapping
        For each stage what it made, in numbers.
    triangles : int
        The number of triangles.
    worst : Extremes
        The largest angle and the least height.
    claims : sequence of Finding
        Every claim of every lemma on the way.
    raw : Certificate, optional
        Of the mesh before thinning, if this one is of a thinned mesh.
    diameter : Diameter, optional
        Theorem 4's frame.
    """

    theorem: int
    n: int
    holes: int
    feature_size_squared: mpq
    grid_unit: mpq | None
    blocks: BlockShape | None
    factor: mpq | None
    rotation: tuple[mpq, mpq] | None
    counts: Mapping[str, Mapping[str, int]]
    triangles: int
    worst: Extremes
    claims: Sequence[Finding]
    raw: Certificate | None = None
    diameter: Diameter | None = None

    @property
    def max_angle(self) -> Angle:
        """The largest angle of the mesh."""
        return self.worst.max_angle

    @property
    def min_height_squared(self) -> mpq:
        """The least height of the mesh, squared."""
        return self.worst.min_height_squared

    @property
    def height_ratio_squared(self) -> mpq:
        """The least height to the feature size, squared; the best mesh possible has at most 1."""
        return self.min_height_squared / self.feature_size_squared

    @property
    def holds(self) -> bool:
        """Does every guarantee hold?"""
        return all(claim.holds for claim in self.claims if claim.role == "guarantee")

    def to_json(self) -> dict[str, Any]:
        """The certificate as it stands in a mesh document.

        Enclosures are certified decimals `[lower, upper]` of what is irrational.
        """
        record = {
            "theorem": self.theorem,
            "n": self.n,
            "holes": self.holes,
            "feature_size_squared": format_rational(self.feature_size_squared),
            "feature_size": list(sqrt_enclosure(self.feature_size_squared)),
            "grid_unit": None if self.grid_unit is None else format_rational(self.grid_unit),
            "blocks": self.blocks,
            "factor": None if self.factor is None else format_rational(self.factor),
            "rotation": None if self.rotation is None else [*map(format_rational, self.rotation)],
            "counts": {stage: dict(counts) for stage, counts in self.counts.items()},
            **self.figures(),
            "claims": [claim.to_json() for claim in self.claims],
        }
        if self.diameter is not None:
            record["diameter"] = self.diameter.to_json()
        if self.raw is not None:
            record["raw"] = self.raw.figures()
        return record

    def figures(self) -> dict[str, Any]:
        """What was measured of the mesh: size, largest angle, least height."""
        angle = self.max_angle
        return {
            "triangles": self.triangles,
            "max_angle": {
                "cos_sign": angle.cos_sign,
                "cos_squared": format_rational(angle.cos_squared),
                "degrees": list(degrees_enclosure(angle)),
                "triangle": self.worst.widest,
            },
            "min_height_squared": format_rational(self.min_height_squared),
            "min_height": list(sqrt_enclosure(self.min_height_squared)),
            "min_height_triangle": self.worst.thinnest,
            "height_ratio_squared": format_rational(self.height_ratio_squared),
            "height_ratio": list(sqrt_enclosure(self.height_ratio_squared)),
        }
