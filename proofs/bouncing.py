"""Section 5's bouncing ends: at most 9 n verticals.

**Setting.**  T and L are the flats of the upper and the lower chain (a peak is a flat of one
point), T no further left than L by their middles; M is the middle, from the first to the last point
of both flats, the zones R and Z are right and left of it.  A *path* is a subdivision pending at
first and what it becomes; at any time at most one is pending of each, at (x, side).  Bouncing it
draws the vertical at x and leaves (sigma_other(x), other), or nothing.  A path is *clockwise* if it
is pending at (R, upper) or (Z, lower), *counter-clockwise* at (R, lower) or (Z, upper).

**(1) The middle.**  Every path is bounced there at most once, and is clockwise afterwards or over.
Nothing is pending inside its own side's flat, where sigma has no value, nor at its ends, which
are vertices.  If one flat contains the other, M is that flat: what is pending in M is on the other
side, and its vertical ends inside the flat: over.  Otherwise L begins and ends first.  In M, upper
side: x is left of T; within L it is over, right of L it goes to sigma_lower(x) in Z, lower side:
clockwise.  Lower side: x is right of L; within T it is over, left of T it goes to R, upper side:
clockwise.  And a clockwise path that meets M is over there: from (R, upper) it goes left of L, from
(Z, lower) right of T, which is in M only if one flat contains the other.

**(2) Strips.**  sigma maps the right and left of a chain's flat to each other, reversing order; so
F, from one place on the right to the next of the same sense, grows with the place.  Its fixed
points c, the closed paths, are the same for both senses: they cut R, and Z with it, into strips.
A path never leaves its strip.  Nor does it by turning in M, in the innermost one: from x in M,
between the verticals of every closed path, both chains are at least as high as at these, and so
its horizontal ends within them.  In a strip all paths of one sense move outward, or all inward.
By the place on the right where it is, or would come to be next, a path on the left has a place,
too: going right keeps it, going left moves it ahead.

**(3) Half-steps.**  A half-step outside M is made where two neighbours p, q of a sense are in one
triangle and one strip; the one ahead, q, is bounced, and p stays.  Of all such pairs that with the
least place of q, in the direction of motion, comes first.  So these places never fall in a strip:
what q leaves has a place of at least q's, and so have the pairs it makes.  Hence nothing
comes into p's triangle any more, which ends at q's vertical: all that arrives is at q's place or
ahead.  What is behind p in the triangle would have made a pair with p, of a lesser place, before.
So p is never bounced nor in such a pair again: each path stays once at most, and there are at
most as many half-steps outside M as paths.  Counter-clockwise ones are done first; by (1)
none is made later.

**(4) Closed paths.**  One is added for neighbours p, q in one triangle if one of them is on it, or
if it lies between them (the next after p).  In the first case that path is over, and has been in no
pair of the second case, as the first is asked first.  In the second case draw an edge between the
paths p and q.  By (2) a path is on the same side of each closed path for ever, turned or not.  An
edge spans its own closed path and none that was added before, which would part the triangle.
Suppose that edges form a cycle, and take the one drawn first, of c.  The other edges of the cycle
join its ends, on both sides of c: one of them spans c, and was drawn later.  A contradiction.
So edges are a forest, fewer than paths: in all at most as many closed paths as paths.

**(5)** There are at most 2 (n - 2) paths: n + 2 (2 n) + 2 (2 n) = 9 n verticals.  If AB is an edge
of P, each path is over at its first bounce, and there are no closed ones.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product

from bern_exact.checkers import bounds_bounce
from bern_exact.checkers.chords import Turns
from bern_exact.convex.bounce import bounce
from bern_exact.convex.frame import convex_frame
from bern_exact.convex.records import Bounced, HalfStep, Pending
from bern_exact.corpus.convex import hull
from bern_exact.exact.points import hpoint
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings
from proofs.algebra import demand_equal, symbols
from proofs.statement import ENUMERATION, IDENTITY, Chapter, demand

CHAPTER = Chapter()
statements = CHAPTER.statements

QUICK, FULL = (4, 4), (5, 4)
"""Grids of which all convex polygons are bounced."""


@CHAPTER.proved(
    "Section 5",
    "There are at most 2 (n - 2) subdivision points before bouncing.",
    "written proof",
)
def first_subdivisions() -> str:
    """A vertical through each vertex but A and B has two ends, each with one horizontal.

    That goes along the chord to the one other point of the boundary at that height on that side,
    and makes at most one subdivision there.
    """
    for size in range(2, 20):
        demand(bounds_bounce.first_subdivisions(size) == 2 * (size - 2), f"n = {size}")
    return "two ends a vertical"


@CHAPTER.proved(
    "Section 5 (repaired)",
    "At most as many half-steps outside the middle, half-steps in it, and closed paths as "
    "subdivision points at first, each: at most 9 n verticals.",
    IDENTITY,
)
def verticals() -> str:
    """The module's docstring."""
    n, first, turned = symbols("n first turned")
    demand_equal(bounds_bounce.half_steps(first, turned), first + turned, "(3)")
    demand_equal(bounds_bounce.middle_steps(first), first, "(1)")
    demand_equal(bounds_bounce.closed_paths(first), first, "(4)")
    demand_equal(bounds_bounce.verticals(n), n + 2 * 2 * n + 2 * 2 * n, "(5)")
    return "n + 2 (2 n) + 2 (2 n) = 9 n"


