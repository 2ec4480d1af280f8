"""The command line: `bern-exact COMMAND`, the same as `python -m bern_exact COMMAND`."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import click
from gmpy2 import mpq

from bern_exact import __version__
from bern_exact.api import Result, triangulate
from bern_exact.boundary.merge import Objective
from bern_exact.boundary.records import BlockShape
from bern_exact.checkers.findings import LemmaViolation
from bern_exact.exact.angle_bound import AngleBound, parse_angle_bound
from bern_exact.exact.errors import InputError
from bern_exact.exact.numbers import parse_rational
from bern_exact.facts import facts_of
from bern_exact.formats import (
    MESH_FORMATS,
    POLYGON_FORMATS,
    cgshop,
    format_of_mesh,
    read_instance_file,
    read_mesh_file,
    safe_json,
)
from bern_exact.interior.subdivided.choice import Method
from bern_exact.interior.sweep import TooManyTriangles
from bern_exact.oracle.api import verify_with_feature_size
from bern_exact.outputs import emit, emit_json, write_atomically
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.progress import Progress
from bern_exact.report import (
    certificate_lines,
    facts_lines,
    print_claims,
    verdict_lines,
)
from bern_exact.theorems.stages import Check, RefusedOption
from bern_exact.trace import Trace
from bern_exact.view.triangulation import draw_triangulation

STAGES = 11
"""How many stages the progress bar expects."""


FOREIGN = frozenset((".node", ".ele", ".poly", ".off", ".obj", ".msh", ".vtk", ".vtu"))
"""Suffixes of formats that are not written: JSON under such a name would mislead."""


class Target(click.Path):
    """A file to be written.  Its directory is looked for before the work, not after it."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """The path, if its directory is there."""
        path = super().convert(value, param, ctx)
        suffix = Path(os.fsdecode(path)).suffix.lower()
        if suffix in FOREIGN:
            self.fail(f"Writing '{suffix}' is not in this version; '.json' is.", param, ctx)
        directory = Path(os.fsdecode(path)).parent
        if not directory.is_dir():
            self.fail(f"Directory '{directory}' does not exist.", param, ctx)
        return path


SOURCE = click.Path(exists=True, dir_okay=False, path_type=Path)
TARGET = Target(path_type=Path, dir_okay=False)

numbers_option = click.option(
    "--numbers",
    type=click.Choice(["decimal", "binary64"]),
    default="decimal",
    show_default=True,
    help="Read a decimal as exactly that, or as the double nearest to it.",
)
json_option = click.option("--json", "as_json", is_flag=True, help="One JSON object on stdout.")
from_option = click.option(
    "--from",
    "source_format",
    type=click.Choice(list(POLYGON_FORMATS)),
    help="The format of POLYGON, whatever its suffix.",
)
output_option = click.option("-o", "--output", type=TARGET, help="Write the result to a file.")
svg_option = click.option("--svg", type=TARGET, help="Draw the mesh.")


Parser = Callable[[click.Context, click.Parameter, str | None], Any]


def parsed_by(parse: Callable[[str], Any]) -> Parser:
    """An option's text as a value; what cannot be parsed is wrong usage."""

    def convert(context: click.Context, option: click.Parameter, text: str | None) -> Any:
        try:
            return None if text is None else parse(text)
        except InputError as error:
            raise click.BadParameter(error.message, context, option) from None

    return convert


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="bern-exact")
def cli() -> None:
    """Triangulate polygons without large angles, exactly, every lemma checked on the way."""


@cli.command("triangulate")
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
    type=click.Choice(MESH_FORMATS),
    help="The format of -o, whatever its suffix; .solution.json is cgshop.",
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
    instance = None
    if (target_format or (output and format_of_mesh(output))) == "cgshop":
        instance = _instance(read_instance_file(polygon, format=source_format), shape, output)
        if instance.made and output and _beside(output).resolve() == polygon.resolve():
            raise click.UsageError(f"the instance would be written over '{polygon}'")
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
    _hand_over(result, output, as_json, instance)
    return 0


