"""Options and arguments that several commands share."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

from bern_exact.exact.errors import InputError
from bern_exact.formats import MESH_FORMATS, POLYGON_FORMATS

ANY_FORMATS = tuple(dict.fromkeys((*POLYGON_FORMATS, *MESH_FORMATS)))
"""Names of the formats of polygons and of meshes."""


class Target(click.Path):
    """A file to be written.  Its directory is looked for before the work, not after it."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """The path, if its directory is there."""
        path = super().convert(value, param, ctx)
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
mesh_from_option = click.option(
    "--from",
    "source_format",
    type=click.Choice(list(MESH_FORMATS)),
    help="The format of MESH, whatever its suffix.",
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
