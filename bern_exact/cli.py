"""The command line: `bern-exact COMMAND`, the same as `python -m bern_exact COMMAND`."""

from __future__ import annotations

import click

from bern_exact import __version__
from bern_exact.commands.convert import convert_command
from bern_exact.commands.corpus import corpus_command, families_command
from bern_exact.commands.facts import facts_command
from bern_exact.commands.triangulate import triangulate_command
from bern_exact.commands.verify import verify_command


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="bern-exact")
def cli() -> None:
    """Triangulate polygons without large angles, exactly, every lemma checked on the way."""


for command in (
    triangulate_command,
    verify_command,
    facts_command,
    convert_command,
    corpus_command,
    families_command,
):
    cli.add_command(command)
