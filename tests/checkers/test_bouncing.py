"""The checkers of the frame and of the bouncing notice every damage."""

from __future__ import annotations

from dataclasses import replace

import pytest
from gmpy2 import mpq

from bern_exact.checkers import strips
from bern_exact.checkers.bouncing import check_bouncing
from bern_exact.checkers.diameter import check_diameter
from bern_exact.checkers.printed_bounces import check_bouncing_as_printed
from bern_exact.checkers.strips import check_f
from bern_exact.convex.bounce import bounce
from bern_exact.convex.frame import convex_frame
from bern_exact.convex.records import Bounced, Chain, ClosedPath, ConvexFrame, HalfStep, Pending
from tests.convex.polygons import family, polygon

FRAME = convex_frame(family("random-hull", 16))
GOOD = bounce(FRAME)
SPIRAL = bounce(convex_frame(family("clustered-spiral", 10)))
CLOSING = bounce(convex_frame(family("random-hull", 40)))


def failing(record: Bounced) -> set[str]:
    return {found.claim for found in check_bouncing(record) if not found.holds}


def failing_frame(frame: ConvexFrame) -> set[str]:
    return {found.claim for found in check_diameter(frame) if not found.holds}


def settling(record: Bounced) -> tuple[int, HalfStep]:
    """The first half-step that leaves one alone, and its number."""
    for i, event in enumerate(record.events):
        if isinstance(event, HalfStep) and event.stays is not None:
            return i, event
    raise AssertionError("there is none")


def without(record: Bounced, i: int) -> Bounced:
    """The record without one event; its verticals stay."""
    return replace(record, events=record.events[:i] + record.events[i + 1 :])


@pytest.mark.parametrize("record", [GOOD, SPIRAL, CLOSING])
def test_the_good_ones_pass(record: Bounced) -> None:
    assert not failing(record)


def test_no_subdivision_at_all() -> None:
    """A kite's grid has none: no triangle has more than 0, and all of them were looked at."""
    kite = polygon([[(0, 0), (2, -1), (4, 0), (2, 1)]])
    found = {f.claim: f for f in check_bouncing(bounce(convex_frame(kite)))}
    assert all(f.holds for f in found.values())


def test_a_diameter_that_is_none() -> None:
    other = next(v for v in range(FRAME.polygon.n) if v not in (FRAME.a, FRAME.b))
    assert "diameter.longest" in failing_frame(replace(FRAME, b=other))


def test_a_vertex_elsewhere() -> None:
    places = list(FRAME.places)
    v = next(v for v in range(FRAME.polygon.n) if v not in (FRAME.a, FRAME.b))
    places[v] = (places[v][0], places[v][1] + mpq(1, 10**9))
    assert {"diameter.frame", "diameter.chains"} <= failing_frame(
        replace(FRAME, places=tuple(places))
    )


def test_a_similarity_that_does_something_else() -> None:
    s = FRAME.similarity
    others = [
        replace(s, b=-s.b),
        replace(s, u=s.u + 1),
        replace(s, v=s.v - 1),
        replace(s, d=2 * s.d),
    ]
    for other in others:
        assert failing_frame(replace(FRAME, similarity=other)) == {"diameter.similarity"}


def test_a_place_too_few_or_too_many() -> None:
    for places in (FRAME.places[:-1], (*FRAME.places, FRAME.places[0])):
        assert "diameter.frame" in failing_frame(replace(FRAME, places=places))


def test_a_and_b_swapped() -> None:
    """The frame turned by 180 degrees is right in all but which of them is the first."""
    upper, lower = (
        Chain(tuple(1 - x for x in reversed(chain.xs)), chain.hs[::-1]) for chain in FRAME.chains
    )
    s = FRAME.similarity
    turned = replace(
        FRAME,
        a=FRAME.b,
        b=FRAME.a,
        places=tuple((1 - x, -y) for x, y in FRAME.places),
        chains=(lower, upper),
        similarity=replace(s, a=-s.a, b=-s.b, u=s.d - s.u, v=-s.v),
    )
    assert failing_frame(turned) == {"diameter.first"}


