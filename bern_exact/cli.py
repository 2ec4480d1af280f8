"""The command line: `bern-exact COMMAND`, the same as `python -m bern_exact COMMAND`."""

from __future__ import annotations

from importlib import import_module

import click

from bern_exact import __version__

HOMES = {
    "triangulate": "triangulate",
    "verify": "verify",
    "facts": "facts",
    "convert": "convert",
    "corpus": "corpus",
    "families": "corpus",
}
"""Command -> its module in `bern_exact.commands`, where it is called `COMMAND_command`."""


class Commands(click.Group):
    """A group whose commands are imported when they are asked for: each pays for itself alone."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Their names."""
        return sorted(HOMES)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """A command, or None if there is no such."""
        if cmd_name not in HOMES:
            return None
        module = import_module(f"bern_exact.commands.{HOMES[cmd_name]}")
        command: click.Command = getattr(module, f"{cmd_name}_command")
        return command


@click.group(cls=Commands, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="bern-exact")
def cli() -> None:
    """Triangulate polygons without large angles, exactly, every lemma checked on the way."""
