"""Meshes and polygons on their way to files of any format."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click

from bern_exact.exact.errors import InputError
from bern_exact.formats import (
    MESH_WRITERS,
    POLYGON_WRITERS,
    cgshop,
    format_of_mesh,
    safe_json,
)
from bern_exact.formats.mesh_json import dumps_mesh
from bern_exact.outputs import emit, write_atomically
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.view.triangulation import draw_triangulation

MESH_TARGETS = (*MESH_WRITERS, "cgshop", "svg")
"""The formats in which a mesh is written."""

POLYGON_TARGETS = (*POLYGON_WRITERS, "cgshop")
"""The formats in which a polygon is written."""

EXACT = frozenset(("json", "cgshop"))
"""The formats that round nothing."""

_POLYGONS_ONLY = frozenset(POLYGON_TARGETS) - frozenset(MESH_TARGETS)
_TWO_FILES = {".node", ".ele"}
_TOGETHER = (".poly", ".node", ".ele")


def target_of_mesh(output: Path | None, named: str | None) -> str:
    """The format in which a mesh is to be written.

    Raises
    ------
    UsageError
        It is a format of polygons alone, or one that needs a file.
    """
    if named is None and output is not None and output.suffix.lower()[1:] in _POLYGONS_ONLY:
        raise click.UsageError(f"'{output.suffix}' is a format of polygons, and this is a mesh")
    target = named or (format_of_mesh(output) if output else "json")
    if output is None and target in ("cgshop", "node"):
        raise click.UsageError(f"--to {target} needs -o FILE")
    return target


def files_of(output: Path, target: str) -> list[Path]:
    """The files that are written for a mesh or polygon."""
    if target == "cgshop":
        return [output, beside_solution(output)]
    if target != "node":
        return [output]
    stem = output.with_suffix("") if output.suffix.lower() in _TWO_FILES else output
    return [stem.with_name(stem.name + suffix) for suffix in (".node", ".ele")]


def refuse_overwriting(targets: Sequence[Path], source: Path) -> None:
    """Refuse to write over what was read: the source, and what stands beside it as part of it.

    Raises
    ------
    UsageError
        One of the targets is one of these.
    """
    read = {source.resolve()}
    if source.suffix.lower() in _TOGETHER:
        read |= {source.with_suffix(suffix).resolve() for suffix in _TOGETHER}
    for target in targets:
        if target.resolve() in read and target.exists():
            raise click.UsageError(f"'{target}' is read, and would be written over")


def write_mesh(
    mesh: Mesh,
    polygon: Polygon | None,
    output: Path | None,
    target: str,
    *,
    document: str | None = None,
    classes: Sequence[str] | None = None,
) -> None:
    """Write a mesh in any format but CG:SHOP's, to files or stdout; tell what was rounded.

    Parameters
    ----------
    document : str, optional
        Its JSON document, if there is one already.
    classes : sequence of str, optional
        What its triangles come from, for pictures.

    Raises
    ------
    InputError
        Kind `number`: a coordinate is beyond all doubles; `schema`: a picture of triangles whose
        vertices do not exist.
    """
    if target == "json":
        _hand_out(document or dumps_mesh(mesh, polygon), output)
        return
    if target == "svg":
        if any(not 0 <= v < len(mesh.vertices) for t in mesh.triangles for v in t):
            raise InputError("schema", "no picture: a triangle's vertex does not exist")
        _hand_out(draw_triangulation(mesh, polygon, classes), output)
        return
    written = MESH_WRITERS[target](mesh)
    paths = files_of(output, target) if output else [None]
    for path, text in zip(paths, written.texts.values(), strict=True):
        _hand_out(text, path)
    tell_rounding(target, written.rounded, 2 * len(mesh.vertices))


def write_polygon(polygon: Polygon, output: Path | None, target: str) -> None:
    """Write a polygon, to a file or stdout; tell what was rounded.

    Raises
    ------
    InputError
        The format does not hold the polygon.
    """
    if target == "cgshop":
        instance = cgshop.instance_of(polygon, output.name.partition(".")[0] if output else "")
        _hand_out(safe_json.dumps(cgshop.instance_document(instance)), output)
        tell_instance(instance, str(output or "stdout"))
        return
    text, rounded = POLYGON_WRITERS[target](polygon)
    _hand_out(text, output)
    if target not in EXACT:
        tell_rounding(target, rounded, 2 * polygon.n)


def tell_rounding(target: str, rounded: int, coordinates: int) -> None:
    """Say on stderr what a format of doubles did to coordinates."""
    message = f"{target} holds doubles: {rounded:,} of {coordinates:,} coordinates were rounded"
    click.echo(message, err=True)


def _hand_out(text: str, path: Path | None) -> None:
    """A text to its file or to stdout."""
    if path is None:
        emit(text)
    else:
        write_atomically(path, text)


def beside_solution(output: Path) -> Path:
    """Where the instance of a solution is written."""
    stem = output.name.removesuffix(".json").removesuffix(".solution")
    return output.with_name(f"{stem}.instance.json")


def write_solution(mesh: Mesh, output: Path, instance: cgshop.Instance) -> None:
    """A CG:SHOP solution, and its instance if there was none.

    Raises
    ------
    InputError
        Kind `schema`: the mesh lacks a point of the instance.
    """
    write_atomically(output, safe_json.dumps(cgshop.solution_document(mesh, instance)))
    if not instance.made:
        return
    path = beside_solution(output)
    write_atomically(path, safe_json.dumps(cgshop.instance_document(instance)))
    tell_instance(instance, str(path))


def tell_instance(instance: cgshop.Instance, place: str) -> None:
    """Say on stderr how an instance was made of a polygon."""
    click.echo(f"its instance, coordinates times {instance.scale}: {place}", err=True)
    if instance.bits > cgshop.VERIFIER_BITS:
        click.echo(
            f"coordinates have up to {instance.bits} bits: the contest's verifier rounds them to "
            "doubles",
            err=True,
        )
