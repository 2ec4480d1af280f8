"""`bern-exact facts`: what is known of a polygon alone."""

from __future__ import annotations

from pathlib import Path

import click

from bern_exact.commands.options import (
    SOURCE,
    from_option,
    json_option,
    numbers_option,
    output_option,
)
from bern_exact.facts import facts_of
from bern_exact.outputs import emit, emit_json
from bern_exact.plane.polygon import Polygon
from bern_exact.report import facts_lines


@click.command("facts")
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
