"""`bern-exact triangulate`: a theorem's construction, run and checked."""

from __future__ import annotations

from pathlib import Path

import click
from gmpy2 import mpq

from bern_exact.api import Result, triangulate
from bern_exact.boundary.merge import Objective
from bern_exact.boundary.records import BlockShape
from bern_exact.checkers.findings import LemmaViolation
from bern_exact.commands.options import (
    SOURCE,
    from_option,
    json_option,
    numbers_option,
    output_option,
    parsed_by,
    svg_option,
)
from bern_exact.commands.writing import (
    MESH_TARGETS,
    files_of,
    refuse_overwriting,
    target_of_mesh,
    write_mesh,
    write_solution,
)
from bern_exact.exact.angle_bound import AngleBound, parse_angle_bound
from bern_exact.exact.numbers import parse_rational
from bern_exact.formats import cgshop, read_instance_file
from bern_exact.interior.subdivided.choice import Method
from bern_exact.interior.sweep import TooManyTriangles
from bern_exact.outputs import emit, emit_json, write_atomically
from bern_exact.plane.polygon import Polygon
from bern_exact.progress import Progress
from bern_exact.report import certificate_lines, print_claims
from bern_exact.theorems.stages import Check, RefusedOption
from bern_exact.trace import Trace
from bern_exact.view.triangulation import draw_triangulation

STAGES = 11
"""How many stages the progress bar expects."""


@click.command("triangulate")
@click.argument("polygon", type=SOURCE)
@click.option("--theorem", type=click.Choice(["1", "2", "3", "4"]), help="Whose construction.")
@click.option(
    "--check",
    type=click.Choice(["every-stage", "final", "none"]),
    default="every-stage",
    show_default=True,
    help="Which claims are checked.",
)
@click.option("--as-printed", is_flag=True, help="Evaluate the paper's false sentences as well.")
@click.option(
    "--max-angle",
    callback=parsed_by(parse_angle_bound),
    help="Theorems 2, 3: degrees above 135 up to 150 (default), or cos:S:p/q.",
)
@click.option(
    "--interior",
    type=click.Choice(["strips", "bridges", "best"]),
    help="Theorem 3: Lemma 8, holes joined to the boundary, or the smaller (default).",
)
@click.option(
    "--objective",
    type=click.Choice(["fewest", "height", "angle"]),
    help="Theorems 2, 3: what faces along the boundary are best at (default: fewest).",
)
@click.option("--squares", is_flag=True, help="Theorem 2: the paper's squares in Lemma 6.")
@click.option(
    "--blocks",
    type=click.Choice(["square", "corner"]),
    help="Theorems 1 to 3: 3 x 3 squares (default), or (experimental) 2 x 2 round a grid vertex.",
)
@click.option(
    "--factor",
    callback=parsed_by(parse_rational),
    help="Theorems 1 to 3: s' in grid units, 8 or (experimental) another; corner blocks: 9/2.",
)
@click.option("--baseline", is_flag=True, help="The O(n^2) construction that is improved on.")
@click.option("--thin", is_flag=True, help="Remove every vertex that the guarantees can spare.")
@click.option(
    "--thin-angle",
    callback=parsed_by(parse_angle_bound),
    help="With --thin: a smaller angle for new triangles, as far as it goes.",
)
@click.option(
    "--trace",
    type=click.Path(path_type=Path, file_okay=False),
    help="Write every stage's record and picture to a directory.",
)
@click.option(
    "--to",
    "target_format",
    type=click.Choice(MESH_TARGETS),
    help="The format of the mesh, whatever the suffix of -o; .solution.json is cgshop.",
)
@from_option
@output_option
@svg_option
@numbers_option
@json_option
def triangulate_command(
    polygon: Path,
    theorem: str | None,
    max_angle: AngleBound | None,
    interior: Method | None,
    objective: Objective | None,
    squares: bool,
    blocks: BlockShape | None,
    factor: mpq | None,
    baseline: bool,
    thin: bool,
    thin_angle: AngleBound | None,
    check: Check,
    as_printed: bool,
    trace: Path | None,
    source_format: str | None,
    target_format: str | None,
    output: Path | None,
    svg: Path | None,
    numbers: str,
    as_json: bool,
) -> int:
    """Triangulate POLYGON by a theorem's construction.

    The mesh goes to stdout or the file of -o; with -o, stdout gets a summary.
    """
    shape = Polygon.load(polygon, numbers=numbers, format=source_format)
    target = target_of_mesh(output, target_format)
    instance = None
    if output is not None:
        files = files_of(output, target)
        if target == "cgshop":
            read = read_instance_file(polygon, format=source_format)
            instance = read or cgshop.instance_of(shape, output.name.partition(".")[0])
            files = files if instance.made else [output]
        refuse_overwriting(files, polygon)
    tracer = Trace(trace) if trace else None
    with Progress(STAGES) as progress:
        if tracer:
            progress.follow(tracer.stage)
        try:
            result = triangulate(
                shape,
                theorem=int(theorem) if theorem else None,
                max_angle=max_angle,
                interior=interior,
                objective=objective,
                squares=squares,
                blocks=blocks,
                factor=factor,
                baseline=baseline,
                thin=thin,
                thin_angle=thin_angle,
                check=check,
                as_printed=as_printed,
                observer=progress,
            )
        except (RefusedOption, TooManyTriangles) as error:
            raise click.UsageError(str(error)) from None
        except LemmaViolation as violation:
            if tracer:
                click.echo(f"witness saved in {tracer.violation(violation.finding)}", err=True)
            raise
    if svg:
        write_atomically(svg, draw_triangulation(result.mesh, result.polygon, result.classes))
    if result.certificate.claims:
        print_claims(result.certificate.claims)
    _hand_over(result, output, target, as_json, instance)
    return 0


def _hand_over(
    result: Result,
    output: Path | None,
    target: str,
    as_json: bool,
    instance: cgshop.Instance | None,
) -> None:
    """The mesh to its file and a summary to stdout, or the mesh itself to stdout."""
    if instance is not None and output is not None:
        write_solution(result.mesh, output, instance)
    else:
        document = result.document if target == "json" else None
        write_mesh(
            result.mesh, result.polygon, output, target, document=document, classes=result.classes
        )
    if output is None:
        return
    if as_json:
        emit_json({"output": str(output), "certificate": result.certificate.to_json()})
    else:
        emit("".join(f"{line}\n" for line in certificate_lines(result.certificate)))
