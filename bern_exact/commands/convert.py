"""`bern-exact convert`: a mesh or a polygon in another format."""

from __future__ import annotations

from pathlib import Path

import click

from bern_exact.commands.options import (
    ANY_FORMATS,
    SOURCE,
    TARGET,
    json_option,
    numbers_option,
)
from bern_exact.commands.writing import (
    MESH_TARGETS,
    POLYGON_TARGETS,
    files_of,
    refuse_overwriting,
    target_of_mesh,
    write_mesh,
    write_polygon,
    write_solution,
)
from bern_exact.formats import (
    POLYGON_FORMATS,
    cgshop,
    cgshop_solution,
    read_array_mesh_file,
    read_instance_file,
    safe_json,
)
from bern_exact.outputs import emit_json
from bern_exact.plane.polygon import Polygon


@click.command("convert")
@click.argument("source", metavar="MESH_OR_POLYGON", type=SOURCE)
@click.option("-o", "--output", type=TARGET, help="The file to write; its suffix is its format.")
@click.option(
    "--from",
    "source_format",
    type=click.Choice(ANY_FORMATS),
    help="The format that is read, whatever the suffix.",
)
@click.option(
    "--to",
    "target_format",
    type=click.Choice(sorted({*MESH_TARGETS, *POLYGON_TARGETS})),
    help="The format that is written, whatever the suffix of -o.",
)
@click.option(
    "--polygon", type=SOURCE, help="The mesh's polygon; of a CG:SHOP solution, its instance."
)
@numbers_option
@json_option
def convert_command(
    source: Path,
    output: Path | None,
    source_format: str | None,
    target_format: str | None,
    polygon: Path | None,
    numbers: str,
    as_json: bool,
) -> int:
    """Write a mesh or a polygon in another format, to stdout or the file of -o.

    Formats of doubles round, and how many coordinates they rounded is told on stderr.
    """
    if output is None and target_format is None:
        raise click.UsageError("-o FILE or --to FORMAT is needed")
    if as_json and output is None:
        raise click.UsageError("--json needs -o FILE: stdout is one JSON object then")
    if _is_mesh(source, source_format):
        target = target_of_mesh(output, target_format)
        _convert_mesh(source, source_format, output, target, polygon, numbers)
    else:
        target = _target_of_polygon(output, target_format)
        shape = Polygon.load(source, numbers=numbers, format=source_format)
        if output:
            refuse_overwriting([output], source)
        write_polygon(shape, output, target)
    if as_json:
        emit_json({"output": str(output), "format": target})
    return 0


def _is_mesh(source: Path, named: str | None) -> bool:
    """Does a file hold a mesh, rather than a polygon?  JSON is looked into."""
    kind = named or source.suffix.lower()[1:]
    if kind not in ("json", "cgshop"):
        return kind not in POLYGON_FORMATS
    document = safe_json.load(source)
    return isinstance(document, dict) and (
        "triangles" in document or cgshop_solution.is_solution(document)
    )


def _convert_mesh(
    source: Path,
    named: str | None,
    output: Path | None,
    target: str,
    polygon: Path | None,
    numbers: str,
) -> None:
    """Read a mesh, and write it."""
    if target not in MESH_TARGETS:
        raise click.UsageError(f"{target} is a format of polygons, and {source.name} is a mesh")
    found, shape = read_array_mesh_file(
        source, binary64=numbers == "binary64", format=named, polygon_path=polygon
    )
    if polygon is not None:
        shape = Polygon.load(polygon, numbers=numbers)
    if output:
        refuse_overwriting(files_of(output, target), source)
    if target != "cgshop" or output is None:
        write_mesh(found.mesh, shape, output, target)
        return
    instance = read_instance_file(polygon) if polygon else None
    if instance is None and shape is None:
        raise click.UsageError("a CG:SHOP solution has a polygon: name it by --polygon")
    if instance is None and shape is not None:
        instance = cgshop.instance_of(shape, output.name.partition(".")[0])
    if instance is not None:
        write_solution(found.mesh, output, instance)


def _target_of_polygon(output: Path | None, named: str | None) -> str:
    """The format in which a polygon is to be written."""
    suffix = output.suffix.lower()[1:] if output else ""
    if named is None and output and output.name.lower().endswith(".instance.json"):
        named = "cgshop"
    target = named or (suffix if suffix in MESH_TARGETS or suffix in POLYGON_TARGETS else "json")
    if target not in POLYGON_TARGETS:
        raise click.UsageError(f"{target} is a format of meshes, and this is a polygon")
    return target
