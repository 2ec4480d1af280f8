"""Strategies for polygons."""

from __future__ import annotations

from collections.abc import Sequence

from gmpy2 import isqrt, mpq
from hypothesis import assume
from hypothesis import strategies as st
from hypothesis.errors import InvalidArgument

from bern_exact.exact.errors import InputError
from bern_exact.exact.points import hpoint
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.triangulation import triangulate_polygon
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.strategies.cells import Cells, stretched
from bern_exact.strategies.options import check_boolean, check_integer, check_numbers, check_range
from bern_exact.strategies.rings import (
    Place,
    Ring,
    are_on_a_line,
    convex_ring,
    off_the_line,
    primitive,
    untangled,
    with_flat,
    without_flat,
)

SPANS = (3, 10, 100, 10_000)
"""Coordinates are drawn within one of these, or the bound: small ones make collinear points."""

NEARLY = (1, 10, 1_000, 10**6)
"""Points are scaled by one of these and shaken by 1: what met nearly meets."""

SHAKES = (0, 1, -1)

SPLITS = (4, 6, 12, 1_000)
"""Holes lie on the points that divide the edges of a triangle into so many parts."""

ROOM = 8
"""A grid has at least so many times as many points as a ring has vertices: few lie on its edges."""

MAX_VALUE, MAX_DENOMINATOR = 10**9, 1_000


def simple_polygons(
    *,
    min_vertices: int = 3,
    max_vertices: int = 12,
    max_value: int = MAX_VALUE,
    max_denominator: int = MAX_DENOMINATOR,
    allow_flat: bool = True,
) -> st.SearchStrategy[Polygon]:
    """Polygons without holes.

    Parameters
    ----------
    min_vertices, max_vertices : int
        How many vertices they have.
    max_value : int
        No coordinate is larger in absolute value.
    max_denominator : int
        The coordinates have a common denominator of at most this; 1 makes all integers.
    allow_flat : bool
        May they have 180-degree vertices?

    Returns
    -------
    SearchStrategy of Polygon
        Any shape, in either orientation.  They shrink to few vertices at small integers.

    Raises
    ------
    InvalidArgument
        At once, if an option is not what it must be.
    """
    check_range("min_vertices", min_vertices, "max_vertices", max_vertices, 3)
    check_numbers(max_value, max_denominator, max_vertices)
    check_boolean("allow_flat", allow_flat)
    return _simple_polygons(min_vertices, max_vertices, max_value, max_denominator, allow_flat)


@st.composite
def _simple_polygons(
    draw: st.DrawFn, least: int, most: int, max_value: int, max_denominator: int, allow_flat: bool
) -> Polygon:
    ring = draw(_simple_rings(least, most, max_value, allow_flat))
    return _polygon([ring], draw(_denominators(max_denominator)))


def convex_polygons(
    *,
    min_vertices: int = 3,
    max_vertices: int = 12,
    max_value: int = MAX_VALUE,
    max_denominator: int = MAX_DENOMINATOR,
    allow_flat: bool = True,
) -> st.SearchStrategy[Polygon]:
    """Convex polygons; options as in `simple_polygons`."""
    check_range("min_vertices", min_vertices, "max_vertices", max_vertices, 3)
    check_numbers(max_value, max_denominator, max_vertices)
    check_boolean("allow_flat", allow_flat)
    return _convex_polygons(min_vertices, max_vertices, max_value, max_denominator, allow_flat)


@st.composite
def _convex_polygons(
    draw: st.DrawFn, least: int, most: int, max_value: int, max_denominator: int, allow_flat: bool
) -> Polygon:
    # Edges of such a size leave the ring within max_value of 0, even if all go one way.
    bound = 2 * max_value // most
    span = draw(_spans(bound, _side(2 * most)))
    number = st.integers(-span, span)
    step = st.tuples(number, number).map(lambda p: p if any(p) else (1, 0))
    steps = draw(st.lists(step, min_size=max(2, least - 1), max_size=most - 1, unique_by=primitive))
    steps = draw(_shaken(steps, span, bound))
    if are_on_a_line([(0, 0), *steps]):
        steps = [steps[0], (-steps[0][1], steps[0][0])]
    ring = convex_ring(steps)
    assume(len(ring) >= least)
    ring = draw(_shifted(ring, max_value))
    if allow_flat:
        ring = draw(_with_flats(ring, most))
    return _polygon([ring], draw(_denominators(max_denominator)))


