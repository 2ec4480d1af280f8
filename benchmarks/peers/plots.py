"""How the number of triangles grows, as a plot."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from benchmarks.peers.meshers import Mesher
from benchmarks.peers.runs import Record

PANELS = (
    ("slit", "Two square holes with a slit of width 1/A between them", "A"),
    ("star", "Random stars", "n, vertices"),
)
COLOURS = ("#666666", "#c1121f", "#1d4e89", "#5b9bd5", "#2a7f3b", "#8cc084", "#b07b00", "#e0b050")
MARKERS = "osv^<>Dd"


def growth_plot(records: Sequence[Record], meshers: Sequence[Mesher], path: Path) -> None:
    """Triangles against A for the slit and against n for the stars, both axes logarithmic."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(1, 2, figsize=(11, 4.4), dpi=100)
    for panel, (family, title, label) in zip(axes, PANELS, strict=True):
        for mesher, colour, marker in zip(meshers, COLOURS, MARKERS, strict=False):
            own = [
                r
                for r in records
                if r.mesher == mesher.name and r.family == family and r.case != "star400"
            ]
            _line(panel, sorted(own, key=lambda r: r.size), mesher, colour, marker)
        panel.set(title=title, xlabel=label, ylabel="triangles", xscale="log", yscale="log")
        panel.grid(True, which="major", linewidth=0.4, alpha=0.6)
    axes[0].legend(fontsize=8, loc="upper left")
    note = "a cross: no mesh within the cap; Gmsh bounds no angle"
    figure.text(0.5, 0.01, note, ha="center", fontsize=8)
    figure.tight_layout(rect=(0, 0.03, 1, 1))
    figure.savefig(path, metadata={"Software": None})
    pyplot.close(figure)


def _line(panel: Any, records: Sequence[Record], mesher: Mesher, colour: str, marker: str) -> None:
    """One mesher's line; where it did not end, a cross beside its last mesh."""
    there = [r for r in records if r.triangles]
    width = 2.2 if mesher.is_ours else 1.2
    panel.plot(
        [r.size for r in there],
        [r.triangles for r in there],
        color=colour,
        marker=marker,
        markersize=4,
        linewidth=width,
        label=mesher.title,
    )
    failed = [r for r in records if not r.triangles]
    if there and failed:
        panel.plot(
            [failed[0].size], [there[-1].triangles], "x", color=colour, markersize=7, zorder=5
        )
