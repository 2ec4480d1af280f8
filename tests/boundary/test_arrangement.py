"""Walking in the arrangement, against a list of all its crossings."""

from __future__ import annotations

from bisect import bisect_left

from hypothesis import given
from hypothesis import strategies as st

from bern_exact.boundary.arrangement import EAST, NORTH, SOUTH, WEST, Arrangement, StabbingIndex
from bern_exact.boundary.records import HORIZONTAL, VERTICAL
from tests.boundary.naive import NaiveArrangement
from tests.boundary.samples import drawn, every_family

SIZE = 11

spans = st.lists(
    st.tuples(st.integers(0, 9), st.integers(0, SIZE - 1), st.integers(0, SIZE - 1)), max_size=30
).map(sorted)


@given(spans, st.integers(1, SIZE), st.integers(-1, 10))
def test_stabbing_queries(found: list[tuple[int, int, int]], size: int, line: int) -> None:
    found = [(at, first, min(last, size - 1)) for at, first, last in found if first < size]
    index = StabbingIndex(found, size)
    for leaf in range(size):
        stabbed = [at for at, first, last in found if first <= leaf <= last]
        up, down = index.next_from(leaf, line), index.last_until(leaf, line)
        assert (up and up[0]) == min((at for at in stabbed if at >= line), default=None)
        assert (down and down[0]) == max((at for at in stabbed if at <= line), default=None)
        for answer in (up, down):
            if answer is not None:
                at, first, last = found[answer[1]]
                assert at == answer[0] and first <= leaf <= last


@every_family
def test_steps_visit_every_crossing_of_an_interval(kind: str, seed: int) -> None:
    diced = drawn(kind, seed).diced
    arrangement, naive = Arrangement(diced), NaiveArrangement(diced)
    for axis, intervals in ((VERTICAL, diced.vertical), (HORIZONTAL, diced.horizontal)):
        for number in range(len(intervals)):
            expected = naive.along(axis, number)
            for up, chain in ((True, expected), (False, expected[::-1])):
                heading = ((NORTH, SOUTH), (EAST, WEST))[axis][not up]
                walked = [chain[0]]
                step = arrangement.step_from_crossing(int(chain[0]) - naive.n)
                while step.crossing < 0:
                    line = intervals[number].line
                    node = (line, step.line) if axis == VERTICAL else (step.line, line)
                    across = (diced.horizontal, diced.vertical)[axis][step.interval]
                    assert across.line == step.line
                    assert arrangement.through[node][axis] == number
                    walked.append(node)
                    step = arrangement.step_from_node(node, heading)
                assert [*walked, naive.n + step.crossing] == chain


@every_family
def test_inner_neighbours_are_the_first_crossings_inwards(kind: str, seed: int) -> None:
    traced = drawn(kind, seed).traced
    naive = NaiveArrangement(traced.diced)
    for chain in naive.chains[: -naive.n]:
        for end, neighbour in ((chain[0], chain[1]), (chain[-1], chain[-2])):
            inner = neighbour if isinstance(neighbour, tuple) else None
            assert traced.inner[int(end) - naive.n] == inner


@every_family
def test_anchors_are_the_first_lines_in_use_outwards(kind: str, seed: int) -> None:
    traced = drawn(kind, seed).traced
    naive = NaiveArrangement(traced.diced)
    for chain in naive.chains[: -naive.n]:
        low, high = (int(end) - naive.n for end in (chain[0], chain[-1]))
        for j, outwards in ((low, -1), (high, 0)):
            q = traced.diced.crossings[j]
            lines = traced.diced.ys if q.axis == VERTICAL else traced.diced.xs
            line = lines[bisect_left(lines, q.at) + outwards]
            assert traced.anchors[j] == ((q.line, line) if q.axis == VERTICAL else (line, q.line))