def _instance(
    read: cgshop.Instance | None, polygon: Polygon, output: Path | None
) -> cgshop.Instance:
    """The CG:SHOP instance to be solved: the one that was read, or one made of the polygon."""
    if output is None:
        raise click.UsageError("--to cgshop needs -o FILE")
    return read or cgshop.instance_of(polygon, output.name.partition(".")[0])


def _beside(output: Path) -> Path:
    """Where the instance of a solution is written."""
    stem = output.name.removesuffix(".json").removesuffix(".solution")
    return output.with_name(f"{stem}.instance.json")


def _write_solution(result: Result, output: Path, instance: cgshop.Instance) -> None:
    """The solution, and the instance if there was none."""
    solution = cgshop.solution_document(result.mesh, instance)
    write_atomically(output, safe_json.dumps(solution))
    if not instance.made:
        return
    path = _beside(output)
    write_atomically(path, safe_json.dumps(cgshop.instance_document(instance)))
    click.echo(f"its instance, coordinates times {instance.scale}: {path}", err=True)
    if instance.bits > cgshop.VERIFIER_BITS:
        click.echo(
            f"coordinates have up to {instance.bits} bits: the contest's verifier rounds them to "
            "doubles",
            err=True,
        )


def _hand_over(
    result: Result, output: Path | None, as_json: bool, instance: cgshop.Instance | None
) -> None:
    """The mesh to its file and a summary to stdout, or the mesh itself to stdout."""
    if output is None:
        emit(result.document)
        return
    if instance is not None:
        _write_solution(result, output, instance)
    else:
        write_atomically(output, result.document)
    if as_json:
        emit_json({"output": str(output), "certificate": result.certificate.to_json()})
    else:
        emit("".join(f"{line}\n" for line in certificate_lines(result.certificate)))


@cli.command("verify")
@click.argument("mesh", type=SOURCE)
@click.option("--polygon", type=SOURCE, help="What it should triangulate.")
@click.option(
    "--max-angle", callback=parsed_by(parse_angle_bound), help="Degrees (149.5) or cos:S:p/q."
)
@click.option(
    "--min-height-squared", callback=parsed_by(parse_rational), help="A bound on every height."
)
@click.option("--max-triangles", type=click.IntRange(min=0), help="A bound on their number.")
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
    max_angle: AngleBound | None,
    min_height_squared: mpq | None,
    max_triangles: int | None,
    limit: int,
    output: Path | None,
    svg: Path | None,
    numbers: str,
    as_json: bool,
) -> int:
    """Judge MESH exactly: is it a triangulation, how large its angles, how small its heights?

    Exit code 0 if it is and keeps every bound asked for, 1 if not.
    """
    found, own = read_mesh_file(mesh, binary64=numbers == "binary64")
    target = Polygon.load(polygon, numbers=numbers) if polygon else own
    verdict = verify_with_feature_size(
        found,
        target,
        max_angle=max_angle,
        min_height_squared=min_height_squared,
        max_triangles=max_triangles,
        limit=limit,
    )
    if svg:
        _draw_if_possible(svg, found, target)
    text = "".join(f"{line}\n" for line in verdict_lines(verdict))
    record = verdict.to_json()
    if output:
        emit_json(record, output)
    if as_json:
        emit_json(record)
    else:
        emit(text)
    return 0 if verdict.valid else 1


def _draw_if_possible(svg: Path, mesh: Mesh, polygon: Polygon | None) -> None:
    """Draw a mesh that anybody made; one whose indices are out of range has no picture."""
    if all(0 <= i < len(mesh.vertices) for corners in mesh.triangles for i in corners):
        write_atomically(svg, draw_triangulation(mesh, polygon))
    else:
        click.echo("no picture: a triangle's vertex does not exist", err=True)


@cli.command("facts")
@click.argument("polygon", type=SOURCE)
@from_option
@output_option
@numbers_option
@json_option
def facts_command(
    polygon: Path, source_format: str | None, output: Path | None, numbers: str, as_json: bool
) -> int:
    """The exact sizes of POLYGON, and the bound that they put on any triangulation."""
    facts = facts_of(Polygon.load(polygon, numbers=numbers, format=source_format))
    if output:
        emit_json(facts.to_json(), output)
    if as_json:
        emit_json(facts.to_json())
    elif not output:
        emit("".join(f"{line}\n" for line in facts_lines(facts)))
    return 0
