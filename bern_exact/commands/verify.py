"""`bern-exact verify`: an exact verdict on anybody's mesh."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click
from gmpy2 import mpq

from bern_exact.commands.options import (
    SOURCE,
    json_option,
    mesh_from_option,
    numbers_option,
    output_option,
    parsed_by,
    svg_option,
)
from bern_exact.exact.angle_bound import AngleBound, parse_angle_bound
from bern_exact.exact.numbers import parse_rational
from bern_exact.formats import read_array_mesh_file
from bern_exact.oracle.api import verdict_on
from bern_exact.oracle.verdict import Verdict
from bern_exact.outputs import emit, emit_json, write_atomically
from bern_exact.plane.polygon import Polygon
from bern_exact.progress import Progress
from bern_exact.report import comparison_lines, verdict_lines
from bern_exact.view.defects import draw_verdict

if TYPE_CHECKING:
    from bern_exact.comparison import Row


@click.command("verify")
@click.argument("mesh", type=SOURCE)
@click.option("--polygon", type=SOURCE, help="What it should triangulate.")
@mesh_from_option
@click.option(
    "--max-angle", callback=parsed_by(parse_angle_bound), help="Degrees (149.5) or cos:S:p/q."
)
@click.option(
    "--min-height-squared", callback=parsed_by(parse_rational), help="A bound on every height."
)
@click.option("--max-triangles", type=click.IntRange(min=0), help="A bound on their number.")
@click.option(
    "--tolerance",
    callback=parsed_by(parse_rational),
    help="Accept boundary vertices so far off their edges of the polygon; all else stays exact.",
)
@click.option(
    "--compare", "compared", is_flag=True, help="Our theorems' meshes of the polygon beside it."
)
@click.option(
    "--limit", type=click.IntRange(min=0), default=100, show_default=True, help="Defects listed."
)
@output_option
@svg_option
@numbers_option
@json_option
def verify_command(
    mesh: Path,
    polygon: Path | None,
    source_format: str | None,
    max_angle: AngleBound | None,
    min_height_squared: mpq | None,
    max_triangles: int | None,
    tolerance: mpq | None,
    compared: bool,
    limit: int,
    output: Path | None,
    svg: Path | None,
    numbers: str,
    as_json: bool,
) -> int:
    """Judge MESH exactly: is it a triangulation, how large its angles, how small its heights?

    Exit code 0 if it is and keeps every bound asked for, 1 if not.
    """
    found, own = read_array_mesh_file(
        mesh, binary64=numbers == "binary64", format=source_format, polygon_path=polygon
    )
    target = Polygon.load(polygon, numbers=numbers) if polygon else own
    for option, given in (("--tolerance", tolerance is not None), ("--compare", compared)):
        if given and target is None:
            raise click.UsageError(f"{option} needs a polygon: give --polygon FILE")
    verdict = verdict_on(
        found,
        target,
        max_angle=max_angle,
        min_height_squared=min_height_squared,
        max_triangles=max_triangles,
        tolerance=tolerance,
        limit=limit,
    )
    if svg:
        write_atomically(svg, draw_verdict(found.mesh, target, verdict))
    rows = _compared(verdict, target) if compared and target else ()
    record = verdict.to_json()
    if compared:
        record["compare"] = [row.to_json() for row in rows]
    if output:
        emit_json(record, output)
    if as_json:
        emit_json(record)
    else:
        lines = [*verdict_lines(verdict), *comparison_lines(rows)]
        if 0 < limit == len(verdict.defects):
            click.echo(f"no more than {limit} defects are listed (--limit)", err=True)
        emit("".join(f"{line}\n" for line in lines))
    return 0 if verdict else 1


def _compared(verdict: Verdict, polygon: Polygon) -> tuple[Row, ...]:
    """The mesh beside ours."""
    # Here, since it brings every theorem with it, and most verdicts need none.
    from bern_exact.comparison import compare

    with Progress(None) as progress:
        return compare(verdict, polygon, observer=progress)