def rectilinear_polygons(
    *,
    min_vertices: int = 4,
    max_vertices: int = 20,
    max_value: int = MAX_VALUE,
    max_denominator: int = MAX_DENOMINATOR,
    allow_flat: bool = True,
) -> st.SearchStrategy[Polygon]:
    """Polygons without holes whose edges are all horizontal or vertical.

    Options as in `simple_polygons`.  Their corners are even in number; exactly so many vertices can
    be asked for only if that is even.
    """
    check_range("min_vertices", min_vertices, "max_vertices", max_vertices, 4)
    check_numbers(max_value, max_denominator, max_vertices)
    check_boolean("allow_flat", allow_flat)
    if min_vertices % 2 == 1 and min_vertices == max_vertices:
        raise InvalidArgument(f"min_vertices=max_vertices={min_vertices} must be even")
    return _rectilinear_polygons(min_vertices, max_vertices, max_value, max_denominator, allow_flat)


@st.composite
def _rectilinear_polygons(
    draw: st.DrawFn, least: int, most: int, max_value: int, max_denominator: int, allow_flat: bool
) -> Polygon:
    cells = Cells()
    for choice in draw(st.lists(st.integers(0, 10**6), max_size=most)):
        fitting = [c for c in cells.candidates() if cells.corners_with(c) <= most]
        if fitting:
            cells.add(fitting[choice % len(fitting)])
    while cells.corners_with() < least:
        cells.add(_step(cells, most))
    corners = cells.ring()
    columns, rows = (len({p[k] for p in corners}) - 1 for k in (0, 1))
    span = draw(_spans(2 * max_value // max(columns, rows)))
    gaps = st.integers(1, max(1, span))
    across = draw(st.lists(gaps, min_size=columns, max_size=columns))
    up = draw(st.lists(gaps, min_size=rows, max_size=rows))
    ring = draw(_shifted(stretched(corners, across, up), max_value))
    if allow_flat:
        ring = draw(_with_flats(ring, most))
    assume(len(ring) >= least)
    return _polygon([ring], draw(_denominators(max_denominator)))


def _step(cells: Cells, most: int) -> Place:
    """The first cell that adds corners, but not too many.

    Failing that, the highest of those right of all: a cell above or below that one does.
    """
    now = cells.corners_with()
    candidates = cells.candidates()
    adding = (c for c in candidates if now < cells.corners_with(c) <= most)
    return next(adding, candidates[-1])


def polygons_with_holes(
    *,
    min_holes: int = 1,
    max_holes: int = 3,
    min_vertices: int = 3,
    max_vertices: int = 10,
    max_hole_vertices: int = 5,
    max_value: int = MAX_VALUE,
    max_denominator: int = MAX_DENOMINATOR,
    allow_flat: bool = True,
) -> st.SearchStrategy[Polygon]:
    """Polygons with holes.

    Parameters
    ----------
    min_holes, max_holes : int
        How many holes they have.
    min_vertices, max_vertices : int
        How many vertices the outer ring has.
    max_hole_vertices : int
        How many vertices a hole has at most.
    max_value, max_denominator, allow_flat
        As in `simple_polygons`.

    Returns
    -------
    SearchStrategy of Polygon
        Holes are of any shape and may nearly touch one another or the outer ring.

    Raises
    ------
    InvalidArgument
        At once, if an option is not what it must be, or `max_vertices` leaves no room for so many
        holes: the outer ring has at least two vertices more than there are holes.
    """
    check_range("min_holes", min_holes, "max_holes", max_holes, 0)
    check_range("min_vertices", min_vertices, "max_vertices", max_vertices, 3)
    check_range("min_holes + 2", min_holes + 2, "max_vertices", max_vertices, 2)
    check_integer("max_hole_vertices", max_hole_vertices, 3)
    check_numbers(max_value, max_denominator, SPLITS[0] * max_vertices)
    check_boolean("allow_flat", allow_flat)
    return _polygons_with_holes(
        (min_holes, max_holes),
        (max(min_vertices, min_holes + 2), max_vertices),
        max_hole_vertices,
        (max_value, max_denominator),
        allow_flat,
    )


@st.composite
def _polygons_with_holes(
    draw: st.DrawFn,
    holes: tuple[int, int],
    vertices: tuple[int, int],
    most_of_hole: int,
    numbers: tuple[int, int],
    allow_flat: bool,
) -> Polygon:
    max_value, max_denominator = numbers
    parts = draw(st.sampled_from([k for k in SPLITS if k * vertices[1] <= max_value]))
    small = draw(_simple_rings(*vertices, max_value // parts, allow_flat))
    rings = [[(parts * x, parts * y) for x, y in small]]
    triangles = list(triangulate_polygon(_polygon(rings, 1)).triangles())
    most = min(holes[1], len(triangles))
    chosen = draw(
        st.lists(st.integers(0, len(triangles) - 1), min_size=holes[0], max_size=most, unique=True)
    )
    for t in chosen:
        a, b, c = (small[v] for v in triangles[t])
        weights = draw(_rings_of_weights(parts, most_of_hole, allow_flat))
        rings.append([_combined((u, v, parts - u - v), (a, b, c)) for u, v in weights])
    if len(chosen) < holes[1]:
        more = _simple_rings(3, most_of_hole, max_value, allow_flat)
        for ring in draw(st.lists(more, max_size=min(2, holes[1] - len(chosen)))):
            if _are_valid([*rings, ring]):
                rings.append(ring)
    return _polygon(rings, draw(_denominators(max_denominator)))


def _combined(weights: Sequence[int], corners: Sequence[Place]) -> Place:
    """The sum of three points, each so many times."""
    x, y = (sum(w * p[k] for w, p in zip(weights, corners, strict=True)) for k in (0, 1))
    return x, y


@st.composite
def _rings_of_weights(draw: st.DrawFn, parts: int, most: int, allow_flat: bool) -> Ring:
    """The first two weights, all three positive, of a simple ring's points inside a triangle."""
    room = parts - 3

    def folded(pair: Place) -> Place:
        u, v = pair
        return (u + 1, v + 1) if u + v <= room else (room - u + 1, room - v + 1)

    number = st.integers(0, room)
    pairs = draw(st.lists(st.tuples(number, number), max_size=most, unique_by=folded))
    points = [folded(pair) for pair in pairs]
    if len(points) < 3 or are_on_a_line(points):
        points = [(1, 1), (room + 1, 1), (1, room + 1)]
    ring = untangled(points)
    return ring if allow_flat else without_flat(ring)


# What all of them are made of ---------------------------------------------------------


def _polygon(rings: Sequence[Sequence[Place]], denominator: int) -> Polygon:
    """The polygon with these points divided by a number."""
    return polygon_from_rings(
        [[hpoint(mpq(x, denominator), mpq(y, denominator)) for x, y in ring] for ring in rings]
    )


def _are_valid(rings: Sequence[Sequence[Place]]) -> bool:
    try:
        _polygon(rings, 1)
    except InputError:
        return False
    return True


def _denominators(most: int) -> st.SearchStrategy[int]:
    """Powers of ten and other numbers, down to 1."""
    return st.sampled_from([d for d in (1, 2, 3, 10, 1_000, 10**6) if d <= most]) | st.integers(
        1, most
    )


def _spans(bound: int, least: int = 1) -> st.SearchStrategy[int]:
    """Small ranges before large ones, all of them within a bound and large enough."""
    return st.sampled_from([*(s for s in SPANS if least <= s < bound), max(bound, 1)])


def _side(count: int) -> int:
    """How far coordinates must reach for so many points on a grid round 0."""
    return int(isqrt(count)) // 2 + 1


@st.composite
def _shaken(draw: st.DrawFn, points: list[Place], span: int, bound: int) -> list[Place]:
    """Points within a span, perhaps scaled and moved by next to nothing, within a bound."""
    scale = draw(st.sampled_from([k for k in NEARLY if k * (span + 1) <= bound or k == 1]))
    if scale == 1:
        return points
    # One number for all: its digits to the base of 9 say where each goes, 0 that it stays.
    digits, shaken = draw(st.integers(0, 9 ** len(points) - 1)), []
    for x, y in points:
        digits, digit = divmod(digits, 9)
        shaken.append((scale * x + SHAKES[digit % 3], scale * y + SHAKES[digit // 3]))
    return shaken


@st.composite
def _simple_rings(draw: st.DrawFn, least: int, most: int, bound: int, allow_flat: bool) -> Ring:
    """Simple rings."""
    span = draw(_spans(bound, _side(ROOM * most)))
    number = st.integers(-span, span)
    points = draw(st.lists(st.tuples(number, number), min_size=least, max_size=most, unique=True))
    ring = untangled(off_the_line(draw(_shaken(points, span, bound)), bound))
    ring = draw(_with_flats(ring, most)) if allow_flat else without_flat(ring)
    assume(len(ring) >= least)
    return ring


@st.composite
def _with_flats(draw: st.DrawFn, ring: Ring, most: int) -> Ring:
    """The ring with 180-degree vertices on a few of its edges."""
    for edge in draw(st.lists(st.integers(0, 10**6), max_size=2)):
        if len(ring) < most:
            ring = with_flat(ring, edge % len(ring))
    return ring


@st.composite
def _shifted(draw: st.DrawFn, ring: Ring, bound: int) -> Ring:
    """A ring whose least coordinates are 0, moved within a bound."""
    width, height = max(x for x, _ in ring), max(y for _, y in ring)
    x = draw(st.integers(-bound, bound - width))
    y = draw(st.integers(-bound, bound - height))
    return [(u + x, v + y) for u, v in ring]
