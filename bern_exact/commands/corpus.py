"""`bern-exact corpus`: regression corpora made, checked, and held against other programs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from concurrent.futures import Executor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import Any

import click
from gmpy2 import mpq

from bern_exact.commands.options import json_option, numbers_option, parsed_by
from bern_exact.corpus.families import FAMILIES
from bern_exact.corpus.generate import generate
from bern_exact.corpus.judging import OUTCOMES, Criterion, Outcome, judge_results
from bern_exact.corpus.plan import Choice
from bern_exact.corpus.recheck import recheck
from bern_exact.exact.angle_bound import AngleBound, parse_angle_bound
from bern_exact.exact.numbers import parse_rational
from bern_exact.outputs import emit, emit_json
from bern_exact.progress import Counting

DIRECTORY = click.Path(path_type=Path, file_okay=False)
EXISTING = click.Path(path_type=Path, file_okay=False, exists=True)

RETRIES = 10
"""So often a case is begun again that went down with its Dask worker."""

GOOD = ("passed", "missing")
"""Outcomes that make the answer no no."""


workers_option = click.option(
    "--workers", type=click.IntRange(min=1), default=1, help="Processes on this machine."
)


@click.group("corpus")
def corpus_command() -> None:
    """Corpora: exact test vectors for programs that make or judge meshes."""


def _choices(
    context: click.Context, option: click.Parameter, texts: tuple[str, ...]
) -> tuple[Choice, ...]:
    """The families asked for."""
    return tuple(parsed_by(Choice.parse)(context, option, text) for text in texts)


@corpus_command.command("generate")
@click.option("--out", type=DIRECTORY, required=True, help="The corpus's directory.")
@click.option("--seed", type=click.IntRange(min=0), required=True, help="Of all chance.")
@click.option("--count", type=click.IntRange(min=1), required=True, help="How many cases.")
@click.option(
    "--family",
    "families",
    multiple=True,
    callback=_choices,
    help="A family, or family:parameter=value,...; several in turn; without it all.",
)
@workers_option
@click.option("--dask", metavar="ADDRESS", help="A Dask scheduler whose workers make the cases.")
@json_option
def generate_command(
    out: Path,
    seed: int,
    count: int,
    families: tuple[Choice, ...],
    workers: int,
    dask: str | None,
    as_json: bool,
) -> int:
    """Make a corpus; run again, it makes what is missing, byte for byte."""
    with Counting(count) as counting, _executor(dask) as (executor, size), _pool_named():
        generate(
            out,
            seed=seed,
            count=count,
            families=families,
            workers=size or workers,
            executor=executor,
            listener=counting.done,
        )
    if as_json:
        emit_json({"corpus": str(out), "seed": seed, "count": count})
    else:
        emit(f"{count} cases in {out}\n")
    return 0


@contextmanager
def _pool_named() -> Iterator[None]:
    """Say what to do when a worker process dies."""
    try:
        yield
    except BrokenProcessPool:
        message = "a worker process died (out of memory?); run the same again to go on"
        raise click.ClickException(message) from None


@contextmanager
def _executor(dask: str | None) -> Iterator[tuple[Executor | None, int]]:
    """The executor of a Dask scheduler and its number of threads, or none."""
    if dask is None:
        yield None, 0
        return
    try:
        distributed = import_module("distributed")
    except ImportError:
        raise click.UsageError("--dask needs the extra: pip install 'bern_exact[dask]'") from None
    try:
        client = distributed.Client(dask, timeout="5s")
    except (OSError, ValueError) as error:
        raise click.ClickException(f"no Dask scheduler answers at {dask}: {error}") from None
    with client:
        yield client.get_executor(pure=False, retries=RETRIES), sum(client.nthreads().values())


@corpus_command.command("check")
@click.argument("directory", type=EXISTING)
@workers_option
@json_option
def check_command(directory: Path, workers: int, as_json: bool) -> int:
    """Derive everything in DIRECTORY again and compare: exit code 1 if anything differs."""
    with Counting(None) as counting, _pool_named():
        found = recheck(directory, workers=workers, listener=counting.done)
    if as_json:
        emit_json({"valid": not found, "differences": [vars(each) for each in found]})
    else:
        emit("".join(f"{each.what}: {each.path}\n" for each in found) or "no differences\n")
    return 1 if found else 0


@corpus_command.command("judge")
@click.argument("directory", type=EXISTING)
@click.argument("results", type=EXISTING)
@click.option("--max-angle", callback=parsed_by(parse_angle_bound), help="For the meshes.")
@click.option(
    "--tolerance", callback=parsed_by(parse_rational), help="For the meshes' boundary vertices."
)
@numbers_option
@json_option
def judge_command(
    directory: Path,
    results: Path,
    max_angle: AngleBound | None,
    tolerance: mpq | None,
    numbers: str,
    as_json: bool,
) -> int:
    """Judge the meshes or the verdicts in RESULTS by the corpus in DIRECTORY.

    Exit code 1 if any is wrong; what is missing is counted.
    """
    criterion = Criterion(max_angle, tolerance, numbers == "binary64")
    outcomes = judge_results(directory, results, criterion)
    counts = Counter(outcome.result for outcome in outcomes)
    if as_json:
        record = {name: counts[name] for name in OUTCOMES}
        emit_json({"counts": record, "outcomes": [outcome.to_json() for outcome in outcomes]})
    else:
        emit("".join(f"{line}\n" for line in _table(outcomes, counts)))
    return 0 if all(outcome.result in GOOD for outcome in outcomes) else 1


def _table(outcomes: Sequence[Outcome], counts: Counter[str]) -> Iterator[str]:
    """What was wrong, one a line; how often each kind of defect, and the sums."""
    for outcome in outcomes:
        if outcome.result not in GOOD:
            about = outcome.message or ", ".join(outcome.kinds)
            yield f"{outcome.result}: {outcome.name}" + (f": {about}" if about else "")
    wrong = Counter[tuple[str, str]]()
    for outcome in outcomes:
        if outcome.result not in GOOD:
            wrong.update((outcome.result, kind) for kind in outcome.kinds)
    for (result, kind), number in sorted(wrong.items()):
        yield f"{number:6,}  {result}, {kind}"
    for name in OUTCOMES:
        if counts[name]:
            yield f"{counts[name]:6,}  {name}"


@click.command("families")
@json_option
def families_command(as_json: bool) -> int:
    """The families of polygons, with their parameters and what each is meant to break."""
    if as_json:
        emit_json({"families": [_family(name) for name in FAMILIES]})
        return 0
    for name, family in FAMILIES.items():
        ranges = ", ".join(f"{k} {low}..{high}" for k, (low, high) in family.parameters.items())
        emit(f"{name}" + (f" ({ranges})" if ranges else "") + f"\n    {family.breaks}\n")
    return 0


def _family(name: str) -> dict[str, Any]:
    """A family as an object."""
    family = FAMILIES[name]
    return {
        "name": name,
        "breaks": family.breaks,
        "parameters": {k: list(limits) for k, limits in family.parameters.items()},
        "flags": list(family.flags),
        "errors": list(family.errors),
    }
