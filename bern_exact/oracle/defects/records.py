"""What a damage is, and what a damaged mesh comes with."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any

from gmpy2 import mpq

from bern_exact.exact.points import HPoint
from bern_exact.oracle.defects.sound import Sound
from bern_exact.oracle.places import points_of
from bern_exact.oracle.verdict import point_json
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon

Place = dict[str, Any]
"""A place as a defect has it: `{"triangle": t}`, `{"edge": [a, b]}`, ..."""


@dataclass(frozen=True)
class Change:
    """What a damage makes of a mesh.

    Parameters
    ----------
    mesh : Mesh
        As it is now.
    polygon : Polygon or None
        What it is to be judged against.
    where : dict
        The place of the defect; nothing if there is none, or if it is the mesh as a whole.
    max_angle : str, optional
        The bound on angles that it is to be judged by, `cos:S:p/q`.
    min_height_squared : mpq, optional
        The bound on squared heights.
    max_triangles : int, optional
        The bound on the number of triangles.
    """

    mesh: Mesh
    polygon: Polygon | None
    where: Place = field(default_factory=dict)
    max_angle: str | None = None
    min_height_squared: mpq | None = None
    max_triangles: int | None = None


@dataclass(frozen=True)
class Damage:
    """One way to spoil a mesh, or to change it so that it must still be accepted.

    Parameters
    ----------
    name : str
        Its name, a key of `DAMAGES`.
    description : str
        One sentence.
    kind : str or None
        The defect that every judge must report, a key of `DEFECTS`; None if the mesh stays valid.
        Whoever lists a hundred defects has it among them, unless a hole has more vertices.
    besides : frozenset of str
        The other kinds that a judge may report as well.
    needs_polygon : bool
        Is it a defect against a polygon alone?
    make : callable
        Makes it; None if the mesh has no place for it.
    """

    name: str
    description: str
    kind: str | None
    besides: frozenset[str]
    needs_polygon: bool
    make: Callable[[Sound], Change | None] = field(repr=False)


def a_damage(
    kind: str | None, *, besides: Iterable[str] = (), needs_polygon: bool = True
) -> Callable[[Callable[[Sound], Change | None]], Damage]:
    """Turn a function into the damage of its name, described by its docstring's first line."""

    def named(make: Callable[[Sound], Change | None]) -> Damage:
        name = make.__name__.replace("_", "-")
        description = (make.__doc__ or "").partition("\n")[0]
        return Damage(name, description, kind, frozenset(besides), needs_polygon, make)

    return named


@dataclass(frozen=True)
class Damaged:
    """A mesh damaged in one known way, and what must be said of it.

    Parameters
    ----------
    damage : Damage
        The way.
    mesh, polygon, where, max_angle, min_height_squared, max_triangles
        As in `Change`.
    """

    damage: Damage
    mesh: Mesh
    polygon: Polygon | None
    where: Place
    max_angle: str | None = None
    min_height_squared: mpq | None = None
    max_triangles: int | None = None

    @property
    def kind(self) -> str | None:
        """The defect that every judge must report; None if there is none."""
        return self.damage.kind

    @property
    def result(self) -> str:
        """What a correct verifier answers: "valid" or "invalid"."""
        return "valid" if self.kind is None else "invalid"

    @property
    def criterion(self) -> dict[str, Any]:
        """The bounds by which it is to be judged, JSON-ready, under the names that `verify` has."""
        height = self.min_height_squared
        bounds = {
            "max_angle": self.max_angle,
            "min_height_squared": None if height is None else str(height),
            "max_triangles": self.max_triangles,
        }
        return {name: bound for name, bound in bounds.items() if bound is not None}

    @property
    def points(self) -> list[HPoint]:
        """Where the place lies: a triangle's corners as far as they exist, an edge's ends, ..."""
        return points_of(self.where, self.mesh, self.polygon)

    def to_json(self) -> dict[str, Any]:
        """All but the mesh and the polygon, JSON-ready."""
        return {
            "name": self.damage.name,
            "description": self.damage.description,
            "result": self.result,
            "kind": self.kind,
            "where": self.where,
            "points": [point_json(p) for p in self.points],
            "criterion": self.criterion,
        }
