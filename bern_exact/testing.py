"""Assertions on meshes for test suites: exact, with a message that says what is wrong and where.

With pytest there is a fixture besides, `exact_judge`, which saves what it refuses; see
`bern_exact.pytest_plugin`.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from bern_exact.exact.numbers import parse_rational
from bern_exact.formats.mesh_json import dumps_mesh
from bern_exact.formats.polygon_json import dump_polygon
from bern_exact.oracle.api import verdict_on
from bern_exact.oracle.arguments import angle_of, exact, mesh_of, polygon_of
from bern_exact.oracle.places import points_of
from bern_exact.oracle.verdict import Defect, Verdict, point_json
from bern_exact.outputs import write_atomically
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.report import verdict_lines
from bern_exact.view.defects import draw_verdict

__all__ = ["ExactJudge", "assert_nonobtuse", "assert_triangulation"]

SLIGHTLY = 1_000
"""A vertex is slightly off if by less than this part of the feature size."""

LONGEST = 400
"""Characters of a line of a message."""


def assert_triangulation(
    vertices: Any,
    triangles: Any = None,
    polygon: Any = None,
    *,
    max_angle: Any = None,
    min_height_squared: Any = None,
    max_triangles: int | None = None,
    tolerance: Any = None,
    limit: int = 10,
) -> Verdict:
    """Assert, exactly, that a mesh triangulates a polygon within bounds.

    Parameters
    ----------
    vertices, triangles, polygon, max_angle, min_height_squared, max_triangles, tolerance
        As in `bern_exact.verify`.
    limit : int
        How many defects the message lists.

    Returns
    -------
    Verdict
        With all exact figures.

    Raises
    ------
    AssertionError
        If the mesh has a defect.  The first line names it; the defects follow, each with its place,
        coordinates and exact witness, then the figures.
    InputError
        If the arguments are not what `verify` takes.

    Examples
    --------
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> assert_triangulation(square, [(0, 1, 2), (0, 2, 3)], square, max_angle=90).triangles
    2
    >>> assert_triangulation(square, [(0, 1, 2), (0, 3, 2)], square)
    Traceback (most recent call last):
    ...
    AssertionError: not valid: clockwise-triangle: triangle 1 (the triangle runs clockwise)
      clockwise-triangle: triangle 1 (the triangle runs clockwise)
        at (0, 0), (0, 1), (1, 1)
      2 triangles, 4 vertices, 0.5 triangles a vertex of the polygon
      largest angle 90 degrees, triangle 0
      least height 0.707106..., triangle 0, 0.707106... of the polygon's feature size 1
      largest angles up to 60: 0, 90: 2, 120: 0, 135: 0, 150: 0, above: 0
    """
    __tracebackhide__ = True
    case = Judged.of(
        vertices,
        triangles,
        polygon,
        max_angle=max_angle,
        min_height_squared=min_height_squared,
        max_triangles=max_triangles,
        tolerance=tolerance,
        limit=limit,
    )
    if not case.verdict:
        raise AssertionError(case.message)
    return case.verdict


def assert_nonobtuse(
    vertices: Any,
    triangles: Any = None,
    polygon: Any = None,
    *,
    min_height_squared: Any = None,
    max_triangles: int | None = None,
    tolerance: Any = None,
    limit: int = 10,
) -> Verdict:
    """Assert, exactly, that a mesh triangulates a polygon without an obtuse angle.

    Parameters and what is raised are those of `assert_triangulation`.

    Examples
    --------
    >>> assert_nonobtuse([(0, 0), (4, 0), (2, 2)], [(0, 1, 2)]).angle_classes["le90"]
    1
    >>> assert_nonobtuse([(0, 0), (4, 0), (2, "1.999")], [(0, 1, 2)])  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    ...
    AssertionError: not valid: angle-above-bound: triangle 0 (the triangle has an angle above ...
    """
    __tracebackhide__ = True
    return assert_triangulation(
        vertices,
        triangles,
        polygon,
        max_angle=90,
        min_height_squared=min_height_squared,
        max_triangles=max_triangles,
        tolerance=tolerance,
        limit=limit,
    )


@dataclass(frozen=True)
class Judged:
    """A mesh, the polygon and the options that it was judged by, and the verdict."""

    mesh: Mesh
    polygon: Polygon | None
    options: dict[str, Any]
    verdict: Verdict

    @staticmethod
    def of(vertices: Any, triangles: Any, polygon: Any, **options: Any) -> Judged:
        """Judge what users have."""
        mesh = mesh_of(vertices, triangles)
        whole = mesh if isinstance(mesh, Mesh) else mesh.mesh
        target = None if polygon is None else polygon_of(polygon)
        asked = {name: value for name, value in options.items() if value is not None}
        if "max_angle" in asked:
            asked["max_angle"] = angle_of(asked["max_angle"])
        for name in ("min_height_squared", "tolerance"):
            if name in asked:
                asked[name] = exact(asked[name], name)
        return Judged(whole, target, asked, verdict_on(mesh, target, **asked))

    @property
    def message(self) -> str:
        """What is wrong: its first line says it, the others where and by how much."""
        verdict = self.verdict
        defects = _telling_first(verdict)
        lines = [f"{verdict.state}: {_headline(defects)}"]
        for defect in defects:
            lines += [f"  {line}" for line in _about(defect, self.mesh, self.polygon)]
        if len(verdict.defects) == self.options["limit"]:
            lines.append(f"  (no more than {len(verdict.defects)} defects are listed)")
        figures = verdict_lines(verdict)[: -len(verdict.defects) or None]
        figures[0] = figures[0].partition(": ")[2]
        lines += [f"  {line}" for line in figures]
        return "\n".join(_shortened(line) for line in lines)


def _telling_first(verdict: Verdict) -> list[Defect]:
    """The defects; those come last that are mere consequences.

    Round a gap or an overlap, vertices inside are boundary vertices off the polygon's edges.  That
    is the news only where they are off by far less than the polygon has details.
    """
    off, size = verdict.off_edge, verdict.feature_size_squared
    far = None if off is None else parse_rational(off["distance_squared"])
    if far is not None and size is not None and far * SLIGHTLY**2 < size:
        return list(verdict.defects)
    return sorted(verdict.defects, key=lambda each: each.kind == "boundary-vertex-off-edge")


def _headline(defects: Sequence[Defect]) -> str:
    """The first defect, and how many others are listed."""
    if not defects:
        return "defects, of which none is listed"
    others = len(defects) - 1
    more = f", and {others} more defect{'' if others == 1 else 's'} listed" if others else ""
    return f"{defects[0].sentence}{more}"


def _about(defect: Defect, mesh: Mesh, polygon: Polygon | None) -> list[str]:
    """A defect, the coordinates of its place, and the values that show it."""
    lines = [defect.sentence]
    points = [point_json(p) for p in points_of(defect.where, mesh, polygon)]
    if points:
        lines.append("  at " + ", ".join(f"({x}, {y})" for x, y in points))
    if defect.where:
        lines += [
            f"  {name}: {_witness_text(value)}"
            for name, value in defect.witness.items()
            if value not in points
        ]
    return lines


def _witness_text(value: Any) -> str:
    """A witness as text: numbers and exact texts as they are."""
    return value if isinstance(value, str) else json.dumps(value).replace('"', "")


def _shortened(line: str) -> str:
    """A line that a terminal can take: exact coordinates may have thousands of digits."""
    return line if len(line) <= LONGEST else f"{line[:LONGEST]}..."


class ExactJudge:
    """Asserts like `assert_triangulation`, and saves what it refuses.

    Parameters
    ----------
    directory : Path
        Where the files go: the mesh (with its polygon) and the polygon as JSON, and a picture
        with the defects marked.
    """

    def __init__(self, directory: Path) -> None:
        self.directory = directory
        self._refused = 0

    def __call__(
        self,
        vertices: Any,
        triangles: Any = None,
        polygon: Any = None,
        *,
        max_angle: Any = None,
        min_height_squared: Any = None,
        max_triangles: int | None = None,
        tolerance: Any = None,
        limit: int = 10,
    ) -> Verdict:
        """Assert that a mesh triangulates a polygon within bounds; see `assert_triangulation`.

        The message ends with the paths of the files and how to judge them again.
        """
        __tracebackhide__ = True
        case = Judged.of(
            vertices,
            triangles,
            polygon,
            max_angle=max_angle,
            min_height_squared=min_height_squared,
            max_triangles=max_triangles,
            tolerance=tolerance,
            limit=limit,
        )
        if case.verdict:
            return case.verdict
        self._refused += 1
        raise AssertionError("\n".join([case.message, "", *self._saved(case)]))

    def _saved(self, case: Judged) -> list[str]:
        """Write the files, and say where they are."""
        name = f"exact_judge_{self._refused}"
        mesh = self.directory / f"{name}.mesh.json"
        texts = {mesh: dumps_mesh(case.mesh, case.polygon)}
        if case.polygon is not None:
            document = json.dumps(dump_polygon(case.polygon), indent=1)
            texts[self.directory / f"{name}.polygon.json"] = f"{document}\n"
        texts[self.directory / f"{name}.svg"] = draw_verdict(case.mesh, case.polygon, case.verdict)
        for path, text in texts.items():
            write_atomically(path, text)
        bounds = "".join(
            f" --{option.replace('_', '-')} {getattr(value, 'text', value)}"
            for option, value in case.options.items()
            if option != "limit"
        )
        return [*(f"saved {path}" for path in texts), f"again: bern-exact verify {mesh}{bounds}"]