def test_another_pair_as_far_apart() -> None:
    """A square's other diagonal."""
    frame = convex_frame(polygon([[(0, 0), (1, 0), (1, 1), (0, 1)]]))
    assert not failing_frame(frame)
    found = failing_frame(replace(frame, a=3, b=1))
    assert "diameter.first" in found
    assert "diameter.longest" not in found


def test_a_chain_without_a_vertex() -> None:
    upper, lower = FRAME.chains
    shorter = Chain(upper.xs[:1] + upper.xs[2:], upper.hs[:1] + upper.hs[2:])
    assert failing_frame(replace(FRAME, chains=(shorter, lower))) == {"diameter.chains"}


def test_a_chain_with_a_height_too_few() -> None:
    upper, lower = FRAME.chains
    shorter = Chain(upper.xs, upper.hs[:-1])
    assert failing_frame(replace(FRAME, chains=(shorter, lower))) == {"diameter.chains"}


def test_chains_swapped() -> None:
    assert failing_frame(replace(FRAME, chains=FRAME.chains[::-1])) == {"diameter.chains"}


def test_a_first_subdivision_left_out() -> None:
    assert failing(replace(GOOD, first=GOOD.first[1:])) >= {"bounce.first"}


def test_a_first_subdivision_twice() -> None:
    assert "bounce.first" in failing(replace(GOOD, first=(*GOOD.first, GOOD.first[0])))


def test_a_half_step_left_out_of_the_record() -> None:
    assert "bounce.record" in failing(without(GOOD, 0))


def test_a_half_step_that_was_not_made() -> None:
    i = next(i for i, step in enumerate(SPIRAL.events) if step == SPIRAL.steps[-1])
    less = tuple(x for x in SPIRAL.verticals if x != SPIRAL.steps[-1].x)
    assert "bounce.alone" in failing(replace(without(SPIRAL, i), verticals=less))


def test_a_half_step_from_nowhere() -> None:
    a, b = GOOD.verticals[1:3]
    step = HalfStep((a + b) / 2, 0, None, None)
    assert "bounce.paths" in failing(replace(GOOD, events=(step, *GOOD.events)))


def test_a_half_step_that_leaves_another_subdivision() -> None:
    i = next(i for i, s in enumerate(SPIRAL.events) if isinstance(s, HalfStep) and s.left)
    step = SPIRAL.events[i]
    assert isinstance(step, HalfStep) and step.left
    for left in (None, Pending(step.left.x, 1 - step.left.side)):
        events = (*SPIRAL.events[:i], step._replace(left=left), *SPIRAL.events[i + 1 :])
        assert failing(replace(SPIRAL, events=events)) == {"bounce.paths"}


def test_the_nearer_one_bounced() -> None:
    i, step = next(
        (i, s) for i, s in enumerate(SPIRAL.events) if isinstance(s, HalfStep) and s.stays
    )
    swapped = step._replace(x=step.stays, stays=step.x)
    events = (*SPIRAL.events[:i], swapped, *SPIRAL.events[i + 1 :])
    assert "bounce.strips" in failing(replace(SPIRAL, events=events))


def test_a_step_outside_the_middle_that_settles_nothing() -> None:
    i, step = next(
        (i, s) for i, s in enumerate(SPIRAL.events) if isinstance(s, HalfStep) and s.stays
    )
    events = (*SPIRAL.events[:i], step._replace(stays=None), *SPIRAL.events[i + 1 :])
    assert failing(replace(SPIRAL, events=events)) == {"bounce.strips"}


