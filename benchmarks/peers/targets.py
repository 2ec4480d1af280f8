"""What the comparison was to show, met or not, decided from the exact figures."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from gmpy2 import mpq

from benchmarks.peers.figures import degrees, root
from benchmarks.peers.judging import Judged
from benchmarks.peers.runs import Record
from bern_exact.exact.angles import ANGLE_150
from bern_exact.figures import digits_of

RIVAL = "triangle-15"
"""The peer whose number of triangles is to be beaten."""

MOST_ON_AVERAGE = mpq(115, 100)
MOST = mpq(13, 10)
TIMES_HIGHER = 10

Found = Mapping[tuple[str, str], Record]
"""(case, mesher) -> record."""


@dataclass(frozen=True)
class Target:
    """One target: its statement, what was measured, and whether that is enough."""

    statement: str
    measured: str
    met: bool | None

    @property
    def answer(self) -> str:
        """In a word."""
        return "not measured" if self.met is None else "met" if self.met else "**not met**"


def by_case(records: Iterable[Record]) -> Found:
    """The records by case and mesher."""
    return {(record.case, record.mesher): record for record in records}


def targets(records: Sequence[Record]) -> list[Target]:
    """All of them, in order."""
    found = by_case(records)
    outlines = [r for r in records if r.mesher == "thin" and r.case.startswith(("ne_", "us_"))]
    stars = [r for r in records if r.mesher == "thin" and r.family == "star"]
    real = [r for r in records if r.mesher == "thin" and r.family == "outline"]
    return [
        _fewer("every outline `ne_*`, `us_*`", outlines, found),
        _fewer("stars wherever it ends", stars, found),
        _average(real),
        _largest(real),
        _higher("every outline `ne_*`, `us_*`", outlines, found),
        _higher("every real polygon", real, found),
        _within([r for r in records if r.mesher in ("raw", "thin")]),
    ]


def _fewer(where: str, ours: Sequence[Record], found: Found) -> Target:
    """Fewer triangles than the rival."""
    statement = f"Fewer triangles than Triangle `-pq15`: {where}"
    pairs = [
        (record, rival)
        for record in ours
        if (rival := found.get((record.case, RIVAL))) and rival.triangles is not None
    ]
    if not pairs:
        return Target(statement, "", None)
    fewer = [a for a, b in pairs if a.triangles is not None and a.triangles < (b.triangles or 0)]
    least = max(pairs, key=lambda pair: mpq(pair[0].triangles or 10**9, pair[1].triangles or 1))
    measured = (
        f"{len(fewer)} of {len(pairs)}; nearest on {least[0].case}: "
        f"{least[0].triangles or 0:,} against {least[1].triangles or 0:,}"
    )
    return Target(statement, measured, len(fewer) == len(pairs))


def _average(real: Sequence[Record]) -> Target:
    """Triangles a vertex of real polygons, on average."""
    most = digits_of(MOST_ON_AVERAGE)
    statement = f"Thinned: at most {most} triangles a vertex, averaged over the real polygons"
    if not real or any(r.triangles is None for r in real):
        return Target(statement, "", None if not real else False)
    mean = sum((_per_vertex(r) for r in real), mpq(0)) / len(real)
    return Target(statement, _digits(mean), mean <= MOST_ON_AVERAGE)


def _largest(real: Sequence[Record]) -> Target:
    """Triangles a vertex of real polygons, at most, where fewer are possible at all."""
    statement = (
        f"Thinned: none above {digits_of(MOST)} a vertex, or above (n + 2 holes - 2)/n, "
        "which no mesh can undercut, if that is more"
    )
    if not real or any(r.triangles is None for r in real):
        return Target(statement, "", None if not real else False)
    worst = max(real, key=_per_vertex)
    excess = max(real, key=lambda r: _per_vertex(r) / _least(r))
    measured = (
        f"{_digits(_per_vertex(worst))} on {worst.case} (least possible {_digits(_least(worst))}); "
        f"farthest above the least possible: {_digits(_per_vertex(excess) / _least(excess))} "
        f"times on {excess.case}"
    )
    return Target(statement, measured, all(_per_vertex(r) <= max(MOST, _least(r)) for r in real))


def _per_vertex(record: Record) -> mpq:
    return mpq(record.triangles or 0, record.n)


def _least(record: Record) -> mpq:
    """The least number of triangles a vertex that any triangulation has."""
    return mpq(record.n + 2 * record.holes - 2, record.n)


def _higher(where: str, ours: Sequence[Record], found: Found) -> Target:
    """The thinned mesh's least height over the raw mesh's, as squares."""
    statement = f"Thinned: least height at least {TIMES_HIGHER} times the raw mesh's, {where}"
    ratios = []
    for record in ours:
        thin, raw = _height(record), _height(found.get((record.case, "raw")))
        if not thin or not raw:
            return Target(statement, f"no figures of {record.case}", False)
        ratios.append((thin / raw, record.case))
    if not ratios:
        return Target(statement, "", None)
    least, case = min(ratios)
    measured = f"least {root(least)} times, on {case}"
    return Target(statement, measured, least >= TIMES_HIGHER**2)


def _height(record: Record | None) -> mpq | None:
    """The squared least height, if it was measured."""
    return record.judged.min_height_squared if record and record.judged else None


def _within(ours: Sequence[Record]) -> Target:
    """Our meshes: valid, and no angle above the bound."""
    statement = "Ours, raw and thinned, every polygon: exactly valid, no angle above 150 degrees"
    if not ours:
        return Target(statement, "", None)
    verdicts = [r.judged for r in ours if r.judged is not None]
    good = [judged for judged in verdicts if is_within(judged) and judged.valid]
    angles = [judged.max_angle for judged in verdicts if judged.max_angle]
    measured = f"{len(good)} of {len(ours)}"
    if angles:
        largest = min(angles, key=lambda found: found.signed_square)
        measured += f"; largest angle {degrees(largest)}"
    return Target(statement, measured, len(good) == len(ours))


def is_within(judged: Judged) -> bool:
    """Is no angle above 150 degrees?"""
    return judged.max_angle is not None and judged.max_angle.is_at_most(ANGLE_150)


def _digits(value: mpq) -> str:
    return digits_of(value, 4).replace("...", "")