@CHAPTER.proved(
    "Section 5 (repaired)",
    "Each path stays once at most, is in the middle once at most, and closed paths are fewer than "
    "paths or none, on all convex polygons with vertices on a grid of 4 x 4 points.",
    ENUMERATION,
)
def all_polygons_on_a_small_grid() -> str:
    """Steps (1), (3) and (4), followed path by path."""
    return _enumerate(*QUICK)


@CHAPTER.proved(
    "Section 5 (repaired)",
    "The same on a grid of 5 x 4 points.",
    ENUMERATION,
    full=True,
)
def all_polygons_on_a_larger_grid() -> str:
    """Steps (1), (3) and (4), followed path by path."""
    return _enumerate(*FULL)


def _enumerate(width: int, height: int) -> str:
    polygons = half_steps = closed = 0
    for polygon in convex_polygons(width, height):
        bounced = bounce(convex_frame(polygon))
        follow(bounced)
        polygons += 1
        half_steps += len(bounced.steps)
        closed += len(bounced.closed)
    return f"{polygons} polygons, {half_steps} half-steps, {closed} closed paths"


def convex_polygons(width: int, height: int) -> Iterator[Polygon]:
    """All strictly convex polygons on a grid that touch its left and its lower side."""
    columns = [[(x, y) for y in range(height)] for x in range(width)]
    # Of each column at most the lowest and the highest vertex: two of them, one or none.
    choices = [[(), *combinations(column, 1), *combinations(column, 2)] for column in columns]
    for chosen in product(*choices):
        points = [p for column in chosen for p in column]
        if len(points) > 2 and chosen[0] and min(y for _, y in points) == 0:
            ring = hull(points)
            if len(ring) == len(points):
                yield polygon_from_rings([[hpoint(x, y) for x, y in ring]])


def follow(bounced: Bounced) -> None:
    """Follow every path through the events.

    Raises
    ------
    NotShown
        If a path stays twice, is bounced after it stayed, or is in the middle twice, or if there
        are too many closed paths.
    """
    turns = Turns(bounced.frame)
    path: dict[Pending, int] = {p: i for i, p in enumerate(bounced.first)}
    stayed: set[int] = set()
    middle: set[int] = set()
    for event in bounced.events:
        if not isinstance(event, HalfStep):
            continue
        here = path.pop(Pending(event.x, event.side))
        demand(here not in stayed or bounced.frame.one_sided, "(3) bounced after it stayed")
        if event.stays is None:
            demand(turns.zone(event.x) == 0 and here not in middle, "(1) the middle twice")
            middle.add(here)
        elif not bounced.frame.one_sided:
            left_behind = path[Pending(event.stays, event.side)]
            demand(left_behind not in stayed, "(3) stays twice")
            stayed.add(left_behind)
        if event.left is not None:
            path[event.left] = here
    first = len(bounced.first)
    outside = len(bounced.steps) - len(middle)
    demand(outside <= first and len(bounced.closed) <= first, "(3), (4)")