def test_a_closed_path_that_does_not_close() -> None:
    i, path = next((i, s) for i, s in enumerate(CLOSING.events) if isinstance(s, ClosedPath))
    near = ClosedPath(path.x, path.partner + mpq(1, 10**30))
    events = (*CLOSING.events[:i], near, *CLOSING.events[i + 1 :])
    assert {"bounce.closed", "bounce.record"} <= failing(replace(CLOSING, events=events))


def test_strips_mixed_without_closed_paths() -> None:
    # Only where closed paths part subdivisions: without one those two share a triangle.
    i = next(i for i, event in enumerate(CLOSING.events) if isinstance(event, ClosedPath))
    path = CLOSING.events[i]
    assert isinstance(path, ClosedPath)
    less = tuple(x for x in CLOSING.verticals if x not in path)
    assert "bounce.alone" in failing(replace(without(CLOSING, i), verticals=less))


def test_too_many_verticals() -> None:
    more = [mpq(i, 10**4) for i in range(1, 9 * FRAME.polygon.n)]
    verticals = tuple(sorted({*GOOD.verticals, *more}))
    assert failing(replace(GOOD, verticals=verticals)) == {"bounce.record", "bounce.verticals"}


def test_too_many_steps_and_turns_and_closed_paths() -> None:
    middle = HalfStep(mpq(1, 2), 0, None, None)
    path = ClosedPath(mpq(2, 3), mpq(1, 3))
    spare = (middle, path) * (len(GOOD.first) + 1)
    settled = HalfStep(mpq(1, 2), 0, None, mpq(1, 3))
    found = failing(replace(GOOD, events=(*GOOD.events, *spare)))
    assert {"bounce.turned", "bounce.closed-paths"} <= found
    many = replace(GOOD, events=(*GOOD.events, *((settled,) * len(GOOD.first))))
    assert "bounce.half-steps" in failing(many)


def test_more_subdivisions_than_a_vertex_makes() -> None:
    many = tuple(Pending(mpq(i, 1000), 0) for i in range(1, 2 * FRAME.polygon.n))
    assert {"bounce.first", "bounce.subdivisions"} <= failing(replace(GOOD, first=many))


def test_f_on_a_chain_that_rises_again() -> None:
    points = [(0, 0), (4, -3), (9, 0), (8, mpq(3, 2)), (6, 3), (3, 2)]
    frame = convex_frame(polygon([points]))
    upper, lower = frame.chains
    again = (*upper.hs[:-3], upper.hs[-2] / 2, upper.hs[-2], upper.hs[-1])
    chains = (Chain(upper.xs, again), lower)
    found = {f.claim for f in check_f(replace(frame, chains=chains)) if not f.holds}
    assert found & {"bounce.f-monotone", "bounce.f-continuous"}


def test_an_f_that_jumps(monkeypatch: pytest.MonkeyPatch) -> None:
    true_f = strips._f
    half = mpq(9, 10)
    monkeypatch.setattr(strips, "_f", lambda a, b, x: true_f(a, b, x) - (x > half))
    found = {f.claim for f in check_f(FRAME) if not f.holds}
    assert {"bounce.f-continuous", "bounce.f-monotone"} <= found


def test_an_f_with_more_pieces_than_vertices(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(strips, "_breaks", lambda *_: [1 - mpq(1, 2**i) for i in range(2, 40)])
    assert {f.claim for f in check_f(FRAME) if not f.holds} >= {"bounce.f-pieces"}


@pytest.mark.parametrize("claim", ["bounce.printed-return", "bounce.printed-order"])
def test_the_printed_sentences_are_false(claim: str) -> None:
    record = bounce(convex_frame(family("occupied-spiral", 16)))
    assert not failing(record)
    (found,) = [f for f in check_bouncing_as_printed(record) if f.claim == claim]
    assert found.role == "as-printed" and not found.holds


def test_the_printed_sentences_say_nothing_of_one_sided_polygons() -> None:
    record = bounce(convex_frame(family("arc", 20)))
    assert all(found.holds for found in check_bouncing_as_printed(record))
