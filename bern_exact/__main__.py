"""`python -m bern_exact`: the command line, every error as its exit code and never a traceback."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from typing import Any

import click

from bern_exact.checkers.findings import LemmaViolation
from bern_exact.cli import cli
from bern_exact.exact.errors import InputError
from bern_exact.outputs import emit, emit_json
from bern_exact.trace import plain

USAGE, BAD_INPUT, VIOLATION, INTERRUPTED = 2, 3, 4, 130
"""Exit codes; 0 is done or verified, 1 is `no`."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command.

    Parameters
    ----------
    arguments : sequence of str, optional
        `sys.argv[1:]` if not given.

    Returns
    -------
    int
        The exit code.
    """
    words = sys.argv[1:] if arguments is None else list(arguments)
    try:
        return int(cli.main(args=words, prog_name="bern-exact", standalone_mode=False) or 0)
    except click.ClickException as error:
        error.show()
        return _failed(words, USAGE, "usage", error.format_message(), {})
    except OSError as error:
        message = f"{error.filename or 'file'}: {error.strerror or error}"
        click.echo(f"Error: {message}", err=True)
        return _failed(words, USAGE, "usage", message, {})
    except InputError as error:
        click.echo(f"Error: {error.message} [{error.kind}]", err=True)
        return _failed(words, BAD_INPUT, error.kind, error.message, error.where)
    except LemmaViolation as violation:
        finding = violation.finding
        click.echo(f"Error: {violation}", err=True)
        where = {**finding.to_json(), "witness": plain(finding.witness, {})}
        return _failed(words, VIOLATION, "lemma-violation", str(violation), where)
    except click.Abort:
        return INTERRUPTED


def _failed(
    words: Sequence[str], code: int, kind: str, message: str, where: Mapping[str, Any]
) -> int:
    """The exit code, after the JSON object that `--json` asks for."""
    if "--json" in words:
        emit_json({"error": {"kind": kind, "message": message, "where": dict(where)}})
    return code


def run() -> None:
    """The installed command `bern-exact`."""
    status = main()
    try:
        emit("")  # and with it all that is still buffered
    except OSError:
        status = status or USAGE
    sys.exit(status)


if __name__ == "__main__":
    run()
