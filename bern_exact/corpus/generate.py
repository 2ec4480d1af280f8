"""Making a corpus: its cases, in any number of processes, and the manifest last."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, Future, ProcessPoolExecutor, as_completed
from contextlib import contextmanager
from multiprocessing import get_context
from pathlib import Path

from bern_exact.corpus.case import Files, case_files
from bern_exact.corpus.manifest import MANIFEST, manifest_text
from bern_exact.corpus.plan import Choice, Plan, every_family
from bern_exact.corpus.readme import README
from bern_exact.corpus.storage import begin, is_complete, remove, write_case
from bern_exact.exact.errors import InputError
from bern_exact.outputs import write_atomically

Listener = Callable[[str, int, int], None]
"""Told of a case that is done: its id, how many are, and of how many."""

AHEAD = 4
"""So many cases a worker are handed out at a time: what is done is written soon."""


def generate(
    directory: Path,
    *,
    seed: int,
    count: int,
    families: Sequence[Choice] = (),
    workers: int = 1,
    executor: Executor | None = None,
    listener: Listener | None = None,
) -> Plan:
    """Make a corpus, or what is missing of it.

    Parameters
    ----------
    directory : Path
        Made if it is not there.  Cases that are complete are kept; the bytes at the end are the
        same as if the directory had been empty.
    seed : int
        Of all chance.
    count : int
        How many cases.
    families : sequence of Choice
        In turn; all if empty.
    workers : int
        Processes on this machine.
    executor : Executor, optional
        Any executor of `concurrent.futures` in place of processes here: those of Dask and MPI.
    listener : callable, optional
        Told of every case that is done.

    Raises
    ------
    InputError
        Kind `unsupported`: the directory holds other files.
    LemmaViolation
        A guarantee failed on the way.
    OSError
        Something cannot be written; no case is left half written.

    Notes
    -----
    The manifest comes last: a directory with one is complete.
    """
    plan = Plan(seed, count, tuple(families) or every_family())
    cases = list(plan.cases())
    begin(directory)
    _refuse_strangers(directory, cases)
    missing = [case for case in cases if not is_complete(directory, seed, case)]
    if missing:
        (directory / MANIFEST).unlink(missing_ok=True)
    done = count - len(missing)
    with processes(executor, min(workers, len(missing))) as pool:
        for case, files in made(pool, seed, missing, AHEAD * max(1, workers)):
            write_case(directory, case, files)
            done += 1
            if listener is not None:
                listener(case, done, count)
    write_atomically(directory / "README.md", README)
    write_atomically(directory / MANIFEST, manifest_text(directory, plan))
    return plan


def _refuse_strangers(directory: Path, cases: Sequence[str]) -> None:
    """Refuse a directory with files of somebody else; cases of another plan are removed."""
    known = {*cases, MANIFEST, "README.md"}
    for path in sorted(directory.iterdir()):
        if path.name in known:
            continue
        if not (path / "case.json").is_file():
            message = f"'{directory}' holds '{path.name}', which is of no corpus: name another one"
            raise InputError("unsupported", message, {"path": str(path)})
        remove(path)


@contextmanager
def processes(given: Executor | None, workers: int) -> Iterator[Executor | None]:
    """The executor that was given, or processes; None if this process does it all."""
    if given is not None or workers < 2:
        yield given
        return
    # Not forked: a fork copies threads' locks, and the same start everywhere is the same result.
    pool = ProcessPoolExecutor(workers, mp_context=get_context("spawn"))
    try:
        yield pool
    finally:
        pool.shutdown(cancel_futures=True)


def made(
    pool: Executor | None, seed: int, cases: Sequence[str], ahead: int
) -> Iterator[tuple[str, Files]]:
    """Every case with its files, as they get done."""
    if pool is None:
        for case in cases:
            yield case, case_files(seed, case)
        return
    for start in range(0, len(cases), ahead):
        futures: dict[Future[Files], str] = {
            pool.submit(case_files, seed, case): case for case in cases[start : start + ahead]
        }
        for future in as_completed(futures):
            yield futures[future], future.result()
