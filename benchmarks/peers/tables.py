"""The comparison as Markdown."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from gmpy2 import mpq

from benchmarks.peers import figures
from benchmarks.peers.cases import FAMILIES
from benchmarks.peers.judging import Judged
from benchmarks.peers.meshers import Mesher
from benchmarks.peers.runs import Limits, Record
from benchmarks.peers.targets import Found, by_case, is_within, targets

MEASURES: Sequence[tuple[str, Callable[[Record], str]]] = (
    ("Triangles", figures.triangles),
    ("Largest angle, degrees; bold: above 150", figures.angle),
    ("Least height, to the feature size", figures.height),
    (
        "Boundary and validity: exact, or how many boundary vertices lie off the polygon's edges "
        "by rounding, or what is wrong",
        figures.boundary,
    ),
    ("Seconds; of ours without / with every check", figures.seconds),
)

LEAST_SECONDS = 1e-4
"""A shorter time is taken to be this one."""


def report(records: Sequence[Record], meshers: Sequence[Mesher], limits: Limits) -> str:
    """Everything, as Markdown without a title."""
    found = by_case(records)
    parts = [
        "### What was to be shown",
        target_table(records),
        "### Peer by peer",
        peer_table(records, meshers),
        _how(meshers, limits),
    ]
    for title, cell in MEASURES:
        parts += [f"### {title}", measure_table(records, meshers, found, cell)]
    notes = sorted(f"- {r.case}, {r.mesher}: {r.outcome}, {r.detail}" for r in records if r.detail)
    if notes:
        parts += ["### What went wrong", "\n".join(notes)]
    return "\n\n".join(parts)


def _how(meshers: Sequence[Mesher], limits: Limits) -> str:
    """How it was measured."""
    settings = "\n".join(f"- {m.title}: {m.setting}." for m in meshers)
    families = "\n".join(f"- {family}: {what}." for family, what in FAMILIES.items())
    return (
        "### How it was measured\n\n"
        "Each mesher runs in a process of its own. Seconds are processor time of the meshing "
        f"alone; a mesher is stopped after {limits.cap:.0f} s (each run of ours after "
        f"{limits.our_cap:.0f} s) or at {limits.most / 2**30:.0f} GiB. Peers compute in doubles: "
        "they are given the polygon whose coordinates are the doubles nearest to the exact ones "
        "and judged against that; ours are given the exact polygon. Angles, heights, boundaries "
        "and validity are decided exactly, from the very doubles that a peer returns; digits are "
        "cut off, not rounded. No mesh has a least height above the feature size (Definition 1)."
        f"\n\n{settings}\n\nThe polygons:\n\n{families}"
    )


def row(cells: Iterable[object]) -> str:
    """A row of a table."""
    return f"| {' | '.join(map(str, cells))} |"


def target_table(records: Sequence[Record]) -> str:
    """The targets, one row each."""
    lines = [row(("target", "measured", "")), row(("---", "---", "---"))]
    lines += [row((t.statement, t.measured, t.answer)) for t in targets(records)]
    return "\n".join(lines)


def measure_table(
    records: Sequence[Record],
    meshers: Sequence[Mesher],
    found: Found,
    cell: Callable[[Record], str],
) -> str:
    """One measure of all cases and meshers."""
    lines = [
        row(("polygon", "n", *(m.title for m in meshers))),
        row(("---", "--:", *("--:" for _ in meshers))),
    ]
    for case in dict.fromkeys(record.case for record in records):
        present = [found.get((case, mesher.name)) for mesher in meshers]
        n = next(record.n for record in present if record)
        cells = [cell(record) if record else figures.NOTHING for record in present]
        lines.append(row((case, f"{n:,}", *cells)))
    return "\n".join(lines)


def peer_table(records: Sequence[Record], meshers: Sequence[Mesher]) -> str:
    """For each peer on how many polygons it ends, keeps what it should, and beats ours thinned."""
    head = (
        "mesher",
        "ended",
        "exactly valid",
        "valid but for rounding",
        "farthest off, to the feature size",
        "no angle above 150",
        "fewer triangles than thinned",
        "of these no angle above 150",
        "higher least height",
        "smaller largest angle",
        "faster",
    )
    lines = [row(head), row(("---", *("--:" for _ in head[1:])))]
    thin = {record.case: record for record in records if record.mesher == "thin"}
    for mesher in meshers:
        own = [record for record in records if record.mesher == mesher.name]
        lines.append(row((mesher.title, *_counts(own, thin))))
    return "\n".join(lines)


def _counts(own: Sequence[Record], thin: dict[str, Record]) -> list[str]:
    """The cells of a peer's row."""
    verdicts = [record.judged for record in own if record.judged]
    pairs = [(r, thin[r.case]) for r in own if r.case in thin and r.mesher != "thin"]
    ended = [(a, b) for a, b in pairs if a.outcome == "ended"]
    both = [(a, b, a.judged, b.judged) for a, b in ended if a.judged and b.judged]
    fewer = [a for a, b in ended if (a.triangles or 0) < (b.triangles or 0)]
    higher = [
        a for a, _, x, y in both if (x.height_ratio_squared or 0) > (y.height_ratio_squared or 0)
    ]
    smaller = [
        a
        for a, _, x, y in both
        if x.max_angle and y.max_angle and not y.max_angle.is_at_most(x.max_angle)
    ]
    counts = [
        f"{sum(r.outcome == 'ended' for r in own)} of {len(own)}",
        str(sum(judged.valid for judged in verdicts)),
        str(sum(judged.is_valid_but_for_rounding for judged in verdicts)),
        _farthest(verdicts),
        str(sum(map(is_within, verdicts))),
    ]
    if not pairs:
        return counts + [figures.NOTHING] * 5
    calm = [a for a in fewer if a.judged and is_within(a.judged)]
    return [*counts, *(str(len(found)) for found in (fewer, calm, higher, smaller)), _faster(ended)]


def _faster(pairs: Sequence[tuple[Record, Record]]) -> str:
    """How often a peer is faster than ours, and how many times on half of the polygons."""
    times = sorted(
        b.seconds / max(a.seconds, LEAST_SECONDS)
        for a, b in pairs
        if a.seconds is not None and b.seconds is not None
    )
    faster = [ratio for ratio in times if ratio > 1]
    middle = f", {times[len(times) // 2]:.0f} times in the median" if times else ""
    return f"{len(faster)}{middle}"


def _farthest(verdicts: Sequence[Judged]) -> str:
    """How far a boundary vertex lies off its edge at most, to the feature size."""
    ratios = [judged.off_squared / judged.feature_squared for judged in verdicts]
    worst = max(ratios, default=mpq(0))
    return figures.root(worst, 1) if worst else "0"


def ordered(
    records: Iterable[Record], cases: Sequence[str], meshers: Sequence[str]
) -> list[Record]:
    """The records in the order of the tables, whatever ended first."""
    places = {name: i for i, name in enumerate(cases)}
    columns = {name: i for i, name in enumerate(meshers)}
    known = [r for r in records if r.case in places and r.mesher in columns]
    return sorted(known, key=lambda r: (places[r.case], columns[r.mesher]))
