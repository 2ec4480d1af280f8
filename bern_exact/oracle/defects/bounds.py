"""Bounds that a mesh just keeps, or just does not: on angles, heights and its triangles."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from gmpy2 import mpq

from bern_exact.exact.angles import largest_angle
from bern_exact.exact.points import HPoint, along
from bern_exact.exact.predicates import squared_height
from bern_exact.oracle.defects.records import Change, a_damage
from bern_exact.oracle.defects.sound import Sound, shifted
from bern_exact.plane.mesh import Mesh

SMALL = mpq(1, 10**30)
"""How far off a bound is, in what it bounds, or a vertex, in lengths of an edge."""


def _largest(mesh: Mesh) -> tuple[mpq, int]:
    """The largest angle of a mesh, by its cos |cos|, and the first triangle that has it."""
    squares = [
        largest_angle(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c])[0].signed_square
        for a, b, c in mesh.triangles
    ]
    least = min(squares)
    return least, squares.index(least)


def _text(signed_square: mpq) -> str:
    """A bound on angles by its cos |cos|."""
    sign = (signed_square > 0) - (signed_square < 0)
    return f"cos:{sign}:{abs(signed_square)}"


def _mesh(sound: Sound) -> Mesh:
    return Mesh(sound.vertices, sound.triangles)


@a_damage("angle-above-bound", needs_polygon=False)
def angle_bound_too_small(sound: Sound) -> Change | None:
    """The bound on angles is smaller than the largest angle by next to nothing."""
    square, t = _largest(_mesh(sound))
    bound = _text(square + SMALL)
    return Change(_mesh(sound), sound.polygon, {"triangle": t}, max_angle=bound)


@a_damage(None, needs_polygon=False)
def angle_bound_exact(sound: Sound) -> Change | None:
    """The bound on angles is the largest angle."""
    square, _ = _largest(_mesh(sound))
    return Change(_mesh(sound), sound.polygon, max_angle=_text(square))


@a_damage(None, needs_polygon=False)
def angle_bound_just_enough(sound: Sound) -> Change | None:
    """The bound on angles is larger than the largest angle by next to nothing."""
    square, _ = _largest(_mesh(sound))
    bound = square - min(SMALL, (1 + square) / 2)
    return Change(_mesh(sound), sound.polygon, max_angle=_text(bound))


@a_damage("angle-above-bound", needs_polygon=False)
def angle_pushed_over_bound(sound: Sound) -> Change | None:
    """A vertex inside is moved so that the largest angle, the bound, grows by next to nothing."""
    for mesh, bound, t in _pushed(sound, 1):
        if _largest(mesh)[0] < bound:
            return Change(mesh, sound.polygon, {"triangle": t}, max_angle=_text(bound))
    return None


@a_damage(None, needs_polygon=False)
def angle_pushed_under_bound(sound: Sound) -> Change | None:
    """A vertex inside is moved so that the largest angle, the bound, falls by next to nothing."""
    for mesh, bound, _ in _pushed(sound, -1):
        if _largest(mesh)[0] >= bound:
            return Change(mesh, sound.polygon, max_angle=_text(bound))
    return None


def _pushed(sound: Sound, sign: int) -> Iterator[tuple[Mesh, mpq, int]]:
    """Meshes with an inner corner of a largest angle moved, the angle before, and its triangle.

    If no corner of that angle's triangle is inside, the triangle is split: its longest edge then
    has a still larger angle beside it, whose vertex is inside.
    """
    bound, t = _largest(_mesh(sound))
    if all(v in sound.boundary for v in sound.triangles[t]):
        sound = sound.with_triangle_split(t)
        bound, t = _largest(_mesh(sound))
    corners = sound.triangles[t]
    _, k = largest_angle(*(sound.vertices[v] for v in corners))
    apex, after, before = (corners[(k + i) % 3] for i in range(3))
    steps: list[tuple[int, Callable[[], HPoint]]] = [
        (apex, lambda: _towards(sound, apex, after, before, sign * SMALL)),
        (after, lambda: shifted(sound.vertices[after], sound.normal(after, apex), sign * SMALL)),
        (before, lambda: shifted(sound.vertices[before], sound.normal(apex, before), sign * SMALL)),
    ]
    for v, step in steps:
        if v not in sound.boundary and sound.stays(v, point := step()):
            yield sound.mesh(moved={v: point}), bound, t


def _towards(sound: Sound, v: int, a: int, b: int, part: mpq) -> HPoint:
    """The vertex v moved by a part of its distance towards the middle of ab."""
    middle = along(sound.vertices[a], sound.vertices[b], mpq(1, 2))
    return along(sound.vertices[v], middle, part)


def _least(sound: Sound) -> tuple[mpq, int]:
    """The least squared height, and the first triangle that has it."""
    heights = [squared_height(*(sound.vertices[v] for v in t)) for t in sound.triangles]
    return min(heights), heights.index(min(heights))


@a_damage("height-below-bound", needs_polygon=False)
def height_bound_too_large(sound: Sound) -> Change | None:
    """The bound on heights is larger than the least height by next to nothing."""
    least, t = _least(sound)
    bound = least * (1 + SMALL)
    return Change(_mesh(sound), sound.polygon, {"triangle": t}, min_height_squared=bound)


@a_damage(None, needs_polygon=False)
def height_bound_exact(sound: Sound) -> Change | None:
    """The bound on heights is the least height."""
    return Change(_mesh(sound), sound.polygon, min_height_squared=_least(sound)[0])


@a_damage("too-many-triangles", needs_polygon=False)
def triangle_too_many(sound: Sound) -> Change | None:
    """There is one triangle more than the bound."""
    return Change(_mesh(sound), sound.polygon, max_triangles=len(sound.triangles) - 1)


@a_damage(None, needs_polygon=False)
def triangles_just_enough(sound: Sound) -> Change | None:
    """There are as many triangles as the bound."""
    return Change(_mesh(sound), sound.polygon, max_triangles=len(sound.triangles))


DAMAGES = (
    angle_bound_too_small,
    angle_bound_exact,
    angle_bound_just_enough,
    angle_pushed_over_bound,
    angle_pushed_under_bound,
    height_bound_too_large,
    height_bound_exact,
    triangle_too_many,
    triangles_just_enough,
)
