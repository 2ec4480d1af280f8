"""One half-step of Lemma 6: glue neighbouring strips in pairs, cut off what finds no partner."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from bern_exact.interior.subdivided.lattice import Strip, Strips


class Run(NamedTuple):
    """A strip of cells with its developed place.

    The *developed* numbers count lines along the surface, from anywhere: in a polygon
    without holes they are the same along every way.  They count in cells of the present level.

    Parameters
    ----------
    strip : Strip
        Where it is.
    cell : int
        Which cell it is across: between its lines `cell` and `cell + 1`.
    start, end : int
        The developed numbers of the lines that end it.
    """

    strip: Strip
    cell: int
    start: int
    end: int


class Clipping(NamedTuple):
    """A rectangle that was cut off.

    Parameters
    ----------
    strip : Strip
        Where it is.
    across, along : int
        How many cells of the lattice (not of the level) it has in each direction.
    """

    strip: Strip
    across: int
    along: int


@dataclass
class Web:
    """The runs of one direction.

    Parameters
    ----------
    runs : list of Run
        In any order.
    chords : list of (int, int)
        Neighbours: one ends where the other begins, and they have a piece in common.
    unit : int
        Lattice cells that a run is wide.
    """

    runs: list[Run]
    chords: list[tuple[int, int]]
    unit: int


@dataclass
class Piece:
    """A connected part of what is left, at some level.

    Parameters
    ----------
    web, cross : Web
        The runs to be glued next, and those across them.
    budget : int
        How long its boundary may be, in lattice edges.
    mirrored : bool
        Whether `web` holds rows.
    even : bool
        Whether corners go to even lines always, as printed; then the budget may not be kept.
    """

    web: Web
    cross: Web
    budget: int
    mirrored: bool
    even: bool = False

    @property
    def boundary(self) -> int:
        """The length of its boundary in lattice edges."""
        return 2 * (len(self.web.runs) * self.web.unit + len(self.cross.runs) * self.cross.unit)

    def is_rectangle(self) -> bool:
        """Is it one chain of equal runs?"""
        first = self.web.runs[0]
        return all(r.start == first.start and r.end == first.end for r in self.web.runs)

    def whole(self) -> Clipping:
        """The rectangle that it is."""
        runs = self.web.runs
        first = runs[0]
        near = min(r.strip.near for r in runs)
        far = max(r.strip.far for r in runs)
        strip = Strip(near, far, first.strip.low, first.strip.high)
        along = (first.end - first.start) * self.cross.unit
        return Clipping(strip, len(runs) * self.web.unit, along)


def half_step(piece: Piece) -> tuple[list[Clipping], list[Piece]]:
    """Halve one direction of a piece.

    Parameters
    ----------
    piece : Piece
        Without holes.

    Returns
    -------
    clippings : list of Clipping
        What was cut off.
    pieces : list of Piece
        What is left, by connected components, the other direction to be halved next.

    Notes
    -----
    O(k log k) for k runs.
    """
    parity = _choose_parity(piece)
    glued, covers = _glue(piece.web, parity)
    clippings = list(_uncovered(piece, glued, covers))
    chords = list(_chords_of_pairs(piece.web, parity, glued, covers))
    cross = _shortened(piece, parity)
    return clippings, _components(piece, Web(glued, chords, 2 * piece.web.unit), cross)


def _choose_parity(piece: Piece) -> int:
    """The parity of the cells that become the near halves of pairs.

    The paper keeps to even lines; then the boundary can grow ([0, 6] x [0, 4] minus
    [2, 3] x [3, 4]: from 22 to 24).  Here it never exceeds the budget: runs and chords form a
    tree, so for one parity there are fewer pairs than half the runs, and the boundary
    shrinks.  The other is preferred if fewer cross runs end inside its pairs, as
    each such end is cut off, and the budget allows it.
    """
    if piece.even:
        return 0
    pairs = [0, 0]
    for near, _ in piece.web.chords:
        pairs[piece.web.runs[near].cell % 2] += 1
    loose = [0, 0]
    for run in piece.cross.runs:
        # A line inside the pairs of parity p has the other parity.
        loose[1 - run.start % 2] += 1
        loose[1 - run.end % 2] += 1
    few = 0 if pairs[0] <= pairs[1] else 1
    other = 1 - few
    longest = 2 * (2 * piece.web.unit * pairs[other] + piece.cross.unit * len(piece.cross.runs))
    return other if loose[other] < loose[few] and longest <= piece.budget else few


def _glue(web: Web, parity: int) -> tuple[list[Run], list[list[int]]]:
    """The pairs, and for each run the pairs that it is in, from low to high."""
    glued: list[Run] = []
    covers: list[list[int]] = [[] for _ in web.runs]
    for near, far in web.chords:
        first, second = web.runs[near], web.runs[far]
        if first.cell % 2 == parity:
            start, low = max((first.start, first.strip.low), (second.start, second.strip.low))
            end, high = min((first.end, first.strip.high), (second.end, second.strip.high))
            covers[near].append(len(glued))
            covers[far].append(len(glued))
            strip = Strip(first.strip.near, second.strip.far, low, high)
            glued.append(Run(strip, (first.cell - parity) // 2, start, end))
    for pairs in covers:
        pairs.sort(key=lambda g: glued[g].start)
    return glued, covers


def _uncovered(piece: Piece, glued: list[Run], covers: list[list[int]]) -> Iterator[Clipping]:
    """The parts of runs that are in no pair."""
    unit, length = piece.web.unit, piece.cross.unit
    for run, pairs in zip(piece.web.runs, covers, strict=True):
        near, far, low, high = run.strip
        start = run.start
        for g in pairs:
            pair = glued[g]
            if start < pair.start:
                strip = Strip(near, far, low, pair.strip.low)
                yield Clipping(strip, unit, (pair.start - start) * length)
            start, low = pair.end, pair.strip.high
        if start < run.end:
            yield Clipping(Strip(near, far, low, high), unit, (run.end - start) * length)


def _chords_of_pairs(
    web: Web, parity: int, glued: list[Run], covers: list[list[int]]
) -> Iterator[tuple[int, int]]:
    """Neighbouring pairs: across the chords that were not glued."""
    for near, far in web.chords:
        first, second = web.runs[near], web.runs[far]
        if first.cell % 2 != parity:
            start, end = max(first.start, second.start), min(first.end, second.end)
            yield from _overlaps(glued, covers[near], covers[far], start, end)


def _overlaps(
    glued: list[Run], ending: list[int], beginning: list[int], start: int, end: int
) -> Iterator[tuple[int, int]]:
    """The pairs on either side of the chord from `start` to `end` that share a piece of it."""
    i = bisect_right(ending, start, key=lambda g: glued[g].end)
    j = bisect_right(beginning, start, key=lambda g: glued[g].end)
    while i < len(ending) and j < len(beginning):
        first, second = glued[ending[i]], glued[beginning[j]]
        if max(first.start, second.start) >= end:
            return
        if max(first.start, second.start) < min(first.end, second.end):
            yield (ending[i], beginning[j])
        if first.end <= second.end:
            i += 1
        else:
            j += 1


def _shortened(piece: Piece, parity: int) -> Web:
    """The cross runs without the cells that were cut off at their ends."""
    web, cross = piece.web, piece.cross
    places = Strips([run.strip for run in web.runs])
    kept: list[Run] = []
    number = [-1] * len(cross.runs)
    for i, run in enumerate(cross.runs):
        start, end = run.start + (run.start - parity) % 2, run.end - (run.end - parity) % 2
        if start >= end:
            continue
        near, far, low, high = run.strip
        if start > run.start:
            low = web.runs[places.after(low, near)].strip.far
        if end < run.end:
            high = web.runs[places.before(high, near)].strip.near
        number[i] = len(kept)
        strip = Strip(near, far, low, high)
        kept.append(Run(strip, run.cell, (start - parity) // 2, (end - parity) // 2))
    chords = [
        (number[a], number[b])
        for a, b in cross.chords
        if number[a] >= 0 and number[b] >= 0 and _touch(kept[number[a]], kept[number[b]])
    ]
    return Web(kept, chords, cross.unit)


def _touch(first: Run, second: Run) -> bool:
    """Do two runs, neighbours once, still have a piece in common?"""
    return max(first.start, second.start) < min(first.end, second.end)


def _components(piece: Piece, web: Web, cross: Web) -> list[Piece]:
    """What is left as connected pieces, each with its share of the budget, by its boundary."""
    component = _labels(len(web.runs), web.chords)
    places = Strips([run.strip for run in web.runs])
    of_cross = [component[places.after(run.strip.low, run.strip.near)] for run in cross.runs]
    webs = _split(web, component)
    crosses = _split(cross, of_cross)
    pieces = [
        Piece(b, a, 0, not piece.mirrored, piece.even) for a, b in zip(webs, crosses, strict=True)
    ]
    boundary = sum(part.boundary for part in pieces)
    for part in pieces:
        part.budget = piece.budget * part.boundary // boundary
    return pieces


def _labels(count: int, chords: Sequence[tuple[int, int]]) -> list[int]:
    """For each run the number of its connected component, in the order of first runs."""
    neighbours: list[list[int]] = [[] for _ in range(count)]
    for a, b in chords:
        neighbours[a].append(b)
        neighbours[b].append(a)
    label = [-1] * count
    components = 0
    for first in range(count):
        if label[first] < 0:
            label[first] = components
            waiting = [first]
            while waiting:
                for other in neighbours[waiting.pop()]:
                    if label[other] < 0:
                        label[other] = components
                        waiting.append(other)
            components += 1
    return label


def _split(web: Web, label: list[int]) -> list[Web]:
    """A web by components."""
    parts = [Web([], [], web.unit) for _ in range(max(label, default=-1) + 1)]
    number = []
    for run, part in zip(web.runs, label, strict=True):
        number.append(len(parts[part].runs))
        parts[part].runs.append(run)
    for a, b in web.chords:
        parts[label[a]].chords.append((number[a], number[b]))
    return parts
