"""One outline meshed three ways, side by side, as a picture."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from io import BytesIO
from pathlib import Path
from typing import Any

from benchmarks.peers import figures
from benchmarks.peers.cases import Case
from benchmarks.peers.doubles import nearest_float
from benchmarks.peers.meshers import OURS, PEERS, Mesher
from benchmarks.peers.runs import Limits, Record, measure
from bern_exact.formats import read_mesh_file
from bern_exact.plane.mesh import Mesh

SHOWN = (OURS[0], OURS[1], PEERS[0])
COLOURS = 48
"""Of the palette: enough for lines of one hue, and a small file."""

UNKNOWN = "?"
TITLES = {"raw": "This package, raw", "thin": "This package, thinned"}


def picture(case: Case, path: Path, limits: Limits) -> None:
    """Mesh a polygon raw, thinned and by Triangle, and draw the three side by side.

    Raises
    ------
    RuntimeError
        If one of them made no mesh.
    """
    records: list[Record] = []
    with tempfile.TemporaryDirectory() as temporary:
        directory = Path(temporary)
        measure([(case, m) for m in SHOWN], limits, 1, records.append, keep=directory)
        panels = []
        for mesher in SHOWN:
            record = next(r for r in records if r.mesher == mesher.name)
            if record.judged is None:
                raise RuntimeError(f"{mesher.title}: {record.outcome} {record.detail}")
            (file,) = directory.glob(f"*.{mesher.name}.mesh.json")
            panels.append((mesher, record, read_mesh_file(file)[0]))
    draw(panels, path)


def draw(panels: Sequence[tuple[Mesher, Record, Mesh]], path: Path) -> None:
    """Draw meshes of one polygon with their figures."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot
    from PIL import Image

    sizes = [_extent(mesh) for _, _, mesh in panels]
    tall = max(height / width for width, height in sizes)
    figure, axes = pyplot.subplots(
        1, len(panels), figsize=(4.6 * len(panels), 4.4 * min(tall, 1.4) + 1.2), dpi=100
    )
    for panel, (mesher, record, mesh) in zip(axes, panels, strict=True):
        _draw_mesh(panel, mesh, record)
        panel.set_title(TITLES.get(mesher.name, mesher.title), fontsize=13, fontweight="bold")
        panel.text(
            0.5,
            -0.02,
            caption(record),
            transform=panel.transAxes,
            ha="center",
            va="top",
            fontsize=10.5,
        )
    figure.tight_layout(w_pad=1.5)
    drawn = BytesIO()
    figure.savefig(drawn, format="png", bbox_inches="tight")
    pyplot.close(figure)
    Image.open(drawn).convert("RGB").quantize(COLOURS).save(path, optimize=True)


def caption(record: Record) -> str:
    """The figures of a mesh in a few lines."""
    judged = record.judged
    if judged is None or judged.max_angle is None:
        return record.outcome
    return (
        f"{judged.triangles:,} triangles for {record.n:,} vertices\n"
        f"largest angle {figures.degrees(judged.max_angle)} degrees\n"
        f"least height {figures.height(record)} of the feature size\n"
        f"boundary vertices off the outline: {UNKNOWN if judged.off is None else judged.off}"
    )


def _extent(mesh: Mesh) -> tuple[float, float]:
    xs, ys = zip(*mesh.coordinates, strict=True)
    return nearest_float(max(xs) - min(xs)), nearest_float(max(ys) - min(ys))


def _draw_mesh(panel: Any, mesh: Mesh, record: Record) -> None:
    """Triangles with thin edges, the boundary with thick ones."""
    points = [(nearest_float(x), nearest_float(y)) for x, y in mesh.coordinates]
    xs, ys = zip(*points, strict=True)
    width = 0.25 if len(mesh.triangles) > 3000 else 0.6
    panel.tripcolor(
        xs,
        ys,
        mesh.triangles,
        facecolors=[1.0] * len(mesh.triangles),
        cmap="Blues",
        vmin=0,
        vmax=8,
        edgecolors="#33506e",
        linewidth=width,
    )
    used = {(t[i - 1], t[i]) for t in mesh.triangles for i in range(3)}
    for a, b in sorted(used):
        if (b, a) not in used:
            panel.plot(*zip(points[a], points[b], strict=True), color="#111111", linewidth=0.9)
    panel.set_aspect("equal")
    panel.axis("off")
