"""Raw rings in, a `Polygon` out, or an exact account of what is wrong with them."""

from __future__ import annotations

from collections.abc import Sequence

from bern_exact.exact.errors import InputError
from bern_exact.exact.points import HPoint, direction
from bern_exact.exact.predicates import dot, orientation
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.raw_rings import RawRings
from bern_exact.plane.simplicity import Simplicity, check_simplicity


def polygon_from_rings(rings: Sequence[Sequence[HPoint]], name: str = "") -> Polygon:
    """The polygon with these rings, if they bound one.

    Parameters
    ----------
    rings : sequence of sequences of HPoint
        The outer ring, then the holes, each in either orientation, none closed by repeating
        its first point.  180-degree vertices are allowed.
    name : str
        For people.

    Returns
    -------
    Polygon
        With the points in this order, the rings normalised: interior on the left, each
        from its first point on.

    Raises
    ------
    InputError
        With the first of these that is found (of several of one kind, one of them):
        `too-few-vertices`, `repeated-vertex` (within a ring), `edges-touch` (rings with a common
        vertex), `zero-area` (a ring within a line), `spike`; then, whichever a sweep from the
        left meets first, `edges-cross`, `edges-touch` (a vertex inside an edge), `edges-overlap`;
        then `hole-outside`, `hole-in-hole` for the first hole that is one of them.

    Notes
    -----
    O(n log n) comparisons; all decisions exact.

    Examples
    --------
    >>> from bern_exact.exact.points import grid_point
    >>> square = [grid_point(x, y) for x, y in ((0, 0), (0, 4), (4, 4), (4, 0))]
    >>> polygon_from_rings([square]).rings
    ((0, 3, 2, 1),)
    >>> polygon_from_rings([[square[i] for i in (0, 1, 3, 2)]])
    Traceback (most recent call last):
    ...
    bern_exact.exact.errors.InputError: edges [0, 1] and [0, 3] cross
    """
    raw = RawRings(rings)
    _check_vertices(raw)
    simplicity = check_simplicity(raw)
    _check_nesting(raw, simplicity)
    turned = [
        ring if simplicity.is_ccw[r] == (r == 0) else (ring[0], *ring[:0:-1])
        for r, ring in enumerate(raw.rings)
    ]
    return Polygon(tuple(raw.points), tuple(turned), name)


def _check_vertices(raw: RawRings) -> None:
    """Refuse what the vertices alone show: too few, repeated, all on a line, spikes."""
    if not raw.rings:
        raise InputError("too-few-vertices", "the outer ring has no vertices", {"ring": 0})
    for r, ring in enumerate(raw.rings):
        if len(ring) < 3:
            raise InputError(
                "too-few-vertices",
                f"ring {r} has {len(ring)} vertices; a ring has at least 3",
                {"ring": r},
            )
    _check_repeated(raw)
    for r, ring in enumerate(raw.rings):
        first, second = raw.points[ring[0]], raw.points[ring[1]]
        if all(orientation(first, second, raw.points[v]) == 0 for v in ring):
            message = f"ring {r} has no area: all its vertices are on one line"
            raise InputError("zero-area", message, {"ring": r})
    for v, w in enumerate(raw.after):
        _check_spike(raw, raw.before[v], v, w)


def _check_repeated(raw: RawRings) -> None:
    """Refuse a point that is a vertex twice; within one ring first."""
    at: dict[HPoint, int] = {}
    touching: tuple[int, int] | None = None
    for v, p in enumerate(raw.points):
        other = at.setdefault(p, v)
        if other == v:
            continue
        if raw.ring_of[other] == raw.ring_of[v]:
            first, second = raw.place(other), raw.place(v)
            message = f"vertices {first} and {second} are the same point"
            if raw.after[v] == other:
                message += "; rings are not closed by repeating their first point"
            where = {"vertices": [first, second], "point": raw.text(p)}
            raise InputError("repeated-vertex", message, where)
        touching = touching or (other, v)
    if touching:
        first, second = raw.place(touching[0]), raw.place(touching[1])
        raise InputError(
            "edges-touch",
            f"rings {first[0]} and {second[0]} have vertices {first} and {second} in common",
            {
                "edges": [first, second],
                "vertices": [first, second],
                "point": raw.text(raw.points[touching[0]]),
            },
        )


def _check_spike(raw: RawRings, before: int, v: int, after: int) -> None:
    """Refuse a vertex whose two edges leave it in the same direction."""
    p, q, r = raw.points[before], raw.points[v], raw.points[after]
    if orientation(p, q, r) == 0 and dot(direction(q, p), direction(q, r)) > 0:
        place = raw.place(v)
        raise InputError(
            "spike",
            f"the boundary folds back on itself at vertex {place}",
            {"vertex": place, "edges": [raw.place(before), place], "point": raw.text(q)},
        )


def _check_nesting(raw: RawRings, simplicity: Simplicity) -> None:
    """Refuse the first hole that is outside the outer ring or inside another hole."""
    for r in range(1, len(raw.rings)):
        container, first = simplicity.container[r], simplicity.leftmost[r]
        if container == 0:
            continue
        where = {"ring": r, "vertex": raw.place(first), "point": raw.text(raw.points[first])}
        if container > 0:
            where["inside"] = container
            raise InputError("hole-in-hole", f"hole {r} lies inside hole {container}", where)
        raise InputError("hole-outside", f"hole {r} lies outside the outer ring", where)
