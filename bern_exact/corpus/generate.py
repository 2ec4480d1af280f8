"""Making a corpus: its cases, in any number of processes, and the manifest last."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ProcessPoolExecutor, wait
from contextlib import contextmanager
from itertools import islice
from multiprocessing import get_context, parent_process
from pathlib import Path
from threading import Thread

from bern_exact.corpus.case import Files, case_files
from bern_exact.corpus.manifest import MANIFEST, manifest_text
from bern_exact.corpus.plan import Choice, Plan, every_family
from bern_exact.corpus.readme import README
from bern_exact.corpus.storage import begin, is_complete, seed_of, write_case
from bern_exact.exact.errors import InputError
from bern_exact.outputs import write_atomically

Listener = Callable[[str, int, int], None]
"""Told of a case that is done: its id, how many are, and of how many."""

AHEAD = 4
"""So many cases a worker are handed out ahead: what is done is written soon."""


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
        Kind `unsupported`: the directory holds other files, or another corpus.
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
    _refuse_strangers(directory, seed, cases)
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


def _refuse_strangers(directory: Path, seed: int, cases: Sequence[str]) -> None:
    """Refuse a directory with files of somebody else, or with cases of another corpus."""
    known = {*cases, MANIFEST, "README.md"}
    for path in sorted(directory.iterdir()):
        if path.name not in known:
            message = f"'{directory}' holds '{path.name}', which is not of this corpus"
            raise _other_directory(message, path)
        if path.name in cases and (made := seed_of(path)) not in (None, seed):
            message = f"'{directory}' holds a corpus of seed {made}, not {seed}"
            raise _other_directory(message, path)


def _other_directory(message: str, path: Path) -> InputError:
    return InputError("unsupported", f"{message}: name another directory", {"path": str(path)})


@contextmanager
def processes(given: Executor | None, workers: int) -> Iterator[Executor | None]:
    """The executor that was given, or processes; None if this process does it all."""
    if given is not None or workers < 2:
        yield given
        return
    # Not forked: a fork copies threads' locks, and the same start everywhere is the same result.
    start = get_context("spawn")
    pool = ProcessPoolExecutor(workers, mp_context=start, initializer=_end_with_parent)
    try:
        yield pool
    finally:
        pool.shutdown(cancel_futures=True)


def _end_with_parent() -> None:
    """Let this worker end when the process that started it does, by a signal too.

    Without this it would wait for work for ever: workers hold each other's pipes open.
    """
    parent = parent_process()

    def watch() -> None:
        if parent is not None:
            parent.join()
            os._exit(1)

    Thread(target=watch, daemon=True).start()


def made(
    pool: Executor | None, seed: int, cases: Sequence[str], ahead: int
) -> Iterator[tuple[str, Files]]:
    """Every case with its files, as they get done."""
    if pool is None:
        for case in cases:
            yield case, case_files(seed, case)
        return
    waiting = iter(cases)
    futures: dict[Future[Files], str] = {}
    while True:
        for case in islice(waiting, ahead - len(futures)):
            futures[pool.submit(case_files, seed, case)] = case
        if not futures:
            return
        done, _ = wait(futures, return_when=FIRST_COMPLETED)
        for future in done:
            yield futures.pop(future), future.result()
